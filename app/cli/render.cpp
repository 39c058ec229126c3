// zscope-cli render: one frame, as a picture, as arrays, and as the statistics of making it.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/json.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "app/cli/table.h"
#include "app/cli/words.h"
#include "core/frame/shortcuts.h"
#include "core/io/file_writer.h"
#include "core/io/npy.h"
#include "core/io/png.h"
#include "core/lesson/layers.h"
#include "core/lesson/replay.h"
#include "core/measure/cull_audit.h"
#include "core/measure/empty_picture.h"
#include "core/measure/over_render.h"

namespace zscope::cli {
namespace {

struct RenderOptions {
    SceneOption                scene;
    ViewOptions                view;
    HowOptions                 how;
    std::optional<std::string> picture, ids, depth, stats, layer;
    bool                       printCamera = false;
};

struct Drawn {
    Frame       frame;
    FrameReport report;
};

std::uint64_t coveredPixels(const VisibilityBuffer& visible)
{
    std::uint64_t covered = 0;
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x) covered += visible.rankAt(x, y) != 0;
    return covered;
}

/// What is found out about a frame afterwards.
struct Explained {
    FrameWork                work;
    std::optional<CullAudit> culls;  // of stream methods
};

Result<Explained> explain(Renderer& renderer, const DrawRequest& request, const Drawn& drawn)
{
    Result<FrameWork> work = renderer.count(request);
    if (!work) return work.error();
    Explained explained{*std::move(work), {}};
    if (canAuditCulls(request.pipeline)) {
        const auto audit = auditCulls(request, drawn.frame.visible, {});
        if (!audit) return audit.error();
        explained.culls = *audit;
    }
    return explained;
}

Json jsonOf(const DepthWork& work)
{
    return {{"tree", work.isInstanceTree ? "instances" : "triangles"},
            {"depth", work.depth},
            {"nodes_visited", work.nodesVisited},
            {"nodes_outside", work.nodesOutside},
            {"nodes_hidden", work.nodesHidden},
            {"nodes_entered", work.nodesEntered},
            {"nodes_drawn", work.nodesDrawn},
            {"nodes_dropped", work.nodesDropped},
            {"nodes_recalled", work.nodesRecalled},
            {"triangles_outside", work.trianglesOutside},
            {"triangles_hidden_by_node", work.trianglesHiddenByNode},
            {"triangles_hidden", work.trianglesHidden},
            {"triangles_drawn", work.trianglesDrawn},
            {"triangles_dropped_with_node", work.trianglesDropped},
            {"pyramid_queries", work.queries},
            {"pyramid_cells_read", work.cellsRead}};
}

Json jsonOf(const OverRender& figures)
{
    return {{"triangles_rasterised", figures.trianglesRasterised},
            {"triangles_visible", figures.trianglesVisible},
            {"triangles", figures.ofTriangles()},
            {"fragments_tested", figures.fragmentsTested},
            {"pixels_covered", figures.pixelsCovered},
            {"fragments", figures.ofFragments()}};
}

/// null for a method that does not draw triangle after triangle, as a sweep.
Json missedCullsOf(const std::optional<CullAudit>& culls)
{
    if (!culls) return nullptr;
    return {{"nodes", culls->missedNodes},
            {"nodes_entered", culls->nodesEntered},
            {"triangles", culls->missedTriangles},
            {"triangles_drawn", culls->trianglesDrawn}};
}

Json statsOf(const std::string& algorithm, const Scene& scene, const Drawn& drawn, const Explained& explained)
{
    Json hierarchy = Json::array();
    for (const DepthWork& depth : explained.work.depths) hierarchy.push_back(jsonOf(depth));
    Json pyramid = Json::array();
    for (const LevelWork& level : explained.work.levels)
        pyramid.push_back(
            {{"level", level.level}, {"cells_written", level.cellsWritten}, {"cells_changed", level.cellsChanged}});
    Json stages = Json::array();
    for (const StageTime& stage : drawn.report.stages)
        stages.push_back({{"name", wordOf(stage.stage)}, {"ms", stage.ms}, {"ran", stage.ran}, {"why", stage.why}});
    const VisibilityBuffer& visible   = drawn.frame.visible;
    const FrameReport&      report    = drawn.report;
    Json                    shortcuts = Json::array();
    for (const ShortcutUse& use : usesOf(report.shortcuts, report.pipeline))
        shortcuts.push_back({{"name", use.name}, {"applies", use.applies}, {"why", use.why}});
    return {
        {"algorithm", algorithm},
        {"chosen", report.chosen.empty() ? Json(nullptr) : Json(report.chosen)},
        {"why", report.why.empty() ? Json(nullptr) : Json(report.why)},
        {"threads", drawn.report.threads},
        {"simd", wordOf(drawn.report.simd)},
        {"shortcuts", std::move(shortcuts)},
        {"scene",
         {{"name", scene.name},
          {"triangles", scene.triangleCount()},
          {"instances", scene.instances.size()},
          {"meshes", scene.meshes.size()},
          {"digest", scene.digest}}},
        {"picture", {{"width", visible.width()}, {"height", visible.height()}, {"covered", coveredPixels(visible)}}},
        {"stages", std::move(stages)},
        {"tallies", cli::jsonOf(report.tally.named())},
        {"counters", cli::jsonOf(explained.work.counters)},
        {"hierarchy", std::move(hierarchy)},
        {"pyramid", std::move(pyramid)},
        {"missed_culls", missedCullsOf(explained.culls)},
        {"over_render", jsonOf(overRenderOf(explained.work, visible))},
        {"bytes", cli::jsonOf(drawn.report.bytes)},
        {"frame_ms", drawn.report.frameMs}};
}

std::string summaryOf(const std::string& algorithm, const Scene& scene, const Drawn& drawn)
{
    const VisibilityBuffer& visible = drawn.frame.visible;
    std::string text = fmt::format("{}  {}x{}  {} triangles  {} pixels covered  {:.3f} ms  ({} thread{}, {})\n",
                                   algorithm, visible.width(), visible.height(), grouped(scene.triangleCount()),
                                   grouped(coveredPixels(visible)), drawn.report.frameMs, drawn.report.threads,
                                   drawn.report.threads == 1 ? "" : "s", wordOf(drawn.report.simd));
    if (!drawn.report.why.empty()) text += drawn.report.why + "\n";
    if (const std::string_view why = whyPlain(drawn.report.pipeline); !why.empty() && !drawn.report.shortcuts.isEmpty())
        text += fmt::format("No shortcut applies: {}.\n", why);
    Table stages({{"stage", Table::Align::Left}, {"ms"}, {"why", Table::Align::Left}});
    for (const StageTime& stage : drawn.report.stages)
        stages.row({std::string(wordOf(stage.stage)), stage.ran ? fmt::format("{:.3f}", stage.ms) : "-", stage.why});
    return text + stages.text();
}

/// Every output that was asked for, one after another; each is complete or absent.
Result<Done> write(const RenderOptions& options, const Layer& layer, const Grid<std::uint32_t>& tests,
                   const Scene& scene, const Drawn& drawn, const std::string& stats, const Session& session)
{
    const auto stillWanted = [&session](const std::optional<std::string>& output) -> Result<bool> {
        if (session.interrupted()) return Error{Trouble::Cancelled, "interrupted"};
        return output.has_value();
    };
    if (const auto wanted = stillWanted(options.picture); !wanted) {
        return wanted.error();
    } else if (*wanted) {
        // The frame's own colours are not copied: a large picture takes as much memory again.
        Grid<std::uint32_t> painted;
        const bool          isShaded = layer.word == layers().front().word;
        if (!isShaded) painted = layer.paint({.frame = drawn.frame, .tests = &tests, .range = {}});
        const auto texts = reproducingTexts(session.reproducingCommand(), scene.digest);
        const auto done =
            writePng(*options.picture, isShaded ? drawn.frame.colour.view() : std::as_const(painted).view(), texts,
                     {.threads = drawn.report.threads, .cancel = session.cancel()});
        if (!done) return done;
    }
    const VisibilityBuffer& visible = drawn.frame.visible;
    if (const auto wanted = stillWanted(options.ids); !wanted) {
        return wanted.error();
    } else if (*wanted) {
        const auto fill = [&visible](int y, std::span<std::int64_t> row) {
            for (int x = 0; x < visible.width(); ++x) row[static_cast<std::size_t>(x)] = visible.idAt(x, y);
        };
        const auto done =
            writeNpy(*options.ids, visible.width(), visible.height(), NpyRow<std::int64_t>(fill), session.cancel());
        if (!done) return done;
    }
    if (const auto wanted = stillWanted(options.depth); !wanted) {
        return wanted.error();
    } else if (*wanted) {
        const auto fill = [&visible](int y, std::span<float> row) {
            for (int x = 0; x < visible.width(); ++x) row[static_cast<std::size_t>(x)] = visible.depthAt(x, y);
        };
        const auto done =
            writeNpy(*options.depth, visible.width(), visible.height(), NpyRow<float>(fill), session.cancel());
        if (!done) return done;
    }
    if (const auto wanted = stillWanted(options.stats); !wanted) return wanted.error();
    if (options.stats) return writeFile(*options.stats, stats);
    return Done{};
}

Result<Exit> render(const RenderOptions& options, Session& session)
{
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    const Result<How> how = options.how.read();
    if (!how) return how.error();
    const std::vector<Output> outputs{{"-o", options.picture, {".png"}},
                                      {"--ids", options.ids},
                                      {"--depth", options.depth},
                                      {"--stats", options.stats}};
    if (const auto checked = checkOutputs(outputs, {options.scene.word(), options.view.cameraFile()}); !checked)
        return checked.error();
    if (options.layer && !options.picture)
        return Error{Trouble::Usage, "--show chooses what the picture shows: say with -o where it goes"};
    const Layer* layer = findLayer(options.layer.value_or(std::string(layers().front().word)));
    if (!layer) {
        std::vector<std::string> valid;
        for (const Layer& each : layers()) valid.emplace_back(each.word);
        return unknownWord("layer", *options.layer, valid);
    }

    if (options.printCamera) {
        if (std::ranges::any_of(outputs, [](const Output& output) { return output.path.has_value(); }))
            return Error{Trouble::Usage,
                         "--print-camera draws nothing: -o, --ids, --depth and --stats do not go with it"};
        const auto scene = options.scene.load(session, how->memoryLimit);
        if (!scene) return scene.error();
        const auto view = words->of(**scene);
        if (!view) return view.error();
        session.print(cameraToJson(view->camera) + '\n');
        return Exit::Done;
    }

    const Result<LoadedScene> scene = options.scene.prepare(session, how->memoryLimit);
    if (!scene) return scene.error();
    if (const auto checked = checkOutputs(outputs, scene->scene->files); !checked) return checked.error();
    const auto view = words->of(*scene->scene);
    if (!view) return view.error();

    const DrawRequest   request = how->request(*scene, *view, session);
    Renderer            renderer;
    Drawn               drawn;
    Result<FrameReport> report = renderer.draw(request, drawn.frame);
    if (!report) return report.error();
    drawn.report = *std::move(report);
    if (const auto why = whyEmpty(request, drawn.frame)) session.warn(std::span(&*why, 1), 1);

    Grid<std::uint32_t> tests;
    if (layer->needsTests) {  // a run of its own: at full speed nobody counts
        Replay     replay(request);
        const auto frames = replay.count(Grain::Frame);
        if (!frames) return frames.error();
        auto last = replay.at(Grain::Frame, StepIndex{*frames - 1});
        if (!last) return last.error();
        tests = std::move(last->tests);
    }

    std::string stats;
    if (options.stats) {
        const auto explained = explain(renderer, request, drawn);
        if (!explained) return explained.error();
        stats = textOf(statsOf(how->algorithm().name, *scene->scene, drawn, *explained));
    }
    if (const auto done = write(options, *layer, tests, *scene->scene, drawn, stats, session); !done)
        return done.error();
    session.print(summaryOf(how->algorithm().name, *scene->scene, drawn));
    return Exit::Done;
}

}  // namespace

Command addRender(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("render", "Draw one frame");
    auto      options = std::make_shared<RenderOptions>();
    options->scene.add(*parser);
    options->view.add(*parser);
    options->how.add(*parser, HowOptions::Algorithms::One);
    parser->add_option("-o,--output", options->picture, "The picture, a PNG: its name ends in .png or has no ending")
        ->type_name("FILE")
        ->group("Output");
    parser->add_option("--ids", options->ids, "Triangle ids: int64 (H, W), -1 is background")
        ->type_name("FILE.npy")
        ->group("Output");
    parser->add_option("--depth", options->depth, "Depth near/z: float32 (H, W), 0 is background")
        ->type_name("FILE.npy")
        ->group("Output");
    parser->add_option("--stats", options->stats, "Stages, counters and bytes of the frame, JSON")
        ->type_name("FILE.json")
        ->group("Output");
    parser->add_option("--show", options->layer, "What the picture shows, see 'list layers' (default shaded)")
        ->type_name("LAYER")
        ->group("Output");
    parser->add_flag("--print-camera", options->printCamera, "Print the camera's ten numbers and draw nothing")
        ->group("Output");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = render(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
