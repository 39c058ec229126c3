// What the tests of foreign pictures share: scenes, and files as other programs write them.
#pragma once

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/check/check.h"
#include "core/check/foreign.h"
#include "core/io/npy.h"
#include "core/measure/reference.h"
#include "core/scene/load.h"

namespace zscope::tests {

inline std::shared_ptr<const PreparedScene> preparedScene(const std::string& word)
{
    Result<Scene> scene = loadScene(word);
    EXPECT_TRUE(scene) << word;
    return std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(scene)));
}

inline Camera cameraOf(const Scene& scene, int width, int height)
{
    ViewRequest view = scene.views.empty() ? ViewRequest{} : scene.views.front().view;
    view.width = width, view.height = height;
    return *makeCamera(view, scene.bounds);
}

/// A folder of its own for each test, removed afterwards.
class CheckFiles : public testing::Test {
protected:
    void SetUp() override
    {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        m_folder         = std::filesystem::temp_directory_path()
                   / ("zscope_check_" + std::string(test->test_suite_name()) + "_" + test->name());
        std::filesystem::remove_all(m_folder);
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    /// Ids and depth as `render` writes them.
    std::string writeIds(const std::string& name, const Grid<std::int64_t>& ids) const
    {
        const auto fill = [&](int y, std::span<std::int64_t> row) {
            std::ranges::copy(ids.view().row(y), row.begin());
        };
        EXPECT_TRUE(writeNpy(path(name), ids.width(), ids.height(), NpyRow<std::int64_t>(fill)));
        return path(name);
    }
    std::string writeDepth(const std::string& name, const Grid<float>& depth) const
    {
        const auto fill = [&](int y, std::span<float> row) { std::ranges::copy(depth.view().row(y), row.begin()); };
        EXPECT_TRUE(writeNpy(path(name), depth.width(), depth.height(), NpyRow<float>(fill)));
        return path(name);
    }

private:
    std::filesystem::path m_folder;
};

template <class T>
void append(std::string& bytes, T value)
{
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
}

}  // namespace zscope::tests
