// SPDX-License-Identifier: GPL-3.0-or-later
// The one thread that does the window's long work, one job at a time, the newest request first.
//
// Slots      at most one job of each kind waits; a newer one takes its place. A load makes every other job
//            pointless, a drawing makes the step of the old drawing pointless; likewise of what is compared with it
// Cancel     a running job that a newer one has made pointless is asked to stop: at once by a load, otherwise when it
//            has had kPatience since the newer one came, so that a dragged camera still sees frames finish. One that
//            was stopped like that gives the next twice the time, until one finishes: a slow machine is slow, not stuck
// Threads    post(), cancel() and the destructor from the thread the worker lives in; jobs run on the thread it
//            owns. The destructor asks the running job to stop and waits for it
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include <QObject>
#include <QTimer>

namespace zscope::ui {

class Worker final : public QObject {
    Q_OBJECT

public:
    enum class Slot { Load, Draw, DrawOther, Step, Search, StepOther, Repaint };  // the most urgent first
    static constexpr std::chrono::milliseconds kPatience{150};

    /// The flag is this worker's for all jobs, and stays where it is while the worker lives.
    using Job = std::function<void(const std::atomic<bool>& cancel)>;

    explicit Worker(QObject* parent = nullptr);
    ~Worker() override;

    void post(Slot slot, Job job);
    /// From a job: has `answer` run in the thread that the worker lives in, in the order of the calls, unless the
    /// worker is gone by then. It passes under the mutex, so that whoever looks for races sees which thread had it
    /// when; Qt's queue does not show.
    void deliver(std::function<void()> answer);
    /// Forgets what waits and asks what runs to stop.
    void cancel();

    /// From post() until idle(): what the jobs have queued for this thread before they ended has arrived by then.
    bool isBusy() const { return m_isBusy; }

signals:
    /// Nothing runs or waits any more. Emitted in the thread the worker lives in.
    void idle();

protected:
    bool event(QEvent* event) override;

private:
    static constexpr int         kMostAllowance = 32;
    static constexpr std::size_t kSlots         = 7;

    void run();
    void losePatience();
    void sayIdle();  // with the mutex held, like the next
    void queue(std::function<void()> answer);

    mutable std::mutex                     m_mutex;  // guards everything down to m_cancel
    std::condition_variable                m_wake;
    std::array<std::optional<Job>, kSlots> m_waiting;
    std::optional<Slot>                    m_running;
    bool                                   m_pointless = false;  // the running job's answer is no longer wanted,
    std::chrono::steady_clock::time_point  m_since;              // and since when
    int                                    m_allowance = 1;      // times kPatience, for the next to be stopped
    bool                                   m_stop      = false;
    std::uint64_t                          m_posts     = 0;
    std::deque<std::function<void()>>      m_answers;  // as many as there are events for them
    std::atomic<bool>                      m_cancel{false};
    bool                                   m_isBusy = false;  // of the thread the worker lives in, like the timer
    QTimer                                 m_patience;
    std::thread                            m_thread;
};

}  // namespace zscope::ui
