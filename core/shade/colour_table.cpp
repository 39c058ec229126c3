#include "core/shade/colour_table.h"

#include <algorithm>
#include <cmath>

#include <omp.h>

#include <glm/geometric.hpp>

namespace zscope {

namespace {

std::uint32_t pack(Rgb colour, double brightness)
{
    const auto channel = [brightness](float value) {
        return static_cast<std::uint32_t>(std::lround(std::clamp(value * brightness, 0.0, 1.0) * 255));
    };
    return 0xFF000000u | channel(colour.r) << 16 | channel(colour.g) << 8 | channel(colour.b);
}

/// Of length 1, whatever the length was (but 0): scaled first, so that no square runs over or vanishes.
dvec3 unit(const dvec3& v) { return glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)})); }

/// In [0.25, 1]; 0.515 for a triangle without a normal. A mirrored instance's corners run the other way round, and its
/// normals stay on the same side of the surface.
double brightnessOf(const dvec3& a, const dvec3& b, const dvec3& c, bool isMirrored, const dvec3& towardsLight)
{
    const dvec3  across  = glm::cross(b - a, c - a);
    const dvec3  normal  = isMirrored ? -across : across;
    const double length  = glm::length(normal);
    const double cosine  = length > 0 && std::isfinite(length) ? glm::dot(normal, towardsLight) / length : 0;
    const double towards = 0.5 + 0.5 * cosine;
    return 0.25 + 0.75 * towards * std::sqrt(towards);
}

dvec3 towardsLightOf(const Scene& scene) { return -unit(scene.light.direction); }

/// `a`, `b` and `c`: the triangle's corners in the world. `isMirrored`: `placed` is.
std::uint32_t shaded(const Instance& placed, bool isMirrored, const Mesh& mesh, std::uint32_t triangle, const dvec3& a,
                     const dvec3& b, const dvec3& c, const dvec3& towardsLight)
{
    const Rgb colour = placed.colour ? *placed.colour : mesh.materialOf(mesh.trianglePolygon[triangle]).diffuse;
    return pack(colour, brightnessOf(a, b, c, isMirrored, towardsLight));
}

/// Fills the table of one instance, a run of triangles after another; `world` holds the mesh's corners in the world.
void shadeTriangles(const Instance& placed, const Mesh& mesh, std::uint32_t from, std::uint32_t end, const dvec3* world,
                    const dvec3& towardsLight, std::uint32_t* colours)
{
    const bool isMirrored = placed.toWorld.isMirrored();
    for (std::uint32_t t = from; t < end; ++t) {
        const auto& corners = mesh.triangles[t];
        colours[t] =
            shaded(placed, isMirrored, mesh, t, world[corners[0]], world[corners[1]], world[corners[2]], towardsLight);
    }
}

/// Instances of at least so many triangles are shaded by all threads together, smaller ones by one thread each.
constexpr std::uint32_t kLargeMesh = 65'536;
constexpr std::int64_t  kRun       = 4'096;  // triangles or corners that a thread takes at a time

}  // namespace

std::uint32_t colourOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle)
{
    const Instance& placed  = scene.instances[instance.value];
    const Mesh&     mesh    = *scene.meshes[placed.mesh.value];
    const auto&     corners = mesh.triangles[meshTriangle];
    const auto      at      = [&](std::size_t i) { return placed.toWorld(mesh.positions[corners[i]]); };
    return shaded(placed, placed.toWorld.isMirrored(), mesh, meshTriangle, at(0), at(1), at(2), towardsLightOf(scene));
}

ColourTable::ColourTable(const Scene& scene)
{
    if (scene.triangleCount() > kMaxEntries) return;
    m_colours.resize(scene.triangleCount() + 1);
    m_colours[0]             = kBackgroundColour;
    const dvec3 towardsLight = towardsLightOf(scene);
    const auto  instances    = static_cast<std::int64_t>(scene.instances.size());
    // Where triangles name few of the mesh's corners, to bring all of them into the world would cost more than it
    // saves.
    const auto isSparse = [](const Mesh& mesh) { return mesh.positions.size() > 3 * mesh.triangles.size(); };
    const auto isLarge  = [&](InstanceId instance) {
        return scene.meshOf(instance).triangles.size() >= kLargeMesh && !isSparse(scene.meshOf(instance));
    };

    // A corner belongs to some six triangles: each is brought into the world once. Memory first, where it may throw.
    const auto  threads = static_cast<std::size_t>(omp_get_max_threads());
    std::size_t most = 0, mostOfLarge = 0;
    for (std::int64_t i = 0; i < instances; ++i) {
        const InstanceId instance{static_cast<std::uint32_t>(i)};
        std::size_t&     of = isLarge(instance) ? mostOfLarge : most;
        if (isSparse(scene.meshOf(instance))) continue;
        of = std::max(of, scene.meshOf(instance).positions.size());
    }
    std::vector<dvec3> world(std::max(most * threads, mostOfLarge));

#pragma omp parallel for schedule(dynamic, 4)
    for (std::int64_t i = 0; i < instances; ++i) {
        const InstanceId instance{static_cast<std::uint32_t>(i)};
        if (isLarge(instance)) continue;
        const Instance& placed  = scene.instances[instance.value];
        const Mesh&     mesh    = scene.meshOf(instance);
        std::uint32_t*  colours = m_colours.data() + scene.firstTriangle[instance.value] + 1;
        if (isSparse(mesh)) {
            for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) colours[t] = colourOf(scene, instance, t);
            continue;
        }
        dvec3* own = world.data() + most * static_cast<std::size_t>(omp_get_thread_num());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) own[v] = placed.toWorld(mesh.positions[v]);
        shadeTriangles(placed, mesh, 0, static_cast<std::uint32_t>(mesh.triangles.size()), own, towardsLight, colours);
    }
    for (std::int64_t i = 0; i < instances; ++i) {
        const InstanceId instance{static_cast<std::uint32_t>(i)};
        if (!isLarge(instance)) continue;
        const Instance& placed    = scene.instances[instance.value];
        const Mesh&     mesh      = scene.meshOf(instance);
        const auto      corners   = static_cast<std::int64_t>(mesh.positions.size());
        const auto      triangles = static_cast<std::int64_t>(mesh.triangles.size());
        std::uint32_t*  colours   = m_colours.data() + scene.firstTriangle[instance.value] + 1;
#pragma omp parallel for schedule(dynamic, 4)
        for (std::int64_t run = 0; run < (corners + kRun - 1) / kRun; ++run)
            for (std::int64_t v = run * kRun; v < std::min(corners, (run + 1) * kRun); ++v)
                world[static_cast<std::size_t>(v)] = placed.toWorld(mesh.positions[static_cast<std::size_t>(v)]);
#pragma omp parallel for schedule(dynamic, 4)
        for (std::int64_t run = 0; run < (triangles + kRun - 1) / kRun; ++run)
            shadeTriangles(placed, mesh, static_cast<std::uint32_t>(run * kRun),
                           static_cast<std::uint32_t>(std::min(triangles, (run + 1) * kRun)), world.data(),
                           towardsLight, colours);
    }
}

}  // namespace zscope
