#include "core/method/ray_casting.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/cull/node_reach.h"
#include "core/plain/coverage.h"
#include "core/plain/depth_test.h"
#include "core/plain/lines.h"
#include "core/plain/set_up_all.h"
#include "core/plain/tree_visit.h"
#include "core/probe/words.h"

namespace zscope::plain {

namespace {

constexpr Pass kNearestWins{};

struct Ray {
    PixelPosition pixel;
    dvec3         way;  // from the eye, in view space; z is 1
};

/// The box of a node in view space, grown by what may be displaced.
class RayBox {
public:
    RayBox(const ViewBox& box, const Projection& p)
        : m_box(box), m_error(std::max(1e-11, 2 * p.displacement.view) * (box.magnitude + p.near))
    {
        const double farthest = box.centre.z + box.spread(0, 0, 1) + m_error;
        m_moved               = farthest * p.displacement.pixels / p.pixelsPerSlope();
    }

    /// True if a plane through the ray, along edges of the box, has the grown box on one side.
    bool isMissedBy(const Ray& ray) const
    {
        for (const dvec3& edge : m_box.half) {
            const dvec3  n     = glm::cross(ray.way, edge);
            const double grown = (std::abs(n.x) + std::abs(n.y)) * (m_moved + m_error) + std::abs(n.z) * m_error;
            if (std::abs(glm::dot(n, m_box.centre)) > m_box.spread(n.x, n.y, n.z) + grown) return true;
        }
        return false;
    }

private:
    ViewBox m_box;
    double  m_error;  // of the numbers, a length in view space
    double  m_moved;  // by snapping, at the box's far side
};

/// A node in view; the nodes below it follow it, near ones first, up to `end`.
struct RayNode {
    NodePlace   place;
    RayBox      box;
    float       nearest;  // as the picture stores it
    std::size_t firstTriangle, endTriangle, end;
};

/// The nodes in view, and their own triangles.
struct RayTree {
    std::vector<RayNode>        nodes;
    std::vector<ScreenTriangle> triangles;

    void enter(Work& work, const Parts& parts, TreeVisit& visit, PlacedNode node);

    std::span<const ScreenTriangle> ownOf(const RayNode& node) const
    {
        return std::span(triangles).subspan(node.firstTriangle, node.endTriangle - node.firstTriangle);
    }
};

void RayTree::enter(Work& work, const Parts& parts, TreeVisit& visit, PlacedNode node)
{
    if (work.isCancelled() || parts.judge(work, kNearestWins, visit, node) != Verdict::Entered) return;
    const PlacedTree& placed = visit.treeOf(node);
    const ViewBox     box    = placed.view(node.node->bounds);
    const NodeReach   reach  = reachOf(box, work.stripe.projection, work.stripe.region());
    const std::size_t at     = nodes.size();
    nodes.push_back({placed.place(*node.node), RayBox(box, work.stripe.projection), work.rules.stored(reach.nearest),
                     triangles.size(), triangles.size(), at});
    if (nodes.capacity() * sizeof(RayNode) > work.stripe.memory) throw std::bad_alloc();

    const auto              below = visit.childrenFarthestFirst(node);
    std::vector<PlacedNode> nearestFirst(below.rbegin(), below.rend());
    if (visit.hasOwnItems(node)) {
        work.tell(NodeDrawn{placed.place(*node.node)});
        if (!node.isInstanceTree())
            for (const BatchPlace& batch : visit.batchesNearestFirst(node)) {
                parts.setUp(work, batch);
                keepTriangles(work, triangles);
            }
    }
    nodes[at].endTriangle = triangles.size();
    for (const PlacedNode& child : nearestFirst) enter(work, parts, visit, child);
    nodes[at].end = nodes.size();
}

RayTree treeInView(Work& work, const Parts& parts)
{
    const SceneTrees& trees = treesOf(work.stripe.scene, TreeKind::Bvh);
    work.clock.lap(Stage::Build);
    RayTree   tree;
    TreeVisit visit(work, trees);
    if (const auto roots = visit.roots(); !roots.empty()) tree.enter(work, parts, visit, PlacedNode(roots.front()));
    work.clock.lap(Stage::Cull);
    return tree;
}

Ray rayThrough(const Projection& p, int x, int y)
{
    const double perPixel = 1 / p.pixelsPerSlope();
    return {{x, y}, {(x + 0.5 - p.centreX) * perPixel, (p.centreY - (y + 0.5)) * perPixel, 1}};
}

/// Whether the ray has met something that is nearer than all of the node.
bool isBehind(Work& work, const RayNode& node, const Ray& ray)
{
    const PixelKey met      = work.stripe.visible.row(ray.pixel.y)[ray.pixel.x];
    const bool     isBehind = rankOf(met) != 0 && node.nearest < depthOf(met);
    if (isBehind) work.tell(NodeBehindRay{node.place, ray.pixel, node.nearest, depthOf(met)});
    return isBehind;
}

/// Whether the ray meets the triangle; if so the depth test decides.
bool meet(Work& work, const ScreenTriangle& triangle, const Ray& ray)
{
    const auto [x, y] = ray.pixel;
    if (!triangle.box.holds(ray.pixel) || !Coverage(triangle).covers(x, y)) return false;
    work.tell(TriangleReached{triangle});
    DepthTest test(work, kNearestWins, triangle.depth, triangle.id, triangle.patterned);
    test.beginLine(y, x);
    test.offer(x);
    return true;
}

void castRay(Work& work, const RayTree& tree, const Ray& ray)
{
    RayCast cast{.pixel = ray.pixel, .rank = 0, .boxes = 0, .missed = 0, .behind = 0, .triangles = 0};
    for (std::size_t n = 0; n < tree.nodes.size(); ++cast.boxes) {
        const RayNode& node      = tree.nodes[n];
        const bool     isMissed  = node.box.isMissedBy(ray);
        const bool     isLeftOut = !isMissed && isBehind(work, node, ray);
        cast.missed += isMissed, cast.behind += isLeftOut;
        n = isMissed || isLeftOut ? node.end : n + 1;
        if (isMissed || isLeftOut) continue;
        for (const ScreenTriangle& triangle : tree.ownOf(node)) cast.triangles += meet(work, triangle, ray);
    }
    cast.rank = work.stripe.visible.rankAt(ray.pixel.x, ray.pixel.y);
    work.tell(cast);
}

}  // namespace

void castRays(Work& work, const Parts& parts)
{
    const RayTree tree = treeInView(work, parts);
    for (const int y : LinesOf(work))
        for (int x = 0; x < work.stripe.visible.width() && !work.isCancelled(); ++x)
            castRay(work, tree, rayThrough(work.stripe.projection, x, y));
}

// What the events say ---------------------------------------------------------------------------------------------

namespace {
constexpr PixelFate kBehindRay{"behind-ray", "in a node behind what the ray had met", FateKind::Hidden, 3, true};
}  // namespace

void NodeBehindRay::mean(Meanings& to) const
{
    const PixelBox here{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
    if (!to.asksAbout(here)) return;
    const auto make = [&](TriangleId id, PixelPosition) {
        return Meaning{.depth      = nearest,
                       .rivalDepth = met,
                       .fate       = kBehindRay,
                       .pixels     = here,
                       .sentence = fmt::format("{}, which holds {}, begins behind what the ray has met: it is at most "
                                               "{:.9g} near, and the ray has met {:.9g}.",
                                               capital(nameInWords(place)), to.telling().nameOf(id), nearest, met)};
    };
    to.below(place, {.word = "behind-ray", .effect = Effect::Ends, .countedAs = {"behind_ray"}}, make, &here);
}

About RayCast::about() const
{
    About about{.line = pixel.y, .pixels = PixelBox{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}};
    if (rank != 0) about.triangle = TriangleId{rank - 1};
    return about;
}

std::string RayCast::sentence(const Telling& telling) const
{
    return fmt::format(
        "The ray through pixel ({}, {}) sees {}: it has asked {} boxes, missed {} and left out {} that begin behind "
        "what "
        "it had met; it has met {} triangles.",
        pixel.x, pixel.y, rank == 0 ? std::string("the background") : telling.nameOf(TriangleId{rank - 1}), boxes,
        missed, behind, triangles);
}

}  // namespace zscope::plain
