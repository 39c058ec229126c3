// builtin:hard/D1 .. hard/D9: the hard cases of the pyramid (docs/correctness.md, Hard cases, D). What is to be hidden
// is a sheet of many small triangles, so that a hierarchy has nodes below its root to ask about. D3 and D8 are no
// scenes.

#include <algorithm>

#include "core/scene/generators/hard_scene.h"

namespace zscope::generated {

namespace {

using namespace zscope::hard;

constexpr int    kSize   = 128;
constexpr double kFront  = 0.125;  // depth of what hides
constexpr double kBehind = 0.0625;

/// A rectangle as cells of about `cell` pixels, in lines from the top.
void sheet(HardScene& hard, const Place& topLeft, const Place& bottomRight, double depth, double cell)
{
    for (double y = topLeft.y; y < bottomRight.y; y += cell)
        for (double x = topLeft.x; x < bottomRight.x; x += cell)
            hard.rectangle({x, y}, {std::min(x + cell, bottomRight.x), std::min(y + cell, bottomRight.y)}, depth);
}

/// An occluder of one cell of a level and, behind it, a sheet of the same outline or one pixel wider.
Result<Scene> onTileBorders(const Arguments& arguments)
{
    HardScene    hard(kSize, kSize);
    const double side  = static_cast<double>(1 << arguments.whole("level"));
    const double wider = arguments.word("wider") == "yes" ? 1 : 0;
    sheet(hard, {side, side}, {2 * side + wider, 2 * side}, kBehind, side / 16);
    hard.rectangle({side, side}, {2 * side, 2 * side}, kFront);
    return hard.finish();
}

/// A wall with a hole of one pixel, and a sheet behind all of it.
Result<Scene> holeOfOnePixel(const Arguments& arguments)
{
    HardScene    hard(kSize, kSize);
    const double x = static_cast<double>(arguments.whole("x")), y = static_cast<double>(arguments.whole("y"));
    sheet(hard, {0, 0}, {kSize, kSize}, kBehind, 8);
    const auto wall = [&hard](const Place& a, const Place& b) {
        if (a.x < b.x && a.y < b.y) hard.rectangle(a, b, kFront);
    };
    wall({0, 0}, {kSize, y});
    wall({0, y}, {x, y + 1});
    wall({x + 1, y}, {kSize, y + 1});
    wall({0, y + 1}, {kSize, kSize});
    return hard.finish();
}

/// A wall and a sheet some float32 steps nearer than it, one of them first in the file. Both stand at right angles to
/// the view, the wall at depth 1/4 and the sheet at z = 1, so that their depths are exact.
Result<Scene> aboutTheWallsDepth(const Arguments& arguments)
{
    const double steps = static_cast<double>(arguments.whole("steps"));
    const double depth = 0.25 + steps * (steps < 0 ? 0x1p-26 : 0x1p-25);  // float32 steps are half as long below 1/4
    HardScene    hard(kSize, kSize, depth);
    const auto   at = [&](double x, double y, double z) {
        return hard.inView({(x - kSize / 2) * z, (kSize / 2 - y) * z, z});
    };
    const auto square = [&](double x0, double y0, double x1, double y1, double z) {
        const Vertex a = at(x0, y0, z), b = at(x0, y1, z), c = at(x1, y1, z), d = at(x1, y0, z);
        hard.quad(a, b, c, d);
    };
    const auto wall = [&] { square(0, 0, kSize, kSize, depth / 0.25); };
    if (arguments.word("first") == "wall") wall();
    for (double y = 32; y < 96; y += 4)
        for (double x = 32; x < 96; x += 4) square(x, y, x + 4, y + 4, 1);
    if (arguments.word("first") == "sheet") wall();
    return hard.finish();
}

/// Sheets behind a wall that reach over the borders of the picture, lie outside it, or between pixel centres.
Result<Scene> acrossTheBorders(const Arguments&)
{
    HardScene hard(kSize, kSize);
    sheet(hard, {-40, 20}, {24, 60}, kBehind, 2);     // half outside, hidden
    sheet(hard, {100, -30}, {170, 40}, kBehind, 3);   // at a corner, hidden but for a part right of the wall
    sheet(hard, {140, 140}, {180, 180}, kBehind, 2);  // wholly outside
    sheet(hard, {-64, 100}, {0, 120}, kBehind, 4);    // touches the border from outside
    for (int i = 0; i < 300; ++i) {                   // between centres
        const double x = 2 + i % 100, y = 70 + i / 100;
        hard.rectangle({x + 0.55, y + 0.55}, {x + 1.45, y + 1.45}, 0.5);
    }
    hard.rectangle({0, 0}, {120, kSize}, kFront);
    return hard.finish();
}

/// A strip as wide as the picture, hidden by another but for its last pixel.
Result<Scene> asWideAsThePicture(const Arguments& arguments)
{
    const int width = static_cast<int>(arguments.whole("width"));
    HardScene hard(width, 8);
    sheet(hard, {0, 2}, {static_cast<double>(width), 5}, kBehind, 1);
    hard.rectangle({0, 1}, {static_cast<double>(width) - 1, 6}, kFront);
    return hard.finish();
}

/// Sheets from far to near, each a pixel smaller all round: every one changes the pyramid and hides what came before.
Result<Scene> farToNear(const Arguments&)
{
    HardScene     hard(kSize, kSize);
    constexpr int kSheets = 24;
    for (int i = 0; i < kSheets; ++i)
        sheet(hard, {1.0 * i, 1.0 * i}, {kSize - 1.0 * i, kSize - 1.0 * i}, 0.03125 * (1 + i * 0.125), 16);
    return hard.finish();
}

}  // namespace

std::vector<Generator> hard_d()
{
    return {
        {"hard/D1",
         "A sheet behind one cell of a level, or a pixel wider",
         {{"level", WholeNumber{5, 3, 5}}, {"wider", OneOf{{"no", "yes"}}}},
         onTileBorders},
        {"hard/D2",
         "A sheet behind a wall with a hole of one pixel",
         {{"x", WholeNumber{63, 0, kSize - 1}}, {"y", WholeNumber{64, 0, kSize - 1}}},
         holeOfOnePixel},
        {"hard/D4",
         "A sheet as near as a wall, or some float32 steps nearer",
         {{"steps", WholeNumber{0, -4, 4}}, {"first", OneOf{{"wall", "sheet"}}}},
         aboutTheWallsDepth},
        {"hard/D6",
         "Sheets behind a wall, over the borders of the picture and between pixel centres",
         {},
         acrossTheBorders},
        {"hard/D7",
         "A strip as wide as the picture, hidden but for its last pixel",
         {{"width", WholeNumber{513, 9, 4097}}},
         asWideAsThePicture},
        {"hard/D9", "Sheets from far to near", {}, farToNear},
    };
}

}  // namespace zscope::generated
