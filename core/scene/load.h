// The one door through which scenes come in: an OBJ file, a scene file in JSON, or a generator's word.
//
// Words      path.obj | path.json | builtin:NAME[?key=value&...]
// Promise    bounded memory and time for any file; every problem is one sentence with file and line
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace zscope {

/// What loading took, in milliseconds.
struct LoadTimes {
    double readMs  = 0;  // files into memory
    double parseMs = 0;  // text to meshes, every face checked and split; all of a generated scene
    double checkMs = 0;  // every instance and limit, bounds, and the digest of the whole
};

struct LoadOptions {
    std::uint64_t memoryLimit = 0;  // bytes the scene may take; 0: three quarters of the machine's memory
    Progress      progress    = {};
    LoadTimes*    times       = nullptr;  // what it took is added here, if anywhere
    bool          isPart      = false;    // of a scene file, which may give the materials another opacity
};

Result<Scene> loadScene(const std::string& word, const LoadOptions& options = {});

/// A generated scene of the registry, for `list scenes` and the window's examples.
struct SceneEntry {
    std::string_view name;        // after "builtin:"
    std::string_view title;       // one line
    std::string_view parameters;  // "count=1000&seed=1" with the defaults, or empty
};
std::span<const SceneEntry> builtinScenes();

}  // namespace zscope
