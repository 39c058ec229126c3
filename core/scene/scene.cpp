#include "core/scene/scene.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

namespace zscope {

namespace {

/// A 64-bit fingerprint of a stream of words, FNV-1a with 64 bits per step and a final mix.
class Digest {
public:
    void add(std::uint64_t word)
    {
        m_state = (m_state ^ word) * 0x9E37'79B9'7F4A'7C15ull;  // odd: no two states meet
        m_state ^= m_state >> 32;                               // lets high bits reach low ones
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(float number) { add(std::uint64_t{std::bit_cast<std::uint32_t>(number)}); }
    void add(const dvec3& point)
    {
        add(point.x);
        add(point.y);
        add(point.z);
    }
    void add(const Rgb& colour)
    {
        add(colour.r);
        add(colour.g);
        add(colour.b);
    }
    template <class Kind>
    void add(Id<Kind> id)
    {
        add(std::uint64_t{id.value});
    }
    void add(std::uint32_t number) { add(std::uint64_t{number}); }
    template <class Values>
    void addAll(const Values& values)
    {
        add(static_cast<std::uint64_t>(std::size(values)));
        for (const auto& value : values) add(value);
    }
    std::string text() const
    {
        std::uint64_t mixed = m_state;
        mixed               = (mixed ^ (mixed >> 29)) * 0xBF58'476D'1CE4'E5B9ull;
        return fmt::format("{:016x}", mixed ^ (mixed >> 32));
    }

private:
    std::uint64_t m_state = 0xCBF2'9CE4'8422'2325ull;
};

void addMesh(Digest& digest, const Mesh& mesh)
{
    digest.addAll(mesh.positions);
    digest.addAll(mesh.corners);
    digest.addAll(mesh.firstCorner);
    digest.addAll(mesh.polygonMaterial);
    digest.addAll(mesh.firstTriangle);
    digest.add(static_cast<std::uint64_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles)
        for (std::uint32_t vertex : triangle) digest.add(vertex);
    digest.add(static_cast<std::uint64_t>(mesh.materials.size()));
    for (const Material& material : mesh.materials) {
        digest.add(material.diffuse);
        digest.add(material.opacity);
        if (material.cutout) {
            digest.add(static_cast<std::uint64_t>(material.cutout->pattern));
            digest.add(material.cutout->size);
        }
        if (material.relief) {
            digest.add(static_cast<std::uint64_t>(material.relief->pattern) + 0x52656C696566u);  // no cut-out's pattern
            digest.add(material.relief->size);
            digest.add(material.relief->depth);
        }
    }
}

std::string digestOf(const Scene& scene)
{
    Digest digest;
    digest.add(static_cast<std::uint64_t>(scene.meshes.size()));
    for (const auto& mesh : scene.meshes) addMesh(digest, *mesh);
    digest.add(static_cast<std::uint64_t>(scene.instances.size()));
    for (const Instance& instance : scene.instances) {
        digest.add(instance.mesh);
        for (const auto& row : instance.toWorld.rows)
            for (double entry : row) digest.add(entry);
        digest.add(std::uint64_t{instance.colour.has_value()});
        if (instance.colour) digest.add(*instance.colour);
    }
    digest.add(scene.light.direction);
    return digest.text();
}

bool isFinite(const Affine& matrix)
{
    return std::ranges::all_of(matrix.rows, [](const auto& row) {
        return std::ranges::all_of(row, [](double entry) { return std::isfinite(entry); });
    });
}

/// The world box of a mesh: the corners of its own box through the matrix. Exact for the identity, otherwise it
/// may be larger than the mesh, and smaller only by rounding.
void include(Bounds& world, const Bounds& box, const Affine& toWorld)
{
    if (box.isEmpty()) return;
    if (toWorld.isIdentity()) {
        world.include(box.min);
        world.include(box.max);
        return;
    }
    for (int corner = 0; corner < 8; ++corner)
        world.include(toWorld({corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                               corner & 4 ? box.max.z : box.min.z}));
}

std::string nameOf(const Scene& scene, std::size_t instance)
{
    return fmt::format("instance {}{}", instance, scene.name.empty() ? "" : " of " + scene.name);
}

/// The triangles' own data was checked where the mesh was made; here what a wrong index would cost is prevented.
void assertWhole([[maybe_unused]] const Mesh& mesh)
{
    assert(mesh.firstCorner.size() == mesh.firstTriangle.size());
    assert(mesh.polygonMaterial.size() == mesh.polygonCount());
    assert(mesh.trianglePolygon.size() == mesh.triangles.size());
    assert(mesh.firstTriangle.back() == mesh.triangles.size());
}

}  // namespace

InstanceId Scene::instanceOf(TriangleId id) const
{
    assert(id.value < triangleCount());
    const auto after = std::ranges::upper_bound(firstTriangle, id.value);  // empty instances share a first triangle
    return InstanceId{static_cast<std::uint32_t>(after - firstTriangle.begin() - 1)};
}

TriangleId Scene::firstOfFace(TriangleId id) const
{
    const InstanceId    instance = instanceOf(id);
    const Mesh&         mesh     = meshOf(instance);
    const std::uint32_t first    = firstTriangle[instance.value];
    return {first + mesh.firstTriangle[mesh.trianglePolygon[id.value - first].value]};
}

Result<Scene> assemble(Scene parts)
{
    const Light& light = parts.light;
    if (!isFinite(light.direction) || light.direction == dvec3{0, 0, 0})
        return Error{Trouble::Input, "the light's direction must be three finite numbers that are not all 0"};
    if (parts.instances.size() > kMaxTriangles)
        return Error{Trouble::Limit, fmt::format("the scene has {} instances, and at most {} can be told apart",
                                                 parts.instances.size(), kMaxTriangles)};

    std::vector<Bounds> boxes;
    for (const auto& mesh : parts.meshes) {
        if (!mesh) return Error{Trouble::Input, "the scene holds a mesh that was never made"};
        assertWhole(*mesh);
        boxes.push_back(mesh->bounds());
    }

    parts.bounds = {};
    parts.firstTriangle.assign(1, 0);
    parts.firstTriangle.reserve(parts.instances.size() + 1);
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < parts.instances.size(); ++i) {
        const Instance& instance = parts.instances[i];
        if (instance.mesh.value >= parts.meshes.size())
            return Error{Trouble::Input, fmt::format("{} names mesh {}, and there are {}", nameOf(parts, i),
                                                     instance.mesh.value, parts.meshes.size())};
        if (!isFinite(instance.toWorld))
            return Error{Trouble::Input, fmt::format("the matrix of {} is not finite", nameOf(parts, i))};
        triangles += parts.meshes[instance.mesh.value]->triangles.size();
        if (triangles > kMaxTriangles)
            return Error{Trouble::Limit, fmt::format("the scene has more than {} triangles, all that can be told apart",
                                                     kMaxTriangles)};
        parts.firstTriangle.push_back(static_cast<std::uint32_t>(triangles));
        include(parts.bounds, boxes[instance.mesh.value], instance.toWorld);
    }
    if (!parts.bounds.isEmpty() && !(isFinite(parts.bounds.min) && isFinite(parts.bounds.max)))
        return Error{Trouble::Input,
                     "the scene reaches beyond the largest number: its instances are too far or too large"};
    parts.digest = digestOf(parts);
    return parts;
}

}  // namespace zscope
