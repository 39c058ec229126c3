// builtin:hard/F1 .. hard/F10: the hard cases of scanline and interval methods (docs/correctness.md, Hard cases, F).

#include <algorithm>
#include <cmath>

#include "core/scene/generators/hard_scene.h"
#include "core/scene/generators/random.h"

namespace zscope::generated {

namespace {

using namespace zscope::hard;

/// Rectangles and triangles whose horizontal sides lie `units` grid units below a row of centres.
Result<Scene> horizontalEdges(const Arguments& arguments)
{
    HardScene    hard(64, 32);
    const double off = static_cast<double>(arguments.whole("units")) * kGridUnit;
    const double top = 6.5 + off, bottom = 20.5 + off;
    hard.rectangle({4, top}, {16, bottom});
    hard.triangle({20, top}, {26, bottom}, {32, top});     // flat on top
    hard.triangle({36, bottom}, {48, bottom}, {42, top});  // flat at the bottom
    hard.rectangle({50, top}, {60, top + kGridUnit});      // one unit high
    return hard.finish();
}

/// Triangles whose topmost corner, lowest corner, or a corner where the outline passes on downwards lies exactly on
/// a row of centres; last a rhomb with all its corners on rows.
Result<Scene> cornersOnRows(const Arguments&)
{
    HardScene hard(64, 32);
    hard.triangle({10.25, 4.5}, {4.75, 14.25}, {15.5, 14.25});                  // local top
    hard.triangle({20.75, 4.25}, {31.25, 4.25}, {25.5, 14.5});                  // local bottom
    hard.triangle({36.5, 4.25}, {42.25, 10.5}, {35.75, 16.75});                 // passing on the right
    hard.triangle({54.25, 4.25}, {46.75, 10.5}, {52.5, 16.75});                 // passing on the left
    hard.quad({Place{10.25, 18.5}, {6.5, 22.5}, {10.25, 28.5}, {16.5, 22.5}});  // all of them on rows
    return hard.finish();
}

/// Triangles whose top is `fraction` of a pixel below the upper border of row 8: a corner, and a flat side.
Result<Scene> firstRow(const Arguments& arguments)
{
    HardScene    hard(64, 32);
    const double top = 8 + arguments.real("fraction");
    hard.triangle({16, top}, {2, top + 7}, {30, top + 7});
    hard.triangle({34, top}, {48, top + 9}, {62, top});
    return hard.finish();
}

/// Right-angled triangles in all four positions, each listed from each corner, both ways round.
Result<Scene> uprightSides(const Arguments& arguments)
{
    HardScene    hard(128, 128);
    const double off = static_cast<double>(arguments.whole("units")) * kGridUnit;
    for (int position = 0; position < 4; ++position)
        for (int listing = 0; listing < 6; ++listing) {
            const double          left = 4 + 20 * listing + 0.5 + off, top = 4 + 30 * position + 0.5 + off;
            std::array<Place, 4>  square{Place{left, top}, {left, top + 24}, {left + 14, top + 24}, {left + 14, top}};
            std::array<Vertex, 3> corner{};
            for (std::size_t i = 0; i < 3; ++i)
                corner[i] = hard.at(square[(static_cast<std::size_t>(position) + i) % 4]);
            const auto number = [&](int i) { return corner[static_cast<std::size_t>((listing + i) % 3)]; };
            if (listing < 3)
                hard.triangle(number(0), number(1), number(2));
            else
                hard.triangle(number(0), number(2), number(1));
        }
    return hard.finish();
}

/// Thin triangles that cross one another between two rows of centres, at many heights.
Result<Scene> crossingBetweenRows(const Arguments& arguments)
{
    HardScene hard(64, 64);
    Random    random(static_cast<std::uint64_t>(arguments.whole("seed")));
    for (int i = 0; i < 40; ++i) {
        const auto   grid  = [&](double low, double high) { return std::floor(random.between(low, high) * 256) / 256; };
        const double y     = grid(4, 60);  // both sides cross those of others near this height
        const double depth = std::ldexp(1.0, -1 - i % 6);
        const double middle = grid(10, 54), reach = grid(1, 9);
        hard.triangle({middle - reach, y - 1.25}, {middle + reach, y + 1.25}, {middle + reach + 2, y + 0.75}, depth);
        hard.triangle({middle + reach, y - 1.25}, {middle - reach, y + 1.25}, {middle - reach - 2, y + 0.75}, depth);
    }
    return hard.finish();
}

/// Triangles with one upright side in the same pixel column, and others too narrow to hold a pixel centre there.
Result<Scene> manyEdgesAtOneX(const Arguments& arguments)
{
    HardScene hard(64, 64);
    Random    random(3);
    for (std::int64_t i = 0; i < arguments.whole("edges"); ++i) {
        const auto   grid = [&](double low, double high) { return std::floor(random.between(low, high) * 256) / 256; };
        const double top = grid(-4, 30), bottom = grid(34, 70), tip = grid(34, 62), level = grid(4, 60);
        const double depth = std::ldexp(1.0, -1 - static_cast<int>(i % 12));
        if (i % 3 == 2)
            hard.triangle({32.5 + kGridUnit, top}, {32.5 + kGridUnit, bottom}, {33.25, level}, depth);
        else if (i % 3 == 1)
            hard.triangle({32.5, top}, {32.5, bottom}, {tip, level}, depth);
        else
            hard.triangle({32.5, bottom}, {32.5, top}, {64 - tip, level}, depth);
    }
    return hard.finish();
}

/// A row of quadrilaterals, each ending where the next begins.
Result<Scene> leavingAndEntering(const Arguments& arguments)
{
    HardScene           hard(64, 32);
    const std::string&  where  = arguments.word("at");
    const double        within = where == "centre" ? 0.5 : where == "corner" ? 0 : 0.3125;
    const double        lean   = arguments.word("side") == "leaning" ? 4 : 0;
    std::vector<Vertex> upper, lower;
    for (int i = 0; i <= 8; ++i) {
        const double x = 4 + 7 * i + within;
        upper.push_back(hard.at({x + (i % 2 == 0 ? lean : -lean) / 2, 3 + within}));
        lower.push_back(hard.at({x, 28 + within}));
    }
    for (std::size_t i = 0; i < 8; ++i) hard.quad(upper[i], lower[i], lower[i + 1], upper[i + 1]);
    return hard.finish();
}

/// Sheets that pass through one another along slanted lines inside the picture.
Result<Scene> crossingInsideAnInterval(const Arguments&)
{
    HardScene  hard(64, 64);
    const auto sheet = [&hard](double topLeft, double bottomLeft, double bottomRight) {
        const Vertex a = hard.at({2, 2}, topLeft), b = hard.at({2, 62}, bottomLeft), c = hard.at({62, 62}, bottomRight);
        hard.triangle(a, b, c);
    };
    sheet(0.25, 0.0625, 0.125);
    sheet(0.0625, 0.25, 0.125);
    sheet(0.125, 0.125, 0.125);
    sheet(0.03125, 0.125, 0.25);
    return hard.finish();
}

/// one-row: all polygons are active on each of 16 rows, and end up to `lean` pixels beside where they begin.
/// rows: they start all the way down the tallest picture.
Result<Scene> manyPolygons(const Arguments& arguments)
{
    const auto   count = static_cast<std::size_t>(arguments.whole("polygons"));
    const double bytes = static_cast<double>(count) * 200;
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("the polygons", bytes, arguments.memoryLimit);
    Random       random(static_cast<std::uint64_t>(count));
    const bool   tall = arguments.word("spread") == "rows";
    const double lean = arguments.real("lean");
    HardScene    hard = tall ? HardScene(16, kMaxPictureSide) : HardScene(1024, 16);
    for (std::size_t i = 0; i < count; ++i) {
        const double depth = 0.25 * (1 - random.unit() / 2);
        if (tall) {
            const double top =
                static_cast<double>(kMaxPictureSide) * static_cast<double>(i) / static_cast<double>(count);
            const double left = random.between(-2, 12), height = random.between(0.5, 3);
            hard.triangle({left, top}, {left + 1, top + height}, {left + 6, top + 1}, depth);
        } else {
            const double left = random.between(-2, 1024), slant = random.between(-lean, lean),
                         width = random.between(0.1, 3);
            hard.triangle({left, -3}, {left + slant, 19}, {left + width, -2}, depth);
        }
    }
    return hard.finish();
}

/// Polygons that reach into the picture from outside.
Result<Scene> fromOutside(const Arguments& arguments)
{
    HardScene          hard(64, 64);
    const std::string& side = arguments.word("from");
    const bool         all  = side == "all";
    if (all || side == "above") hard.triangle({20, -70}, {4, 40}, {40, 30}, 0.25);
    if (all || side == "left") hard.triangle({-80, 20}, {-75, 55}, {35, 44}, 0.125);
    if (all || side == "right") hard.triangle({140, 10}, {30, 20}, {130, 60}, 0.0625);
    if (all || side == "below") hard.triangle({33, 30}, {20, 140}, {50, 130}, 0.5);
    if (all || side == "above") hard.rectangle({50.5, -60}, {54.5, 90}, 0.03125);
    return hard.finish();
}

}  // namespace

std::vector<Generator> hard_f()
{
    const Parameter seed{"seed", WholeNumber{1, 0, 1'000'000}};
    const Parameter units{"units", WholeNumber{0, -128, 128}};  // 1/256 pixel from a pixel centre
    return {
        {"hard/F1", "Horizontal edges at, just above and just below a row of pixel centres", {units}, horizontalEdges},
        {"hard/F2", "Corners exactly on a row of pixel centres", {}, cornersOnRows},
        {"hard/F3",
         "The first row of a triangle, for any fraction of its top",
         {{"fraction", RealNumber{0.2, 0, 1}}},
         firstRow},
        {"hard/F4", "Vertical edges, listed from every corner", {units}, uprightSides},
        {"hard/F5", "Edges that cross between two rows", {seed}, crossingBetweenRows},
        {"hard/F6", "Hundreds of edges at the same x", {{"edges", WholeNumber{400, 1, 100'000}}}, manyEdgesAtOneX},
        {"hard/F7",
         "One polygon leaves and another enters at the same pixel",
         {{"at", OneOf{{"centre", "corner", "elsewhere"}}}, {"side", OneOf{{"upright", "leaning"}}}},
         leavingAndEntering},
        {"hard/F8", "Polygons that cross inside an interval", {}, crossingInsideAnInterval},
        {"hard/F9",
         "Tens of thousands of polygons active on one row, or starting on all rows",
         {{"polygons", WholeNumber{50'000, 1, 10'000'000}},
          {"spread", OneOf{{"one-row", "rows"}}},
          {"lean", RealNumber{3, 0, 1024}}},
         manyPolygons},
        {"hard/F10",
         "Polygons that enter from outside the picture",
         {{"from", OneOf{{"all", "above", "left", "right", "below"}}}},
         fromOutside},
    };
}

}  // namespace zscope::generated
