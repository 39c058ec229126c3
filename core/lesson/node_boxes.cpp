#include "core/lesson/node_boxes.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "core/cull/node_reach.h"
#include "core/hierarchy/scene_trees.h"

namespace zscope {
namespace {

const Affine& spaceOf(const NodeRow& node, const Scene& scene)
{
    static const Affine world;
    return node.instance ? scene.instances[node.instance->value].toWorld : world;
}

const Tree& treeOf(const NodeRow& node, const PreparedScene& scene, TreeKind kind)
{
    const SceneTrees& trees = treesOf(scene, kind);
    return node.instance ? trees.mesh(scene.scene().instances[node.instance->value].mesh) : trees.instances();
}

/// What is in front of the near plane of a line in the world.
void addLine(const dvec3& from, const dvec3& to, const Camera& camera, std::vector<ScreenLine>& lines)
{
    const Projection projection(camera);
    dvec3            a = projection.toView(from), b = projection.toView(to);
    if (a.z < camera.near && b.z < camera.near) return;
    const auto cut = [&](const dvec3& out, const dvec3& in) {
        dvec3 at = out + (in - out) * ((camera.near - out.z) / (in.z - out.z));
        at.z     = camera.near;
        return at;
    };
    if (a.z < camera.near)
        a = cut(a, b);
    else if (b.z < camera.near)
        b = cut(b, a);
    const ScreenCorner start = projection.toScreen(a), end = projection.toScreen(b);
    lines.push_back({start.x, start.y, end.x, end.y});
}

/// The deepest known node of one tree that holds the item; -1 if not even the root is known.
int deepestHolding(std::uint32_t item, const Tree& tree, const std::map<std::string, int>& known)
{
    int             best = -1;
    const TreeNode* node = &tree.root();
    for (;;) {
        const auto row = known.find(pathOf(*node));
        if (row == known.end()) return best;
        best = row->second;
        if (!node->isOpen.load(std::memory_order_acquire)) return best;
        const TreeNode* next = nullptr;
        for (const TreeNode& child : tree.childrenOf(*node))
            if (std::ranges::find(tree.allItems(child), item) != tree.allItems(child).end()) next = &child;
        if (!next) return best;
        node = next;
    }
}

}  // namespace

int rowOf(const std::vector<NodeRow>& nodes, const NodeName& name)
{
    const auto found = std::ranges::find_if(
        nodes, [&](const NodeRow& row) { return row.path == name.path && row.instance == name.instance; });
    return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

std::array<dvec3, 8> cornersOf(const NodeRow& node, const Scene& scene)
{
    const Affine&        toWorld = spaceOf(node, scene);
    std::array<dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = toWorld({i & 1 ? node.box.max.x : node.box.min.x, i & 2 ? node.box.max.y : node.box.min.y,
                              i & 4 ? node.box.max.z : node.box.min.z});
    return corners;
}

std::vector<ScreenLine> outlineOf(const NodeRow& node, const Scene& scene, const Camera& camera)
{
    const auto              corners = cornersOf(node, scene);
    std::vector<ScreenLine> lines;
    for (const auto& edge : kBoxEdges)
        addLine(corners[static_cast<std::size_t>(edge[0])], corners[static_cast<std::size_t>(edge[1])], camera, lines);
    return lines;
}

std::vector<ScreenLine> outlineOf(TriangleId triangle, const Scene& scene, const Camera& camera)
{
    std::vector<ScreenLine> lines;
    if (triangle.value >= scene.triangleCount()) return lines;
    const InstanceId id       = scene.instanceOf(triangle);
    const Instance&  instance = scene.instances[id.value];
    const Mesh&      mesh     = *scene.meshes[instance.mesh.value];
    const auto&      corners  = mesh.triangles[triangle.value - scene.firstTriangle[id.value]];
    for (std::size_t k = 0; k < 3; ++k)
        addLine(instance.toWorld(mesh.positions[corners[k]]), instance.toWorld(mesh.positions[corners[(k + 1) % 3]]),
                camera, lines);
    return lines;
}

NodeOnScreen onScreen(const NodeRow& node, const Scene& scene, const Camera& camera)
{
    const NodeReach reach =
        reachOf(node.box, spaceOf(node, scene), Projection(camera), {0, 0, camera.width, camera.height});
    const PixelBox& box  = reach.pixels;
    const bool      none = box.x1 <= box.x0 || box.y1 <= box.y0;
    return {none ? 0 : std::int64_t{box.x1 - box.x0} * (box.y1 - box.y0), reach.nearest, reach.crossesNear};
}

const TreeNode* nodeAt(const Tree& tree, const std::string& path)
{
    const TreeNode* node = &tree.root();
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1)) {
        if (!node->isOpen.load(std::memory_order_acquire)) return nullptr;
        const int  slot     = std::atoi(path.c_str() + dot + 1);
        const auto children = tree.childrenOf(*node);
        const auto child = std::ranges::find_if(children, [slot](const TreeNode& each) { return each.slot == slot; });
        if (child == children.end()) return nullptr;
        node = &*child;
    }
    return node;
}

std::uint64_t itemsBelow(const NodeRow& node, const PreparedScene& scene, TreeKind kind)
{
    const TreeNode* found = nodeAt(treeOf(node, scene, kind), node.path);
    return found ? found->size() : 0;
}

int nodeHolding(TriangleId triangle, const std::vector<NodeRow>& nodes, const PreparedScene& scene, TreeKind kind)
{
    const InstanceId           instance = scene.scene().instanceOf(triangle);
    std::map<std::string, int> ofInstance, ofInstances;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].instance)
            ofInstances.emplace(nodes[i].path, static_cast<int>(i));
        else if (*nodes[i].instance == instance)
            ofInstance.emplace(nodes[i].path, static_cast<int>(i));
    }
    const SceneTrees& trees = treesOf(scene, kind);
    if (!ofInstance.empty())
        return deepestHolding(triangle.value - scene.scene().firstTriangle[instance.value],
                              trees.mesh(scene.scene().instances[instance.value].mesh), ofInstance);
    return ofInstances.empty() ? -1 : deepestHolding(instance.value, trees.instances(), ofInstances);
}

}  // namespace zscope
