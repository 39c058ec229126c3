// Outlines that are hard to cut, for the tests of polygons and of the OBJ reader; all corners on an integer grid, so
// that a test can count with 64-bit integers what lies inside.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/affine.h"

namespace zscope::test {

struct GridPoint {
    std::int64_t x, y;
};

struct GridPolygon {
    std::string            name;
    std::vector<GridPoint> corners;
};

inline std::vector<GridPoint> circle(int corners, double radius, GridPoint centre = {0, 0}, double turn = 0)
{
    std::vector<GridPoint> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + turn) / corners;
        points.push_back(
            {centre.x + std::llround(radius * std::cos(angle)), centre.y + std::llround(radius * std::sin(angle))});
    }
    return points;
}

inline GridPolygon star(int tips, std::int64_t outer, std::int64_t inner)
{
    GridPolygon polygon{"star", {}};
    for (int i = 0; i < 2 * tips; ++i) {
        const double angle  = std::numbers::pi * i / tips;
        const double radius = static_cast<double>(i % 2 == 0 ? outer : inner);
        polygon.corners.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
    }
    return polygon;
}

/// Teeth of one width on a common back; `slant` shears them, so that their boxes overlap.
inline GridPolygon comb(int teeth, std::int64_t length, std::int64_t slant = 0)
{
    GridPolygon polygon{"comb", {{0, -10}}};
    polygon.corners.push_back({teeth * 20, -10});
    for (int i = teeth; i-- > 0;) {
        polygon.corners.push_back({i * 20 + 20, 0});
        polygon.corners.push_back({i * 20 + 15 + slant, length});
        polygon.corners.push_back({i * 20 + 5 + slant, length});
        polygon.corners.push_back({i * 20 + 2, 0});
    }
    return polygon;
}

/// A band that winds inwards `turns` times.
inline GridPolygon spiral(int cornersPerSide, int turns, double spacing)
{
    GridPolygon polygon{"spiral", {}};
    const auto  at = [&](int i, double shift) {
        const double angle  = 2 * std::numbers::pi * turns * i / (cornersPerSide - 1);
        const double radius = spacing * (angle / (2 * std::numbers::pi) + 1 + shift);
        return GridPoint{std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))};
    };
    for (int i = 0; i < cornersPerSide; ++i) polygon.corners.push_back(at(i, 0.4));
    for (int i = cornersPerSide; i-- > 0;) polygon.corners.push_back(at(i, 0));
    return polygon;
}

/// Outline and hole of `corners` corners each, joined by an edge that is walked there and back: 2 * corners + 2.
inline GridPolygon bridgedRing(int corners, std::int64_t outer, std::int64_t inner)
{
    GridPolygon polygon{"bridged ring", circle(corners, static_cast<double>(outer))};
    polygon.corners.push_back(polygon.corners.front());
    std::vector<GridPoint> hole = circle(corners, static_cast<double>(inner));
    polygon.corners.push_back(hole.front());
    for (std::size_t i = hole.size(); i-- > 0;) polygon.corners.push_back(hole[i]);
    return polygon;
}

/// Unit squares joined one by one across a random edge of the ring: seams where squares meet again are walked there
/// and back, corners coincide up to four times, and holes are closed by bridges.
inline GridPolygon grownFromSquares(int squares, std::uint64_t seed)
{
    std::mt19937_64                                 random(seed);
    std::vector<GridPoint>                          ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::set<std::pair<std::int64_t, std::int64_t>> taken{{0, 0}};  // lower left corners
    while (static_cast<int>(taken.size()) < squares) {
        const std::size_t i = random() % ring.size();
        const GridPoint   a = ring[i], b = ring[(i + 1) % ring.size()];
        const GridPoint   out{b.y - a.y, a.x - b.x};  // to the right of a -> b
        const GridPoint   c{a.x + out.x, a.y + out.y}, d{b.x + out.x, b.y + out.y};
        const std::pair   cell{std::min({a.x, b.x, c.x, d.x}), std::min({a.y, b.y, c.y, d.y})};
        if (!taken.insert(cell).second) continue;
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, {c, d});
    }
    for (GridPoint& p : ring) p = {p.x * 8, p.y * 8};
    return {"grown from " + std::to_string(squares) + " squares, seed " + std::to_string(seed), ring};
}

inline std::vector<GridPolygon> cuttablePolygons()
{
    return {
        {"dart", {{0, 0}, {100, 0}, {30, 30}, {0, 100}}},
        {"clockwise dart", {{0, 0}, {0, 100}, {30, 30}, {100, 0}}},
        star(5, 1000, 300),
        star(150, 100000, 60000),
        comb(3, 300),
        comb(50, 300, 4000),
        spiral(40, 3, 1000),
        spiral(400, 9, 1000),
        bridgedRing(32, 10000, 4000),
        bridgedRing(4, 100, 50),
        {"hole bridged along an edge",
         {{0, 0}, {90, 0}, {90, 90}, {0, 90}, {0, 60}, {30, 60}, {60, 60}, {60, 30}, {30, 30}, {30, 60}, {0, 60}}},
        {"two holes on one corner",
         {{0, 0}, {20, 30}, {30, 20}, {0, 0}, {60, 20}, {60, 10}, {0, 0}, {100, 0}, {100, 100}, {0, 100}}},
        {"hole touching a corner", {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}, {30, 60}, {60, 30}}},
        {"hole touching an edge from inside",
         {{0, 0}, {50, 0}, {30, 40}, {70, 40}, {50, 0}, {100, 0}, {100, 100}, {0, 100}}},
        {"bridged hole touching an edge",
         {{0, 0},
          {100, 0},
          {100, 100},
          {50, 100},
          {50, 60},
          {70, 50},
          {50, 0},
          {30, 50},
          {50, 60},
          {50, 100},
          {0, 100}}},
        {"notch touching an edge", {{0, 0}, {100, 0}, {100, 100}, {60, 100}, {50, 0}, {40, 100}, {0, 100}}},
        {"spike outwards", {{0, 0}, {100, 0}, {100, 50}, {180, 50}, {100, 50}, {100, 100}, {0, 100}}},
        {"spike inwards", {{0, 0}, {100, 0}, {100, 50}, {20, 50}, {100, 50}, {100, 100}, {0, 100}}},
        {"two squares and a bridge",
         {{0, 0},
          {40, 0},
          {40, 20},
          {60, 20},
          {60, 0},
          {100, 0},
          {100, 40},
          {60, 40},
          {60, 20},
          {40, 20},
          {40, 40},
          {0, 40}}},
        {"repeated corners", {{0, 0}, {0, 0}, {100, 0}, {100, 0}, {100, 0}, {30, 30}, {30, 30}, {0, 100}, {0, 0}}},
        {"collinear runs",
         {{0, 0},
          {25, 0},
          {50, 0},
          {75, 0},
          {100, 0},
          {100, 50},
          {100, 100},
          {50, 50},
          {25, 75},
          {0, 100},
          {0, 66},
          {0, 33}}},
        {"stair", {{0, 0}, {90, 0}, {90, 30}, {60, 30}, {60, 60}, {30, 60}, {30, 90}, {0, 90}}},
        {"square with flat corners around a square hole",
         {{0, 0},
          {50, 0},
          {100, 0},
          {100, 50},
          {100, 100},
          {50, 100},
          {0, 100},
          {0, 50},
          {0, 0},
          {25, 25},
          {25, 50},
          {25, 75},
          {75, 75},
          {75, 25},
          {25, 25}}},
    };
}

/// +1 left of a -> b, -1 right, 0 on it; coordinates below 2^30.
inline int sideOf(GridPoint a, GridPoint b, GridPoint p)
{
    const std::int64_t turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    return (turn > 0) - (turn < 0);
}

/// How often the outline runs round p counter-clockwise; p on no edge.
inline int windingAround(const std::vector<GridPoint>& outline, GridPoint p)
{
    int winding = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const GridPoint a = outline[i], b = outline[(i + 1) % outline.size()];
        if (a.y <= p.y && b.y > p.y && sideOf(a, b, p) > 0) ++winding;
        if (a.y > p.y && b.y <= p.y && sideOf(a, b, p) < 0) --winding;
    }
    return winding;
}

inline std::vector<std::uint32_t> inOrder(std::size_t count)
{
    std::vector<std::uint32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

inline std::vector<dvec3> inPlane(const std::vector<GridPoint>& points)
{
    std::vector<dvec3> positions;
    for (const GridPoint& p : points) positions.push_back({static_cast<double>(p.x), static_cast<double>(p.y), 0.0});
    return positions;
}

}  // namespace zscope::test
