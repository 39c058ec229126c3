// Batches of whole faces: every opaque face once, in load order, with its triangles, and with sides that go round what
// they cover.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/geometry/face_batches.h"
#include "tests/core/outline_shapes.h"

namespace zscope {
namespace {

using test::GridPoint;
using test::GridPolygon;

/// All shapes in one mesh, side by side; every third one of glass if wanted.
Mesh meshOf(const std::vector<GridPolygon>& shapes, bool hasGlass = false)
{
    Mesh mesh;
    mesh.materials.push_back(Material{.name = "glass", .diffuse = {}, .opacity = 0.5f});
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto first   = static_cast<std::uint32_t>(mesh.positions.size());
        auto       outline = test::inOrder(shapes[i].corners.size());
        for (std::uint32_t& corner : outline) corner += first;
        for (const dvec3& p : test::inPlane(shapes[i].corners)) mesh.positions.push_back(p);
        mesh.addPolygon(outline, MaterialId{hasGlass && i % 3 == 0 ? 1u : 0u});
    }
    return mesh;
}

dvec3 cornerOf(const FaceBatches& made, std::uint32_t batch, std::uint32_t place)
{
    const std::size_t v = made.points.batches[batch].firstVertex + place;
    return {made.points.x[v], made.points.y[v], made.points.z[v]};
}

void expectFaithfulFaces(const Mesh& mesh)
{
    const FaceBatches made = makeFaceBatches(mesh);
    ASSERT_EQ(made.batches.size(), made.points.batches.size());
    std::vector<std::uint32_t> expected, found;
    for (std::uint32_t p = 0; p < mesh.polygonCount(); ++p)
        if (mesh.materialOf(PolygonId{p}).opacity >= 1 && mesh.firstTriangle[p] < mesh.firstTriangle[p + 1])
            expected.push_back(mesh.firstTriangle[p]);
    std::uint32_t face = 0;
    for (std::uint32_t b = 0; b < made.batches.size(); ++b) {
        const Batch& points = made.points.batches[b];
        ASSERT_EQ(made.batches[b].firstFace, face);
        EXPECT_TRUE(made.batches[b].faceCount == 1
                    || (points.vertexCount <= kBatchVertices && points.triangleCount <= kBatchTriangles));
        std::uint32_t triangles = 0;
        for (std::uint32_t i = 0; i < made.batches[b].faceCount; ++i, ++face) {
            found.push_back(made.faces[face].firstTriangle);
            const auto ears = made.earsOf(face);
            triangles += static_cast<std::uint32_t>(ears.size());
            for (std::uint32_t e = 0; e < ears.size(); ++e)
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    ASSERT_LT(ears[e][corner], points.vertexCount);
                    EXPECT_EQ(cornerOf(made, b, ears[e][corner]),
                              mesh.positions[mesh.triangles[made.faces[face].firstTriangle + e][corner]]);
                }
        }
        EXPECT_EQ(triangles, points.triangleCount);
    }
    EXPECT_EQ(face + 1, made.faces.size());
    EXPECT_EQ(found, expected);
    EXPECT_EQ(made.points.x.size(), made.points.y.size());
    EXPECT_GE(made.points.x.size(),
              made.points.batches.empty()
                  ? 0u
                  : made.points.batches.back().firstVertex + made.points.batches.back().vertexCount + kBatchPadding);
}

TEST(FaceBatches, HoldEveryOpaqueFaceOnceInLoadOrderWithItsTriangles)
{
    std::vector<GridPolygon> shapes = test::cuttablePolygons();
    for (int i = 0; i < 400; ++i) shapes.push_back({"triangle", {{i, 0}, {i + 9, 1}, {i, 7}}});
    expectFaithfulFaces(meshOf(shapes));
    expectFaithfulFaces(meshOf(shapes, true));
    expectFaithfulFaces(Mesh{});
    EXPECT_TRUE(makeFaceBatches(Mesh{}).batches.empty());
}

/// How often directed sides wind round p, which is on none of them.
int windingOf(const FaceBatches& made, std::uint32_t face, GridPoint p)
{
    int winding = 0;
    for (const FaceSide& side : made.sidesOf(face)) {
        const dvec3     from = cornerOf(made, 0, side.from), to = cornerOf(made, 0, side.to);
        const GridPoint a{std::llround(from.x), std::llround(from.y)}, b{std::llround(to.x), std::llround(to.y)};
        winding += a.y <= p.y && b.y > p.y && test::sideOf(a, b, p) > 0;
        winding -= a.y > p.y && b.y <= p.y && test::sideOf(a, b, p) < 0;
    }
    return winding;
}

TEST(FaceBatches, SidesWindRoundAPointAsTheOutlineDoesAndAreClosed)
{
    for (const GridPolygon& shape : test::cuttablePolygons()) {
        SCOPED_TRACE(shape.name);
        std::vector<GridPoint> finer;  // room between the corners for points on no side
        for (const GridPoint& p : shape.corners) finer.push_back({p.x * 64, p.y * 64});
        const FaceBatches made = makeFaceBatches(meshOf({{shape.name, finer}}));
        ASSERT_EQ(made.faces.size(), 2u);

        std::map<std::uint32_t, int> ends;
        for (const FaceSide& side : made.sidesOf(0)) ++ends[side.from], --ends[side.to];
        EXPECT_TRUE(std::ranges::all_of(ends, [](const auto& at) { return at.second == 0; }));
        EXPECT_LT(made.sidesOf(0).size(), 3 * made.earsOf(0).size()) << "sides between triangles are left out";

        std::mt19937_64 random(7);
        GridPoint       low = finer[0], high = finer[0];
        for (const GridPoint& p : finer) {
            low  = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        int inside = 0;
        for (int i = 0; i < 500; ++i) {
            const auto any = [&](std::int64_t from, std::int64_t to) {
                return from + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(to - from + 1));
            };
            const GridPoint p{any(low.x, high.x), any(low.y, high.y)};
            const bool      isOnASide = [&] {
                for (std::size_t c = 0; c < finer.size(); ++c) {
                    const GridPoint a = finer[c], b = finer[(c + 1) % finer.size()];
                    if ((a.x != b.x || a.y != b.y) && test::sideOf(a, b, p) == 0) return true;
                }
                return false;
            }();
            if (isOnASide) continue;
            ASSERT_EQ(windingOf(made, 0, p), test::windingAround(finer, p)) << p.x << ", " << p.y;
            inside += windingOf(made, 0, p) != 0;
        }
        EXPECT_GT(inside, 0);
    }
}

TEST(FaceBatches, PlanesHaveTheNormalOfTheOutlineAndGoThroughItsMiddle)
{
    Mesh mesh;
    mesh.positions = {{1, 0, 5}, {3, 0, 5}, {3, 4, 5}, {1, 4, 5}};
    mesh.addPolygon(std::array<std::uint32_t, 4>{0, 1, 2, 3});
    mesh.addPolygon(std::array<std::uint32_t, 3>{0, 1, 2});
    const FaceBatches made = makeFaceBatches(mesh);
    ASSERT_EQ(made.planes.size(), 1u) << "a triangle has its own";
    EXPECT_EQ(made.faces[1].plane, Face::kNoPlane);
    const FacePlane& plane = made.planes[made.faces[0].plane];
    EXPECT_EQ(plane.mean, (dvec3{2, 2, 5}));
    EXPECT_EQ(plane.normal, (dvec3{0, 0, 16})) << "twice the area along the axis it faces";
}

TEST(FaceBatches, AFaceLargerThanABatchHasOneOfItsOwn)
{
    const FaceBatches made = makeFaceBatches(meshOf({{"triangle", {{0, 0}, {9, 1}, {0, 7}}},
                                                     test::star(300, 100000, 60000),
                                                     {"triangle", {{0, 0}, {9, 1}, {0, 7}}}}));
    ASSERT_EQ(made.batches.size(), 3u);
    EXPECT_EQ(made.points.batches[1].vertexCount, 600u);
}

}  // namespace
}  // namespace zscope
