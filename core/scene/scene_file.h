// Scene files: meshes, where they stand, what they are made of, the light and the cameras, as JSON.
//
//   {"meshes":    {NAME: {"obj": PATH} | {"builtin": WORD}},
//    "instances": [{"mesh": NAME, "matrix": [12 numbers, 3 rows]}                    absent: where the mesh says
//                | {"mesh": NAME, "grid":   {"count": [3], "step": [3]}}             x runs fastest; the first at 0
//                | {"mesh": NAME, "random": {"count": n, "seed": s, "min": [3], "max": [3], "rotate": bool}}],
//    "materials": {NAME: {"colour": [3], "opacity": d}},
//    "light":     {"direction": [3]},
//    "cameras":   {NAME: {view options, or the ten numbers of a camera}}}            the first is the default view
//
// Paths      relative to the file, with / or \ between folders; they stay inside its folder, links included
// Builtin    the word must be one of a single mesh (teapot, soccer-ball, cube, ...): a whole scene is refused
// Materials  one replaces the material of that name in every mesh of the file (obj/names.h); an instance may wear one
//            by "material": NAME (its colour), or "colour": [3], or "colour": "each" for one per copy
// Limits     file kMaxSceneFileBytes; counts are checked against the memory limit before anything is allocated
// Errors     Input and Limit, with file and line; an unknown key is an error, nothing is guessed
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/scene/load.h"
#include "core/scene/scene.h"

namespace zscope {

inline constexpr std::uint64_t kMaxSceneFileBytes = 64u << 20;

Result<Scene> loadSceneFile(const std::string& path, const LoadOptions& options = {});

}  // namespace zscope
