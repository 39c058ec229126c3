// Scenes small enough to be stepped through whole, and the request that draws one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/frame/renderer.h"
#include "core/lesson/replay.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {

/// A scene, ready to be drawn, with a camera and a name for failure messages.
struct SeenScene {
    std::string                          what;
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;

    DrawRequest request(const Pipeline& pipeline) const;
};

/// A scene of the registry ("teapot?tessellation=3"), seen by its own default view.
SeenScene builtinScene(const std::string& word, int width, int height);
SeenScene soupScene(SoupKind kind, std::uint64_t seed, int width, int height, int triangles);

/// What a state shows, apart from how it was asked for: two steps of different grains at one moment have the same.
std::string contentsOf(const StepState& state);
/// True if two states agree in text, picture, colours and edge-table buckets.
bool areIdentical(const StepState& a, const StepState& b);

}  // namespace zscope::tests
