// A 3 x 4 affine transform in float64, applied with one rounding per written operation and in the
// written order, so that every program that follows docs/correctness.md gets the same bits.
#pragma once

#include <array>
#include <cmath>

#include <glm/vec3.hpp>

namespace zscope {

using glm::dvec3;

inline bool isFinite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Rows of the matrix: p' = (row . p) + offset, per row ((m0*x + m1*y) + m2*z) + m3.
struct Affine {
    std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

    dvec3 operator()(const dvec3& q) const { return in<double>(q); }
    /// The same in another arithmetic: float, as an approximation.
    template <class Real>
    dvec3 in(const dvec3& point) const
    {
        const glm::vec<3, Real> q(point);
        const auto              row = [&q](const std::array<double, 4>& m) {
            const auto at = [&m](std::size_t i) { return static_cast<Real>(m[i]); };
            return ((at(0) * q.x + at(1) * q.y) + at(2) * q.z) + at(3);
        };
        return {row(rows[0]), row(rows[1]), row(rows[2])};
    }
    /// The identity leaves a point exactly as it is, so callers may skip it.
    bool isIdentity() const { return *this == Affine{}; }
    /// True if it turns left into right: its determinant is below 0, in the arithmetic of docs/correctness.md. Not so
    /// of a flat one, nor of one whose determinant is NaN.
    bool isMirrored() const
    {
        const auto& [a, b, c] = rows;
        const double det      = (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]))
                           + a[2] * (b[0] * c[1] - b[1] * c[0]);
        return det < 0;
    }

    friend bool operator==(const Affine&, const Affine&) = default;

    static Affine translation(const dvec3& by)
    {
        Affine a;
        a.rows[0][3] = by.x;
        a.rows[1][3] = by.y;
        a.rows[2][3] = by.z;
        return a;
    }
};

/// `outer` after `inner`.
inline Affine compose(const Affine& outer, const Affine& inner)
{
    Affine result;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 4; ++c) {
            double sum = c == 3 ? outer.rows[r][3] : 0.0;
            for (std::size_t k = 0; k < 3; ++k) sum += outer.rows[r][k] * inner.rows[k][c];
            result.rows[r][c] = sum;
        }
    }
    return result;
}

}  // namespace zscope
