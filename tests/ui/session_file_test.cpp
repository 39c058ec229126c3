// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions: saved, closed and opened again they are the same view; broken
// ones say where they are broken. Layouts, the start page and broken settings.
#include <QAbstractButton>
#include <QAction>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QStackedWidget>
#include <QStatusBar>

#include "core/frame/faults.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/registry.h"
#include "ui/session/session_file.h"
#include "ui/view/frame_view.h"
#include "ui/window/layouts.h"
#include "ui/window/message_bar.h"
#include "ui/window/start_page.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

QByteArray bytesOf(const QString& file)
{
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

void write(const QString& file, const QByteArray& bytes)
{
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(bytes);
}

/// A view that nobody would get by chance.
void arrange(Desk& desk)
{
    desk.session.setPipeline(findPreset("hzb-octree")->pipeline);
    desk.session.moveCamera([](CameraControl& camera) {
        const YzyAngles at = camera.angles();
        camera.setAngles({at.first + 31, at.second + 7, at.third});
    });
    QVERIFY(desk.goTo(Grain::Triangle, 1500));
    desk.session.pick(QPoint(150, 100));
    desk.session.toggleBookmark();
    desk.session.nameBookmark(0, QStringLiteral("\u58F6\u5634 \"the spout\""));
    for (const auto on : {Breakpoint::On::Line, Breakpoint::On::Pixel, Breakpoint::On::Node, Breakpoint::On::Triangle})
        if (const auto at = breakpointHere(desk.session.now(), on)) desk.session.toggleBreakpoint(*at);
    QCOMPARE(desk.session.now().marks.breakpoints.size(), std::size_t{4});
    desk.session.setLayer(*findLayer("depth"));
    desk.session.setDepthRange({.isAutomatic = false, .farthest = 0.05f, .nearest = 0.3f, .isLogarithmic = true});
    desk.session.linkBy(Link::Line);
    desk.session.setTolerance(3);
    desk.session.compareWith(findPreset("scanline")->pipeline);
    desk.session.showCompared(CompareShow::Wipe);
    desk.session.setWipe(0.25);
    Pipeline faulty = desk.session.now().pipeline;
    faulty.fault    = Fault::CornersOnly;
    faulty.fault.add(Fault::OddPadded);
    desk.session.setPipeline(faulty);
    QVERIFY(desk.settles());
}

}  // namespace

class SessionFileTest final : public QObject {
    Q_OBJECT

private slots:
    void aSessionOpenedAgainIsTheSameView()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("\u8BFE\u5802.zscope-session"));
        QImage        picture;
        SessionFile   saved;
        {
            Desk desk("zbuffer");
            QVERIFY(desk.open("builtin:teapot"));
            arrange(desk);
            desk.window.useLayout("compare");
            picture = desk.window.view().picture(true);
            saved   = *sessionFileOf(desk.session);
            QVERIFY(saved.step);
            desk.window.saveSessionTo(file);
            QVERIFY(desk.window.messages().sentence().isEmpty());
        }
        Desk again("scanline");
        again.window.openSession(file);
        QVERIFY(again.settles());
        QVERIFY(QTest::qWaitFor([&] { return again.session.now().compare.result != nullptr; }, Desk::kLong));
        QVERIFY(again.settles());
        const Snapshot& now = again.session.now();
        QCOMPARE(now.camera, saved.camera);
        QVERIFY(now.pipeline == saved.pipeline);
        QVERIFY(now.pipeline.fault == findFaults("corners-only+odd-padded"));
        QCOMPARE(again.session.position()->step, *saved.step);
        QCOMPARE(now.picked, saved.selection.picked);
        QVERIFY(now.selectedNode == saved.selection.node);
        QVERIFY(now.marks.bookmarks == saved.selection.marks.bookmarks);
        QVERIFY(now.marks.breakpoints == saved.selection.marks.breakpoints);
        QVERIFY(now.look == saved.look);
        QVERIFY(now.compare.other == saved.other);
        QCOMPARE(now.compare.wipe, 0.25);
        QCOMPARE(now.compare.tolerance, 3u);
        QVERIFY(now.compare.link == Link::Line);
        QCOMPARE(again.window.view().picture(true), picture);
        QVERIFY(!again.window.dock("scene")->isWanted());  // the layout came, too
        QVERIFY(again.window.dock("compare")->isWanted());
        // Written again it is the same file, but for the layout of another window.
        SessionFile twice = *sessionFileOf(again.session);
        QCOMPARE(sessionToJson(twice, file), sessionToJson(saved, file));
    }
    void everythingThatASessionHoldsComesBackFromItsText()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        arrange(desk);
        SessionFile session    = *sessionFileOf(desk.session);
        session.layout         = desk.window.layoutNow();
        const std::string text = sessionToJson(session, "/a/b.zscope-session");
        const auto        read = sessionFromJson(text, "/a/b.zscope-session");
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
        QCOMPARE(sessionToJson(*read, "/a/b.zscope-session"), text);
        QCOMPARE(read->layout.state, session.layout.state);
        QCOMPARE(read->layout.name, session.layout.name);
        QVERIFY(!read->layout.name.isEmpty());

        SessionFile below          = session;
        below.scene                = "/a/models/x.obj";
        const std::string relative = sessionToJson(below, "/a/b.zscope-session");
        QVERIFY(relative.find("\"models/x.obj\"") != std::string::npos);
        QCOMPARE(sessionFromJson(relative, "/elsewhere/b.zscope-session")->scene, QString("/elsewhere/models/x.obj"));
    }
    void aSessionMayHaveAByteOrderMarkAndIsRefusedInUtf16()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        const std::string good = sessionToJson(*sessionFileOf(desk.session), "x");
        QVERIFY(sessionFromJson("\xEF\xBB\xBF" + good, "x").ok());
        const QString     text = QString::fromStdString(good);
        const std::string wide(reinterpret_cast<const char*>(text.utf16()), 2 * static_cast<std::size_t>(text.size()));
        for (const std::string& bytes : {wide, "\xFF\xFE" + wide}) {
            const auto read = sessionFromJson(bytes, "x");
            QVERIFY(!read.ok());
            QCOMPARE(read.error().sentence, std::string("the text is UTF-16; save it as UTF-8 or plain ASCII"));
        }
    }
    void aBrokenSessionSaysWhereAndLeavesTheWindowAsItIs()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        const std::string good   = sessionToJson(*sessionFileOf(desk.session), "x");
        const auto        broken = [&](const char* what, const char* with) {
            std::string text = good;
            const auto  at   = text.find(what);
            return at == std::string::npos ? std::string() : text.replace(at, std::string(what).size(), with);
        };
        const std::pair<std::string, const char*> cases[] = {
            {"", ":1:"},
            {"{\"zscope-session\": 1}", ":1:"},
            {good.substr(0, good.size() / 2), ":"},
            {broken("\"zscope-session\": 1", "\"zscope-session\": 99"), ":1:"},
            {broken("\"step\": ", "\"stepp\": "), "stepp"},
            {broken("\"grain\": \"triangle\"", "\"grain\": \"interval\""), "interval"},
            {broken("\"layer\": \"shaded\"", "\"layer\": \"shady\""), "shady"},
            {broken("\"bookmarks\": []", "\"bookmarks\": [7]"), "bookmark"},
            {broken("\"breakpoints\": []", "\"breakpoints\": [{\"moon\": 1}]"), "moon"},
            {broken("\"scan\": \"half-space\"", "\"scan\": \"sweep-z-line\""), ":"},
        };
        int number = 0;
        for (const auto& [text, word] : cases) {
            ++number;
            QVERIFY2(number == 1 || !text.empty(), qPrintable(QString::number(number)));
            const QString file = desk.folder.filePath(QString("broken-%1.zscope-session").arg(number));
            write(file, QByteArray::fromStdString(text));
            desk.window.messages().hide();
            const auto before = desk.session.now().scene;
            desk.window.open(file);
            QVERIFY(desk.settles());
            QVERIFY2(desk.window.messages().isVisible(), qPrintable(file));
            QVERIFY2(desk.window.messages().sentence().contains(word)
                         && desk.window.messages().sentence().contains(".zscope-session:"),
                     qPrintable(desk.window.messages().sentence()));
            QCOMPARE(desk.session.now().scene, before);
            QVERIFY(desk.session.now().pipeline == findPreset("zbuffer")->pipeline);
        }
        desk.window.messages().hide();
        desk.window.open(desk.folder.filePath("absent.zscope-session"));
        QVERIFY(desk.window.messages().isVisible());
    }
    void brokenSettingsOpenTheDefaultWindowWithAMessage()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        write(file, "[window]\nlayoutName=compare\nthis is no setting\n");
        Settings settings(file);
        QVERIFY(settings.trouble());
        QVERIFY2(settings.trouble()->contains("settings.ini:3:"), qPrintable(*settings.trouble()));
        QVERIFY(bytesOf(file + ".broken").contains("this is no setting"));
        Session    session;
        MainWindow window(session, settings, QApplication::palette());
        window.show();
        QVERIFY(window.dock("scene")->isWanted());  // Teach
        Settings next(file);
        QVERIFY(!next.trouble());
        next.setLayoutName("profile");
        Settings::forget(file);
        QCOMPARE(Settings(file).layoutName(), QString());
        // A layout that is no layout is left out, too.
        write(file, "[window]\nlayout=nonsense\ngeometry=7\n[keys]\nstep.play=@@@\n");
        Settings   odd(file);
        Session    other;
        MainWindow second(other, odd, QApplication::palette());
        second.show();
        QCOMPARE(second.findChild<QAction*>("step.play")->shortcut(), QKeySequence(Qt::Key_Space));
    }
    void theLayoutsAreSwitchedResetSavedAndForgotten()
    {
        Desk desk("hzb-octree", {1600, 1000});
        QVERIFY(desk.open("builtin:teapot"));
        const auto wanted = [&] {
            QStringList words;
            for (auto* dock : desk.window.findChildren<PanelDock*>())
                if (dock->isWanted()) words << dock->entry().word;
            words.sort();
            return words;
        };
        const QStringList teach = wanted();
        for (const LayoutEntry& layout : layoutEntries()) {
            desk.window.findChild<QAction*>(QString("layout.") + layout.word)->trigger();
            QTest::qWait(50);
            QVERIFY(desk.window.findChild<QAction*>(QString("layout.") + layout.word)->isChecked());
            QStringList words;
            for (const LayoutPlace& place : layout.places()) words << place.panel;
            words.sort();
            QCOMPARE(wanted(), words);
            desk.photograph(QString("layout-") + layout.word);
        }
        desk.window.useLayout("teach");
        QCOMPARE(wanted(), teach);
        desk.window.dock("scene")->setWanted(false);
        const WindowLayout own = desk.window.layoutNow();
        desk.settings.keepOwnLayout("mine / \u6211", own.state, own.hidden);
        QCOMPARE(desk.settings.ownLayouts(), QStringList{"mine / \u6211"});
        desk.window.findChild<QAction*>("layout.reset")->trigger();
        QCOMPARE(wanted(), teach);
        const auto [state, hidden] = desk.settings.ownLayout("mine / \u6211");
        QVERIFY(desk.window.applyLayout({{}, state, hidden, {}}));
        QVERIFY(!desk.window.dock("scene")->isWanted());
        QVERIFY(!desk.window.applyLayout({{}, "nonsense", {}, {}}));
        desk.settings.forgetOwnLayout("mine / \u6211");
        QVERIFY(desk.settings.ownLayouts().isEmpty());
    }
    void noLayoutKeepsTheHeightsOfTheOneBefore()
    {
        Desk desk("interval", {1280, 800});
        QVERIFY(desk.open("builtin:cubes"));
        const auto timeline = [&] {
            QTest::qWait(50);
            return desk.window.dock("timeline")->height();
        };
        desk.window.useLayout("teach");
        const int before = timeline();
        for (const char* layout : {"teach", "compare"}) {
            desk.window.useLayout("profile");  // a high panel stands below
            QTest::qWait(50);
            QVERIFY(desk.window.dock("measure")->height() > 3 * before / 2);
            desk.window.useLayout(layout);
            QVERIFY2(timeline() <= 5 * before / 4, layout);
        }
    }
    void noLayoutMakesTheWindowGrow()
    {
        Desk desk("scanline");  // 1280 x 800
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.toggleBookmark();
        desk.session.toggleBreakpoint({.on = Breakpoint::On::Line, .line = 20});
        desk.session.pick(QPoint(160, 90));
        desk.session.compareWith(findPreset("interval")->pipeline);
        for (const char* algorithm : {"scanline", "hzb-octree", "zbuffer"}) {
            desk.session.setPipeline(findPreset(algorithm)->pipeline);
            QVERIFY(desk.settles());
            for (const LayoutEntry& layout : layoutEntries()) {
                desk.window.useLayout(layout.word);
                QTest::qWait(50);
                // All that can stand in the line below at once, with numbers of a large scene.
                for (auto* part : desk.window.statusBar()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
                    part->show();
                    if (auto* label = qobject_cast<QLabel*>(part); label && label->accessibleName() == "Triangles")
                        label->setText("3,516,000 of 3,516,000 triangles seen in 8,294,400 pixels");
                    else if (label && label->text().isEmpty())
                        label->setText("Drawing the picture to compare");
                }
                QTest::qWait(50);
                QVERIFY2(desk.window.height() <= 800 && desk.window.width() <= 1280,
                         qPrintable(QString("%1, %2: %3 x %4")
                                        .arg(algorithm, layout.word)
                                        .arg(desk.window.width())
                                        .arg(desk.window.height())));
            }
        }
    }
    void theStartPageOpensAnExampleByTheKeyboard()
    {
        Desk  desk("zbuffer");
        auto* page = desk.window.findChild<StartPage*>();
        QVERIFY(page->isVisible());
        QVERIFY(!desk.window.view().isVisible());
        desk.photograph("start-page");
        auto* examples = page->findChild<QListWidget*>();
        examples->setFocus();
        for (int i = 0; i < examples->count(); ++i)
            if (examples->item(i)->text().startsWith("cubes")) examples->setCurrentRow(i);
        QTest::keyClick(examples, Qt::Key_Return);
        QVERIFY(QTest::qWaitFor([&] { return desk.session.now().scene != nullptr; }, Desk::kLong));
        QVERIFY(desk.settles());
        QVERIFY(!page->isVisible());
        QVERIFY(desk.window.view().isVisible());
        QCOMPARE(desk.session.now().scene->word, QString("builtin:cubes"));
    }
    void aPickedPixelBringsWhyToTheFrontUnlessTwoAreCompared()
    {
        Desk desk("zbuffer", {1600, 1000});
        QVERIFY(desk.open("builtin:teapot"));
        auto* why = desk.window.dock("why");
        desk.window.dock("depth-test")->raise();
        QTest::qWait(50);
        QVERIFY(why->visibleRegion().isEmpty());
        desk.session.pick(QPoint(160, 90));
        QTest::qWait(50);
        QVERIFY(!why->visibleRegion().isEmpty());
        desk.session.compareWith(findPreset("scanline")->pipeline);
        desk.window.dock("compare")->raise();
        QTest::qWait(50);
        desk.session.pick(QPoint(120, 90));
        QTest::qWait(50);
        QVERIFY(why->visibleRegion().isEmpty());
        QVERIFY(desk.settles());
    }
};

ZSCOPE_UI_TEST(SessionFileTest, "session_file_test", Window)
#include "session_file_test.moc"
