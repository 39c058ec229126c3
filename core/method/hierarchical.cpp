#include "core/method/hierarchical.h"

#include "core/cull/cull_events.h"
#include "core/method/two_pass.h"

namespace zscope::plain {

void hierarchical(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, Remembers remembers)
{
    parts.push(work, visit.roots());
    for (PlacedNode node; parts.pop(work, node);) {
        if (work.isCancelled()) return;
        if (parts.judge(work, pass, visit, node) != Verdict::Entered) continue;
        parts.push(work, visit.childrenFarthestFirst(node));  // divides the node; hasOwnItems() is known only then
        if (!visit.hasOwnItems(node)) continue;
        if (remembers == Remembers::Yes) {
            drawIfNotDrawnInPassOne(work, parts, pass, visit, node);
            continue;
        }
        work.tell(NodeDrawn{visit.treeOf(node).place(*node.node)});
        if (!node.isInstanceTree()) drawOwn(work, parts, pass, visit, node);  // instances wait on the stack
    }
}

DrawnTriangles drawOwn(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node)
{
    DrawnTriangles all;
    for (const BatchPlace& batch : visit.batchesNearestFirst(node)) {
        if (work.isCancelled()) break;
        if (work.leavesOut(Checkpoint::Batch) || !parts.mayBeSeen(work, batch)) continue;
        parts.setUp(work, batch);
        all.add(parts.draw(work, pass));
    }
    return all;
}

void pushOnStack(Call work, std::span<const PlacedNode> nodes)
{
    work->scratch.nodes.insert(work->scratch.nodes.end(), nodes.begin(), nodes.end());
}

bool popFromStack(Call work, PlacedNode& node)
{
    if (work->scratch.nodes.empty()) return false;
    node = work->scratch.nodes.back();
    work->scratch.nodes.pop_back();
    work->clock.lap(Stage::Cull);
    return true;
}

}  // namespace zscope::plain
