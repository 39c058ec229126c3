// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of the pyramid and of the hierarchy, and the observer, driven by keys and mouse as a person would.
#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/hierarchy/hierarchy_panel.h"
#include "ui/panels/hierarchy/node_model.h"
#include "ui/panels/observer/observer_panel.h"
#include "ui/panels/observer/observer_view.h"
#include "ui/panels/pyramid/level_thumbs.h"
#include "ui/panels/pyramid/level_view.h"
#include "ui/panels/pyramid/pyramid_words.h"
#include "ui/panels/registry.h"
#include "ui/parts/choice_box.h"
#include "ui/theme/theme.h"
#include "ui/view/overlay.h"
#include "ui/window/layouts.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

/// The index of a verdict's switch in its bar, which holds them in the order of kVerdicts.
QToolButton* switchOf(QWidget& panel, const QString& shape)
{
    for (auto* button : panel.findChildren<QToolButton*>("verdict"))
        if (button->text().startsWith(shape)) return button;
    return nullptr;
}

int rowsBelow(const QAbstractItemModel& model, const QModelIndex& parent = {})
{
    int rows = 0;
    for (int row = 0; row < model.rowCount(parent); ++row) rows += 1 + rowsBelow(model, model.index(row, 0, parent));
    return rows;
}

bool isDrawn(ObserverView& view)
{
    return QTest::qWaitFor([&] { return view.isIdle() && view.observer() != nullptr; }, Desk::kLong);
}

}  // namespace

class PanelsTest final : public QObject {
    Q_OBJECT

private slots:
    void theWheelOverABoxScrollsItsPanelAndChangesNothing()
    {
        Desk desk("hzb-octree", {1280, 800});
        QVERIFY(desk.open("builtin:cubes"));
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.window.setFocus();
        const auto turn = [](QWidget& widget) {
            const QPoint at = widget.rect().center();
            QWheelEvent  wheel(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                               Qt::NoScrollPhase, false);
            // as a mouse does: it goes on to parents, and may give the focus
            QSpontaneKeyEvent::setSpontaneous(&wheel);
            qApp->notify(&widget, &wheel);
        };
        auto&          panel    = desk.window.dock("pipeline")->panel();
        auto*          scroll   = panel.findChild<QScrollArea*>();
        const Pipeline pipeline = desk.session.now().pipeline;
        int            boxes    = 0;
        QVERIFY(scroll->verticalScrollBar()->maximum() > 0);
        turn(*panel.findChild<QComboBox*>());
        QVERIFY(scroll->verticalScrollBar()->value() > 0);
        for (auto* box : desk.window.findChildren<QComboBox*>()) {
            if (!box->isVisible()) continue;
            ++boxes;
            const int before = box->currentIndex();
            turn(*box);
            QVERIFY2(!box->hasFocus(), qPrintable(box->accessibleName()));
            box->setFocus();
            turn(*box);
            QCOMPARE(box->currentIndex(), before);
        }
        QVERIFY(boxes > 5);
        QVERIFY(desk.session.now().pipeline == pipeline);

        desk.window.setFocus();
        auto* number = desk.window.dock("scene")->findChild<QDoubleSpinBox*>();
        QVERIFY(number && number->isVisible());
        const double before = number->value();
        turn(*number->findChild<QLineEdit*>());
        QCOMPARE(number->value(), before);
        QVERIFY(!number->hasFocus());
        number->setFocus();  // and now it is meant
        turn(*number->findChild<QLineEdit*>());
        QVERIFY(number->value() != before);
        QVERIFY(desk.settles());
    }
    void aBoxAsWideAsItsLongestNameShortensNone()
    {
        QWidget window;
        window.setStyleSheet("QComboBox { padding: 3px 20px 3px 8px; border: 1px solid }");
        for (double points = 7; points < 20; points += 0.25) {
            ChoiceBox box(&window);
            QFont     font = box.font();
            font.setPointSizeF(points);
            box.setFont(font);
            box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
            for (const char* name : {"triangle", "vertex", "pixel"}) box.addItem(name);
            box.ensurePolished();
            box.resize(box.sizeHint());
            QStyleOptionComboBox option;
            option.initFrom(&box);
            const int room =
                box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width()
                - 2;
            QCOMPARE(box.fontMetrics().elidedText("triangle", Qt::ElideRight, room), QString("triangle"));
        }
    }
    void whoHasChosenFromABoxByMouseStillPlaysWithSpace()
    {
        Desk desk("zbuffer", {1280, 800});
        QVERIFY(desk.open("builtin:cubes"));
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.session.player().setSpeed(1);
        int boxes = 0;
        for (auto* box : desk.window.findChildren<QComboBox*>()) {
            if (!box->isVisible() || !box->isEnabled() || box->count() < 2) continue;
            ++boxes;
            desk.window.setFocus();
            QTest::mouseClick(box, Qt::LeftButton);
            QVERIFY2(QTest::qWaitFor([&] { return box->view()->isVisible(); }, 2000),
                     qPrintable(box->accessibleName()));
            QTest::keyClick(box->view(), Qt::Key_Return);  // what was chosen before
            QVERIFY(QTest::qWaitFor([&] { return !box->view()->isVisible(); }, 2000));
            QVERIFY2(!box->hasFocus(), qPrintable(box->accessibleName()));
        }
        QVERIFY(boxes > 5);
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.session.goToStart();
        QVERIFY(desk.settles());
        desk.press(Qt::Key_Space);
        QVERIFY(desk.session.player().isPlaying());
        desk.press(Qt::Key_Space);
        QVERIFY(!desk.session.player().isPlaying());
    }
    void panelsThatTheAlgorithmDoesNotNeedFoldAway()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        for (const char* panel : {"pyramid", "hierarchy", "observer"}) QVERIFY(!desk.window.dock(panel)->isVisible());
        desk.session.setPipeline(findPreset("quadtree")->pipeline);
        QVERIFY(desk.settles());
        QVERIFY(desk.window.dock("pyramid")->isVisible());
        QVERIFY(!desk.window.dock("hierarchy")->isVisible());
        desk.session.setPipeline(findPreset("octree-frustum")->pipeline);
        QVERIFY(desk.settles());
        QVERIFY(!desk.window.dock("pyramid")->isVisible());
        QVERIFY(desk.window.dock("hierarchy")->isVisible());
    }
    void aMeasuredChoiceShowsThePanelsOfWhatItsStepsRun()
    {
        Desk desk("auto");
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(!desk.window.dock("pyramid")->isVisible());
        QVERIFY(desk.open("builtin:office-tower"));
        QVERIFY(desk.session.now().hierarchy() && desk.session.now().hierarchy()->tree);
        QVERIFY(desk.window.dock("pyramid")->isVisible());
        QVERIFY(desk.window.dock("hierarchy")->isVisible());
    }
    void theWindowFitsASmallScreenWithEveryAlgorithm()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        for (const Preset& preset : presets()) {
            desk.session.setPipeline(preset.pipeline);
            QVERIFY(desk.settles());
            QTest::qWait(20);
            const QByteArray size = QByteArray(preset.name.data(), static_cast<qsizetype>(preset.name.size())) + ": "
                                    + QByteArray::number(desk.window.width()) + " x "
                                    + QByteArray::number(desk.window.height());
            QVERIFY2(desk.window.height() <= 800 && desk.window.width() <= 1280, size.constData());
        }
        desk.session.setPipeline(findPreset("hzb-octree")->pipeline);
        QVERIFY(desk.settles());
        desk.photograph("small");
    }
    void theWindowFitsALowScreenInEveryLayoutAndLanguage()
    {
        constexpr QSize kLow{1000, 680};  // what 1366 x 768 leaves below title and task bar, and narrower still
        Desk            desk;
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.pick(QPoint(160, 90));
        for (const Language language : {Language::English, Language::Chinese}) {
            desk.window.speak(language);
            for (const LayoutEntry& layout : layoutEntries()) {
                desk.window.useLayout(layout.word);
                for (const char* preset : {"zbuffer", "hzb-octree", "scanline", "interval"}) {
                    desk.session.setPipeline(findPreset(preset)->pipeline);
                    QVERIFY(desk.settles());
                    for (const PanelEntry& panel : panels()) {  // also where another is in front
                        desk.window.dock(panel.word)->raise();
                        QTest::qWait(0);
                        const QSize least = desk.window.minimumSizeHint();
                        QVERIFY2(least.height() <= kLow.height() && least.width() <= kLow.width(),
                                 qPrintable(QStringLiteral("%1, %2, %3: %4 x %5")
                                                .arg(layout.word, preset, panel.word)
                                                .arg(least.width())
                                                .arg(least.height())));
                    }
                }
            }
        }
    }
    void theWindowBeginsNoLargerThanTheScreen()
    {
        QTemporaryDir folder;
        Settings      settings(folder.filePath("settings.ini"));
        Session       session;
        MainWindow    window(session, settings, QApplication::palette());
        QVERIFY(window.width() < std::max(1281, window.minimumSizeHint().width())
                && window.height() < window.screen()->availableSize().height());
    }
    void aNarrowWindowCutsNothingAndAWideOneHasItsColumnsBack()
    {
        Desk desk("scanline", {1280, 800});
        QVERIFY(desk.open("builtin:teapot", {640, 360}));
        QVERIFY(desk.goTo(Grain::Line, 180));
        auto*     table = desk.window.dock("active-edges")->findChild<QTableView*>();
        auto*     tools = desk.window.findChild<QToolBar*>("tools");
        const int wide  = desk.window.dock("active-edges")->width();
        for (const QSize& size :
             {QSize(964, 700), QSize(1280, 800), QSize(1600, 1000), QSize(1000, 700), QSize(1280, 720)}) {
            desk.window.resize(size);
            QTest::qWait(50);
            QCOMPARE(desk.window.size(), size);
            for (const auto* dock : desk.window.findChildren<PanelDock*>()) {
                if (!dock->isVisible() || dock->visibleRegion().isEmpty()) continue;
                QVERIFY2(dock->geometry().right() < size.width(), dock->entry().word);
                QVERIFY2(dock->minimumSizeHint().width() <= dock->width(), dock->entry().word);
            }
            for (auto* button : tools->findChildren<QToolButton*>()) {
                if (button->objectName() == "qt_toolbar_ext_button")
                    QVERIFY(!button->isVisible());
                else
                    QVERIFY2(
                        button->isVisible() && tools->rect().adjusted(0, 0, 0, -kStep).contains(button->geometry()),
                        qPrintable(button->text()));
            }
            if (size.width() < 1280) continue;
            QCOMPARE(desk.window.dock("active-edges")->width(), wide);
            QVERIFY2(QTest::qWaitFor([&] { return !table->horizontalScrollBar()->isVisible(); }, 2000),
                     qPrintable(QStringLiteral("%1 x %2: %3 of %4")
                                    .arg(size.width())
                                    .arg(size.height())
                                    .arg(table->viewport()->width())
                                    .arg(table->horizontalHeader()->length())));
        }
    }
    void theSweepsTableStripAndBucketsAreAllSeenAt1280By800()
    {
        for (const bool isLate : {false, true}) {  // chosen before the window is seen, or after
            Desk desk(isLate ? "zbuffer" : "scanline", {1280, 800});
            QVERIFY(desk.open("builtin:teapot", {640, 360}));
            desk.session.setPipeline(findPreset("scanline")->pipeline);
            QVERIFY(desk.settles());
            QVERIFY(desk.goTo(Grain::Line, 180));
            QTest::qWait(50);
            for (const char* panel : {"active-edges", "scene"})
                for (auto* area : desk.window.dock(panel)->findChildren<QScrollArea*>())
                    QVERIFY2(!area->verticalScrollBar()->isVisible(),
                             qPrintable(QStringLiteral("%1: %2 of %3")
                                            .arg(panel)
                                            .arg(area->height())
                                            .arg(area->widget()->minimumSizeHint().height())));
        }
    }
    void theTreesColumnsFitBesideItsScrollBar()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3", {640, 360}));
        QVERIFY(desk.goTo(Grain::Node, 60));
        QTest::qWait(50);
        auto* tree = desk.window.dock("hierarchy")->findChild<QTreeView*>();
        QVERIFY(tree->verticalScrollBar()->isVisible());
        QVERIFY(!tree->horizontalScrollBar()->isVisible());
    }
    void thumbnailsNeverOverlapAndNeverLeaveTheirRoom()
    {
        for (const int count : {1, 5, 9, 12, 15}) {
            for (const int width : {90, 200, 416, 900}) {
                const ThumbLayout layout = thumbLayout(count, width, {1280, 720}, 6);
                for (int i = 0; i < count; ++i) {
                    QVERIFY(layout.placeOf(i, 6).right() < width);
                    for (int j = 0; j < i; ++j) QVERIFY(!layout.placeOf(i, 6).intersects(layout.placeOf(j, 6)));
                }
                QVERIFY(layout.rows * layout.columns >= count);
                QVERIFY(layout.rows * layout.columns < count + layout.columns);
            }
        }
    }
    void aClickOnALevelShowsItLargeAndFollowGoesBackToTheStep()
    {
        Desk desk("hzb-octree", {1920, 1080});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3", {640, 360}));
        QVERIFY(desk.goTo(Grain::Query, 60));
        auto* panel  = &desk.window.dock("pyramid")->panel();
        auto* thumbs = panel->findChild<LevelThumbs*>();
        QVERIFY(desk.session.now().hierarchy()->query);
        QCOMPARE(levelOnShow(desk.session.now()), desk.session.now().hierarchy()->query->level);
        const int         count  = static_cast<int>(desk.session.now().step->pyramid.levels.size());
        const ThumbLayout layout = thumbLayout(count, thumbs->width(), {640, 360}, 6);
        QVERIFY(thumbs->height() >= layout.placeOf(count - 1, 6).bottom());  // all of them are seen
        QTest::mouseClick(thumbs, Qt::LeftButton, {}, layout.placeOf(2, 6).center());
        QCOMPARE(desk.session.now().selectedLevel, std::optional(2));
        QTest::keyClick(thumbs, Qt::Key_PageUp);
        QCOMPARE(levelOnShow(desk.session.now()), 3);
        for (auto* button : panel->findChildren<QAbstractButton*>())
            if (button->text() == "Follow the step") QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(!desk.session.now().selectedLevel);
    }
    void theWordsTellWhatWasAskedAndWhatWasFound()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3", {640, 360}));
        bool hidden = false, seen = false;
        for (int step = 0; step < 200 && !(hidden && seen); step += 3) {
            QVERIFY(desk.goTo(Grain::Query, step));
            const HierarchyState* hierarchy = desk.session.now().hierarchy();
            if (!hierarchy || !hierarchy->query) continue;
            const PyramidWords words =
                wordsOf(*hierarchy, desk.session.now().step->pyramid.empty, themeOf(desk.window.palette()));
            QVERIFY(words.question.contains(QString("%1 × %2 px")
                                                .arg(hierarchy->query->box.x1 - hierarchy->query->box.x0)
                                                .arg(hierarchy->query->box.y1 - hierarchy->query->box.y0)));
            QCOMPARE(words.question.contains("<b>hidden</b>"), hierarchy->query->hidden);
            (hierarchy->query->hidden ? hidden : seen) = true;
        }
        QVERIFY(hidden && seen);
    }
    void theLevelLiesOverThePictureWhenAsked()
    {
        Desk desk("hzb-octree", {1920, 1080});
        QVERIFY(desk.open("builtin:office-tower", {1280, 720}));
        QVERIFY(desk.goTo(Grain::Query, 4000));
        desk.session.selectLevel(6);
        const QImage before = desk.window.view().picture(true);
        auto*        box    = desk.window.dock("pyramid")->findChild<QCheckBox*>();
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        QVERIFY(desk.session.now().layers.pyramid);
        const Overlay overlay = overlayOf(desk.session.now(), desk.session.now().layers);
        QVERIFY(overlay.cells);
        QCOMPARE(overlay.cells->level, levelOnShow(desk.session.now()));
        QVERIFY(desk.window.view().picture(true) != before);
        desk.photograph("pyramid");
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        QCOMPARE(desk.window.view().picture(true), before);
    }
    void aClickOnTheLargeLevelPicksThePixelUnderIt()
    {
        Desk desk("quadtree", {1920, 1080});
        QVERIFY(desk.open("builtin:cubes"));
        auto* large = desk.window.dock("pyramid")->findChild<LevelView*>();
        QTest::mouseClick(large, Qt::LeftButton, {}, large->rect().center());
        QVERIFY(desk.session.now().picked);
        const QPoint off      = *desk.session.now().picked - QPoint(160, 90);
        const double perPixel = 180.0 / large->height();  // the middle of the widget, to a pixel of the screen
        QVERIFY(std::abs(off.x()) <= 1 + perPixel && std::abs(off.y()) <= 1 + perPixel);
    }

    void theNodeModelIsAProperModelAtEveryStep()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3"));
        NodeModel                model;
        NodeFilter               filter(model);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QAbstractItemModelTester filterTester(&filter, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (const int step : {0, 1, 2, 7, 20, 5, 60, -1}) {
            QVERIFY(desk.goTo(Grain::Node, step));
            model.present(desk.session.now());
            const HierarchyState* hierarchy = desk.session.now().hierarchy();
            QCOMPARE(rowsBelow(model), hierarchy ? static_cast<int>(hierarchy->nodes.size()) : 0);
            QCOMPARE(rowsBelow(filter), rowsBelow(model));
        }
        QVERIFY(rowsBelow(model) > 10);
        filter.setText("0.3");
        for (int id = 0; id < model.count(); ++id) {
            const bool kept = filter.mapFromSource(model.indexOf(id)).isValid();
            if (QString::fromStdString(model.row(id).path).contains("0.3")) QVERIFY(kept);
        }
        QVERIFY(rowsBelow(filter) < rowsBelow(model));
    }
    void theCountsPerDepthAddUpToTheNodes()
    {
        Desk desk("hzb-bvh");
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3"));
        QVERIFY(desk.goTo(Grain::Node, -1));
        const auto& nodes = desk.session.now().hierarchy()->nodes;
        std::size_t sum   = 0;
        for (const auto& counts : countsByDepth(nodes))
            for (const std::size_t n : counts) sum += n;
        QCOMPARE(sum, nodes.size());
        QCOMPARE(countsByDepth(nodes)[0][static_cast<std::size_t>(nodes[0].verdict)], std::size_t{1});
    }
    void theFilterAndTheSwitchesLeaveTheNodesThatWereAskedFor()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3"));
        QVERIFY(desk.goTo(Grain::Node, -1));
        auto&     panel = desk.window.dock("hierarchy")->panel();
        auto*     tree  = panel.findChild<QTreeView*>();
        const int all   = rowsBelow(*tree->model());
        auto*     text  = panel.findChild<QLineEdit*>();
        text->setFocus();
        QTest::keyClicks(text, "0.1");
        const int some = rowsBelow(*tree->model());
        QVERIFY(some > 0 && some < all);
        text->clear();
        QCOMPARE(rowsBelow(*tree->model()), all);
        QToolButton* hidden = switchOf(panel, QStringLiteral("\u00D7"));
        QVERIFY(hidden);
        QTest::mouseClick(hidden, Qt::LeftButton);
        QVERIFY(!desk.session.now().shownNodes[static_cast<std::size_t>(NodeVerdict::Hidden)]);
        QVERIFY(rowsBelow(*tree->model()) < all);
    }
    void aRowFramesItsBoxAndAPickedPixelSelectsItsNode()
    {
        Desk desk("hzb-octree", {1920, 1080});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3", {640, 360}));
        QVERIFY(desk.goTo(Grain::Node, -1));
        auto* tree = desk.window.dock("hierarchy")->findChild<QTreeView*>();
        tree->setCurrentIndex(tree->model()->index(0, 0));
        QVERIFY(desk.session.now().selectedNode);
        QCOMPARE(desk.session.now().selectedNode->path, std::string("0"));
        const auto selectedIn = [&] {
            const Overlay overlay = overlayOf(desk.session.now(), desk.session.now().layers);
            return std::ranges::count(overlay.boxes, OverlayBox::Kind::Selected, &OverlayBox::kind);
        };
        QCOMPARE(selectedIn(), 1);

        desk.session.pick(QPoint(320, 200));
        const auto node = nodeOfPick(desk.session.now());
        QVERIFY(node);
        QVERIFY(desk.session.now().selectedNode == node);
        const QModelIndex at = tree->currentIndex();
        QVERIFY(at.isValid());
        QVERIFY(at.data().toString().startsWith(QString::fromStdString(node->path)));
        const int id = rowOf(desk.session.now().hierarchy()->nodes, *node);
        QVERIFY(desk.session.now().hierarchy()->nodes[static_cast<std::size_t>(id)].verdict == NodeVerdict::Drawn);
        desk.press(Qt::Key_Escape);
        QVERIFY(!desk.session.now().selectedNode);
        QCOMPARE(selectedIn(), 0);
    }
    void theBoxesLieOverThePictureByVerdict()
    {
        Desk desk("hzb-octree", {1920, 1080});
        QVERIFY(desk.open("builtin:office-tower", {1280, 720}));
        QVERIFY(desk.goTo(Grain::Node, 300));
        for (auto* box : desk.window.dock("hierarchy")->findChildren<QCheckBox*>()) box->click();
        QVERIFY(desk.session.now().layers.boxes);
        const Overlay all = overlayOf(desk.session.now(), desk.session.now().layers);
        QVERIFY(all.boxesShown > 3);
        desk.photograph("hierarchy");
        VerdictSet onlyHidden{};
        onlyHidden[static_cast<std::size_t>(NodeVerdict::Hidden)] = true;
        desk.session.showNodes(onlyHidden);
        const Overlay some = overlayOf(desk.session.now(), desk.session.now().layers);
        QVERIFY(some.boxesWanted < all.boxesWanted);
        for (const OverlayBox& box : some.boxes)
            QVERIFY(box.kind != OverlayBox::Kind::Plain || box.verdict == NodeVerdict::Hidden);
    }

    void theObserverSeesTheFrustumFliesAndSelects()
    {
        Desk desk("hzb-octree", {1920, 1080});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=6", {1280, 720}));
        QVERIFY(desk.goTo(Grain::Node, -1));
        auto* dock = desk.window.dock("observer");
        dock->raise();
        desk.window.resizeDocks({dock}, {700}, Qt::Horizontal);
        desk.window.resizeDocks({dock}, {560}, Qt::Vertical);
        auto* view = dock->findChild<ObserverView*>();
        QVERIFY(isDrawn(*view));
        const QImage first = view->grab().toImage();

        const QPoint middle = view->rect().center();
        QTest::mousePress(view, Qt::LeftButton, {}, middle);
        QTest::mouseMove(view, middle + QPoint(40, 8));
        QTest::mouseRelease(view, Qt::LeftButton, {}, middle + QPoint(40, 8));
        QVERIFY(isDrawn(*view));
        QTest::qWait(50);
        QVERIFY(view->grab().toImage() != first);
        QVERIFY(!desk.session.now().selectedNode);  // a drag is not a click

        QPoint place;
        int    node = -1;
        for (int y = 0; y < view->height() && node < 0; y += 3)
            for (int x = 0; x < view->width() && node < 0; x += 3)
                if (const int at = view->nodeAt(QPointF(x, y)); at > 0) node = at, place = QPoint(x, y);
        QVERIFY(node > 0);
        QTest::mouseClick(view, Qt::LeftButton, {}, place);
        QVERIFY(desk.session.now().selectedNode);
        QVERIFY(*desk.session.now().selectedNode
                == nameOf(desk.session.now().hierarchy()->nodes[static_cast<std::size_t>(node)]));
        QVERIFY(isDrawn(*view));
        desk.session.selectNode({});
        QVERIFY(isDrawn(*view));
        desk.photograph("observer");

        // Arrow keys turn what has the focus, and do not step.
        const std::uint64_t step  = desk.session.position()->step;
        const QImage        still = view->grab().toImage();
        QSignalSpy          drawn(view, &ObserverView::drawn);
        view->setFocus();
        QTest::keyClick(view, Qt::Key_Left);
        QVERIFY(QTest::qWaitFor([&] { return drawn.count() > 0; }, Desk::kLong));
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, step);
        QVERIFY(view->grab().toImage() != still);
    }
    void aFrozenCullingViewStaysWhileTheCameraMovesOn()
    {
        Desk desk("octree-frustum", {1920, 1080});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3"));
        QVERIFY(desk.goTo(Grain::Node, -1));
        auto* dock = desk.window.dock("observer");
        dock->raise();
        auto* view = dock->findChild<ObserverView*>();
        QVERIFY(isDrawn(*view));
        dock->findChild<QCheckBox*>()->click();
        const auto before = view->observer();
        desk.session.moveCamera([](CameraControl& camera) { camera.orbit(0.4, 0); });
        QVERIFY(desk.settles());
        QVERIFY(isDrawn(*view));
        QCOMPARE(view->observer(), before);
        dock->findChild<QCheckBox*>()->click();
        QVERIFY(QTest::qWaitFor([&] { return view->isIdle() && view->observer() != before; }, Desk::kLong));
    }
};

ZSCOPE_UI_TEST(PanelsTest, "panels_test", Window)
#include "panels_test.moc"
