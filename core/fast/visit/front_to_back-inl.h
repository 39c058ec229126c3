// Order front to back: the two-level hierarchy is descended from the near side to the far side, so that what is drawn
// first hides what comes later.
//
// Node       outside the frustum: skipped. Hidden by the pyramid: skipped. Else entered: its own items are drawn, or
//            its children visited, nearer ones first
// Order      octree: the eye's octant first, then across one splitting plane, two, three. An affine placement keeps
//            planes planes, so the eye is taken into the tree's own space. What straddles the planes has no exact place
//            between the octants: it comes before the first octant whose box is farther from the eye. BVH: the nearer
//            box first. Instances and batches of one node: the nearer box first. Triangles of one batch, where they are
//            large: the nearer first
// Inside     a tree whose box holds the eye is not descended branch by branch: of all nodes that wait the
//            nearest is next. From within, much of a branch lies behind what is near in the next one
// Pixels     a batch's patches that face away are left out, and those patches and small triangles all of
//            whose pixels hold something nearer than the batch comes (core/geometry/patches.h,
//            core/fast/hidden_squares/hidden_squares.h); of large triangles, patches that the pyramid hides
// Balls      a node reaches no farther than a ball around it does
// Dense      where that is so, questions about nodes below one whose triangles are that small may be left out
//            (core/fast/skipped_questions/sampled_questions.h)
// Whole      there, too, a small node is drawn with everything below it, and not divided: the squares tell its parts
//            apart
// Recall     with a memory of the last frame: what it saw is drawn first, unasked, in the order in which it came then;
//            the visit that follows judges it again, to learn whether it stays remembered, but does not draw it twice
//            (NodeMemory)
// Promise    skips only what cannot win a pixel (StripeVolume, NodeReach, Pyramid); a node that reaches before the near
//            plane, as one that holds the eye does, is always entered
// Source     Greene, Kass, Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993
#if defined(ZSCOPE_FRONT_TO_BACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_FRONT_TO_BACK_INL_H
#undef ZSCOPE_FRONT_TO_BACK_INL_H
#else
#define ZSCOPE_FRONT_TO_BACK_INL_H
#endif

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/cull/cull_events.h"
#include "core/cull/node_reach.h"
#include "core/cull/occlusion.h"
#include "core/fast/lanes/ask_pyramid-inl.h"
#include "core/fast/skipped_questions/sampled_questions.h"
#include "core/fast/visit/submitted-inl.h"
#include "core/hierarchy/scene_trees.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// One tree as it is placed in the world, seen from the eye.
struct PlacedTree {
    const Tree&   tree;
    const Affine& toWorld;
    PlacedView    view;
    BackFaces     backs;
    dvec3         eye;  // in the tree's own space
    bool          isInstanceTree;
    InstanceId    instance;

    NodePlace place(const TreeNode& node) const { return {isInstanceTree, instance, tree, node}; }
};

template <class Consume>
class FrontToBack {
    using Planes = StripeVolume::Planes;

public:
    FrontToBack(const Stripe& stripe, StripeScratch& scratch, const SceneTrees& trees, const Occlusion& occlusion,
                StageClock& clock, const Consume& consume, const LaneRules& rules, NodeMemory* memory = nullptr)
        : m_stripe(stripe), m_scene(stripe.scene.scene()), m_scratch(scratch), m_trees(trees), m_occlusion(occlusion),
          m_clock(clock), m_consume(consume), m_rules(rules), m_memory(memory),
          m_volume(stripe.projection, stripe.visible.width(), stripe.firstRow, stripe.endRow)
    {}

    void visitScene()
    {
        const Tree& instances = m_trees.instances();
        if (instances.isEmpty()) return;
        const Affine     world;
        const PlacedTree placed = place(instances, world, true, {});
        visit(placed, instances.root(), StripeVolume::kAll, [&](const TreeNode& node, Planes open) {
            auto& waiting = m_scratch.instances;
            waiting.clear();
            for (const std::uint32_t item : instances.ownItems(node))
                waiting.push_back({distance(m_stripe.projection.eye, instances.boxOf(item)), InstanceId{item}});
            std::ranges::sort(waiting, [](const WaitingInstance& a, const WaitingInstance& b) {
                return std::pair(a.distance, a.instance.value) < std::pair(b.distance, b.instance.value);
            });
            for (const WaitingInstance& next : waiting) visitInstance(next.instance, node, open);
        });
        m_clock.lap(Stage::Cull);
    }

    /// What is left of the last frame's view, before anything else has been drawn.
    void drawRemembered()
    {
        std::optional<PlacedTree> placed;
        for (const RememberedNode& last : m_memory->lastFrame()) {
            if (m_stripe.progress.cancelled()) return;
            const Instance& instance = m_scene.instances[last.instance.value];
            if (!placed || placed->instance != last.instance)
                placed.emplace(place(m_trees.mesh(instance.mesh), instance.toWorld, false, last.instance));
            if (m_memory->isItsTurn(last) || m_volume.misses(placed->view(last.node->bounds))) continue;
            m_memory->noteDrawnAhead(last);
            drawOwn(*placed, *last.node);
        }
        m_clock.lap(Stage::Cull);
    }

private:
    PlacedTree place(const Tree& tree, const Affine& toWorld, bool isInstanceTree, InstanceId instance) const
    {
        const auto&      m = toWorld.rows;
        const glm::dmat3 linear(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]);
        const dvec3      eye = glm::inverse(linear) * (m_stripe.projection.eye - dvec3{m[0][3], m[1][3], m[2][3]});
        const PlacedView view(m_stripe.projection, toWorld,
                              isInstanceTree ? m_stripe.projection.displacement.instances : 0);
        return {tree, toWorld,        view,    BackFaces(view, m_stripe.projection, toWorld.isMirrored()),
                eye,  isInstanceTree, instance};
    }

    /// `open`: planes of the stripe that `holder` crosses.
    void visitInstance(InstanceId id, const TreeNode& holder, Planes open)
    {
        const Instance& instance = m_scene.instances[id.value];
        const Tree&     tree     = m_trees.mesh(instance.mesh);
        if (tree.isEmpty()) return;
        const PlacedTree placed = place(tree, instance.toWorld, false, id);
        visitTree(placed, open, [&](const TreeNode& node, Planes) {
            const bool isDrawnAhead = m_memory && m_memory->isDrawnAhead(id, node);
            const bool isWorthIt    = isDrawnAhead || NodeMemory::isWorthIt(drawOwn(placed, node));
            if (m_memory && isWorthIt) m_memory->remember({id, &holder, &node});
        });
    }

    /// The node's own triangles, batch by batch, the nearest box first.
    DrawnTriangles drawOwn(const PlacedTree& placed, const TreeNode& node)
    {
        const Mesh&        mesh    = m_scene.meshOf(placed.instance);
        const bool         isWhole = isDrawnWhole(placed, node);
        const MeshBatches& batches = isWhole ? placed.tree.allBatchesOf(node, mesh) : placed.tree.batchesOf(node, mesh);
        const Affine*      toWorld = placed.toWorld.isIdentity() ? nullptr : &placed.toWorld;
        DrawnTriangles     all;
        for (const WaitingBatch& next : inOrder(placed, batches)) {
            const Batch& batch = batches.batches[next.batch];
            if (m_stripe.progress.cancelled()) break;
            const BatchPlace place{batches, batch, toWorld, m_scene.firstTriangle[placed.instance.value]};
            if (!setUp(placed, place, all)) continue;
            m_scratch.triangles.startsNearest =
                m_stripe.shortcuts.has(Shortcut::NearestTriangle) && m_scratch.triangles.areLarge();
            all.add(m_consume(m_scratch.triangles));
        }
        return all;
    }

    /// Answers about patches that are waited for: those of what comes first are mostly "no".
    static constexpr std::uint32_t kFirstPatches = 256;

    /// Whether any triangle may have been left; those that were not seen are added to `all`.
    bool setUp(const PlacedTree& placed, BatchPlace place, DrawnTriangles& all)
    {
        if (m_occlusion.asksPixels) {
            place.patches = patchesTowardsEye(place, placed.backs, placed.view, m_stripe);
            m_clock.lap(Stage::Cull);
            if (place.patches == 0) return false;
            const LeftOut leftOut =
                setUpSeen(place, placed.view, m_stripe, m_scratch, m_patchQuestions, m_clock, m_rules);
            all.add({.hidden = leftOut.triangles, .hiddenPixels = leftOut.pixels});
            return true;
        }
        if (isCulledAsBack(place, placed.backs, placed.view, m_stripe, m_rules)) return false;
        m_clock.lap(Stage::Cull);
        setUpBatch(place, m_stripe, m_scratch, m_clock, m_rules);
        return true;
    }

    std::span<const WaitingBatch> inOrder(const PlacedTree& placed, const MeshBatches& batches)
    {
        std::vector<WaitingBatch>& waiting = m_scratch.batches;
        waiting.clear();
        for (std::uint32_t b = 0; b < batches.batches.size(); ++b) {
            const double away = distance(placed.eye, batches.batches[b].bounds);
            waiting.push_back({away >= 0 ? away : 0, b});  // a flat placement has no place for the eye
        }
        std::ranges::sort(waiting, [](const WaitingBatch& a, const WaitingBatch& b) {
            return std::pair(a.distance, a.batch) < std::pair(b.distance, b.batch);
        });
        return waiting;
    }

    template <class DrawItems>
    void visitTree(const PlacedTree& placed, Planes open, const DrawItems& drawItems)
    {
        const TreeNode& root = placed.tree.root();
        if (m_stripe.shortcuts.has(Shortcut::NearestNode) && distance(placed.eye, root.bounds) == 0)
            visitNearestFirst(placed, {0, &root, open, {}}, drawItems);
        else
            visit(placed, root, open, drawItems);
    }

    template <class DrawItems>
    void visitNearestFirst(const PlacedTree& placed, const WaitingNode& root, const DrawItems& drawItems)
    {
        std::vector<WaitingNode>& waiting = m_scratch.nodes;
        const auto isFarther = [](const WaitingNode& a, const WaitingNode& b) { return a.distance > b.distance; };
        waiting.assign(1, root);
        while (!waiting.empty() && !m_stripe.progress.cancelled()) {
            std::ranges::pop_heap(waiting, isFarther);
            WaitingNode next = waiting.back();
            waiting.pop_back();
            const TreeNode& node = *next.node;
            if (judge(placed, node, next.open, next.above) != Verdict::Entered) continue;
            if (isDrawnWhole(placed, node)) {
                drawItems(node, next.open);
                continue;
            }
            placed.tree.open(node);
            if (!placed.tree.ownItems(node).empty()) drawItems(node, next.open);
            for (const TreeNode& child : placed.tree.childrenOf(node)) {
                waiting.push_back({distance(placed.eye, child.bounds), &child, next.open, next.above});
                std::ranges::push_heap(waiting, isFarther);
            }
        }
    }

    /// `open`: planes of the stripe that the node above crosses, and so this one may.
    template <class DrawItems>
    void visit(const PlacedTree& placed, const TreeNode& node, Planes open, const DrawItems& drawItems,
               AskedNode above = {})
    {
        if (m_stripe.progress.cancelled() || judge(placed, node, open, above) != Verdict::Entered) return;
        if (isDrawnWhole(placed, node)) return drawItems(node, open);
        const Tree& tree = placed.tree;
        tree.open(node);
        auto children = inOrder(placed, node);
        if (!tree.ownItems(node).empty()) drawItems(node, open);
        for (std::size_t i = 0; i < children.count; ++i) visit(placed, *children.nodes[i], open, drawItems, above);
    }

    /// Triangles of a node that is drawn at once, with everything below it, where pixels are asked (measured,
    /// docs/performance.md).
    static constexpr std::uint32_t kDrawnWhole = 768;
    bool                           isDrawnWhole(const PlacedTree& placed, const TreeNode& node) const
    {
        return m_stripe.shortcuts.has(Shortcut::WholeNodes) && m_occlusion.asksPixels
               && (!m_memory || m_memory->holdsWholeNodes()) && !placed.isInstanceTree && node.size() <= kDrawnWhole;
    }

    /// A dense node that is much smaller than the last one asked about is asked in any case, unless it is drawn whole:
    /// its batch looks for itself.
    static constexpr std::uint32_t kMuchSmaller = 8;
    bool                           isAsked(const PlacedTree& placed, const TreeNode& node, const AskedNode& above)
    {
        if (!above.isDense || !m_stripe.shortcuts.has(Shortcut::SkippedQuestions)) return true;
        if (node.size() <= above.size / kMuchSmaller && !isDrawnWhole(placed, node)) return true;
        return m_denseQuestions.isWorthIt();
    }

    /// Strikes out of `open` the planes that the node lies wholly inside of; `above` becomes the node itself if it is
    /// asked about.
    Verdict judge(const PlacedTree& placed, const TreeNode& node, Planes& open, AskedNode& above)
    {
        m_scratch.tally.add(Unit::Nodes);
        const ViewBox box = placed.view(node.bounds);
        if (m_volume.misses(box, open)) return Verdict::Outside;
        const double smallest = m_rules.smallestNode();
        if (smallest == 0 && !(m_occlusion.asksNodes && isAsked(placed, node, above))) return Verdict::Entered;
        NodeReach reach = reachOf(box, m_stripe.projection, m_stripe.region());
        if (reach.crossesNear) return Verdict::Entered;
        if (reach.area < smallest) return Verdict::Small;
        if (!m_occlusion.asksNodes) return Verdict::Entered;
        if (m_stripe.shortcuts.has(Shortcut::NodeBalls) && !m_rules.movesCorners() && !m_rules.dependsOnVisit())
            reach = narrowedToBall(reach, box, node.radius * placed.view.longest(), m_stripe.projection);
        if (reach.pixels.isEmpty()) return Verdict::Outside;
        m_scratch.tally.add(Unit::Questions);
        const PyramidQuery query = askPyramid(*m_occlusion.pyramid, reach.pixels, reach.nearest, WholeBox{}, m_rules);
        if (above.isDense) m_denseQuestions.answered(query.hidden);
        if (m_occlusion.asksPixels && !placed.isInstanceTree)
            above = {node.size(), reach.pixels.area() <= kWorthLooking * node.size()};
        return query.hidden ? Verdict::Hidden : Verdict::Entered;
    }

    struct Child {
        double          distance;
        const TreeNode* node;
    };

    struct Children {
        std::array<const TreeNode*, TreeNode::kSlots> nodes;
        std::size_t                                   count = 0;

        void add(const TreeNode* node) { nodes[count++] = node; }
    };

    static Children inOrder(const PlacedTree& placed, const TreeNode& node)
    {
        Children   ordered;
        const auto children = placed.tree.childrenOf(node);
        const bool halved   = children.size() > 1 && (children[0].straddles || placed.tree.kind() == TreeKind::Bvh);
        if (halved) {
            const bool swap = distance(placed.eye, children[1].bounds) < distance(placed.eye, children[0].bounds);
            ordered.add(&children[swap ? 1 : 0]);
            ordered.add(&children[swap ? 0 : 1]);
            return ordered;
        }
        std::array<Child, TreeNode::kSlots> straddling;
        std::size_t                         waiting = 0, next = 0;
        std::array<const TreeNode*, 8>      octant{};
        for (const TreeNode& child : children) {
            if (child.straddles)
                straddling[waiting++] = {distance(placed.eye, child.bounds), &child};
            else
                octant[static_cast<std::size_t>(child.slot)] = &child;
        }
        std::sort(straddling.begin(), straddling.begin() + waiting, [](const Child& a, const Child& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.node->slot < b.node->slot;
        });
        const dvec3    centre = 0.5 * node.cell.min + 0.5 * node.cell.max;
        const unsigned eyes   = (placed.eye.x > centre.x ? 1u : 0u) | (placed.eye.y > centre.y ? 2u : 0u)
                              | (placed.eye.z > centre.z ? 4u : 0u);
        // planes between the eye's octant and this one
        for (const unsigned across : {0u, 1u, 2u, 4u, 3u, 5u, 6u, 7u}) {
            const TreeNode* child = octant[eyes ^ across];
            if (!child) continue;
            while (next < waiting && straddling[next].distance < distance(placed.eye, child->bounds))
                ordered.add(straddling[next++].node);
            ordered.add(child);
        }
        while (next < waiting) ordered.add(straddling[next++].node);
        return ordered;
    }

    /// Squared, from the eye to the nearest point of the box.
    static double distance(const dvec3& eye, const Bounds& box)
    {
        const dvec3 gap = eye - glm::clamp(eye, box.min, box.max);
        return glm::dot(gap, gap);
    }

    const Stripe&     m_stripe;
    const Scene&      m_scene;
    StripeScratch&    m_scratch;
    const SceneTrees& m_trees;
    const Occlusion&  m_occlusion;
    StageClock&       m_clock;
    const Consume&    m_consume;
    const LaneRules&  m_rules;
    NodeMemory*       m_memory;  // nullptr: nothing is remembered
    StripeVolume      m_volume;
    SampledQuestions  m_denseQuestions, m_patchQuestions{kFirstPatches};
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_FRONT_TO_BACK_INL_H
