// The active edge table, the active polygons and the spans of every line, as a lesson shows them, against whole-number
// arithmetic that knows nothing of a sweep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "tests/replay/replay_support.h"
#include "tests/replay/sweep_truth.h"

namespace zscope::tests {
namespace {

constexpr std::int64_t kFarAway = 1 << 29;  // subpixels; edges farther off are in no order among themselves

struct Sweep {
    SeenScene   seen;
    FaceCulling culling = FaceCulling::None;
};

std::vector<Sweep> sweeps()
{
    std::vector<Sweep> all{{builtinScene("teapot?tessellation=4", 96, 64)},
                           {builtinScene("teapot?tessellation=4", 33, 47), FaceCulling::Back},
                           {builtinScene("soccer-ball", 61, 40)},
                           {builtinScene("soccer-ball", 7, 90), FaceCulling::Back},
                           {builtinScene("cubes", 1, 50)},
                           {builtinScene("cubes", 50, 1)}};
    std::uint64_t      seed = 100;
    for (const SoupKind kind : soupKinds()) {
        ++seed;
        const int width = 17 + static_cast<int>(seed * 7 % 40), height = 13 + static_cast<int>(seed * 11 % 40);
        all.push_back(
            {soupScene(kind, seed, width, height, 60), seed % 3 == 0 ? FaceCulling::Back : FaceCulling::None});
    }
    return all;
}

using Row = std::tuple<std::uint32_t, std::int64_t, std::int64_t, std::int64_t, int, int>;

Row rowOf(const EdgeRow& e) { return {e.polygon.value, e.xSubpixels, e.dx[0], e.dx[1], e.firstLine, e.lastLine}; }
Row rowOf(const TrueEdge& e) { return {e.polygon, e.xFloor, e.dxNumerator, e.dxDenominator, e.firstLine, e.lastLine}; }

template <class Edges>
std::vector<Row> sortedRows(const Edges& edges)
{
    std::vector<Row> rows;
    for (const auto& edge : edges) rows.push_back(rowOf(edge));
    std::ranges::sort(rows);
    return rows;
}

std::vector<TrueEdge> only(const std::vector<TrueEdge>& edges, int TrueEdge::*line, int y)
{
    std::vector<TrueEdge> some;
    std::ranges::copy_if(edges, std::back_inserter(some), [&](const TrueEdge& e) { return e.*line == y; });
    return some;
}

/// The row's own x against the true edge that has the same row.
void expectPlace(const EdgeRow& row, const std::vector<TrueEdge>& truth)
{
    double nearest = HUGE_VAL;
    for (const TrueEdge& edge : truth)
        if (rowOf(edge) == rowOf(row)) nearest = std::min(nearest, std::abs(edge.pixels() - row.x));
    EXPECT_LE(nearest, std::max(1e-9, std::abs(row.x) * 0x1p-50))
        << "triangle " << row.polygon.value << " at " << row.x;
}

/// Every pair of neighbours in order, exactly inside the guard band and to the subpixel beyond. A row does not tell its
/// remainder, so rows are matched with true edges: among edges of the same row any will do.
void expectSorted(const std::vector<EdgeRow>& rows, const std::vector<TrueEdge>& truth)
{
    const auto rank = [](const EdgeRow& row) { return std::clamp(row.xSubpixels, -kFarAway, kFarAway); };
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_LE(rank(rows[i - 1]), rank(rows[i])) << "row " << i;
        if (rows[i - 1].xSubpixels == rows[i].xSubpixels) {
            const auto trueOf = [&](const EdgeRow& row) {
                return *std::ranges::find_if(truth, [&](const TrueEdge& e) { return rowOf(e) == rowOf(row); });
            };
            const TrueEdge left = trueOf(rows[i - 1]), right = trueOf(rows[i]);
            if (!left.isWide && !right.isWide) {
                EXPECT_TRUE(left.isNotRightOf(right)) << "row " << i;
            }
        }
    }
}

void expectSpans(const SweepState& state, const CoverOfLine& truth, int width)
{
    CoverOfLine cover;
    for (const SpanRow& span : state.spans) {
        ASSERT_LE(0, span.x0);
        ASSERT_LT(span.x0, span.x1);
        ASSERT_LE(span.x1, width);
        for (int x = span.x0; x < span.x1; ++x) ++cover[span.polygon.value][x];
    }
    EXPECT_EQ(cover, truth);
}

bool isOfTriangles(const Scene& scene)
{
    return std::ranges::all_of(scene.meshes,
                               [](const auto& mesh) { return mesh->triangles.size() == mesh->polygonCount(); });
}

using PixelsOfFaces = std::map<std::uint32_t, std::set<int>>;

/// Where an odd number of a face's active edges have been passed.
PixelsOfFaces oddByEdges(const std::vector<EdgeRow>& edges, int width)
{
    PixelsOfFaces odd;
    for (const EdgeRow& edge : edges)
        for (int x = 0; x < width; ++x) {
            // the first pixel whose centre is not left of the edge, and all to its right
            if (edge.x * 256 > 256 * x + 128) continue;
            std::set<int>& pixels = odd[edge.polygon.value];
            if (!pixels.insert(x).second) pixels.erase(x);
        }
    std::erase_if(odd, [](const auto& face) { return face.second.empty(); });
    return odd;
}

/// Where an odd number of a face's triangles cover a pixel.
PixelsOfFaces oddByTriangles(const Scene& scene, const CoverOfLine& cover)
{
    PixelsOfFaces odd;
    for (const auto& [triangle, pixels] : cover)
        for (const auto& [x, times] : pixels) {
            std::set<int>& ofFace = odd[scene.firstOfFace(TriangleId{triangle}).value];
            if (times % 2 != 0 && !ofFace.insert(x).second) ofFace.erase(x);
        }
    std::erase_if(odd, [](const auto& face) { return face.second.empty(); });
    return odd;
}

/// The sweep of a scene of whole faces: a face's edges are not those of its triangles, but enclose the same pixels.
void expectTrueFaces(const Sweep& sweep, const Preset& preset)
{
    SCOPED_TRACE(sweep.seen.what + ", " + std::string(preset.name));
    const Scene&     scene  = sweep.seen.scene->scene();
    const Camera&    camera = sweep.seen.camera;
    const SweepTruth truth(scene, camera, sweep.culling);
    DrawRequest      request = sweep.seen.request(preset.pipeline);
    request.faceCulling      = sweep.culling;
    Replay              replay(request);
    const std::uint64_t count = *replay.count(Grain::Line);
    std::size_t         above = 0, edges = 0, ofTriangles = 0;
    for (std::uint64_t k = 0; k < count; ++k) {
        const Result<StepState> at = replay.at(Grain::Line, StepIndex{k});
        ASSERT_TRUE(at.ok()) << at.error().text();
        if (at->event != Grain::Line) continue;
        const SweepState& state = *at->sweep;
        SCOPED_TRACE("line " + std::to_string(state.y));
        ASSERT_EQ(oddByEdges(state.activeEdges, camera.width), oddByTriangles(scene, truth.coverOf(state.y)));
        EXPECT_EQ(above + state.entered.size() - state.left.size(), state.activeEdges.size());

        std::set<TriangleId> named;
        for (const EdgeRow& row : state.activeEdges) named.insert(row.polygon);
        EXPECT_EQ(state.activePolygons, std::vector(named.begin(), named.end()));
        for (const TriangleId face : state.activePolygons)
            EXPECT_EQ(scene.firstOfFace(face), face) << "its first triangle";
        above = state.activeEdges.size();
        edges += above;
        ofTriangles += truth.activeOn(state.y).size();
    }
    EXPECT_LT(edges, ofTriangles) << "faces have fewer edges than their triangles";
}

/// The whole sweep of one scene, line by line.
void expectTrueSweep(const Sweep& sweep, const Preset& preset)
{
    SCOPED_TRACE(sweep.seen.what + ", " + std::string(preset.name));
    const Camera&    camera = sweep.seen.camera;
    const SweepTruth truth(sweep.seen.scene->scene(), camera, sweep.culling);
    DrawRequest      request = sweep.seen.request(preset.pipeline);
    request.faceCulling      = sweep.culling;
    Replay                replay(request);
    const std::uint64_t   count = *replay.count(Grain::Line);
    std::vector<TrueEdge> above;
    std::uint64_t         edges = 0;
    int                   lines = 0;
    for (std::uint64_t k = 0; k < count; ++k) {
        const Result<StepState> at = replay.at(Grain::Line, StepIndex{k});
        ASSERT_TRUE(at.ok()) << at.error().text();
        if (at->event != Grain::Line) continue;
        const SweepState& state = *at->sweep;
        const int         y     = lines++;
        SCOPED_TRACE("line " + std::to_string(y));
        ASSERT_EQ(state.y, y);
        const std::vector<TrueEdge> active = truth.activeOn(y);

        ASSERT_EQ(sortedRows(state.activeEdges), sortedRows(active));
        for (const EdgeRow& row : state.activeEdges) {
            EXPECT_GT(row.dx[1], 0);
            EXPECT_EQ(std::gcd(row.dx[0], row.dx[1]), 1);
            expectPlace(row, active);
        }
        expectSorted(state.activeEdges, active);

        std::set<std::uint32_t> polygons;
        for (const TrueEdge& edge : active) polygons.insert(edge.polygon);
        std::vector<std::uint32_t> shown;
        for (const TriangleId polygon : state.activePolygons) shown.push_back(polygon.value);
        EXPECT_EQ(shown, std::vector(polygons.begin(), polygons.end()));

        EXPECT_EQ(sortedRows(state.entered), sortedRows(only(active, &TrueEdge::firstLine, y)));
        EXPECT_EQ(sortedRows(state.left), sortedRows(only(above, &TrueEdge::lastLine, y - 1)));
        EXPECT_EQ(above.size() + state.entered.size() - state.left.size(), active.size());

        ASSERT_EQ(state.edgesStarting.size(), static_cast<std::size_t>(camera.height));
        EXPECT_EQ(static_cast<std::size_t>(state.edgesStarting[static_cast<std::size_t>(y)]), state.entered.size());
        edges += state.entered.size();
        if (y + 1 == camera.height) {
            EXPECT_EQ(std::accumulate(state.edgesStarting.begin(), state.edgesStarting.end(), std::uint64_t{0}), edges);
        }
        if (preset.name == "scanline") expectSpans(state, truth.coverOf(y), camera.width);
        above = active;
        if (::testing::Test::HasFailure()) return;  // one line tells enough
    }
    EXPECT_EQ(lines, camera.height);
}

TEST(SweepState, EveryLineHoldsExactlyTheEdgesPolygonsAndSpansOfTheDefinition)
{
    for (const Sweep& sweep : sweeps()) {
        for (const Preset& preset : presets()) {
            if (!drawsLineByLine(preset.pipeline)) continue;
            if (preset.claim == Claim::ExactByFace && !isOfTriangles(sweep.seen.scene->scene()))
                expectTrueFaces(sweep, preset);
            else
                expectTrueSweep(sweep, preset);
        }
        if (HasFailure()) return;
    }
}

TEST(SweepState, BeforeTheFirstLineTheTableIsThereAndNothingIsActive)
{
    for (const Preset& preset : presets()) {
        if (!drawsLineByLine(preset.pipeline)) continue;
        Replay                  replay(builtinScene("cubes", 40, 30).request(preset.pipeline));
        const Result<StepState> state = replay.at(Grain::Stage, StepIndex{0});
        ASSERT_TRUE(state.ok());
        ASSERT_TRUE(state->sweep.has_value());
        EXPECT_EQ(state->stage, Stage::Setup);
        EXPECT_EQ(state->sweep->y, -1);
        EXPECT_TRUE(state->sweep->activeEdges.empty() && state->sweep->activePolygons.empty());
        EXPECT_TRUE(state->sweep->entered.empty() && state->sweep->left.empty() && state->sweep->spans.empty());
        EXPECT_GT(std::accumulate(state->sweep->edgesStarting.begin(), state->sweep->edgesStarting.end(), 0), 0);
    }
}

TEST(SweepState, StreamMethodsHaveNoSweepAndSweepsHaveNoTriangleAtHand)
{
    for (const Preset& preset : presets()) {
        Replay                  replay(builtinScene("cubes", 40, 30).request(preset.pipeline));
        const Result<StepState> state = replay.at(Grain::Frame, StepIndex{0});
        ASSERT_TRUE(state.ok());
        EXPECT_EQ(state->sweep.has_value(), drawsLineByLine(preset.pipeline)) << preset.name;
        EXPECT_EQ(state->triangle.has_value(), !drawsLineByLine(preset.pipeline)) << preset.name;
    }
}

}  // namespace
}  // namespace zscope::tests
