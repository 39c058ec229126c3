#include "core/lesson/lesson_facts.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "core/measure/error_figures.h"
#include "core/measure/reference.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

namespace {

using Value  = std::optional<FactValue>;
using Source = const FactSource&;

template <class Number>
Value number(Number value)
{
    return FactValue(static_cast<double>(value));
}
Value word(std::string_view text) { return FactValue(std::string(text)); }

const SweepState*   lineOf(Source s) { return s.state.sweep && s.state.sweep->y >= 0 ? &*s.state.sweep : nullptr; }
const PyramidQuery* queryOf(Source s)
{
    return s.state.hierarchy && s.state.hierarchy->query ? &*s.state.hierarchy->query : nullptr;
}
const NodeRow* nodeOf(Source s)
{
    return s.state.hierarchy && s.state.hierarchy->now >= 0
               ? &s.state.hierarchy->nodes[static_cast<std::size_t>(s.state.hierarchy->now)]
               : nullptr;
}

template <auto Member>
Value sizeInLine(Source s)
{
    const SweepState* line = lineOf(s);
    return line ? number((line->*Member).size()) : std::nullopt;
}
template <auto Member>
Value ofFirstEdge(Source s)
{
    const SweepState* line = lineOf(s);
    return line && !line->activeEdges.empty() ? number(line->activeEdges.front().*Member) : std::nullopt;
}
template <NodeVerdict verdict>
Value nodesOf(Source s)
{
    if (!s.state.hierarchy) return std::nullopt;
    return number(std::ranges::count(s.state.hierarchy->nodes, verdict, &NodeRow::verdict));
}
Value bucketOfLine(Source s)
{
    const SweepState* line = lineOf(s);
    return line ? number(line->edgesStarting[static_cast<std::size_t>(line->y)]) : std::nullopt;
}
Value edgesInTable(Source s)
{
    if (!s.state.sweep) return std::nullopt;
    double edges = 0;
    for (const int starting : s.state.sweep->edgesStarting) edges += starting;
    return number(edges);
}
Value slopeOfFirstEdge(Source s)
{
    const SweepState* line = lineOf(s);
    if (!line || line->activeEdges.empty()) return std::nullopt;
    const EdgeRow& edge = line->activeEdges.front();
    return number(static_cast<double>(edge.dx[0]) / static_cast<double>(edge.dx[1]));
}
/// The reference's picture, where the whole frame is drawn.
std::optional<ErrorFigures> errorsOf(Source s)
{
    const auto right = referencePicture(s.request.scene->scene(), s.request.camera, s.request.faceCulling);
    if (!right) return std::nullopt;
    return compare(*right, pictureOf(s.state.frame.visible));
}
Value wrongPixels(Source s)
{
    const auto errors = errorsOf(s);
    return errors ? number(errors->wrongPixels()) : std::nullopt;
}
Value holes(Source s)
{
    const auto errors = errorsOf(s);
    return errors ? number(errors->holes) : std::nullopt;
}
template <class Read>
Value ofPicture(Source s, const Read& read)
{
    const VisibilityBuffer& visible = s.state.frame.visible;
    for (int y = 0; y < s.request.camera.height; ++y)
        for (int x = 0; x < s.request.camera.width; ++x) read(visible.idAt(x, y), s.state.tests.at(x, y));
    return std::nullopt;
}
Value covered(Source s)
{
    double pixels = 0;
    ofPicture(s, [&](std::int64_t id, std::uint32_t) { pixels += id >= 0; });
    return number(pixels);
}
Value visibleTriangles(Source s)
{
    std::set<std::int64_t> seen;
    ofPicture(s, [&](std::int64_t id, std::uint32_t) {
        if (id >= 0) seen.insert(id);
    });
    return number(seen.size());
}
Value tests(Source s)
{
    double all = 0;
    ofPicture(s, [&](std::int64_t, std::uint32_t tests) { all += tests; });
    return number(all);
}

constexpr std::array kFacts{
    // The sweep
    FactEntry{"line", "the line that the sweep has reached, from 0 at the top", false,
              [](Source s) { return lineOf(s) ? number(lineOf(s)->y) : std::nullopt; }},
    FactEntry{"active-edges", "edges in the active edge table", false, sizeInLine<&SweepState::activeEdges>},
    FactEntry{"active-polygons", "polygons that are active on this line", false,
              sizeInLine<&SweepState::activePolygons>},
    FactEntry{"edges-entered", "edges that entered since the line before", false, sizeInLine<&SweepState::entered>},
    FactEntry{"edges-left", "edges that left since the line before", false, sizeInLine<&SweepState::left>},
    FactEntry{"spans", "spans filled on this line so far", false, sizeInLine<&SweepState::spans>},
    FactEntry{"bucket", "edges in the edge table's bucket of this line", false, bucketOfLine},
    FactEntry{"edges-in-table", "edges in all buckets of the edge table", false, edgesInTable},
    FactEntry{"first-edge-x", "x of the leftmost active edge, in pixels", false, ofFirstEdge<&EdgeRow::x>},
    FactEntry{"first-edge-dx", "what the leftmost active edge moves by per line, in pixels", false, slopeOfFirstEdge},
    FactEntry{"first-edge-last-line", "the last line of the leftmost active edge", false,
              ofFirstEdge<&EdgeRow::lastLine>},
    FactEntry{"first-edge-polygon", "the polygon of the leftmost active edge", false,
              [](Source s) {
                  return lineOf(s) && !lineOf(s)->activeEdges.empty()
                             ? number(lineOf(s)->activeEdges.front().polygon.value)
                             : std::nullopt;
              }},
    // Intervals and spans
    FactEntry{"interval-start", "first pixel of the interval", false,
              [](Source s) { return s.state.interval ? number(s.state.interval->x0) : std::nullopt; }},
    FactEntry{
        "interval-width", "pixels of the interval", false,
        [](Source s) { return s.state.interval ? number(s.state.interval->x1 - s.state.interval->x0) : std::nullopt; }},
    FactEntry{"interval-open", "polygons that are open in the interval", false,
              [](Source s) { return s.state.interval ? number(s.state.interval->open.size()) : std::nullopt; }},
    FactEntry{"interval-winner", "the polygon that gets the interval as a whole, or -1", false,
              [](Source s) {
                  return s.state.interval ? number(
                             s.state.interval->winner ? static_cast<double>(s.state.interval->winner->value) : -1)
                                          : std::nullopt;
              }},
    FactEntry{"interval-reason", "why the interval was decided as it was", true,
              [](Source s) { return s.state.interval ? word(wordOf(s.state.interval->reason)) : std::nullopt; }},
    FactEntry{"span-start", "first pixel of the span", false,
              [](Source s) { return s.state.span ? number(s.state.span->x0) : std::nullopt; }},
    FactEntry{"span-width", "pixels of the span", false,
              [](Source s) { return s.state.span ? number(s.state.span->x1 - s.state.span->x0) : std::nullopt; }},
    FactEntry{"span-polygon", "the polygon of the span", false,
              [](Source s) { return s.state.span ? number(s.state.span->polygon.value) : std::nullopt; }},
    // The depth test
    FactEntry{"test-result", "how the depth test ended", true,
              [](Source s) { return s.state.pixel ? word(s.state.pixel->won ? "won" : "lost") : std::nullopt; }},
    FactEntry{"test-depth", "the depth that was tested", false,
              [](Source s) { return s.state.pixel ? number(s.state.pixel->depth) : std::nullopt; }},
    FactEntry{"rival-depth", "the depth that the pixel held", false,
              [](Source s) { return s.state.pixel ? number(s.state.pixel->rivalDepth) : std::nullopt; }},
    FactEntry{"test-triangle", "the triangle that was tested", false,
              [](Source s) { return s.state.pixel ? number(s.state.pixel->triangle.value) : std::nullopt; }},
    FactEntry{"triangle", "the triangle that is being drawn", false,
              [](Source s) { return s.state.triangle ? number(s.state.triangle->triangle.value) : std::nullopt; }},
    FactEntry{"triangle-pixels", "pixels that the triangle has won", false,
              [](Source s) { return s.state.triangle ? number(s.state.triangle->pixelsWon) : std::nullopt; }},
    // The pyramid
    FactEntry{"pyramid-levels", "levels of the pyramid, level 0 included", false,
              [](Source s) {
                  return s.state.hierarchy && !s.state.hierarchy->levels.empty()
                             ? number(s.state.hierarchy->levels.size())
                             : std::nullopt;
              }},
    FactEntry{"query-verdict", "the answer of the pyramid", true,
              [](Source s) { return queryOf(s) ? word(queryOf(s)->hidden ? "hidden" : "entered") : std::nullopt; }},
    FactEntry{"query-level", "the level at which the question began", false,
              [](Source s) { return queryOf(s) ? number(queryOf(s)->level) : std::nullopt; }},
    FactEntry{"query-cells", "cells and pixels that were read for the answer", false,
              [](Source s) { return queryOf(s) ? number(queryOf(s)->cells) : std::nullopt; }},
    FactEntry{"query-value", "the farthest depth found on that level", false,
              [](Source s) { return queryOf(s) ? number(queryOf(s)->value) : std::nullopt; }},
    FactEntry{"query-nearest", "the nearest depth that what was asked about can have", false,
              [](Source s) { return queryOf(s) ? number(queryOf(s)->nearest) : std::nullopt; }},
    FactEntry{"query-width", "width of the rectangle, in pixels", false,
              [](Source s) { return queryOf(s) ? number(queryOf(s)->box.x1 - queryOf(s)->box.x0) : std::nullopt; }},
    FactEntry{"query-height", "height of the rectangle, in pixels", false,
              [](Source s) { return queryOf(s) ? number(queryOf(s)->box.y1 - queryOf(s)->box.y0) : std::nullopt; }},
    FactEntry{"query-about", "what the pyramid was asked about", true,
              [](Source s) { return queryOf(s) ? word(s.state.hierarchy->asked) : std::nullopt; }},
    FactEntry{"update-level", "the level of the cell that was written", false,
              [](Source s) {
                  return s.state.hierarchy && s.state.hierarchy->update ? number(s.state.hierarchy->update->level)
                                                                        : std::nullopt;
              }},
    FactEntry{"update-changed", "whether the cell's value is another than before", true,
              [](Source s) {
                  return s.state.hierarchy && s.state.hierarchy->update ? word(
                             s.state.hierarchy->update->before != s.state.hierarchy->update->after ? "yes" : "no")
                                                                        : std::nullopt;
              }},
    FactEntry{"climb", "cells on the way up that ends at the cell written last", false,
              [](Source s) {
                  return s.state.hierarchy && s.state.hierarchy->update ? number(s.state.hierarchy->climb.size())
                                                                        : std::nullopt;
              }},
    // The hierarchy
    FactEntry{"node-verdict", "what became of the node judged last", true,
              [](Source s) { return nodeOf(s) ? word(wordOf(nodeOf(s)->verdict)) : std::nullopt; }},
    FactEntry{"node-depth", "levels from the root to the node judged last", false,
              [](Source s) { return nodeOf(s) ? number(nodeOf(s)->depth) : std::nullopt; }},
    FactEntry{"nodes-known", "nodes that the visit has come to know", false,
              [](Source s) { return s.state.hierarchy ? number(s.state.hierarchy->nodes.size()) : std::nullopt; }},
    FactEntry{"nodes-outside", "nodes outside the view", false, nodesOf<NodeVerdict::Outside>},
    FactEntry{"nodes-hidden", "nodes that the pyramid hides", false, nodesOf<NodeVerdict::Hidden>},
    FactEntry{"nodes-drawn", "nodes whose own triangles were drawn", false, nodesOf<NodeVerdict::Drawn>},
    FactEntry{"nodes-waiting", "nodes that are known and have not been judged", false, nodesOf<NodeVerdict::Waiting>},
    // The picture at this step
    FactEntry{"covered", "pixels that show a triangle", false, covered},
    FactEntry{"visible-triangles", "triangles that own a pixel", false, visibleTriangles},
    FactEntry{"tests", "depth tests so far, of all pixels", false, tests},
    FactEntry{"wrong-pixels", "pixels that show something else than the reference", false, wrongPixels},
    FactEntry{"holes", "pixels that show background where the reference shows a triangle", false, holes},
    FactEntry{
        "picked-owner", "the triangle at the picked pixel, or -1", false,
        [](Source s) { return s.pick ? number(s.state.frame.visible.idAt(s.pick->x, s.pick->y)) : std::nullopt; }},
    FactEntry{
        "picked-depth", "near/z at the picked pixel", false,
        [](Source s) { return s.pick ? number(s.state.frame.visible.depthAt(s.pick->x, s.pick->y)) : std::nullopt; }},
    FactEntry{"picked-tests", "depth tests at the picked pixel", false,
              [](Source s) { return s.pick ? number(s.state.tests.at(s.pick->x, s.pick->y)) : std::nullopt; }},
    FactEntry{"picked-covering", "triangles that cover the picked pixel, seen or not", false,
              [](Source s) -> Value {
                  if (!s.pick) return std::nullopt;
                  const auto all =
                      coveringTriangles(s.request.scene->scene(), s.request.camera, s.request.faceCulling, *s.pick);
                  return all ? number(all->size()) : std::nullopt;
              }},
    // The run
    FactEntry{"scene-triangles", "triangles of the scene", false,
              [](Source s) { return number(s.request.scene->scene().triangleCount()); }},
    FactEntry{"steps", "steps of this grain", false, [](Source s) { return number(s.state.count); }},
};

constexpr std::array kPixelFacts{
    PixelFactEntry{"owner", "the triangle that it shows, or -1"},
    PixelFactEntry{"tests", "depth tests so far"},
    PixelFactEntry{"depth", "near/z, 0 for background"},
    PixelFactEntry{"wrong", "1 where the reference shows something else, otherwise 0"},
};

constexpr std::string_view kWork = "work.";

Result<FactValue> workOf(std::string_view name, Source s)
{
    Renderer   renderer;
    const auto work = renderer.count(s.request);
    if (!work) return work.error();
    const auto counter = std::ranges::find(work->counters, name, &NamedCount::name);
    if (counter == work->counters.end()) return Error{Trouble::Input, fmt::format("there is no counter '{}'", name)};
    return FactValue(static_cast<double>(counter->value));
}

}  // namespace

std::span<const FactEntry>      facts() { return kFacts; }
std::span<const PixelFactEntry> pixelFacts() { return kPixelFacts; }

bool isFact(std::string_view word)
{
    return word.starts_with(kWork) || std::ranges::find(kFacts, word, &FactEntry::word) != kFacts.end();
}

Result<FactValue> factOf(std::string_view word, Source source)
{
    if (word.starts_with(kWork)) return workOf(word.substr(kWork.size()), source);
    const auto entry = std::ranges::find(kFacts, word, &FactEntry::word);
    if (entry == kFacts.end()) return Error{Trouble::Input, fmt::format("there is no fact '{}'", word)};
    if (const auto value = entry->read(source)) return *value;
    return Error{Trouble::Input, fmt::format("at this step there is no '{}' ({})", entry->word, entry->title)};
}

Result<Grid<double>> pixelFactOf(std::string_view word, Source source)
{
    const Camera& camera = source.request.camera;
    Picture       right;
    if (word == "wrong") {
        auto picture = referencePicture(source.request.scene->scene(), camera, source.request.faceCulling);
        if (!picture) return picture.error();
        right = std::move(*picture);
    }
    const VisibilityBuffer& visible = source.state.frame.visible;
    Grid<double>            values(camera.width, camera.height, 0.0);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const std::int64_t id = visible.idAt(x, y);
            double&            to = values.at(x, y);
            if (word == "owner")
                to = static_cast<double>(id);
            else if (word == "tests")
                to = source.state.tests.at(x, y);
            else if (word == "depth")
                to = visible.depthAt(x, y);
            else if (word == "wrong")
                to = id != right.ids.at(x, y);
            else
                return Error{Trouble::Input, fmt::format("there is no fact '{}' of pixels", word)};
        }
    return values;
}

}  // namespace zscope
