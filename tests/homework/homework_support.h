// What the tests of the homework share: their scenes, and the dumps that renderers write.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/depth/visibility_buffer.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::homework_test {

/// Exit status of a command of the shell; 1000: a signal ended it.
int statusOf(const std::string& command);

std::string contentsOf(const std::filesystem::path& file);

/// A scene as a homework gets it: an OBJ file and a camera file.
struct Task {
    std::string obj, camera;
    Scene       scene = {};
    Camera      view  = {};
};

/// The scenes that variants.json names: "blocks", "inside", "close", "soup", "odd", "stars", "grid", "ties".
Task taskNamed(const std::string& name, const std::filesystem::path& folder);

/// A dump without matrices, as the kit writes it: row 0 is whatever was written first.
struct Dump {
    std::uint32_t             width = 0, height = 0;
    std::vector<float>        depth = {};
    std::vector<std::int32_t> ids   = {};
};
Dump readDump(const std::filesystem::path& file);

/// A folder of its own for each test, removed afterwards.
class InAFolder : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }

    std::filesystem::path m_folder;
};

}  // namespace zscope::homework_test
