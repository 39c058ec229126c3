#include <array>

#include <nlohmann/json.hpp>

#include "core/lesson/explain.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const std::optional<TriangleId>& id) { return id ? Json(id->value) : Json(nullptr); }

Json toJson(const NodeName& node)
{
    return {{"instance", node.instance ? Json(node.instance->value) : Json(nullptr)}, {"path", node.path}};
}

Json toJson(const PixelBox& box) { return {box.x0, box.y0, box.x1, box.y1}; }

/// Only the grains that the method has: nobody can step by the others.
Json toJson(const Moment& moment, const std::vector<Grain>& grains)
{
    Json json = Json::object();
    for (const Grain grain : grains) json[std::string(wordOf(grain))] = moment.at(grain).value;
    return json;
}

std::string_view wordOf(SetUp fate)
{
    constexpr std::array<std::string_view, 8> words{"drawn",       "transparent", "outside",         "clipped-away",
                                                    "back-facing", "degenerate",  "no-pixel-centre", "out-of-range"};
    return words[static_cast<std::size_t>(fate)];
}

Json toJson(const Event& e, const std::vector<Grain>& grains)
{
    Json json{{"event", wordOf(e.happening)},
              {"grain", wordOf(e.grain)},
              {"steps", toJson(e.moment, grains)},
              {"sentence", e.sentence}};
    if (e.isPrepass) json["prepass"] = true;
    if (e.pass > 0) json["pass"] = e.pass;
    if (e.unmovedDepth) json["unmoved_depth"] = *e.unmovedDepth;
    if (e.pixel) json["pixel"] = {e.pixel->x, e.pixel->y};
    if (e.node) json["node"] = toJson(*e.node);
    if (e.query)
        json["query"] = {{"rectangle", toJson(e.query->box)}, {"level", e.query->level},
                         {"value", e.query->value},           {"nearest", e.query->nearest},
                         {"cells_read", e.query->cells},      {"hidden", e.query->hidden}};
    if (e.tile)
        json["tile"] = {
            {"rectangle", toJson(e.tile->box)}, {"nearest", e.tile->nearest}, {"farthest", e.tile->farthest}};
    if (e.interval)
        json["interval"] = {
            {"line", e.interval->y0}, {"x0", e.interval->x0}, {"x1", e.interval->x1}, {"reason", wordOf(e.reason)}};
    switch (e.happening) {
        case Happening::SetUp:
            json["set_up"] = wordOf(e.setUp);
            json["cut"]    = e.isCut;
            break;
        case Happening::Won:
        case Happening::Lost:
        case Happening::Overtaken:
        case Happening::IntervalLost:
            json["rival"]       = toJson(e.rival);
            json["rival_depth"] = e.rivalDepth;
            [[fallthrough]];
        case Happening::IntervalWon:
            json["depth"] = e.depth;
            break;
        default:
            break;
    }
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

/// Names come from files, which may hold any bytes.
std::string textOf(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string_view wordOf(Happening happening)
{
    constexpr std::array<std::string_view, 15> words{
        "set-up",          "node-outside",    "node-hidden",   "node-small", "node-entered", "node-recalled",
        "triangle-hidden", "triangle-passed", "tile-rejected", "discarded",  "won",          "lost",
        "overtaken",       "interval-won",    "interval-lost"};
    return words[static_cast<std::size_t>(happening)];
}

std::string_view wordOf(PixelFate fate)
{
    constexpr std::array<std::string_view, 18> words{
        "winner",        "overwritten",   "farther",         "lost-tie",    "interval-lost", "hole",
        "beyond-far",    "tile-rejected", "triangle-hidden", "node-hidden", "node-outside",  "node-small",
        "batch-outside", "back-face",     "near-clip",       "not-filled",  "blended",       "behind-opaque"};
    return words[static_cast<std::size_t>(fate)];
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
    const TriangleTally& t = e.tally;
    Json                 json{{"algorithm", e.algorithm},
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
    json["pixels"]   = {{"covered", t.covered},
                        {"shown", t.shown},
                        {"tested", t.tested},
                        {"passed", t.passed},
                        {"prepass_tested", t.prepassTested},
                        {"prepass_passed", t.prepassPassed},
                        {"in_holes", t.inHoles},
                        {"beyond_far", t.beyondFar},
                        {"back_facing", t.backFacing},
                        {"tile_rejected", t.tileRejected},
                        {"interval_won", t.intervalWon},
                        {"interval_lost", t.intervalLost}};
    json["taken_by"] = Json::array();
    for (const Taker& taker : e.takers) json["taken_by"].push_back({{"id", taker.id}, {"pixels", taker.pixels}});
    json["taken_by_others"] = e.otherTakers;
    json["events"]          = Json::array();
    for (const Event& event : e.events) json["events"].push_back(toJson(event, e.grains));
    json["events_left_out"] = e.leftOut;
    return textOf(json);
}

}  // namespace zscope
