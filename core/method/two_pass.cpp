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
    hierarchical(work, parts, asking, visit, Remembers::Yes);
    work.scratch.memory.finish();
}

void drawIfNotDrawnInPassOne(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node)
{
    if (node.isInstanceTree()) {
        drawNode(work, parts, pass, visit, node);
        return;
    }
    NodeMemory& memory     = work.scratch.memory;
    bool        wasWorthIt = memory.isDrawnAhead(node.instance, *node.node);
    if (!wasWorthIt) {
        const DrawnTriangles drawn = drawNode(work, parts, pass, visit, node);
        wasWorthIt                 = NodeMemory::isWorthIt(drawn);
    }
    if (wasWorthIt) memory.remember({node.instance, node.holder, node.node});
}

}  // namespace zscope::plain
