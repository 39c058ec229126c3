// Everything that can be seen: meshes, placed as instances. An instanced mesh is never copied.
//
// World      right-handed, units of the file, float64
// Ids        triangle t of instance i has the id firstTriangle[i] + t: load order over the whole scene
// Promise    made only by assemble(), which checks every index and every limit
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/affine.h"
#include "core/base/ids.h"
#include "core/base/result.h"
#include "core/scene/mesh.h"
#include "core/scene/view.h"

namespace zscope {

struct Instance {
    MeshId             mesh;
    Affine             toWorld;
    std::optional<Rgb> colour = {};  // replaces the materials' colours; their opacity stays
};

/// One directional light; the shading is flat and the same from every eye.
struct Light {
    dvec3 direction{-0.35, -0.8, -0.5};  // in which the light travels, world space, any length but 0
};

struct NamedView {
    std::string name;
    ViewRequest view;
    int         line = 0;  // of the scene file; 0: it was not read from one
};

struct Scene {
    std::string                              name;   // the word or path it was loaded by
    std::vector<std::string>                 files;  // all that it was read from; of a generated scene none
    std::vector<std::shared_ptr<const Mesh>> meshes;
    std::vector<Instance>                    instances;
    std::vector<std::uint32_t>               firstTriangle{0};  // instances + 1 entries
    Light                                    light;
    std::vector<NamedView>                   views;  // [0], if any, is the default view
    std::vector<Warning>                     warnings;
    Bounds                                   bounds;  // of all instances, world space
    std::string                              digest;  // 16 hex digits of everything that decides the picture

    std::uint64_t triangleCount() const { return firstTriangle.back(); }
    const Mesh&   meshOf(InstanceId i) const { return *meshes[instances[i.value].mesh.value]; }
    /// The instance that holds triangle `id`; logarithmic in the number of instances.
    InstanceId instanceOf(TriangleId id) const;
    /// The first triangle of the face, as it was read, that triangle `id` is part of; as costly as instanceOf().
    TriangleId firstOfFace(TriangleId id) const;
};

/// Checks and completes a scene: ids, bounds, digest. Errors: Limit when there are more triangles than ids,
/// Input when an instance names no mesh or its matrix is not finite.
Result<Scene> assemble(Scene parts);

}  // namespace zscope
