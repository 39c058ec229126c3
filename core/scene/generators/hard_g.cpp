// builtin:hard/G1 .. hard/G5: the hard cases of polygons of any size (docs/correctness.md, Hard cases, G). Face 0 is
// the case, face 1 a wall behind it, so that a pixel that is missing shows something else, and not only background.

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/scene/generators/hard_scene.h"

namespace zscope::generated {

namespace {

using namespace zscope::hard;

constexpr int    kSize      = 96;
constexpr double kWallDepth = 0x1p-9;

using Places = std::vector<Place>;

/// To the grid, so that the outline is what snapping leaves of it.
double onGrid(double pixels) { return std::round(pixels * 256) / 256; }

/// Twice as near at the bottom as at the top.
double slanted(const Place& place) { return 0.0625 * (1 + place.y / kSize); }

/// The outline in a slanted plane, then the wall. Corners at one place are one vertex, unless they follow each other.
Scene inFrontOfAWall(HardScene& hard, const Places& outline)
{
    std::vector<Vertex>                         corners;
    std::map<std::pair<double, double>, Vertex> known;
    for (const Place& place : outline) {
        const auto [at, isNew] = known.try_emplace({place.x, place.y}, 0);
        if (isNew || at->second == corners.back()) at->second = hard.at(place, slanted(place));
        corners.push_back(at->second);
    }
    hard.polygon(corners);
    hard.polygon(Places{{8.25, 6.5}, {8.25, 90.5}, {90.75, 90.5}, {90.75, 6.5}}, kWallDepth);
    return hard.finish();
}

/// `points` tips, and as many corners between them that are `waist` as far from the middle.
Places star(int points, double waist)
{
    Places outline;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * (i + 0.3) / points, reach = 42 * (i % 2 == 0 ? 1 : waist);
        outline.push_back({onGrid(48 + reach * std::cos(angle)), onGrid(48 - reach * std::sin(angle))});
    }
    return outline;
}

/// Teeth upwards from a bar, with gaps of a pixel, of less than one, and of one grid unit between them.
Places comb()
{
    Places upper;
    double x = 6.25;
    for (int tooth = 0; tooth < 12; ++tooth) {
        const double width = 4 + tooth % 3 * 0.5, gap = tooth % 3 == 0 ? 1 : tooth % 3 == 1 ? 0.3125 : kGridUnit;
        const double top = 8.5 + tooth % 4 * 3.25, lean = tooth % 2 == 0 ? 0 : 0.25;
        upper.insert(upper.end(),
                     {{x + lean, top}, {x + width - lean, top + 0.5}, {x + width, 70.5}, {x + width + gap, 70.5}});
        x += width + gap;
    }
    upper.pop_back();  // beside the last tooth there is no gap
    upper.insert(upper.end(), {{upper.back().x, 84.25}, {6.25, 84.25}});
    return upper;
}

/// An arm that winds inwards, two and a half times round, a pixel and a half wide.
Places spiral()
{
    Places       outer, inner;
    double       left = 4.5, top = 4.5, right = 90.25, bottom = 91.75;
    const double arm = 1.5, pitch = 7.25;
    for (int turn = 0; turn < 6; ++turn) {
        outer.insert(outer.end(), {{left, top}, {left, bottom}, {right, bottom}, {right, top + pitch}});
        inner.insert(inner.end(), {{left + arm, top + arm},
                                   {left + arm, bottom - arm},
                                   {right - arm, bottom - arm},
                                   {right - arm, top + pitch + arm}});
        left += pitch, top += pitch, right -= pitch, bottom -= pitch;
    }
    Places outline = outer;
    outline.insert(outline.end(), inner.rbegin(), inner.rend());
    return outline;
}

Result<Scene> concave(const Arguments& arguments)
{
    HardScene          hard(kSize, kSize);
    const std::string& shape = arguments.word("shape");
    return inFrontOfAWall(hard, shape == "star" ? star(7, 0.35) : shape == "comb" ? comb() : spiral());
}

/// A frame about a hole that its outline reaches over a bridge edge, there and back; or a hole that touches the outline
/// in a corner, or lies with a corner on one of its sides.
Result<Scene> withAHole(const Arguments& arguments)
{
    HardScene          hard(kSize, kSize);
    const std::string& hole = arguments.word("hole");
    if (hole == "inside")
        return inFrontOfAWall(hard, {{10.5, 12.25},
                                     {14.25, 84.5},
                                     {86.5, 80.25},
                                     {82.25, 10.5},
                                     {10.5, 12.25},
                                     {30.25, 32.5},
                                     {58.5, 28.25},
                                     {66.5, 60.5},
                                     {34.75, 64.25},
                                     {30.25, 32.5}});
    if (hole == "corner")
        return inFrontOfAWall(
            hard,
            {{10.5, 12.5}, {14.25, 84.5}, {86.5, 80.25}, {82.25, 10.5}, {10.5, 12.5}, {50.25, 28.5}, {40.5, 56.75}});
    // the hole's tip on the upper side
    return inFrontOfAWall(hard, {{10.5, 12.5},
                                 {10.5, 84.5},
                                 {82.5, 84.5},
                                 {82.5, 12.5},
                                 {46.5, 12.5},
                                 {62.25, 48.5},
                                 {30.75, 48.5},
                                 {46.5, 12.5}});
}

/// A star drawn in one go, its five sides crossing one another.
Result<Scene> pentagram(const Arguments&)
{
    HardScene hard(kSize, kSize);
    Places    outline;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * (2 * i) / 5 + 0.1;
        outline.push_back({onGrid(48 + 40 * std::sin(angle)), onGrid(50 - 40 * std::cos(angle))});
    }
    return inFrontOfAWall(hard, outline);
}

/// A saddle: a square with two opposite corners raised, seen from so low that one of its triangles shows its back
/// (folded), or from higher up (bent). Around it triangles that share its sides, out to a square frame.
Result<Scene> notPlane(const Arguments& arguments)
{
    Camera camera = pixelCamera(kSize, kSize);
    camera.focal  = 1;  // 90 degrees
    HardScene    hard(camera);
    const bool   folds = arguments.word("view") == "folded";
    const double side = 1.6, upwards = 0.6, away = 1.5, raised = folds ? 1.2 : 0.3, z = 4;
    const auto   corner = [&](double u, double w, double h) {
        return hard.inView({side * u, upwards * w + raised * h, z + away * w - 0.4 * raised * h});
    };
    const auto   frame = [&](double u, double w) { return hard.inView({7.03125 * u, 6.96875 * w, 8}); };
    const Vertex a = corner(-1, -1, -1), b = corner(1, -1, 1), c = corner(1, 1, -1), d = corner(-1, 1, 1);
    const Vertex e = frame(-1, -1), f = frame(1, -1), g = frame(1, 1), h = frame(-1, 1);
    hard.polygon(std::array{a, b, c, d});
    hard.quad(e, f, b, a);
    hard.quad(f, g, c, b);
    hard.quad(g, h, d, c);
    hard.quad(h, e, a, d);
    return hard.finish();
}

/// A wheel of many teeth: corners repeated, runs of corners on one line, and `corners` in all.
Result<Scene> manyCorners(const Arguments& arguments)
{
    const auto   count = static_cast<int>(arguments.whole("corners"));
    const double bytes = static_cast<double>(count) * 2000;
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("the corners", bytes, arguments.memoryLimit);
    HardScene hard(kSize, kSize);
    Places    outline;
    for (int i = 0; static_cast<int>(outline.size()) < count; ++i) {
        const double angle = 2 * std::numbers::pi * 6 * i / count;  // six corners for every place on the rim
        const auto   at    = [&](double reach, double ahead) {
            return Place{onGrid(48 + reach * std::cos(angle + ahead)), onGrid(48 - reach * std::sin(angle + ahead))};
        };
        const double step = 2 * std::numbers::pi / count;
        const Place  tip = at(43, 0), root = at(36, 3 * step);
        const Place  middle{0.5 * tip.x + 0.5 * root.x, 0.5 * tip.y + 0.5 * root.y};
        for (const Place& place : {tip, tip, middle, root, root, root})
            if (static_cast<int>(outline.size()) < count) outline.push_back(place);
    }
    return inFrontOfAWall(hard, outline);
}

}  // namespace

std::vector<Generator> hard_g()
{
    return {
        {"hard/G1", "Concave faces: a star, a comb, a spiral", {{"shape", OneOf{{"star", "comb", "spiral"}}}}, concave},
        {"hard/G2",
         "A face with a hole, inside or touching the outline",
         {{"hole", OneOf{{"inside", "corner", "side"}}}},
         withAHole},
        {"hard/G3", "A pentagram: a face that crosses itself", {}, pentagram},
        {"hard/G4",
         "A quadrilateral that is not plane, among neighbours",
         {{"view", OneOf{{"folded", "bent"}}}},
         notPlane},
        {"hard/G5",
         "A face of thousands of corners, some repeated, some on one line",
         {{"corners", WholeNumber{10'000, 12, 20'000}}},
         manyCorners},
    };
}

}  // namespace zscope::generated
