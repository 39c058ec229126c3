// How a depth is stored. Whatever the format, the stored value is a float32 of which the larger is the nearer, so that
// the depth test, the pyramid and every query compare alike.
//
// Depth      D = near/z, in (0, 1]; background is below everything that is kept
// Reversed   the definition's: D itself, rounded to float32
// Standard   S = (1 - D) * far/(far - near), which grows from 0 at the near plane to 1 at the far plane; stored as -S,
//            in float32 or rounded to 24 or 16 bits. Nearly all its values lie close to 1, where the format is coarse
// Stacked    reversed depths may be stored times a power of two, which changes their exponents only: the same picture.
//            Pictures of growing scales lie above each other, so that what one has left in memory is background to the
//            next (above())
// Source     docs/correctness.md, Depth and the winner. Stacked: GLQuake's gl_ztrick (id Software, 1997), which gave
//            each picture half of a z-buffer's range, and so lost a bit
#pragma once

#include <cmath>
#include <limits>

namespace zscope {

enum class DepthFormat { ReversedFloat32, StandardFloat32, Fixed24, Fixed16 };

struct DepthEncoding {
    DepthFormat format    = DepthFormat::ReversedFloat32;
    double      range     = 1;      // far/(far - near); 1 if there is no far plane
    double      steps     = 0;      // of the fixed formats: S = 1 is this code, which is stored as -code/(steps + 1)
    float       empty     = 0;      // what background holds: the largest stored value that is not kept
    double      scale     = 1;      // a reversed depth is stored as this many times D: a power of two
    bool        isBounded = false;  // no stored depth is larger than `scale`: reversed, by exact rules

    DepthEncoding() = default;
    DepthEncoding(DepthFormat as, double near, double far)
        : format(as), range(std::isinf(far) ? 1 : far / (far - near)),
          steps(as == DepthFormat::Fixed16 ? 65535.0 : 16777215.0)
    {
        const float farthest = isReversed() ? static_cast<float>(near / far) : -1.0f;
        empty                = isFixed() ? -1.0f : std::nextafter(farthest, -std::numeric_limits<float>::infinity());
    }

    /// The definition's format with a background of the caller's choice.
    static DepthEncoding withBackground(float empty)
    {
        DepthEncoding encoding;
        encoding.empty = empty;
        return encoding;
    }

    /// Of the definition's format, with a far plane, for pictures by exact rules: the least scale at which all that a
    /// picture by `below` may have left is background. Where `below` is not bounded or float32 ends, that of a picture
    /// which must be emptied for; so see isAbove().
    DepthEncoding above(const DepthEncoding& below) const
    {
        constexpr int kLeast = -125, kMost = 126;  // exponents of float32, one from its ends
        const int     own = std::ilogb(empty), above = below.isBounded ? std::ilogb(below.scale) + 1 - own : 0;
        const int     exponent = above <= kMost ? above : kLeast - own;
        DepthEncoding stacked  = *this;
        stacked.scale          = std::ldexp(1.0, exponent);
        stacked.empty          = std::ldexp(empty, exponent);
        stacked.isBounded      = true;
        return stacked;
    }
    /// True if whatever a picture by `below` may hold is farther than what is kept here.
    bool isAbove(const DepthEncoding& below) const { return isBounded && below.isBounded && empty >= 2 * below.scale; }

    bool isReversed() const { return format == DepthFormat::ReversedFloat32; }
    bool isFixed() const { return format == DepthFormat::Fixed24 || format == DepthFormat::Fixed16; }

    /// Never falls where `depth` grows. At scale 1.
    [[gnu::always_inline]] float stored(double depth) const
    {
        if (isReversed()) return static_cast<float>(depth);
        const double standard = (1 - depth) * range;
        return static_cast<float>(isFixed() ? std::nearbyint(standard * steps) * -(1 / (steps + 1)) : -standard);
    }
    /// The depth that a stored value stands for.
    float depthOf(float value) const
    {
        if (isReversed()) return atScaleOne(value);
        const double standard = isFixed() ? value * -(steps + 1) / steps : -static_cast<double>(value);
        return static_cast<float>(1 - standard / range);
    }
    /// What would be stored if the scale were 1.
    float atScaleOne(float value) const { return static_cast<float>(value / scale); }
};

}  // namespace zscope
