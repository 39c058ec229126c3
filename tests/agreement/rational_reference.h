// The definition without its rounding: one triangle from the mesh to the depth at a pixel in exact rational numbers.
// Only what the definition says is rounded is rounded, from the exact value: corners to the grid, depths to float32.
//
// Purpose    measures what the float64 arithmetic of docs/correctness.md, section 2a, costs (level L2)
// Cost       some microseconds per pixel and triangle: for small pictures only
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <gmpxx.h>

#include "core/measure/definition.h"

namespace zscope::tests {

struct RationalCorner {
    mpq_class x, y;    // pixels
    mpq_class depth;   // near / z
    mpz_class xs, ys;  // snapped, ties to even of the exact value
};

class RationalPart {
public:
    explicit RationalPart(const std::array<RationalCorner, 3>& corners);

    const std::array<RationalCorner, 3>& corners() const { return m_corners; }

    /// Replaces the snapped corners, where the definition's float64 came to lie on the other side of a tie.
    void adoptSnapped(const std::array<definition::Corner, 3>& corners);

    int   sign() const;                // of the snapped area: 0 degenerate, negative front
    bool  covers(int i, int j) const;  // sign() must not be 0
    float depth(int i, int j) const;   // nearest even of the exact plane, within the limits; hi if edge-on
    float lo() const { return m_lo; }
    float hi() const { return m_hi; }
    /// The unsnapped part is thicker than 1/1024 pixel, so that its plane means something.
    bool isThick() const { return m_isThick; }

private:
    std::array<RationalCorner, 3> m_corners;
    mpq_class                     m_a, m_b, m_c;  // depth = a x + b y + c
    bool                          m_isEdgeOn = false;
    bool                          m_isThick  = false;
    float                         m_lo = 0, m_hi = 0;
};

struct RationalTriangle {
    std::vector<RationalPart> parts;         // in front of the near plane, those without area included
    int                       nearTies = 0;  // corners so close to the near plane that float64 took the other side
    /// An edge lies in the near plane but for rounding and is yet cut by it: where it is cut, rounding alone decides.
    bool cutIsOpen = false;
};
/// Where float64 decides otherwise which side of the near plane a corner is on, and the corner is within 2^-40 of
/// the plane, its decision is followed, and counted.
RationalTriangle rationalTriangle(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle,
                                  const Camera& camera);

/// Nearest even; `value` in [0, 1], float32 denormals included.
float toFloat(const mpq_class& value);
/// Nearest even.
mpz_class toInteger(const mpq_class& value);

}  // namespace zscope::tests
