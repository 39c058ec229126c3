// What a sweep must hold on every line, worked out without a sweep: each side of each part against each line's
// centre, in whole numbers.
//
// Arithmetic  snapped corners from the definition (core/measure), then 128-bit integers and a division per line
// Shares      nothing with the edge table, the steppers or the active edge table it judges
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "core/measure/definition.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::tests {

using definition::Wide;

/// A side of a part of a triangle, on a line it crosses.
struct TrueEdge {
    std::uint32_t polygon = 0;
    std::int64_t  xFloor  = 0;           // 1/256 pixel, rounded down
    Wide          over = 0, height = 1;  // what the rounding dropped: over / height, in [0, 1)
    std::int64_t  dxNumerator = 0, dxDenominator = 1;
    int           firstLine = 0, lastLine = 0;  // of the picture, inclusive
    bool          isWide = false;               // its part reaches beyond the guard band

    double pixels() const;
    /// Exactly left of `other`, or at the same place.
    bool isNotRightOf(const TrueEdge& other) const;
};

/// How often each pixel of a line is covered, by triangle: a triangle cut in two counts once per part.
using CoverOfLine = std::map<std::uint32_t, std::map<int, int>>;

class SweepTruth {
public:
    SweepTruth(const Scene& scene, const Camera& camera, FaceCulling faceCulling);

    std::vector<TrueEdge> activeOn(int y) const;  // in no order
    CoverOfLine           coverOf(int y) const;

private:
    /// Half-open, as scanline methods fill.
    struct Box {
        std::int64_t x0, x1, y0, y1;
    };
    struct Member {
        std::uint32_t    polygon;
        definition::Part part;
        Box              box;
    };

    std::vector<Member> m_parts;  // those with a pixel centre of the picture in their box
    Camera              m_camera;
};

}  // namespace zscope::tests
