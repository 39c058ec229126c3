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
        if (memory.isItsTurn(last)) continue;  // every eighth is left to pass two, which asks about its triangles
        if (visit.volume().misses(placed.view(last.node->bounds))) continue;
        memory.noteDrawnAhead(last);
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
    unasked.number = 1, asking.number = 2;
    work.tell(PassStarted{1});
    drawRemembered(work, parts, unasked, visit);
    work.tell(PassStarted{2});
    hierarchical(work, parts, asking, visit, Remembers::Yes);
    work.scratch.memory.finish();
}

void drawIfNotDrawnInPassOne(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node)
{
    NodeMemory& memory = work.scratch.memory;
    // True: pass one drew it, and this visit has just found it not hidden.
    bool remains = !node.isInstanceTree() && memory.isDrawnAhead(node.instance, *node.node);
    if (!remains) {
        work.tell(NodeDrawn{visit.treeOf(node).place(*node.node)});
        if (node.isInstanceTree()) return;
        remains = NodeMemory::isWorthIt(drawOwn(work, parts, pass, visit, node));
    }
    if (remains) memory.remember({node.instance, node.holder, node.node});
}

}  // namespace zscope::plain
