// Boxes around runs of consecutive things (the corners or edges of one outline), to find those near a segment or a
// triangle without looking at all of them. Neighbours on an outline lie close together, so its order is the tree.
//
// Layout     a complete binary tree in one array: node k has the children 2k and 2k + 1, leaves hold one thing each
// Node       the box around it, and a strip along its longest edge, which keeps thin slanted runs (teeth of a comb,
//            rays of a star) apart where their boxes overlap
// Promise    a search visits every leaf that the shape touches, perhaps more, never fewer
// Cost       building n log n; removing log n; searching about log n plus what is found
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
    std::array<Point2, 2> corners;

    bool misses(const Box2& box) const
    {
        return liesRightOf(corners[0], corners[1], box) || liesRightOf(corners[1], corners[0], box);
    }
};

struct Triangle2 {
    std::array<Point2, 3> corners;  // counter-clockwise

    bool misses(const Box2& box) const
    {
        return liesRightOf(corners[0], corners[1], box) || liesRightOf(corners[1], corners[2], box)
               || liesRightOf(corners[2], corners[0], box);
    }
};

/// The places whose distance from a line through the origin of the tree, times the length of `along`, is in [low,
/// high].
struct Strip {
    Point2 along;
    double low  = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    /// Widened by more than rounding can move p across; what leaves the range of float64 makes it hold everything.
    void include(const Point2& p, const Point2& origin)
    {
        constexpr double kErrorBound = 4 * std::numeric_limits<double>::epsilon();
        const double     left        = along.x * (p.y - origin.y);
        const double     right       = along.y * (p.x - origin.x);
        const double     margin      = kErrorBound * (std::fabs(left) + std::fabs(right)) + 0x1p-960;
        const double     from        = left - right - margin;
        const double     to          = left - right + margin;
        low  = from >= low ? low : std::isnan(from) ? -std::numeric_limits<double>::infinity() : from;
        high = to <= high ? high : std::isnan(to) ? std::numeric_limits<double>::infinity() : to;
    }
};

class BoxTree {
public:
    /// Leaf i is corner i of the closed ring.
    void buildOverCorners(std::span<const Point2> ring) { build(ring, 1); }
    /// Leaf i is the edge from corner i to the next.
    void buildOverEdges(std::span<const Point2> ring) { build(ring, 2); }

    void remove(std::size_t leaf)
    {
        m_nodes[m_leaves + leaf].box = Box2{};
        for (std::size_t node = (m_leaves + leaf) / 2; node >= 1; node /= 2) joinBoxes(node);
    }
    /// Calls found(leaf) in rising order for leaves near the shape until it answers true; says whether it did.
    template <class Shape, class Found>
    bool anyNear(const Shape& shape, const Found& found) const
    {
        Box2 around;
        for (const Point2& corner : shape.corners) around.include(corner);
        std::array<std::size_t, 64> open;  // one right child per level of a tree of fewer than 2^63 leaves
        std::size_t                 count = 0;
        open[count++]                     = 1;
        while (count > 0) {
            const std::size_t index = open[--count];
            const Node&       node  = m_nodes[index];
            if (!around.touches(node.box) || shape.misses(node.box) || isBeside(shape, node.strip)) continue;
            if (index >= m_leaves) {
                if (found(index - m_leaves)) return true;
                continue;
            }
            open[count++] = 2 * index + 1;
            open[count++] = 2 * index;
        }
        return false;
    }

private:
    struct Node {
        Box2  box;
        Strip strip;
    };

    template <class Shape>
    bool isBeside(const Shape& shape, const Strip& strip) const
    {
        Strip own{strip.along};
        for (const Point2& corner : shape.corners) own.include(corner, m_origin);
        return own.high < strip.low || strip.high < own.low;
    }

    /// `corners` of the ring belong to each leaf: its own, and perhaps the next.
    void build(std::span<const Point2> ring, std::size_t corners)
    {
        const std::size_t n = ring.size();
        m_leaves            = std::bit_ceil(n < 1 ? std::size_t{1} : n);
        m_origin            = n > 0 ? ring[0] : Point2{};
        m_nodes.assign(2 * m_leaves, Node{});
        for (std::size_t i = 0; i < n; ++i) {
            const Point2& next = ring[i + 1 == n ? 0 : i + 1];
            Node&         leaf = m_nodes[m_leaves + i];
            leaf.box.include(ring[i]);
            if (corners == 2) leaf.box.include(next);
            leaf.strip.along = {next.x - ring[i].x, next.y - ring[i].y};
        }
        for (std::size_t node = m_leaves; node-- > 1;) {
            joinBoxes(node);
            const Point2& left       = m_nodes[2 * node].strip.along;
            const Point2& right      = m_nodes[2 * node + 1].strip.along;
            const bool    leftIsLong = std::fabs(left.x) + std::fabs(left.y) >= std::fabs(right.x) + std::fabs(right.y);
            m_nodes[node].strip.along = leftIsLong ? left : right;
        }
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < corners; ++k)
                for (std::size_t node = m_leaves + i; node >= 1; node /= 2)
                    m_nodes[node].strip.include(ring[i + k == n ? 0 : i + k], m_origin);
    }
    void joinBoxes(std::size_t node)
    {
        Box2 both = m_nodes[2 * node].box;
        both.include(m_nodes[2 * node + 1].box);
        m_nodes[node].box = both;
    }

    std::size_t       m_leaves = 0;
    Point2            m_origin;
    std::vector<Node> m_nodes;
};

}  // namespace zscope
