// The hard cases of scanline and interval methods, docs/correctness.md, F1 to F10. Beside the pictures, the tables that
// the sweep keeps are held against the half-open rule, line by line.

#include <algorithm>

#include <pthread.h>

#include "core/lesson/replay.h"
#include "tests/agreement/hard_support.h"

namespace zscope::hardcase {
namespace {

/// The snapped corners of triangle `id`, upper end first, of each side that meets row y; as the definition counts.
std::vector<std::array<GridPoint, 2>> sidesMeeting(const GridTriangle& triangle, int y)
{
    std::vector<std::array<GridPoint, 2>> sides;
    const std::int64_t                    centre = std::int64_t{256} * y + 128;
    for (std::size_t i = 0; i < 3; ++i) {
        GridPoint upper = triangle.corner[i], lower = triangle.corner[(i + 1) % 3];
        if (upper.y > lower.y) std::swap(upper, lower);
        if (upper.y <= centre && centre < lower.y) sides.push_back({upper, lower});
    }
    return sides;
}

/// Where a side meets row y, in 1/256 pixel, rounded down.
std::int64_t meetingPoint(const std::array<GridPoint, 2>& side, int y)
{
    const auto& [upper, lower]   = side;
    const std::int64_t numerator = (std::int64_t{256} * y + 128 - upper.y) * (lower.x - upper.x),
                       dy        = lower.y - upper.y;
    return upper.x + (numerator >= 0 ? numerator / dy : -((-numerator + dy - 1) / dy));
}

DrawRequest sweepRequest(const HardCase& hard)
{
    DrawRequest request;
    request.scene    = hard.prepared;
    request.camera   = hard.camera;
    request.pipeline = findPreset("scanline")->pipeline;
    request.threads  = 1;
    request.shade    = false;
    return request;
}

/// Calls visit(state) for every line of the sweep, after checking its active edge table against whole numbers: sorted
/// by x, every side that meets the line exactly once, where it meets it, and no other.
template <class Visit>
void forEachLine(const HardCase& hard, const Visit& visit)
{
    Replay     replay(sweepRequest(hard));
    const auto count = replay.count(Grain::Line);
    ASSERT_TRUE(count.ok()) << count.error().text();
    const auto triangles = gridTriangles(hard);
    int        lines     = 0;
    for (std::uint64_t step = 0; step < *count; ++step) {
        const auto state = replay.at(Grain::Line, StepIndex{step});
        ASSERT_TRUE(state.ok()) << state.error().text();
        if (state->event != Grain::Line || !state->sweep) continue;
        const SweepState& sweep = *state->sweep;
        ++lines;
        EXPECT_TRUE(std::ranges::is_sorted(sweep.activeEdges, {}, &EdgeRow::x)) << hard.word << ", line " << sweep.y;
        std::vector<std::pair<std::uint32_t, std::int64_t>> expected, actual;
        for (std::uint32_t id = 0; id < triangles.size(); ++id) {
            if (sum(fill(triangles[id].outline(), hard.width(), hard.height())) == 0) continue;  // never enters a table
            for (const auto& side : sidesMeeting(triangles[id], sweep.y))
                expected.emplace_back(id, meetingPoint(side, sweep.y));
        }
        for (const EdgeRow& edge : sweep.activeEdges) {
            if (sum(fill(triangles[edge.polygon.value].outline(), hard.width(), hard.height())) == 0) continue;
            actual.emplace_back(edge.polygon.value, edge.xSubpixels);
        }
        std::ranges::sort(expected);
        std::ranges::sort(actual);
        EXPECT_EQ(expected, actual) << hard.word << ", line " << sweep.y;
        visit(*state);
    }
    EXPECT_GT(lines, 0);
}

void expectEverything(const HardCase& hard, const Picture& picture, TwinDepth depth = TwinDepth::Same)
{
    expectWinners(hard, picture);
    expectTwins(hard, picture, depth);
    expectCounters(hard);
    agreedPicture(hard, Effort::All, FaceCulling::Back);
    expectCounters(hard, FaceCulling::Back);
}

/// First row and last row that show triangle `id`; every row between them must show it too.
std::array<int, 2> rowsOf(const Picture& picture, std::int64_t id)
{
    std::array<int, 2> rows{-1, -1};
    const Grid<int>    seen = coverageOf(picture, id);
    for (int y = 0; y < seen.height(); ++y) {
        if (std::ranges::count(seen.view().row(y), 1) == 0) continue;
        if (rows[0] < 0) rows[0] = y;
        EXPECT_TRUE(rows[1] < 0 || rows[1] == y - 1) << "a row is skipped above " << y;
        rows[1] = y;
    }
    return rows;
}

TEST(HardF, F1HorizontalEdgesAreNoCrossingsAndFillAsTheHalfOpenRuleSays)
{
    for (const int units : {-128, -1, 0, 1, 127}) {
        const HardCase hard    = hardCase("F1?units=" + std::to_string(units));
        const Picture  picture = agreedPicture(hard);
        expectEverything(hard, picture);
        // rows 6.5 + u .. 20.5 + u, the lower end out
        const int first = units <= 0 ? 6 : 7, end = units <= 0 ? 20 : 21;
        for (int y = 0; y < 32; ++y)
            EXPECT_EQ(picture.ids.at(10, y) >= 0, y >= first && y < end) << units << ", row " << y;
        for (int x = 50; x < 60; ++x)
            EXPECT_EQ(picture.ids.at(x, 6) >= 0, units == 0) << "one unit high, from the centre on";
        EXPECT_EQ(picture.ids.at(55, 7), -1);
        forEachLine(hard, [](const StepState& state) {  // a horizontal side is in no table: two sides per polygon
            for (const TriangleId polygon : state.sweep->activePolygons)
                EXPECT_EQ(std::ranges::count(state.sweep->activeEdges, polygon, &EdgeRow::polygon), 2);
        });
    }
}

TEST(HardF, F2CornersOnARowCountTwiceOrNotAtAllAndOncePassingThrough)
{
    const HardCase hard    = hardCase("F2");
    const Picture  picture = agreedPicture(hard);
    expectEverything(hard, picture);
    const auto all = gridTriangles(hard);
    EXPECT_EQ(sidesMeeting(all[0], 4).size(), 2u) << "a local top counts twice";
    EXPECT_EQ(sidesMeeting(all[1], 14).size(), 0u) << "a local bottom does not count";
    EXPECT_EQ(sidesMeeting(all[2], 10).size(), 2u) << "passing through: one side here, one on the other side";
    // The row of the local top holds no pixel, nor does that of the local bottom.
    EXPECT_EQ(rowsOf(picture, 0)[0], 5);
    EXPECT_EQ(rowsOf(picture, 1)[1], 13);
    EXPECT_EQ(rowsOf(picture, 2), (std::array{4, 15}));
    forEachLine(hard, [](const StepState&) {});
}

TEST(HardF, F3FirstRowOfATopAtAnyFractionIsNeitherSkippedNorAdded)
{
    struct Claim {
        const char* fraction;
        int         corner;  // first row that shows the triangle with a corner on top
        int         flat;    // and the one with a flat top
    };
    // 0.5: row 8 starts there, where the corner is still zero wide and the flat side is not.
    for (const Claim& claim : {Claim{"0", 8, 8},
                               {"0.2", 8, 8},
                               {"0.498", 9, 8},
                               {"0.5", 9, 8},
                               {"0.51", 9, 9},
                               {"0.7", 9, 9},
                               {"1", 9, 9}}) {
        const HardCase hard    = hardCase(std::string("F3?fraction=") + claim.fraction);
        const Picture  picture = agreedPicture(hard);
        EXPECT_EQ(rowsOf(picture, 0)[0], claim.corner) << claim.fraction;
        EXPECT_EQ(rowsOf(picture, 1)[0], claim.flat) << claim.fraction;
        expectEverything(hard, picture);
        forEachLine(hard, [](const StepState&) {});
    }
}

TEST(HardF, F4UprightSidesAreRightOnBothSidesFromWhicheverCornerTheyAreListed)
{
    for (const int units : {-1, 0, 1, 77}) {
        const HardCase hard    = hardCase("F4?units=" + std::to_string(units));
        const Picture  picture = agreedPicture(hard);
        expectEverything(hard, picture);
        for (int position = 0; position < 4; ++position)
            for (int listing = 1; listing < 6; ++listing)
                for (int y = 0; y < 28; ++y)
                    for (int x = 0; x < 18; ++x)
                        ASSERT_EQ(picture.ids.at(3 + x, 3 + 30 * position + y) >= 0,
                                  picture.ids.at(3 + 20 * listing + x, 3 + 30 * position + y) >= 0)
                            << hard.word << ", position " << position << ", listing " << listing;
    }
}

TEST(HardF, F5EdgesThatCrossBetweenRowsAreInOrderOnEveryRow)
{
    for (int seed = 0; seed < 12; ++seed) {
        const HardCase hard    = hardCase("F5?seed=" + std::to_string(seed));
        const Picture  picture = agreedPicture(hard);
        expectEverything(hard, picture);
        if (seed < 3) forEachLine(hard, [](const StepState&) {});
    }
}

TEST(HardF, F6HundredsOfEdgesAtTheSameXWithIntervalsOfZeroPixelsAreHarmless)
{
    const HardCase hard    = hardCase("F6");
    const Picture  picture = agreedPicture(hard);
    expectEverything(hard, picture);
    std::size_t most = 0;
    forEachLine(hardCase("F6?edges=60"), [&most](const StepState& state) {
        const auto& edges = state.sweep->activeEdges;
        for (const EdgeRow& edge : edges)
            most = std::max(most,
                            static_cast<std::size_t>(std::ranges::count(edges, edge.xSubpixels, &EdgeRow::xSubpixels)));
    });
    EXPECT_GE(most, 30u) << "many edges do meet one row at the same x";
}

TEST(HardF, F7OnePolygonLeavesWhereTheNextEntersWithoutGapAndWithoutDouble)
{
    for (const std::string at : {"centre", "corner", "elsewhere"})
        for (const std::string side : {"upright", "leaning"}) {
            const HardCase hard    = hardCase("F7?at=" + at + "&side=" + side);
            const Picture  picture = agreedPicture(hard);
            Outline        whole;
            const auto     point = [&hard](std::size_t vertex) {
                const dvec3& p = hard.mesh().positions[vertex];
                return snapped(32 + p.x / -p.z, 16 - p.y / -p.z);
            };
            for (std::size_t i = 0; i <= 8; ++i) whole.push_back(point(2 * i));   // the upper side
            for (std::size_t i = 9; i-- > 0;) whole.push_back(point(2 * i + 1));  // and back along the lower
            expectCoverage(fill(whole, 64, 32), coverageOf(picture), hard.word);
            expectCoveredAtMostOnce(hard);
            expectEverything(hard, picture);
            EXPECT_EQ(expectCounters(hard).at("pixels_tested"), static_cast<std::uint64_t>(sum(coverageOf(picture))));
        }
}

TEST(HardF, F8PolygonsThatCrossInsideAnIntervalAreResolvedPerPixel)
{
    const HardCase hard    = hardCase("F8");
    const Picture  picture = agreedPicture(hard);
    expectEverything(hard, picture, TwinDepth::WithinOneStep);
    int changes = 0;  // of owner inside one row
    for (int y = 0; y < 64; ++y)
        for (int x = 1; x < 64; ++x)
            changes += picture.ids.at(x, y) != picture.ids.at(x - 1, y) && picture.ids.at(x, y) >= 0
                       && picture.ids.at(x - 1, y) >= 0;
    EXPECT_GT(changes, 30);
}

/// Draws on a thread of little stack, so that recursion as deep as the polygons are many cannot go unseen.
Picture drawnWithLittleStack(const DrawRequest& request)
{
    struct Work {
        const DrawRequest& request;
        Picture            picture = {};
    } work{request};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, 512 * 1024);
    pthread_t thread{};
    const int started = pthread_create(
        &thread, &attributes,
        [](void* argument) -> void* {
            auto&    todo = *static_cast<Work*>(argument);
            Renderer renderer;
            Frame    frame;
            if (renderer.draw(todo.request, frame)) todo.picture = pictureOf(frame.visible);
            return nullptr;
        },
        &work);
    EXPECT_EQ(started, 0);
    if (started == 0) pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return work.picture;
}

TEST(HardF, F9FiftyThousandPolygonsOnOneRowOrOnAllRowsAreDrawnWithLittleStack)
{
    for (const std::string spread : {"one-row", "rows"}) {
        const auto word = [&](int polygons) { return "F9?polygons=" + std::to_string(polygons) + "&spread=" + spread; };
        // Edges that cross one another at every turn. Nothing here is timed: a sort that were quadratic would move 10^9
        // edges a line, and run into the test's time limit.
        const HardCase leaning        = hardCase(word(50'000) + "&lean=300");
        const Picture  leaningPicture = agreedPicture(leaning, Effort::EachPreset);
        const HardCase hard           = hardCase(word(50'000));
        const Picture  picture        = agreedPicture(hard, Effort::EachPreset);
        expectCounters(hard);
        for (const Preset& preset : presets()) {
            if (preset.claim == Claim::Approximate) continue;  // the case is of triangles, so by face is to the bit
            DrawRequest request = sweepRequest(hard);
            request.pipeline    = preset.pipeline;
            EXPECT_EQ(drawnWithLittleStack(request), picture) << preset.name;
            request.scene = leaning.prepared;
            EXPECT_EQ(drawnWithLittleStack(request), leaningPicture) << preset.name;
        }
        if (spread == "one-row") {
            EXPECT_EQ(sum(coverageOf(picture)), 1024 * 16) << "they leave nothing uncovered";
        }
    }
}

TEST(HardF, F9AllOfThemAreActiveOnOneRow)
{
    const HardCase hard = hardCase("F9?polygons=3000");
    Replay         replay(sweepRequest(hard));
    const auto     count = replay.count(Grain::Line);
    ASSERT_TRUE(count.ok());
    std::size_t most = 0;
    for (std::uint64_t step = 0; step < *count; ++step) {
        const auto state = replay.at(Grain::Line, StepIndex{step});
        ASSERT_TRUE(state.ok());
        if (state->sweep) most = std::max(most, state->sweep->activePolygons.size());
    }
    EXPECT_GT(most, 2500u) << "all but those that hold no pixel centre";
}

TEST(HardF, F10PolygonsFromOutsideAreActiveFromRowZeroAndLoseNothingAtTheBorder)
{
    for (const std::string from : {"all", "above", "left", "right", "below"}) {
        const HardCase hard    = hardCase("F10?from=" + from);
        const Picture  picture = agreedPicture(hard);
        expectEverything(hard, picture);
        EXPECT_GT(sum(coverageOf(picture)), 100) << from;

        Camera wide = hard.camera;  // the same view in the middle of a picture that holds every polygon whole
        wide.width *= 8;
        wide.height *= 8;
        wide.focal /= 8;
        const Picture whole =
            agreedPicture(changed(hard, "with all that is around it", wide, [](auto&, auto&) {}), Effort::EachPreset);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_EQ(picture.ids.at(x, y), whole.ids.at(x + 224, y + 224)) << from << " at " << x << ", " << y;

        if (from != "above") continue;
        bool reachedTop = false;
        forEachLine(hard, [&reachedTop](const StepState& state) {
            if (state.sweep->y != 0) return;
            reachedTop = true;
            EXPECT_EQ(state.sweep->activePolygons.size(), 3u) << "active from row 0";
        });
        EXPECT_TRUE(reachedTop);
    }
}

}  // namespace
}  // namespace zscope::hardcase
