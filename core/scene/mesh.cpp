#include "core/scene/mesh.h"

#include <algorithm>
#include <cassert>

#include "core/scene/triangulate.h"

namespace zscope {

Bounds Mesh::bounds() const
{
    Bounds box;
    for (const auto& triangle : triangles)
        for (const std::uint32_t vertex : triangle) box.include(positions[vertex]);
    return box;
}

bool Mesh::addPolygon(std::span<const std::uint32_t> outline, MaterialId material, GroupId group)
{
    PolygonSplitter    splitter;
    const PolygonSplit how = addPolygon(outline, material, group, splitter);
    return how == PolygonSplit::Fan || how == PolygonSplit::Ears;
}

PolygonSplit Mesh::addPolygon(std::span<const std::uint32_t> outline, MaterialId material, GroupId group,
                              PolygonSplitter& splitter)
{
    assert(outline.size() >= 3);
    assert(std::ranges::all_of(outline, [this](std::uint32_t vertex) { return vertex < positions.size(); }));
    assert(material.value < materials.size() && group.value < groups.size());
    const PolygonSplit how = splitter.split(positions, outline, triangles);
    if (how == PolygonSplit::Refused) {
        ++droppedFaces;
        return how;
    }
    const PolygonId polygon{static_cast<std::uint32_t>(polygonCount())};
    trianglePolygon.resize(triangles.size(), polygon);
    if (how == PolygonSplit::MendedFan) mendedFaces.push_back(polygon);
    corners.insert(corners.end(), outline.begin(), outline.end());
    firstCorner.push_back(static_cast<std::uint32_t>(corners.size()));
    firstTriangle.push_back(static_cast<std::uint32_t>(triangles.size()));
    polygonMaterial.push_back(material);
    polygonGroup.push_back(group);
    if (outline.size() > 3) ++splitFaces;
    return how;
}

}  // namespace zscope
