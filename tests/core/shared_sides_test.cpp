// Sides that two triangles of a batch have in common: found when batches are made, entered in the edge table as one
// edge where nobody looks on. In every instruction set.
#include <cstddef>

#include "core/geometry/rules.h"
#include "core/geometry/triangle_list.h"
#include "core/sweep/edge_table.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/shared_sides_test.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/fast/lanes/enter_edges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

void enterAll(const TriangleList& triangles, EdgeTable& table) { EdgeEntry{table}(triangles); }

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <hwy/targets.h>

#include "core/geometry/batches.h"
#include "core/geometry/patches.h"
#include "core/scene/load.h"
#include "core/scene/mesh.h"

namespace zscope {

HWY_EXPORT(enterAll);

namespace {

constexpr int kSide = 64;  // of the picture, pixels

using Outline = std::array<std::uint32_t, 3>;

Mesh meshOf(const std::vector<dvec3>& positions, const std::vector<Outline>& triangles)
{
    Mesh mesh;
    mesh.materials = {Material{}};
    mesh.positions = positions;
    for (const Outline& outline : triangles) {
        mesh.trianglePolygon.push_back(PolygonId{static_cast<std::uint32_t>(mesh.triangles.size())});
        mesh.triangles.push_back(outline);
        mesh.corners.insert(mesh.corners.end(), outline.begin(), outline.end());
        mesh.firstCorner.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.firstTriangle.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
        mesh.polygonMaterial.push_back(MaterialId{0});
        mesh.polygonGroup.push_back({});
    }
    return mesh;
}

/// Who has the sides of a batch's triangles, by their corners' positions in the batch.
class Sides {
public:
    Sides(const MeshBatches& mesh, const Batch& batch)
    {
        for (std::uint32_t t = 0; t < batch.triangleCount; ++t)
            for (std::size_t k = 0; k < 3; ++k)
                if (const auto [from, to] = ends(mesh, batch, t, k); from != to) ++m_count[{from, to}];
    }
    static std::pair<int, int> ends(const MeshBatches& mesh, const Batch& batch, std::uint32_t t, std::size_t k)
    {
        return {mesh.corners[k][batch.firstTriangle + t], mesh.corners[(k + 1) % 3][batch.firstTriangle + t]};
    }
    int count(std::pair<int, int> side) const
    {
        const auto at = m_count.find(side);
        return at == m_count.end() ? 0 : at->second;
    }

private:
    std::map<std::pair<int, int>, int> m_count;
};

/// How many sides have a triangle beyond them.
std::size_t expectMutual(const MeshBatches& mesh)
{
    std::size_t found = 0;
    for (const Batch& batch : mesh.batches) {
        const Sides sides(mesh, batch);
        for (std::uint32_t t = 0; t < batch.triangleCount; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint16_t beyond   = mesh.beyond[k][batch.firstTriangle + t];
                const auto          side     = Sides::ends(mesh, batch, t, k);
                const auto          opposite = std::pair(side.second, side.first);
                if (beyond == MeshBatches::kNobody) {
                    const bool isPlain = sides.count(side) == 1 && sides.count(opposite) == 1;
                    EXPECT_FALSE(isPlain && side.first != side.second)
                        << "triangle " << t << ", side " << k << ": its neighbour was not found";
                    continue;
                }
                ++found;
                int mutual = 0;
                for (std::size_t j = 0; j < 3; ++j)
                    mutual += mesh.beyond[j][batch.firstTriangle + beyond] == t
                              && Sides::ends(mesh, batch, beyond, j) == opposite;
                EXPECT_LT(beyond, batch.triangleCount);
                EXPECT_EQ(mutual, 1) << "triangle " << t << ", side " << k;
            }
    }
    return found;
}

TEST(SidesOfBatches, EachOfTwoTrianglesNamesTheOther)
{
    std::mt19937_64 random(3);
    for (const std::uint32_t vertices : {4u, 12u, 60u, 900u}) {  // from everybody's neighbour to hardly anybody's
        std::vector<dvec3> positions;
        for (std::uint32_t v = 0; v < vertices; ++v)
            positions.emplace_back(random() % 100, random() % 100, random() % 100);
        std::vector<Outline> triangles(1500);
        for (auto& outline : triangles)
            // a corner may be another one, too
            for (auto& corner : outline) corner = static_cast<std::uint32_t>(random() % vertices);
        const Mesh        mesh  = meshOf(positions, triangles);
        const MeshBatches whole = makeBatches(mesh);
        EXPECT_GT(expectMutual(whole), vertices < 100 ? 200u : 0u) << vertices;
    }
}

TEST(SidesOfBatches, OfASurfaceNearlyAllHaveANeighbour)
{
    const Result<Scene> scene = loadScene("builtin:icosphere?frequency=40");
    const Mesh&         mesh  = scene.value().meshOf(InstanceId{0});
    const MeshBatches   whole = makeBatches(mesh), patched = patchedBatches(mesh, whole);
    ASSERT_FALSE(patched.batches.empty());
    for (const MeshBatches* batches : {&whole, &patched})
        EXPECT_GT(expectMutual(*batches), 3 * mesh.triangles.size() * 4 / 5);
}

class SharedEdges : public testing::TestWithParam<std::int64_t> {
protected:
    SharedEdges() { choose(GetParam()); }
    ~SharedEdges() override { choose(0); }

    static void choose(std::int64_t target)
    {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }

    /// The batch's triangles as set-up lists them: corners where their vertices' x and y say, in pixels, those of a
    /// front turned.
    static void list(const MeshBatches& mesh, TriangleList& out)
    {
        out.clear();
        out.mesh = &mesh, out.batch = &mesh.batches[0];
        for (std::uint32_t t = 0; t < out.batch->triangleCount; ++t) {
            std::array<int, 3> x, y;
            for (std::size_t k = 0; k < 3; ++k)
                x[k] = static_cast<int>(256 * mesh.x[mesh.corners[k][t]]),
                y[k] = static_cast<int>(256 * mesh.y[mesh.corners[k][t]]);
            const int area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
            if (area == 0) continue;
            const bool front = area < 0;  // y runs down
            if (front) std::swap(x[1], x[2]), std::swap(y[1], y[2]);
            const std::size_t i  = out.count++;
            const int         px = std::ranges::min(x) >> 8, py = std::ranges::min(y) >> 8;
            out.start[i]         = pixelsAndLines(px, py);
            out.end[i]           = pixelsAndLines((std::ranges::max(x) >> 8) + 1, (std::ranges::max(y) >> 8) + 1);
            out.kind[i]          = TriangleList::kCompact | (front ? TriangleList::kCounterClockwise : 0);
            out.notRank[i]       = ~(mesh.meshTriangle[t] + 1);
            out.thirdAndPlace[i] = t << 16;
            out.a[i] = out.b[i] = out.c[i] = 0, out.farthest[i] = out.nearest[i] = 0;
            for (std::size_t k = 0; k < 3; ++k)
                out.corner[k][i] = pixelsAndLines(x[k] - 256 * px - 128, y[k] - 256 * py - 128);
        }
    }

    static EdgeTable entered(const TriangleList& triangles, EdgeTable::Sides sides)
    {
        EdgeTable table;
        table.clear(0, kSide, kSide, sides, std::uint64_t{1} << 30);
        HWY_DYNAMIC_DISPATCH(enterAll)(triangles, table);
        table.fillBuckets();
        return table;
    }

    /// Per line and polygon the pixels between its edges, however they were entered.
    static std::multiset<std::array<int, 4>> spansOf(const EdgeTable& table)
    {
        std::multiset<std::array<int, 4>> spans;
        std::vector<ActiveEdge>           active;
        for (int y = 0; y < kSide; ++y) {
            std::erase_if(active, [y](const ActiveEdge& edge) { return edge.lastLine() < y; });
            for (ActiveEdge& edge : active) edge.standAt(edge.crossing().onNextLine());
            for (const std::uint32_t edge : table.startingAt(y)) active.push_back(table[edge]);
            std::ranges::sort(active, [](const ActiveEdge& a, const ActiveEdge& b) { return a.isLeftOf(b); });
            std::map<std::uint32_t, int> open;
            const auto                   pass = [&](std::uint32_t polygon, int pixel) {
                if (const auto at = open.find(polygon); at != open.end()) {
                    if (at->second < pixel)
                        spans.insert({y, static_cast<int>(table.parts()[polygon].id.value), at->second, pixel});
                    open.erase(at);
                } else {
                    open[polygon] = pixel;
                }
            };
            for (const ActiveEdge& edge : active) {
                pass(edge.polygon(), edge.firstPixel());
                if (edge.isShared()) pass(edge.opens(), edge.firstPixel());
            }
            EXPECT_TRUE(open.empty()) << "line " << y;
        }
        return spans;
    }

    static std::size_t sharedOf(const EdgeTable& table)
    {
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < table.edgeCount(); ++i) count += table[i].isShared();
        return count;
    }

    std::unique_ptr<TriangleList> m_list = std::make_unique<TriangleList>();
};

TEST_P(SharedEdges, ASideBetweenTwoTrianglesIsEnteredOnce)
{
    for (const bool isTurned : {false, true}) {  // a front, or a back
        const Mesh mesh =
            meshOf({{5, 5, 0}, {40, 8, 0}, {45, 50, 0}, {3, 41, 0}},
                   isTurned ? std::vector<Outline>{{0, 1, 2}, {0, 2, 3}} : std::vector<Outline>{{2, 1, 0}, {3, 2, 0}});
        const MeshBatches batches = makeBatches(mesh);
        list(batches, *m_list);
        ASSERT_EQ(m_list->count, 2u);
        EXPECT_EQ(m_list->is(TriangleList::kCounterClockwise, 0), !isTurned);

        const EdgeTable once = entered(*m_list, EdgeTable::Sides::OfWide),
                        each = entered(*m_list, EdgeTable::Sides::All);
        EXPECT_EQ(once.edgeCount(), 5u);
        ASSERT_EQ(sharedOf(once), 1u);
        EXPECT_EQ(each.edgeCount(), 6u) << "whoever looks on sees each triangle's own";
        EXPECT_EQ(sharedOf(each), 0u);
        EXPECT_EQ(spansOf(once), spansOf(each));
        EXPECT_FALSE(spansOf(once).empty());
    }
}

TEST_P(SharedEdges, AnyHeapOfTrianglesHasTheSpansThatEachHasByItself)
{
    std::mt19937_64 random(17);
    std::size_t     shared = 0, spans = 0;
    for (int i = 0; i < 60; ++i) {
        const std::size_t  vertices = 4 + random() % 40;
        std::vector<dvec3> positions;  // on centres, corners and thirds of pixels; some outside
        for (std::size_t v = 0; v < vertices; ++v)
            positions.emplace_back((static_cast<int>(random() % 150) - 5) / 2.0 + (random() % 3 ? 0.0 : 0.34),
                                   (static_cast<int>(random() % 150) - 5) / 2.0, 0);
        std::vector<Outline> triangles(1 + random() % 200);  // fronts and backs, three and more at a side, some twice
        for (auto& outline : triangles) {
            const auto about = random() % vertices;
            for (auto& corner : outline) corner = static_cast<std::uint32_t>((about + random() % 4) % vertices);
        }
        const Mesh        mesh    = meshOf(positions, triangles);
        const MeshBatches batches = makeBatches(mesh);
        list(batches, *m_list);
        const EdgeTable once = entered(*m_list, EdgeTable::Sides::OfWide),
                        each = entered(*m_list, EdgeTable::Sides::All);
        ASSERT_EQ(spansOf(once), spansOf(each)) << i;
        shared += sharedOf(once), spans += spansOf(once).size();
    }
    EXPECT_GT(shared, 300u);
    EXPECT_GT(spans, 10'000u);
}

TEST_P(SharedEdges, OfNoBatchNothingIsShared)
{
    const MeshBatches batches =
        makeBatches(meshOf({{5, 5, 0}, {40, 8, 0}, {45, 50, 0}, {3, 41, 0}}, {{0, 1, 2}, {0, 2, 3}}));
    list(batches, *m_list);
    m_list->batch = nullptr;
    EXPECT_EQ(entered(*m_list, EdgeTable::Sides::OfWide).edgeCount(), 6u);
    const std::vector<std::uint32_t> all{0, 1};
    const MeshBatches                node =
        makeBatches(meshOf({{5, 5, 0}, {40, 8, 0}, {45, 50, 0}, {3, 41, 0}}, {{0, 1, 2}, {0, 2, 3}}), all);
    list(node, *m_list);
    EXPECT_EQ(entered(*m_list, EdgeTable::Sides::OfWide).edgeCount(), 6u) << "of a node's batch";
}

std::string nameOf(const testing::TestParamInfo<std::int64_t>& info) { return hwy::TargetName(info.param); }
std::vector<std::int64_t> targets()
{
    std::vector<std::int64_t> all;
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1)
        all.push_back(left & -left);
    return all;
}
INSTANTIATE_TEST_SUITE_P(Targets, SharedEdges, testing::ValuesIn(targets()), nameOf);

}  // namespace
}  // namespace zscope

#endif  // HWY_ONCE
