// The contract of the shortcuts: no set of them changes a bit of the picture.
//
// Pipelines  every composed preset, exact and with one approximation
// Sets       any; each one alone with what it needs; each one left out with what needs it
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/frame/shortcuts.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

constexpr Shortcut shortcutAt(int place) { return static_cast<Shortcut>(place); }

/// Every composed preset, as it is and with one approximation.
std::vector<Pipeline> pipelinesOfTheContract()
{
    struct Word {
        std::string_view axis, word;
    };
    constexpr std::array  kWords{Word{"snap", "4-bits"},
                                Word{"vertices", "float32"},
                                Word{"depth-numbers", "float32"},
                                Word{"depth-format", "float32-standard"},
                                Word{"depth-format", "fixed-16"},
                                Word{"near", "drop"},
                                Word{"shading-cost", "10-operations"},
                                Word{"cells", "one-level"},
                                Word{"small-nodes", "drop-below-16"}};
    std::vector<Pipeline> all;
    for (const Preset& preset : presets()) {
        if (preset.pipeline.chooser == Chooser::Measured) continue;
        all.push_back(preset.pipeline);
        for (const Word& word : kWords)
            if (const auto changed = withChoice(preset.pipeline, word.axis, word.word);
                changed && !explainInvalid(*changed))
                all.push_back(*changed);
    }
    return all;
}

/// Nothing if the frames are the same. The shortcuts draw over a picture of the same scene from nearer by, as they do
/// in the window: what that left must not show.
std::optional<std::string> whatShortcutsChange(DrawRequest request, ShortcutSet set)
{
    Frame plain, fast;
    request.shortcuts = {};
    drawAlone(request, plain);
    request.shortcuts  = set;
    DrawRequest before = request;
    before.camera.focal *= 1.5;
    drawAlone(before, fast);
    drawAlone(request, fast);
    const auto differs = firstDifference(plain, fast);
    if (!differs) return std::nullopt;
    return nameOf(request.pipeline) + " with the shortcuts " + wordsOf(set) + ", " + std::to_string(request.threads)
           + " threads, " + *differs;
}

TEST(ShortcutContract, NoSetOfShortcutsChangesABit)
{
    const std::vector<Pipeline> pipelines = pipelinesOfTheContract();
    std::mt19937_64             random(9);
    std::uint64_t               changedNothing = 0;
    for (std::uint64_t i = 0; i < shareOf(2000); ++i) {
        const SoupKind kind  = soupKinds()[random() % soupKinds().size()];
        const int      width = 30 + static_cast<int>(random() % 120), height = 20 + static_cast<int>(random() % 80);
        const Soup     soup = makeSoup(kind, random(), width, height, 20 + static_cast<int>(random() % 200));
        ShortcutSet    set  = with({}, Shortcut::Lanes);
        for (int k = 0; k < kShortcutCount; ++k)
            if (random() % 2 == 0) set = with(set, shortcutAt(k));
        DrawRequest             request{.scene       = prepared(soup.scene),
                                        .camera      = soup.camera,
                                        .faceCulling = random() % 2 == 0 ? FaceCulling::None : FaceCulling::Back,
                                        .pipeline    = pipelines[random() % pipelines.size()],
                                        .threads     = 1 + static_cast<int>(random() % 2)};
        const std::vector<Simd> targets = targetsTested();
        request.simd                    = targets[random() % targets.size()];
        // Where the borders between stripes lie in a second frame depends on the clock.
        const Approximation& numbers = request.pipeline.approximation;
        if (numbers.cells != CellDescent::Descend || numbers.small != SmallNodes::Keep) request.threads = 1;
        const auto changed = whatShortcutsChange(request, set);
        ASSERT_FALSE(changed) << soup.what << ", " << *changed;
        ++changedNothing;
    }
    EXPECT_EQ(changedNothing, shareOf(2000));
}

TEST(ShortcutContract, NoneAloneAndNoneLeftOutChangesABit)
{
    for (const char* word : {"teapot?tessellation=4", "glass", "cutouts", "reliefs", "layers?count=6",
                             "wall-and-city?blocks=4", "soccer-ball", "hard/B1", "hard/E7"}) {
        const auto   loaded = std::make_shared<const Scene>(builtinScene(word));
        const auto   scene  = prepared(loaded);
        const Camera camera = cameraFor(*loaded, 120, 75);
        for (const Preset& preset : presets()) {
            if (preset.pipeline.chooser == Chooser::Measured) continue;
            std::vector<ShortcutSet> sets;  // first alone, so that a failure names the shortcut
            for (int k = 0; k < kShortcutCount; ++k) sets.push_back(with({}, shortcutAt(k)));
            for (int k = 0; k < kShortcutCount; ++k) sets.push_back(without(ShortcutSet::all(), shortcutAt(k)));
            for (const ShortcutSet set : sets) {
                const auto changed = whatShortcutsChange({.scene       = scene,
                                                          .camera      = camera,
                                                          .faceCulling = FaceCulling::Back,
                                                          .pipeline    = preset.pipeline,
                                                          .threads     = 2},
                                                         set);
                ASSERT_FALSE(changed) << word << ", " << *changed;
            }
        }
    }
}

}  // namespace
}  // namespace zscope::tests
