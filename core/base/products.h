// Products of two vectors in float64 with one rounding per written operation, in the written order: cameras and
// patterns are defined to the bit (docs/correctness.md), and a library may regroup.
#pragma once

#include "core/base/affine.h"

namespace zscope {

inline double dotAsWritten(const dvec3& a, const dvec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

inline dvec3 crossAsWritten(const dvec3& a, const dvec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace zscope
