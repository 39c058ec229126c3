// The directions that the triangles of a batch face, in one cone: a batch that is seen from behind need not be set up
// triangle by triangle.
//
// Cone       in model space: every triangle's normal lies within an angle of the axis, and the apex lies behind every
//            triangle's plane. An eye behind the apex, outside of the cone that opens there, is behind all planes
// Margin     corners snap to 1/256 pixel, which may turn a thin triangle over. Twice the area of a triangle on the
//            screen is f^2 det h l D / (z0 z1 z2): f pixels per slope, det of the way to view space, h its smallest
//            altitude, l its longest side, D the eye's distance from its plane. Corners that move by e change it by at
//            most e times the perimeter and 4 e^2. Only where it is larger than that is a batch called back-facing; e
//            holds the snapping and every rounding on the way
// Promise    of a batch that isBackFacing() every triangle is SetUp::BackFacing, as the exact arithmetic finds one by
//            one
// Mirrored   an instance that turns left into right turns its fronts, too: in the model nothing changes
// Never      of a batch that reaches before the near plane, of a camera whose axes are mirrored, of a batch with a
//            triangle without area
// Source     Shirman, Abi-Ezzi: The Cone of Normals Technique for Fast Processing of Curved Patches, Eurographics 1993;
//            the margin is ours
#pragma once

#include <array>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "core/geometry/placed_view.h"

namespace zscope {

/// In the units of the model.
struct NormalCone {
    dvec3  axis{0, 0, 0};  // of length 1
    dvec3  apex{0, 0, 0};
    double cosine = 0, sine = 0;  // of the angle between the axis and the sides
    double altitude = 0;          // the smallest of any of its triangles; 0: nothing is promised of this batch

    bool promises() const { return altitude > 0; }
};

/// Of a batch around `centre`; corners anticlockwise as seen from the front.
NormalCone normalConeOf(std::span<const std::array<dvec3, 3>> triangles, const dvec3& centre);

/// Whether all triangles of a cone face away, wherever in one box they lie: if the eye is so far behind the planes of
/// all of them that nothing turns one over.
struct BehindQuestion {
    dvec3  eye;    // in model space
    double slack;  // what a distance may be wrong by, but for the apex's part
    // twice the area of a triangle on the screen is at least so much, times its altitude and the distance
    double areaPerDistance;
    double change;             // by so much snapping may change it, all per length of its longest side,
    double changePerAltitude;  // and by so much divided by its altitude

    /// True only if every triangle is back-facing.
    bool holdsOf(const NormalCone& cone) const;
};
/// What a cosine, a length or a position may be wrong by, relative to what it was made of: far above the rounding of
/// some twenty operations (1e-15) over the thinnest triangle (1e6) or the flattest placement (1e3). So much of the sum
/// of its coordinates' magnitudes an apex adds to BehindQuestion::slack.
inline constexpr double kConeSlack = 1e-8;

/// One placement, as its camera sees it, asked about batches.
class BackFaces {
public:
    /// `isMirrored`: the instance that `view` places is (Affine::isMirrored).
    BackFaces(const PlacedView& view, const Projection& projection, bool isMirrored);

    /// False if no question about the cone can be answered with yes, whatever box holds its triangles.
    bool mayHold(const NormalCone& cone) const { return cone.promises() && glm::dot(cone.apex - m_eye, cone.axis) > 0; }

    /// What to ask about cones whose triangles lie in `box`; nothing if no answer could be trusted.
    std::optional<BehindQuestion> question(const ViewBox& box) const;

    /// True only of a batch of which every triangle is back-facing; `box` holds it.
    bool hold(const NormalCone& cone, const ViewBox& box) const;

private:
    dvec3  m_eye{0, 0, 0};  // in model space
    double m_volume  = 0;   // of a unit cube of the model in view space; 0: a mirrored camera, or too flat to be sure
    double m_stretch = 0;   // what is 1 long in the model is at most so long in view space
    double m_near, m_focal;
};

}  // namespace zscope
