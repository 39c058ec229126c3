// zscope-cli info: what a scene holds; nothing is rendered.
#include <set>
#include <span>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/json.h"
#include "app/cli/options.h"
#include "app/cli/table.h"
#include "core/base/stopwatch.h"
#include "core/geometry/prepared_scene.h"
#include "core/measure/empty_picture.h"

namespace zscope::cli {
namespace {

struct InfoOptions {
    SceneOption                scene;
    ViewOptions                view;
    std::optional<std::string> memoryLimit;
    bool                       json = false, times = false;
};

/// Of every mesh once, however often it stands in the scene; triangles are in Scene.
struct Counts {
    std::uint64_t vertices = 0, polygons = 0, groups = 0, materials = 0, dropped = 0, split = 0;
};

Counts countsOf(const Scene& scene)
{
    Counts counts;
    for (const auto& mesh : scene.meshes) {
        counts.vertices += mesh->positions.size();
        counts.polygons += mesh->polygonCount();
        counts.groups += std::set(mesh->polygonGroup.begin(), mesh->polygonGroup.end()).size();
        counts.materials += std::set(mesh->polygonMaterial.begin(), mesh->polygonMaterial.end()).size();
        counts.dropped += mesh->droppedFaces;
        counts.split += mesh->splitFaces;
    }
    return counts;
}

/// What it took until the scene could be drawn.
struct Times {
    LoadTimes load;
    double    prepareMs = 0;
};

/// Makes the scene ready for drawing to see how long that takes.
Times timesOf(const LoadTimes& load, const std::shared_ptr<const Scene>& scene)
{
    Stopwatch           watch;
    const PreparedScene prepared(scene);
    return {load, watch.lap()};
}

Json jsonOf(const Times& times)
{
    return {{"read_ms", times.load.readMs},
            {"parse_ms", times.load.parseMs},
            {"check_ms", times.load.checkMs},
            {"prepare_ms", times.prepareMs}};
}

/// What is said of the scene, and of views that show nothing: the one that is asked for, else the default view and all
/// that the scene names.
Result<std::vector<Warning>> warningsOf(const Scene& scene, const ViewWords& words, Session& session)
{
    std::vector<Warning> warnings = scene.warnings;
    const bool           isAsked  = !words.given.empty() || words.faceCulling;
    const auto           judge    = [&](const ViewWords::View& view, const std::string& name, int line) {
        auto why = whyEmpty(scene, view.camera, view.faceCulling, name, session.progress());
        if (!why) return;
        if (line > 0 && why->file.empty()) why->file = scene.name, why->line = line;
        warnings.push_back(*std::move(why));
    };
    if (isAsked || scene.views.empty()) {
        const auto view = words.of(scene);
        if (!view && isAsked) return view.error();
        if (view) judge(*view, {}, 0);  // a scene that cannot be framed has no default view
    } else {
        for (const NamedView& named : scene.views) {
            const auto view = words.of(scene, named.name);
            if (!view) return view.error();
            judge(*view, named.name, named.line);
        }
    }
    if (session.interrupted()) return Error{Trouble::Cancelled, "interrupted"};
    return warnings;
}

Json jsonOf(const Scene& scene, const std::vector<Warning>& all, const Counts& counts)
{
    Json warnings = Json::array();
    for (const Warning& warning : all)
        warnings.push_back({{"file", warning.file}, {"line", warning.line}, {"message", warning.sentence}});
    return {{"vertices", counts.vertices},         {"polygons", counts.polygons}, {"triangles", scene.triangleCount()},
            {"instances", scene.instances.size()}, {"groups", counts.groups},     {"materials", counts.materials},
            {"dropped", counts.dropped},           {"split", counts.split},       {"bounds", cli::jsonOf(scene.bounds)},
            {"warnings", std::move(warnings)},     {"digest", scene.digest}};
}

std::string tableOf(const Scene& scene, std::size_t warnings, const Counts& counts, const Times* times)
{
    Table      table({{"scene", Table::Align::Left}, {scene.name, Table::Align::Left}});
    const auto row = [&table](const char* name, std::uint64_t value) { table.row({name, grouped(value)}); };
    row("vertices", counts.vertices);
    row("polygons", counts.polygons);
    row("triangles", scene.triangleCount());
    row("instances", scene.instances.size());
    row("groups", counts.groups);
    row("materials", counts.materials);
    row("dropped", counts.dropped);
    row("split", counts.split);
    if (!scene.bounds.isEmpty()) {
        const auto corner = [](const dvec3& p) { return fmt::format("{} {} {}", p.x, p.y, p.z); };
        table.row({"from", corner(scene.bounds.min)});
        table.row({"to", corner(scene.bounds.max)});
    }
    table.row({"warnings", grouped(warnings)});
    table.row({"digest", scene.digest});
    if (times) {
        const auto ms = [&table](const char* name, double value) {
            table.row({name, fmt::format("{:.1f} ms", value)});
        };
        ms("read", times->load.readMs);
        ms("parse", times->load.parseMs);
        ms("check", times->load.checkMs);
        ms("prepare", times->prepareMs);
    }
    return table.text();
}

Result<Exit> info(const InfoOptions& options, Session& session)
{
    std::uint64_t limit = 0;
    if (options.memoryLimit) {
        const auto given = memoryLimitOf(*options.memoryLimit);
        if (!given) return given.error();
        limit = *given;
    }
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    LoadTimes  load;
    const auto scene = cli::loadScene(options.scene.word(), session, limit, 0, &load);
    if (!scene) return scene.error();
    const auto warnings = warningsOf(**scene, *words, session);
    if (!warnings) return warnings.error();
    if (!options.json) session.warn(*warnings, warnings->size());
    const Counts counts = countsOf(**scene);
    const Times  times  = options.times ? timesOf(load, *scene) : Times{};
    if (!options.json) {
        session.print(tableOf(**scene, warnings->size(), counts, options.times ? &times : nullptr));
        return Exit::Done;
    }
    Json json = jsonOf(**scene, *warnings, counts);
    if (options.times) json["times"] = jsonOf(times);
    session.print(textOf(json));
    return Exit::Done;
}

}  // namespace

Command addInfo(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("info", "Count what a scene holds; nothing is rendered");
    auto      options = std::make_shared<InfoOptions>();
    options->scene.add(*parser);
    options->view.add(*parser);
    parser->add_flag("--json", options->json, "JSON instead of a table; warnings are part of it");
    parser->add_flag("--times", options->times,
                     "How long reading, parsing, checking and preparing it for drawing took");
    parser->add_option("--memory-limit", options->memoryLimit, "Most memory that the scene may take")->type_name("MIB");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = info(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
