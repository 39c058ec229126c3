// The hard cases of transform and clipping, docs/correctness.md, B1 to B13.

#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "core/geometry/near_clip.h"
#include "core/measure/definition.h"
#include "core/scene/load.h"
#include "tests/agreement/hard_support.h"

namespace zscope::hardcase {
namespace {

/// A place in view space in extended precision, so that nothing here repeats the roundings of what is tested.
struct ViewPoint {
    long double x, y, z;
};
using ViewTriangle = std::array<ViewPoint, 3>;

/// Triangle `id` in view space of the pixel camera (eye at the origin, along -z).
ViewTriangle viewTriangle(const HardCase& hard, std::size_t id)
{
    ViewTriangle seen{};
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3& p = hard.mesh().positions[hard.mesh().triangles[id][i]];
        seen[i]        = {p.x, p.y, -static_cast<long double>(p.z)};
    }
    return seen;
}

/// What lies in front of the near plane, on the grid, in the order of the walk that the definition prescribes.
Outline clippedOutline(const HardCase& hard, std::size_t id)
{
    const long double near     = hard.camera.near;
    const auto        triangle = viewTriangle(hard, id);
    Outline           outline;
    const auto        add = [&](const ViewPoint& p) {
        outline.push_back(snapped(static_cast<double>(hard.width() / 2.0L + p.x / p.z),
                                         static_cast<double>(hard.height() / 2.0L - p.y / p.z)));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const ViewPoint &a = triangle[i], &b = triangle[(i + 1) % 3];
        if (a.z >= near) add(a);
        if ((a.z >= near) == (b.z >= near)) continue;
        const long double t = (a.z - near) / (a.z - b.z);
        add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), near});
    }
    return outline;
}

/// The one triangle of the scene is seen exactly where its outline says, each pixel tested once.
Picture expectOutline(const HardCase& hard, const Outline& outline, const Outline& predicted)
{
    EXPECT_EQ(fill(outline, hard.width(), hard.height()), fill(predicted, hard.width(), hard.height())) << hard.word;
    const Picture picture = agreedPicture(hard);
    expectCoverage(fill(outline, hard.width(), hard.height()), coverageOf(picture), hard.word);
    const auto counters = expectCounters(hard);
    EXPECT_EQ(counters.at("pixels_tested"), static_cast<std::uint64_t>(sum(coverageOf(picture)))) << hard.word;
    return picture;
}

Outline pixels(std::initializer_list<std::array<double, 2>> places)
{
    Outline outline;
    for (const auto& [x, y] : places) outline.push_back(snapped(x, y));
    return outline;
}

TEST(HardB, B1CornersBehindTheNearPlaneLeaveTwoOneAndNoPartsThatShareTheirDiagonal)
{
    for (int behind = 1; behind <= 3; ++behind)
        for (int first = 0; first < 3; ++first) {
            const HardCase hard = hardCase("B1?behind=" + std::to_string(behind) + "&first=" + std::to_string(first));
            std::array<dvec3, 3> view{};
            for (std::size_t i = 0; i < 3; ++i) {
                const ViewPoint p = viewTriangle(hard, 0)[i];
                view[i]           = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
            }
            const ClippedTriangle kept = clipNear(view, hard.camera.near);
            ASSERT_EQ(kept.parts(), static_cast<std::size_t>(3 - behind)) << hard.word;
            if (behind == 1) {
                EXPECT_EQ(kept.part(0)[0], kept.part(1)[0]);
                EXPECT_EQ(kept.part(0)[2], kept.part(1)[1]);
            }
            if (behind == 3) {
                EXPECT_EQ(sum(coverageOf(agreedPicture(hard))), 0);
                const auto counters = expectCounters(hard);
                EXPECT_EQ(counters.at("triangles_clipped_away") + counters.at("triangles_outside"), 1u);
                continue;
            }
            const Picture picture = expectOutline(hard, clippedOutline(hard, 0),
                                                  behind == 1 ? pixels({{12, 22}, {-4, 68}, {76, 68}, {52, 22}})
                                                              : pixels({{32, 12}, {24, 72}, {52, 52}}));
            EXPECT_EQ(expectCounters(hard).at("triangles_clipped"), 1u) << hard.word;
            expectTwins(hard, picture, TwinDepth::WithinOneStep);
            agreedPicture(hard, Effort::All, FaceCulling::Back);
        }
}

TEST(HardB, B2SharedEdgeAcrossTheNearPlaneHasNoGapAndNoOverlap)
{
    std::int64_t seen = 0;
    for (int seed = 0; seed < 150; ++seed) {
        const HardCase hard    = hardCase("B2?seed=" + std::to_string(seed));
        const Picture  picture = agreedPicture(hard, seed < 10 ? Effort::All : Effort::Some);
        const Outline  first = clippedOutline(hard, 0), second = clippedOutline(hard, 1);
        ASSERT_EQ(first.front(), *(second.end() - 2)) << "the end in front";
        ASSERT_EQ(first.back(), second.back()) << "where the shared edge crosses the plane";
        Outline whole = first;
        whole.insert(whole.end(), second.begin(), second.end() - 2);
        expectCoverage(fill(whole, 64, 64), coverageOf(picture), hard.word);
        const auto counters = expectCounters(hard);
        EXPECT_EQ(counters.at("pixels_tested"), static_cast<std::uint64_t>(sum(coverageOf(picture)))) << hard.word;
        expectCoveredAtMostOnce(hard);
        if (seed < 10) expectTwins(hard, picture, TwinDepth::WithinOneStep);
        seen += sum(coverageOf(picture));
    }
    EXPECT_GT(seen, 150 * 200) << "most of them fill a good part of the picture";
}

TEST(HardB, B3CornerOrFaceOnTheNearPlaneIsKeptWithDepthOne)
{
    for (int first = 0; first < 3; ++first) {
        const HardCase hard    = hardCase("B3?what=corner&first=" + std::to_string(first));
        const Picture  picture = agreedPicture(hard);
        expectWinners(hard, picture);
        for (const float depth : picture.depth.values()) EXPECT_LE(depth, 1.0f);
        EXPECT_EQ(expectCounters(hard).at("triangles_clipped"), 0u) << "on the plane is inside";
        expectTwins(hard, picture, TwinDepth::WithinOneStep);
    }
    const HardCase face    = hardCase("B3?what=face");
    const Picture  picture = agreedPicture(face);
    expectWinners(face, picture);
    EXPECT_GT(sum(coverageOf(picture)), 500);
    for (std::size_t i = 0; i < picture.ids.values().size(); ++i)
        EXPECT_EQ(picture.depth.values()[i], picture.ids.values()[i] == 0 ? 1.0f : 0.0f);
    expectTwins(face, picture);
}

TEST(HardB, B4CornersAtBehindAndHardlyInFrontOfTheEyeGiveNoMirroredImage)
{
    for (int first = 0; first < 3; ++first) {
        const auto word = [first](const std::string& z) { return "B4?z=" + z + "&first=" + std::to_string(first); };
        // From z = 1 to 0 the plane is met at 3/4 of the way; a denormal z is 0 to the last bit of the crossing.
        const Outline atZero = pixels({{12, 22}, {15, 46}, {55, 42}, {52, 18}});
        for (const std::string z : {"zero", "tiny", "denormal"}) {
            const HardCase hard    = hardCase(word(z));
            const Picture  picture = expectOutline(hard, clippedOutline(hard, 0), atZero);
            if (z != "denormal") expectScaledTwin(hard, picture, -5);
            expectShiftedTwin(hard, picture, TwinDepth::WithinOneStep);
            expectReversedTwin(hard, picture, TwinDepth::WithinOneStep);
        }
        const HardCase behind = hardCase(word("minus-near"));  // at 3/5 of the way
        expectOutline(behind, clippedOutline(behind, 0), pixels({{12, 22}, {2.4, 35.2}, {66.4, 28.8}, {52, 18}}));
    }
}

TEST(HardB, B5InsideAClosedBoxEveryPixelIsCoveredOnceInTwelveDirections)
{
    for (int direction = 0; direction < 12; ++direction) {
        const HardCase hard    = hardCase("B5?direction=" + std::to_string(direction));
        const Picture  picture = agreedPicture(hard);
        EXPECT_EQ(sum(coverageOf(picture)), 64 * 48) << hard.word;
        EXPECT_EQ(expectCounters(hard).at("pixels_tested"), 64u * 48u) << hard.word;
        expectCoveredAtMostOnce(hard);
        EXPECT_EQ(agreedPicture(hard, Effort::All, FaceCulling::Back), picture)
            << "seen from inside all faces are front";
        expectCounters(hard, FaceCulling::Back);
        expectTwins(hard, picture, TwinDepth::WithinOneStep);
        const HardCase outside = changed(hard, "turned inside out", hard.camera, [](auto&, auto& triangles) {
            for (auto& triangle : triangles) std::swap(triangle[0], triangle[1]);
        });
        EXPECT_EQ(sum(coverageOf(agreedPicture(outside, Effort::Some, FaceCulling::Back))), 0) << hard.word;
    }
}

TEST(HardB, B6FaceInThePlaneOfTheCameraIsNothingOrOneExactLine)
{
    for (const std::string roll : {"0", "90", "180"})  // along the axes nothing is left of it
        EXPECT_EQ(sum(coverageOf(agreedPicture(hardCase("B6?roll=" + roll)))), 0) << roll;
    for (const std::string roll : {"0.001", "1", "30", "45", "77.7", "-30", "-89.999", "135"}) {
        const HardCase hard    = hardCase("B6?roll=" + roll);
        const Picture  picture = agreedPicture(hard);
        const double   angle   = std::stod(roll) / 180 * 3.141592653589793;
        for (int y = 0; y < hard.height(); ++y)
            for (int x = 0; x < hard.width(); ++x) {
                if (picture.ids.at(x, y) < 0) continue;
                const double off = std::abs(std::cos(angle) * (y + 0.5 - 32.5) - std::sin(angle) * (x + 0.5 - 32.5));
                EXPECT_LE(off, 1.0 / 256) << hard.word << ": a pixel beside the line, " << x << ", " << y;
            }
        expectReversedTwin(hard, picture, TwinDepth::WithinOneStep);
        expectCounters(hard);
    }
}

/// How many snapped corners differ between two scenes of the same triangles.
std::int64_t snapDifferences(const HardCase& a, const HardCase& b)
{
    std::int64_t                  count = 0;
    std::vector<definition::Part> first, second;
    const definition::View        viewA(a.camera, FaceCulling::None), viewB(b.camera, FaceCulling::None);
    for (std::uint32_t id = 0; id < a.scene->triangleCount(); ++id) {
        definition::partsOf(*a.scene, InstanceId{0}, id, viewA, first);
        definition::partsOf(*b.scene, InstanceId{0}, id, viewB, second);
        EXPECT_EQ(first.size(), second.size());
        for (std::size_t part = 0; part < std::min(first.size(), second.size()); ++part)
            for (std::size_t i = 0; i < 3; ++i) {
                count += first[part].corners()[i].xs != second[part].corners()[i].xs;
                count += first[part].corners()[i].ys != second[part].corners()[i].ys;
            }
    }
    return count;
}

TEST(HardB, B7ScaledSceneIsTheSamePictureUpToCountedSnapDifferences)
{
    const HardCase one     = hardCase("B7");
    const Picture  picture = agreedPicture(one);
    EXPECT_GT(sum(coverageOf(picture)), 96 * 64 / 2);
    expectTwins(one, picture, TwinDepth::WithinOneStep);
    expectCounters(one);
    for (const std::string scale : {"1048576", "9.5367431640625e-07", "1099511627776"})  // 2^20, 2^-20, 2^40
        EXPECT_EQ(agreedPicture(hardCase("B7?scale=" + scale)), picture) << scale << " is a power of two: identical";
    for (const std::string scale : {"1e-6", "1e6", "1e-20", "1e20"}) {
        const HardCase     scaled           = hardCase("B7?scale=" + scale);
        const Picture      other            = agreedPicture(scaled);
        const std::int64_t snaps            = snapDifferences(one, scaled);
        std::int64_t       pixelsThatDiffer = 0;
        for (std::size_t i = 0; i < picture.ids.values().size(); ++i)
            pixelsThatDiffer += picture.ids.values()[i] != other.ids.values()[i];
        EXPECT_LE(snaps, 4) << scale << ": float64 moves next to no corner to another unit";
        EXPECT_LE(pixelsThatDiffer, 2 * snaps) << scale;
    }
}

/// The picture of a bumpy sheet without any snapping, in extended precision; lengths in units of the detail.
Grid<std::int64_t> unsnappedWinners(const HardCase& binary)
{
    const int          width = binary.width(), height = binary.height();
    Grid<std::int64_t> ids(width, height, -1);
    Grid<long double>  best(width, height, 0.0L);
    const auto&        mesh = binary.mesh();
    for (std::size_t id = 0; id < mesh.triangles.size(); ++id) {
        long double x[3], y[3], d[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const dvec3&      p = mesh.positions[mesh.triangles[id][i]];  // exact multiples of 2^-10 * 2^-8
            const long double z = 32 - p.z * 1024.0L;
            x[i]                = width / 2.0L + height / 2.0L * binary.camera.focal * (p.x * 1024.0L - 10) / z;
            y[i]                = height / 2.0L - height / 2.0L * binary.camera.focal * (p.y * 1024.0L - 10) / z;
            d[i]                = 8 / z;
        }
        const long double area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const long double px = i + 0.5L, py = j + 0.5L;
                const long double w0 = ((x[1] - px) * (y[2] - py) - (y[1] - py) * (x[2] - px)) / area;
                const long double w1 = ((x[2] - px) * (y[0] - py) - (y[2] - py) * (x[0] - px)) / area;
                const long double w2 = 1 - w0 - w1;
                if (w0 < 0 || w1 < 0 || w2 < 0) continue;
                const long double depth = w0 * d[0] + w1 * d[1] + w2 * d[2];
                if (depth <= best.at(i, j)) continue;
                best.at(i, j) = depth;
                ids.at(i, j)  = static_cast<std::int64_t>(id);
            }
    }
    return ids;
}

TEST(HardB, B8DetailFarFromTheOriginIsNoWorseThanNearIt)
{
    const HardCase binary = hardCase("B8?offset=0&detail=binary");
    const Picture  atHome = agreedPicture(binary);
    const auto     truth  = unsnappedWinners(binary);
    const auto     wrong  = [&truth](const Picture& picture) {
        std::int64_t count = 0;
        for (std::size_t i = 0; i < truth.values().size(); ++i) count += truth.values()[i] != picture.ids.values()[i];
        return count;
    };
    // 2^20 away coordinates on a binary grid are exact, and so is everything after the eye is subtracted.
    EXPECT_EQ(agreedPicture(hardCase("B8?offset=1048576&detail=binary")), atHome);
    const std::int64_t near = wrong(agreedPicture(hardCase("B8?offset=0&detail=decimal")));
    const std::int64_t far  = wrong(agreedPicture(hardCase("B8?offset=1e6&detail=decimal")));
    EXPECT_LE(far, near);
    EXPECT_LE(near, 128 * 128 / 200) << "snapping to 1/256 pixel shows another triangle on few pixels";
    RecordProperty("wrong_pixels_near", static_cast<int>(near));
    RecordProperty("wrong_pixels_far", static_cast<int>(far));
    expectTwins(binary, atHome, TwinDepth::WithinOneStep);
}

TEST(HardB, B9ExtremeAnglesAgreeWithTheReference)
{
    for (const std::string angle : {"0.01", "1", "90", "170", "179"}) {
        const HardCase hard    = hardCase("B9?angle=" + angle);
        const Picture  picture = agreedPicture(hard);
        EXPECT_GT(sum(coverageOf(picture)), 96 * 64 / 2) << angle;
        expectTwins(hard, picture, TwinDepth::WithinOneStep);
        expectCounters(hard);
        // The cloud is made to fill the view, so the same pixels are reached from a camera 18,000 times as wide.
        double                        magnitude = 0;
        std::vector<definition::Part> parts;
        for (std::uint32_t id = 0; id < hard.scene->triangleCount(); ++id) {
            definition::partsOf(*hard.scene, InstanceId{0}, id, {hard.camera, FaceCulling::None}, parts);
            for (const auto& part : parts)
                for (const auto& corner : part.corners())
                    magnitude = std::max({magnitude, std::abs(corner.x), std::abs(corner.y)});
        }
        EXPECT_LT(magnitude, 1000) << angle;
        RecordProperty("largest_corner_at_" + angle, std::to_string(magnitude));
    }
}

TEST(HardB, B10FrontSheetWinsEverywhereAtBothEndsOfElevenDecades)
{
    for (const std::string end : {"near", "far"})
        for (const std::string sheet : {"flat", "leaning"}) {
            const HardCase hard    = hardCase("B10?end=" + end + "&sheet=" + sheet);
            const Picture  picture = agreedPicture(hard);
            EXPECT_EQ(sum(coverageOf(picture)), 48 * 48) << hard.word;
            for (const std::int64_t id : picture.ids.values()) EXPECT_TRUE(id == -1 || id == 2 || id == 3) << hard.word;
            expectTwins(hard, picture, sheet == "flat" ? TwinDepth::Same : TwinDepth::WithinOneStep);
        }
}

TEST(HardB, B11SampleAtFarIsKeptOneStepNearerTooOneStepBeyondIsDropped)
{
    for (const std::string far : {"256", "1000.1", "3e7", "1e30"}) {
        const HardCase hard    = hardCase("B11?far=" + far);
        const Picture  picture = agreedPicture(hard);
        const auto     limit   = static_cast<float>(0.25 / std::stod(far));
        const auto     shown   = [&](int x) { return picture.depth.at(x, 16); };
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x) {
                const bool inRows = y >= 4 && y < 28;
                const bool isKept = inRows && ((x >= 2 && x < 14) || (x >= 18 && x < 30));
                EXPECT_EQ(picture.ids.at(x, y) >= 0, isKept) << hard.word << " at " << x << ", " << y;
            }
        EXPECT_EQ(shown(8), std::nextafter(limit, 1.0f)) << far;
        EXPECT_EQ(shown(24), limit) << far;
        EXPECT_EQ(shown(40), 0.0f) << far;
        if (far == "256") {
            EXPECT_EQ(limit, 1.0f / 1024);
        }
        expectScaledTwin(hard, picture, 20);
        expectReversedTwin(hard, picture);
        expectShuffledTwin(hard, picture);
        Camera open       = hard.camera;
        open.far          = std::numeric_limits<double>::infinity();
        const Picture all = agreedPicture(changed(hard, "without far", open, [](auto&, auto&) {}));
        EXPECT_EQ(all.depth.at(40, 16), std::nextafter(limit, 0.0f)) << "the third sheet lies where it is meant to";
    }
}

/// Where the triangle in question is not seen, the picture is that of its neighbours alone.
void expectNeighboursUnaffected(const HardCase& hard, const Picture& picture, std::uint32_t troublemaker)
{
    const Picture alone = agreedPicture(only(hard, [=](std::uint32_t id) { return id != troublemaker; }));
    EXPECT_GT(sum(coverageOf(alone)), 500);
    for (int y = 0; y < hard.height(); ++y)
        for (int x = 0; x < hard.width(); ++x) {
            if (picture.ids.at(x, y) == troublemaker) continue;
            const std::int64_t id = alone.ids.at(x, y);
            ASSERT_EQ(picture.ids.at(x, y), id >= troublemaker ? id + 1 : id) << hard.word << " at " << x << ", " << y;
            ASSERT_EQ(picture.depth.at(x, y), alone.depth.at(x, y)) << hard.word << " at " << x << ", " << y;
        }
}

TEST(HardB, B12ExtremeCoordinatesAreHandledAndLeaveTheirNeighboursAlone)
{
    for (const std::string what : {"huge-x", "huge-z", "huge-behind", "huge-all", "denormal", "denormal-z"}) {
        const HardCase hard    = hardCase("B12?what=" + what);
        const Picture  picture = agreedPicture(hard);
        expectNeighboursUnaffected(hard, picture, 1);
        const auto counters = expectCounters(hard);
        agreedPicture(hard, Effort::All, FaceCulling::Back);
        if (what == "huge-x" || what == "huge-all") {
            EXPECT_EQ(counters.at("triangles_out_of_range"), 1u) << what;
            EXPECT_EQ(sum(coverageOf(picture, 1)), 0) << what;
        }
        if (what == "denormal") {  // seen as if the denormals were 0: corners (32, 12), (12, 32), (52, 32)
            const Grid<int> shape = fill(pixels({{32, 12}, {12, 32}, {52, 32}}), 64, 64);
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x) {
                    if (picture.ids.at(x, y) == 1) {
                        EXPECT_EQ(shape.at(x, y), 1);
                    }
                    if (shape.at(x, y) == 1) {
                        EXPECT_GE(picture.ids.at(x, y), 0);
                    }
                }
        }
        if (what == "huge-z") {
            EXPECT_GT(sum(coverageOf(picture, 1)), 50) << "it ends at the horizon's middle";
        }
    }
}

TEST(HardB, B12UnusableNumbersInAFileAreDroppedAndCountedAndTheRestIsDrawn)
{
    const auto folder = std::filesystem::temp_directory_path() / ("zscope-hard-b12-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    const std::string path = (folder / "numbers.obj").string();
    std::ofstream(path) << "v -29.5 29.5 -1\nv -29.5 2 -1\nv -2 29.5 -1\n"       // 1 2 3: an ordinary triangle
                           "v nan 0 -1\nv 0 inf -1\nv 0 0 -inf\nv 1e999 0 -1\n"  // 4 .. 7: no numbers at all
                           "v 1e308 -20 -1\nv 1e-320 20 -1\n"                    // 8, 9: extreme, but numbers
                           "v 29.5 -29.5 -1\nv 29.5 -2 -1\nv 2 -29.5 -1\n"       // 10 11 12: an ordinary triangle
                           "f 1 2 3\nf 1 4 3\nf 5 2 3\nf 1 2 6\nf 7 2 3\nf 1 8 3\nf 1 9 2\nf 10 11 12\n";
    Result<Scene> scene = loadScene(path);
    std::filesystem::remove_all(folder);
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(scene->meshes[0]->droppedFaces, 4u);
    EXPECT_GE(scene->warnings.size(), 1u);
    ASSERT_EQ(scene->triangleCount(), 4u) << "the faces that use a vertex without a value, and no others, are gone";

    HardCase      hard    = hardCase("B12 from a file", std::move(scene).value(), hardCase("B12").camera);
    const Picture picture = agreedPicture(hard);
    expectNeighboursUnaffected(hard, picture, 1);
    const auto counters = expectCounters(hard);
    EXPECT_EQ(counters.at("triangles_in"), 4u);
    EXPECT_EQ(counters.at("triangles_out_of_range"), 1u) << "the one with 1e308";
    EXPECT_GT(sum(coverageOf(picture, 0)), 300);
    EXPECT_GT(sum(coverageOf(picture, 3)), 300);
}

TEST(HardB, B13CamerasThatCannotBeAreRefusedInASentence)
{
    Bounds box;
    box.include({-1, -1, -1});
    box.include({1, 1, 1});
    const auto expectRefused = [&box](const std::string& about, const std::function<void(ViewRequest&)>& spoil) {
        ViewRequest view;
        view.eye    = dvec3{0, 0, 5};
        view.target = dvec3{0, 0, 0};
        ASSERT_TRUE(makeCamera(view, box).ok()) << "the view is fine before it is spoilt";
        spoil(view);
        const Result<Camera> camera = makeCamera(view, box);
        ASSERT_FALSE(camera.ok()) << about;
        EXPECT_EQ(camera.error().kind, Trouble::Usage) << about;
        EXPECT_NE(camera.error().sentence.find(about), std::string::npos) << camera.error().sentence;
    };
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    expectRefused("parallel", [](ViewRequest& v) { v.up = {0, 0, 1}; });
    expectRefused("parallel", [](ViewRequest& v) { v.up = {0, 0, -3e-200}; });
    expectRefused("parallel", [](ViewRequest& v) { v.eye = dvec3{0, 7, 0}; });
    expectRefused("up", [](ViewRequest& v) { v.up = {0, 0, 0}; });
    expectRefused("same point", [](ViewRequest& v) { v.eye = v.target; });
    expectRefused("near", [](ViewRequest& v) { v.near = 10, v.far = 10; });
    expectRefused("near", [](ViewRequest& v) { v.near = 10, v.far = 9; });
    expectRefused("near", [](ViewRequest& v) { v.near = 0; });
    expectRefused("near", [](ViewRequest& v) { v.near = -1; });
    expectRefused("near", [=](ViewRequest& v) { v.near = inf; });
    expectRefused("near", [=](ViewRequest& v) { v.near = nan; });
    expectRefused("far", [=](ViewRequest& v) { v.far = nan; });
    expectRefused("size", [](ViewRequest& v) { v.width = 0; });
    expectRefused("size", [](ViewRequest& v) { v.height = 0; });
    expectRefused("size", [](ViewRequest& v) { v.width = -4; });
    expectRefused("size", [](ViewRequest& v) { v.height = kMaxPictureSide + 1; });
    expectRefused("field of view", [](ViewRequest& v) { v.verticalFov = 0; });
    expectRefused("field of view", [](ViewRequest& v) { v.verticalFov = 180; });
    expectRefused("field of view", [=](ViewRequest& v) { v.verticalFov = nan; });
    expectRefused("eye", [=](ViewRequest& v) { v.eye = dvec3{0, inf, 0}; });
    expectRefused("target", [=](ViewRequest& v) { v.target = dvec3{nan, 0, 0}; });
}

TEST(HardB, B13PicturesOnePixelWideOrHighAreExact)
{
    for (const auto& [width, height] : {std::array{1, 64}, {64, 1}, {1, 1}, {2, 1}, {1, 2}, {17, 1}, {1, 256}}) {
        const HardCase hard    = hardCase("B13?width=" + std::to_string(width) + "&height=" + std::to_string(height));
        const Picture  picture = agreedPicture(hard);
        EXPECT_EQ(picture.ids.width(), width);
        EXPECT_EQ(picture.ids.height(), height);
        expectWinners(hard, picture);
        EXPECT_GE(picture.ids.at(0, 0), 0) << hard.word;
        agreedPicture(hard, Effort::All, FaceCulling::Back);
        expectReversedTwin(hard, picture);
        expectCounters(hard);
    }
}

}  // namespace
}  // namespace zscope::hardcase
