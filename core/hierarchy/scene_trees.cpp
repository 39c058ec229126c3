#include "core/hierarchy/scene_trees.h"

#include <cmath>

namespace zscope {

namespace {

class TriangleBoxes : public ItemBoxes {
public:
    explicit TriangleBoxes(const Mesh& mesh) : m_mesh(mesh) {}

    std::uint32_t count() const override { return static_cast<std::uint32_t>(m_mesh.triangles.size()); }
    Bounds        boxOf(std::uint32_t item) const override
    {
        Bounds box;
        for (const std::uint32_t vertex : m_mesh.triangles[item]) box.include(m_mesh.positions[vertex]);
        return box;
    }

private:
    const Mesh& m_mesh;
};

class InstanceBoxes : public ItemBoxes {
public:
    explicit InstanceBoxes(const Scene& scene) : m_scene(scene)
    {
        for (const auto& mesh : scene.meshes) m_meshBounds.push_back(mesh->bounds());
    }

    std::uint32_t count() const override { return static_cast<std::uint32_t>(m_scene.instances.size()); }
    /// The world box of the mesh's placed box, grown by far more than its rounding.
    Bounds boxOf(std::uint32_t item) const override
    {
        const Instance& instance = m_scene.instances[item];
        const Bounds&   box      = m_meshBounds[instance.mesh.value];
        Bounds          world;
        if (box.isEmpty()) return world;
        for (int i = 0; i < 8; ++i)
            world.include(instance.toWorld({i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z}));
        for (int axis = 0; axis < 3; ++axis) {
            const auto&  m    = instance.toWorld.rows[static_cast<std::size_t>(axis)];
            const double size = std::abs(m[3]) + std::abs(m[0]) * largest(box, 0) + std::abs(m[1]) * largest(box, 1) +
                                std::abs(m[2]) * largest(box, 2);
            world.min[axis] -= 1e-14 * size;
            world.max[axis] += 1e-14 * size;
        }
        return world;
    }

private:
    static double largest(const Bounds& box, int axis) { return std::max(std::abs(box.min[axis]), std::abs(box.max[axis])); }

    const Scene&        m_scene;
    std::vector<Bounds> m_meshBounds;
};

template <TreeKind kKind>
struct Trees : SceneTrees {
    explicit Trees(const Scene& scene) : SceneTrees(scene, kKind) {}
};

}  // namespace

SceneTrees::SceneTrees(const Scene& scene, TreeKind kind)
    : m_scene(scene),
      m_kind(kind),
      m_instances(std::make_unique<Tree>(kind, std::make_unique<InstanceBoxes>(scene), kInstanceLeaf)),
      m_meshes(scene.meshes.size()),
      m_ready(std::make_unique<std::atomic<const Tree*>[]>(scene.meshes.size()))
{
}

const Tree& SceneTrees::mesh(MeshId mesh) const
{
    std::atomic<const Tree*>& ready = m_ready[mesh.value];
    if (const Tree* tree = ready.load(std::memory_order_acquire)) return *tree;
    const std::scoped_lock lock(m_mutex);
    std::unique_ptr<Tree>& tree = m_meshes[mesh.value];
    if (!tree) {
        tree = std::make_unique<Tree>(m_kind, std::make_unique<TriangleBoxes>(*m_scene.meshes[mesh.value]), kTriangleLeaf);
        ready.store(tree.get(), std::memory_order_release);
    }
    return *tree;
}

std::uint64_t SceneTrees::bytes() const
{
    const std::scoped_lock lock(m_mutex);
    std::uint64_t          total = m_instances->bytes();
    for (const auto& tree : m_meshes) total += tree ? tree->bytes() : 0;
    return total;
}

const SceneTrees& treesOf(const PreparedScene& scene, TreeKind kind)
{
    const auto make = [&scene]<TreeKind kKind>() -> const SceneTrees& {
        return scene.derived().get<Trees<kKind>>([&scene] { return std::make_unique<Trees<kKind>>(scene.scene()); });
    };
    return kind == TreeKind::Octree ? make.operator()<TreeKind::Octree>() : make.operator()<TreeKind::Bvh>();
}

}  // namespace zscope
