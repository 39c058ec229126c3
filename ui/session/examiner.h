// SPDX-License-Identifier: GPL-3.0-or-later
// Judges what another program drew, as `zscope-cli check` does, and makes it the session's B. No widgets.
//
// First      what is wrong: B appears and is shown; A gets the layer, the size and the culling by which they can be
//            compared
// Then       the mistakes that explain it, which may take seconds. Cancelled, B stays as it was judged
// Camera     the one on show, in the size of the files; a dump with matrices brings its own
// Errors     Session::failed() with one sentence; what was B before stays B
// Threads    to be used from one thread; the judging happens on a worker of its own, and the newest request wins
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QStringList>

#include "core/check/check.h"
#include "ui/session/snapshot.h"
#include "ui/session/worker.h"

namespace zscope::ui {

class Session;

class Examiner final : public QObject {
    Q_OBJECT

public:
    explicit Examiner(Session& session, QObject* parent = nullptr);
    ~Examiner() override;

    /// They become B once they are judged. A scene must be open.
    void open(const QStringList& files);
    /// Once this scene is there: B is shown as `show` says, and A stays as it is. Another scene forgets it.
    void openWith(const QStringList& files, CompareShow show, const QString& sceneWord);
    /// Of B.
    const QStringList& files() const { return m_files; }
    /// The same files as they are by now, by the camera of the moment.
    void judgeAgain();
    void cancel();
    /// To the scene and the camera by which B was judged.
    void goBack();
    /// Wants a dialog that asks for files.
    void chooseFiles() { emit filesWanted(); }
    void chooseReport() { emit reportWanted(); }
    /// The page of `check --report`, written in the background; Session::noticed() says when it is there.
    void saveReport(const QString& file);

    enum class Phase { Idle, Judging, Diagnosing };
    Phase phase() const { return m_phase; }
    bool  isIdle() const { return m_phase == Phase::Idle && !m_worker->isBusy(); }
    /// In [0, 1], or -1: not known.
    double progress() const { return m_progress; }

signals:
    /// Another phase, or more progress.
    void changed();
    /// B has appeared.
    void opened();
    void filesWanted();
    void reportWanted();

private:
    struct Question;
    struct Later {  // openWith()
        QStringList files;
        CompareShow show = CompareShow::A;
        QString     sceneWord;
    };
    struct Desk;  // what the worker keeps between two questions

    void ask(const QStringList& files, bool isNew, std::optional<CompareShow> seen = {});
    void judged(const std::shared_ptr<const TheirPicture>& theirs, const Question& question);
    void show(Phase phase, double progress = -1);

    Session&                m_session;
    QStringList             m_files;  // of B
    std::optional<Later>    m_later;
    std::shared_ptr<Desk>   m_desk;          // used by jobs of the worker only
    std::uint64_t           m_number   = 0;  // of the question asked last
    Phase                   m_phase    = Phase::Idle;
    double                  m_progress = -1;
    std::unique_ptr<Worker> m_worker;  // last: stops before anything else goes
};

}  // namespace zscope::ui
