// Boxes around runs of consecutive things (the corners or edges of one outline), to find those near a segment or a
// triangle without looking at all of them. Neighbours on an outline lie close together, so its order is the tree.
//
// Layout     a complete binary tree in one array: node k has the children 2k and 2k + 1, leaves hold one box each
// Promise    a search visits every leaf whose box the shape touches, perhaps more, never fewer
// Cost       building 2n boxes; removing log n; searching about log n plus what is found
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/scene/orientation.h"

namespace zscope {

struct Box2 {  // empty while min > max
    Point2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void include(const Point2& p)
    {
        min = {p.x < min.x ? p.x : min.x, p.y < min.y ? p.y : min.y};
        max = {p.x > max.x ? p.x : max.x, p.y > max.y ? p.y : max.y};
    }
    void include(const Box2& other)
    {
        min = {other.min.x < min.x ? other.min.x : min.x, other.min.y < min.y ? other.min.y : min.y};
        max = {other.max.x > max.x ? other.max.x : max.x, other.max.y > max.y ? other.max.y : max.y};
    }
    bool touches(const Box2& other) const
    {
        return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y && other.min.y <= max.y;
    }
};

/// True only if all of `box` lies strictly right of a -> b; rounding, overflow and NaN end in "no".
inline bool liesRightOf(const Point2& a, const Point2& b, const Box2& box)
{
    constexpr double kErrorBound = 4 * std::numeric_limits<double>::epsilon();  // 8 half units; 3 and a bit suffice
    const double     dx          = b.x - a.x;
    const double     dy          = b.y - a.y;
    const double     up          = dx * ((dx >= 0 ? box.max.y : box.min.y) - a.y);
    const double     down        = dy * ((dy >= 0 ? box.min.x : box.max.x) - a.x);
    return up - down < -(kErrorBound * (std::fabs(up) + std::fabs(down)) + 0x1p-960);
}

struct Segment2 {
    Point2 a, b;

    Box2 box() const
    {
        Box2 around;
        around.include(a);
        around.include(b);
        return around;
    }
    bool misses(const Box2& other) const { return liesRightOf(a, b, other) || liesRightOf(b, a, other); }
};

struct Triangle2 {  // counter-clockwise
    Point2 a, b, c;

    Box2 box() const
    {
        Box2 around;
        around.include(a);
        around.include(b);
        around.include(c);
        return around;
    }
    bool misses(const Box2& other) const
    {
        return liesRightOf(a, b, other) || liesRightOf(b, c, other) || liesRightOf(c, a, other);
    }
};

class BoxTree {
public:
    void build(std::span<const Box2> leaves)
    {
        m_leaves = std::bit_ceil(leaves.size() < 1 ? std::size_t{1} : leaves.size());
        m_boxes.assign(2 * m_leaves, Box2{});
        for (std::size_t i = 0; i < leaves.size(); ++i) m_boxes[m_leaves + i] = leaves[i];
        for (std::size_t node = m_leaves; node-- > 1;) joinChildren(node);
    }
    void remove(std::size_t leaf)
    {
        m_boxes[m_leaves + leaf] = Box2{};
        for (std::size_t node = (m_leaves + leaf) / 2; node >= 1; node /= 2) joinChildren(node);
    }
    /// Calls found(leaf) in rising order for leaves near the shape until it answers true; says whether it did.
    template <class Shape, class Found>
    bool anyNear(const Shape& shape, const Found& found) const
    {
        const Box2                  around = shape.box();
        std::array<std::size_t, 64> open;  // one right child per level of a tree of fewer than 2^63 leaves
        std::size_t                 count = 0;
        open[count++] = 1;
        while (count > 0) {
            const std::size_t node = open[--count];
            if (!around.touches(m_boxes[node]) || shape.misses(m_boxes[node])) continue;
            if (node >= m_leaves) {
                if (found(node - m_leaves)) return true;
                continue;
            }
            open[count++] = 2 * node + 1;
            open[count++] = 2 * node;
        }
        return false;
    }

private:
    void joinChildren(std::size_t node)
    {
        Box2 both = m_boxes[2 * node];
        both.include(m_boxes[2 * node + 1]);
        m_boxes[node] = both;
    }

    std::size_t       m_leaves = 0;
    std::vector<Box2> m_boxes;
};

}  // namespace zscope
