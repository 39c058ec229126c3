// SPDX-License-Identifier: GPL-3.0-or-later
// Commands: each has a name, the palette finds and runs it, the cheat sheet
// tells its keys, and the keys can be changed.
#include <set>

#include <QAbstractItemModelTester>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QPushButton>
#include <QTableView>
#include <QTextBrowser>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/window/actions.h"
#include "ui/window/command_palette.h"
#include "ui/window/fuzzy.h"
#include "ui/window/keys_dialog.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

template <class Kind>
Kind* opened(Desk& desk)
{
    Kind* found = nullptr;
    (void)QTest::qWaitFor([&] { return (found = desk.window.findChild<Kind*>()) != nullptr && found->isVisible(); },
                          2000);
    return found;
}

bool isGone(Desk& desk, const QString& name)
{
    return QTest::qWaitFor([&] { return desk.window.findChild<QWidget*>(name) == nullptr; }, 2000);
}

/// Types a few letters into the palette and runs the first that is found.
bool run(Desk& desk, const QString& letters)
{
    desk.window.activateWindow();  // there is no window manager to do it
    if (!QTest::qWaitForWindowActive(&desk.window)) return false;
    desk.press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    auto* palette = opened<CommandPalette>(desk);
    if (!palette) return false;
    auto* query = palette->findChild<QLineEdit*>();
    QTest::keyClicks(query, letters);
    QTest::keyClick(query, Qt::Key_Return);
    if (!isGone(desk, "commandPalette")) return false;
    QTest::qWait(20);  // it is run once the palette has gone
    return true;
}

}  // namespace

class CommandsTest final : public QObject {
    Q_OBJECT

private slots:
    void lettersMatchInOrderAndWordBeginningsComeFirst()
    {
        QVERIFY(fuzzyScore("", "anything"));
        QVERIFY(fuzzyScore("fsb", "First step that changes the picked pixel, backwards"));
        QVERIFY(!fuzzyScore("xyz", "zyx"));
        QVERIFY(!fuzzyScore("abc", "ab"));
        QVERIFY(*fuzzyScore("go px", "Go to pixel") > *fuzzyScore("go px", "ego wraps xenon"));
        QVERIFY(*fuzzyScore("fit", "Fit") > *fuzzyScore("fit", "Fit the range of depths"));
        QVERIFY(*fuzzyScore("wipe", "Wipe") > *fuzzyScore("wipe", "weird ink paper edge"));
    }
    void everyActionOfTheMenusHasANameOfItsOwn()
    {
        Desk                      desk;
        std::set<QString>         names;
        std::vector<const QMenu*> open;
        for (const QAction* entry : desk.window.menuBar()->actions()) open.push_back(entry->menu());
        int count = 0;
        while (!open.empty()) {
            const QMenu* menu = open.back();
            open.pop_back();
            for (const QAction* action : menu->actions()) {
                if (action->menu()) open.push_back(action->menu());
                if (action->menu() || action->isSeparator()) continue;
                ++count;
                QVERIFY2(!action->objectName().isEmpty(), qPrintable(action->text()));
                QVERIFY2(names.insert(action->objectName()).second, qPrintable(action->objectName()));
            }
        }
        QVERIFY(count > 120);
    }
    void noTwoCommandsOfOneToolShareAKey()
    {
        Desk  desk;
        auto& bindings = desk.window.findChild<Actions*>()->bindings();
        for (const QAction* action : bindings.commands())
            for (const QKeySequence& key : action->shortcuts())
                QVERIFY2(bindings.conflictsOf(*action, key).empty(),
                         qPrintable(action->objectName() + " " + key.toString()));
    }
    void thePaletteFindsAndRunsACommandByTheKeyboardAlone()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(run(desk, "firststep"));
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.position()->step, std::uint64_t{0});
        QVERIFY(run(desk, "algorithm.a.zbuffer"));
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline == findPreset("zbuffer")->pipeline);

        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        auto* palette = opened<CommandPalette>(desk);
        QVERIFY(palette);
        auto*                    query = palette->findChild<QLineEdit*>();
        auto*                    list  = palette->findChild<QListView*>();
        QAbstractItemModelTester tester(list->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        QTest::keyClicks(query, "pixel");
        QVERIFY(list->model()->rowCount() >= 5);
        QTest::keyClick(query, Qt::Key_Down);
        QTest::keyClick(query, Qt::Key_Down);
        QCOMPARE(list->currentIndex().row(), 2);
        if (const QString where = qEnvironmentVariable("ZSCOPE_PICTURES"); !where.isEmpty())
            palette->grab().save(where + "/palette.png");
        QTest::keyClicks(query, "qqqq");
        QCOMPARE(list->model()->rowCount(), 0);
        QTest::keyClick(query, Qt::Key_Return);  // nothing to run
        QVERIFY(palette->isVisible());
        QTest::keyClick(query, Qt::Key_Escape);
        QVERIFY(isGone(desk, "commandPalette"));
    }
    void listsOfCommandsHaveNoEmptyRows()
    {
        Desk  desk;  // no recent file, but a place for each
        auto& bindings = desk.window.findChild<Actions*>()->bindings();
        for (const QString& file : {QString(), desk.folder.filePath("mine.obj")}) {
            if (!file.isEmpty()) desk.window.findChild<Actions*>()->showRecent({file});
            CommandModel palette(bindings.commands());
            KeysModel    keys(bindings);
            QVERIFY(palette.rowCount() > 120);
            QCOMPARE(keys.rowCount(), palette.rowCount());
            int mine = 0;
            for (int row = 0; row < palette.rowCount(); ++row) {
                QVERIFY(!palette.index(row).data().toString().isEmpty());
                QVERIFY(!keys.index(row, KeysModel::Command).data().toString().isEmpty());
                QCOMPARE(keys.index(row, KeysModel::Command).data(), QVariant(plainName(*keys.at(row))));
                mine += keys.at(row)->text() == "mine.obj";
            }
            QCOMPARE(mine, file.isEmpty() ? 0 : 1);
        }
    }
    void thePaletteTellsTheMenuBesideTheName()
    {
        Desk         desk;
        CommandModel palette(desk.window.findChild<Actions*>()->bindings().commands());
        const auto   heardOf = [&](const QString& name) {
            for (int row = 0; row < palette.rowCount(); ++row)
                if (palette.at(row)->objectName() == name)
                    return palette.index(row).data(Qt::AccessibleTextRole).toString();
            return QString();
        };
        QCOMPARE(heardOf("measure.open").trimmed(), QString("Open a record… Measure"));
        QVERIFY(heardOf("file.open").startsWith("Open… File "));
        QCOMPARE(heardOf("measure.stop"), QString("Stop measuring Measure, not possible now"));
        QVERIFY(heardOf("algorithm.a.zbuffer").contains("Algorithm"));
    }
    void aChangedKeyWorksIsToldIsKeptAndCanBePutBack()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        {
            Settings   settings(file);
            Session    session;
            MainWindow window(session, settings, QApplication::palette());
            auto&      bindings = window.findChild<Actions*>()->bindings();
            auto*      dialog   = new KeysDialog(bindings, &window);
            dialog->show();
            auto*                    table = dialog->findChild<QTableView*>();
            QAbstractItemModelTester tester(dialog->findChild<KeysModel*>(),
                                            QAbstractItemModelTester::FailureReportingMode::QtTest);
            dialog->findChild<QLineEdit*>()->setText("Play or pause");
            QVERIFY(table->model()->rowCount() == 1);
            auto* keys = dialog->findChild<QKeySequenceEdit*>();
            keys->setKeySequence(QKeySequence("W"));
            QString conflict;
            for (auto* label : dialog->findChildren<QLabel*>()) conflict += label->text();
            QVERIFY2(conflict.contains("Wipe"), qPrintable(conflict));
            if (const QString where = qEnvironmentVariable("ZSCOPE_PICTURES"); !where.isEmpty())
                dialog->grab().save(where + "/keys.png");
            for (auto* button : dialog->findChildren<QPushButton*>())
                if (button->text() == "Assign") QTest::mouseClick(button, Qt::LeftButton);
            QCOMPARE(window.findChild<QAction*>("step.play")->shortcut(), QKeySequence("W"));
            QVERIFY(window.findChild<QAction*>("compare.wipe")->shortcuts().isEmpty());
        }
        Settings   settings(file);  // the next start
        Session    session;
        MainWindow window(session, settings, QApplication::palette());
        QCOMPARE(window.findChild<QAction*>("step.play")->shortcut(), QKeySequence("W"));
        QVERIFY(window.findChild<QAction*>("compare.wipe")->shortcuts().isEmpty());
        window.show();
        window.findChild<QAction*>("help.keys")->trigger();
        QDialog* sheet = nullptr;
        QVERIFY(QTest::qWaitFor([&] { return (sheet = window.findChild<QDialog*>("cheatSheet")) != nullptr; }, 2000));
        const auto text = [&] { return sheet->findChild<QTextBrowser*>()->toPlainText(); };
        QVERIFY(text().contains(QRegularExpression("W\\s+Play or pause")));
        if (const QString where = qEnvironmentVariable("ZSCOPE_PICTURES"); !where.isEmpty())
            sheet->grab().save(where + "/cheat-sheet.png");
        window.findChild<Actions*>()->bindings().resetAll();
        QVERIFY(QTest::qWaitFor([&] { return text().contains(QRegularExpression("Space\\s+Play or pause")); }, 2000));
        QCOMPARE(window.findChild<QAction*>("compare.wipe")->shortcut(), QKeySequence("W"));
        QVERIFY(!Settings(file).keysOf("step.play"));
    }
};

ZSCOPE_UI_TEST(CommandsTest, "commands_test", Window)
#include "commands_test.moc"
