#include "core/scene/opacity.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/base/quotable.h"

namespace zscope {

namespace {

constexpr std::size_t kMostWarnings = 100;

}  // namespace

std::string opacityOrigin(const Material& material)
{
    if (!material.opacityFrom) return {};
    const FileStatement& from = *material.opacityFrom;
    return fmt::format("{}, {}:{}", from.text, printable(std::filesystem::path(from.file).filename().string()),
                       from.line);
}

std::string opacityText(const Material& material)
{
    const std::string origin = opacityOrigin(material);
    return origin.empty() ? fmt::format("{}", material.opacity) : fmt::format("{} ({})", material.opacity, origin);
}

std::vector<UsedMaterial> invisibleMaterialsOf(const Scene& scene)
{
    std::vector<std::uint64_t> instances(scene.meshes.size(), 0);
    for (const Instance& instance : scene.instances) ++instances[instance.mesh.value];
    std::vector<UsedMaterial> used;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh        = *scene.meshes[m];
        const auto  isInvisible = [](const Material& material) { return material.opacity <= 0; };
        if (instances[m] == 0 || std::ranges::none_of(mesh.materials, isInvisible)) continue;
        std::vector<std::uint64_t> triangles(mesh.materials.size(), 0);
        for (std::size_t p = 0; p < mesh.polygonCount(); ++p)
            triangles[mesh.polygonMaterial[p].value] += mesh.firstTriangle[p + 1] - mesh.firstTriangle[p];
        for (std::size_t i = 0; i < mesh.materials.size(); ++i)
            if (triangles[i] > 0 && isInvisible(mesh.materials[i]))
                used.push_back({MeshId{static_cast<std::uint32_t>(m)}, MaterialId{static_cast<std::uint32_t>(i)},
                                triangles[i] * instances[m]});
    }
    return used;
}

std::vector<Warning> invisibleMaterials(const Scene& scene)
{
    std::vector<Warning> warnings;
    std::uint64_t        more = 0;
    for (const UsedMaterial& used : invisibleMaterialsOf(scene)) {
        const Material& material = scene.meshes[used.mesh.value]->materials[used.material.value];
        if (!material.opacityFrom) continue;  // a generator did it, or a program: there is nothing to change
        const FileStatement& from    = *material.opacityFrom;
        const auto           isKnown = [&from](const Warning& w) { return w.file == from.file && w.line == from.line; };
        if (std::ranges::any_of(warnings, isKnown)) continue;  // a file that is several meshes
        if (warnings.size() >= kMostWarnings) {
            ++more;
            continue;
        }
        warnings.push_back({from.file, from.line,
                            fmt::format("material '{}' has opacity 0 ({}): its faces are not drawn",
                                        quotable(material.name), from.text)});
    }
    if (more > 0) warnings.push_back({scene.name, 0, fmt::format("and {} more warnings", more)});
    return warnings;
}

}  // namespace zscope
