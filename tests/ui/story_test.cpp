// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson's hour in one go, by mouse and keyboard only: open the bunny,
// step, pick a pixel, read why it shows what it shows, flip, wipe, take the difference, bookmark, break, answer a
// question, save a picture. What is looked at is what the session and the widgets show; nothing is asked of them but
// through keys and clicks.
#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRadioButton>
#include <QTabBar>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/timeline/step_track.h"
#include "ui/panels/why/why_panel.h"
#include "ui/session/course.h"
#include "ui/window/message_bar.h"
#include "ui/window/start_page.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

/// The bunny where it lies beside the project, else the lighthouse.
QString model()
{
    const QString bunny = QStringLiteral(ZSCOPE_SOURCE_DIR "/../shared/models/stanford-bunny.obj");
    return QFileInfo::exists(bunny) ? QFileInfo(bunny).canonicalFilePath()
                                    : QStringLiteral(ZSCOPE_SOURCE_DIR "/assets/models/lighthouse.obj");
}

Qt::Key digitOf(std::string_view preset)
{
    const auto at = std::ranges::find(presets(), preset, &Preset::name) - presets().begin();
    return static_cast<Qt::Key>(Qt::Key_1 + at);
}

QString shownText(const QWidget& widget)
{
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>())
        if (label->isVisibleTo(&widget)) texts << label->text();
    return texts.join('\n');
}

struct Person : Desk {
    using Desk::Desk;

    QWidget* focus() { return QApplication::focusWidget() ? QApplication::focusWidget() : &window; }
    void     type(const QString& text) { QTest::keyClicks(focus(), text); }
    void     hit(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(focus(), key, modifiers); }
    bool     attends()  // as after a dialog has gone
    {
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) return false;
        if (!QApplication::focusWidget()) window.setFocus();
        return true;
    }
    QPoint placeOf(const QPoint& pixel)
    {
        const FrameView& view = window.view();
        return (view.view().toView(QPointF(pixel) + QPointF(0.5, 0.5)) / view.devicePixelRatioF()).toPoint();
    }
    void click(const QPoint& pixel) { QTest::mouseClick(&window.view(), Qt::LeftButton, {}, placeOf(pixel)); }
    /// A click on the tab of a panel; true as well if it stands by itself.
    bool bringUp(const char* panel)
    {
        const QString title = window.dock(panel)->windowTitle();
        for (auto* tabs : window.findChildren<QTabBar*>())
            for (int i = 0; i < tabs->count(); ++i)
                if (tabs->isVisible() && tabs->tabText(i) == title) {
                    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(i).center());
                    return QTest::qWaitFor([&] { return !window.dock(panel)->panel().visibleRegion().isEmpty(); },
                                           2000);
                }
        return !window.dock(panel)->panel().visibleRegion().isEmpty();
    }
    /// Through the palette, as one who does not know the key.
    bool command(const QString& words)
    {
        QTimer::singleShot(200, &window, [words] {
            QWidget* field = QApplication::focusWidget();
            QVERIFY(qobject_cast<QLineEdit*>(field));
            QTest::keyClicks(field, words);
            QTest::keyClick(field, Qt::Key_Return);
        });
        hit(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::qWait(400);
        return attends();
    }
    std::uint64_t step() { return session.position()->step; }
};

/// A pixel of the line that shows a triangle; the one in the middle of them.
QPoint coveredOn(const VisibilityBuffer& visible, int line)
{
    std::vector<int> covered;
    for (int x = 0; x < visible.width(); ++x)
        if (visible.idAt(x, line) >= 0) covered.push_back(x);
    return covered.empty() ? QPoint(-1, -1) : QPoint(covered[covered.size() / 2], line);
}

}  // namespace

class StoryTest final : public QObject {
    Q_OBJECT

private slots:
    void anHourWithTheBunnyByMouseAndKeyboard()
    {
        Person        desk("zbuffer", QSize(1280, 800));
        QTemporaryDir pictures;
        desk.settings.setPictureFolder(pictures.path());
        QVERIFY(desk.attends());
        QVERIFY(desk.window.findChild<StartPage*>()->isVisible());

        // Open.
        QTimer::singleShot(300, &desk.window, [] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
            QVERIFY(name);
            QTest::keyClicks(name, model());
            QTest::keyClick(name, Qt::Key_Return);
        });
        desk.hit(Qt::Key_O, Qt::ControlModifier);
        QVERIFY(QTest::qWaitFor([&] { return desk.session.now().step != nullptr; }, Desk::kLong));
        QVERIFY(desk.settles() && desk.attends());
        QVERIFY(desk.window.view().isVisible());
        QVERIFY(desk.window.messages().sentence().isEmpty());

        // The scanline, line by line: its table follows, and back is the exact inverse.
        QVERIFY(desk.command("scanline"));
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline == findPreset("scanline")->pipeline);
        QComboBox* grain = nullptr;
        for (auto* box : desk.window.findChildren<QComboBox*>())
            if (box->accessibleName() == "Grain of a step") grain = box;
        QVERIFY(grain);
        for (int i = 0; i < grain->count() && grain->currentData().toInt() != static_cast<int>(Grain::Line); ++i)
            QTest::keyClick(grain, Qt::Key_Down);
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().grain, Grain::Line);
        auto* track = desk.window.findChild<StepTrack*>();
        QTest::mouseClick(track, Qt::LeftButton, {}, QPoint(track->width() / 2, track->height() / 2));
        QVERIFY(desk.settles());
        const auto middle = desk.step();
        QVERIFY(middle > 10 && middle + 10 < desk.session.position()->count);
        QVERIFY(desk.bringUp("active-edges"));
        auto*                    edges = desk.window.dock("active-edges")->findChild<QTableView*>();
        QAbstractItemModelTester edgeTester(edges->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        QVERIFY(edges->model()->rowCount() > 0);
        const int     line     = desk.session.now().sweep()->y;
        const QString sentence = shownText(desk.window.dock("timeline")->panel());
        const QImage  picture  = desk.window.view().picture(true);
        desk.hit(Qt::Key_Right);
        QVERIFY(desk.settles());
        QCOMPARE(desk.step(), middle + 1);
        QCOMPARE(desk.session.now().sweep()->y, line + 1);
        QVERIFY(shownText(desk.window.dock("timeline")->panel()) != sentence);
        desk.hit(Qt::Key_Left);
        QVERIFY(desk.settles());
        QCOMPARE(desk.window.view().picture(true), picture);
        QCOMPARE(shownText(desk.window.dock("timeline")->panel()), sentence);
        desk.photograph("story-step");

        // Pick, and read why.
        const QPoint aim = coveredOn(*desk.session.now().visible(), line - 3);
        QVERIFY(aim.x() >= 0);
        desk.click(aim);
        QVERIFY(desk.session.now().picked);
        // where the picture is shown smaller than it is, a hand hits a neighbour
        const QPoint pixel = *desk.session.now().picked;
        QVERIFY((pixel - aim).manhattanLength() <= 4);
        while (desk.session.now().sweep()->y > pixel.y()) {  // back to its line
            desk.hit(Qt::Key_Left);
            QVERIFY(desk.settles());
        }
        int lit = 0;
        for (int row = 0; row < edges->model()->rowCount(); ++row)
            lit += edges->model()->index(row, 1).data(Qt::BackgroundRole).isValid();
        QVERIFY(lit >= 1);  // the triangle's edges light up
        QVERIFY(desk.bringUp("why"));
        auto& why = static_cast<WhyPanel&>(desk.window.dock("why")->panel());
        QVERIFY(QTest::qWaitFor([&] { return why.isIdle() && why.answer(); }, Desk::kLong));
        QCOMPARE(why.answer()->winner, desk.session.now().frame->frame.visible.idAt(pixel.x(), pixel.y()));
        QVERIFY(shownText(why).contains(QString::fromStdString(why.answer()->sentence)));
        auto*                    candidates = why.findChild<QTreeView*>();
        QAbstractItemModelTester whyTester(candidates->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        QVERIFY(candidates->model()->rowCount() >= 2);  // front and back
        QTest::mouseClick(candidates->viewport(), Qt::LeftButton, {},
                          candidates->visualRect(candidates->model()->index(0, 0)).center());
        QVERIFY(desk.session.now().selectedTriangle);
        desk.photograph("story-why");
        desk.hit(Qt::Key_Return);  // jumps to its moment
        QVERIFY(desk.settles());
        QVERIFY(desk.attends());

        // A bookmark, and away, and back to it.
        const auto marked = desk.step();
        desk.window.view().setFocus();
        desk.hit(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(desk.session.now().marks.bookmarks.size(), std::size_t{1});
        desk.hit(Qt::Key_Home);
        QVERIFY(desk.settles());
        QCOMPARE(desk.step(), std::uint64_t{0});
        desk.hit(Qt::Key_PageDown, Qt::ControlModifier);
        QVERIFY(desk.settles());
        QCOMPARE(desk.step(), marked);

        // A breakpoint on the pixel: the run comes to it from the start.
        desk.hit(Qt::Key_Escape);
        desk.click(pixel);
        desk.hit(Qt::Key_F9);
        QCOMPARE(desk.session.now().marks.breakpoints.size(), std::size_t{1});
        QVERIFY(desk.session.now().marks.breakpoints[0].on == Breakpoint::On::Pixel);
        desk.hit(Qt::Key_Home);
        QVERIFY(desk.settles());
        desk.hit(Qt::Key_F5);
        QVERIFY(QTest::qWaitFor([&] { return desk.settles() && desk.step() > 0; }, Desk::kLong));
        QCOMPARE(desk.session.now().sweep()->y, pixel.y());
        desk.hit(Qt::Key_F9);  // and gone

        // Against another algorithm: to and fro, the wipe by its handle, the difference.
        desk.hit(Qt::Key_End);
        QVERIFY(desk.settles());
        desk.hit(digitOf("zbuffer"), Qt::ShiftModifier);
        QVERIFY(QTest::qWaitFor([&] { return desk.settles() && desk.session.now().compare.result; }, Desk::kLong));
        desk.hit(Qt::Key_T);
        QVERIFY(desk.session.now().compare.seen() == CompareShow::B);
        desk.hit(Qt::Key_T);
        QVERIFY(desk.session.now().compare.seen() == CompareShow::A);
        desk.hit(Qt::Key_W);
        QVERIFY(desk.session.now().compare.seen() == CompareShow::Wipe);
        const QRectF whole =
            desk.window.view().view().toView(QRectF(QPointF(0, 0), QSizeF(desk.window.view().picture(false).size())));
        const auto at = [&](double part) {
            return QPoint(
                static_cast<int>((whole.left() + whole.width() * part) / desk.window.view().devicePixelRatioF()),
                desk.window.view().height() / 2);
        };
        QTest::mousePress(&desk.window.view(), Qt::LeftButton, {}, at(0.5));
        QTest::mouseMove(&desk.window.view(), at(0.4));
        QTest::mouseMove(&desk.window.view(), at(0.3));
        QTest::mouseRelease(&desk.window.view(), Qt::LeftButton, {}, at(0.3));
        QVERIFY(std::abs(desk.session.now().compare.wipe - 0.3) < 0.02);
        desk.photograph("story-wipe");
        desk.hit(Qt::Key_D);
        QVERIFY(desk.session.now().compare.seen() == CompareShow::Difference);
        QCOMPARE(desk.session.now().compare.result->difference.differing(), std::uint64_t{0});  // two exact ones

        // The palette ends the comparison.
        QVERIFY(desk.command("end the comparison"));
        QVERIFY(!desk.session.now().compare.other);

        // A picture, named by the template.
        desk.hit(Qt::Key_F12);
        const QString stem = QFileInfo(model()).completeBaseName();
        QVERIFY2(QFile::exists(pictures.filePath(stem + "_scanline_1.png")),
                 qPrintable(QDir(pictures.path()).entryList().join(' ')));

        // The first lesson, its first question.
        desk.hit(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(QTest::qWaitFor([] { return qobject_cast<QListWidget*>(QApplication::focusWidget()); }, 2000));
        desk.hit(Qt::Key_Home);
        desk.hit(Qt::Key_Return);
        Course& course = desk.session.course();
        QVERIFY(course.lesson());
        QVERIFY(QTest::qWaitFor([&] { return course.isReady() && course.isSettled() && desk.session.isIdle(); },
                                Desk::kLong));
        QVERIFY(QTest::qWaitFor([] { return QApplication::focusWidget(); }, 2000));
        QVERIFY(course.page()->question && !course.given());
        const bool isChoice = course.right()->choice.has_value();
        for (int i = 0; i < 80
                        && !(isChoice ? qobject_cast<QRadioButton*>(desk.focus()) != nullptr
                                      : qobject_cast<QLineEdit*>(desk.focus()) != nullptr);
             ++i)
            desk.hit(Qt::Key_Tab);
        if (isChoice) {
            desk.hit(Qt::Key_Space);
            for (std::size_t i = 0; i < *course.right()->choice; ++i) desk.hit(Qt::Key_Down);
        } else {
            QVERIFY(course.right()->number);
            desk.type(QString::number(*course.right()->number));
        }
        desk.hit(Qt::Key_Return);
        QVERIFY(course.given() && course.given()->isRight);
        desk.photograph("story-lesson");
    }
};

ZSCOPE_UI_TEST(StoryTest, "story_test", Window)
#include "story_test.moc"
