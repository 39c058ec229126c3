// One triangle in exact geometry (float64, before snapping), and how far a careful renderer may move it: the rule by
// which a difference counts as rounding.
//
// Careful     such a renderer transforms vertices in float32 and may snap them to a grid of its own. Its corners lie at
//             most `d` from where exact geometry has them: half a step of its grid or of ours, whichever is more, plus
//             12 roundings of float32 (2^-24 each) of the numbers that are added up to place a vertex
//             (core/geometry/displacement.h), plus 6 roundings of the pixel position
// Displaced   `d` grows towards the eye: an error of the vertex is worth more pixels there. It is found at each sample,
//             along x and y apart, and an edge moves by |nx| dx + |ny| dy across itself
// Depth       the plane of moved corners differs at a sample by at most |slope| d, and never by more than its corners
//             differ; an error of z itself comes on top
// Source      docs/check.md, What counts as rounding
#pragma once

#include <array>

#include "core/base/ids.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::check {

/// How a sample lies to a triangle.
struct Place {
    bool   isPossible = false;  // a careful renderer may cover it
    bool   isCertain  = false;  // every careful renderer covers it
    double depth      = 0;      // near/z of the triangle's plane there, limited to its corners
    double slack      = 0;      // of that depth, absolute: what a displacement by d may change

    bool isNearEdge() const { return isPossible && !isCertain; }
};

class ExactTriangle {
public:
    /// `halfStep`: of the coarser sub-pixel grid, pixels. Nothing remains of a triangle that is transparent or lies
    /// behind the near plane: its places are impossible.
    ExactTriangle(const Scene& scene, const Camera& camera, TriangleId id, double halfStep);

    /// At the centre of pixel (i, j).
    Place placeOf(int i, int j) const;
    /// The part of placeOf() that concerns depth.
    Place depthOf(int i, int j) const;

    bool isEmpty() const { return m_count == 0; }
    /// Of the reference's own sub-pixel grid: how far its corners lie from exact ones.
    static constexpr double kOurStep = 1.0 / 512;
    /// The most that one of its corners may be moved, pixels.
    double mostShift() const { return m_mostShift; }
    /// A corner may be moved across the centre of this line from where the reference has it.
    bool mayEndAt(int line) const;
    /// It may be left out on a grid: it is so thin that it may have no area, or so small that its box may hold no
    /// pixel's centre.
    bool mayVanish() const;
    bool isCutByNear() const { return m_isCut; }
    /// The viewer surely sees its back: no displacement turns it over.
    bool isSurelyBack() const { return m_isSurelyBack; }
    /// Pixels whose centres may be covered: [x0, x1] x [y0, y1], limited to the picture; empty if x0 > x1.
    struct Box {
        int x0 = 0, x1 = -1, y0 = 0, y1 = -1;
    };
    Box box() const;

private:
    struct Corner {
        double x = 0, y = 0, depth = 0;  // pixels; near/z
        bool   isCrossing = false;       // made by the near plane
    };
    struct Shift {
        double x = 0, y = 0;  // pixels
    };
    Shift  shiftAt(double x, double y, double depth) const;
    void   setBack(bool isMirrored);
    double doubleArea() const;

    const Camera*         m_camera;
    std::array<Corner, 4> m_corners;
    int                   m_count        = 0;
    bool                  m_isCut        = false;
    bool                  m_isSurelyBack = false;
    double                m_halfStep;
    double                m_scale;                                           // view-space x / z to pixels
    dvec3                 m_error{0};                                        // of view space, most of the three corners
    double                m_zError = 0;                                      // of the depth at the sample: relative
    double                m_a = 0, m_b = 0, m_c = 0;                         // depth = a x + b y + c
    double                m_lo = 0, m_hi = 0;                                // of the corners
    double                m_left = 0, m_right = 0, m_top = 0, m_bottom = 0;  // of corners, each moved by d
    double                m_mostShift = 0;
    bool                  m_isThin    = false;
    bool                  m_isEdgeOn  = false;  // the plane goes through the eye
};

}  // namespace zscope::check
