// Random numbers of our own, so that a seed means the same scene everywhere.
//
// Source     Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators (SplitMix64), OOPSLA 2014
#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/affine.h"

namespace zscope {

class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t bits()
    {
        m_state += 0x9E37'79B9'7F4A'7C15ull;
        std::uint64_t z = m_state;
        z               = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9ull;
        z               = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBull;
        return z ^ (z >> 31);
    }
    /// In [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// Between the two, `low` included; `low` when they are equal.
    double between(double low, double high) { return low + unit() * (high - low); }
    /// In [0, count); count > 0. The bias of one part in 2^64 / count does not show in a scene.
    std::uint64_t below(std::uint64_t count) { return bits() % count; }

    dvec3 between(const dvec3& low, const dvec3& high)
    {
        const double x = between(low.x, high.x);  // one statement each: the order of the draws is fixed
        const double y = between(low.y, high.y);
        const double z = between(low.z, high.z);
        return {x, y, z};
    }

    /// A rotation, uniform over all of them, as the linear part of a matrix.
    /// Marsaglia: Choosing a Point from the Surface of a Sphere, 1972, for the unit quaternion.
    Affine rotation()
    {
        double a = 0, b = 0, s = 2;
        while (s >= 1) {
            a = between(-1, 1);
            b = between(-1, 1);
            s = a * a + b * b;
        }
        double c = 0, d = 0, t = 2;
        while (t >= 1 || t == 0) {
            c = between(-1, 1);
            d = between(-1, 1);
            t = c * c + d * d;
        }
        const double stretch = std::sqrt((1 - s) / t);
        const double w = a, x = b, y = c * stretch, z = d * stretch;
        Affine       turn;
        turn.rows[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 0};
        turn.rows[1] = {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 0};
        turn.rows[2] = {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), 0};
        return turn;
    }

private:
    std::uint64_t m_state;
};

}  // namespace zscope
