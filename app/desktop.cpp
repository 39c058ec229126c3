// SPDX-License-Identifier: GPL-3.0-or-later
// zscope: the window. The command line is read before Qt starts, so that --help and mistakes need no display.
//
// Exit       0 closed by the user; 2 the command line is wrong; 4 there is no display to open a window on
#include <cstdio>
#include <cstdlib>
#include <string>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QStyleFactory>
#include <QTimer>

#include "app/cli/options.h"
#include "ui/report/report.h"
#include "ui/session/course.h"
#include "ui/view/frame_view.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace {

using zscope::cli::Exit;

struct Options {
    std::string                  scene;  // empty: the start page
    std::string                  session;
    bool                         resetSettings = false;
    std::string                  settings;        // a file; empty: the user's own
    std::string                  screenshot;      // a file; empty: none
    std::string                  report, folder;  // a record, and where its report goes
    std::string                  grain;
    std::string                  language;
    std::string                  lessons;  // a folder; empty: the one of the settings
    std::string                  lesson;   // a name or a number of the list
    std::size_t                  page = 1;
    std::optional<std::uint64_t> step;
    zscope::cli::ViewOptions     view;
    zscope::cli::HowOptions      how;
};

void declare(CLI::App& parser, Options& options)
{
    parser.set_version_flag("--version", "ZScope " ZSCOPE_VERSION);
    parser
        .add_option("SCENE", options.scene,
                    "An .obj file, a scene .json file, a .zscope-session file, or builtin:NAME[?key=value&...]; "
                    "without it the start page")
        ->type_name("");
    options.view.add(parser);
    options.how.add(parser, zscope::cli::HowOptions::Algorithms::One);
    parser.add_option("--grain", options.grain, "Grain of the steps: stage, triangle, line, span or pixel")
        ->type_name("GRAIN")
        ->group("Step");
    parser.add_option("--at", options.step, "Step to begin at, counted from 0 (default: the finished picture)")
        ->type_name("K")
        ->group("Step");
    parser.add_option("--session", options.session, "Reopen the view that was saved in this session file")
        ->type_name("FILE")
        ->group("Window");
    parser.add_flag("--reset-settings", options.resetSettings, "Forget layout, recent files and appearance")
        ->group("Window");
    parser.add_option("--language", options.language, "Language of the window in this run: system, en or zh_CN")
        ->type_name("LANGUAGE")
        ->group("Window");
    parser
        .add_option("--lessons", options.lessons,
                    "A folder of lessons to add to those of the program, see docs/lessons.md")
        ->type_name("DIR")
        ->group("Lessons");
    parser.add_option("--lesson", options.lesson, "Begin with this lesson: its file's name, or its number in the list")
        ->type_name("NAME")
        ->group("Lessons");
    parser.add_option("--page", options.page, "Page of the lesson to begin with, from 1")
        ->type_name("N")
        ->group("Lessons")
        ->check(CLI::PositiveNumber);
    parser.add_option("--settings", options.settings, "Keep settings in this file instead")
        ->type_name("FILE")
        ->group("Window");
    parser
        .add_option("--report", options.report,
                    "Write the charts and the page of a benchmark's record, and quit; needs no display")
        ->type_name("RECORD.json")
        ->group("Report");
    parser.add_option("-o", options.folder, "The folder of the report")->type_name("FOLDER")->group("Report");
    parser
        .add_option("--screenshot", options.screenshot,
                    "Save a picture of the whole window once the scene is drawn, and quit; for course notes and tests")
        ->type_name("FILE.png")
        ->group("Window");
}

Exit complain(Exit exit, const std::string& sentence)
{
    std::fprintf(stderr, "zscope: error: %s\n", sentence.c_str());
    return exit;
}

constexpr const char* kNoDisplay =
    "zscope: error: there is no display to open a window on; set DISPLAY or WAYLAND_DISPLAY, start it under xvfb-run, "
    "or draw pictures with zscope-cli";

/// Qt aborts when it finds no display; this ends with a sentence and a status instead.
void endWithoutDisplay(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    if (type != QtFatalMsg) {
        if (type != QtDebugMsg && type != QtInfoMsg && !message.contains("platform plugin")
            && !message.contains("display"))
            std::fprintf(stderr, "zscope: %s\n", qPrintable(message));
        return;
    }
    std::fprintf(stderr, "%s\n", kNoDisplay);
    std::_Exit(static_cast<int>(Exit::Output));
}

/// Writes the picture of the window when everything asked for is on it.
/// `asked`: a scene is on its way.
void screenshotWhenIdle(zscope::ui::MainWindow& window, zscope::ui::Session& session, const QString& file, bool asked)
{
    auto* poll = new QTimer(&window);
    QObject::connect(poll, &QTimer::timeout, &window, [&window, &session, file, poll, asked] {
        const bool failed = !window.messages().sentence().isEmpty();
        if (!session.isIdle() || !session.course().isSettled() || (asked && !session.now().step && !failed)) return;
        poll->stop();
        QTimer::singleShot(100, &window, [&window, file, failed] {
            const bool saved = window.grab().save(file, "PNG");
            if (!saved) std::fprintf(stderr, "zscope: error: %s cannot be written\n", qPrintable(file));
            if (failed) std::fprintf(stderr, "zscope: error: %s\n", qPrintable(window.messages().sentence()));
            QApplication::exit(static_cast<int>(!saved ? Exit::Output : failed ? Exit::Input : Exit::Done));
        });
    });
    poll->start(50);
}

Exit report(const Options& options, char** argv)
{
    if (options.report.empty())
        return complain(Exit::Usage, "-o names the folder of a report: say of which record with --report");
    if (options.folder.empty()) return complain(Exit::Usage, "--report wants a folder: -o FOLDER");
    if (!options.scene.empty() || !options.session.empty())
        return complain(Exit::Usage, "a report is made from a record alone: leave SCENE and --session out");
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    int          qtArgc = 1;
    QApplication application(qtArgc, argv);
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    const auto written = zscope::ui::writeReport(options.report, options.folder);
    if (!written) return complain(zscope::cli::exitOf(written.error().kind), written.error().text());
    std::printf("%s\n", written->c_str());
    return Exit::Done;
}

Exit run(int argc, char** argv)
{
    Options  options;
    CLI::App parser("ZScope: a microscope for visible-surface algorithms", "zscope");
    declare(parser, options);
    try {
        parser.parse(argc, argv);
    } catch (const CLI::Success& help) {  // --help and --version
        parser.exit(help);
        return Exit::Done;
    } catch (const CLI::ParseError& error) {
        return complain(Exit::Usage, error.what());
    }
    if (!options.scene.empty() && !options.session.empty())
        return complain(Exit::Usage, "a session names its own scene: give one of SCENE and --session");
    if (!options.report.empty() || !options.folder.empty()) return report(options, argv);
    const auto view = options.view.read();
    if (!view) return complain(zscope::cli::exitOf(view.error().kind), view.error().text());
    const auto how = options.how.read();
    if (!how) return complain(zscope::cli::exitOf(how.error().kind), how.error().text());
    const auto grain = zscope::grainOf(options.grain);
    if (!options.grain.empty() && !grain)
        return complain(Exit::Usage, "unknown grain '" + options.grain + "': see zscope-cli list grains");

    const auto language = zscope::ui::languageOf(options.language);
    if (!options.language.empty() && !language)
        return complain(Exit::Usage, "unknown language '" + options.language + "': one of system, en, zh_CN");

    const auto set = [](const char* name) { return !qEnvironmentVariableIsEmpty(name); };
    if (!set("QT_QPA_PLATFORM") && !set("DISPLAY") && !set("WAYLAND_DISPLAY")) {
        std::fprintf(stderr, "%s\n", kNoDisplay);
        return Exit::Output;
    }
    if (options.resetSettings) zscope::ui::Settings::forget(QString::fromLocal8Bit(options.settings.c_str()));

    const QtMessageHandler before = qInstallMessageHandler(endWithoutDisplay);
    int                    qtArgc = 1;  // Qt has no say in our command line
    QApplication           application(qtArgc, argv);
    qInstallMessageHandler(before);
    QApplication::setApplicationName("ZScope");
    QApplication::setApplicationVersion(ZSCOPE_VERSION);
    QApplication::setDesktopFileName("zscope");
    const QPalette system = QApplication::palette();
    QApplication::setStyle(QStyleFactory::create("Fusion"));

    zscope::ui::Settings settings(QString::fromLocal8Bit(options.settings.c_str()));
    settings.beginStart();
    zscope::ui::Session    session({.threads = how->threads, .simd = how->simd, .memoryLimit = how->memoryLimit});
    zscope::ui::MainWindow window(session, settings, system);
    if (language) window.speak(*language);
    session.setPipeline(how->algorithm().pipeline);
    if (grain) session.setGrain(*grain);
    window.show();
    if (settings.trouble()) window.messages().tell([&settings] { return settings.trouble().value_or(QString()); });
    if (!options.session.empty())
        window.openSession(QString::fromLocal8Bit(options.session.c_str()));
    else if (!options.scene.empty())
        window.open(QString::fromLocal8Bit(options.scene.c_str()),
                    [words = *view](const zscope::Scene& scene) { return words.requestFor(scene); });
    if (!options.lessons.empty()) window.openLessons(QString::fromLocal8Bit(options.lessons.c_str()));
    if (!options.lesson.empty()) {
        const auto found = session.course().find(QString::fromLocal8Bit(options.lesson.c_str()));
        if (!found) return complain(Exit::Usage, "there is no lesson '" + options.lesson + "'");
        session.course().open(*found, options.page - 1);
    }
    if (options.step) session.startAt(*options.step);
    if (!options.screenshot.empty())
        screenshotWhenIdle(window, session, QString::fromLocal8Bit(options.screenshot.c_str()),
                           !options.scene.empty() || !options.session.empty() || !options.lesson.empty());
    return static_cast<Exit>(QApplication::exec());
}

}  // namespace

int main(int argc, char** argv) { return static_cast<int>(run(argc, argv)); }
