// What the fuzzer and its bounded test do with one input: read it as an OBJ file, in memory and within limits, and
// stop the program if the answer breaks a promise of core/scene/mesh.h or obj_import.h.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/scene/obj/obj_import.h"
#include "core/scene/obj/statement_stream.h"
#include "core/scene/obj/warning_list.h"

namespace zscope::fuzz {

inline void demand(bool holds, const char* promise)
{
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

/// Says whether the text gave a mesh. `folder` is where its material libraries may lie; empty: nowhere.
inline bool readAsObj(std::string_view text, const std::string& folder = {})
{
    const auto import = importObjText(text, "fuzz.obj", folder, {.memoryLimit = 256u << 20});
    if (!import.ok()) {
        demand(!import.error().sentence.empty(), "an error has a sentence");
        demand(import.error().sentence.find('\n') == std::string::npos, "an error is one line");
        return false;
    }
    const Mesh& mesh = *import->mesh;
    demand(!mesh.triangles.empty(), "a mesh has something to draw");
    for (const dvec3& p : mesh.positions)
        demand(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "positions are finite");
    demand(mesh.firstCorner.back() == mesh.corners.size(), "polygons tile the corners");
    demand(mesh.firstTriangle.back() == mesh.triangles.size(), "polygons tile the triangles");
    demand(mesh.polygonMaterial.size() == mesh.polygonCount() && mesh.polygonGroup.size() == mesh.polygonCount(),
           "every polygon has a material and a group");
    demand(mesh.trianglePolygon.size() == mesh.triangles.size(), "every triangle has a polygon");
    for (std::uint32_t p = 0; p < mesh.polygonCount(); ++p) {
        demand(mesh.polygonMaterial[p].value < mesh.materials.size(), "materials are in range");
        demand(mesh.polygonGroup[p].value < mesh.groups.size(), "groups are in range");
        const std::uint32_t triangles = mesh.firstTriangle[p + 1] - mesh.firstTriangle[p];
        demand(triangles + 2 >= mesh.polygon(PolygonId{p}).size(),
               "a polygon of n corners has at least n - 2 triangles");
        for (std::uint32_t t = mesh.firstTriangle[p]; t < mesh.firstTriangle[p + 1]; ++t)
            demand(mesh.trianglePolygon[t].value == p, "a triangle knows its polygon");
    }
    for (const std::uint32_t corner : mesh.corners) demand(corner < mesh.positions.size(), "corners are in range");
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) demand(vertex < mesh.positions.size(), "triangles are in range");
    demand(import->warnings.size() <= obj::kMaxWarnings + obj::kMaxSkippedKinds + 2, "warnings are capped");
    for (const Warning& warning : import->warnings)
        demand(warning.sentence.find('\n') == std::string::npos, "a warning is one line");
    demand(import->counts.faces == mesh.polygonCount() + mesh.droppedFaces, "every face is kept or counted as dropped");
    return true;
}

}  // namespace zscope::fuzz
