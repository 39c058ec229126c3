#include "core/scene/orientation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace zscope {

namespace {

__extension__ typedef unsigned __int128 Wide;

/// A finite float64 taken apart: (negative ? -1 : 1) * mantissa * 2^exponent, mantissa below 2^53.
struct Parts {
    std::uint64_t mantissa;
    int           exponent;  // -1074 .. 971
    bool          negative;

    explicit Parts(double value)
    {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        const int  raw  = static_cast<int>((bits >> 52) & 0x7FF);
        negative        = (bits >> 63) != 0;
        mantissa        = (bits & 0xF'FFFF'FFFF'FFFFull) | (raw == 0 ? 0 : 1ull << 52);
        exponent        = (raw == 0 ? 1 : raw) - 1075;
    }
};

struct Product {
    Wide magnitude;  // below 2^106
    int  exponent;
    bool negative;

    Product(const Parts& a, const Parts& b, bool negated)
        : magnitude(static_cast<Wide>(a.mantissa) * b.mantissa), exponent(a.exponent + b.exponent),
          negative((a.negative != b.negative) != negated)
    {}
};

/// Magnitude of a sum in units of 2^base, 64 bits per limb, least first. The widest span of exponents,
/// 2 * (971 + 1074) bits, and a product with room for carries take less than 67 limbs.
class FixedPoint {
public:
    FixedPoint(int base, int limbs) : m_base(base), m_limbs(limbs) { std::fill_n(m_limb.begin(), limbs, 0); }

    void add(const Product& product)
    {
        const int   offset = product.exponent - m_base;
        std::size_t limb   = static_cast<std::size_t>(offset / 64);
        const int   shift  = offset % 64;
        const auto  low    = static_cast<std::uint64_t>(product.magnitude);
        const auto  high   = static_cast<std::uint64_t>(product.magnitude >> 64);
        const Wide  first  = static_cast<Wide>(low) << shift;
        const Wide  second = static_cast<Wide>(high) << shift;  // high is below 2^42, so nothing is lost
        Wide        carry  = static_cast<Wide>(m_limb[limb]) + static_cast<std::uint64_t>(first);
        m_limb[limb]       = static_cast<std::uint64_t>(carry);
        carry              = (carry >> 64) + m_limb[limb + 1] + static_cast<std::uint64_t>(first >> 64)
                + static_cast<std::uint64_t>(second);
        m_limb[limb + 1] = static_cast<std::uint64_t>(carry);
        carry            = (carry >> 64) + m_limb[limb + 2] + static_cast<std::uint64_t>(second >> 64);
        m_limb[limb + 2] = static_cast<std::uint64_t>(carry);
        for (limb += 3; (carry >> 64) != 0; ++limb) {
            carry        = (carry >> 64) + m_limb[limb];
            m_limb[limb] = static_cast<std::uint64_t>(carry);
        }
    }
    int compare(const FixedPoint& other) const
    {
        for (int i = m_limbs; i-- > 0;) {
            const auto at = static_cast<std::size_t>(i);
            if (m_limb[at] != other.m_limb[at]) return m_limb[at] > other.m_limb[at] ? 1 : -1;
        }
        return 0;
    }

private:
    std::array<std::uint64_t, 70> m_limb;
    int                           m_base, m_limbs;
};

/// Sign of ax*by - ay*bx + bx*cy - by*cx + cx*ay - cy*ax, every product and sum exact.
int exactOrientation(const Point2& a, const Point2& b, const Point2& c)
{
    const Parts                  ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
    const std::array<Product, 6> products{Product(ax, by, false), Product(ay, bx, true),  Product(bx, cy, false),
                                          Product(by, cx, true),  Product(cx, ay, false), Product(cy, ax, true)};
    int                          lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
    for (const Product& p : products) {
        if (p.magnitude == 0) continue;
        lowest  = std::min(lowest, p.exponent);
        highest = std::max(highest, p.exponent);
    }
    if (lowest > highest) return 0;
    const int  limbs = (highest - lowest) / 64 + 4;
    FixedPoint positive(lowest, limbs), negative(lowest, limbs);
    for (const Product& p : products)
        if (p.magnitude != 0) (p.negative ? negative : positive).add(p);
    return positive.compare(negative);
}

}  // namespace

int orientation(const Point2& a, const Point2& b, const Point2& c)
{
    // On one axis-parallel line, the commonest way of being in line: no arithmetic needed.
    if ((a.x == c.x && b.x == c.x) || (a.y == c.y && b.y == c.y)) return 0;

    constexpr double kHalfUnit    = std::numeric_limits<double>::epsilon() / 2;  // 2^-53
    constexpr double kErrorBound  = (3 + 16 * kHalfUnit) * kHalfUnit;
    constexpr double kNoUnderflow = 0x1p-960;  // above it, what a product may have lost below 2^-1074 is covered too
    const double     left         = (a.x - c.x) * (b.y - c.y);
    const double     right        = (a.y - c.y) * (b.x - c.x);
    const double     sum          = std::fabs(left) + std::fabs(right);
    const double     det          = left - right;
    if (sum > kNoUnderflow && sum <= std::numeric_limits<double>::max() && std::fabs(det) > kErrorBound * sum)
        return det > 0 ? 1 : -1;
    if (a == c || b == c || a == b) return 0;
    return exactOrientation(a, b, c);
}

}  // namespace zscope
