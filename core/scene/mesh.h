// One mesh as it was read: positions, polygons of any size, and the triangles they were split into.
//
// Positions  float64, model space, finite
// Polygons   polygon p has the corners [firstCorner[p], firstCorner[p+1]) of `corners`, in file order
// Triangles  those of polygon p are [firstTriangle[p], firstTriangle[p+1]), in load order: convex faces as a
//            fan from the first corner, concave ones by ears (docs/correctness.md, Polygons)
//            (a polygon of n corners has n - 2 triangles, more where corners touch its own edges)
// Promise    every index is in range; a face that was dropped while reading is in none of the lists
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/affine.h"
#include "core/base/ids.h"
#include "core/scene/cutout.h"
#include "core/scene/relief.h"

namespace zscope {

enum class PolygonSplit;  // core/scene/triangulate.h
class PolygonSplitter;

/// Linear colour, each part in [0, 1].
struct Rgb {
    float r = 0, g = 0, b = 0;

    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// A statement of a file, as it was written.
struct FileStatement {
    std::string text;  // "Tr 1"
    std::string file;
    int         line = 0;  // 1-based
};

struct Material {
    std::string           name;
    Rgb                   diffuse{0.66f, 0.75f, 0.88f};  // Kd
    float                 opacity = 1;                   // d; below 1 the face is outside ids and depth
    std::optional<Cutout> cutout  = {};                  // holes in the face
    std::optional<Relief> relief  = {};                  // fragments that lie farther than the face
    // what set an opacity below 1; nullptr: no file did
    std::shared_ptr<const FileStatement> opacityFrom = {};

    /// Its fragments are looked at one by one, because of holes or a relief.
    bool isPatterned() const { return cutout || relief; }
};

/// Axis-aligned box; empty while min > max.
struct Bounds {
    dvec3 min{std::numeric_limits<double>::infinity()};
    dvec3 max{-std::numeric_limits<double>::infinity()};

    bool isEmpty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    void include(const dvec3& p)
    {
        min = {p.x < min.x ? p.x : min.x, p.y < min.y ? p.y : min.y, p.z < min.z ? p.z : min.z};
        max = {p.x > max.x ? p.x : max.x, p.y > max.y ? p.y : max.y, p.z > max.z ? p.z : max.z};
    }
};

struct Mesh {
    std::string        name;
    std::vector<dvec3> positions;

    std::vector<std::uint32_t> corners;           // vertex of each corner of each polygon
    std::vector<std::uint32_t> firstCorner{0};    // polygons + 1 entries
    std::vector<MaterialId>    polygonMaterial;   // one per polygon
    std::vector<GroupId>       polygonGroup;      // one per polygon
    std::vector<std::uint32_t> firstTriangle{0};  // polygons + 1 entries

    std::vector<std::array<std::uint32_t, 3>> triangles;        // vertices, in the polygon's sense of turning
    std::vector<PolygonId>                    trianglePolygon;  // one per triangle
    // ascending: degenerate or self-intersecting, so a mere fan
    std::vector<PolygonId> mendedFaces;

    std::vector<Material>    materials{Material{}};  // [0] is what a face without usemtl has
    std::vector<std::string> groups{"default"};      // "group" or "object/group"; [0] before any statement

    std::uint64_t droppedFaces = 0;  // left out while reading
    std::uint64_t splitFaces   = 0;  // had more than three corners

    std::size_t                    polygonCount() const { return firstCorner.size() - 1; }
    std::span<const std::uint32_t> polygon(PolygonId p) const
    {
        return std::span(corners).subspan(firstCorner[p.value], firstCorner[p.value + 1] - firstCorner[p.value]);
    }
    const Material& materialOf(PolygonId p) const { return materials[polygonMaterial[p.value].value]; }
    bool isPatterned(std::uint32_t triangle) const { return materialOf(trianglePolygon[triangle]).isPatterned(); }
    /// Its triangles are a fan that is no triangulation of its outline.
    bool isMended(PolygonId p) const { return std::ranges::binary_search(mendedFaces, p); }

    /// Box of the positions that a triangle uses.
    Bounds bounds() const;

    /// Appends a polygon and splits it (core/scene/triangulate.h); the corners must be valid vertices, three or more.
    /// Returns false if the outline was degenerate or self-intersecting, so that a fan was used and should be reported,
    /// or if it was refused (concave beyond kMaxConcaveCorners), so that nothing but droppedFaces changed.
    bool addPolygon(std::span<const std::uint32_t> outline, MaterialId material = {}, GroupId group = {});
    /// The same for whoever adds many: says what was done, and uses the splitter's working memory again.
    PolygonSplit addPolygon(std::span<const std::uint32_t> outline, MaterialId material, GroupId group,
                            PolygonSplitter& splitter);
};

}  // namespace zscope
