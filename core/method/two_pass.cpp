#include "core/method/two_pass.h"

#include "core/method/hierarchical.h"

namespace zscope::plain {

namespace {

void drawRemembered(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit)
{
    NodeMemory& memory = work.scratch.memory;
    for (const RememberedNode& last : memory.lastFrame()) {
        if (work.isCancelled()) return;
        const PlacedNode  node{.node = last.node, .holder = last.holder, .instance = last.instance};
        const PlacedTree& placed = visit.treeOf(node);
        if (memory.isItsTurn(last) || visit.volume().misses(placed.view(last.node->bounds))) continue;
        memory.drawnAhead(last);
        work.tell(NodeRecalled{placed.place(*last.node), visit.trees().instances(), *last.holder});
        drawOwn(work, parts, pass, visit, node);
    }
}

}  // namespace

void twoPass(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit)
{
    work.scratch.memory.begin(visit.trees());
    Pass unasked = pass, asking = pass;
    unasked.asksNodes = unasked.asksTriangles = false;
    unasked.ofTwo = 1, asking.ofTwo = 2;
    work.tell(PassStarted{1});
    drawRemembered(work, parts, unasked, visit);
    work.tell(PassStarted{2});
    hierarchical(work, parts, asking, visit, true);
    work.scratch.memory.finish();
}

void drawUnlessDrawnAhead(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node)
{
    NodeMemory& memory       = work.scratch.memory;
    const bool  isDrawnAhead = !node.isInstanceTree() && memory.isDrawnAhead(node.instance, *node.node);
    const bool  isWorthIt    = isDrawnAhead || NodeMemory::isWorthIt(drawNode(work, parts, pass, visit, node));
    if (isWorthIt && !node.isInstanceTree()) memory.remember({node.instance, node.holder, node.node});
}

}  // namespace zscope::plain
