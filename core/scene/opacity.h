// Materials that make faces invisible, and what says so.
//
// Words      "0 (Tr 1, lamp.mtl:3)": the value, and the statement that set it, where a file did
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace zscope {

/// An opacity with the statement that set it.
std::string opacityText(const Material& material);
/// The statement alone, "Tr 1, lamp.mtl:3", with its file's name without folders; empty: no file set it.
std::string opacityOrigin(const Material& material);

/// A material that faces of the scene have.
struct UsedMaterial {
    MeshId        mesh;
    MaterialId    material;
    std::uint64_t triangles = 0;  // in the whole scene, every instance of the mesh counted
};
/// Those of opacity 0, mesh by mesh.
std::vector<UsedMaterial> invisibleMaterialsOf(const Scene& scene);

/// A warning for each of them, at the statement that set the opacity; of many the first hundred.
std::vector<Warning> invisibleMaterials(const Scene& scene);

}  // namespace zscope
