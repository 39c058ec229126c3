// Numbers that cannot be confused: each kind of index is a type of its own, so handing a triangle to
// something that wants a node does not compile.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace zscope {

/// An index of one kind. 32 bits: a scene holds at most kMaxTriangles triangles.
template <class Kind>
struct Id {
    std::uint32_t value = 0;

    friend constexpr auto operator<=>(Id, Id) = default;
};

using TriangleId = Id<struct TriangleKind>;  // in load order over the whole scene, from 0
using PolygonId  = Id<struct PolygonKind>;   // in load order inside one mesh, from 0
using InstanceId = Id<struct InstanceKind>;  // in the order of Scene::instances
using MeshId     = Id<struct MeshKind>;      // in the order of Scene::meshes
using MaterialId = Id<struct MaterialKind>;  // in the order of Mesh::materials
using GroupId    = Id<struct GroupKind>;     // in the order of Mesh::groups
using NodeId     = Id<struct NodeKind>;      // of one octree or BVH

/// The picture stores id + 1 in 32 bits and 0 for background, so one value is spent.
inline constexpr std::uint64_t kMaxTriangles = 0xFFFF'FFFEull;

/// Number of a step of a stepped run, counted from 0 within one grain.
struct StepIndex {
    std::uint64_t value = 0;

    friend constexpr auto operator<=>(StepIndex, StepIndex) = default;
};

}  // namespace zscope
