// The way back: from benchToJson() to rows.
#include "core/measure/bench.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "core/frame/shortcuts.h"
#include "core/measure/series_json.h"
#include "core/measure/strict_json.h"

namespace zscope {
namespace {

using Json = nlohmann::ordered_json;

/// "inf" is infinite: JSON has no number for it.
double numberOf(const Json& json)
{
    return json.is_string() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

RelativeDistance distanceOf(const Json& json)
{
    return {numberOf(json.at("rms")), numberOf(json.at("p99")), numberOf(json.at("max"))};
}

ErrorFigures figuresOf(const Json& json, std::uint64_t pixels)
{
    ErrorFigures figures;
    figures.pixels  = pixels;
    const auto read = [&json](const char* name, auto& figure) {
        figure = wholeOf<std::remove_reference_t<decltype(figure)>>(json.at(name));
    };
    read("covered", figures.covered);
    read("holes", figures.holes);
    read("spills", figures.spills);
    read("near_ties", figures.nearTies);
    read("real_wrong_surface", figures.realWrongSurface);
    read("depth_bits_differ", figures.depthBitsDiffer);
    json.at("exact_share").get_to(figures.exactShare);
    read("p99_depth_steps", figures.p99DepthSteps);
    read("max_depth_steps", figures.maxDepthSteps);
    figures.distanceOnSameSurface  = distanceOf(json.at("distance_on_same_surface"));
    figures.distanceOnWrongSurface = distanceOf(json.at("distance_on_wrong_surface"));
    read("lost_triangles", figures.lostTriangles);
    read("false_culls", figures.falseCulls);
    return figures;
}

/// The value whose word it is. Words that nobody has are not in such a file.
template <class Value, std::size_t kCount>
Value valueOf(const Json& word, const std::array<Value, kCount>& values)
{
    const auto found =
        std::ranges::find_if(values, [&](Value value) { return wordOf(value) == word.get<std::string>(); });
    return found == values.end() ? throw Json::other_error::create(501, "unknown word", &word) : *found;
}

ShortcutSet shortcutsIn(const Json& words)
{
    const Result<ShortcutSet> set = shortcutsOf(words.get<std::string>());
    return set ? *set : throw Json::other_error::create(501, "unknown shortcut", &words);
}

BenchRow rowOf(const Json& json)
{
    BenchRow row;
    json.at("scene").get_to(row.scene);
    json.at("algorithm").get_to(row.algorithm);
    row.claim = valueOf(json.at("claim"), std::array{Claim::Exact, Claim::ExactByFace, Claim::Approximate});
    if (const Json& chosen = json.at("chosen"); chosen.is_string()) chosen.get_to(row.chosen);
    row.threads = wholeOf<int>(json.at("threads"));
    row.simd    = valueOf(json.at("simd"), std::array{Simd::Auto, Simd::Scalar, Simd::Sse4, Simd::Avx2, Simd::Avx512});
    if (json.contains("shortcuts"))  // older records have none
        row.shortcuts = shortcutsIn(json.at("shortcuts"));
    json.at("shaded").get_to(row.shaded);
    row.pixels = wholeOf<std::uint64_t>(json.at("pixels"));
    if (const Json& wrong = json.at("wrong_pixels"); !wrong.is_null()) row.wrongPixels = wholeOf<std::uint64_t>(wrong);
    if (json.contains("samples")) row.samples = wholeOf<std::uint64_t>(json.at("samples"));  // older records have none
    if (const Json& figures = json.at("figures"); !figures.is_null()) row.figures = figuresOf(figures, row.pixels);
    row.bestMs   = amountOf(json.at("best_ms"));
    row.medianMs = amountOf(json.at("median_ms"));
    row.q1Ms     = amountOf(json.at("q1_ms"));
    row.q3Ms     = amountOf(json.at("q3_ms"));
    if (json.contains("frames")) row.frames = wholeOf<std::uint64_t>(json.at("frames"));  // older records do not tell
    row.triangles    = wholeOf<std::uint64_t>(json.at("triangles"));
    row.load.readMs  = amountOf(json.at("read_ms"));
    row.load.parseMs = amountOf(json.at("parse_ms"));
    row.load.checkMs = amountOf(json.at("check_ms"));
    row.buildMs      = amountOf(json.at("build_ms"));
    row.bytes        = wholeOf<std::uint64_t>(json.at("bytes"));
    for (const Stage stage : kStages) {
        const auto        at = static_cast<std::size_t>(stage);
        const std::string word(wordOf(stage));
        const Json&       quartiles = json.at("stage_quartiles").at(word);
        row.stageMs[at]             = json.at("stages").at(word).get<double>();
        row.stageQuartiles[at]      = {quartiles.at("q1").get<double>(), quartiles.at("median").get<double>(),
                                       quartiles.at("q3").get<double>()};
    }
    for (const auto& [name, value] : json.at("counters").items())
        row.counters.push_back({name, wholeOf<std::uint64_t>(value)});
    if (json.contains("tallies"))  // older records have none
        for (const auto& [name, value] : json.at("tallies").items())
            row.tallies.push_back({name, wholeOf<std::uint64_t>(value)});
    for (const Json& each : listOf(json.at("round_ms"))) row.roundMs.push_back(amountOf(each));
    // older records have none
    if (json.contains("series") && !json.at("series").is_null()) row.series = seriesOf(json.at("series"));
    return row;
}

}  // namespace

Result<std::vector<BenchRow>> benchFromJson(const std::string& json)
{
    try {
        std::vector<BenchRow> rows;
        for (const Json all = Json::parse(json); const Json& each : listOf(all)) rows.push_back(rowOf(each));
        return rows;
    } catch (const Json::exception& error) {
        return Error{Trouble::Input, std::string("these are no rows of a benchmark: ") + error.what()};
    }
}

}  // namespace zscope
