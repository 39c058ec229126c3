// SPDX-License-Identifier: GPL-3.0-or-later
// Times algorithms in the background and keeps what it found, view by view. No widgets.
//
// View       scene by its digest, camera with its size, face culling: runs of another view are another list
// Newest     a run of the same algorithm and threads takes the place of the one before
// Stopped    what has been finished is kept
// Threads    to be used from one thread; bench() runs on a worker of its own. Destroying it in the middle of a run
//            cancels that and waits for it
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "core/measure/bench.h"
#include "ui/session/session.h"
#include "ui/session/worker.h"

namespace zscope::ui {

struct MeasuredView {
    std::string digest;  // of the scene
    Camera      camera;  // with the size of the picture
    FaceCulling faceCulling = FaceCulling::None;

    friend bool operator==(const MeasuredView&, const MeasuredView&) = default;
};
/// Of what the session shows; nothing without a scene.
std::optional<MeasuredView> viewOf(const Session& session);

struct Run {
    Pipeline pipeline;
    BenchRow row;
};

class Measurer final : public QObject {
    Q_OBJECT

public:
    explicit Measurer(QObject* parent = nullptr);
    ~Measurer() override;

    /// Times `algorithms`, `frames` timed frames each, on what the session shows now. Stops what is running.
    void start(const Session& session, std::vector<BenchAlgorithm> algorithms, int frames, bool checks);
    void stop();

    bool    isRunning() const { return m_isRunning; }
    double  progress() const { return m_progress; }  // in [0, 1]
    QString doing() const { return m_doing; }        // the algorithm that is timed; empty: the reference is being drawn

    /// Empty if nothing has been timed on this view.
    const std::vector<Run>& runsOf(const std::optional<MeasuredView>& view) const;

signals:
    void progressed();
    /// A run of `view` has been finished.
    void found(const zscope::ui::MeasuredView& view);
    void ended();
    void failed(const QString& sentence);

private:
    struct List {
        MeasuredView     view;
        std::vector<Run> runs;
    };

    void keep(const MeasuredView& view, Run run);
    void end(std::uint64_t request);

    std::vector<List>       m_lists;
    bool                    m_isRunning = false;
    std::uint64_t           m_request   = 0;  // the newest
    double                  m_progress  = 0;
    QString                 m_doing;
    std::unique_ptr<Worker> m_worker;  // last: stops before anything else goes
};

}  // namespace zscope::ui
