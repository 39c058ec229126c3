#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/lesson/replay.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const SourceLine& line)
{
    return {{"file", line.fileFromRoot()}, {"line", line.line}, {"function", line.function}};
}

Json toJson(const EdgeRow& edge)
{
    return {{"polygon", edge.polygon.value},  {"x", edge.x},
            {"x_subpixels", edge.xSubpixels}, {"dx", edge.dx},
            {"first_line", edge.firstLine},   {"last_line", edge.lastLine}};
}

Json toJson(const SpanRow& span) { return {{"x0", span.x0}, {"x1", span.x1}, {"polygon", span.polygon.value}}; }

Json toJson(const PixelState& pixel)
{
    Json json{
        {"x", pixel.x}, {"y", pixel.y}, {"triangle", pixel.triangle.value}, {"depth", pixel.depth}, {"won", pixel.won}};
    json["rival"]  = pixel.rival ? Json{{"triangle", pixel.rival->value}, {"depth", pixel.rivalDepth}} : Json(nullptr);
    json["shaded"] = pixel.shaded;
    json["discarded"] = pixel.discarded;
    if (pixel.unmovedDepth) json["unmoved_depth"] = *pixel.unmovedDepth;
    return json;
}

Json toJson(const TileTested& tile)
{
    return {{"rectangle", {tile.box.x0, tile.box.y0, tile.box.x1, tile.box.y1}},
            {"triangle", tile.triangle.value},
            {"nearest", tile.nearest},
            {"farthest", tile.farthest},
            {"rejected", tile.rejected}};
}

/// "#rrggbb"
std::string hexOf(std::uint32_t colour) { return fmt::format("#{:06x}", colour & 0xFFFFFFu); }

Json toJson(const BlendState& blend)
{
    return {{"x", blend.x},
            {"y", blend.y},
            {"surfaces", blend.surfaces},
            {"before", hexOf(blend.before)},
            {"after", hexOf(blend.after)}};
}

Json toJson(const TriangleState& triangle)
{
    return {{"id", triangle.triangle.value}, {"corners", triangle.corners}, {"pixels_won", triangle.pixelsWon}};
}

Json toJson(const NodeRow& node)
{
    Json json{{"id", node.id},
              {"parent", node.parent},
              {"depth", node.depth},
              {"verdict", wordOf(node.verdict)},
              {"box",
               {{"min", {node.box.min.x, node.box.min.y, node.box.min.z}},
                {"max", {node.box.max.x, node.box.max.y, node.box.max.z}}}},
              {"path", node.path}};
    json["instance"] = node.instance ? Json(node.instance->value) : Json(nullptr);
    if (node.pass > 0) json["pass"] = node.pass;
    return json;
}

template <class Values>
Json listOf(const Values& values)
{
    Json list = Json::array();
    for (const auto& value : values) list.push_back(toJson(value));
    return list;
}

void addSweep(Json& json, const SweepState& sweep)
{
    json["line"]         = sweep.y;
    json["active_edges"] = listOf(sweep.activeEdges);
    Json polygons        = Json::array();
    for (const TriangleId polygon : sweep.activePolygons) polygons.push_back(polygon.value);
    json["active_polygons"] = std::move(polygons);
    json["spans"]           = listOf(sweep.spans);
    json["entered"]         = listOf(sweep.entered);
    json["left"]            = listOf(sweep.left);
}

Json toJson(const IntervalState& interval)
{
    Json open = Json::array();
    for (const TriangleId polygon : interval.open) open.push_back(polygon.value);
    Json json{{"line", interval.y}, {"x0", interval.x0}, {"x1", interval.x1}, {"open", std::move(open)}};
    json["winner"] = interval.winner ? Json(interval.winner->value) : Json(nullptr);
    json["reason"] = wordOf(interval.reason);
    return json;
}

/// Row by row, from the top.
Json rowsOf(const Grid<float>& cells)
{
    Json rows = Json::array();
    for (int y = 0; y < cells.height(); ++y)
        rows.push_back(Json(std::vector<float>(cells.view().row(y).begin(), cells.view().row(y).end())));
    return rows;
}

void addHierarchy(Json& json, const HierarchyState& hierarchy, PyramidCells cells)
{
    json["nodes"] = listOf(hierarchy.nodes);
    json["node"]  = hierarchy.now;
    if (hierarchy.pass > 0) json["pass"] = hierarchy.pass;
    json["query"] = nullptr;
    if (hierarchy.query) {
        const PyramidQuery& q = *hierarchy.query;
        json["query"]         = {{"asked", hierarchy.asked},
                                 {"triangle", hierarchy.askedAbout ? Json(hierarchy.askedAbout->value) : Json(nullptr)},
                                 {"rectangle", {q.box.x0, q.box.y0, q.box.x1, q.box.y1}},
                                 {"level", q.level},
                                 {"value", q.value},
                                 {"node_depth", q.nearest},
                                 {"cells_read", q.cells},
                                 {"verdict", q.hidden ? "hidden" : "entered"}};
    }
    json["update"] = nullptr;
    if (const auto& cell = hierarchy.update)
        json["update"] = {
            {"level", cell->level}, {"x", cell->x}, {"y", cell->y}, {"before", cell->before}, {"after", cell->after}};
    json["pyramid"] = {{"levels", hierarchy.levels}};
    if (cells == PyramidCells::Left) return;
    Json stored = Json::array();
    for (std::size_t i = 0; i < hierarchy.cells.size(); ++i)
        stored.push_back(
            {{"level", Pyramid::kTileLevel + static_cast<int>(i)}, {"farthest", rowsOf(hierarchy.cells[i])}});
    json["pyramid"]["stored"] = std::move(stored);
}

}  // namespace

std::string stateToJson(const StepState& state, PyramidCells cells)
{
    Json json{{"algorithm", state.algorithm}, {"grain", wordOf(state.grain)}, {"step", state.step.value},
              {"count", state.count},         {"sentence", state.sentence},   {"event", wordOf(state.event)},
              {"stage", wordOf(state.stage)}};
    json["source"] = {{"method", toJson(state.method)}, {"part", toJson(state.part)}};
    if (state.sweep) addSweep(json, *state.sweep);
    if (state.hierarchy) addHierarchy(json, *state.hierarchy, cells);
    if (state.triangle) json["triangle"] = toJson(*state.triangle);
    if (state.interval) json["interval"] = toJson(*state.interval);
    if (state.span) json["span"] = toJson(*state.span);
    if (state.tile) json["tile"] = toJson(*state.tile);
    if (state.pixel) json["pixel"] = toJson(*state.pixel);
    if (state.blend) json["blend"] = toJson(*state.blend);
    return json.dump(1) + "\n";
}

}  // namespace zscope
