// zscope-cli: everything the window can measure, without a display. Its words are stable: scripts, courses and
// tests call it (README.md, "On the command line").
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/session.h"
#include "app/cli/words.h"

namespace zscope::cli {
namespace {

/// A misspelt command would be reported as a missing one: this names what was written.
bool isUnknownCommand(std::string_view word, const std::vector<Command>& commands)
{
    return !word.starts_with('-')
           && std::ranges::none_of(commands, [&](const Command& c) { return c.parser->get_name() == word; });
}

/// A file whose name begins with a dash is read as an option: this says how to name it. Empty: there is none.
std::string hintAtDash(std::span<char* const> words)
{
    for (const std::string_view word : words) {
        std::error_code trouble;
        const bool      isFile = word.ends_with(".obj") || std::filesystem::is_regular_file(word, trouble);
        if (word.starts_with('-') && isFile)
            return fmt::format("'{0}' is read as an option: write the file's name as './{0}'", word);
    }
    return {};
}

Exit usage(Session& session, const std::vector<Command>& commands, std::string sentence)
{
    const auto        asked = std::ranges::find_if(commands, [](const Command& c) { return c.parser->parsed(); });
    const std::string name  = asked == commands.end() ? "" : asked->parser->get_name() + " ";
    const Exit        exit  = session.fail({Trouble::Usage, std::move(sentence)});
    session.note(fmt::format("'zscope-cli {}--help' lists what can be said", name));
    return exit;
}

Exit run(int argc, char** argv)
{
    Session  session({argv, static_cast<std::size_t>(argc)});
    CLI::App parser("ZScope on the command line: visible-surface algorithms, drawn, stepped, checked and timed",
                    "zscope-cli");
    parser.set_version_flag("--version", "ZScope " ZSCOPE_VERSION);
    parser.require_subcommand(1);
    const std::vector<Command> commands{addRender(parser),  addInfo(parser),   addExport(parser),  addVerify(parser),
                                        addCheck(parser),   addGrade(parser),  addAudit(parser),   addStep(parser),
                                        addExplain(parser), addLesson(parser), addCompare(parser), addBench(parser),
                                        addMerge(parser),   addList(parser)};
    bool                       quiet = false;
    for (const Command& command : commands) command.parser->add_flag("--quiet", quiet, "Show no progress");

    if (argc > 1 && isUnknownCommand(argv[1], commands)) {
        std::vector<std::string> valid;
        for (const Command& command : commands) valid.push_back(command.parser->get_name());
        return usage(session, commands, unknownWord("command", argv[1], valid).sentence);
    }
    try {
        parser.parse(argc, argv);
    } catch (const CLI::Success& help) {  // --help and --version
        parser.exit(help);
        return session.finish(Exit::Done);
    } catch (const CLI::ParseError& error) {
        const std::string hint = hintAtDash({argv, static_cast<std::size_t>(argc)});
        return usage(session, commands, hint.empty() ? error.what() : hint);
    }
    if (quiet) session.silence();
    const auto asked = std::ranges::find_if(commands, [](const Command& c) { return c.parser->parsed(); });
    return session.finish(asked->run(session));
}

}  // namespace
}  // namespace zscope::cli

int main(int argc, char** argv)
{
    using zscope::cli::Exit;
    zscope::cli::catchInterrupts();
    try {
        return static_cast<int>(zscope::cli::run(argc, argv));
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {  // a container that could never be that large
    }
    std::fputs("zscope-cli: error: there is not enough memory for this scene and picture\n", stderr);
    return static_cast<int>(Exit::Limit);
}
