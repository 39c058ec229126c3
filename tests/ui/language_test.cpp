// SPDX-License-Identifier: GPL-3.0-or-later
// The language changes while the window is open: everything that is seen follows, and back.
#include <set>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>

#include "core/frame/faults.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/why/why_panel.h"
#include "ui/window/actions.h"
#include "ui/window/cheat_sheet.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

/// Words that stay as they are in every language: names in the registries and on the command line, keys, units.
bool isName(const QString& word)
{
    static const std::set<QString> kNames = [] {
        std::set<QString> names{"ZScope",  "Language", "English", "Ctrl",   "Shift",    "Alt",      "Esc",
                                "Del",     "Home",     "End",     "Enter",  "PageUp",   "PageDown", "WASD",
                                "OBJ",     "PNG",      "CSV",     "BVH",    "teapot",   "near",     "float",
                                "px",      "dx",       "Newell",  "scalar", "avx",      "sse",      "neon",
                                "builtin", "default",  "body",    "glaze",  "exponent", "apart",    "level"};
        const auto        add = [&](std::string_view words) {
            const QString text = QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
            for (const QString& name : text.split(QRegularExpression("[^A-Za-z]+"))) names.insert(name);
        };
        for (const Preset& preset : presets()) add(preset.name);
        for (const AxisEntry& axis : axes()) {
            for (const ChoiceEntry& choice : axis.choices) add(choice.word);
            add(axis.word);
        }
        for (const SceneEntry& scene : builtinScenes()) add(scene.name);
        for (const FaultEntry& fault : faults()) add(fault.word);
        names.insert("fault");
        return names;
    }();
    return kNames.contains(word);
}

/// The English in a text, if there is any.
QString englishIn(QString text)
{
    text.remove(QRegularExpression("<[^>]*>"));
    text.remove("&nbsp;");
    text.remove(QRegularExpression(QStringLiteral("“zscope[^”]*”")));  // what is typed on the command line
    for (const auto& match : QRegularExpression("[A-Za-z]{2,}").globalMatch(text))
        if (!isName(match.captured())) return text;
    return {};
}

void collect(const QMenu& menu, QStringList& texts)
{
    for (const QAction* action : menu.actions()) {
        texts << action->text();
        if (menu.toolTipsVisible() && action->toolTip() != action->text()) texts << action->toolTip();
        if (action->menu()) collect(*action->menu(), texts);
    }
}

/// All that is written or said in the window, whether a dock hides it or not.
QStringList textsOf(const MainWindow& window)
{
    QStringList texts;
    for (const QAction* action : window.menuBar()->actions()) {
        texts << action->text();
        collect(*action->menu(), texts);
    }
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (widget->isHidden() && !qobject_cast<const QDockWidget*>(widget)) continue;  // said when it is shown
        const QString own = widget->objectName();
        if (own.startsWith("qt_") || own.startsWith("Scroll")) continue;  // Qt's, who names them once
        texts << widget->toolTip() << widget->accessibleName() << widget->accessibleDescription();
        if (const auto* label = qobject_cast<const QLabel*>(widget)) texts << label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) texts << button->text();
        if (const auto* edit = qobject_cast<const QLineEdit*>(widget)) texts << edit->placeholderText();
        if (const auto* box = qobject_cast<const QComboBox*>(widget))
            for (int i = 0; i < box->count(); ++i)
                texts << box->itemText(i) << box->itemData(i, Qt::ToolTipRole).toString();
        if (const auto* view = qobject_cast<const QAbstractItemView*>(widget); view && view->model())
            for (int column = 0; column < view->model()->columnCount(); ++column)
                texts << view->model()->headerData(column, Qt::Horizontal).toString()
                      << view->model()->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
    }
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) texts << dock->windowTitle();
    texts << window.windowTitle();
    texts.removeAll(QString());
    return texts;
}

WhyPanel& whyOf(Desk& desk) { return static_cast<WhyPanel&>(desk.window.dock("why")->panel()); }

QAction* languageAction(const MainWindow& window, const QString& name)
{
    for (QAction* action : window.findChildren<QAction*>())
        if (action->text() == name) return action;
    return nullptr;
}

}  // namespace

class LanguageTest final : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QCoreApplication::processEvents(); }

    void aChoiceInTheMenuTurnsEverythingChineseAndBack()
    {
        for (const char* algorithm : {"scanline", "hzb-octree", "interval"}) {
            Desk desk(algorithm);
            QVERIFY(desk.open("builtin:teapot"));
            QVERIFY(desk.goTo(grainsOf(desk.session.now().pipeline).at(2), 20));
            desk.session.compareWith(findPreset("edge-walk")->pipeline);
            desk.session.pick(QPoint(160, 90));
            QVERIFY(desk.settles());
            desk.window.dock("why")->raise();
            QVERIFY(QTest::qWaitFor([&] { return whyOf(desk).isIdle() && whyOf(desk).answer(); }, Desk::kLong));
            const QStringList english = textsOf(desk.window);

            languageAction(desk.window, QStringLiteral("简体中文"))->trigger();
            QCoreApplication::processEvents();
            QVERIFY(desk.settles());
            QVERIFY(QTest::qWaitFor([&] { return whyOf(desk).isIdle() && whyOf(desk).answer(); }, Desk::kLong));
            const QStringList chinese = textsOf(desk.window);
            QVERIFY(chinese.size() > 300);
            QStringList left;
            for (const QString& text : chinese)
                if (const QString found = englishIn(text); !found.isEmpty()) left << found;
            left.removeDuplicates();
            QVERIFY2(left.isEmpty(), qPrintable(left.join('\n')));
            desk.photograph(QStringLiteral("chinese-%1").arg(algorithm));

            languageAction(desk.window, QStringLiteral("English"))->trigger();
            QCoreApplication::processEvents();
            QVERIFY(desk.settles());
            QVERIFY(QTest::qWaitFor([&] { return whyOf(desk).isIdle() && whyOf(desk).answer(); }, Desk::kLong));
            const QStringList back = textsOf(desk.window);
            QCOMPARE(back.size(), english.size());
            for (qsizetype i = 0; i < back.size(); ++i)
                if (!english[i].contains(QRegularExpression("[0-9]"))) QCOMPARE(back[i], english[i]);  // times differ
        }
    }
    void theLayerOverThePictureIsNamedInChinese()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        desk.window.speak(Language::Chinese);
        for (const Layer& layer : layers()) {
            desk.session.setLayer(layer);
            QVERIFY(desk.settles());
            const QString chips = desk.window.view().chips().join('\n');
            QVERIFY2(englishIn(chips).isEmpty(), qPrintable(chips));
        }
        desk.window.speak(Language::English);
    }
    void aToolHasOneNameInMenuToolbarAndCheatSheet()
    {
        Desk desk;
        desk.window.speak(Language::Chinese);
        QCoreApplication::processEvents();
        const CheatSheet sheet(*desk.window.menuBar(), &desk.window);
        QStringList      lines = sheet.findChild<QTextBrowser*>()->toPlainText().split('\n');
        for (const char* tool : {"tool.inspect", "tool.camera"}) {  // in this order at the top of the sheet
            const QString name = plainName(*desk.window.findChild<QAction*>(tool));
            QCOMPARE(desk.window.findChild<QAction*>(tool)->iconText(), name);
            QVERIFY2(lines.front().startsWith(name), qPrintable(lines.front()));
            lines.removeFirst();
        }
        desk.window.speak(Language::English);
    }
    void qtsOwnWordsFollow()
    {
        Desk       desk;
        const auto cancel = [] {
            return QDialogButtonBox(QDialogButtonBox::Cancel).button(QDialogButtonBox::Cancel)->text();
        };
        QVERIFY(cancel().contains("Cancel"));
        desk.window.speak(Language::Chinese);
        QVERIFY(cancel().contains(QStringLiteral("取消")));
        desk.window.speak(Language::English);
        QVERIFY(cancel().contains("Cancel"));
    }
    void theChoiceIsKept()
    {
        const QTemporaryDir folder;
        const QString       file = folder.filePath("settings.ini");
        {
            Settings settings(file);
            QVERIFY(settings.language() == Language::System);
            Session    session;
            MainWindow window(session, settings, QApplication::palette());
            languageAction(window, QStringLiteral("简体中文"))->trigger();
        }
        Settings settings(file);
        QVERIFY(settings.language() == Language::Chinese);
        Session    session;
        MainWindow window(session, settings, QApplication::palette());
        QVERIFY(languageAction(window, QStringLiteral("简体中文"))->isChecked());
        QVERIFY(englishIn(window.menuBar()->actions().front()->text()).isEmpty());
    }
    void anUnknownWordInTheSettingsIsTheSystems()
    {
        const QTemporaryDir folder;
        QSettings(folder.filePath("settings.ini"), QSettings::IniFormat).setValue("look/language", "klingon");
        QVERIFY(Settings(folder.filePath("settings.ini")).language() == Language::System);
    }
};

ZSCOPE_UI_TEST(LanguageTest, "language_test", Window)
#include "language_test.moc"
