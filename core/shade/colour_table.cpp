#include "core/shade/colour_table.h"

#include <algorithm>
#include <cmath>

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
dvec3 unit(const dvec3& v)
{
    return glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

/// In [0.25, 1]; 0.515 for a triangle without a normal.
double brightnessOf(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& towardsLight)
{
    const dvec3  normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    const double cosine = length > 0 && std::isfinite(length) ? glm::dot(normal, towardsLight) / length : 0;
    const double towards = 0.5 + 0.5 * cosine;
    return 0.25 + 0.75 * towards * std::sqrt(towards);
}

}  // namespace

std::uint32_t colourOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle)
{
    const Instance& placed       = scene.instances[instance.value];
    const Mesh&     mesh         = *scene.meshes[placed.mesh.value];
    const auto&     corners      = mesh.triangles[meshTriangle];
    const dvec3     towardsLight = -unit(scene.light.direction);
    const auto      at           = [&](std::size_t i) { return placed.toWorld(mesh.positions[corners[i]]); };
    const Rgb colour = placed.colour ? *placed.colour : mesh.materialOf(mesh.trianglePolygon[meshTriangle]).diffuse;
    return pack(colour, brightnessOf(at(0), at(1), at(2), towardsLight));
}

ColourTable::ColourTable(const Scene& scene)
{
    if (scene.triangleCount() > kMaxEntries) return;
    m_colours.resize(scene.triangleCount() + 1);
    m_colours[0]         = kBackgroundColour;
    const auto instances = static_cast<std::int64_t>(scene.instances.size());
#pragma omp parallel for schedule(dynamic, 16)
    for (std::int64_t i = 0; i < instances; ++i) {
        const InstanceId    instance{static_cast<std::uint32_t>(i)};
        const std::uint32_t first = scene.firstTriangle[instance.value];
        const auto          count = static_cast<std::uint32_t>(scene.meshOf(instance).triangles.size());
        for (std::uint32_t t = 0; t < count; ++t) m_colours[first + t + 1] = colourOf(scene, instance, t);
    }
}

}  // namespace zscope
