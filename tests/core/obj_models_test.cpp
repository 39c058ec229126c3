#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "core/scene/obj/obj_import.h"
#include "tests/core/obj_support.h"

namespace zscope {
namespace {

const std::filesystem::path kModels = std::filesystem::path(ZSCOPE_SOURCE_DIR).parent_path() / "shared" / "models";

/// What the table beside the models says of each.
struct Row {
    const char*   file;
    std::uint64_t vertices, faces, triangles, threeCorners, fourCorners, more, groups, objects, materials;
};
constexpr Row kRows[] = {
    {"stanford-bunny.obj", 35947, 69451, 69451, 69451, 0, 0, 0, 0, 0},
    {"utah-teapot.obj", 3644, 6320, 6320, 6320, 0, 0, 0, 0, 0},
    {"soccerball.obj", 1760, 1992, 3516, 480, 1500, 12, 3, 0, 2},
    {"spot_control_mesh.obj", 188, 180, 372, 4, 160, 16, 0, 0, 0},
    {"sword-quad-dominant.obj", 22293, 22465, 44582, 348, 22117, 0, 0, 0, 0},
    {"wingnut.obj", 3047, 6090, 6090, 6090, 0, 0, 0, 0, 0},
    {"mountain.obj", 25600, 50562, 50562, 50562, 0, 0, 0, 0, 0},
    {"crytek-sponza.obj", 145050, 262267, 262267, 262267, 0, 0, 0, 0, 0},
    {"city.obj", 187240, 174093, 350726, 6088, 166981, 1024, 1498, 325, 7},
};

TEST(SharedModels, HaveTheCountsOfTheirTable)
{
    if (!std::filesystem::exists(kModels)) GTEST_SKIP() << "the folder of shared models is not there";
    for (const Row& row : kRows) {
        const auto import = importObj(kModels / row.file);
        ASSERT_TRUE(import.ok()) << import.error().text();
        const ObjCounts& counts = import->counts;
        EXPECT_EQ(import->mesh->positions.size(), row.vertices) << row.file;
        EXPECT_EQ(counts.faces, row.faces) << row.file;
        EXPECT_EQ(import->mesh->polygonCount(), row.faces) << row.file;
        EXPECT_EQ(import->mesh->triangles.size(), row.triangles) << row.file;
        EXPECT_EQ(counts.triangles, row.threeCorners) << row.file;
        EXPECT_EQ(counts.quads, row.fourCorners) << row.file;
        EXPECT_EQ(counts.largerFaces, row.more) << row.file;
        EXPECT_EQ(counts.groupNames, row.groups) << row.file;
        EXPECT_EQ(counts.objectNames, row.objects) << row.file;
        EXPECT_EQ(counts.materialNames, row.materials) << row.file;
        EXPECT_EQ(counts.droppedFaces, 0u) << row.file;
    }
}

TEST(SharedModels, KeepTheColoursOfTheirLibrary)
{
    if (!std::filesystem::exists(kModels)) GTEST_SKIP() << "the folder of shared models is not there";
    const auto import = importObj(kModels / "city.obj");
    ASSERT_TRUE(import.ok());
    EXPECT_TRUE(import->warnings.empty());
    bool seen = false;
    for (const Material& material : import->mesh->materials) {
        if (material.name != "brick") continue;
        seen = true;
        EXPECT_EQ(material.diffuse, (Rgb{0.62f, 0.3f, 0.22f}));
    }
    EXPECT_TRUE(seen);
}

TEST(ObjSpeed, SevenHundredThousandTrianglesAreReadInOnePass)
{
    // A loose bound that no sanitizer or busy machine breaks; what is quadratic breaks it.
    constexpr int kSide = 600;
    std::string   text;
    for (int y = 0; y <= kSide; ++y)
        for (int x = 0; x <= kSide; ++x)
            fmt::format_to(std::back_inserter(text), "v {:.6f} {:.6f} {:.6f}\n", x * 0.01, y * 0.01,
                           std::sin(x * y * 1e-3));
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const int v = y * (kSide + 1) + x + 1;
            fmt::format_to(std::back_inserter(text), "f {} {} {}\nf {} {} {}\n", v, v + 1, v + kSide + 2, v,
                           v + kSide + 2, v + kSide + 1);
        }
    const auto start  = std::chrono::steady_clock::now();
    const auto import = test::read(text);
    const auto time   = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->triangles.size(), 2u * kSide * kSide);
    EXPECT_LT(time, 120);
    std::printf("%zu triangles, %zu bytes: %.3f s\n", import->mesh->triangles.size(), text.size(), time);
}

}  // namespace
}  // namespace zscope
