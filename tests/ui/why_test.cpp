// SPDX-License-Identifier: GPL-3.0-or-later
// Why this pixel: the list, its links into the run, and the same for a triangle.
#include <QAbstractItemModelTester>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeView>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/why/why_model.h"
#include "ui/panels/why/why_panel.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

WhyPanel& panelOf(Desk& desk)
{
    desk.window.dock("why")->raise();
    QTest::qWait(20);
    return static_cast<WhyPanel&>(desk.window.dock("why")->panel());
}

bool answers(WhyPanel& panel)
{
    return QTest::qWaitFor([&] { return panel.isIdle() && panel.findChild<QTreeView*>()->model()->rowCount() > 0; },
                           Desk::kLong);
}

/// A pixel that several triangles cover.
QPoint busyPixel(const Session& session)
{
    const auto& tests = session.now().step->state.tests;
    QPoint      best(0, 0);
    for (int y = 0; y < tests.height(); ++y)
        for (int x = 0; x < tests.width(); ++x)
            if (tests.at(x, y) > tests.at(best.x(), best.y())) best = {x, y};
    return best;
}

}  // namespace

class WhyTest final : public QObject {
    Q_OBJECT

private slots:
    void theListNamesEveryTriangleAndItsWinnerIsThePictures()
    {
        for (const char* algorithm : {"zbuffer", "scanline", "hzb-octree", "interval"}) {
            Desk desk(algorithm);
            QVERIFY(desk.open("builtin:teapot"));
            Desk counting("zbuffer");
            QVERIFY(counting.open("builtin:teapot"));
            const QPoint pixel = busyPixel(counting.session);
            WhyPanel&    panel = panelOf(desk);
            desk.session.pick(pixel);
            QVERIFY(answers(panel));
            QVERIFY(panel.answer());
            QCOMPARE(panel.answer()->winner, desk.session.now().visible()->idAt(pixel.x(), pixel.y()));
            auto* model = panel.findChild<QTreeView*>()->model();
            QCOMPARE(model->rowCount(), static_cast<int>(panel.answer()->candidates.size()));
            QVERIFY(model->rowCount() >= 3);
            QAbstractItemModelTester tester(model, QAbstractItemModelTester::FailureReportingMode::QtTest);
            int                      winners = 0;
            for (const PixelCandidate& candidate : panel.answer()->candidates)
                winners += candidate.fate == fates::kWinner;
            QCOMPARE(winners, 1);
        }
    }
    void depthsAreWholeHoweverManyRowsThereAre()
    {
        int bars = 0;
        for (const QSize& size : {QSize(1280, 720), QSize(1280, 800), QSize(1600, 900), QSize(1920, 1200)}) {
            for (const char* scene : {"builtin:teapot", "builtin:layers"}) {
                Desk desk("scanline", size);
                QVERIFY(desk.open(scene));
                WhyPanel& panel = panelOf(desk);
                desk.session.pick(QPoint(160, 90));
                QVERIFY(answers(panel));
                QTest::qWait(50);
                auto* tree = panel.findChild<QTreeView*>();
                for (const auto* area : panel.findChildren<QScrollArea*>())
                    bars += area->verticalScrollBar()->isVisible();
                bars += tree->verticalScrollBar()->isVisible();
                QVERIFY(tree->columnViewportPosition(WhyModel::Depth) + tree->columnWidth(WhyModel::Depth)
                        <= tree->viewport()->width());
                QFont bold = tree->font();
                bold.setBold(true);
                const QString depth = tree->model()->index(0, WhyModel::Depth).data().toString();
                QVERIFY2(QFontMetrics(bold).horizontalAdvance(depth) < tree->columnWidth(WhyModel::Depth),
                         qPrintable(depth));
            }
        }
        QVERIFY(bars > 0);
    }
    void theTableGivesWayBeforeThePanelScrolls()
    {
        Desk desk("hzb-octree", {1600, 940});
        QVERIFY(desk.open("builtin:teapot"));
        WhyPanel& panel = panelOf(desk);
        desk.session.pick(QPoint(160, 90));
        QVERIFY(answers(panel));
        QTest::qWait(50);
        const auto* area = panel.findChild<QScrollArea*>();
        // else this would show nothing
        QVERIFY(panel.findChild<QTreeView*>()->height() < panel.findChild<QTreeView*>()->sizeHint().height());
        QVERIFY(!area->verticalScrollBar()->isVisible());
        for (const auto* button : panel.findChildren<QPushButton*>()) QVERIFY(!button->visibleRegion().isEmpty());
    }
    void atAnEarlierStepItSaysThatTheAnswerIsOfTheFinishedPicture()
    {
        Desk desk("zbuffer", {1600, 1000});
        QVERIFY(desk.open("builtin:teapot"));
        WhyPanel& panel = panelOf(desk);
        desk.session.pick(QPoint(160, 90));
        QVERIFY(answers(panel));
        const auto says = [&] {
            for (const auto* label : panel.findChildren<QLabel*>())
                if (label->isVisible() && label->text().contains("That is the finished picture")) return true;
            return false;
        };
        QVERIFY(!says());
        desk.session.goToStep(3);
        QVERIFY(desk.settles());
        QVERIFY(says());
        desk.session.goToEnd();
        QVERIFY(desk.settles());
        QVERIFY(!says());
    }
    void onALeafOfTheTreeRightStepsAndElsewhereItOpens()
    {
        Desk desk("zbuffer", {1600, 1000});
        QVERIFY(desk.open("builtin:teapot"));
        WhyPanel& panel = panelOf(desk);
        desk.session.pick(QPoint(160, 90));
        QVERIFY(answers(panel));
        desk.session.goToStep(3);
        QVERIFY(desk.settles());
        auto* tree = panel.findChild<QTreeView*>();
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        tree->setFocus();
        const QModelIndex top = tree->model()->index(0, 0);
        QVERIFY(tree->model()->hasChildren(top));
        tree->setCurrentIndex(top);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        QVERIFY(tree->isExpanded(top));
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, std::uint64_t{3});
        tree->setCurrentIndex(tree->model()->index(0, 0, top));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, std::uint64_t{4});
    }
    void aRowJumpsToItsMomentAndHighlightsItsNode()
    {
        Desk desk("hzb-octree", {1920, 1080});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3", {640, 360}));
        WhyPanel& panel = panelOf(desk);
        desk.session.pick(QPoint(300, 200));
        QVERIFY(answers(panel));
        auto* tree  = panel.findChild<QTreeView*>();
        auto* model = static_cast<WhyModel*>(tree->model());
        // The first triangle that a hidden node kept out.
        QModelIndex hidden;
        for (int row = 0; row < model->rowCount() && !hidden.isValid(); ++row)
            if (panel.answer()->candidates[static_cast<std::size_t>(row)].fate == fates::kNodeHidden)
                hidden = model->index(row, 0);
        QVERIFY(hidden.isValid());
        tree->setCurrentIndex(hidden);
        QVERIFY(desk.session.now().selectedTriangle);
        const Event* event = model->eventOf(hidden);
        QVERIFY(event && event->node);
        QVERIFY(desk.session.now().selectedNode == event->node);
        desk.photograph("why");
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_Return);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().grain, event->grain);
        QCOMPARE(desk.session.position()->step, event->moment.at(event->grain).value);
        const auto& hierarchy = *desk.session.now().hierarchy();
        const int   id        = rowOf(hierarchy.nodes, *event->node);
        QVERIFY(id >= 0);
        QVERIFY(hierarchy.nodes[static_cast<std::size_t>(id)].verdict == NodeVerdict::Hidden);
    }
    void aTriangleCanBeAskedWhyItIsMissing()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        WhyPanel& panel = panelOf(desk);
        desk.session.pick(QPoint(160, 90));
        QVERIFY(answers(panel));
        auto* field = panel.findChild<QLineEdit*>();
        field->setFocus();
        QTest::keyClicks(field, "5");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(QTest::qWaitFor([&] { return panel.isIdle() && !panel.answer(); }, Desk::kLong));
        desk.session.pick(QPoint(100, 90));  // another pick asks about the pixel again
        QVERIFY(QTest::qWaitFor([&] { return panel.answer() != nullptr; }, Desk::kLong));
        QCOMPARE(panel.answer()->pixel.x, 100);
    }
    void aTriangleThatThereIsNotLeavesTheFieldAndTheAnswerBefore()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        WhyPanel&  panel = panelOf(desk);
        auto*      field = panel.findChild<QLineEdit*>();
        auto*      tree  = panel.findChild<QTreeView*>();
        const auto asks  = [&](const QString& number) {
            field->setFocus();
            field->clear();
            QTest::keyClicks(field, number);
            QTest::keyClick(field, Qt::Key_Return);
            return QTest::qWaitFor([&] { return panel.isIdle(); }, Desk::kLong);
        };
        const auto says = [&](const QString& words) {
            return QTest::qWaitFor(
                [&] {
                    return std::ranges::any_of(panel.findChildren<QLabel*>(), [&](const QLabel* label) {
                        return label->isVisible() && label->text().contains(words);
                    });
                },
                2000);
        };
        QVERIFY(asks("999999999"));  // nothing is picked yet
        QVERIFY(says("there is no triangle 999999999"));
        QVERIFY(says("Click a pixel"));
        QVERIFY(field->isVisible());
        QVERIFY(asks("5"));
        QVERIFY(says("riangle 5"));
        QVERIFY(!says("there is no triangle"));
        QVERIFY(tree->isVisible() && !panel.answer());

        desk.session.pick(QPoint(160, 90));
        QVERIFY(QTest::qWaitFor([&] { return panel.answer() != nullptr; }, Desk::kLong));
        const auto before = panel.answer();
        const int  rows   = tree->model()->rowCount();
        QVERIFY(rows > 0);
        QVERIFY(asks("999999999"));
        QVERIFY(says("there is no triangle 999999999"));
        desk.photograph("why-trouble");
        QVERIFY(field->isVisible() && tree->isVisible());
        QCOMPARE(panel.answer(), before);
        QCOMPARE(tree->model()->rowCount(), rows);

        QVERIFY(asks("5"));
        QVERIFY(QTest::qWaitFor([&] { return !panel.answer(); }, Desk::kLong));
        desk.session.pick(QPoint(160, 90));  // the same pixel again
        QVERIFY(QTest::qWaitFor([&] { return panel.answer() != nullptr; }, Desk::kLong));
        QCOMPARE(panel.answer()->pixel.x, 160);
        QVERIFY(!says("there is no triangle"));
    }
    void theNewestQuestionWins()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:teapot"));
        WhyPanel& panel = panelOf(desk);
        for (int x = 100; x < 200; ++x) desk.session.pick(QPoint(x, 90));
        QVERIFY(QTest::qWaitFor([&] { return panel.answer() && panel.answer()->pixel.x == 199; }, Desk::kLong));
    }
};

ZSCOPE_UI_TEST(WhyTest, "why_test", Window)
#include "why_test.moc"
