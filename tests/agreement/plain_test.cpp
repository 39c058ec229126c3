// The plain text of core/method and core/plain against the renderer with all shortcuts: the same ids, depths and
// colours, bit by bit, for every preset and for every approximation of numbers.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/frame/renderer.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

void expectSame(DrawRequest request, const std::string& what)
{
    for (const int threads : {1, 2}) {
        request.threads   = threads;
        request.shortcuts = ShortcutSet::all();
        Frame all, none;
        drawAlone(request, all);
        request.shortcuts = ShortcutSet();
        drawAlone(request, none);
        const auto differs = firstDifference(all, none);
        EXPECT_FALSE(differs) << what << ", " << nameOf(request.pipeline) << ", " << threads << " threads, "
                              << *differs;
    }
}

class PlainText : public testing::TestWithParam<SoupKind> {};

TEST_P(PlainText, DrawsWhatShortcutsDraw)
{
    for (std::uint64_t seed = 1; seed <= shareOf(20); ++seed) {
        const int  width = 40 + static_cast<int>(seed * 37 % 60), height = 20 + static_cast<int>(seed * 53 % 50);
        const Soup soup  = makeSoup(GetParam(), seed, width, height);
        const auto scene = std::make_shared<const PreparedScene>(soup.scene);
        for (const Preset& preset : presets()) {
            if (preset.pipeline.chooser == Chooser::Measured || !hasFastText(preset.pipeline)) continue;
            expectSame({.scene       = scene,
                        .camera      = soup.camera,
                        .faceCulling = seed % 3 == 0 ? FaceCulling::Back : FaceCulling::None,
                        .pipeline    = preset.pipeline},
                       soup.what);
        }
        if (HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(Soups, PlainText, testing::ValuesIn(soupKinds().begin(), soupKinds().end()),
                         [](const auto& kind) { return std::to_string(static_cast<int>(kind.param)); });

struct Setting {
    std::string_view axis, word;
};
constexpr std::array kNumbers{Setting{"snap", "4-bits"},
                              Setting{"snap", "12-bits"},
                              Setting{"vertices", "float32"},
                              Setting{"depth-numbers", "float32"},
                              Setting{"depth-numbers", "accumulated"},
                              Setting{"depth-format", "float32-standard"},
                              Setting{"depth-format", "fixed-24"},
                              Setting{"depth-format", "fixed-16"},
                              Setting{"edges", "accumulated"},
                              Setting{"near", "drop"}};

/// Of the methods that skip nothing but what lies outside the view.
TEST_P(PlainText, DrawsWhatShortcutsDrawByApproximateNumbers)
{
    int drawn = 0;
    for (std::uint64_t seed = 1; seed <= shareOf(10); ++seed) {
        const Soup soup  = makeSoup(GetParam(), seed, 61, 47);
        const auto scene = std::make_shared<const PreparedScene>(soup.scene);
        for (const Preset& preset : presets())
            for (const Setting& choice : kNumbers) {
                const auto pipeline = withChoice(preset.pipeline, choice.axis, choice.word);
                if (preset.pipeline.chooser == Chooser::Measured || !hasFastText(preset.pipeline)
                    || preset.pipeline.cull != Cull::Frustum || !pipeline || explainInvalid(*pipeline))
                    continue;
                expectSame({.scene = scene, .camera = soup.camera, .pipeline = *pipeline}, soup.what);
                ++drawn;
            }
        if (HasFailure()) return;
    }
    EXPECT_GT(drawn, 50);
}

TEST(PlainTextOnGenerated, DrawsWhatShortcutsDraw)
{
    for (const char* word : {"builtin:teapot?tessellation=4", "builtin:glass", "builtin:cutouts", "builtin:reliefs",
                             "builtin:layers?count=6", "builtin:soccer-ball", "builtin:wall-and-city?blocks=4"}) {
        const auto   loaded = std::make_shared<const Scene>(loadScene(word).value());
        const auto   scene  = std::make_shared<const PreparedScene>(loaded);
        const Camera camera = cameraFor(*loaded, 120, 75);
        for (const Preset& preset : presets())
            if (preset.pipeline.chooser != Chooser::Measured && hasFastText(preset.pipeline))
                expectSame({.scene = scene, .camera = camera, .pipeline = preset.pipeline}, word);
    }
}

}  // namespace
}  // namespace zscope::tests
