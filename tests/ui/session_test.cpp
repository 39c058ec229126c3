// SPDX-License-Identifier: GPL-3.0-or-later
// The session and its worker: the newest request wins, what is kept over a change, and closing in the middle of work.
#include <atomic>
#include <memory>
#include <semaphore>
#include <thread>

#include <QAbstractItemModelTester>
#include <QFile>
#include <QImageReader>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/ui/ui_test.h"
#include "ui/panels/active_edges/edge_table_model.h"
#include "ui/panels/active_edges/line_strip.h"
#include "ui/panels/depth_test/depth_test_panel.h"
#include "ui/session/picture_name.h"
#include "ui/session/reproduce.h"
#include "ui/session/session.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

constexpr int kLong = 60'000;  // ms; a machine under load

ViewRequest smallView(const Scene&)
{
    ViewRequest view;
    view.width  = 160;
    view.height = 90;
    return view;
}

bool settles(const Session& session)
{
    return QTest::qWaitFor([&] { return session.isIdle() && session.now().busy.isEmpty(); }, kLong);
}

const Pipeline& pipelineOf(std::string_view name) { return findPreset(name)->pipeline; }

/// A session that shows the teapot by the scanline algorithm, small.
std::unique_ptr<Session> teapot()
{
    auto session = std::make_unique<Session>();
    session->setPipeline(pipelineOf("scanline"));
    session->open("builtin:teapot", smallView);
    return settles(*session) && session->now().step ? std::move(session) : nullptr;
}

QImage shownBy(const Session& session) { return imageOf(*session.now().colours()).copy(); }

}  // namespace

class SessionTest final : public QObject {
    Q_OBJECT

private slots:
    void theNewestRequestWins()
    {
        Worker                worker;
        std::binary_semaphore started{0}, goOn{0};
        std::atomic<int>      last = -1, runs = 0;
        worker.post(Worker::Slot::Step, [&](const std::atomic<bool>&) {
            started.release();
            goOn.acquire();
        });
        started.acquire();
        for (int i = 0; i < 100; ++i)
            worker.post(Worker::Slot::Step, [&, i](const std::atomic<bool>&) {
                last = i;
                ++runs;
            });
        goOn.release();
        QVERIFY(QTest::qWaitFor([&] { return !worker.isBusy(); }, kLong));
        QCOMPARE(last.load(), 99);
        QCOMPARE(runs.load(), 1);
    }
    void aLoadStopsWhateverRuns()
    {
        Worker                worker;
        std::binary_semaphore started{0};
        std::atomic<bool>     stopped = false, loaded = false;
        worker.post(Worker::Slot::Draw, [&](const std::atomic<bool>& cancel) {
            started.release();
            while (!cancel) std::this_thread::yield();
            stopped = true;
        });
        started.acquire();
        worker.post(Worker::Slot::Load, [&](const std::atomic<bool>& cancel) { loaded = !cancel; });
        QVERIFY(QTest::qWaitFor([&] { return !worker.isBusy(); }, kLong));
        QVERIFY(stopped);
        QVERIFY(loaded);  // the flag was lowered for the new job
    }
    void longWorkThatNobodyWantsIsStopped()
    {
        Worker                worker;
        std::binary_semaphore started{0};
        std::atomic<bool>     done = false;
        worker.post(Worker::Slot::Draw, [&](const std::atomic<bool>& cancel) {
            started.release();
            while (!cancel) std::this_thread::yield();
        });
        started.acquire();
        worker.post(Worker::Slot::Draw, [&](const std::atomic<bool>&) { done = true; });
        QVERIFY(QTest::qWaitFor([&] { return done.load(); }, kLong));
    }
    void workThatTakesLongerThanPatienceIsDoneAllTheSameWhileNewerKeepsComing()
    {
        Worker           worker;
        std::atomic<int> finished = 0;
        const auto       slow     = [&](const std::atomic<bool>& cancel) {
            const auto end = std::chrono::steady_clock::now() + 3 * Worker::kPatience;
            while (!cancel && std::chrono::steady_clock::now() < end) std::this_thread::yield();
            finished += !cancel;
        };
        QVERIFY(QTest::qWaitFor(
            [&] {
                worker.post(Worker::Slot::Draw, slow);
                return finished >= 2;
            },
            kLong));
    }
    void aStepDoesNotStopADrawing()
    {
        Worker                worker;
        std::binary_semaphore started{0}, goOn{0};
        std::atomic<bool>     cancelled = false, stepped = false;
        worker.post(Worker::Slot::Draw, [&](const std::atomic<bool>& cancel) {
            started.release();
            goOn.acquire();
            cancelled = cancel.load();
        });
        started.acquire();
        worker.post(Worker::Slot::Step, [&](const std::atomic<bool>&) { stepped = true; });
        QTest::qWait(2 * static_cast<int>(Worker::kPatience.count()));
        goOn.release();
        QVERIFY(QTest::qWaitFor([&] { return stepped.load(); }, kLong));
        QVERIFY(!cancelled);
    }

    void leftUndoesRightAndTheLastStepIsTheFinishedPicture()
    {
        const auto session = teapot();
        QVERIFY(session);
        const QImage finished = shownBy(*session);
        session->goToStep(40);
        QVERIFY(settles(*session));
        const QImage      at40  = shownBy(*session);
        const std::string state = stateToJson(session->now().step->state);
        session->stepBy(1);
        QVERIFY(settles(*session));
        QCOMPARE(session->position()->step, std::uint64_t{41});
        QVERIFY(shownBy(*session) != at40);
        session->stepBy(-1);
        QVERIFY(settles(*session));
        QCOMPARE(shownBy(*session), at40);
        QCOMPARE(stateToJson(session->now().step->state), state);
        session->goToEnd();
        QVERIFY(settles(*session));
        QCOMPARE(shownBy(*session), finished);
        QCOMPARE(imageOf(session->now().step->state.frame.colour).copy(), finished);
    }
    void backFromTheEndWorksBeforeTheNumberOfStepsIsKnown()
    {
        Session session;
        session.setPipeline(pipelineOf("scanline"));
        session.open("builtin:teapot", smallView);
        session.stepBy(-1);
        session.stepBy(-1);
        QVERIFY(settles(session));
        session.goToEnd();
        session.stepBy(-1);
        session.stepBy(-1);
        QVERIFY(settles(session));
        const auto at = session.position();
        QVERIFY(at);
        QCOMPARE(at->step, at->count - 3);
    }
    void cameraAndStepSurviveAnotherAlgorithm()
    {
        const auto session = teapot();
        QVERIFY(session);
        session->setGrain(Grain::Pixel);
        session->moveCamera([](CameraControl& camera) { camera.orbit(0.4, 0.1); });
        session->goToStep(123);
        QVERIFY(settles(*session));
        const Camera camera = session->now().camera;
        session->setPipeline(pipelineOf("zbuffer"));
        QVERIFY(settles(*session));
        QVERIFY(session->now().camera == camera);
        QVERIFY(session->now().step->pipeline == pipelineOf("zbuffer"));
        QCOMPARE(session->now().step->state.step.value, std::uint64_t{123});
        QCOMPARE(session->now().grain, Grain::Pixel);
        QVERIFY(session->now().showsStep);
    }
    void theTimeToldIsTheMedianOfSomeFramesButWhileTheCameraMovesOfOne()
    {
        const auto session = teapot();
        QVERIFY(session);
        QVERIFY(session->now().frame->framesTimed > 1);
        session->moveCamera([](CameraControl& camera) { camera.orbit(0.4, 0.1); });
        QVERIFY(settles(*session));
        QCOMPARE(session->now().frame->framesTimed, std::size_t{1});
        session->setPipeline(pipelineOf("zbuffer"));
        QVERIFY(settles(*session));
        QVERIFY(session->now().frame->framesTimed > 1);
    }
    void aFirstDrawingThatIsCancelledLeavesNothingOfTheOldSceneUnderTheNewName()
    {
        const auto session = teapot();
        QVERIFY(session);
        QObject    once;
        QSignalSpy told(session.get(), &Session::noticed);
        connect(session.get(), &Session::changed, &once, [&](Changes what) {
            if (what & Change::Scene) QTimer::singleShot(0, &once, [&] { session->cancelWork(); });
        });
        session->open("builtin:soccer-field");
        QVERIFY(settles(*session));
        QCOMPARE(session->now().scene->word, QString("builtin:soccer-field"));
        QVERIFY(!session->now().frame);
        QVERIFY(!session->now().visible());
        QCOMPARE(told.count(), 1);
        session->goToEnd();  // draws what is missing
        QVERIFY(settles(*session));
        QVERIFY(session->now().frame && session->now().frame->visibleTriangles > 1000);
    }
    void aStepBeyondAnotherAlgorithmsLastIsItsFinishedPicture()
    {
        const auto session = teapot();
        QVERIFY(session);
        session->setPipeline(pipelineOf("zbuffer"));
        session->setGrain(Grain::Pixel);
        QVERIFY(settles(*session));
        const std::uint64_t last = session->now().step->last();
        session->goToStep(last - 1);
        QVERIFY(settles(*session));
        QVERIFY(session->now().showsStep);
        session->setPipeline(pipelineOf("interval"));
        QVERIFY(settles(*session));
        QVERIFY(session->now().step->isLast() && session->now().step->last() < last - 1);
        QVERIFY(!session->now().showsStep);
        session->setPipeline(pipelineOf("zbuffer"));
        QVERIFY(settles(*session));
        QCOMPARE(session->now().step->state.step.value, last - 1);  // it has not forgotten
    }
    void everyAlgorithmEndsOnTheSamePicture()
    {
        const auto session = teapot();
        QVERIFY(session);
        const QImage first = shownBy(*session);
        for (const Preset& preset : presets()) {
            session->setPipeline(preset.pipeline);
            QVERIFY(settles(*session));
            if (preset.isExact()) QCOMPARE(shownBy(*session), first);
        }
    }
    void aFinerGrainStaysAtTheSameMoment()
    {
        const auto session = teapot();
        QVERIFY(session);
        session->goToStep(50);
        QVERIFY(settles(*session));
        const std::string sentence = session->now().step->state.sentence;
        const QImage      picture  = shownBy(*session);
        session->setGrain(Grain::Span);
        QVERIFY(settles(*session));
        QCOMPARE(session->now().step->state.grain, Grain::Span);
        QCOMPARE(shownBy(*session), picture);
        QCOMPARE(session->now().step->state.sentence, sentence);
        session->setGrain(Grain::Line);
        QVERIFY(settles(*session));
        QCOMPARE(session->position()->step, std::uint64_t{50});
    }
    void coarserStepsLandOnEventsOfTheCoarserGrain()
    {
        const auto session = teapot();
        QVERIFY(session);
        session->goToStep(50);
        QVERIFY(settles(*session));
        session->setGrain(Grain::Span);
        session->stepBy(1);  // into the next line
        QVERIFY(settles(*session));
        QVERIFY(session->now().step->state.event == Grain::Span);
        session->stepCoarser(1);
        QVERIFY(settles(*session));
        QVERIFY(session->now().step->state.event <= Grain::Line);
        const std::uint64_t ahead = session->position()->step;
        session->stepCoarser(-1);
        QVERIFY(settles(*session));
        QVERIFY(session->now().step->state.event <= Grain::Line);
        QVERIFY(session->position()->step < ahead);
        session->setGrain(Grain::Line);
        QVERIFY(settles(*session));
        QCOMPARE(session->position()->step, std::uint64_t{50});
    }
    void aFileThatCannotBeReadLeavesEverythingAsItWas()
    {
        const auto session = teapot();
        QVERIFY(session);
        session->goToStep(30);
        QVERIFY(settles(*session));
        const QImage  before = shownBy(*session);
        QTemporaryDir folder;
        QFile         file(folder.filePath(QString::fromUtf8("坏.obj")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nv 1 0 0\nf 1 2 99\n");
        file.close();
        QSignalSpy failed(session.get(), &Session::failed);
        session->open(file.fileName());
        QVERIFY(settles(*session));
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains(QString::fromUtf8("坏.obj")));
        QCOMPARE(session->now().scene->word, QString("builtin:teapot"));
        QCOMPARE(shownBy(*session), before);
        QCOMPARE(session->position()->step, std::uint64_t{30});
    }
    void aReloadKeepsCameraAlgorithmAndStep()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("tetra.obj");
        QFile         file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
        file.close();
        Session session;
        session.setPipeline(pipelineOf("scanline"));
        session.open(path, smallView);
        QVERIFY(settles(session));
        session.moveCamera([](CameraControl& camera) { camera.orbit(0.3, 0.2); });
        session.goToStep(20);
        QVERIFY(settles(session));
        const Camera camera = session.now().camera;
        session.reload();
        QVERIFY(settles(session));
        QVERIFY(session.now().camera == camera);
        QVERIFY(session.now().pipeline == pipelineOf("scanline"));
        QCOMPARE(session.position()->step, std::uint64_t{20});
    }
    void aPickedPixelTellsItsTriangle()
    {
        const auto session = teapot();
        QVERIFY(session);
        const VisibilityBuffer& visible = *session->now().visible();
        QPoint                  covered(-1, -1);
        for (int y = 0; y < visible.height() && covered.x() < 0; ++y)
            for (int x = 0; x < visible.width(); ++x)
                if (visible.idAt(x, y) >= 0) {
                    covered = {x, y};
                    break;
                }
        QVERIFY(covered.x() >= 0);
        session->pick(covered);
        const auto facts = factsOf(session->now(), covered);
        QVERIFY(facts && facts->triangle);
        QCOMPARE(static_cast<std::int64_t>(facts->triangle->value), visible.idAt(covered.x(), covered.y()));
        QVERIFY(std::abs(facts->z * static_cast<double>(facts->depth) - session->now().camera.near) < 1e-12);
        QVERIFY(!depthTestOf(session->now()).facts.empty());
        QVERIFY(!factsOf(session->now(), QPoint(160, 0)));
        session->nudgePick({-1000, -1000});
        QCOMPARE(*session->now().picked, QPoint(0, 0));
    }

    void theEdgeModelIsAProperModelAndShowsEveryActiveEdge()
    {
        const auto session = teapot();
        QVERIFY(session);
        EdgeTableModel           model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        std::size_t              most = 0;
        for (std::uint64_t step = 0; step < session->position()->count; step += 7) {
            session->goToStep(step);
            QVERIFY(settles(*session));
            model.present(session->now());
            const SweepState* sweep  = session->now().sweep();
            const std::size_t wanted = sweep ? sweep->activeEdges.size() + sweep->left.size() : 0;
            QCOMPARE(model.rows().size(), wanted);
            QVERIFY(std::ranges::is_sorted(model.rows(), {}, [](const auto& row) { return row.edge.x; }));
            for (const auto& row : model.rows()) QVERIFY(model.rowOf(row.edge) >= 0);
            most = std::max(most, wanted);
        }
        QVERIFY(most > 4);
    }
    void theStripGivesEveryPixelToItsOwner()
    {
        const auto session = teapot();
        QVERIFY(session);
        session->goToStep(45);
        QVERIFY(settles(*session));
        const StepState&        state = session->now().step->state;
        const LineStripContents strip = stripOf(state);
        QVERIFY(!strip.owners.empty());
        const int y = state.sweep->y;
        for (const StripRun& run : strip.owners)
            for (int x = run.x0; x < run.x1; ++x)
                QCOMPARE(state.frame.visible.idAt(x, y), static_cast<std::int64_t>(run.polygon));
        std::uint64_t owned = 0, covered = 0;
        for (const StripRun& run : strip.owners) owned += static_cast<std::uint64_t>(run.x1 - run.x0);
        for (int x = strip.x0; x < strip.x1; ++x) covered += state.frame.visible.idAt(x, y) >= 0;
        QCOMPARE(owned, covered);
    }

    void aSavedPictureCarriesItsCommandAndIsNeverReplacedSilently()
    {
        const auto session = teapot();
        QVERIFY(session);
        session->moveCamera([](CameraControl& camera) { camera.orbit(0.1, 0.05); });
        QVERIFY(settles(*session));
        QTemporaryDir folder;
        const QString name = freePictureName(session->now(), folder.path());
        QCOMPARE(name, QString("teapot_scanline_1"));
        const QString file = folder.filePath(name + ".png");
        QVERIFY(!savePicture(shownBy(*session), file, *session, false));
        QVERIFY(savePicture(shownBy(*session), file, *session, false));
        QCOMPARE(freePictureName(session->now(), folder.path()), QString("teapot_scanline_2"));
        QImageReader  reader(file);
        const QString command = QImage(file).text("Command");
        QVERIFY(command.startsWith("zscope-cli render builtin:teapot --size 160x90 --eye "));
        QVERIFY(command.contains("--algorithm scanline"));
        QFile bytes(file);
        QVERIFY(bytes.open(QIODevice::ReadOnly));
        QVERIFY(bytes.readAll().contains(session->now().scene->scene().digest.c_str()));
        QCOMPARE(reader.read().convertToFormat(QImage::Format_RGB32), shownBy(*session));

        // The numbers of the command are those of the camera, to the bit.
        const QStringList words = commandOf(session->now(), {});
        const QStringList eye   = words[words.indexOf("--eye") + 1].split(',');
        QCOMPARE(eye[0].toDouble(), session->now().camera.eye.x);
        QCOMPARE(eye[1].toDouble(), session->now().camera.eye.y);
        QCOMPARE(eye[2].toDouble(), session->now().camera.eye.z);
    }

    void closingInTheMiddleOfWorkIsSafe()
    {
        for (int wait = 0; wait < 40; ++wait) {
            auto session = std::make_unique<Session>();
            session->setPipeline(presets()[static_cast<std::size_t>(wait) % presets().size()].pipeline);
            session->open("builtin:city?blocks=20&seed=1");
            if (wait % 4 == 1) QTest::qWait(wait * 3);
            if (wait % 4 == 2) {
                QTest::qWait(wait * 5);
                session->moveCamera([](CameraControl& camera) { camera.orbit(0.1, 0); });
                session->stepBy(-5);
            }
            if (wait % 4 == 3) session->cancelWork();
        }
    }
};

ZSCOPE_UI_TEST(SessionTest, "session_test", Events)
#include "session_test.moc"
