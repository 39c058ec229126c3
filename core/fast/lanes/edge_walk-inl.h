// Scan conversion by walking the left and the right edge from line to line.
//
// Idea       on every line a triangle covers the pixels between two edges; both move by a constant per line
// Promise    the same pixels as the half-space test, because the steps are exact integers with remainder
// Cost       two additions per line and edge, two divisions per edge
// Source     docs/correctness.md, Coverage
#if defined(ZSCOPE_EDGE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_EDGE_WALK_INL_H
#undef ZSCOPE_EDGE_WALK_INL_H
#else
#define ZSCOPE_EDGE_WALK_INL_H
#endif

#include <array>
#include <utility>

#include "core/fast/lanes/depth_test-inl.h"
#include "core/scan/edge_stepper.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

struct EdgeWalk {
    template <Keep kKeep, class Fragments, class Rules>
    static void fill(const ScreenTriangle& triangle, const Fragments& fragments, VisibilityBuffer& visible,
                     const Rules& rules)
    {
        // From top to bottom: the long side joins the first and the last, the short sides meet in the middle.
        std::array<std::size_t, 3> at{0, 1, 2};
        const auto                 orderByY = [&](std::size_t i, std::size_t j) {
            if (triangle.y[at[j]] < triangle.y[at[i]]) std::swap(at[i], at[j]);
        };
        orderByY(0, 1);
        orderByY(1, 2);
        orderByY(0, 1);

        const PixelBox& box    = triangle.box;
        const int       first  = std::max(rules.firstCentreFrom(triangle.y[at[0]]), box.y0);
        const int       middle = std::clamp(firstLineFrom(triangle.y[at[1]]), box.y0, box.y1);
        const auto      both   = [&]<class Stepper>() {
            walk<kKeep, Stepper>(triangle, at, 0, 1, first, middle, fragments, visible, rules);
            walk<kKeep, Stepper>(triangle, at, 1, 2, std::max(first, middle), box.y1, fragments, visible, rules);
        };
        if (triangle.wide)
            both.template operator()<EdgeStepper<std::int64_t>>();
        else
            both.template operator()<EdgeStepper<std::int32_t>>();
    }

private:
    /// Lines [first, end) between the long side and the short side from corner `top` to `bottom` (in order of y).
    template <Keep kKeep, class Stepper, class Fragments, class Rules>
    static void walk(const ScreenTriangle& triangle, const std::array<std::size_t, 3>& at, std::size_t top,
                     std::size_t bottom, int first, int end, const Fragments& fragments, VisibilityBuffer& visible,
                     const Rules& rules)
    {
        if (first >= end) return;
        const auto edge = [&](std::size_t a, std::size_t b) {
            return Stepper(triangle.x[at[a]], triangle.y[at[a]], triangle.x[at[b]], triangle.y[at[b]], first, end - 1);
        };
        Stepper longSide = edge(0, 2), shortSide = edge(top, bottom);
        for (int y = first; y < end; ++y) {
            const int one   = longSide.firstPixel();
            const int other = shortSide.firstPixel();
            fillSpan<kKeep>(triangle.depth, triangle.rank(), y, std::max(std::min(one, other), triangle.box.x0),
                            std::min(std::max(one, other), triangle.box.x1), visible, rules, fragments);
            longSide.nextLine();
            shortSide.nextLine();
        }
    }
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_EDGE_WALK_INL_H
