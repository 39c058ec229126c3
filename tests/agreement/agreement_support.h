// What the agreement tests share: the presets that promise exact pictures, held against the reference on one scene
// after another.
//
// Share      ZSCOPE_SANITIZED_TESTS says that a sanitizer makes every draw ten to twenty times as long. What it looks
//            for is in the text, not in the product of targets and threads nor in the number of scenes, so under one a
//            test draws with one lane and with the widest, with two threads, and shareOf() its scenes
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/frame/renderer.h"
#include "core/scene/scene.h"

namespace zscope::tests {

/// How many of `whole` repetitions this build makes: all, or under a sanitizer every tenth, at least one.
std::uint64_t shareOf(std::uint64_t whole);

/// Instruction sets of the fast text; one lane, the plain text, where there are none.
std::vector<Simd> targetsTested();
/// Those that promise exact pictures, to the bit or by face.
std::vector<Preset> exactPresets();

struct Agreement {
    std::vector<int>  threads = {1, 2, 3};
    std::vector<Simd> targets = targetsTested();
};
/// Draws by every exact preset and expects the reference's picture and no false cull. Gives back how many pixels show a
/// triangle: a test whose scenes are all empty would prove nothing.
std::uint64_t expectAgreement(const std::shared_ptr<const PreparedScene>& scene, const Camera& camera,
                              FaceCulling culling, const std::string& what, const Agreement& with = {});

using Prepared = std::shared_ptr<const PreparedScene>;
Prepared prepared(std::shared_ptr<const Scene> scene);
Prepared prepared(Scene scene);
Scene    builtinScene(const std::string& word);

/// Where two frames differ first, in ids, depths or colours; nothing if they do not.
std::optional<std::string> firstDifference(const Frame& a, const Frame& b);
/// Draws the frame by a renderer of its own; twice if the pipeline takes something over from the frame before.
void drawAlone(const DrawRequest& request, Frame& frame);

/// The textbook method's work on the frame, by name.
std::map<std::string, std::uint64_t> countersOf(const DrawRequest& request);

/// The scene's first view in this size; one that insists on its own camera keeps its own size.
Camera cameraFor(const Scene& scene, int width, int height);

}  // namespace zscope::tests
