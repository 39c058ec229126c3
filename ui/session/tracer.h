// SPDX-License-Identifier: GPL-3.0-or-later
// Holds another program's trace against the session's run, as `zscope-cli check --trace` does, and steps the two
// together. No widgets.
//
// Run        of the scene, camera and algorithm on show. If the trace names an algorithm, or has tables that the one on
//            show lacks, A becomes what `check` would take; likewise the culling with which more of the trace agrees
// Row        the current one is the last that the step on show has reached; going to a row takes the session there
// Old        as soon as scene, camera, algorithm or culling are others than those of the judgement: then no row follows
// Errors     Session::failed() with one sentence; the trace before stays
// Threads    to be used from one thread; reading and judging happen on a worker of its own, and the newest request wins
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "core/check/trace_beside.h"
#include "ui/session/snapshot.h"
#include "ui/session/worker.h"

namespace zscope::ui {

class Session;

/// A trace as it was judged.
struct TheirTrace {
    QString                                   file, title;
    std::shared_ptr<const check::Trace>       trace;
    std::shared_ptr<const check::TraceAnswer> answer;
    std::vector<std::size_t>                  order;  // rows that have a step of ours, in the order of the run
    std::string                               scene;  // digest of the one that it was held against
    QString                                   sceneWord;
    Camera                                    camera;
    Pipeline                                  pipeline;
    std::shared_ptr<check::TraceBeside>       beside;  // used by jobs of the worker only

    /// The last row that a state of our run has reached; nothing: none.
    std::optional<std::size_t> reachedBy(std::uint64_t events) const;
    /// The next row that differs, in the order of the file; nothing: there is none.
    std::optional<std::size_t> differenceFrom(std::optional<std::size_t> row, Direction direction) const;
};

class Tracer final : public QObject {
    Q_OBJECT

public:
    explicit Tracer(Session& session, QObject* parent = nullptr);
    ~Tracer() override;

    /// A scene must be open. Goes to the first row that differs.
    void open(const QString& file);
    /// Once this scene is there, with the algorithm of then; the step stays. Another scene forgets it.
    void openWith(const QString& file, const QString& sceneWord);
    /// The same file as it is by now, held against the run on show.
    void judgeAgain();
    void close();
    void cancel();
    /// To the scene, the camera and the algorithm of the judgement.
    void goBack();
    /// Wants a dialog that asks for a file.
    void chooseFile() { emit fileWanted(); }

    const TheirTrace*                 trace() const { return m_trace.get(); }
    std::shared_ptr<const TheirTrace> shared() const { return m_trace; }
    bool                              isOld() const;
    std::optional<std::size_t>        row() const { return m_row; }
    /// What the current row and our run hold; nullptr while that is on its way.
    const std::vector<check::FieldBeside>* fields() const { return m_fieldsOf == m_row && m_row ? &m_fields : nullptr; }

    void goToRow(std::size_t row);
    void goToNextRow(Direction direction);
    void goToFirstDifference();
    void goToNextDifference(Direction direction);

    bool isJudging() const { return m_isJudging; }
    bool isIdle() const { return !m_worker->isBusy(); }

signals:
    /// Another trace, row, or what is known of them.
    void changed();
    /// A trace has been judged.
    void opened();
    void fileWanted();

private:
    struct Question;

    void ask(const QString& file, bool isNew);
    void judged(const std::shared_ptr<const TheirTrace>& trace, const Question& question);
    void follow();  // the step on show
    void show(std::optional<std::size_t> row);
    void askForFields();

    Session&                          m_session;
    std::shared_ptr<const TheirTrace> m_trace;
    std::optional<std::size_t>        m_row;
    std::optional<std::size_t>        m_wanted;  // the row that was gone to: others may have the same step
    std::optional<std::uint64_t>      m_events;  // of the step that was followed last
    std::vector<check::FieldBeside>   m_fields;
    std::optional<std::size_t>        m_fieldsOf;
    QString                           m_later, m_laterScene;  // openWith()
    std::uint64_t                     m_number    = 0;        // of the question asked last
    bool                              m_isJudging = false;
    std::unique_ptr<Worker>           m_worker;  // last: stops before anything else goes
};

}  // namespace zscope::ui
