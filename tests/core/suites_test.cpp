// What a suite names is there: presets, scenes, cameras, and the baseline that its times are set against.
#include "core/measure/suites.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "core/frame/presets.h"
#include "core/io/read_file.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

namespace fs = std::filesystem;

TEST(Suites, NamePresetsThatExistAndTheBaseline)
{
    std::set<std::string_view> names;
    for (const Suite& suite : suites()) {
        EXPECT_TRUE(names.insert(suite.name).second) << suite.name;
        EXPECT_EQ(findSuite(suite.name), &suite);
        EXPECT_FALSE(suite.scenes.empty());
        EXPECT_FALSE(suite.threads.empty());
        EXPECT_NE(std::ranges::find(suite.algorithms, kSuiteBaseline), suite.algorithms.end()) << suite.name;
        for (const std::string_view algorithm : suite.algorithms)
            EXPECT_NE(std::ranges::find(kPresets, algorithm, &Preset::name), kPresets.end()) << algorithm;
    }
    EXPECT_EQ(findSuite("no such suite"), nullptr);
}

TEST(Suites, NameScenesViewsAndCamerasThatCanBeRead)
{
    int cameras = 0;
    for (const Suite& suite : suites()) {
        for (const SuiteScene& scene : suite.scenes) {
            SCOPED_TRACE(scene.word);
            ASSERT_TRUE(scene.word.starts_with("builtin:")) << "what a suite draws is there on every machine";
            const std::string_view name = scene.word.substr(8, scene.word.find('?') - 8);
            EXPECT_NE(std::ranges::find(builtinScenes(), name, &SceneEntry::name), builtinScenes().end());
            if (!scene.view.empty()) {
                const auto loaded = loadScene(std::string(scene.word));
                ASSERT_TRUE(loaded.ok());
                EXPECT_NE(std::ranges::find(loaded->views, scene.view, &NamedView::name), loaded->views.end())
                    << scene.view;
            }
            EXPECT_EQ(scene.model.empty(), scene.modelCamera.empty());
            for (const std::string_view file : {scene.camera, scene.modelCamera}) {
                if (file.empty()) continue;
                const auto text = readRegularFile((fs::path(ZSCOPE_SOURCE_DIR) / file).string(), 1 << 20);
                ASSERT_TRUE(text.ok()) << file;
                const auto camera = cameraFromJson(*text, std::string(file));
                ASSERT_TRUE(camera.ok()) << camera.error().text();
                constexpr std::pair<int, int> kSizes[]{{1600, 900}, {1024, 768}, {1920, 1080}};
                EXPECT_NE(std::ranges::find(kSizes, std::pair{camera->width, camera->height}), std::end(kSizes));
                ++cameras;
            }
        }
    }
    EXPECT_GE(cameras, 8);
}

}  // namespace
}  // namespace zscope
