// What a benchmark draws: scenes named on the command line, or those of a suite with the views and cameras it gives
// them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "core/base/result.h"
#include "core/measure/suites.h"
#include "core/scene/camera_path.h"

namespace zscope::cli {

struct BenchScene {
    std::string                word;
    std::string                view        = {};  // of the scene's own; empty: its first
    std::string                title       = {};  // what rows call it; empty: the scene's name and view
    std::string                cameraFile  = {};
    std::optional<Camera>      camera      = {};  // of that file
    std::optional<FaceCulling> faceCulling = {};  // where the command line says nothing
    bool                       isStandIn   = false;

    std::string nameFor(const Scene& scene) const;
    /// What was said on the command line goes over the file's camera: a size keeps the rest of it, anything else
    /// replaces it.
    Result<ViewWords::View> viewOf(const Scene& scene, const ViewWords& words) const;
    /// The words that draw it again, for `render` and `bench`.
    std::string options() const;
};

/// What a suite or an experiment calls a scene. Errors: Input when a file of the project is missing.
Result<BenchScene> benchSceneOf(const SuiteScene& scene, std::optional<FaceCulling> faceCulling);
/// Scenes that were said replace those of the suite; suite may be nullptr. Errors: Input when a file of the project is
/// missing.
Result<std::vector<BenchScene>> benchScenesOf(const std::vector<std::string>& said, const Suite* suite);

struct NamedPath {
    CameraPath  path;
    std::string file;    // as it was said
    std::string digest;  // of what it says, however it is laid out
};
/// A file of key frames, found as camera files of the project are. Errors: Input.
Result<NamedPath> cameraPathOf(const std::string& file);

}  // namespace zscope::cli
