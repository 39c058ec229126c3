// zscope-cli export: the triangles as any other program can read them.
#include <array>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "core/io/npy.h"

namespace zscope::cli {
namespace {

struct ExportOptions {
    SceneOption                scene;
    std::optional<std::string> memoryLimit;
    std::string                triangles;
};

constexpr std::uint64_t kTrianglesAtATime = 1 << 14;  // between two looks at whether they are still wanted

Result<Done> writeTriangles(const Scene& scene, const std::string& path, const Session& session)
{
    Result<NpyTriangleWriter> file = NpyTriangleWriter::create(path, scene.triangleCount());
    if (!file) return file.error();
    std::uint64_t written = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh  = *scene.meshes[instance.mesh.value];
        const bool  moved = !instance.toWorld.isIdentity();
        for (const auto& triangle : mesh.triangles) {
            if (written++ % kTrianglesAtATime == 0 && session.interrupted())
                return Error{Trouble::Cancelled, "interrupted"};
            std::array<double, 9> corners;
            for (std::size_t c = 0; c < 3; ++c) {
                const dvec3& p = mesh.positions[triangle[c]];
                const dvec3  q = moved ? instance.toWorld(p) : p;
                for (std::size_t axis = 0; axis < 3; ++axis) corners[c * 3 + axis] = q[static_cast<int>(axis)];
            }
            file->triangle(corners);
        }
        if (file->failed()) break;  // commit() says why
    }
    return file->commit();
}

Result<Exit> exportTriangles(const ExportOptions& options, Session& session)
{
    std::uint64_t limit = 0;
    if (options.memoryLimit) {
        const auto given = memoryLimitOf(*options.memoryLimit);
        if (!given) return given.error();
        limit = *given;
    }
    const std::vector<Output> outputs{{"--triangles", options.triangles}};
    if (const auto checked = checkOutputs(outputs, {options.scene.word()}); !checked) return checked.error();
    const auto scene = options.scene.load(session, limit);
    if (!scene) return scene.error();
    if (const auto checked = checkOutputs(outputs, (*scene)->files); !checked) return checked.error();
    if (const auto done = writeTriangles(**scene, options.triangles, session); !done) return done.error();
    return Exit::Done;
}

}  // namespace

Command addExport(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("export", "Write the scene's triangles as an array");
    auto      options = std::make_shared<ExportOptions>();
    options->scene.add(*parser);
    parser
        ->add_option("--triangles", options->triangles,
                     "World-space corners: float64 (N, 3, 3), the row is the triangle's id")
        ->type_name("FILE.npy")
        ->required();
    parser->add_option("--memory-limit", options->memoryLimit, "Most memory that the scene may take")->type_name("MIB");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = exportTriangles(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
