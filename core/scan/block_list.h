// Small triangles that wait to become pixels, and the blocks of the picture that each of them may cover.
//
// Room       grows to what a batch needs and stays there
// Source     see blocks-inl.h, which fills it and works it off
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/screen_triangle.h"

namespace zscope {

/// What a block needs to know of its triangle. Edge values are divided by 256 and rounded down: integers.
struct BlockTriangle {
    std::array<float, 3> origin, perPixel, perLine;  // of the edges; origin is the value at pixel (x0, y0)
    int                  x0, y0;
    std::uint32_t        rank;
    DepthPlane           depth;
};

struct BlockPlace {
    int x, y;  // its first pixel
};

/// Sides up to this long, in subpixels along each axis, are tested by blocks: 128 pixels.
inline constexpr double kCompactSide = 32768;

inline bool isCompact(const ScreenTriangle& t)
{
    const auto reach = [](const std::array<double, 3>& at) { return std::max({at[0], at[1], at[2]}) - std::min({at[0], at[1], at[2]}); };
    return reach(t.x) <= kCompactSide && reach(t.y) <= kCompactSide;
}

class BlockList {
public:
    void clear() { m_triangleCount = m_blockCount = 0; }

    /// Room for one more triangle; the blocks that are kept from now on are its.
    BlockTriangle& nextTriangle()
    {
        if (m_triangleCount == m_triangles.size()) m_triangles.resize(2 * m_triangles.size() + 64);
        return m_triangles[m_triangleCount++];
    }

    /// Where the next blocks may be written: x + 65536 y of each, and the triangle they belong to.
    struct Room {
        std::uint32_t* places;
        std::uint32_t* triangles;
        std::uint32_t  triangle;
    };
    Room room(std::size_t count)
    {
        if (m_blockCount + count > m_places.size()) {
            m_places.resize(2 * (m_blockCount + count));
            m_owners.resize(m_places.size());
        }
        return {m_places.data() + m_blockCount, m_owners.data() + m_blockCount, static_cast<std::uint32_t>(m_triangleCount - 1)};
    }
    void keep(std::size_t count) { m_blockCount += count; }

    std::size_t size() const { return m_blockCount; }
    BlockPlace  block(std::size_t i) const { return {static_cast<int>(m_places[i] & 0xffff), static_cast<int>(m_places[i] >> 16)}; }
    /// Whose block it is.
    const BlockTriangle& triangle(std::size_t i) const { return m_triangles[m_owners[i]]; }
    std::size_t          bytes() const
    {
        return m_triangles.capacity() * sizeof(BlockTriangle) + (m_places.capacity() + m_owners.capacity()) * sizeof(std::uint32_t);
    }

private:
    std::vector<BlockTriangle> m_triangles;
    std::vector<std::uint32_t> m_places, m_owners;
    std::size_t                m_triangleCount = 0, m_blockCount = 0;
};

}  // namespace zscope
