// Pictures of whole faces, judged pixel by pixel on a scene that can be read off: a square before a wall, a sheet that
// crosses the square, and a bow tie.
#include <gtest/gtest.h>

#include <array>

#include "core/measure/face_figures.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

constexpr int kSide = 16;

struct Shown {
    std::shared_ptr<const Scene> scene;
    Camera                       camera;
    Picture                      reference;

    ErrorFigures figures(const Picture& test, FaceCulling culling = FaceCulling::None) const
    {
        return *compareByFace(*scene, camera, culling, reference, test);
    }
    /// The picture with one pixel changed.
    Picture with(int x, int y, std::int64_t id, float depth) const
    {
        Picture picture        = reference;
        picture.ids.at(x, y)   = id;
        picture.depth.at(x, y) = depth;
        return picture;
    }
};

using Corner = std::array<double, 3>;  // pixels, distance

Shown shown(std::initializer_list<std::vector<Corner>> faces)
{
    const Camera camera = plainCamera(kSide, kSide);
    Mesh         mesh;
    for (const auto& face : faces) {
        std::vector<std::uint32_t> outline;
        for (const auto& [x, y, z] : face) {
            outline.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(pointAt(camera, x, y, z));
        }
        mesh.addPolygon(outline);
    }
    const auto scene = sceneOf(std::move(mesh), std::array{Affine{}});
    return {scene, camera, *referencePicture(*scene, camera, FaceCulling::None)};
}

std::vector<Corner> square(double from, double to, double z)
{
    return {{from, from, z}, {from, to, z}, {to, to, z}, {to, from, z}};
}

/// Face 0: triangles 0 and 1, pixels 4 to 11 at depth 1/2. Face 2: the wall, triangles 2 and 3, at depth 1/4.
Shown squareBeforeAWall() { return shown({square(4, 12, 2), square(0, 16, 4)}); }

TEST(FaceFigures, OfTheReferenceAreNone)
{
    const Shown seen    = squareBeforeAWall();
    const auto  figures = seen.figures(seen.reference);
    EXPECT_TRUE(figures.isExact());
    EXPECT_EQ(figures.covered, 256u);
    EXPECT_EQ(figures.falseCulls, 0u);
}

TEST(FaceFigures, WhichTriangleOfAFaceIsNamedIsNoMatter)
{
    const Shown seen = squareBeforeAWall();
    Picture     test = seen.reference;
    for (std::int64_t& id : test.ids.values()) id = id < 2 ? 0 : 2;
    EXPECT_NE(test, seen.reference);
    EXPECT_TRUE(seen.figures(test).isExact());
}

TEST(FaceFigures, ANearerFaceThatIsMissingIsAHole)
{
    const Shown seen = squareBeforeAWall();
    for (const auto& [id, depth] : {std::pair{std::int64_t{2}, 0.25f}, {std::int64_t{-1}, 0.0f}}) {
        const auto figures = seen.figures(seen.with(5, 6, id, depth));
        EXPECT_EQ(figures.holes, 1u) << id;
        EXPECT_EQ(figures.spills, 0u) << id;
        EXPECT_EQ(figures.falseCulls, 0u) << id << ": the face is seen elsewhere";
    }
}

TEST(FaceFigures, AFaceThatIsMissingEverywhereIsAFalseCull)
{
    const Shown seen = squareBeforeAWall();
    Picture     test = seen.reference;
    for (std::size_t i = 0; i < test.ids.values().size(); ++i) {
        if (test.ids.values()[i] >= 2) continue;
        test.ids.values()[i]   = 2;
        test.depth.values()[i] = 0.25f;
    }
    const auto figures = seen.figures(test);
    EXPECT_EQ(figures.holes, 64u);
    EXPECT_EQ(figures.falseCulls, 1u);
    EXPECT_EQ(figures.lostTriangles, 1u);
}

TEST(FaceFigures, AFaceWhereItDoesNotCoverIsASpill)
{
    const Shown seen = squareBeforeAWall();
    EXPECT_EQ(seen.figures(seen.with(12, 6, 0, 0.5f)).spills, 1u);
    EXPECT_EQ(seen.figures(seen.with(12, 6, 0, 0.5f)).holes, 0u);
    EXPECT_EQ(seen.figures(seen.with(3, 3, 1, 0.5f)).spills, 1u);
}

TEST(FaceFigures, WhoIsNearerOfTwoFacesWhoseDepthsOverlapIsAFigureAndNoHole)
{
    // From depth 1/2 at the left to 1/8 at the right, through the square at 1/4: which of the two leads depends on the
    // place.
    const Shown seen = shown({{{0, 0, 2}, {0, 16, 2}, {16, 16, 8}, {16, 0, 8}}, square(0, 16, 4)});
    EXPECT_EQ(seen.reference.ids.at(2, 8) < 2, true);
    EXPECT_EQ(seen.reference.ids.at(13, 8) >= 2, true);
    const auto figures = seen.figures(seen.with(13, 8, 0, seen.reference.depth.at(13, 8)));
    EXPECT_EQ(figures.wrongCoverage(), 0u);
    EXPECT_EQ(figures.nearTies, 1u);
    EXPECT_EQ(seen.figures(seen.with(13, 8, 0, 0.3f)).realWrongSurface, 1u);
}

TEST(FaceFigures, AMendedFaceIsJudgedByTheEvenOddRule)
{
    // A frame walked twice round, the second time on a smaller way: the fan covers its middle twice.
    const Shown seen = shown({{{1, 1, 2},
                               {1, 15, 2},
                               {15, 15, 2},
                               {15, 1, 2},
                               {1, 1, 2},
                               {5, 5, 2},
                               {5, 11, 2},
                               {11, 11, 2},
                               {11, 5, 2},
                               {5, 5, 2}},
                              square(0, 16, 4)});
    const Mesh& mesh = *seen.scene->meshes[0];
    ASSERT_TRUE(mesh.isMended(PolygonId{0}));
    const auto wall = static_cast<std::int64_t>(mesh.firstTriangle[1]);
    ASSERT_LT(seen.reference.ids.at(8, 8), wall) << "its triangles cover the middle";
    Picture test = seen.reference;
    for (int y = 5; y < 11; ++y)
        for (int x = 5; x < 11; ++x) {
            test.ids.at(x, y)   = wall;
            test.depth.at(x, y) = 0.25f;
        }
    EXPECT_EQ(seen.figures(test).wrongPixels(), 0u);
    EXPECT_EQ(seen.figures(seen.reference).spills, 36u);
    test.ids.at(2, 2)   = wall;
    test.depth.at(2, 2) = 0.25f;
    EXPECT_EQ(seen.figures(test).holes, 1u);
}

TEST(FaceFigures, CulledBacksCoverNothing)
{
    // clockwise: its back
    const Shown seen  = shown({{{4, 4, 2}, {12, 4, 2}, {12, 12, 2}, {4, 12, 2}}, square(0, 16, 4)});
    Shown       front = seen;
    front.reference   = *referencePicture(*seen.scene, seen.camera, FaceCulling::Back);
    EXPECT_TRUE(front.figures(front.reference, FaceCulling::Back).isExact());
    EXPECT_EQ(front.figures(seen.reference, FaceCulling::Back).spills, 64u);
}

}  // namespace
}  // namespace zscope::tests
