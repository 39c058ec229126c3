// builtin:hard/C1 .. hard/C8: the hard cases of depth (docs/correctness.md, Hard cases, C).

#include <cmath>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/hard_scene.h"
#include "core/scene/generators/random.h"

namespace zscope::generated {

namespace {

using namespace zscope::hard;

Result<Scene> identical(const Arguments& arguments)
{
    HardScene    hard(64, 64);
    const Vertex a = hard.at({5.25, 7.5}, 0.25), b = hard.at({20, 60.75}, 0.125), c = hard.at({58.5, 20}, 0.0625);
    for (std::int64_t i = 0; i < arguments.whole("copies"); ++i) hard.triangle(a, b, c);
    return hard.finish();
}

/// Triangles with corners of their own, all in one leaning plane.
Result<Scene> coplanar(const Arguments& arguments)
{
    HardScene hard(64, 64);
    Random    random(static_cast<std::uint64_t>(arguments.whole("seed")));
    for (std::int64_t i = 0; i < arguments.whole("triangles"); ++i) {
        const auto corner = [&] {
            const double x = random.between(-24, 24), y = random.between(-24, 24);
            const double depth = 0.15 + 0.0017 * x - 0.0009 * y;  // affine in the picture: one plane in space
            return hard.at({32 + x, 32 + y}, depth);
        };
        const Vertex a = corner(), b = corner(), c = corner();
        hard.triangle(a, b, c);
    }
    return hard.finish();
}

/// Two rectangles that cross in a column of pixel centres, each nearer on its own side.
Result<Scene> crossing(const Arguments& arguments)
{
    HardScene  hard(65, 64);
    const auto sheet = [&hard](double left, double right) {
        const Vertex a = hard.at({0.5, 4}, left), b = hard.at({0.5, 60}, left);
        const Vertex c = hard.at({64.5, 60}, right), d = hard.at({64.5, 4}, right);
        hard.quad(a, b, c, d);
    };
    const bool leftFirst = arguments.word("first") == "left";
    if (leftFirst) sheet(0.25, 0.125);
    sheet(0.125, 0.25);
    if (!leftFirst) sheet(0.25, 0.125);
    return hard.finish();
}

/// Three long triangles along the sides of a triangle, each beginning near the eye and ending far behind the next.
Result<Scene> cyclicOverlap(const Arguments&)
{
    HardScene  hard(128, 128);
    const auto onGrid = [](double x, double y) { return Place{std::round(x * 256) / 256, std::round(y * 256) / 256}; };
    for (int i = 0; i < 3; ++i) {
        const auto [fromX, fromY] = pointOnCircle(i / 3.0 + 0.05);
        const auto [toX, toY]     = pointOnCircle((i + 1) / 3.0 + 0.05);
        const double alongX = toX - fromX, alongY = toY - fromY;  // of length 1.73; the corners lie 24 pixels out
        const double startX = 64 + 24 * fromX - 12 * alongX, startY = 64 + 24 * fromY - 12 * alongY;
        const Vertex a = hard.at(onGrid(startX - 6 * alongY, startY + 6 * alongX), 0.5);
        const Vertex b = hard.at(onGrid(startX + 6 * alongY, startY - 6 * alongX), 0.5);
        const Vertex c = hard.at(onGrid(64 + 24 * toX + 15 * alongX, 64 + 24 * toY + 15 * alongY), 0.125);
        hard.triangle(a, c, b);
    }
    return hard.finish();
}

/// Two sheets from one common left edge; the second in load order comes nearer by `apart` of the depth at its right.
Result<Scene> converging(const Arguments& arguments)
{
    HardScene    hard(256, 64);
    const double apart = std::ldexp(1.0, -static_cast<int>(arguments.whole("apart")));
    const Vertex a = hard.at({2.5, 4}, 0.125), b = hard.at({2.5, 60}, 0.125);
    for (const double depth : {0.25, 0.25 * (1 + apart)}) {
        const Vertex c = hard.at({250.5, 60}, depth), d = hard.at({250.5, 4}, depth);
        hard.quad(a, b, c, d);
    }
    return hard.finish();
}

/// A tall wall that is seen edge-on at 90 degrees, between a sheet behind it and one before a part of it.
Result<Scene> edgeOn(const Arguments& arguments)
{
    HardScene hard(256, 256);
    hard.rectangle({20, 20}, {236, 236}, 1.0 / 64);
    const auto [cosine, sine] = pointOnCircle(arguments.real("angle") / 360);
    const dvec3  axis{2 * 40.5, 0, 2};  // upright, seen in the middle of pixel column 168
    const double length = std::sqrt(axis.x * axis.x + axis.z * axis.z);
    const dvec3  sight{axis.x / length, 0, axis.z / length};
    const dvec3  facing{sight.z, 0, -sight.x};  // along the wall that faces the eye
    const dvec3  along{facing.x * cosine + sight.x * sine, 0, facing.z * cosine + sight.z * sine};
    const auto   corner = [&](double step, double height) {
        return hard.inView({axis.x + along.x * step, height, axis.z + along.z * step});
    };
    const Vertex a = corner(-40, 90), b = corner(-40, -90), c = corner(40, -95), d = corner(40, 95);
    hard.quad(a, b, c, d);
    hard.rectangle({150, 100}, {250, 120}, 0.5);
    return hard.finish();
}

/// A large triangle cut at the near plane beside, behind and in front of ordinary ones.
Result<Scene> clippedBesideOrdinary(const Arguments&)
{
    HardScene    hard(64, 64);
    const Vertex a = hard.inView({-20, 24, 2}), b = hard.inView({-3, -9, -0.4}), c = hard.inView({22, 20, 1.3});
    hard.triangle(a, b, c);
    hard.triangle({2, 40}, {30, 62}, {62, 38}, 1);
    hard.triangle({10, 30}, {32, 63}, {50, 20}, std::nextafter(1.0f, 0.0f));
    hard.triangle({4, 4}, {4, 60}, {60, 4}, 0.5);
    return hard.finish();
}

/// Two sheets facing the eye, the farther one first in the file. Its depth is 1/4, or one float32 step more for
/// base=odd; the nearer one, at z = 1, has exactly `step` float32 steps more than that before rounding.
Result<Scene> oneStepApart(const Arguments& arguments)
{
    const double ulp  = 0x1p-25;  // the step of float32 from 1/4 on
    const bool   odd  = arguments.word("base") == "odd";
    const double far  = odd ? 0.25 + ulp : 0.25;
    const double near = far + arguments.real("step") * ulp;  // exact: `near` is the depth at z = 1
    HardScene    hard(64, 64, near);
    const auto   sheet = [&](const Place& topLeft, const Place& bottomRight, double z) {
        const auto   at = [&](double x, double y) { return hard.inView({(x - 32) * z, (32 - y) * z, z}); };
        const Vertex a = at(topLeft.x, topLeft.y), b = at(topLeft.x, bottomRight.y);
        const Vertex c = at(bottomRight.x, bottomRight.y), d = at(bottomRight.x, topLeft.y);
        hard.quad(a, b, c, d);
    };
    sheet({4, 4}, {44, 44}, near / far);
    sheet({20, 20}, {60, 60}, 1);
    return hard.finish();
}

}  // namespace

std::vector<Generator> hard_c()
{
    return {
        {"hard/C1", "The same triangle several times", {{"copies", WholeNumber{5, 1, 100'000}}}, identical},
        {"hard/C2",
         "Triangles in one plane that overlap with different corners",
         {{"triangles", WholeNumber{12, 1, 10'000}}, {"seed", WholeNumber{1, 0, 1'000'000}}},
         coplanar},
        {"hard/C3",
         "Two sheets that cross in a column of pixel centres",
         {{"first", OneOf{{"left", "right"}}}},
         crossing},
        {"hard/C4", "Three triangles that overlap in a circle", {}, cyclicOverlap},
        {"hard/C5",
         "Two sheets converging to a common edge, 2^-apart of the depth apart at the other",
         {{"apart", WholeNumber{18, 1, 52}}},
         converging},
        {"hard/C6", "A wall seen almost edge-on; the angle in degrees", {{"angle", RealNumber{89.999, 0, 90}}}, edgeOn},
        {"hard/C7", "A triangle cut at the near plane next to ordinary ones", {}, clippedBesideOrdinary},
        {"hard/C8",
         "Sheets a float32 step apart, or part of one",
         {{"step", RealNumber{1, 0, 16}}, {"base", OneOf{{"even", "odd"}}}},
         oneStepApart},
    };
}

}  // namespace zscope::generated
