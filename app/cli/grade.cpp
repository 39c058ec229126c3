#include "app/cli/grade.h"

#include <algorithm>

#include "app/cli/commands.h"
#include "app/cli/grade_output.h"
#include "app/cli/grade_run.h"
#include "core/io/file_writer.h"

namespace zscope::cli {
namespace {

Result<Exit> grade(const GradeOptions& options, Session& session)
{
    const auto rows = gradeAll(options, session);
    if (!rows) return rows.error();
    session.print(options.json ? gradeJsonOf(*rows) : gradeTableOf(*rows));
    if (options.junit)
        if (const auto done = writeFile(*options.junit, gradeJunitOf(*rows)); !done) return done.error();
    if (options.gradescope)
        if (const auto done = writeFile(*options.gradescope, gradescopeOf(*rows)); !done) return done.error();
    const bool allGood = std::ranges::all_of(*rows, [](const GradeRow& row) { return isGood(row.verdict); });
    return allGood ? Exit::Done : Exit::CheckFailed;
}

}  // namespace

Command addGrade(CLI::App& parent)
{
    CLI::App* parser =
        parent.add_subcommand("grade", "Run programs over scenes in a sandbox, and judge what they draw");
    auto       options = std::make_shared<GradeOptions>();
    const auto option  = [&](const char* name, std::optional<std::string>& value, const char* type, const char* help,
                            const char* group) {
        parser->add_option(name, value, help)->type_name(type)->group(group);
    };
    parser->add_option("SCENE", options->scenes, "Scenes, each an .obj file, a scene .json file, or builtin:NAME")
        ->type_name("...")
        ->required();
    options->view.add(*parser);
    parser
        ->add_option(
            "--program", options->program,
            "Line of the shell that draws. {scene} (OBJ), {camera} (JSON), {out} (folder for out.zdump, depth.npy, "
            "ids.npy or picture.png) and {submission} become paths")
        ->type_name("COMMAND")
        ->group("Program")
        ->required();
    option("--submissions", options->submissions, "FOLDER", "Each file or folder in it is a submission", "Program");
    option("--time-limit", options->timeLimit, "S", "Seconds that a run may take, compiling included (default 10)",
           "Limits");
    option("--memory-limit", options->memoryLimit, "MIB", "Memory that a run may take (default 2048)", "Limits");
    option("--threads", options->threads, "N", "Runs side by side (default: one for each core)", "Limits");
    parser->add_flag("--no-sandbox", options->withoutSandbox, "Run programs with all rights that you have")
        ->group("Limits");
    option("--journal", options->journal, "FILE.json", "Keep each result, and go on where a journal ends", "Reports");
    parser->add_flag("--json", options->json, "JSON instead of a table")->group("Reports");
    option("--junit", options->junit, "FILE.xml", "Also write a JUnit report", "Reports");
    option("--gradescope", options->gradescope, "FILE.json",
           "Also write the results of one program as Gradescope reads them", "Reports");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = grade(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
