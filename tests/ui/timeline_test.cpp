// SPDX-License-Identifier: GPL-3.0-or-later
// The timeline: stages and marks on the track, breakpoints both ways, the
// steps that change a pixel, and two runs stepped together.
#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "core/lesson/pixel_changes.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/marks/marks_model.h"
#include "ui/panels/timeline/step_track.h"
#include "ui/panels/timeline/timeline_panel.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

StepTrack&  trackOf(Desk& desk) { return *desk.window.findChild<StepTrack*>(); }
QTableView& marksOf(Desk& desk)
{
    desk.window.dock("marks")->raise();
    QTest::qWait(20);
    return *desk.window.dock("marks")->panel().findChild<QTableView*>();
}
std::uint64_t stepOf(const Desk& desk) { return desk.session.position()->step; }

/// A pixel that shows a triangle, near the middle.
QPoint coveredPixel(const Session& session)
{
    const VisibilityBuffer& visible = *session.now().visible();
    for (int x = visible.width() / 2; x < visible.width(); ++x)
        if (visible.idAt(x, visible.height() / 2) >= 0) return {x, visible.height() / 2};
    return {-1, -1};
}

}  // namespace

class TimelineTest final : public QObject {
    Q_OBJECT

private slots:
    void theTrackShowsTheStagesOfTheRun()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(desk.goTo(Grain::Line, 60));
        const auto& stages = trackOf(desk).marks().stages;
        QVERIFY(stages.size() >= 2);
        const auto& made = desk.session.now().step->stages;
        QCOMPARE(stages.size(), made.size());
        for (std::size_t i = 1; i < stages.size(); ++i) QVERIFY(stages[i - 1].step < stages[i].step);
        QVERIFY(std::ranges::any_of(stages, [](const auto& stage) { return stage.name == "raster"; }));
        desk.photograph("timeline");
    }
    void aBookmarkIsMadeNamedFoundAgainAndRemovedByKeys()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(desk.goTo(Grain::Line, 60));
        desk.press(Qt::Key_B, Qt::ControlModifier);
        QVERIFY(desk.goTo(Grain::Line, 100));
        desk.press(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(desk.session.now().marks.bookmarks.size(), std::size_t{2});
        QCOMPARE(trackOf(desk).marks().bookmarks.size(), std::size_t{2});
        desk.press(Qt::Key_PageUp, Qt::ControlModifier);
        QVERIFY(desk.settles());
        QCOMPARE(stepOf(desk), std::uint64_t{60});
        desk.press(Qt::Key_PageDown, Qt::ControlModifier);
        QVERIFY(desk.settles());
        QCOMPARE(stepOf(desk), std::uint64_t{100});

        QTableView&              table = marksOf(desk);
        QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        table.setCurrentIndex(table.model()->index(0, 0));
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_F2);
        auto* editor = table.findChild<QLineEdit*>();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, "the spout");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(desk.session.now().marks.bookmarks[0].name, QString("the spout"));

        desk.session.setPipeline(findPreset("zbuffer")->pipeline);  // a bookmark brings its algorithm and grain back
        QVERIFY(desk.settles());
        QVERIFY(trackOf(desk).marks().bookmarks.empty());
        table.setFocus();
        table.setCurrentIndex(table.model()->index(0, 0));
        QTest::keyClick(&table, Qt::Key_Return);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline == findPreset("scanline")->pipeline);
        QCOMPARE(desk.session.now().grain, Grain::Line);
        QCOMPARE(stepOf(desk), std::uint64_t{60});

        QTest::keyClick(&table, Qt::Key_Delete);
        QCOMPARE(desk.session.now().marks.bookmarks.size(), std::size_t{1});
        desk.press(Qt::Key_B, Qt::ControlModifier);  // a second time takes it away
        desk.press(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(desk.session.now().marks.bookmarks.size(), std::size_t{1});
    }
    void f5RunsFromStopToStopAndShiftF5TheSameWayBack()
    {
        for (const char* algorithm : {"zbuffer", "scanline", "hzb-octree"}) {
            Desk desk(algorithm);
            QVERIFY(desk.open("builtin:teapot"));
            const QPoint pixel = coveredPixel(desk.session);
            desk.session.pick(pixel);
            desk.press(Qt::Key_F9);
            const auto& set = desk.session.now().marks.breakpoints;
            QCOMPARE(set.size(), std::size_t{1});
            QVERIFY(set[0].on == Breakpoint::On::Pixel && set[0].pixel.x == pixel.x() && set[0].pixel.y == pixel.y());

            desk.press(Qt::Key_Home);
            QVERIFY(desk.settles());
            std::vector<std::uint64_t> forward;
            for (;;) {
                const std::uint64_t before = stepOf(desk);
                desk.press(Qt::Key_F5);
                QVERIFY(desk.settles());
                if (stepOf(desk) == before) break;
                forward.push_back(stepOf(desk));
                QVERIFY(forward.size() < 200);
            }
            QVERIFY(!forward.empty());
            QVERIFY(std::ranges::is_sorted(forward));
            for (std::size_t i = forward.size() - 1; i-- > 0;) {
                desk.press(Qt::Key_F5, Qt::ShiftModifier);
                QVERIFY(desk.settles());
                QCOMPARE(stepOf(desk), forward[i]);
            }
            desk.press(Qt::Key_F9);
            QVERIFY(desk.session.now().marks.breakpoints.empty());
        }
    }
    void breakpointsOfEveryKindAreSetFromTheMenuListedAndRemoved()
    {
        Desk desk("hzb-octree", {1600, 1000});
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.pick(coveredPixel(desk.session));
        QVERIFY(desk.session.now().selectedNode);
        for (const char* name : {"breakpoint.line", "breakpoint.pixel", "breakpoint.node", "breakpoint.triangle"}) {
            auto* action = desk.window.findChild<QAction*>(name);
            QVERIFY2(action, name);
            action->trigger();
        }
        QTableView& table = marksOf(desk);
        QCOMPARE(table.model()->rowCount(), 4);
        desk.press(Qt::Key_Home);
        QVERIFY(desk.settles());
        desk.press(Qt::Key_F5);
        QVERIFY(desk.settles());
        QVERIFY(stepOf(desk) > 0);
        desk.photograph("marks");
        table.setCurrentIndex(table.model()->index(0, 0));
        for (auto* button : desk.window.dock("marks")->findChildren<QPushButton*>())
            if (button->text() == "Remove") QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(desk.session.now().marks.breakpoints.size(), std::size_t{3});
        QVERIFY(desk.session.now().marks.breakpoints[0].on == Breakpoint::On::Pixel);
        desk.press(Qt::Key_F9, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(desk.session.now().marks.breakpoints.empty());
    }
    void theFirstChangeOfAPixelIsTheFirstStepWhosePictureShowsIt()
    {
        for (const char* algorithm : {"zbuffer", "scanline"}) {
            Desk desk(algorithm);
            QVERIFY(desk.open("builtin:cubes"));
            const QPoint pixel = coveredPixel(desk.session);
            QVERIFY(pixel.x() >= 0);
            desk.session.pick(pixel);
            desk.press(Qt::Key_Home, Qt::ControlModifier);
            QVERIFY(desk.settles());
            const std::uint64_t first = stepOf(desk);
            QVERIFY(first > 0);
            QVERIFY(desk.session.now().step->state.frame.visible.idAt(pixel.x(), pixel.y()) >= 0);
            QVERIFY(!trackOf(desk).marks().changes.empty());
            QCOMPARE(trackOf(desk).marks().changes.front(), first);
            desk.press(Qt::Key_Left);
            QVERIFY(desk.settles());
            QCOMPARE(desk.session.now().step->state.frame.visible.idAt(pixel.x(), pixel.y()), std::int64_t{-1});
            desk.press(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(desk.settles());
            QCOMPARE(stepOf(desk), first);
        }
    }
    void aStepAskedForWhileSearchingGoesBeforeTheSearch()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(desk.goTo(Grain::Triangle, 10));
        desk.session.toggleBreakpoint({.on = Breakpoint::On::Line, .line = 170});
        for (int i = 0; i < 20; ++i) {
            desk.session.runTo(Direction::Forward);
            desk.session.goToStep(static_cast<std::uint64_t>(20 + i));
        }
        QVERIFY(desk.settles());
        QCOMPARE(stepOf(desk), std::uint64_t{39});
    }
    void bFollowsTheLineTheStageAndThePixelOfA()
    {
        Desk desk("zbuffer", {1600, 1000});
        QVERIFY(desk.open("builtin:cubes"));
        const QPoint pixel = coveredPixel(desk.session);
        desk.session.pick(pixel);
        // back from the end: where it gets its last colour
        desk.press(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().showsStep);
        desk.session.compareWith(findPreset("scanline")->pipeline);
        QVERIFY(desk.settles());
        desk.window.dock("compare")->raise();
        QTest::qWait(20);
        auto* link = [&]() -> QComboBox* {
            for (auto* box : desk.window.dock("compare")->findChildren<QComboBox*>())
                if (box->findText("picked pixel") >= 0) return box;
            return nullptr;
        }();
        QVERIFY(link);
        const auto choose = [&](const char* text) {
            link->setCurrentIndex(link->findText(text));
            emit link->activated(link->currentIndex());
            return desk.settles();
        };
        QVERIFY(choose("picked pixel"));
        const auto& step = desk.session.now().step->state;
        const auto& b    = desk.session.now().compare.step;
        QVERIFY(b);
        QCOMPARE(b->state.frame.visible.idAt(pixel.x(), pixel.y()), step.frame.visible.idAt(pixel.x(), pixel.y()));
        desk.photograph("linked");

        // The other way round: A sweeps, B follows its line.
        desk.session.swapCompared();
        QVERIFY(desk.settles());
        desk.session.setGrain(Grain::Line);
        desk.session.pick(pixel);
        QVERIFY(desk.goTo(Grain::Line, 90));
        QVERIFY(choose("same line"));
        const int   line = desk.session.now().step->state.sweep->y;
        const auto& of   = desk.session.now().compare.step->state;
        QVERIFY(of.pixel);
        QCOMPARE(of.pixel->y, line);

        QVERIFY(choose("same stage"));
        QVERIFY(desk.session.now().compare.step->state.stage == desk.session.now().step->state.stage);
        QVERIFY(desk.session.now().compare.linkNote.what == LinkNote::What::PartOfStage);
    }
};

ZSCOPE_UI_TEST(TimelineTest, "timeline_test", Window)
#include "timeline_test.moc"
