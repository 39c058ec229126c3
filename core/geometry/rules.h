// The rules of the definition that a renderer can relax or get wrong, one small function each.
//
// ExactRules    the definition: every answer is known when the text is compiled
// LaneRules     what the fast text can follow: the definition, or approximations of numbers and of questions
// ChosenRules   all approximations and faults, chosen at run time: what the plain text follows
// Source        docs/correctness.md; the faults are described in core/frame/faults.h
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/approximation.h"
#include "core/base/depth_format.h"
#include "core/base/fault.h"
#include "core/geometry/facing.h"
#include "core/geometry/pixel_box.h"
#include "core/geometry/projection.h"
#include "core/scene/view.h"

namespace zscope {

/// First pixel (or line) whose centre, at 256 i + 128 subpixels, is at or beyond `snapped`; limited to +-2^30.
[[gnu::always_inline]] inline int firstPixelCentreFrom(double snapped)
{
    const std::int64_t pixel = (static_cast<std::int64_t>(snapped) + 127) >> 8;
    return static_cast<int>(std::clamp<std::int64_t>(pixel, -(std::int64_t{1} << 30), std::int64_t{1} << 30));
}

/// The coarse grid of snapped corners, where an approximation asks for it: steps to a pixel.
inline constexpr double kCoarseSnaps = 16;

struct ExactRules {
    static constexpr bool kExactDepths = true;

    // Vertices
    static constexpr bool   usesFloat32Vertices() { return false; }
    static constexpr double snapsPerPixel() { return kSubpixels; }
    static constexpr bool   dropsAtNear() { return false; }
    static constexpr Facing facing(const Facing& of) { return of; }
    /// Of the depth: it is interpolated as 1 / depth, which is proportional to the distance.
    static constexpr bool interpolatesDistance() { return false; }
    /// Corners behind the eye are projected as they are.
    static constexpr bool dividesBehindTheEye() { return false; }
    /// True if a part with these corners is left out because it crosses the border of the picture.
    static constexpr bool dropsCrossing(const ScreenCorner&, const ScreenCorner&, const ScreenCorner&) { return false; }

    // Coverage. Positions in subpixels
    static int firstCentreFrom(double snapped) { return firstPixelCentreFrom(snapped); }
    /// What an edge value is lowered by where the edge does not own its points.
    static constexpr double notOwned() { return 1; }

    // Depth
    static constexpr DepthNumbers depthNumbers() { return DepthNumbers::Float64; }
    static float                  stored(double depth) { return static_cast<float>(depth); }
    /// True if stored depths are affine and positive, so that who leads at both ends of a run leads inside it.
    static constexpr bool comparesByEnds() { return true; }
};

/// Corners lie on whole subpixels, and nothing is carried from pixel to pixel or from line to line: each lane can find
/// its own numbers. Coverage is the definition's. There are no faults.
class LaneRules : public ExactRules {
public:
    static constexpr bool kExactDepths = false;  // known at run time only: hasExactDepths()

    /// Of an approximation that lanes can follow.
    LaneRules(const Approximation& approximation, const Camera& camera)
        : m_approximation(approximation), m_encoding(approximation.format, camera.near, camera.far)
    {}

    /// True if depths are found and stored as the definition says, so that ExactRules can stand for these rules where
    /// pixels are tested.
    bool hasExactDepths() const { return m_approximation.depth == DepthNumbers::Float64 && m_encoding.isReversed(); }
    /// True if a corner may stand farther from its exact place than the definition's snapping moves it.
    bool movesCorners() const { return usesFloat32Vertices() || m_approximation.snap != SnapBits::Eight; }
    /// True if the picture depends on which nodes are visited.
    bool dependsOnVisit() const { return smallestNode() > 0; }

    bool   usesFloat32Vertices() const { return m_approximation.vertex == VertexNumbers::Float32; }
    double snapsPerPixel() const { return m_approximation.snap == SnapBits::Four ? kCoarseSnaps : kSubpixels; }
    bool   dropsAtNear() const { return m_approximation.near == NearPlane::Drop; }

    DepthNumbers                 depthNumbers() const { return m_approximation.depth; }
    const DepthEncoding&         encoding() const { return m_encoding; }
    [[gnu::always_inline]] float stored(double depth) const { return m_encoding.stored(depth); }
    bool                         comparesByEnds() const { return hasExactDepths(); }

    /// Nodes whose whole rectangle has fewer pixels are dropped.
    double smallestNode() const { return smallestNodeOf(m_approximation.small); }

private:
    Approximation m_approximation;
    DepthEncoding m_encoding;
};

/// What is called for every triangle or pixel is always inlined, so that each instruction set gets it in its own
/// instructions.
class ChosenRules {
public:
    ChosenRules(const Approximation& approximation, const FaultSet& faults, const Camera& camera)
        : m_approximation(approximation), m_faults(faults), m_encoding(approximation.format, camera.near, camera.far),
          m_width(camera.width * kSubpixels), m_height(camera.height * kSubpixels)
    {}

    bool   usesFloat32Vertices() const { return m_approximation.vertex == VertexNumbers::Float32; }
    double snapsPerPixel() const
    {
        return m_approximation.snap == SnapBits::Four     ? kCoarseSnaps
               : m_approximation.snap == SnapBits::Twelve ? 4096
                                                          : kSubpixels;
    }
    /// Which side of a triangle is drawn. With a fault, that of the screen's y axis pointing down, the other side.
    Facing facing(const Facing& of) const
    {
        return takesFrontsForBacks() ? Facing{FaceCulling::Back, !of.isMirrored} : of;
    }
    bool takesFrontsForBacks() const { return m_faults.has(Fault::WindingFlipped); }
    /// A fault: the division by the distance comes before the cut at the near plane, so that nothing is left to cut.
    bool dividesBehindTheEye() const { return m_faults.has(Fault::BehindTheEye); }
    /// A fault: a face is cut into triangles as if it were convex.
    bool fansFaces() const { return m_faults.has(Fault::ConcaveFanned); }
    /// Where in a pixel it is sampled. A fault: in its upper left corner.
    double sampleOffset() const { return m_faults.has(Fault::HalfPixel) ? 0 : 0.5; }
    bool   dropsAtNear() const { return m_approximation.near == NearPlane::Drop || m_faults.has(Fault::NearRejected); }
    [[gnu::always_inline]] bool dropsCrossing(const ScreenCorner& p0, const ScreenCorner& p1,
                                              const ScreenCorner& p2) const
    {
        const auto isOutside = [this](const ScreenCorner& p) {
            return p.xs < 0 || p.ys < 0 || p.xs > m_width || p.ys > m_height;
        };
        return m_faults.has(Fault::CrossingDropped) && (isOutside(p0) || isOutside(p1) || isOutside(p2));
    }

    [[gnu::always_inline]] int firstCentreFrom(double snapped) const
    {
        return firstPixelCentreFrom(std::ceil(snapped));
    }
    [[gnu::always_inline]] int firstLineOfTriangle(double top) const
    {
        if (!m_faults.has(Fault::FirstLineRounded)) return firstCentreFrom(top);
        return static_cast<int>(std::clamp(std::floor(top / kSubpixels), -0x1p30, 0x1p30)) + 1;
    }
    /// The pixels of a triangle's box that are looked at. A fault: its ends are taken for its last pixels, which the
    /// loop does not reach.
    PixelBox looked(const PixelBox& box) const
    {
        return m_faults.has(Fault::BoxShort) ? PixelBox{box.x0, box.y0, box.x1 - 1, box.y1 - 1} : box;
    }
    /// A fault: an edge's step from line to line loses its fraction of a subpixel.
    bool stepsByWholeSubpixels() const { return m_faults.has(Fault::EdgeDrift); }
    bool isSkippedAsHorizontal(double xa, double xb) const
    {
        return m_faults.has(Fault::HorizontalByX) && std::floor(xa / kSubpixels) == std::floor(xb / kSubpixels);
    }
    int firstPixel(int first, std::int64_t x) const
    {
        return m_faults.has(Fault::XTruncated) ? static_cast<int>(x >> 8) : first;
    }
    double notOwned() const
    {
        if (m_faults.has(Fault::NoTopLeft)) return 0;
        const double step = kSubpixels / snapsPerPixel();
        return std::min(1.0, step * step);
    }
    bool accumulatesEdges() const { return m_approximation.edges == EdgeSteps::Accumulated; }
    bool sortsActiveEdges() const { return !m_faults.has(Fault::EdgesUnsorted); }
    bool testsIntervalOnce() const { return m_faults.has(Fault::OneTestPerInterval); }

    /// A fault: the distance is interpolated, as if perspective kept halves halves.
    bool interpolatesDistance() const { return m_faults.has(Fault::LinearZ); }
    /// The depth of a pixel, given what has been interpolated.
    [[gnu::always_inline]] double depthFrom(double interpolated) const
    {
        return m_faults.has(Fault::LinearZ) ? 1 / std::max(1.0, interpolated) : interpolated;
    }
    /// A fault: the depths of the frame before are there when the frame begins.
    bool keepsLastDepths() const { return m_faults.has(Fault::NotCleared); }
    /// A fault: no depth is compared; what comes later in the file is drawn over what came before.
    bool drawsOver() const { return m_faults.has(Fault::PainterOrder); }
    /// A fault: of two depths the farther one wins; background loses to both.
    bool keepsFarthest() const { return m_faults.has(Fault::FarthestWins); }
    /// A fault: the pass that wants equal depths compares with "less".
    bool equalPassWantsNearer() const { return m_faults.has(Fault::EqualPassLess); }

    DepthNumbers                 depthNumbers() const { return m_approximation.depth; }
    const DepthEncoding&         encoding() const { return m_encoding; }
    [[gnu::always_inline]] float stored(double depth) const { return m_encoding.stored(depth); }
    bool comparesByEnds() const { return m_encoding.isReversed() && m_approximation.depth == DepthNumbers::Float64; }

    bool   asksOneLevel() const { return m_approximation.cells == CellDescent::OneLevel; }
    double smallestNode() const { return smallestNodeOf(m_approximation.small); }
    bool   visitsFarFirst() const { return m_faults.has(Fault::FarFirst); }
    bool   firstComerKeepsTie() const { return m_faults.has(Fault::FarFirst); }
    bool   truncatesNodeBoxes() const { return m_faults.has(Fault::EmptyIsHidden); }

private:
    Approximation m_approximation;
    FaultSet      m_faults;
    DepthEncoding m_encoding;
    double        m_width, m_height;  // of the picture, subpixels
};

}  // namespace zscope
