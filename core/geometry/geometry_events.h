// What the geometry stage tells: which triangles never reach the pixels, and why.
#pragma once

#include <cstdint>

#include "core/base/ids.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

/// Triangles with opacity below 1 are in no batch: they are outside ids and depth.
struct TransparentLeftOut {
    InstanceId    instance;
    std::uint32_t triangles;
};

/// A whole batch lies outside the picture or behind the eye; none of its triangles is looked at.
struct BatchOutside {
    InstanceId    instance;
    std::uint32_t triangles;
};

/// A batch's vertices have been transformed and snapped.
struct BatchTransformed {
    InstanceId    instance;
    std::uint32_t vertices;
};

/// The fate of one triangle at set-up, told once per triangle: Drawn if any part of it is.
struct TriangleSetUp {
    TriangleId triangle;
    SetUp      fate;
    bool       cut;                // by the near plane, which left a part of it
    bool       wide;               // took the 128-bit path
    bool       isFlipped = false;  // fronts are taken for backs (a fault)
};

/// A face as it was read has been set up: as one polygon, or triangle by triangle. Told after its triangles.
struct FaceSetUpAs {
    enum class How {
        Triangle,  // it is one
        Outline,   // by its sides
        // by its triangles: some show their fronts, some their backs; not plane, or turned over by snapping
        UnlikeTurns,
        Thin,  // by its triangles: seen edge on, so that its plane would be nothing but rounding
    };
    TriangleId face;  // its first triangle
    How        how;
    bool       isDrawn;
};

}  // namespace zscope
