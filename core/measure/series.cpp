#include "core/measure/series_json.h"

#include <algorithm>

#include "core/measure/strict_json.h"

namespace zscope {
namespace {

using Json = nlohmann::ordered_json;

/// One list per figure: a series is read column by column.
template <class Figure>
Json column(const Series& series, const Figure& figure)
{
    Json list = Json::array();
    for (const SeriesFrame& frame : series.frames) list.push_back(figure(frame));
    return list;
}

}  // namespace

std::vector<Lag> lagsOf(std::span<const SeriesFrame> frames, std::span<const int> cuts)
{
    std::vector<Lag> lags;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const auto first = frames.begin() + cuts[i];
        const auto end   = i + 1 < cuts.size() ? frames.begin() + cuts[i + 1] : frames.end();
        const auto right = std::find_if(first, end, [](const SeriesFrame& frame) { return frame.wrongPixels == 0u; });
        lags.push_back({cuts[i], right == end ? std::nullopt : std::optional(static_cast<int>(right - first))});
    }
    return lags;
}

double worstShare(const Series& series)
{
    double worst = 0;
    for (const SeriesFrame& frame : series.frames)
        if (const auto wrong = static_cast<double>(frame.wrongPixels.value_or(0)); wrong > 0)
            worst = std::max(worst, wrong / static_cast<double>(std::max<std::uint64_t>(frame.covered, 1)));
    return worst;
}

Json toJson(const Series& series)
{
    Json stages = Json::object(), counters = Json::object(), lags = Json::array();
    for (std::size_t i = 0; i < kStages.size(); ++i)
        stages[std::string(wordOf(kStages[i]))] =
            column(series, [i](const SeriesFrame& frame) { return frame.stageMs[i]; });
    for (std::size_t i = 0; i < series.counters.size(); ++i)
        counters[series.counters[i]] = column(series, [i](const SeriesFrame& frame) { return frame.counts[i]; });
    for (const Lag& lag : series.lags)
        lags.push_back({{"cut", lag.cut}, {"wrong_frames", lag.frames ? Json(*lag.frames) : Json(nullptr)}});
    return {{"ms", column(series, [](const SeriesFrame& frame) { return frame.ms; })},
            {"covered", column(series, [](const SeriesFrame& frame) { return frame.covered; })},
            {"wrong_pixels", column(series,
                                    [](const SeriesFrame& frame) {
                                        return frame.wrongPixels ? Json(*frame.wrongPixels) : Json(nullptr);
                                    })},
            {"chosen", column(series, [](const SeriesFrame& frame) { return frame.chosen; })},
            {"lags", std::move(lags)},
            {"stages", std::move(stages)},
            {"counters", std::move(counters)}};
}

Series seriesOf(const Json& json)
{
    Series      series;
    const Json& counters = json.at("counters");
    for (const auto& [name, values] : counters.items()) series.counters.push_back(name);
    for (std::size_t at = 0; at < listOf(json.at("ms")).size(); ++at) {
        SeriesFrame frame;
        frame.ms      = amountOf(json.at("ms").at(at));
        frame.covered = wholeOf<std::uint64_t>(json.at("covered").at(at));
        if (const Json& wrong = json.at("wrong_pixels").at(at); !wrong.is_null())
            frame.wrongPixels = wholeOf<std::uint64_t>(wrong);
        json.at("chosen").at(at).get_to(frame.chosen);
        for (std::size_t i = 0; i < kStages.size(); ++i)
            frame.stageMs[i] = json.at("stages").at(std::string(wordOf(kStages[i]))).at(at).get<double>();
        for (const std::string& name : series.counters)
            frame.counts.push_back(wholeOf<std::uint64_t>(counters.at(name).at(at)));
        series.frames.push_back(std::move(frame));
    }
    for (const Json& lag : listOf(json.at("lags"))) {
        const Json& frames = lag.at("wrong_frames");
        series.lags.push_back(
            {wholeOf<int>(lag.at("cut")), frames.is_null() ? std::nullopt : std::optional(wholeOf<int>(frames))});
    }
    return series;
}

}  // namespace zscope
