// The way back: from benchToJson() to rows.
#include "core/measure/bench.h"

#include <algorithm>
#include <array>
#include <limits>

#include <nlohmann/json.hpp>

#include "core/measure/series_json.h"

namespace zscope {
namespace {

using Json = nlohmann::ordered_json;

/// "inf" is infinite: JSON has no number for it.
double numberOf(const Json& json) { return json.is_string() ? std::numeric_limits<double>::infinity() : json.get<double>(); }

RelativeDistance distanceOf(const Json& json) { return {numberOf(json.at("rms")), numberOf(json.at("p99")), numberOf(json.at("max"))}; }

ErrorFigures figuresOf(const Json& json, std::uint64_t pixels)
{
    ErrorFigures figures;
    figures.pixels = pixels;
    json.at("covered").get_to(figures.covered);
    json.at("holes").get_to(figures.holes);
    json.at("spills").get_to(figures.spills);
    json.at("near_ties").get_to(figures.nearTies);
    json.at("real_wrong_surface").get_to(figures.realWrongSurface);
    json.at("depth_bits_differ").get_to(figures.depthBitsDiffer);
    json.at("exact_share").get_to(figures.exactShare);
    json.at("p99_depth_steps").get_to(figures.p99DepthSteps);
    json.at("max_depth_steps").get_to(figures.maxDepthSteps);
    figures.distanceOnSameSurface  = distanceOf(json.at("distance_on_same_surface"));
    figures.distanceOnWrongSurface = distanceOf(json.at("distance_on_wrong_surface"));
    json.at("lost_triangles").get_to(figures.lostTriangles);
    json.at("false_culls").get_to(figures.falseCulls);
    return figures;
}

/// The value whose word it is. Words that nobody has are not in such a file.
template <class Value, std::size_t kCount>
Value valueOf(const Json& word, const std::array<Value, kCount>& values)
{
    const auto found = std::ranges::find_if(values, [&](Value value) { return wordOf(value) == word.get<std::string>(); });
    return found == values.end() ? throw Json::other_error::create(501, "unknown word", &word) : *found;
}

BenchRow rowOf(const Json& json)
{
    BenchRow row;
    json.at("scene").get_to(row.scene);
    json.at("algorithm").get_to(row.algorithm);
    row.claim = valueOf(json.at("claim"), std::array{Claim::Exact, Claim::ExactByFace, Claim::Approximate});
    if (const Json& chosen = json.at("chosen"); chosen.is_string()) chosen.get_to(row.chosen);
    json.at("threads").get_to(row.threads);
    row.simd = valueOf(json.at("simd"), std::array{Simd::Auto, Simd::Scalar, Simd::Sse4, Simd::Avx2, Simd::Avx512});
    json.at("shaded").get_to(row.shaded);
    json.at("pixels").get_to(row.pixels);
    if (const Json& wrong = json.at("wrong_pixels"); !wrong.is_null()) row.wrongPixels = wrong.get<std::uint64_t>();
    row.samples = json.value("samples", std::uint64_t{0});  // older records have none
    if (const Json& figures = json.at("figures"); !figures.is_null()) row.figures = figuresOf(figures, row.pixels);
    json.at("best_ms").get_to(row.bestMs);
    json.at("median_ms").get_to(row.medianMs);
    json.at("q1_ms").get_to(row.q1Ms);
    json.at("q3_ms").get_to(row.q3Ms);
    json.at("triangles").get_to(row.triangles);
    json.at("read_ms").get_to(row.load.readMs);
    json.at("parse_ms").get_to(row.load.parseMs);
    json.at("check_ms").get_to(row.load.checkMs);
    json.at("build_ms").get_to(row.buildMs);
    json.at("bytes").get_to(row.bytes);
    for (const Stage stage : kStages) {
        const auto        at   = static_cast<std::size_t>(stage);
        const std::string word(wordOf(stage));
        const Json&       quartiles = json.at("stage_quartiles").at(word);
        row.stageMs[at]        = json.at("stages").at(word).get<double>();
        row.stageQuartiles[at] = {quartiles.at("q1").get<double>(), quartiles.at("median").get<double>(), quartiles.at("q3").get<double>()};
    }
    for (const auto& [name, value] : json.at("counters").items()) row.counters.push_back({name, value.get<std::uint64_t>()});
    json.at("round_ms").get_to(row.roundMs);
    if (json.contains("series") && !json.at("series").is_null()) row.series = seriesOf(json.at("series"));  // older records have none
    return row;
}

}  // namespace

Result<std::vector<BenchRow>> benchFromJson(const std::string& json)
{
    try {
        std::vector<BenchRow> rows;
        for (const Json& each : Json::parse(json)) rows.push_back(rowOf(each));
        return rows;
    } catch (const Json::exception& error) {
        return Error{Trouble::Input, std::string("these are no rows of a benchmark: ") + error.what()};
    }
}

}  // namespace zscope
