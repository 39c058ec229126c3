// zscope-cli verify: every algorithm's picture against the brute-force reference, pixel by pixel.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/json.h"
#include "app/cli/options.h"
#include "app/cli/table.h"
#include "app/cli/words.h"
#include "core/measure/verify.h"

namespace zscope::cli {
namespace {

struct VerifyOptions {
    SceneOption                scene;
    ViewOptions                view;
    HowOptions                 how;
    std::optional<std::string> sample;
    bool                       json = false;
};

/// Pixels kept with their ids and depths in memory: more than the largest picture has is never needed.
constexpr std::int64_t kMaxSamples = std::int64_t{kMaxPictureSide} * kMaxPictureSide;

std::string wordOf(Claim claim)
{
    return claim == Claim::Exact ? "yes" : claim == Claim::ExactByFace ? "by face" : "no";
}

std::string verdictOf(const VerifyRow& row)
{
    if (!row.passed()) return "WRONG";
    if (row.claim == Claim::Approximate) return "approximate";
    return row.figures.isExact() ? "same picture" : "same coverage by face";
}

std::string tableOf(const std::vector<VerifyRow>& rows)
{
    std::vector<Table::Column> columns{{"algorithm", Table::Align::Left},
                                       {"exact", Table::Align::Left},
                                       {"threads"},
                                       {"simd", Table::Align::Left},
                                       {"covered"},
                                       {"holes"},
                                       {"spills"},
                                       {"wrong surface"},
                                       {"depth bits differ"},
                                       {"max depth steps"},
                                       {"lost"},
                                       {"false culls"},
                                       {"", Table::Align::Left}};
    const bool judgesColours = std::ranges::any_of(rows, [](const VerifyRow& row) { return row.colours.has_value(); });
    if (judgesColours) columns.insert(columns.end() - 1, {{"wrong colours"}, {"max channel"}});
    Table table(std::move(columns));
    for (const VerifyRow& row : rows) {
        const ErrorFigures&      f = row.figures;
        std::vector<std::string> cells{row.algorithm,
                                       wordOf(row.claim),
                                       std::to_string(row.threads),
                                       std::string(wordOf(row.simd)),
                                       grouped(f.covered),
                                       grouped(f.holes),
                                       grouped(f.spills),
                                       grouped(f.wrongSurface()),
                                       grouped(f.depthBitsDiffer),
                                       grouped(f.maxDepthSteps),
                                       grouped(f.lostTriangles),
                                       grouped(row.falseCulls),
                                       verdictOf(row)};
        if (judgesColours) {
            cells.insert(cells.end() - 1, {row.colours ? grouped(row.colours->wrong) : "-",
                                           row.colours ? std::to_string(row.colours->maxChannel) : "-"});
        }
        table.row(std::move(cells));
    }
    return table.text();
}

Json jsonOf(const std::vector<VerifyRow>& rows)
{
    Json list = Json::array();
    for (const VerifyRow& row : rows) {
        const ErrorFigures& f = row.figures;
        list.push_back({{"algorithm", row.algorithm},
                        {"exact", row.claim == Claim::Exact},
                        {"threads", row.threads},
                        {"simd", wordOf(row.simd)},
                        {"covered", f.covered},
                        {"holes", f.holes},
                        {"spills", f.spills},
                        {"wrong_surface", f.wrongSurface()},
                        {"depth_bits_differ", f.depthBitsDiffer},
                        {"max_depth_steps", f.maxDepthSteps},
                        {"lost_triangles", f.lostTriangles},
                        {"false_culls", row.falseCulls}});
        if (row.colours) {
            list.back()["wrong_colours"]          = row.colours->wrong;
            list.back()["max_channel_difference"] = row.colours->maxChannel;
        }
    }
    return list;
}

Result<Exit> verifyScene(const VerifyOptions& options, Session& session)
{
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    const Result<How> how = options.how.read();
    if (!how) return how.error();
    std::optional<std::uint64_t> samples;
    if (options.sample) {
        const auto count = wholeNumber(*options.sample, "--sample", 1, kMaxSamples);
        if (!count) return count.error();
        samples = static_cast<std::uint64_t>(*count);
    }
    const Result<LoadedScene> scene = options.scene.prepare(session, how->memoryLimit);
    if (!scene) return scene.error();
    const auto view = words->of(*scene->scene);
    if (!view) return view.error();

    VerifyRequest request{.scene       = scene->prepared,
                          .camera      = view->camera,
                          .faceCulling = view->faceCulling,
                          .algorithms  = {},
                          .threads     = {how->threads},
                          .simd        = {how->simd},
                          .shortcuts   = how->shortcuts,
                          .samples     = samples,
                          .memoryLimit = how->memoryLimit,
                          .progress    = session.progress()};
    for (const NamedPipeline& algorithm : how->algorithms)
        request.algorithms.push_back({algorithm.name, {}, algorithm.pipeline, algorithm.claim});

    const auto rows = verify(request);
    if (!rows) return rows.error();
    session.print(options.json ? textOf(jsonOf(*rows)) : tableOf(*rows));
    return std::ranges::all_of(*rows, &VerifyRow::passed) ? Exit::Done : Exit::CheckFailed;
}

}  // namespace

Command addVerify(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("verify", "Compare algorithms with the brute-force reference");
    auto      options = std::make_shared<VerifyOptions>();
    options->scene.add(*parser);
    options->view.add(*parser);
    options->how.add(*parser, HowOptions::Algorithms::Several);
    parser->add_option("--sample", options->sample, "Compare N random pixels instead of all (for very large scenes)")
        ->type_name("N");
    parser->add_flag("--json", options->json, "JSON instead of a table");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = verifyScene(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
