// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons in the window: read, answered and turned by keys alone; a teacher's folder; answers that are told at once.
#include <QAction>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTimer>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/lessons/lessons_panel.h"
#include "ui/session/course.h"
#include "ui/window/message_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

bool arrives(Desk& desk)
{
    return QTest::qWaitFor(
        [&] { return desk.session.course().isReady() && desk.session.course().isSettled() && desk.session.isIdle(); },
        Desk::kLong);
}

void key(int key, Qt::KeyboardModifiers modifiers = {})
{
    QWidget* focus = QApplication::focusWidget();
    QVERIFY(focus);
    QTest::keyClick(focus, static_cast<Qt::Key>(key), modifiers);
    QCoreApplication::processEvents();
}

/// Presses Tab until a widget of this kind has the focus.
template <class Kind>
bool tabTo()
{
    for (int i = 0; i < 80; ++i) {
        if (qobject_cast<Kind*>(QApplication::focusWidget())) return true;
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    return false;
}

void write(const QString& path, const QByteArray& text)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

QByteArray lessonText(const QByteArray& title, const QByteArray& line)
{
    return "=== lesson\n{\"title\": \"" + title + "\"}\n=== page\n{\"scene\": \"builtin:cube\", \"algorithm\": \"scanline\", \"size\": [64, 36],\n"
           "\"stop\": {\"grain\": \"line\", \"line\": " + line + "}}\n=== en\nLook at line " + line +
           ".\n=== question\n{\"kind\": \"number\", \"fact\": \"line\", \"ask\": \"Which line?\", \"why\": \"It says so.\"}\n";
}

QString shownText(const QWidget& panel)
{
    QStringList texts;
    for (const QLabel* label : panel.findChildren<QLabel*>())
        if (label->isVisibleTo(&panel)) texts << label->text();
    return texts.join('\n');
}

}  // namespace

class LessonsTest final : public QObject {
    Q_OBJECT

private slots:
    void everyPanelThatAPageMayRaiseIsThere()
    {
        Desk desk("zbuffer");
        for (const std::string_view word : kLessonPanels)
            QVERIFY2(desk.window.dock(QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()))),
                     word.data());
    }
    void aWholeLessonIsDoneByKeysAlone()
    {
        Desk desk("zbuffer");
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.window.setFocus();
        Course& course = desk.session.course();
        QVERIFY(course.lessons().size() >= 15);
        desk.press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(QTest::qWaitFor([] { return qobject_cast<QListWidget*>(QApplication::focusWidget()); }, 2000));
        desk.photograph("lessons-list");
        key(Qt::Key_Down);
        key(Qt::Key_Up);
        key(Qt::Key_Return);
        QVERIFY(course.lesson());
        QCOMPARE(course.lessonNumber(), std::size_t{0});
        bool kinds[3] = {};
        for (std::size_t page = 0; page < course.lesson()->pages.size(); ++page) {
            QCOMPARE(course.pageNumber(), page);
            QVERIFY(arrives(desk));
            QVERIFY(QTest::qWaitFor([] { return QApplication::focusWidget(); }, 2000));
            QVERIFY(course.page()->question);
            const LessonQuestion& question         = *course.page()->question;
            kinds[static_cast<int>(question.kind)] = true;
            QVERIFY(!course.given());
            if (question.kind == LessonQuestion::Kind::Number) {
                QVERIFY(tabTo<QLineEdit>());
                QTest::keyClicks(QApplication::focusWidget(), QString::number(*course.right()->number));
                key(Qt::Key_Return);
            } else if (question.kind == LessonQuestion::Kind::Choice) {
                QVERIFY(tabTo<QRadioButton>());
                key(Qt::Key_Space);
                for (std::size_t i = 0; i < *course.right()->choice; ++i) key(Qt::Key_Down);
                key(Qt::Key_Return);
            } else {
                const auto& pixels = course.right()->pixels;
                QPoint      target(-1, -1);
                for (int y = 0; y < pixels.height(); ++y)
                    for (int x = 0; x < pixels.width(); ++x)
                        if (pixels.at(x, y) != 0 && target.x() < 0) target = {x, y};
                QTimer::singleShot(200, &desk.window, [target] {
                    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
                    QVERIFY(dialog);
                    const auto boxes = dialog->findChildren<QSpinBox*>();
                    boxes[0]->selectAll();
                    QTest::keyClicks(boxes[0], QString::number(target.x() + 1));
                    boxes[1]->selectAll();
                    QTest::keyClicks(boxes[1], QString::number(target.y()));
                    QTest::keyClick(dialog, Qt::Key_Return);
                });
                desk.press(Qt::Key_G, Qt::ControlModifier);
                desk.window.activateWindow();  // as a window manager does when the dialog has gone
                QVERIFY(QTest::qWaitForWindowActive(&desk.window));
                if (!QApplication::focusWidget()) desk.window.setFocus();
                desk.press(Qt::Key_Left, Qt::ControlModifier);  // one to the left of it
                QVERIFY(desk.session.now().picked == target);
                QVERIFY(tabTo<QPushButton>());
                auto* check = qobject_cast<QPushButton*>(QApplication::focusWidget());
                for (int i = 0; i < 80 && check->text() != "Check"; ++i) {
                    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
                    if (auto* button = qobject_cast<QPushButton*>(QApplication::focusWidget())) check = button;
                }
                QCOMPARE(check->text(), QString("Check"));
                key(Qt::Key_Space);
            }
            QVERIFY(course.given());
            QVERIFY(course.given()->isRight);
            if (page == 1) desk.photograph("lesson");
            if (page + 1 < course.lesson()->pages.size())
                desk.press(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
        }
        QVERIFY(kinds[0] && kinds[1] && kinds[2]);
        QCOMPARE(course.scoreOf(0).right, course.scoreOf(0).questions);
        desk.press(Qt::Key_PageUp, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(course.pageNumber(), course.lesson()->pages.size() - 2);
        QVERIFY(course.given());  // what was answered is still there
        desk.press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(!course.lesson());
        QVERIFY(desk.window.dock("lessons")->findChild<QListWidget*>()->item(0)->text().contains("right"));
    }
    void aPageStopsAtItsStepWithItsPickItsPanelAndItsAlgorithm()
    {
        Desk       desk("zbuffer");
        Course&    course = desk.session.course();
        const auto lesson = course.find("06-two-polygons-that-cross");
        QVERIFY(lesson);
        course.open(*lesson, 1);
        QVERIFY(arrives(desk));
        const Snapshot& now = desk.session.now();
        QCOMPARE(nameOf(now.pipeline), std::string("interval"));
        QVERIFY(now.step && now.step->state.interval);
        QVERIFY(now.step->state.interval->reason == IntervalReason::NoClearLead);
        QCOMPARE(now.camera.width, 320);
        QVERIFY(QTest::qWaitFor([&] { return desk.window.dock("active-edges")->isVisible(); }, 2000));
        course.open(*lesson, 0);
        QVERIFY(arrives(desk));
        QVERIFY(now.picked == QPoint(80, 90));
        course.next();
        course.next();  // faster than it can be shown: the newest wins
        QVERIFY(arrives(desk));
        QCOMPARE(course.pageNumber(), std::size_t{2});
        QVERIFY(now.pipeline.fault == Fault::OneTestPerInterval);
        QVERIFY(now.compare.other);
        desk.session.goToStart();
        desk.session.setPipeline(findPreset("zbuffer")->pipeline);
        QVERIFY(desk.settles());
        desk.press(Qt::Key_Backspace, Qt::ControlModifier);  // back to the page
        QVERIFY(arrives(desk));
        QVERIFY(now.pipeline.fault == Fault::OneTestPerInterval);
    }
    void aWrongAnswerIsToldAtOnceWithTheRightOneAndWhy()
    {
        Desk    desk("zbuffer", {1280, 800});
        Course& course = desk.session.course();
        course.open(*course.find("02-the-edge-table"));
        QVERIFY(arrives(desk));
        QWidget& panel = desk.window.dock("lessons")->panel();
        QVERIFY(!shownText(panel).contains("right.", Qt::CaseInsensitive));
        auto* field = panel.findChild<QLineEdit*>();
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        field->setFocus();
        QVERIFY(field->hasFocus());
        QTest::keyClicks(field, "12");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(course.given() && !course.given()->isRight);
        QVERIFY(shownText(panel).contains(QString::fromUtf8("✘")));
        QVERIFY(shownText(panel).contains("36"));
        QVERIFY(shownText(panel).contains("Three edges per triangle"));
        field->setFocus();
        field->clear();
        QTest::keyClicks(field, "36");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(course.given()->isRight);
        QVERIFY(shownText(panel).contains(QString::fromUtf8("✔")));
        QCOMPARE(course.scoreOf(course.lessonNumber()).right, 0);  // the first answer counts
        desk.photograph("lesson-answered");
    }
    void aNumberThatIsWrongOrNoneIsAnsweredAnewWithoutAnotherClick()
    {
        Desk    desk("zbuffer", {1280, 800});
        Course& course = desk.session.course();
        course.open(*course.find("02-the-edge-table"));
        QVERIFY(arrives(desk));
        QWidget& panel = desk.window.dock("lessons")->panel();
        auto*    field = panel.findChild<QLineEdit*>();
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        field->setFocus();
        QTest::keyClicks(field, "abc");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!course.given());
        QVERIFY(shownText(panel).contains("abc"));
        field->clear();
        QTest::keyClicks(field, "12");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(course.given() && !course.given()->isRight);
        QVERIFY(field->hasFocus());
        const Pipeline before = desk.session.now().pipeline;
        QTest::keyClicks(QApplication::focusWidget(), "36");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QVERIFY(course.given()->isRight);
        QVERIFY(desk.session.now().pipeline == before);
    }
    void anotherSceneLeavesTheLessonAndItsPictureSize()
    {
        Desk desk("zbuffer", {1280, 800});
        QVERIFY(desk.open("builtin:cubes", {640, 360}));
        Course& course = desk.session.course();
        course.open(*course.find("03-the-active-edge-table"));
        QVERIFY(arrives(desk));
        QVERIFY(desk.session.now().camera.width != 640);
        desk.window.open("builtin:teapot");
        QVERIFY(desk.settles());
        QVERIFY(QTest::qWaitFor(
            [&] { return desk.session.now().frame && desk.session.now().frame->camera.width == 640; }, Desk::kLong));
        QVERIFY(!course.page());
    }
    void theKeysStepWhileAPageIsReadAndOnceItsQuestionIsAnswered()
    {
        Desk    desk("zbuffer", {1280, 800});
        Course& course = desk.session.course();
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        for (const std::size_t number : {0, 2}) {  // a question for a number, and one with choices
            course.open(*course.find("02-the-edge-table"), number);
            QVERIFY(arrives(desk));
            auto* page = desk.window.dock("lessons")->panel().findChild<QScrollArea*>();
            QVERIFY(QTest::qWaitFor([&] { return page->hasFocus(); }, 2000));
            const auto steps = [&](Qt::Key pressed, int by) {
                const std::uint64_t before = desk.session.position()->step;
                key(pressed);
                return desk.settles() && desk.session.position()->step == before + static_cast<std::uint64_t>(by);
            };
            QVERIFY(steps(Qt::Key_Right, 1));
            QVERIFY(steps(Qt::Key_Left, -1));
            if (course.page()->question->kind == LessonQuestion::Kind::Number) {
                page->findChild<QLineEdit*>()->setFocus();
                QTest::keyClicks(QApplication::focusWidget(), "12");
            } else {
                page->findChild<QRadioButton*>()->setFocus();
                key(Qt::Key_Space);
            }
            key(Qt::Key_Return);
            QVERIFY(course.given());
            // which was wrong: the field is ready for another
            if (course.page()->question->kind == LessonQuestion::Kind::Number) {
                QVERIFY(page->findChild<QLineEdit*>()->hasFocus());
                QVERIFY(page->findChild<QLineEdit*>()->text().isEmpty());
            } else {
                QVERIFY(page->hasFocus());
            }
            QVERIFY(steps(Qt::Key_Right, 1));
            QVERIFY(steps(Qt::Key_Left, -1));
        }
    }
    void everyPageOfTheProgramNamesPanelsThatThereAre()
    {
        Desk desk;
        for (const Lesson& lesson : desk.session.course().lessons())
            for (const LessonPage& page : lesson.pages)
                QVERIFY2(page.panel.empty() || desk.window.dock(QString::fromStdString(page.panel)),
                         lesson.file.c_str());
    }
    void aTeachersFileAppearsWhenItIsSavedAndABrokenOneTellsWhere()
    {
        QTemporaryDir teacher;
        Desk          desk;
        Course&       course  = desk.session.course();
        const auto    bundled = course.lessons().size();
        desk.window.openLessons(teacher.path());
        QCOMPARE(course.lessons().size(), bundled);
        write(teacher.filePath("01-mine.md"), lessonText("Mine", "9"));
        QVERIFY(QTest::qWaitFor([&] { return course.lessons().size() == bundled + 1; }, Desk::kLong));
        QCOMPARE(course.lessons().back().title.english, std::string("Mine"));
        course.open(bundled);
        QVERIFY(arrives(desk));
        QCOMPARE(desk.session.now().sweep()->y, 9);

        write(teacher.filePath("02-broken.md"),
              "=== lesson\n{\"title\": \"Broken\"}\n=== page\n{\"scene\": \"builtin:cube\",\n\"algorithm\": "
              "\"zbufer\"}\n");
        QVERIFY(QTest::qWaitFor([&] { return !course.troubles().isEmpty(); }, Desk::kLong));
        QVERIFY(course.troubles().front().contains("02-broken.md:5: "));
        QCOMPARE(course.lessons().size(), bundled + 1);

        write(teacher.filePath("01-mine.md"), lessonText("Mine", "12"));  // the page on show follows its file
        QVERIFY(QTest::qWaitFor(
            [&] {
                return course.isReady() && desk.session.isIdle() && desk.session.now().sweep()
                       && desk.session.now().sweep()->y == 12;
            },
            Desk::kLong));

        // and comes back when what broke it is mended
        write(teacher.filePath("01-mine.md"), "=== lesson\n{\"title\": \n");
        QVERIFY(QTest::qWaitFor([&] { return course.troubles().size() == 2; }, Desk::kLong));
        QVERIFY(!course.lesson());
        write(teacher.filePath("01-mine.md"), lessonText("Mine", "10"));
        QVERIFY(QTest::qWaitFor(
            [&] {
                return course.isReady() && desk.session.isIdle() && desk.session.now().sweep()
                       && desk.session.now().sweep()->y == 10;
            },
            Desk::kLong));

        course.close();
        QVERIFY(shownText(desk.window.dock("lessons")->panel()).contains("02-broken.md:5: "));
        QCOMPARE(desk.settings.lessonFolder(), teacher.path());
        QVERIFY(QFile::remove(teacher.filePath("02-broken.md")));
        QVERIFY(QTest::qWaitFor([&] { return course.troubles().isEmpty(); }, Desk::kLong));
    }
    void aStopThatNeverComesIsToldWithFileAndLine()
    {
        QTemporaryDir teacher;
        Desk          desk;
        write(teacher.filePath("x.md"), lessonText("X", "40"));
        desk.window.openLessons(teacher.path());
        desk.session.course().open(*desk.session.course().find("x"));
        QVERIFY(QTest::qWaitFor(
            [&] { return desk.session.course().isSettled() && !desk.window.messages().sentence().isEmpty(); },
            Desk::kLong));
        QVERIFY2(desk.window.messages().sentence().contains("x.md:5: "), qPrintable(desk.window.messages().sentence()));
        QVERIFY(!desk.session.course().isReady());
    }
    void theFolderIsRememberedAndAMissingOneDoesNoHarm()
    {
        const QTemporaryDir folder, teacher;
        write(teacher.filePath("x.md"), lessonText("X", "9"));
        Settings settings(folder.filePath("settings.ini"));
        settings.setLessonFolder(teacher.path());
        {
            Session    session;
            MainWindow window(session, settings, QApplication::palette());
            QVERIFY(session.course().find("x"));
        }
        settings.setLessonFolder("/nowhere/at/all");
        Session    session;
        MainWindow window(session, settings, QApplication::palette());
        QVERIFY(session.course().lessons().size() >= 15);
    }
    void theStartPageBeginsWithTheFirstLesson()
    {
        Desk desk;
        for (auto* button : desk.window.findChildren<QPushButton*>())
            if (button->text() == "Begin with lesson 1") QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(desk.session.course().lesson());
        QCOMPARE(desk.session.course().lessonNumber(), std::size_t{0});
        QVERIFY(arrives(desk));
    }
    void itsKeysAreNobodyElses()
    {
        Desk       desk;
        int        keys    = 0;
        const auto actions = desk.window.findChildren<QAction*>();
        for (const QAction* own : actions) {
            if (!own->objectName().startsWith("lessons.")) continue;
            for (const QKeySequence& key : own->shortcuts()) {
                ++keys;
                for (const QAction* other : actions)
                    QVERIFY2(other == own || !other->shortcuts().contains(key), qPrintable(other->objectName()));
            }
        }
        QCOMPARE(keys, 5);
    }
    void inChineseALessonIsChinese()
    {
        Desk desk;
        desk.window.speak(Language::Chinese);
        Course& course = desk.session.course();
        course.open(0);
        QVERIFY(arrives(desk));
        QWidget& panel = desk.window.dock("lessons")->panel();
        QVERIFY(shownText(panel).contains(QString::fromUtf8("谁遮住谁")));
        QVERIFY(!shownText(panel).contains("hides"));
        desk.photograph("lesson-chinese");
        desk.window.speak(Language::English);
        QCoreApplication::processEvents();
        QVERIFY(shownText(panel).contains("What hides what"));
    }
};

ZSCOPE_UI_TEST(LessonsTest, "lessons_test", Window)
#include "lessons_test.moc"
