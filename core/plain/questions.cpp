#include "core/plain/questions.h"

#include "core/cull/node_reach.h"
#include "core/depth/pyramid_told.h"
#include "core/depth/tile_plane.h"

namespace zscope::plain {

namespace {

/// Reports each cell that the pyramid computes anew.
struct TellCells {
    const Work&  work;
    AfterDrawing upkeep;
    void         operator()(const CellWrite& write) const
    {
        work.tally.add(Unit::CellsWritten);
        work.tell(CellUpdated{write, upkeep});
    }
};

template <class Shape>
PyramidQuery ask(Work& work, const Pass& pass, const PixelBox& box, double nearest, const Shape& shape)
{
    Pyramid&           pyramid = work.scratch.pyramid;
    const float        depth   = work.rules.stored(nearest);
    const TellCells    told{work, pass.afterDrawing};
    const PyramidQuery query = work.rules.asksOneLevel()  // an approximation
                                   ? pyramid.askOneLevel(box, depth, told)
                                   : pyramid.ask(box, depth, shape, told);
    work.tally.add(Unit::Questions);
    work.tally.add(Unit::CellsRead, static_cast<std::uint64_t>(query.cells));
    return query;
}

}  // namespace

Verdict judgeNode(Call call, const Pass& pass, TreeVisit& visit, PlacedNode& node)
{
    Work& work = *call;
    if (work.observer)
        if (const std::optional<int> known = work.observer->knownVerdict()) return static_cast<Verdict>(*known);

    if (pass.keep != Keep::DepthOnly) work.tally.add(Unit::Nodes);
    const PlacedTree& placed = visit.treeOf(node);
    const auto        judged = [&](Verdict verdict, const PyramidQuery* query = nullptr) {
        const bool isDrawnAhead =
            pass.number == 2 && !node.isInstanceTree() && work.scratch.memory.isDrawnAhead(node.instance, *node.node);
        work.tell(NodeJudged{placed.place(*node.node), verdict, query, pass.number, isDrawnAhead, pass.asksNodes});
        return verdict;
    };
    const ViewBox box = placed.view(node.node->bounds);
    if (visit.volume().misses(box, node.open)) return judged(Verdict::Outside);
    const double smallest = work.rules.smallestNode();  // an approximation, if it is not 0
    if (smallest == 0 && !pass.asksNodes) return judged(Verdict::Entered);
    NodeReach reach = reachOf(box, work.stripe.projection, work.stripe.region());
    if (reach.crossesNear) return judged(Verdict::Entered);
    if (reach.area < smallest) return judged(Verdict::Small);
    if (!pass.asksNodes) return judged(Verdict::Entered);
    if (work.rules.truncatesNodeBoxes()) --reach.pixels.x1, --reach.pixels.y1;  // a fault
    if (reach.pixels.isEmpty()) return judged(Verdict::Outside);

    const PyramidQuery query = ask(work, pass, reach.pixels, reach.nearest, WholeBox{});
    const NodePlace    asked = placed.place(*node.node);
    work.tell(PyramidAsked{query, &asked, {}, work.rules.asksOneLevel(), pass.afterDrawing});
    return judged(query.hidden ? Verdict::Hidden : Verdict::Entered, &query);
}

bool isHidden(Work& work, const Pass& pass, const ScreenTriangle& triangle)
{
    if (!pass.asksTriangles) return false;
    const PyramidQuery query = pass.asksByShape ? ask(work, pass, triangle.box, triangle.depth.nearest,
                                                      TriangleCover(triangle, work.rules.notOwned()))
                                                : ask(work, pass, triangle.box, triangle.depth.nearest, WholeBox{});
    work.tell(PyramidAsked{query, nullptr, triangle.id, work.rules.asksOneLevel(), pass.afterDrawing});
    if (query.hidden)
        work.tell(TriangleHidden{triangle.id, query});
    else
        work.tell(TrianglePassed{triangle.id, query});
    return query.hidden;
}

bool isHiddenInTile(Work& work, const ScreenTriangle& triangle, const PixelBox& pixels)
{
    const PixelBox tile = work.scratch.pyramid.tileAt(pixels.x0, pixels.y0);
    // Fragments have the depths of the triangle's plane, whose nearest point in the tile is at one of its corners. Not
    // so with other numbers (an approximation) or an interpolated distance (a fault): the nearest corner of the whole
    // triangle bounds them then.
    const bool  isPlane = work.rules.depthNumbers() == DepthNumbers::Float64 && !work.rules.interpolatesDistance();
    const float nearest = work.rules.stored(isPlane ? nearestOver(triangle.depth, pixels) : triangle.depth.nearest);
    const TileAnswer answer =
        work.scratch.pyramid.askTile(tile.x0, tile.y0, nearest, TellCells{work, AfterDrawing::MarkStale});
    work.tell(TileTested{pixels, triangle.id, nearest, answer.farthest, answer.hidden});
    return answer.hidden;
}

void keepPyramidTrue(Work& work, const Pass& pass, const ScreenTriangle& triangle)
{
    Pyramid&        pyramid = work.scratch.pyramid;
    const TellCells told{work, pass.afterDrawing};
    if (pass.testsTiles) return pyramid.touched(triangle.box);
    switch (pass.afterDrawing) {
        case AfterDrawing::Nothing:
            return;
        case AfterDrawing::MarkStale:
            return pyramid.touched(triangle.box);
        case AfterDrawing::Push:
            return pyramid.push(triangle.box, told);
        case AfterDrawing::PushFromFarthest:
            return pyramid.pushFrom(triangle.box, fromFarthestCorner(triangle), told);
        case AfterDrawing::Cover:
            if (triangle.wide || triangle.patterned) return;  // what it covers, or how far back, is not known here
            return pyramid.cover(
                triangle.box, TriangleCover(triangle, work.rules.notOwned()),
                [&](const PixelBox& pixels) { return farthestOver(triangle.depth, pixels, work.rules); }, told);
    }
}

}  // namespace zscope::plain
