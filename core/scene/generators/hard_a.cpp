// builtin:hard/A1 .. hard/A13: the hard cases of coverage (docs/correctness.md, Hard cases, A).

#include <cmath>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/hard_scene.h"

namespace zscope::generated {

namespace {

using namespace zscope::hard;

Place onCircle(const Place& centre, double radius, double turns)
{
    const auto [cosine, sine] = pointOnCircle(turns);
    return {centre.x + radius * cosine, centre.y + radius * sine};
}

/// The point itself, or the pixel centre or pixel corner next to it.
Place movedTo(const std::string& where, const Place& p)
{
    if (where == "centre") return {std::floor(p.x) + 0.5, std::floor(p.y) + 0.5};
    if (where == "corner") return {std::floor(p.x), std::floor(p.y)};
    return p;
}

/// A kite cut along one of its diagonals; the diagonal between its first and third corner turns with `direction`.
Result<Scene> sharedEdge(const Arguments& arguments)
{
    HardScene             hard(64, 64);
    const std::string&    ends  = arguments.word("ends");
    const double          turns = static_cast<double>(arguments.whole("direction")) / 400;
    const Place           middle{32.3, 31.7};
    std::array<Vertex, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i)
        corner[i] =
            hard.at(movedTo(ends, onCircle(middle, i % 2 == 0 ? 24 : 15, turns + 0.25 * static_cast<double>(i))));
    if (arguments.word("diagonal") == "long")
        hard.quad(corner[0], corner[1], corner[2], corner[3]);
    else
        hard.quad(corner[1], corner[2], corner[3], corner[0]);
    return hard.finish();
}

/// The square from pixel centre (2, 2) to pixel centre (7, 7).
Result<Scene> squareOnCentres(const Arguments& arguments)
{
    HardScene    hard(16, 16);
    const Vertex topLeft = hard.at({2.5, 2.5}), bottomLeft = hard.at({2.5, 7.5});
    const Vertex bottomRight = hard.at({7.5, 7.5}), topRight = hard.at({7.5, 2.5});
    if (arguments.word("diagonal") == "falling")
        hard.quad(topLeft, bottomLeft, bottomRight, topRight);
    else
        hard.quad(bottomLeft, bottomRight, topRight, topLeft);
    return hard.finish();
}

/// Outlines all of whose edges run through rows, columns or diagonals of pixel centres.
Result<Scene> edgesThroughCentres(const Arguments& arguments)
{
    HardScene          hard(32, 32);
    const std::string& shape = arguments.word("shape");
    if (shape == "rectangle") hard.rectangle({3.5, 5.5}, {20.5, 11.5});
    if (shape == "diamond") hard.quad({Place{16.5, 10.5}, {10.5, 16.5}, {16.5, 22.5}, {22.5, 16.5}});
    if (shape == "triangles") {  // the four right-angled halves of a square, apart
        hard.triangle({2.5, 2.5}, {2.5, 10.5}, {10.5, 2.5});
        hard.triangle({14.5, 2.5}, {22.5, 10.5}, {22.5, 2.5});
        hard.triangle({2.5, 14.5}, {2.5, 22.5}, {10.5, 22.5});
        hard.triangle({22.5, 14.5}, {14.5, 22.5}, {22.5, 22.5});
    }
    return hard.finish();
}

Result<Scene> fan(const Arguments& arguments)
{
    HardScene          hard(128, 128);
    const std::string& where  = arguments.word("centre");
    const Place        centre = movedTo(where, {64.3141, 63.2718});
    const auto         count  = static_cast<std::uint32_t>(arguments.whole("triangles"));
    const Vertex       hub    = hard.at(centre);
    for (std::uint32_t i = 0; i < count; ++i) hard.at(onCircle(centre, 50, -static_cast<double>(i) / count));
    for (std::uint32_t i = 0; i < count; ++i) hard.triangle(hub, hub + 1 + i, hub + 1 + (i + 1) % count);
    return hard.finish();
}

/// Three slivers: the first starts on a row (column) of centres, the second ends on one, the third is between two.
Result<Scene> slivers(const Arguments& arguments)
{
    const std::string& run     = arguments.word("run");
    const double       width   = arguments.real("width") * kGridUnit;
    const bool         upright = run == "vertical" || run == "steep";
    const double       rise    = run == "shallow" || run == "steep" ? 200 : 0;
    HardScene          hard    = upright ? HardScene(256, 1024) : HardScene(1024, 256);
    const auto         place   = [upright](double along, double across) {
        return upright ? Place{across, along} : Place{along, across};
    };
    for (const double start : {10.5, 20.5 - width, 30.8})
        hard.triangle(place(12.5, start), place(1012.5, start + rise), place(1012.5, start + rise + width));
    return hard.finish();
}

/// A closed sphere of parallels and meridians whose outline is a circle of 50 pixels about the picture's middle.
Result<Scene> tinyTriangles(const Arguments& arguments)
{
    const auto   wanted = static_cast<double>(arguments.whole("triangles"));
    const auto   rings  = static_cast<std::uint32_t>(std::lround(std::sqrt(wanted / 2)));
    const double bytes  = wanted * 60;  // a mesh takes 24 per vertex, half as many vertices, and 48 per triangle
    if (bytes > static_cast<double>(arguments.memoryLimit)) return tooLarge("the sphere", bytes, arguments.memoryLimit);

    Camera camera;
    camera.near  = kNear;
    camera.far   = kInfinity;
    camera.width = camera.height = 128;
    HardScene    hard(camera);
    const double distance = 8, slope = 50.0 / 64;  // tangent of the angle at which the outline is seen
    const double radius = distance * slope / std::sqrt(1 + slope * slope);
    const auto   point  = [&](double ring, double turns) {
        const auto [up, out]      = pointOnCircle(ring / (2.0 * rings));
        const auto [cosine, sine] = pointOnCircle(turns);
        return hard.inWorld({radius * out * cosine, radius * up, radius * out * sine - distance});
    };
    const Vertex north = point(0, 0);
    for (std::uint32_t ring = 1; ring < rings; ++ring)
        for (std::uint32_t step = 0; step < rings; ++step) point(ring, -static_cast<double>(step) / rings);
    const Vertex south  = point(rings, 0);
    const auto   vertex = [&](std::uint32_t ring, std::uint32_t step) {
        return north + 1 + (ring - 1) * rings + step % rings;
    };
    for (std::uint32_t step = 0; step < rings; ++step) {
        if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the scene was not wanted any more"};
        hard.triangle(north, vertex(1, step), vertex(1, step + 1));
        for (std::uint32_t ring = 1; ring + 1 < rings; ++ring)
            hard.quad(vertex(ring, step), vertex(ring + 1, step), vertex(ring + 1, step + 1), vertex(ring, step + 1));
        hard.triangle(vertex(rings - 1, step), south, vertex(rings - 1, step + 1));
    }
    return hard.finish();
}

/// One triangle right of a long edge, two left of it that meet at its midpoint. Off the grid the midpoint is moved
/// by half a unit when it is snapped, to the left (a gap) or to the right (an overlap) of the long edge.
Result<Scene> tJunction(const Arguments& arguments)
{
    HardScene          hard(64, 64);
    const std::string& midpoint = arguments.word("midpoint");
    const double       extra    = midpoint == "gap" ? kGridUnit : midpoint == "overlap" ? -kGridUnit : 0;
    const Place        top{8.5, 8.5}, bottom{48.5 + extra, 48.5};
    const Place        middle{(top.x + bottom.x) / 2, (top.y + bottom.y) / 2};
    hard.triangle(top, bottom, {60, 10});
    hard.triangle(top, {6, 52}, middle);
    hard.triangle(middle, {6, 52}, bottom);
    return hard.finish();
}

Result<Scene> zeroArea(const Arguments& arguments)
{
    HardScene          hard(32, 32);
    const std::string& kind      = arguments.word("kind");
    const auto         repeated  = [&] { hard.triangle({4.5, 4.5}, {4.5, 4.5}, {28.5, 20.5}); };
    const auto         collinear = [&] { hard.triangle({2.5, 2.5}, {10.5, 10.5}, {26.5, 26.5}); };
    const auto         equal     = [&] { hard.triangle({16.5, 16.5}, {16.5, 16.5}, {16.5, 16.5}); };
    const auto         snapped   = [&] {  // thin before snapping, a line after it
        hard.triangle({4.5, 12.5}, {28.5, 12.5}, {16.5, 12.5 + 0.4 * kGridUnit});
    };
    if (kind == "repeated") repeated();
    if (kind == "collinear") collinear();
    if (kind == "equal") equal();
    if (kind == "snapped") snapped();
    if (kind == "among") {  // between two ordinary triangles
        hard.triangle({2, 2}, {2, 30}, {30, 2});
        repeated();
        collinear();
        equal();
        snapped();
        hard.triangle({30, 30}, {30, 2}, {2, 30});
    }
    return hard.finish();
}

/// A hexagon about a hub; all seven corners lie at odd multiples of half a grid unit, `units` whole units off a
/// pixel centre, and some of them left of and above the picture.
Result<Scene> snappingMidpoint(const Arguments& arguments)
{
    HardScene    hard(64, 64);
    const double off = (static_cast<double>(arguments.whole("units")) + 0.5) * kGridUnit;
    const auto   at  = [&](double x, double y) { return hard.at({x + 0.5 + off, y + 0.5 + off}); };
    const Vertex hub = at(32, 32);
    at(50, 32);
    at(41, 10);
    at(-6, -3);
    at(-9, 32);
    at(20, 54);
    at(45, 50);
    for (std::uint32_t i = 0; i < 6; ++i) hard.triangle(hub, hub + 1 + i, hub + 1 + (i + 1) % 6);
    return hard.finish();
}

Result<Scene> wholePicture(const Arguments& arguments)
{
    HardScene    hard(64, 64);
    const double times = arguments.real("times");
    hard.triangle({32 - 96 * times, 32 - 80 * times}, {32 - 96 * times, 32 + 144 * times},
                  {32 + 176 * times, 32 - 8 * times});
    return hard.finish();
}

/// One corner 2^exponent pixels to the right and half as far down.
Result<Scene> farCorner(const Arguments& arguments)
{
    HardScene    hard(64, 64);
    const double far = std::ldexp(1.0, static_cast<int>(arguments.whole("exponent")));
    hard.triangle({4.25, 8.75}, {4.5, 50.5}, {far, far / 2});
    return hard.finish();
}

Result<Scene> pictureBorder(const Arguments& arguments)
{
    HardScene          hard(48, 32);
    const double       right = 47.5, bottom = 31.5;  // the last centre
    const std::string& shape = arguments.word("shape");
    if (shape == "last-in") hard.triangle({right, bottom}, {right, bottom + 3}, {right + 3, bottom});
    if (shape == "last-out") hard.triangle({right, bottom}, {right, bottom - 0.375}, {right - 0.375, bottom});
    if (shape == "first-in") hard.triangle({0.5, 0.5}, {0.5, 0.875}, {0.875, 0.5});
    if (shape == "first-out") hard.triangle({0.5, 0.5}, {0.5, -3}, {-3, 0.5});
    if (shape == "whole") hard.rectangle({0, 0}, {48, 32});
    if (shape == "centres") hard.rectangle({0.5, 0.5}, {right, bottom});
    if (shape == "beyond") hard.rectangle({0.5 - kGridUnit, 0.5 - kGridUnit}, {right + kGridUnit, bottom + kGridUnit});
    return hard.finish();
}

/// A triangle a tenth of a grid unit thin that turns the other way once its corners are snapped.
Result<Scene> flippedBySnapping(const Arguments& arguments)
{
    HardScene   hard(64, 32);
    const Place left{8, 10.5 + 0.6 * kGridUnit}, right{56, 10.5 - 0.4 * kGridUnit}, middle{32, 10.5 + 0.2 * kGridUnit};
    if (arguments.word("facing") == "front")
        hard.triangle(left, middle, right);
    else
        hard.triangle(left, right, middle);
    return hard.finish();
}

}  // namespace

std::vector<Generator> hard_a()
{
    const OneOf where{{"centre", "corner", "elsewhere"}};
    return {
        {"hard/A1",
         "Two triangles that share an edge, in 400 directions",
         {{"direction", WholeNumber{37, 0, 399}}, {"ends", where}, {"diagonal", OneOf{{"long", "short"}}}},
         sharedEdge},
        {"hard/A2",
         "A square with its corners on pixel centres",
         {{"diagonal", OneOf{{"falling", "rising"}}}},
         squareOnCentres},
        {"hard/A3",
         "Edges that run through rows and columns of pixel centres",
         {{"shape", OneOf{{"rectangle", "diamond", "triangles"}}}},
         edgesThroughCentres},
        {"hard/A4",
         "A fan of triangles about one vertex",
         {{"triangles", WholeNumber{1000, 3, 1'000'000}}, {"centre", where}},
         fan},
        {"hard/A5",
         "Slivers 1000 pixels long; width in 1/256 pixel",
         {{"width", RealNumber{1, 0, 1024}}, {"run", OneOf{{"horizontal", "vertical", "shallow", "steep"}}}},
         slivers},
        {"hard/A6",
         "A closed sphere of triangles far smaller than a pixel",
         {{"triangles", WholeNumber{1'000'000, 32, 100'000'000}}},
         tinyTriangles},
        {"hard/A7", "A long edge against two short ones", {{"midpoint", OneOf{{"grid", "gap", "overlap"}}}}, tJunction},
        {"hard/A8",
         "Triangles of zero area",
         {{"kind", OneOf{{"among", "repeated", "collinear", "equal", "snapped"}}}},
         zeroArea},
        {"hard/A9",
         "Corners halfway between two points of the snapping grid",
         {{"units", WholeNumber{0, -128, 127}}},
         snappingMidpoint},
        {"hard/A10",
         "A triangle that covers the picture many times over",
         {{"times", RealNumber{10000, 1, 1e12}}},
         wholePicture},
        {"hard/A11", "A corner 2^exponent pixels away", {{"exponent", WholeNumber{40, 6, 1000}}}, farCorner},
        {"hard/A12",
         "The border of the picture",
         {{"shape", OneOf{{"centres", "whole", "beyond", "last-in", "last-out", "first-in", "first-out"}}}},
         pictureBorder},
        {"hard/A13", "A triangle that snapping turns over", {{"facing", OneOf{{"front", "back"}}}}, flippedBySnapping},
    };
}

}  // namespace zscope::generated
