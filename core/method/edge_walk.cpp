#include "core/method/edge_walk.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/plain/depth_test.h"
#include "core/scan/edge_stepper.h"

namespace zscope::plain {

namespace {

struct Corner {
    double x, y;  // snapped, 1/256 pixel
};

/// The lines [first, end), from a long side to the short side from `top` to `bottom`.
template <class Stepper>
void walkBetween(Work& work, const Pass& pass, const ScreenTriangle& triangle, const std::array<Corner, 3>& corner,
                 std::size_t top, std::size_t bottom, int first, int end)
{
    if (first >= end || work.rules.isSkippedAsHorizontal(corner[top].x, corner[bottom].x)) return;
    const auto edge = [&](std::size_t a, std::size_t b) {
        Stepper side(corner[a].x, corner[a].y, corner[b].x, corner[b].y, first, end - 1);
        if (work.rules.stepsByWholeSubpixels()) side.stepByWholeSubpixels();  // a fault
        return side;
    };
    const auto pixelAt  = [&](const Stepper& side) { return work.rules.firstPixel(side.firstPixel(), side.x()); };
    Stepper    longSide = edge(0, 2), shortSide = edge(top, bottom);
    DepthTest  test(work, pass, triangle.depth, triangle.id, triangle.patterned);
    for (int y = first; y < end; ++y) {
        const auto [one, other] = std::minmax({pixelAt(longSide), pixelAt(shortSide)});
        const int left = std::max(one, triangle.box.x0), right = std::min(other, triangle.box.x1);
        if (left < right) {
            test.beginLine(y, left);
            for (int x = left; x < right; ++x) test.offer(x);
            work.tally.add(Unit::Spans);
            work.tell(SpanFilled{y, left, right, triangle.id});
        }
        longSide.nextLine();
        shortSide.nextLine();
    }
}

template <class Stepper>
void walk(Work& work, const Pass& pass, const ScreenTriangle& triangle)
{
    // The long side joins the first and the last corner from above; the short sides meet in the middle one.
    std::array<Corner, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) corner[i] = {triangle.x[i], triangle.y[i]};
    std::ranges::stable_sort(corner, {}, &Corner::y);
    const PixelBox& box    = triangle.box;
    const int       first  = std::max(work.rules.firstLineOfTriangle(corner[0].y), box.y0);
    const int       middle = std::clamp(firstLineFrom(corner[1].y), box.y0, box.y1);
    walkBetween<Stepper>(work, pass, triangle, corner, 0, 1, first, middle);
    walkBetween<Stepper>(work, pass, triangle, corner, 1, 2, std::max(first, middle), box.y1);
}

}  // namespace

void walkEdges(Work& work, const Pass& pass, const ScreenTriangle& triangle)
{
    if (work.rules.accumulatesEdges())  // an approximation
        walk<AccumulatedEdge>(work, pass, triangle);
    else
        walk<EdgeStepper<std::int64_t>>(work, pass, triangle);
}

}  // namespace zscope::plain
