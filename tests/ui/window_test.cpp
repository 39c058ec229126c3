// SPDX-License-Identifier: GPL-3.0-or-later
// The window, driven by keys and mouse as a person would, on the offscreen platform.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollBar>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>

#include "tests/ui/ui_test.h"
#include "ui/panels/registry.h"
#include "ui/session/engine.h"
#include "ui/view/frame_view.h"
#include "ui/window/dock.h"
#include "ui/window/layouts.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

constexpr int kLong = 60'000;  // ms

struct Desk {
    QTemporaryDir folder;
    Settings      settings{folder.filePath("settings.ini")};
    Session       session;
    MainWindow    window{session, settings, QApplication::palette()};

    Desk()
    {
        session.setPipeline(findPreset("scanline")->pipeline);
        window.resize(1280, 800);
        window.show();
    }
    bool settles()
    {
        return QTest::qWaitFor([&] { return session.isIdle() && session.now().busy.isEmpty(); }, kLong);
    }
    bool open(const QString& word)
    {
        window.open(word, [](const Scene&) {
            ViewRequest view;
            view.width  = 320;
            view.height = 180;
            return view;
        });
        return settles() && session.now().step;
    }
    void press(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&window, static_cast<Qt::Key>(key), modifiers);
    }
    QTableView* table() { return window.dock("active-edges")->findChild<QTableView*>(); }
};

/// The middle of a pixel of the picture in the view's own coordinates.
QPoint placeOf(const FrameView& view, const QPoint& pixel)
{
    return (view.view().toView(QPointF(pixel) + QPointF(0.5, 0.5)) / view.devicePixelRatioF()).toPoint();
}

}  // namespace

class WindowTest final : public QObject {
    Q_OBJECT

private slots:
    void rightAndLeftStepAndTheTableFollows()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.goToStep(90);
        QVERIFY(desk.settles());
        const int rows = desk.table()->model()->rowCount();
        QVERIFY(rows > 2);
        desk.press(Qt::Key_Right);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, std::uint64_t{91});
        desk.press(Qt::Key_Left);
        desk.press(Qt::Key_Left);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, std::uint64_t{89});
        desk.press(Qt::Key_Home);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, std::uint64_t{0});
        desk.press(Qt::Key_End);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step + 1, desk.session.position()->count);
    }
    void numberKeysChooseTheAlgorithmAndKeepTheCamera()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:teapot"));
        const Camera camera = desk.session.now().camera;
        for (std::size_t i = 0; i < presets().size() && i < 9; ++i) {
            desk.press(Qt::Key_1 + static_cast<int>(i));
            QVERIFY(desk.settles());
            QVERIFY(desk.session.now().pipeline == presets()[i].pipeline);
            QVERIFY(desk.session.now().camera == camera);
            const bool sweeps = drawsLineByLine(presets()[i].pipeline);
            QCOMPARE(desk.window.dock("active-edges")->isVisible(), sweeps);
        }
    }
    void keypadDigitsAreViewsAndNotAlgorithms()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        const Pipeline before = desk.session.now().pipeline;
        desk.press(Qt::Key_1, Qt::KeypadModifier);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline == before);
        QCOMPARE(desk.session.now().camera.forward.z, -1.0);
        desk.press(Qt::Key_3, Qt::KeypadModifier);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().camera.forward.x, -1.0);
        desk.press(Qt::Key_7, Qt::KeypadModifier);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().camera.forward.y, -1.0);
    }
    void theToolbarNamesAnAlgorithmThatIsNoPreset()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        const auto* box     = desk.window.findChild<QToolBar*>("tools")->findChild<QComboBox*>();
        const int   presets = box->count();
        QCOMPARE(box->currentText(), QString("scanline"));
        const auto composed = withChoice(findPreset("zbuffer-late")->pipeline, "shading-cost", "100-operations");
        QVERIFY(composed);
        Pipeline faulty = *composed;
        faulty.fault    = Fault::XTruncated;
        for (const Pipeline& pipeline : {*composed, faulty}) {
            desk.session.setPipeline(pipeline);
            QVERIFY(desk.settles());
            QCOMPARE(box->currentText(), QString::fromStdString(nameOf(pipeline)));
            QVERIFY(box->currentText().contains('+'));
            QCOMPARE(box->count(), presets + 1);
        }
        desk.press(Qt::Key_2);
        QVERIFY(desk.settles());
        QCOMPARE(box->count(), presets);
        QCOMPARE(box->currentIndex(), 1);
    }
    void theMenuMarksTheToolThatIsChosen()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        for (const Tool tool : {Tool::Camera, Tool::Inspect}) {
            desk.window.view().setTool(tool);
            auto* camera  = desk.window.findChild<QAction*>("tool.camera");
            auto* inspect = desk.window.findChild<QAction*>("tool.inspect");
            auto* menu    = qobject_cast<QMenu*>(camera->associatedObjects().front());
            QVERIFY(menu);
            menu->ensurePolished();
            const QImage picture  = menu->grab().toImage();
            const auto   isMarked = [&](QAction* action) {  // something beside the name that is not the ground
                QRect place = menu->actionGeometry(action);
                place.setWidth(26);
                const QColor ground = picture.pixelColor(place.topLeft() + QPoint(1, 1));
                int          marks  = 0;
                for (int y = place.top(); y <= place.bottom(); ++y)
                    for (int x = place.left(); x <= place.right(); ++x)
                        marks += std::abs(picture.pixelColor(x, y).lightness() - ground.lightness()) > 60;
                return marks;
            };
            QVERIFY(isMarked(tool == Tool::Camera ? camera : inspect)
                    > isMarked(tool == Tool::Camera ? inspect : camera) + 8);
        }
    }
    void itsFirstSizeIsMostOfTheScreenAndNeverMore()
    {
        QCOMPARE(firstSize({800, 600}), QSize(800, 600));
        QCOMPARE(firstSize({1366, 728}), QSize(1280, 728));
        QCOMPARE(firstSize({1900, 1000}), QSize(1710, 900));
        QCOMPARE(firstSize({3840, 2160}), QSize(1920, 1200));
    }
    void escapeClosesAListAndNothingElse()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.pick(QPoint(100, 90));
        auto* box = desk.window.findChild<QComboBox*>();
        QVERIFY(box);
        box->showPopup();
        QVERIFY(QTest::qWaitFor([] { return QApplication::activePopupWidget() != nullptr; }, 2000));
        QWidget* list = QApplication::activePopupWidget();
        QTest::keyClick(list->focusWidget() ? list->focusWidget() : list, Qt::Key_Escape);
        QVERIFY(QTest::qWaitFor([] { return QApplication::activePopupWidget() == nullptr; }, 2000));
        QVERIFY(desk.session.now().picked);
        desk.press(Qt::Key_Escape);
        QVERIFY(!desk.session.now().picked);
    }
    void theKeypadIsTheSameWithoutNumLockAndItsEnterResets()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        const Camera        camera = desk.session.now().camera;
        const std::uint64_t step   = desk.session.position()->step;
        desk.press(Qt::Key_End, Qt::KeypadModifier);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().camera.forward.z, -1.0);
        desk.press(Qt::Key_PageDown, Qt::KeypadModifier);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().camera.forward.x, -1.0);
        desk.press(Qt::Key_Home, Qt::KeypadModifier);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().camera.forward.y, -1.0);
        QCOMPARE(desk.session.position()->step, step);  // neither the first step nor the last
        desk.press(Qt::Key_Enter, Qt::KeypadModifier);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().camera == camera);
    }
    void keypadKeysOfCommandsAreTakenBeforeShortcutsAreLookedUpButNotFromFields()
    {
        // The platform under this test would find these shortcuts; X11 does not, and is asked no more.
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        const auto isTakenFrom = [](QWidget& widget, Qt::Key key, const QString& text) {
            QKeyEvent asked(QEvent::ShortcutOverride, key, Qt::KeypadModifier, text);
            asked.ignore();
            QApplication::sendEvent(&widget, &asked);
            return asked.isAccepted();
        };
        for (const Qt::Key key : {Qt::Key_1, Qt::Key_3, Qt::Key_7, Qt::Key_Enter})
            QVERIFY(isTakenFrom(desk.window, key, {}));
        QVERIFY(!isTakenFrom(desk.window, Qt::Key_2, "2"));

        const Camera camera = desk.session.now().camera;
        for (QWidget* field :
             {static_cast<QWidget*>(new QSpinBox(&desk.window)), static_cast<QWidget*>(new QLineEdit(&desk.window))}) {
            field->show();
            field->setFocus();
            QVERIFY(field->hasFocus());
            if (auto* box = qobject_cast<QSpinBox*>(field)) box->selectAll();
            QTest::keyClick(field, Qt::Key_3, Qt::KeypadModifier);
            QTest::keyClick(field, Qt::Key_7, Qt::KeypadModifier);
            const auto* line = field->findChild<QLineEdit*>();
            QCOMPARE((line ? line : qobject_cast<QLineEdit*>(field))->text(), QString("37"));
            QTest::keyClick(field, Qt::Key_Enter, Qt::KeypadModifier);
        }
        QVERIFY(desk.session.now().camera == camera);
    }
    void aClickPicksAndItsRowsLightUpAndARowHighlightsItsEdge()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.goToStep(90);
        QVERIFY(desk.settles());
        const SweepState& sweep = *desk.session.now().sweep();
        QVERIFY(!sweep.spans.empty());
        const QPoint pixel((sweep.spans[0].x0 + sweep.spans[0].x1 - 1) / 2, sweep.y);
        QTest::mouseClick(&desk.window.view(), Qt::LeftButton, {}, placeOf(desk.window.view(), pixel));
        QVERIFY(desk.session.now().picked);
        QCOMPARE(*desk.session.now().picked, pixel);
        const auto owner = pickedTriangle(desk.session.now());
        QVERIFY(owner);
        QAbstractItemModel& model = *desk.table()->model();
        int                 lit   = 0;
        for (int row = 0; row < model.rowCount(); ++row) lit += model.index(row, 1).data(Qt::BackgroundRole).isValid();
        QVERIFY(lit >= 1);

        desk.table()->setCurrentIndex(model.index(0, 1));
        QVERIFY(desk.session.now().selectedEdge);
        const Overlay overlay = overlayOf(desk.session.now(), {});
        QVERIFY(std::ranges::any_of(overlay.edges, [](const OverlayEdge& e) { return e.kind == EdgeKind::Selected; }));
        desk.press(Qt::Key_Escape);
        QVERIFY(!desk.session.now().picked);
        QVERIFY(!desk.session.now().selectedEdge);
    }
    void controlArrowsNudgeThePick()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.pick(QPoint(10, 20));
        desk.press(Qt::Key_Right, Qt::ControlModifier);
        desk.press(Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(*desk.session.now().picked, QPoint(11, 21));
    }
    void theWheelZoomsAndDraggingPansAndNeitherPicks()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        FrameView&    view   = desk.window.view();
        const QPoint  cursor = view.rect().center() + QPoint(40, 30);
        const QPointF held   = view.view().toPicture(QPointF(cursor) * view.devicePixelRatioF());
        const double  before = view.view().zoom();
        QWheelEvent   wheel(cursor, view.mapToGlobal(cursor), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                            Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &wheel);
        QVERIFY(view.view().zoom() > before);
        const QPointF now = view.view().toPicture(QPointF(cursor) * view.devicePixelRatioF());
        QVERIFY(std::abs(now.x() - held.x()) < 1e-6 && std::abs(now.y() - held.y()) < 1e-6);

        QTest::mousePress(&view, Qt::LeftButton, {}, cursor);
        QTest::mouseMove(&view, cursor + QPoint(30, 0));
        QTest::mouseMove(&view, cursor + QPoint(60, 0));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, cursor + QPoint(60, 0));
        QVERIFY(!desk.session.now().picked);
        desk.press(Qt::Key_F);
        QVERIFY(view.view().isFitted());
        desk.press(Qt::Key_0, Qt::ControlModifier);
        QCOMPARE(view.view().zoom(), 1.0);
    }
    void keysMeanOneThingPerTool()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:teapot"));
        const Camera        camera = desk.session.now().camera;
        const std::uint64_t step   = desk.session.position()->step;
        desk.press(Qt::Key_C);
        QCOMPARE(desk.window.view().tool(), Tool::Camera);
        desk.press(Qt::Key_Left);
        QVERIFY(desk.settles());
        QVERIFY(!(desk.session.now().camera == camera));
        QCOMPARE(desk.session.position()->step + 1, desk.session.position()->count);
        desk.press(Qt::Key_Return);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().camera == camera);
        desk.press(Qt::Key_I);
        desk.press(Qt::Key_Left);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, step - 1);
        QVERIFY(desk.session.now().camera == camera);
    }
    void orbitingMovesTheCameraAndFlyingGoesForward()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        FrameView& view = desk.window.view();
        desk.press(Qt::Key_C);
        const Camera before = desk.session.now().camera;
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, {}, middle);
        QTest::mouseMove(&view, middle + QPoint(50, 10));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(50, 10));
        QVERIFY(desk.settles());
        const Camera orbited = desk.session.now().camera;
        QVERIFY(!(orbited == before));
        QTest::keyPress(&view, Qt::Key_W);
        QTest::qWait(200);
        QTest::keyRelease(&view, Qt::Key_W);
        QVERIFY(desk.settles());
        QVERIFY(!(desk.session.now().camera.eye == orbited.eye));
        QVERIFY(desk.session.now().camera.forward.x == orbited.forward.x
                || std::abs(desk.session.now().camera.forward.x - orbited.forward.x) < 1e-9);
    }
    void aDroppedFileWithAChineseNameIsOpened()
    {
        Desk          desk;
        const QString path = desk.folder.filePath(QString::fromUtf8("茶壶 模型.obj"));
        QFile         file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        file.close();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&desk.window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&desk.window, &drop);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().scene);
        QCOMPARE(desk.session.now().scene->word, path);
        QCOMPARE(desk.settings.recentFiles().value(0), path);
    }
    void aFileThatCannotBeReadIsSaidAndNothingElseChanges()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        desk.window.open(desk.folder.filePath("missing.obj"));
        QVERIFY(desk.settles());
        QVERIFY(desk.window.messages().sentence().contains("missing.obj"));
        QCOMPARE(desk.session.now().scene->word, QString("builtin:cubes"));
        QCOMPARE(desk.settings.recentFiles(), QStringList());
    }
    void everythingThatCanBeSeenHasAName()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:cubes"));
        for (const PanelEntry& entry : panels()) {
            const PanelDock* dock = desk.window.dock(entry.word);
            QVERIFY(dock);
            QVERIFY(!dock->accessibleName().isEmpty());
        }
        QVERIFY(!desk.window.view().accessibleName().isEmpty());
        for (const auto* box : desk.window.findChildren<QComboBox*>()) QVERIFY(!box->accessibleName().isEmpty());
        for (const auto* button : desk.window.findChildren<QAbstractButton*>())
            if (button->isVisible() && !button->objectName().startsWith("qt_"))
                QVERIFY2(!button->text().isEmpty() || !button->accessibleName().isEmpty(),
                         qPrintable(button->objectName()));
    }
    void brokenSettingsDoNotBlockTheStart()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("settings.ini");
        QFile         file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "[window]\ngeometry=@ByteArray(nonsense)\nlayout=@Variant(\\0\\0\\xff)\n[files\nrecent=%%%\n\x01\x02");
        file.close();
        Settings settings(path);
        settings.beginStart();
        Session    session;
        MainWindow window(session, settings, QApplication::palette());
        window.show();
        QVERIFY(window.isVisible());
        QVERIFY(window.dock("timeline")->isVisible());
    }
    void aLayoutIsKeptUntilTheNextStart()
    {
        QTemporaryDir folder;
        Settings      settings(folder.filePath("settings.ini"));
        {
            Session    session;
            MainWindow window(session, settings, QApplication::palette());
            window.show();
            window.dock("scene")->setWanted(false);
            window.close();
        }
        Session    session;
        MainWindow window(session, settings, QApplication::palette());
        window.show();
        QVERIFY(!window.dock("scene")->isVisible());
        QVERIFY(window.dock("pipeline")->isVisible());
    }
    void closingWhileLoadingDrawingOrReplayingIsSafe()
    {
        for (int round = 0; round < 12; ++round) {
            Desk desk;
            desk.window.open("builtin:soccer-field?count=30&seed=1");
            if (round % 3 == 1) QTest::qWait(20 * round);
            if (round % 3 == 2) {
                QVERIFY(desk.settles());
                desk.session.goToStep(100);
                desk.press(Qt::Key_Space);  // playing
                QTest::qWait(5 * round);
            }
            desk.window.close();
        }
    }
};

ZSCOPE_UI_TEST(WindowTest, "window_test", Window)
#include "window_test.moc"
