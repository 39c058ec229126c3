// What the definition says about one triangle: the parts that survive the near plane, which pixel centres each
// part covers, and the depth it has there. Everything that calls itself the reference is made from this file.
//
// Arithmetic  the float64 expressions of docs/correctness.md, section 2a, in the written order, one rounding per
//             operation; coverage in 128-bit integers on the snapped grid, where corners reach 2^61
// Grid        1/256 pixel; pixel (i, j) has its centre at (256 i + 128, 256 j + 128); y points down
// Promise     shares no code with the algorithms it judges: only the scene's values and core/base
// Source      docs/correctness.md, sections 1 to 4
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::definition {

__extension__ typedef __int128 Wide;

/// The camera with what is computed once per frame.
struct View {
    View(const Camera& camera, FaceCulling faceCulling);

    Camera      camera;
    FaceCulling faceCulling;
    double      k;         // view-space x / z, times near, to pixels
    float       farDepth;  // a sample is kept iff its depth is at least this
};

struct Corner {
    double       x = 0, y = 0;    // pixels, before snapping
    double       depth = 0;       // near / z, in (0, 1]
    std::int64_t xs = 0, ys = 0;  // snapped, 1/256 pixel
};

/// Pixels [x0, x1] x [y0, y1], both ends included; empty if x0 > x1 or y0 > y1.
struct PixelBox {
    int x0 = 0, x1 = -1, y0 = 0, y1 = -1;

    bool isEmpty() const { return x0 > x1 || y0 > y1; }
    bool holds(int x, int y) const { return x0 <= x && x <= x1 && y0 <= y && y <= y1; }
};
/// The pixels of the picture whose centres lie in a box of the grid, borders included.
PixelBox pixelsWithin(std::int64_t minXs, std::int64_t maxXs, std::int64_t minYs, std::int64_t maxYs,
                      const Camera& camera);

/// One side of a part, with the part on its positive side.
struct Side {
    Wide xa = 0, ya = 0;  // where it starts, 1/256 pixel
    Wide dx = 0, dy = 0;
    Wide bias = 0;  // 0: centres exactly on a left or top side belong; 1: on others they do not

    /// The edge function at the centre of (i, j), less the bias: inside iff >= 0.
    Wide at(int i, int j) const { return dx * (Wide{256} * j + 128 - ya) - dy * (Wide{256} * i + 128 - xa) - bias; }
    /// What at() gains from one pixel to the next on the right.
    Wide perPixel() const { return Wide{-256} * dy; }
};

/// Where a triangle has holes, and how far back its relief lies: docs/correctness.md, Cut-outs and Reliefs.
class Patterns {
public:
    /// `model` and `view` are corners of the first triangle of its face in the mesh's space and in view space, before
    /// clipping.
    Patterns(const Material& material, const std::array<dvec3, 3>& model, const std::array<dvec3, 3>& view,
             const Camera& camera);

    bool   isHole(int i, int j) const;
    bool   hasRelief() const { return m_relief.has_value(); }
    double movedBack(double depth, int i, int j) const;
    /// What the deepest place of the relief would make of it.
    double movedBackWholly(double depth) const { return depth / (1 + depth * m_deepest); }

private:
    struct Cell {
        double a = 0, b = 0;  // coordinates on the face, in cells of a pattern
    };
    Cell cellAt(int i, int j, double size) const;
    /// From 0, on the face, to 1.
    double reliefAt(int i, int j) const;
    /// A pattern coordinate: `origin` at the first corner, `gain` along the ray through a pixel.
    struct Coordinate {
        double origin = 0;
        dvec3  gain{0};
    };
    Coordinate coordinate(const std::array<double, 3>& ofCorner) const;

    std::optional<Cutout> m_cutout;
    std::optional<Relief> m_relief;
    double                m_deepest = 0;  // of the relief, in near distances
    std::array<dvec3, 3>  m_view;
    dvec3                 m_weight;  // the plane's normal, not of length 1
    Coordinate            m_first, m_second;
    double                m_halfWidth, m_halfHeight, m_focal;  // pixels
};

/// A triangle in front of the near plane, snapped, with area, facing the viewer as the culling asks.
class Part {
public:
    Part(const std::array<Corner, 3>& corners, Wide doubleArea, const Camera& camera,
         const std::optional<Patterns>& patterns = {}, bool isBack = false);

    bool isBack() const { return m_isBack; }

    const std::array<Corner, 3>& corners() const { return m_corners; }  // in the order of the walk
    const std::array<Side, 3>&   sides() const { return m_sides; }
    const PixelBox&              box() const { return m_box; }  // holds every covered pixel

    bool  covers(int i, int j) const;  // a hole is not covered
    bool  isHole(int i, int j) const { return m_patterns && m_patterns->isHole(i, j); }
    float depth(int i, int j) const;
    /// No fragment of it is farther.
    float farthestDepth() const;

private:
    void   setPlane();
    void   setSides(Wide doubleArea);
    double limitedDepth(int i, int j) const;

    std::array<Corner, 3>   m_corners;
    std::array<Side, 3>     m_sides;
    PixelBox                m_box;
    std::optional<Patterns> m_patterns;
    double                  m_a = 0, m_b = 0, m_c = 0;  // depth = a x + b y + c at pixel centres
    float                   m_lo = 0, m_hi = 0;         // limits: the nearest and farthest corner
    bool                    m_isBack;                   // the viewer sees its back
    bool                    m_isFlat = false;           // no plane could be computed: depth is m_hi
};

/// What became of a triangle. Of two parts the better fate counts: the first in this order.
enum class Fate { Drawn, Culled, Degenerate, OutOfRange, BehindNear, Transparent };

/// Left and right change places: the determinant is below 0, in the arithmetic of the definition.
bool isMirrored(const Affine& matrix);

/// Replaces `parts` by the parts of one triangle that may cover pixels: none unless the answer is Drawn.
Fate partsOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle, const View& view,
             std::vector<Part>& parts);

/// The same for a triangle that is blended over the opaque picture; false, and no parts, for any other.
bool transparentPartsOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle, const View& view,
                        std::vector<Part>& parts);

/// Every pixel that any triangle of the instance can cover; `meshBox` holds all positions of its mesh.
PixelBox reachOf(const Bounds& meshBox, const Affine& toWorld, const View& view);

}  // namespace zscope::definition
