#include "core/method/scanline.h"

#include "core/plain/batches_in_view.h"
#include "core/plain/depth_test.h"
#include "core/plain/enter_faces.h"
#include "core/plain/lines.h"

namespace zscope::plain {

void scanline(Work& work, const Parts& parts)
{
    EdgeTable&   edges  = work.scratch.edges;
    ActiveEdges& active = work.scratch.active;
    active.begin(edges);
    for (const int y : LinesOf(work)) {
        active.retireBefore(y, work);
        active.admit(edges, y, work);
        active.sortByX(work);
        work.tell(LineReady{y, active.edges(), edges.polygons(), active.changes()});
        const std::uint64_t spansBefore = work.tally.of(Unit::Spans);
        parts.resolveLine(work, y);
        work.tell(LineFinished{y, active.edges(), edges.polygons(), active.changes(),
                               work.tally.of(Unit::Spans) - spansBefore});
        active.advance();
    }
}

void fillEdgeTable(Work& work, const Parts& parts)
{
    work.scratch.edges.clear(work.stripe.firstRow, work.stripe.endRow, work.stripe.memory);
    for (const BatchPlace& batch : BatchesInView(work)) {
        if (!parts.mayBeSeen(work, batch)) continue;
        parts.setUp(work, batch);
        parts.enterEdges(work);
    }
    if (!work.isCancelled()) work.scratch.edges.fillBuckets();
}

void fillEdgeTableWithFaces(Work& work)
{
    work.scratch.edges.clear(work.stripe.firstRow, work.stripe.endRow, work.stripe.memory);
    enterFaces(work);
    if (!work.isCancelled()) work.scratch.edges.fillBuckets();
}

void resolveByDepth(Call work, int y)
{
    for (const auto& [polygonIndex, x0, x1] : spansOf(*work)) {
        const Polygon& polygon = work->scratch.edges.polygons()[polygonIndex];
        offerSpan(*work, polygon, y, x0, x1);
        work->tally.add(Unit::Spans);
        work->tell(SpanFilled{y, x0, x1, polygon.id});
    }
}

void offerSpan(Work& work, const Polygon& polygon, int y, int x0, int x1)
{
    const Pass nearest{.keep = Keep::Nearest};
    DepthTest  test(work, nearest, polygon.depth, polygon.id, polygon.patterned);
    test.beginLine(y, x0);
    for (int x = x0; x < x1; ++x) test.offer(x);
}

std::span<const LineSpan> spansOf(Work& work)
{
    ActiveEdges&           active = work.scratch.active;
    std::vector<LineSpan>& spans  = work.scratch.spans;
    spans.clear();
    for (const Edge& edge : active.edges()) {
        PolygonSpan& span    = active.spanOf(edge.polygon);
        const int    x       = firstPixelRightOf(edge, work.stripe.visible.width(), work.rules);
        const bool   wasOpen = span.isOpen();
        span.winding += edge.winding;
        if (span.isOpen() == wasOpen) continue;
        if (!wasOpen)
            span.from = x;
        else if (span.from < x)
            spans.push_back({edge.polygon, span.from, x});
    }
    return spans;
}

}  // namespace zscope::plain
