// Flat things to build small scenes of.
#pragma once

#include <array>

#include "core/scene/mesh.h"

namespace zscope::generated {

inline void addQuad(Mesh& mesh, const std::array<dvec3, 4>& corners, MaterialId material)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
    mesh.addPolygon(std::array{first, first + 1, first + 2, first + 3}, material);
}

/// Of side 2, about the origin.
inline void addBox(Mesh& mesh, MaterialId material)
{
    for (const double side : {-1.0, 1.0}) {
        addQuad(mesh, {{{side, -1, -1}, {side, 1, -1}, {side, 1, 1}, {side, -1, 1}}}, material);
        addQuad(mesh, {{{-1, side, -1}, {1, side, -1}, {1, side, 1}, {-1, side, 1}}}, material);
        addQuad(mesh, {{{-1, -1, side}, {1, -1, side}, {1, 1, side}, {-1, 1, side}}}, material);
    }
}

}  // namespace zscope::generated
