// How a depth is stored. Whatever the format, the stored value is a float32 of which the larger is the nearer, so that the
// depth test, the pyramid and every query compare alike.
//
// Depth      D = near/z, in (0, 1]; background is below everything that is kept
// Reversed   the definition's: D itself, rounded to float32
// Standard   S = (1 - D) * far/(far - near), which grows from 0 at the near plane to 1 at the far plane; stored as -S, in
//            float32 or rounded to 24 or 16 bits. Nearly all its values lie close to 1, where the format is coarse
// Source     docs/correctness.md, Depth and the winner
#pragma once

#include <cmath>
#include <limits>

namespace zscope {

enum class DepthFormat { ReversedFloat32, StandardFloat32, Fixed24, Fixed16 };

struct DepthEncoding {
    DepthFormat format = DepthFormat::ReversedFloat32;
    double      range  = 1;  // far/(far - near); 1 if there is no far plane
    double      steps  = 0;  // of the fixed formats: S = 1 is this code, which is stored as -code/(steps + 1)
    float       empty  = 0;  // what background holds: the largest stored value that is not kept

    DepthEncoding() = default;
    DepthEncoding(DepthFormat as, double near, double far)
        : format(as), range(std::isinf(far) ? 1 : far / (far - near)), steps(as == DepthFormat::Fixed16 ? 65535.0 : 16777215.0)
    {
        const float farthest = isReversed() ? static_cast<float>(near / far) : -1.0f;
        empty = isFixed() ? -1.0f : std::nextafter(farthest, -std::numeric_limits<float>::infinity());
    }

    /// The definition's format with a background of the caller's choice.
    static DepthEncoding withBackground(float empty)
    {
        DepthEncoding encoding;
        encoding.empty = empty;
        return encoding;
    }

    bool isReversed() const { return format == DepthFormat::ReversedFloat32; }
    bool isFixed() const { return format == DepthFormat::Fixed24 || format == DepthFormat::Fixed16; }

    /// Never falls where `depth` grows.
    [[gnu::always_inline]] float stored(double depth) const
    {
        if (isReversed()) return static_cast<float>(depth);
        const double standard = (1 - depth) * range;
        return static_cast<float>(isFixed() ? std::nearbyint(standard * steps) * -(1 / (steps + 1)) : -standard);
    }
    /// The depth that a stored value stands for.
    float depthOf(float value) const
    {
        if (isReversed()) return value;
        const double standard = isFixed() ? value * -(steps + 1) / steps : -static_cast<double>(value);
        return static_cast<float>(1 - standard / range);
    }
};

}  // namespace zscope
