// A pixel, and a rectangle of pixels.
#pragma once

#include <algorithm>
#include <cstdint>

namespace zscope {

struct PixelPosition {
    int x = 0;
    int y = 0;

    friend bool operator==(const PixelPosition&, const PixelPosition&) = default;
};

/// Pixels [x0, x1) x [y0, y1).
struct PixelBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    /// Grows to hold another box as well; neither is empty.
    void include(const PixelBox& other)
    {
        *this = {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1), std::max(y1, other.y1)};
    }
    /// How many; it is not empty.
    std::uint64_t area() const { return static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0); }
    bool          holds(PixelPosition p) const { return x0 <= p.x && p.x < x1 && y0 <= p.y && p.y < y1; }
    bool          isEmpty() const { return x0 >= x1 || y0 >= y1; }
    friend bool   operator==(const PixelBox&, const PixelBox&) = default;
};

}  // namespace zscope
