// The hard cases of polygons, docs/correctness.md, G1 to G5: every preset draws them, those that draw triangles to the
// bit, the one that draws whole faces by face. Face 0 is the case; what it must cover is known from its snapped outline
// alone.

#include <algorithm>
#include <cmath>

#include "core/geometry/projection.h"
#include "core/measure/face_figures.h"
#include "tests/agreement/hard_support.h"

namespace zscope::hardcase {
namespace {

DrawRequest byFace(const HardCase& hard, FaceCulling culling = FaceCulling::None)
{
    DrawRequest request;
    request.scene       = hard.prepared;
    request.camera      = hard.camera;
    request.faceCulling = culling;
    request.pipeline    = findPreset("interval-polygon")->pipeline;
    request.shade       = false;
    return request;
}

Picture pictureByFace(const HardCase& hard, FaceCulling culling = FaceCulling::None)
{
    Renderer   renderer;
    Frame      frame;
    const auto report = renderer.draw(byFace(hard, culling), frame);
    EXPECT_TRUE(report.ok());
    return pictureOf(frame.visible);
}

std::map<std::string, std::uint64_t> countsByFace(const HardCase& hard)
{
    std::map<std::string, std::uint64_t> counts;
    const auto                           work = Renderer().count(byFace(hard));
    EXPECT_TRUE(work.ok());
    for (const NamedCount& count : work->counters) counts[count.name] = count.value;
    EXPECT_EQ(counts["polygons_set_up"], hard.mesh().polygonCount());
    EXPECT_EQ(counts["polygons_set_up"], counts["polygons_that_are_triangles"] + counts["polygons_by_outline"]
                                             + counts["polygons_by_ears_unlike_turns"]
                                             + counts["polygons_by_ears_thin"]);
    EXPECT_LE(counts["polygons_drawn"], counts["polygons_set_up"]);
    return counts;
}

/// The snapped corners of a face in the order of the file. Some lie halfway between grid points, where rounding
/// decides: so they are projected as the definition does it, and only what is filled is worked out apart.
Outline outlineOf(const HardCase& hard, std::uint32_t face)
{
    const Projection projection(hard.camera);
    Outline          outline;
    for (const std::uint32_t vertex : hard.mesh().polygon(PolygonId{face})) {
        const ScreenCorner corner = projection.toScreen(projection.toView(hard.mesh().positions[vertex]));
        outline.push_back({static_cast<std::int64_t>(corner.xs), static_cast<std::int64_t>(corner.ys)});
    }
    return outline;
}

/// 1 where the picture shows any triangle of the first face.
Grid<int> coverageOfFirstFace(const HardCase& hard, const Picture& picture)
{
    Grid<int>  coverage(hard.width(), hard.height());
    const auto end = static_cast<std::int64_t>(hard.mesh().firstTriangle[1]);
    for (int y = 0; y < hard.height(); ++y)
        for (int x = 0; x < hard.width(); ++x)
            coverage.at(x, y) = picture.ids.at(x, y) >= 0 && picture.ids.at(x, y) < end;
    return coverage;
}

/// The first face is nearer than the wall behind it, so it is seen wherever it covers: by the even-odd rule over its
/// outline, whether it is drawn whole or as triangles, as the plane that it is.
void expectEvenOdd(const HardCase& hard)
{
    const Grid<int> expected = fill(outlineOf(hard, 0), hard.width(), hard.height());
    ASSERT_GT(sum(expected), 300) << hard.word;
    ASSERT_LT(sum(expected), 6900) << hard.word << ": the wall is seen too";
    const Picture triangles = agreedPicture(hard), faces = pictureByFace(hard);
    expectCoverage(expected, coverageOfFirstFace(hard, triangles), hard.word + " as triangles");
    expectCoverage(expected, coverageOfFirstFace(hard, faces), hard.word + " as a face");
    for (int y = 0; y < hard.height(); ++y)
        for (int x = 0; x < hard.width(); ++x)
            ASSERT_LE(std::abs(depthSteps(triangles.depth.at(x, y), faces.depth.at(x, y))), 1)
                << hard.word << " at " << x << ", " << y;
    agreedPicture(hard, Effort::EachPreset, FaceCulling::Back);
    expectCounters(hard);
    expectCounters(hard, FaceCulling::Back);
    EXPECT_EQ(countsByFace(hard)["polygons_by_outline"], hard.mesh().polygonCount()) << hard.word;
}

TEST(HardG, G1ConcaveFacesCoverWhatTheirEarsCover)
{
    for (const char* shape : {"star", "comb", "spiral"}) {
        const HardCase hard = hardCase(std::string("G1?shape=") + shape);
        EXPECT_FALSE(hard.mesh().isMended(PolygonId{0}));
        EXPECT_GT(hard.mesh().firstTriangle[1], 10u);
        expectEvenOdd(hard);
    }
}

TEST(HardG, G2AFaceWithAHoleShowsWhatLiesBehindTheHole)
{
    struct Hole {
        std::string word;
        int         x, y;  // of a pixel in it
    };
    for (const auto& [hole, x, y] : {Hole{"inside", 46, 44}, {"corner", 34, 33}, {"side", 46, 40}}) {
        const HardCase hard = hardCase("G2?hole=" + hole);
        EXPECT_FALSE(hard.mesh().isMended(PolygonId{0}));
        expectEvenOdd(hard);
        EXPECT_EQ(coverageOfFirstFace(hard, pictureByFace(hard)).at(x, y), 0) << hole << ": inside the hole";
    }
}

TEST(HardG, G3APentagramIsHollowAsAFaceAndReportedAsTriangles)
{
    const HardCase hard = hardCase("G3");
    EXPECT_TRUE(hard.mesh().isMended(PolygonId{0}));
    EXPECT_FALSE(hard.scene->warnings.empty());
    const Grid<int> expected  = fill(outlineOf(hard, 0), hard.width(), hard.height());
    const Picture   triangles = agreedPicture(hard);
    EXPECT_EQ(expected.at(48, 50), 0);
    EXPECT_EQ(coverageOfFirstFace(hard, triangles).at(48, 50), 1) << "a fan covers the middle";
    expectCoverage(expected, coverageOfFirstFace(hard, pictureByFace(hard)), "G3 as a face");
    EXPECT_GT(sum(expected), 1000);
    // It turns counter-clockwise on the whole, so that it shows its front; the middle of a picture of backs stays
    // empty.
    agreedPicture(hard, Effort::All, FaceCulling::Back);
    const std::int64_t shown = sum(coverageOfFirstFace(hard, pictureByFace(hard, FaceCulling::Back)));
    EXPECT_TRUE(shown == 0 || shown == sum(expected)) << "one side for the whole of it";
    expectCounters(hard);
    countsByFace(hard);
}

TEST(HardG, G3CutByTheNearPlaneIsHollowStill)
{
    const HardCase hard   = hardCase("G3");
    Camera         camera = hard.camera;
    bool           isCut  = false;
    for (const double near : {2.2, 2.5, 2.8, 3.2}) {  // the star is slanted, between 2 and 4 away
        camera.near = near;
        const HardCase cut{hard.word + " with its tips cut off", hard.scene, hard.prepared, camera};
        agreedPicture(cut);
        agreedPicture(cut, Effort::EachPreset, FaceCulling::Back);
        const auto counts = countsByFace(cut);
        isCut             = isCut || counts.at("triangles_clipped") > 0;
    }
    EXPECT_TRUE(isCut);
}

TEST(HardG, G4AFaceThatIsNotPlaneIsClosedAgainstItsNeighbours)
{
    for (const std::string view : {"folded", "bent"}) {
        const HardCase hard    = hardCase("G4?view=" + view);
        const Picture  picture = agreedPicture(hard), faces = pictureByFace(hard);
        agreedPicture(hard, Effort::EachPreset, FaceCulling::Back);
        expectCounters(hard);
        expectCounters(hard, FaceCulling::Back);
        const auto covered = [](const Picture& shown) { return sum(coverageOf(shown)); };
        EXPECT_EQ(covered(picture), 84 * 84) << view << ": a frame without a gap";
        expectCoverage(coverageOf(picture), coverageOf(faces), "G4 as faces");
        EXPECT_GT(sum(coverageOfFirstFace(hard, faces)), 100) << view;
        EXPECT_EQ(countsByFace(hard)["polygons_by_ears_unlike_turns"], view == "folded" ? 1u : 0u);
        const auto figures = compareByFace(*hard.scene, hard.camera, FaceCulling::None, picture, faces);
        ASSERT_TRUE(figures.ok());
        EXPECT_EQ(figures->maxDepthSteps > 1, view == "bent")
            << "by its ears depth is theirs; as one plane it is a figure";
    }
}

TEST(HardG, G5RepeatedCornersRunsOnALineAndTenThousandCorners)
{
    for (const char* corners : {"12", "97", "1000", "10000"}) {
        const HardCase hard = hardCase(std::string("G5?corners=") + corners);
        EXPECT_GE(hard.mesh().polygon(PolygonId{0}).size() + 1, static_cast<std::size_t>(std::atoi(corners)));
        if (hard.mesh().isMended(PolygonId{0})) {
            agreedPicture(hard);
            expectCoverage(fill(outlineOf(hard, 0), hard.width(), hard.height()),
                           coverageOfFirstFace(hard, pictureByFace(hard)), hard.word);
            continue;
        }
        expectEvenOdd(hard);
    }
}

TEST(HardG, AFaceBeyondTheGuardBandOrOutOfRangeCoversWhatItsTrianglesCover)
{
    for (const double factor : {0x1p12, 0x1p20, 0x1p45, 0x1p60}) {
        const HardCase star = hardCase("G1?shape=star");
        Scene          parts;
        auto           mesh = std::make_shared<Mesh>(star.mesh());
        const auto     far  = mesh->polygon(PolygonId{0})[0];
        mesh->positions[far].x *= factor;  // one tip far away
        parts.meshes.push_back(std::move(mesh));
        parts.instances.push_back({MeshId{0}, Affine{}});
        const HardCase hard =
            hardCase("G1 with a tip " + std::to_string(factor) + " times as far", std::move(parts), star.camera);
        const Picture picture = agreedPicture(hard);
        agreedPicture(hard, Effort::EachPreset, FaceCulling::Back);
        expectCounters(hard);
        EXPECT_GT(sum(coverageOfFirstFace(hard, picture)), 100);
    }
}

}  // namespace
}  // namespace zscope::hardcase
