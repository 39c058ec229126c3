#include "core/method/edge_walk.h"

#include <algorithm>
#include <array>

#include "core/plain/depth_test.h"
#include "core/plain/triangle_side.h"

namespace zscope::plain {

namespace {

struct Corner {
    double x, y;  // snapped, 1/256 pixel
};

/// The corners from top to bottom.
std::array<Corner, 3> fromTheTop(const ScreenTriangle& triangle)
{
    std::array<Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = {triangle.x[i], triangle.y[i]};
    std::ranges::stable_sort(corners, {}, &Corner::y);
    return corners;
}

/// The lines [first, end), on which the short side from corner `upper` to corner `lower` faces the long side.
struct Half {
    std::size_t upper, lower;
    int         first, end;
};

std::array<Half, 2> halvesOf(const ScreenTriangle& triangle, const std::array<Corner, 3>& corners,
                             const ChosenRules& rules)
{
    const PixelBox& box    = triangle.box;
    const int       first  = std::max(rules.firstLineOfTriangle(corners[0].y), box.y0);  // a fault: a line late
    const int       middle = std::clamp(firstLineFrom(corners[1].y), box.y0, box.y1);
    return {{{0, 1, first, middle}, {1, 2, std::max(first, middle), box.y1}}};
}

}  // namespace

void walkEdges(Work& work, const Pass& pass, const ScreenTriangle& triangle)
{
    const std::array<Corner, 3> corners = fromTheTop(triangle);
    DepthTest                   test(work, pass, triangle.depth, triangle.id, triangle.patterned);
    for (const auto& [upper, lower, first, end] : halvesOf(triangle, corners, work.rules)) {
        const Corner &top = corners[0], &bottom = corners[2], &from = corners[upper], &to = corners[lower];
        if (first >= end) continue;                                    // the half crosses no line's centre
        if (work.rules.isSkippedAsHorizontal(from.x, to.x)) continue;  // a fault
        TriangleSide longSide(top.x, top.y, bottom.x, bottom.y, first, end - 1, work.rules);
        TriangleSide shortSide(from.x, from.y, to.x, to.y, first, end - 1, work.rules);
        for (int y = first; y < end; ++y, longSide.nextLine(), shortSide.nextLine()) {
            const auto [leftmost, rightmost] = std::minmax({longSide.firstPixel(), shortSide.firstPixel()});
            const int left = std::max(leftmost, triangle.box.x0), right = std::min(rightmost, triangle.box.x1);
            if (left >= right) continue;
            test.beginLine(y, left);
            for (int x = left; x < right; ++x) test.offer(x);
            work.tally.add(Unit::Spans);
            work.tell(SpanFilled{y, left, right, triangle.id});
        }
    }
}

}  // namespace zscope::plain
