#include "core/hierarchy/scene_trees.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/placed_view.h"

namespace zscope {

namespace {

double squaredDistance(const dvec3& a, const dvec3& b) { return glm::dot(a - b, a - b); }

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
    double squaredReach(std::uint32_t item, const dvec3& from) const override
    {
        double most = 0;
        for (const std::uint32_t vertex : m_mesh.triangles[item])
            most = std::max(most, squaredDistance(m_mesh.positions[vertex], from));
        return most;
    }

private:
    const Mesh& m_mesh;
};

/// Found once: whoever visits the tree asks for them frame by frame.
class InstanceBoxes : public ItemBoxes {
public:
    explicit InstanceBoxes(const Scene& scene)
    {
        std::vector<PlacedMesh> meshes;
        for (const auto& mesh : scene.meshes) meshes.emplace_back(*mesh);
        m_boxes.reserve(scene.instances.size());
        for (const Instance& instance : scene.instances)
            m_boxes.push_back(meshes[instance.mesh.value].boxAt(instance.toWorld));
    }

    std::uint32_t count() const override { return static_cast<std::uint32_t>(m_boxes.size()); }
    Bounds        boxOf(std::uint32_t item) const override { return m_boxes[item]; }
    std::uint64_t bytes() const override { return m_boxes.capacity() * sizeof(Bounds); }

private:
    /// A mesh that is placed many times: its box, and the ball about the middle of that.
    class PlacedMesh {
    public:
        explicit PlacedMesh(const Mesh& mesh) : m_box(mesh.bounds()), m_middle(0.5 * m_box.min + 0.5 * m_box.max)
        {
            double most = 0;
            for (const dvec3& position : mesh.positions) most = std::max(most, squaredDistance(position, m_middle));
            m_radius = ballRadius(most);
        }

        /// What the world boxes of the placed box and of the placed ball have in common, grown by far more than its
        /// rounding.
        Bounds boxAt(const Affine& toWorld) const
        {
            Bounds world;
            if (m_box.isEmpty()) return world;
            for (int i = 0; i < 8; ++i)
                world.include(toWorld({i & 1 ? m_box.max.x : m_box.min.x, i & 2 ? m_box.max.y : m_box.min.y,
                                       i & 4 ? m_box.max.z : m_box.min.z}));
            const dvec3 middle = toWorld(m_middle);
            for (int axis = 0; axis < 3; ++axis) {
                const auto&  m    = toWorld.rows[static_cast<std::size_t>(axis)];
                const double size = std::abs(m[3]) + std::abs(m[0]) * largest(0) + std::abs(m[1]) * largest(1)
                                    + std::abs(m[2]) * largest(2);
                const double reach = m_radius * ballRadius(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
                if (middle[axis] - reach > world.min[axis]) world.min[axis] = middle[axis] - reach;
                if (middle[axis] + reach < world.max[axis]) world.max[axis] = middle[axis] + reach;
                world.min[axis] -= 1e-14 * size;
                world.max[axis] += 1e-14 * size;
            }
            return world;
        }

    private:
        double largest(int axis) const { return std::max(std::abs(m_box.min[axis]), std::abs(m_box.max[axis])); }

        Bounds m_box;
        dvec3  m_middle;
        double m_radius;
    };

    std::vector<Bounds> m_boxes;
};

template <TreeKind kKind>
struct Trees : SceneTrees {
    explicit Trees(const Scene& scene) : SceneTrees(scene, kKind) {}
};

}  // namespace

SceneTrees::SceneTrees(const Scene& scene, TreeKind kind)
    : m_scene(scene), m_kind(kind),
      m_instances(std::make_unique<Tree>(kind, std::make_unique<InstanceBoxes>(scene), kInstanceLeaf)),
      m_meshes(scene.meshes.size()), m_ready(std::make_unique<std::atomic<const Tree*>[]>(scene.meshes.size()))
{}

const Tree& SceneTrees::mesh(MeshId mesh) const
{
    std::atomic<const Tree*>& ready = m_ready[mesh.value];
    if (const Tree* tree = ready.load(std::memory_order_acquire)) return *tree;
    const std::scoped_lock lock(m_mutex);
    std::unique_ptr<Tree>& tree = m_meshes[mesh.value];
    if (!tree) {
        tree =
            std::make_unique<Tree>(m_kind, std::make_unique<TriangleBoxes>(*m_scene.meshes[mesh.value]), kTriangleLeaf);
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
