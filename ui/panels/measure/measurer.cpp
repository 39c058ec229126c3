// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/measure/measurer.h"

#include <algorithm>
#include <chrono>

#include "ui/text/phrase_book.h"

namespace zscope::ui {
namespace {

constexpr std::chrono::milliseconds kProgressEvery{60};

}  // namespace

std::optional<MeasuredView> viewOf(const Session& session)
{
    const Snapshot& now = session.now();
    if (!now.scene) return {};
    return MeasuredView{now.scene->scene().digest, now.camera, session.settings().faceCulling};
}

Measurer::Measurer(QObject* parent) : QObject(parent), m_worker(std::make_unique<Worker>()) {}

Measurer::~Measurer() = default;

void Measurer::start(const Session& session, std::vector<BenchAlgorithm> algorithms, int frames, bool checks)
{
    const auto view = viewOf(session);
    if (!view || algorithms.empty()) return;
    m_isRunning = true;
    m_progress  = 0;
    m_doing.clear();

    const auto&  prepared = session.now().scene->prepared;
    BenchRequest request{.scene       = std::shared_ptr<const Scene>(prepared, &prepared->scene()),
                         .camera      = view->camera,
                         .faceCulling = view->faceCulling,
                         .algorithms  = std::move(algorithms),
                         .threads     = {session.settings().threads},
                         .simd        = {session.settings().simd},
                         .frames      = frames,
                         .verify      = checks,
                         .memoryLimit = session.settings().memoryLimit};
    m_worker->post(Worker::Slot::Draw, [this, view = *view, number = ++m_request,
                                        request = std::move(request)](const std::atomic<bool>& cancel) mutable {
        const auto  deliver     = [this](auto answer) { m_worker->deliver(std::move(answer)); };
        auto        told        = std::chrono::steady_clock::now() - kProgressEvery;
        std::size_t done        = 0;
        request.progress.cancel = &cancel;
        request.progress.report = [&](double fraction, std::string_view what) {
            const bool isTiming =
                std::ranges::find(request.algorithms, what, &BenchAlgorithm::name) != request.algorithms.end();
            const auto time = std::chrono::steady_clock::now();
            if (time - told < kProgressEvery) return;
            told = time;
            deliver([this, number, fraction = isTiming ? fraction : 0,
                     doing = isTiming ? std::string(what) : std::string()] {
                if (number != m_request) return;
                m_progress = fraction;
                m_doing    = QString::fromStdString(doing);
                emit progressed();
            });
        };
        request.finished = [&](const BenchRow& row) {
            deliver([this, view, run = Run{request.algorithms[done++].pipeline, row}]() mutable {
                keep(view, std::move(run));
            });
        };
        const auto rows      = bench(request);
        const bool isTrouble = !rows && rows.error().kind != Trouble::Cancelled;
        deliver([this, number, sentence = isTrouble ? rows.error().text() : std::string()] {
            if (!sentence.empty()) emit failed(said(sentence));
            end(number);
        });
    });
    emit progressed();
}

void Measurer::stop()
{
    if (!m_isRunning) return;
    m_worker->cancel();  // a job that has not begun will never tell that it ended
    end(m_request);
}

void Measurer::end(std::uint64_t request)
{
    if (request != m_request || !m_isRunning) return;
    m_isRunning = false;
    emit ended();
}

void Measurer::keep(const MeasuredView& view, Run run)
{
    auto list = std::ranges::find(m_lists, view, &List::view);
    if (list == m_lists.end()) list = m_lists.insert(m_lists.end(), List{view, {}});
    const auto same = std::ranges::find_if(
        list->runs, [&](const Run& old) { return old.pipeline == run.pipeline && old.row.threads == run.row.threads; });
    if (same == list->runs.end())
        list->runs.push_back(std::move(run));
    else
        *same = std::move(run);
    emit found(view);
}

const std::vector<Run>& Measurer::runsOf(const std::optional<MeasuredView>& view) const
{
    static const std::vector<Run> kNone;
    if (!view) return kNone;
    const auto list = std::ranges::find(m_lists, *view, &List::view);
    return list == m_lists.end() ? kNone : list->runs;
}

}  // namespace zscope::ui
