// zscope-cli audit: what another program's culling hides that is seen, and what it draws in vain.
#include <algorithm>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/json.h"
#include "app/cli/options.h"
#include "app/cli/table.h"
#include "core/check/audit.h"
#include "core/io/npy_read.h"
#include "core/io/read_file.h"
#include "core/probe/words.h"

namespace zscope::cli {
namespace {

constexpr std::uint64_t kMaxVerdictFile = std::uint64_t{256} << 20;
constexpr std::uint64_t kMaxLevelFile   = std::uint64_t{4} << 30;
constexpr std::size_t   kCellsShown     = 20;

struct AuditOptions {
    SceneOption                scene;
    ViewOptions                view;
    std::optional<std::string> verdicts;
    std::vector<std::string>   pyramid;
    bool                       json = false;
};

struct Audit {
    std::vector<check::CullJudgement> objects;
    check::PyramidJudgement           pyramid;

    std::size_t falseCulls() const
    {
        return static_cast<std::size_t>(std::ranges::count_if(objects, &check::CullJudgement::isFalseCull));
    }
    bool isRight() const { return falseCulls() == 0 && pyramid.wrongCells == 0; }
};

Json jsonOf(const Audit& audit)
{
    Json json;
    json["objects"] = audit.objects.size();
    json["culled"]  = std::ranges::count_if(audit.objects, &check::CullJudgement::isCulled);
    Json &wrong = json["false_culls"] = Json::array(), &missed = json["missed_culls"] = Json::array();
    for (const check::CullJudgement& object : audit.objects) {
        if (object.isFalseCull()) wrong.push_back({{"name", object.name}, {"pixels", object.pixels}});
        if (object.isMissedCull()) missed.push_back({{"name", object.name}});
    }
    json["cells"] = Json::array();
    for (const check::WrongCell& cell : audit.pyramid.wrong)
        json["cells"].push_back(
            {{"level", cell.level}, {"x", cell.x}, {"y", cell.y}, {"value", cell.value}, {"farthest", cell.farthest}});
    json["cause"] = audit.pyramid.cause ? Json(wordOf(*audit.pyramid.cause)) : Json(nullptr);
    return json;
}

std::string describe(const Audit& audit, bool ofPyramid)
{
    if (ofPyramid) {
        const check::PyramidJudgement& p = audit.pyramid;
        if (p.wrongCells == 0)
            return fmt::format("No cell of {} is nearer than a pixel below it.\n", withCommas(p.cells));
        std::string text = fmt::format("{} of {} cells are nearer than the farthest pixel below them: {}.\n",
                                       withCommas(p.wrongCells), withCommas(p.cells), wordOf(*p.cause));
        Table       table({{"level"}, {"x"}, {"y"}, {"value"}, {"farthest"}});
        for (std::size_t i = 0; i < std::min(kCellsShown, p.wrong.size()); ++i)
            table.row({fmt::format("{}", p.wrong[i].level), fmt::format("{}", p.wrong[i].x),
                       fmt::format("{}", p.wrong[i].y), fmt::format("{:.9g}", p.wrong[i].value),
                       fmt::format("{:.9g}", p.wrong[i].farthest)});
        return text + table.text();
    }
    std::uint64_t lost   = 0;
    std::size_t   missed = 0;
    Table         table({{"object", Table::Align::Left}, {"verdict", Table::Align::Left}, {"pixels"}});
    for (const check::CullJudgement& object : audit.objects) {
        missed += object.isMissedCull();
        if (object.isFalseCull())
            lost += object.pixels, table.row({object.name, "false cull", withCommas(object.pixels)});
    }
    for (const check::CullJudgement& object : audit.objects)
        if (object.isMissedCull()) table.row({object.name, "missed cull", "0"});
    const std::size_t wrong = audit.falseCulls();
    std::string       text =
        wrong == 0 ? fmt::format("No object of {} is culled although it is seen.", withCommas(audit.objects.size()))
                         : fmt::format("{} culled although {} {}.", counted(wrong, "object is", "objects are"),
                                 wrong == 1 ? "it owns" : "they own", counted(lost, "pixel", "pixels"));
    text += missed == 0 ? std::string(" None is drawn in vain.\n")
                        : fmt::format(" {} not culled and {} no pixel.\n", counted(missed, "object is", "objects are"),
                                      missed == 1 ? "owns" : "own");
    return wrong + missed == 0 ? text : text + table.text();
}

/// The level above one of `below`'s size: a half, rounded up or down.
Result<Grid<double>> readLevel(const std::string& file, const Grid<double>* below, const Camera& camera)
{
    const Result<std::string> bytes = readRegularFile(file, kMaxLevelFile);
    if (!bytes) return bytes.error();
    const auto read = [&](int width, int height) -> Result<Grid<double>> {
        Result<NpyGrid> level = npyGridOf(*bytes, file, width, height);
        if (!level) return level.error();
        if (level->numbers.kind != 'f')
            return Error{Trouble::Input, "a level of a pyramid holds near/z as floats", file};
        return std::move(level->reals);
    };
    if (!below) return read(camera.width, camera.height);
    const int            w = below->width(), h = below->height();
    Result<Grid<double>> level = read((w + 1) / 2, (h + 1) / 2);
    for (const auto& [width, height] :
         {std::pair((w + 1) / 2, std::max(1, h / 2)), std::pair(std::max(1, w / 2), (h + 1) / 2),
          std::pair(std::max(1, w / 2), std::max(1, h / 2))})
        if (!level)
            if (auto other = read(width, height)) level = std::move(other);
    return level;
}

Result<Exit> audit(const AuditOptions& options, Session& session)
{
    if (options.verdicts.has_value() == !options.pyramid.empty())
        return Error{Trouble::Usage, "say either --verdicts FILE or --pyramid FILE..."};
    const auto words = options.view.read();
    if (!words) return words.error();
    const Result<LoadedScene> scene = options.scene.prepare(session, 0);
    if (!scene) return scene.error();
    const auto view = words->of(*scene->scene);
    if (!view) return view.error();

    Audit audit;
    if (options.verdicts) {
        const Result<std::string> text = readRegularFile(*options.verdicts, kMaxVerdictFile);
        if (!text) return text.error();
        const auto verdicts = check::cullVerdictsOf(*text, *options.verdicts);
        if (!verdicts) return verdicts.error();
        const auto truth = check::truthOf(scene->prepared, view->camera, view->faceCulling, 8, session.progress());
        if (!truth) return truth.error();
        auto objects = check::auditVerdicts(**truth, *verdicts, *options.verdicts);
        if (!objects) return objects.error();
        audit.objects = *std::move(objects);
    } else {
        std::vector<Grid<double>> levels;
        for (const std::string& file : options.pyramid) {
            auto level = readLevel(file, levels.empty() ? nullptr : &levels.back(), view->camera);
            if (!level) return level.error();
            levels.push_back(*std::move(level));
        }
        audit.pyramid = check::auditPyramid(levels);
    }
    session.print(options.json ? cli::textOf(jsonOf(audit)) : describe(audit, !options.pyramid.empty()));
    return audit.isRight() ? Exit::Done : Exit::CheckFailed;
}

}  // namespace

Command addAudit(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("audit", "Judge another program's culling: what it hides that is seen");
    auto      options = std::make_shared<AuditOptions>();
    options->scene.add(*parser);
    options->view.add(*parser);
    parser->add_option("--verdicts", options->verdicts, "JSON: boxes or groups, and whether each was culled")
        ->type_name("FILE")
        ->group("Files");
    parser->add_option("--pyramid", options->pyramid, "Levels of a depth pyramid in near/z, .npy, the pixels first")
        ->type_name("FILE...")
        ->group("Files");
    parser->add_flag("--json", options->json, "JSON instead of text");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = audit(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
