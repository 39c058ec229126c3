#include "core/method/painter.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "core/method/edge_walk.h"
#include "core/method/zbuffer.h"
#include "core/plain/set_up_all.h"
#include "core/probe/words.h"

namespace zscope::plain {

namespace {

constexpr Pass kPaintOver{.keep = Keep::Over};

/// A larger depth is nearer.
bool isPaintedBefore(const ScreenTriangle& a, const ScreenTriangle& b)
{
    return std::tuple(a.depth.farthest, a.depth.nearest, b.id.value)
           < std::tuple(b.depth.farthest, b.depth.nearest, a.id.value);
}

}  // namespace

void paint(Work& work, const Parts& parts)
{
    std::vector<ScreenTriangle> triangles = setUpAll(work, parts);
    std::ranges::stable_sort(triangles, isPaintedBefore);
    std::size_t place = 0;
    for (const ScreenTriangle& triangle : triangles) {
        ++place;
        if (work.isCancelled()) return;
        if (work.leavesOut(Checkpoint::Piece)) continue;
        work.tell(TriangleReached{triangle});
        if (triangle.wide)  // beyond the guard band float64 does not hold the values of edges
            walkEdges(work, kPaintOver, triangle);
        else
            fillByHalfSpaces(work, kPaintOver, triangle);
        work.tell(TrianglePainted{triangle.id, place, triangles.size(), triangle.depth.farthest});
    }
}

std::string TrianglePainted::sentence(const Telling& telling) const
{
    return fmt::format(
        "Triangle {} is painted over what is there, at {}: it is number {} of {} from the farthest, by its farthest "
        "corner "
        "at {:.7g}.",
        withCommas(triangle.value), counted(telling.pixelsWon(), "pixel", "pixels"), withCommas(place),
        withCommas(count), farthest);
}

}  // namespace zscope::plain
