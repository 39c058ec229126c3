// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/worker.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QEvent>

namespace zscope::ui {

Worker::Worker(QObject* parent) : QObject(parent)
{
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience);
    connect(&m_patience, &QTimer::timeout, this, &Worker::losePatience);
    m_thread = std::thread([this] { run(); });
}

Worker::~Worker()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
        for (auto& job : m_waiting) job.reset();
        m_cancel = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void Worker::post(Slot slot, Job job)
{
    m_isBusy       = true;
    bool wait      = false;
    int  allowance = 1;
    {
        const std::lock_guard lock(m_mutex);
        for (auto kind = static_cast<std::size_t>(slot); kind < kSlots; ++kind) m_waiting[kind].reset();
        m_waiting[static_cast<std::size_t>(slot)] = std::move(job);
        ++m_posts;
        if (m_running && *m_running >= slot) {
            if (!m_pointless) m_since = std::chrono::steady_clock::now();
            m_pointless = true;
            if (slot == Slot::Load)
                m_cancel = true;
            else
                wait = true;
        }
        allowance = m_allowance;
    }
    if (wait && !m_patience.isActive()) m_patience.start(kPatience * allowance);
    m_wake.notify_one();
}

void Worker::cancel()
{
    const std::lock_guard lock(m_mutex);
    for (auto& job : m_waiting) job.reset();
    if (m_running)
        m_cancel = true;
    else
        sayIdle();
}

void Worker::sayIdle()
{
    // Queued behind whatever the last job has queued; of no interest once something newer was posted.
    const auto tell = [this, posts = m_posts] {
        {
            const std::lock_guard lock(m_mutex);
            if (posts != m_posts) return;
        }
        m_isBusy = false;
        emit idle();
    };
    queue(tell);
}

void Worker::deliver(std::function<void()> answer)
{
    const std::lock_guard lock(m_mutex);
    queue(std::move(answer));
}

void Worker::queue(std::function<void()> answer)
{
    m_answers.push_back(std::move(answer));
    QCoreApplication::postEvent(this, new QEvent(QEvent::User));
}

bool Worker::event(QEvent* event)
{
    if (event->type() != QEvent::User) return QObject::event(event);
    std::function<void()> answer;
    {
        const std::lock_guard lock(m_mutex);
        if (m_answers.empty()) return true;
        answer = std::move(m_answers.front());
        m_answers.pop_front();
    }
    answer();
    return true;
}

void Worker::losePatience()
{
    const std::lock_guard lock(m_mutex);
    if (!m_running || !m_pointless) return;
    const auto had = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - m_since);
    // the timer was another job's
    if (const auto due = kPatience * m_allowance; had < due) return m_patience.start(due - had);
    m_cancel    = true;
    m_allowance = std::min(2 * m_allowance, kMostAllowance);
}

void Worker::run()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        const auto next = std::ranges::find_if(m_waiting, [](const auto& job) { return job.has_value(); });
        if (m_stop) return;
        if (next == m_waiting.end()) {
            m_wake.wait(lock);
            continue;
        }
        Job job = std::move(**next);
        next->reset();
        m_running   = static_cast<Slot>(next - m_waiting.begin());
        m_pointless = false;
        m_cancel    = false;

        lock.unlock();
        job(m_cancel);
        job = nullptr;  // what it held may be large: let it go outside the lock
        lock.lock();

        if (!m_cancel) m_allowance = 1;
        m_running.reset();
        if (std::ranges::none_of(m_waiting, [](const auto& waiting) { return waiting.has_value(); })) sayIdle();
    }
}

}  // namespace zscope::ui
