// Judges another program's culling against the exact picture.
//
// Verdicts   what the culler said of boxes in world space, or of groups, objects and instances by name. One that owns a
//            visible pixel must not be culled (a false cull); one that owns none could have been (a missed cull)
// Owns       a box: the point that is seen at the pixel's centre lies in it, grown by a millionth of its size. A name:
//            the triangle that is seen there belongs to it
// Pyramid    levels in near/z, the pixels first. A cell may not be nearer than the farthest pixel below it: it would
//            hide what that pixel lets through. Level k + 1 has half the width and height of level k, rounded up or
//            down
// Source     docs/check.md, Culling
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/check/truth.h"
#include "core/scene/mesh.h"

namespace zscope::check {

/// What a culler said of one object.
struct CullVerdict {
    std::string           name;
    std::optional<Bounds> box;  // nothing: `name` is a group, an object, a mesh, or "instance N"
    bool                  isCulled = false;
    int                   line     = 0;  // of the file
};

/// JSON: [{"name": s, "min": [3], "max": [3], "culled": bool}] or [{"group": s, "culled": bool}]. Errors: Input.
Result<std::vector<CullVerdict>> cullVerdictsOf(std::string_view text, const std::string& file);

struct CullJudgement {
    std::string   name;
    bool          isCulled = false;
    std::uint64_t pixels   = 0;  // that it owns

    bool isFalseCull() const { return isCulled && pixels > 0; }
    bool isMissedCull() const { return !isCulled && pixels == 0; }
};
/// In the order of the verdicts. Errors: Input, a name that the scene does not have.
Result<std::vector<CullJudgement>> auditVerdicts(const Truth& truth, const std::vector<CullVerdict>& verdicts,
                                                 const std::string& file);

struct WrongCell {
    int    level = 0, x = 0, y = 0;
    double value    = 0;
    double farthest = 0;  // of the pixels below it
};
enum class PyramidCause { NearestInCells, OddPadded, LevelShifted, LevelTooFine, Unknown };
/// "nearest-in-cells", "odd-padded", "level-shifted", "level-too-fine", "unknown".
std::string_view wordOf(PyramidCause cause);

struct PyramidJudgement {
    std::uint64_t               cells = 0;  // of all levels but the first
    std::vector<WrongCell>      wrong;      // by level and row; at most kMostWrongCells
    std::uint64_t               wrongCells = 0;
    std::optional<PyramidCause> cause;  // nothing: no cell is wrong

    static constexpr std::size_t kMostWrongCells = 1000;
};
/// levels[0] holds the pixels. Each level has half the size of the one before (isHalfOf).
PyramidJudgement auditPyramid(const std::vector<Grid<double>>& levels);
/// True if a level of `size` cells may stand above one of `below`: a half, rounded up or down, and at least one.
bool isHalfOf(int size, int below);

}  // namespace zscope::check
