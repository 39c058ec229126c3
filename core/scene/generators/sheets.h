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

/// The same in n x n pieces.
inline void addQuadInPieces(Mesh& mesh, const std::array<dvec3, 4>& corners, int n, MaterialId material)
{
    const auto at = [&](int i, int j) {
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        return (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[3] + u * corners[2]);
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) addQuad(mesh, {{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}}, material);
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
