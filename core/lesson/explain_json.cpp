#include <array>
#include <type_traits>
#include <variant>

#include <nlohmann/json.hpp>

#include "core/lesson/explain.h"
#include "core/lesson/explain_sentences.h"

namespace zscope {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const std::optional<TriangleId>& id) { return id ? Json(id->value) : Json(nullptr); }

Json toJson(const NodeName& node)
{
    return {{"instance", node.instance ? Json(node.instance->value) : Json(nullptr)}, {"path", node.path}};
}

/// Only the grains that the method has: nobody can step by the others.
Json toJson(const Moment& moment, const std::vector<Grain>& grains)
{
    Json json = Json::object();
    for (const Grain grain : grains) json[std::string(wordOf(grain))] = moment.at(grain).value;
    return json;
}

Json toJson(const Values& values);

Json toJson(const Value& value)
{
    return std::visit(
        [](const auto& each) {
            if constexpr (std::is_same_v<std::decay_t<decltype(each)>, Values>)
                return toJson(each);
            else
                return Json(each);
        },
        value);
}

Json toJson(const Values& values)
{
    Json json = Json::object();
    for (const auto& [name, value] : values) json[std::string(name)] = toJson(value);
    return json;
}

Json toJson(const Event& e, const std::vector<Grain>& grains)
{
    Json json{
        {"event", e.word}, {"grain", wordOf(e.grain)}, {"steps", toJson(e.moment, grains)}, {"sentence", e.sentence}};
    if (e.isPrepass) json["prepass"] = true;
    if (e.pass > 0) json["pass"] = e.pass;
    if (e.unmovedDepth) json["unmoved_depth"] = *e.unmovedDepth;
    if (e.pixel) json["pixel"] = {e.pixel->x, e.pixel->y};
    if (e.node) json["node"] = toJson(*e.node);
    for (const auto& [name, value] : e.values) json[std::string(name)] = toJson(value);
    if (e.rivalDepth) {
        json["rival"]       = toJson(e.rival);
        json["rival_depth"] = *e.rivalDepth;
    }
    if (isTest(e.effect) && e.effect != Effect::IsAbsent) json["depth"] = e.depth;
    return json;
}

Json toJson(const PixelCandidate& c, const std::vector<Grain>& grains)
{
    Json json{{"triangle", c.triangle.value}, {"drawn_as", c.drawnAs.value}, {"instance", c.instance.value}};
    json["cover"]        = c.cover ? Json(wordOf(*c.cover)) : Json(nullptr);
    json["depth"]        = c.depth;
    json["opacity"]      = c.opacity;
    json["fate"]         = wordOf(c.fate);
    json["rival"]        = toJson(c.rival);
    json["steps_behind"] = c.stepsBehind;
    json["node"]         = c.node ? toJson(*c.node) : Json(nullptr);
    json["sentence"]     = c.sentence;
    json["decisive"]     = c.decisive ? Json(*c.decisive) : Json(nullptr);
    json["events"]       = Json::array();
    for (const Event& event : c.events) json["events"].push_back(toJson(event, grains));
    return json;
}

Json wordsOf(const std::vector<Grain>& grains)
{
    Json list = Json::array();
    for (const Grain grain : grains) list.push_back(wordOf(grain));
    return list;
}

/// What is counted by the definition, and by the names that have always a place; then other names as they turned up.
Json pixelsOf(const TriangleTally& t)
{
    Json       json{{"covered", t.covered}, {"shown", t.shown}};
    const auto count = [&](std::string_view name) { json[std::string(name)] = t.of(name); };
    for (const std::string_view name : {"tested", "passed", "prepass_tested", "prepass_passed"}) count(name);
    json["in_holes"]    = t.inHoles;
    json["beyond_far"]  = t.beyondFar;
    json["back_facing"] = t.backFacing;
    for (const std::string_view name : {"tile_rejected", "interval_won", "interval_lost"}) count(name);
    for (const auto& [name, pixels] : t.counted) json[std::string(name)] = pixels;
    return json;
}

/// Names come from files, which may hold any bytes.
std::string textOf(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string_view wordOf(SetUp setUp)
{
    constexpr std::array<std::string_view, 8> words{"drawn",       "transparent", "outside",         "clipped-away",
                                                    "back-facing", "degenerate",  "no-pixel-centre", "out-of-range"};
    return words[static_cast<std::size_t>(setUp)];
}

std::string explanationToJson(const PixelExplanation& e)
{
    Json json{{"algorithm", e.algorithm},  {"pixel", {e.pixel.x, e.pixel.y}}, {"winner", e.winner},
              {"depth", e.depth},          {"sentence", e.sentence},          {"grains", wordsOf(e.grains)},
              {"triangles", Json::array()}};
    for (const PixelCandidate& c : e.candidates) json["triangles"].push_back(toJson(c, e.grains));
    return textOf(json);
}

std::string explanationToJson(const TriangleExplanation& e)
{
    Json json{{"algorithm", e.algorithm},
              {"triangle", e.triangle.value},
              {"drawn_as", e.drawnAs.value},
              {"instance", e.instance.value},
              {"mesh", e.mesh},
              {"material", e.material},
              {"transparent", e.isTransparent},
              {"opacity", e.opacity},
              {"fate", wordOf(e.fate)},
              {"sentence", e.sentence},
              {"grains", wordsOf(e.grains)}};
    json["pixels"]   = pixelsOf(e.tally);
    json["taken_by"] = Json::array();
    for (const Taker& taker : e.takers) json["taken_by"].push_back({{"id", taker.id}, {"pixels", taker.pixels}});
    json["taken_by_others"] = e.otherTakers;
    json["events"]          = Json::array();
    for (const Event& event : e.events) json["events"].push_back(toJson(event, e.grains));
    json["events_left_out"] = e.leftOut;
    return textOf(json);
}

}  // namespace zscope
