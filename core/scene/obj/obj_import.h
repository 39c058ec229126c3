// Reading one OBJ file into a mesh, trusting nothing in it.
//
// Coordinates  the float64 nearest to the decimal text. A vertex with a coordinate that is missing, no number, NaN,
//              infinite or beyond float64 keeps its place among the vertices (as 0, 0, 0) but no face may use it
// Indices      positive ones count from 1 and refer to vertices read so far, as the format defines them: a vertex
//              defined further down is out of range. Negative ones count back from the last vertex read
// Faces        a face with an unusable corner, or with fewer than three, is left out whole and reported with its line;
//              texture and normal indices must be integers, and are otherwise not looked at
// Names        of groups, objects and materials go to the end of the line, with any '#' (core/scene/obj/names.h)
// Kept         groups, objects, materials (Kd, d). Lines, points, curves and whatever is unknown is skipped and counted
// Limits       a file of at most memoryLimit bytes, statements of at most obj::kMaxLineBytes, concave faces of at most
//              kMaxConcaveCorners; the mesh, the file's text and the growing of lists together stay below memoryLimit
// Errors       Input: the file cannot be opened, is no text, or leaves nothing to draw. Limit. Cancelled
// Cost         one pass, linear in the bytes but for concave faces
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/mesh.h"

namespace zscope {

struct ObjOptions {
    std::uint64_t memoryLimit = 0;  // bytes; 0: three quarters of the machine's memory
    Progress      progress    = {};
};

struct ObjCounts {
    std::uint64_t vertices          = 0;
    std::uint64_t unusableVertices  = 0;
    std::uint64_t faces             = 0;  // statements read; of these droppedFaces are not in the mesh
    std::uint64_t droppedFaces      = 0;
    std::uint64_t triangles         = 0;  // faces in the mesh with three corners, four, and more
    std::uint64_t quads             = 0;
    std::uint64_t largerFaces       = 0;
    std::uint64_t mendedFaces       = 0;  // degenerate or self-intersecting, split as a fan
    std::uint64_t groupNames        = 0;  // different names after g, o and usemtl
    std::uint64_t objectNames       = 0;
    std::uint64_t materialNames     = 0;
    std::uint64_t skippedStatements = 0;
};

struct ObjImport {
    std::shared_ptr<const Mesh> mesh;
    /// At most obj::kMaxWarnings in file order, one per kind of skipped statement, and one that counts the rest.
    std::vector<Warning>     warnings;
    ObjCounts                counts;
    std::vector<std::string> libraries;                // real paths of the material libraries it names
    double                   readMs = 0, parseMs = 0;  // how long each took
};

Result<ObjImport> importObj(const std::string& path, const ObjOptions& options = {});

/// The same for text in memory. `name` stands in the messages; material libraries are looked for in `folder`, or not
/// at all where it is empty.
Result<ObjImport> importObjText(std::string_view text, const std::string& name, const std::string& folder,
                                const ObjOptions& options = {});

}  // namespace zscope
