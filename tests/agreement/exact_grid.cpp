#include "tests/agreement/exact_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace zscope::hardcase {

namespace {

__extension__ typedef __int128 Wide;

Wide ceilQuotient(Wide numerator, Wide denominator)  // denominator > 0
{
    const Wide quotient = numerator / denominator;  // towards zero
    return quotient + (numerator % denominator > 0 ? 1 : 0);
}

std::int64_t nearestEven(double value)
{
    const double below    = std::floor(value);
    const double fraction = value - below;  // exact
    const auto   whole    = static_cast<std::int64_t>(below);
    if (fraction != 0.5) return fraction < 0.5 ? whole : whole + 1;
    return whole % 2 == 0 ? whole : whole + 1;
}

/// The first pixel whose centre is not left of where the edge meets row y; nothing if it does not meet it.
bool firstPixelRightOf(const GridPoint& a, const GridPoint& b, int y, Wide& pixel)
{
    const GridPoint& upper  = a.y <= b.y ? a : b;
    const GridPoint& lower  = a.y <= b.y ? b : a;
    const Wide       centre = Wide{256} * y + 128;
    if (!(upper.y <= centre && centre < lower.y)) return false;
    const Wide dx = Wide{lower.x} - upper.x, dy = Wide{lower.y} - upper.y;
    pixel = ceilQuotient((Wide{upper.x} - 128) * dy + (centre - upper.y) * dx, 256 * dy);
    return true;
}

/// A depth at a pixel centre: numerator / denominator, in units of 2^-30.
struct Depth {
    Wide numerator = 0, denominator = 1;  // denominator > 0

    double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator) * 0x1p-30; }
};
bool isNearer(const Depth& a, const Depth& b) { return a.numerator * b.denominator > b.numerator * a.denominator; }
bool isEqual(const Depth& a, const Depth& b) { return a.numerator * b.denominator == b.numerator * a.denominator; }

Wide doubleArea(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
    return (Wide{b.x} - a.x) * (Wide{c.y} - a.y) - (Wide{b.y} - a.y) * (Wide{c.x} - a.x);
}

Depth depthAt(const GridTriangle& triangle, int x, int y)
{
    const GridPoint centre{std::int64_t{256} * x + 128, std::int64_t{256} * y + 128};
    const auto& [a, b, c] = triangle.corner;
    const auto scaled     = [&triangle](std::size_t i) {
        const double whole = std::ldexp(triangle.depth[i], 30);
        assert(whole == std::floor(whole));
        return static_cast<Wide>(whole);
    };
    Depth depth{doubleArea(centre, b, c) * scaled(0) + doubleArea(a, centre, c) * scaled(1)
                    + doubleArea(a, b, centre) * scaled(2),
                doubleArea(a, b, c)};
    if (depth.denominator < 0) depth = {-depth.numerator, -depth.denominator};
    return depth;
}

}  // namespace

GridPoint snapped(double px, double py) { return {nearestEven(px * 256), nearestEven(py * 256)}; }

Grid<int> fill(const Outline& outline, int width, int height)
{
    Grid<int>         covered(width, height, 0);
    std::vector<Wide> border;
    for (int y = 0; y < height; ++y) {
        border.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            Wide pixel = 0;
            if (firstPixelRightOf(outline[i], outline[(i + 1) % outline.size()], y, pixel)) border.push_back(pixel);
        }
        std::ranges::sort(border);
        for (std::size_t i = 0; i + 1 < border.size(); i += 2)
            for (Wide x = std::max<Wide>(border[i], 0); x < std::min<Wide>(border[i + 1], width); ++x)
                covered.at(static_cast<int>(x), y) = 1;
    }
    return covered;
}

Grid<int> fill(const std::vector<Outline>& outlines, int width, int height)
{
    Grid<int> total(width, height, 0);
    for (const Outline& outline : outlines) {
        const Grid<int> one = fill(outline, width, height);
        for (std::size_t i = 0; i < one.values().size(); ++i) total.values()[i] += one.values()[i];
    }
    return total;
}

std::int64_t sum(const Grid<int>& counts)
{
    std::int64_t total = 0;
    for (const int count : counts.values()) total += count;
    return total;
}

Grid<int> coverageOf(const Picture& picture)
{
    Grid<int> covered(picture.ids.width(), picture.ids.height(), 0);
    for (std::size_t i = 0; i < covered.values().size(); ++i) covered.values()[i] = picture.ids.values()[i] >= 0;
    return covered;
}

Grid<int> coverageOf(const Picture& picture, std::int64_t id)
{
    Grid<int> covered(picture.ids.width(), picture.ids.height(), 0);
    for (std::size_t i = 0; i < covered.values().size(); ++i) covered.values()[i] = picture.ids.values()[i] == id;
    return covered;
}

ExactPicture winners(const std::vector<GridTriangle>& triangles, int width, int height)
{
    ExactPicture picture{Grid<std::int64_t>(width, height, -1), Grid<double>(width, height, 0),
                         Grid<int>(width, height, 0)};
    Grid<Depth>  best(width, height);
    const auto   forEachCovered = [&](const auto& visit) {
        for (std::size_t id = 0; id < triangles.size(); ++id) {
            const Grid<int> covered = fill(triangles[id].outline(), width, height);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (covered.at(x, y)) visit(x, y, static_cast<std::int64_t>(id), depthAt(triangles[id], x, y));
        }
    };
    forEachCovered([&](int x, int y, std::int64_t id, const Depth& depth) {  // in rising order of ids
        if (picture.ids.at(x, y) >= 0 && !isNearer(depth, best.at(x, y))) return;
        picture.ids.at(x, y)   = id;
        picture.depth.at(x, y) = depth.value();
        best.at(x, y)          = depth;
    });
    forEachCovered([&](int x, int y, std::int64_t, const Depth& depth) {
        if (isEqual(depth, best.at(x, y))) return;
        if (depth.value() > picture.depth.at(x, y) * (1 - 3 * 0x1p-23)) picture.unclear.at(x, y) = 1;
    });
    return picture;
}

}  // namespace zscope::hardcase
