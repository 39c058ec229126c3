// zscope-cli export: the triangles as any other program can read them.
#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "app/cli/scene_export.h"

namespace zscope::cli {
namespace {

struct ExportOptions {
    SceneOption                scene;
    std::optional<std::string> memoryLimit;
    std::optional<std::string> triangles, obj;
};

Result<Exit> exportTriangles(const ExportOptions& options, Session& session)
{
    std::uint64_t limit = 0;
    if (options.memoryLimit) {
        const auto given = memoryLimitOf(*options.memoryLimit);
        if (!given) return given.error();
        limit = *given;
    }
    if (!options.triangles && !options.obj)
        return Error{Trouble::Usage, "export needs --triangles FILE.npy or --obj FILE.obj"};
    const std::vector<Output> outputs{{"--triangles", options.triangles}, {"--obj", options.obj, {".obj"}}};
    if (const auto checked = checkOutputs(outputs, {options.scene.word()}); !checked) return checked.error();
    const auto scene = options.scene.load(session, limit);
    if (!scene) return scene.error();
    if (const auto checked = checkOutputs(outputs, (*scene)->files); !checked) return checked.error();
    if (options.triangles)
        if (const auto done = writeTriangles(**scene, *options.triangles, session.cancel()); !done) return done.error();
    if (options.obj)
        if (const auto done = writeObj(**scene, *options.obj, session.cancel()); !done) return done.error();
    return Exit::Done;
}

}  // namespace

Command addExport(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("export", "Write the scene's triangles as an array or as an OBJ file");
    auto      options = std::make_shared<ExportOptions>();
    options->scene.add(*parser);
    parser
        ->add_option("--triangles", options->triangles,
                     "World-space corners: float64 (N, 3, 3), the row is the triangle's id")
        ->type_name("FILE.npy");
    parser
        ->add_option("--obj", options->obj,
                     "The same as an OBJ file, one face for each triangle: for programs that read no other scenes")
        ->type_name("FILE.obj");
    parser->add_option("--memory-limit", options->memoryLimit, "Most memory that the scene may take")->type_name("MIB");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = exportTriangles(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
