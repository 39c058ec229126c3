// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/examiner.h"

#include <chrono>
#include <utility>

#include <QDir>
#include <QFileInfo>

#include "core/check/report.h"
#include "core/io/file_writer.h"
#include "ui/session/session.h"
#include "ui/session/their_files.h"
#include "ui/session/tracer.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {

namespace {

constexpr std::chrono::milliseconds kNewsEvery{60};

QString titleOf(const QStringList& files)
{
    QStringList names;
    for (const QString& file : files) names << QFileInfo(file).fileName();
    return names.join(QStringLiteral(", "));
}

/// The view in the size of the files.
ViewRequest inSize(ViewRequest view, const QSize& size)
{
    view.width  = size.width();
    view.height = size.height();
    if (view.exact) view.exact->width = size.width(), view.exact->height = size.height();
    return view;
}

}  // namespace

struct Examiner::Question {
    std::uint64_t                      number = 0;
    QStringList                        files;
    bool                               isNew = true;  // the window is brought to where B can be compared
    std::optional<CompareShow>         seen;          // otherwise: what of B is seen then
    std::shared_ptr<const LoadedScene> scene;
    ViewRequest                        view;
    Camera                             camera;
    Look                               look;
    std::shared_ptr<const DrawnFrame>  a;
};

/// References and pictures with mistakes are kept while scene and camera stay the same.
struct Examiner::Desk {
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;
    std::optional<check::Checker>        checker;

    check::Checker& checkerFor(const std::shared_ptr<const PreparedScene>& of, const Camera& by)
    {
        if (!checker || scene != of || !(camera == by)) {
            checker.reset();
            checker.emplace(of);
            scene  = of;
            camera = by;
        }
        return *checker;
    }
};

namespace {

/// Without causes. Of numbers that may be depth or ids it is found out here what they are: what leaves fewer pixels
/// wrong.
Result<check::CheckAnswer> firstAnswer(check::Checker& checker, check::CheckRequest& request, const TheirFiles& files)
{
    request.diagnoses = false;
    if (!files.numbers) return checker.check(request);
    request.depth      = files.numbers;
    auto       asDepth = checker.check(request);
    const auto depth   = std::exchange(request.depth, std::nullopt);
    if (!asDepth && asDepth.error().kind != Trouble::Input) return asDepth;
    request.ids = files.numbers;
    auto asIds  = checker.check(request);
    if (!asDepth || (asIds && asIds->wrong.total() <= asDepth->wrong.total())) return asIds;
    request.depth = depth;
    request.ids.reset();
    return asDepth;
}

}  // namespace

Examiner::Examiner(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_desk(std::make_shared<Desk>()), m_worker(std::make_unique<Worker>())
{
    connect(&session, &Session::changed, this, [this](Changes what) {
        if ((what & Change::Scene) && m_later) {
            const Later later = *std::exchange(m_later, {});
            if (m_session.now().scene->word == later.sceneWord)  // once the scene has its view
                QTimer::singleShot(0, this, [this, later] { ask(later.files, false, later.show); });
        }
        // B is another by now
        const bool isForgotten =
            (what & Change::Compare) && !m_session.now().compare.theirs && m_phase == Phase::Diagnosing;
        if (isForgotten) cancel();
    });
}

Examiner::~Examiner() = default;

void Examiner::show(Phase phase, double progress)
{
    m_phase    = phase;
    m_progress = progress;
    emit changed();
}

void Examiner::open(const QStringList& files) { ask(files, true); }

void Examiner::openWith(const QStringList& files, CompareShow show, const QString& sceneWord)
{
    m_later = Later{files, show, sceneWord};
}

void Examiner::judgeAgain()
{
    if (m_session.now().compare.theirs) ask(m_files, false);
}

void Examiner::cancel()
{
    ++m_number;
    m_worker->cancel();
    show(Phase::Idle);
}

void Examiner::goBack()
{
    const auto theirs = m_session.now().compare.theirs;
    if (!theirs || !m_session.now().scene) return;
    const auto viewOf = Session::seenBy(theirs->camera(), m_session.settings().faceCulling);
    if (m_session.now().scene->scene().digest != theirs->scene)
        m_session.open(theirs->sceneWord, viewOf);
    else
        m_session.useView(viewOf(m_session.now().scene->scene()));
}

void Examiner::saveReport(const QString& file)
{
    const auto theirs = m_session.now().compare.theirs;
    if (!theirs) return;
    auto trace = m_session.tracer().shared();  // one of another view has no place there
    if (trace && (trace->scene != theirs->scene || trace->camera != theirs->camera())) trace.reset();
    m_worker->post(Worker::Slot::Draw, [this, theirs, trace, file](const std::atomic<bool>&) {
        const auto page = check::reportPage(
            *theirs->answer, {},
            trace ? check::ReportedTrace{trace->answer.get(), trace->trace.get()} : check::ReportedTrace{});
        Result<Done> written = Done{};
        if (page)
            written = writeFile(file.toStdString(), *page);
        else
            written = page.error();
        m_worker->deliver([this, file, written] {
            if (!written)
                return emit m_session.failed(said(written.error()), [written] { return said(written.error()); });
            emit m_session.noticed(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
        });
    });
}

void Examiner::ask(const QStringList& files, bool isNew, std::optional<CompareShow> seen)
{
    const Snapshot& now = m_session.now();
    if (!now.scene) {
        const auto  say = [] { return tr("Open the scene first that your picture shows."); };
        return emit m_session.failed(say(), say);
    }
    const Question question{++m_number, files, isNew, seen, now.scene, now.view, now.camera, now.look, now.frame};
    show(Phase::Judging);
    m_worker->post(Worker::Slot::Load, [this, question, desk = m_desk](const std::atomic<bool>& cancel) {
        const auto mine = [this, number = question.number](auto answer) {
            m_worker->deliver([this, number, answer = std::move(answer)] {
                if (number == m_number) answer();
            });
        };
        const auto fail = [&](const Error& error) {
            mine([this, error] {
                show(Phase::Idle);
                if (error.kind != Trouble::Cancelled)
                    emit m_session.failed(said(error), [error] { return said(error); });
            });
        };
        const auto sorted = theirFilesOf(question.files);
        if (!sorted) return fail(sorted.error());

        Camera camera = question.camera;
        if (sorted->size && *sorted->size != QSize(camera.width, camera.height)) {
            const auto sized = makeCamera(inSize(question.view, *sorted->size), question.scene->scene().bounds);
            if (!sized) return fail(sized.error());
            camera = *sized;
        }
        check::CheckRequest request;
        request.depth   = sorted->depth;
        request.ids     = sorted->ids;
        request.picture = sorted->picture;
        request.dump    = sorted->dump;
        if (!sorted->hasMatrices) request.camera = camera;
        auto told               = std::chrono::steady_clock::now();
        request.progress.cancel = &cancel;
        request.progress.report = [&](double fraction, std::string_view) {
            const auto time = std::chrono::steady_clock::now();
            if (time - told < kNewsEvery) return;
            told = time;
            mine([this, fraction] { show(m_phase, fraction); });
        };
        check::Checker& checker = desk->checkerFor(question.scene->prepared, camera);
        auto            answer  = firstAnswer(checker, request, *sorted);
        if (!answer) return fail(answer.error());

        auto theirs         = std::make_shared<TheirPicture>();
        theirs->title       = titleOf(question.files);
        theirs->scene       = question.scene->scene().digest;
        theirs->sceneWord   = question.scene->word;
        theirs->answer      = std::make_shared<const check::CheckAnswer>(std::move(answer).value());
        theirs->isDiagnosed = theirs->answer->isRight();  // there is nothing to explain
        if (const auto filled = fill(*theirs, *sorted); !filled) return fail(filled.error());
        Look look = question.look;
        if (question.isNew) look.layer = &layerFor(*theirs->answer, *look.layer);
        const auto shown = repainted(*theirs, look, question.a.get());
        mine([this, shown, question] { judged(shown, question); });
        if (shown->isDiagnosed) return mine([this] { show(Phase::Idle); });

        mine([this] { show(Phase::Diagnosing, 0); });
        request.diagnoses = true;
        answer            = checker.check(request);
        if (!answer) return fail(answer.error());
        mine([this, found = std::make_shared<const check::CheckAnswer>(std::move(answer).value())] {
            show(Phase::Idle);
            const auto before = m_session.now().compare.theirs;
            if (!before) return;
            auto diagnosed         = std::make_shared<TheirPicture>(*before);
            diagnosed->answer      = found;
            diagnosed->isDiagnosed = true;
            m_session.compareWithTheirs(diagnosed);
        });
    });
}

void Examiner::judged(const std::shared_ptr<const TheirPicture>& theirs, const Question& question)
{
    m_files = question.files;
    // A user who has opened another scene or view in the meantime keeps it.
    const bool isThere = m_session.now().camera == question.camera && m_session.now().scene == question.scene;
    if (isThere && !(theirs->camera() == question.camera)) {
        m_session.setPictureSize(theirs->camera().width, theirs->camera().height);
        if (!(m_session.now().camera == theirs->camera()))
            m_session.useView(
                Session::seenBy(theirs->camera(), m_session.settings().faceCulling)(question.scene->scene()));
    }
    if (question.isNew) {
        m_session.setLayer(*theirs->look.layer);
        if (const auto cull = theirs->answer->conventions.cull) m_session.setFaceCulling(*cull);
    }
    m_session.compareWithTheirs(theirs);
    if (question.seen) m_session.showCompared(*question.seen);
    if (!question.isNew) return;
    m_session.showCompared(CompareShow::B);
    emit opened();
}

}  // namespace zscope::ui
