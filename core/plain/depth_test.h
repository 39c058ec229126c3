// The depth test: of all fragments at a pixel the nearest is seen, and of equally near ones that of the lowest id.
//
// Depth      a*(x + 0.5) + (b*(y + 0.5) + c), clamped to the depths of the corners, rounded to float32 when it is
//            stored
// Winner     depth and id together are one number, larger for the winner (core/depth/pixel_key.h)
// Far        background holds a depth just below every depth that may be kept, so the far test is part of the depth
//            test
// Patterns   a fragment in a hole does not exist; a relief moves it back. If it loses where its triangle is, it loses
//            anywhere behind, so the pattern is looked up only for fragments that pass (shading first looks up all)
// Painter    of fragments that are painted over each other the last is seen: no depth is compared
// Numbers    approximations: float32 in place of float64, or a depth that is carried along the line by adding a
// Source     docs/correctness.md, Depth and the winner
#pragma once

#include <cstdint>
#include <optional>

#include "core/plain/pass.h"
#include "core/plain/patterns.h"
#include "core/plain/work.h"

namespace zscope::plain {

class DepthTest {
public:
    /// Of the fragments of a triangle, or of a polygon of a sweep, with this plane.
    DepthTest(Work& work, const Pass& pass, const DepthPlane& plane, TriangleId id, bool patterned);
    /// Adds what it has tested to the tally.
    ~DepthTest();
    DepthTest(const DepthTest&)            = delete;
    DepthTest& operator=(const DepthTest&) = delete;

    /// The fragments that follow lie on line y, at pixel `first` and to its right, from left to right.
    void beginLine(int y, int first);

    /// A covered pixel: the fragment takes it if it is nearer.
    void offer(int x);
    /// The fragment takes the pixel without a test: the caller knows that nothing there is nearer.
    void store(int x);

private:
    double   clampedDepthAt(int x);
    bool     wins(PixelKey fragment, PixelKey held) const;
    bool     winsByItsRule(PixelKey fragment, PixelKey held) const;
    bool     mayBecomeNearer(PixelKey fragment, PixelKey held) const;
    PixelKey keyOfDepth(double depth) const;
    void     shade(int x) const;

    Work&                       m_work;
    const Pass&                 m_pass;
    const DepthPlane&           m_plane;
    std::uint32_t               m_rank;   // id + 1
    float                       m_empty;  // depth of background
    ShadingMoment               m_shading;
    bool                        m_nearerWins;  // no pass after a pre-pass and no fault says otherwise
    std::optional<PatternPlane> m_pattern;     // of the material, if it has one
    int                         m_y       = 0;
    PixelKey*                   m_row     = nullptr;
    double                      m_line    = 0;  // b*(y + 0.5) + c
    int                         m_carried = 0;  // accumulated depths: the pixel that m_carry belongs to
    float                       m_carry   = 0;
    std::uint64_t               m_tested = 0, m_won = 0, m_shaded = 0;
};

}  // namespace zscope::plain
