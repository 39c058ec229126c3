// What scene files and the readers under them promise: every part of the format, sentences with file and line for what
// is wrong, limits before anything is allocated, and nothing opened outside the file's folder.
#include "core/scene/scene_file.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/io/read_file.h"

namespace zscope {
namespace {

namespace fs = std::filesystem;

class SceneFile : public testing::Test {
protected:
    void SetUp() override
    {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        root                   = fs::temp_directory_path() / ("zscope-" + std::to_string(::getpid()) + "-" + name);
        fs::create_directories(root / "scene" / "models");
        write("scene/models/flag.obj",
              "mtllib flag.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl cloth\nf 1 2 3 4\n");
        write("scene/models/flag.mtl", "newmtl cloth\nKd 1 0 0\n");
        write("outside.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    }
    void TearDown() override { fs::remove_all(root); }

    void write(const std::string& path, const std::string& text) const
    {
        std::ofstream(root / path, std::ios::binary) << text;
    }
    std::string   path(const std::string& name = "scene/s.json") const { return (root / name).string(); }
    Result<Scene> load(const std::string& text, std::uint64_t memory = 0) const
    {
        write("scene/s.json", text);
        return loadScene(path(), {.memoryLimit = memory});
    }
    /// Loads a scene that must be refused.
    Error refused(const std::string& text, std::uint64_t memory = 0) const
    {
        const auto scene = load(text, memory);
        EXPECT_FALSE(scene.ok()) << text;
        return scene.ok() ? Error{} : scene.error();
    }
    static std::string cubes(const std::string& instances, const std::string& rest = "")
    {
        return "{\"meshes\": {\"c\": {\"builtin\": \"cube\"}},\n\"instances\": [" + instances + "]" + rest + "}";
    }

    fs::path root;
};

bool says(const Error& error, const std::string& words) { return error.sentence.find(words) != std::string::npos; }

TEST_F(SceneFile, ACutOutBelongsToTheMaterialOfAMesh)
{
    const auto flag = [](const std::string& cutout, const std::string& instance = "{\"mesh\": \"f\"}") {
        return "{\"materials\": {\"cloth\": {\"colour\": [1, 0, 0], \"cutout\": " + cutout
               + "}},\n\"meshes\": {\"f\": {\"obj\": \"models/flag.obj\"}},\n\"instances\": [" + instance + "]}";
    };
    const auto scene = load(flag("{\"pattern\": \"holes\", \"size\": 0.25}"));
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    const Mesh& mesh = *scene->meshes[0];
    EXPECT_TRUE(mesh.isPatterned(0));
    EXPECT_EQ(mesh.materialOf(PolygonId{0}).cutout, (Cutout{CutoutPattern::Holes, 0.25}));
    EXPECT_NE(scene->digest, load(flag("{\"pattern\": \"holes\", \"size\": 0.5}"))->digest);

    EXPECT_TRUE(says(refused(flag("{\"pattern\": \"lace\", \"size\": 1}")), "choose one of checker, stripes, holes"));
    EXPECT_TRUE(says(refused(flag("{\"pattern\": \"holes\", \"size\": 0}")), "more than 0"));
    EXPECT_TRUE(says(refused(flag("{\"pattern\": \"holes\"}")), "a cut-out needs a 'size'"));
    EXPECT_TRUE(
        says(refused(flag("{\"pattern\": \"holes\", \"size\": 1}", "{\"mesh\": \"f\", \"material\": \"cloth\"}")),
             "its mesh's"));
}

TEST_F(SceneFile, AReliefBelongsToTheMaterialOfAMesh)
{
    const auto flag = [](const std::string& relief, const std::string& instance = "{\"mesh\": \"f\"}") {
        return "{\"materials\": {\"cloth\": {\"colour\": [1, 0, 0], \"relief\": " + relief
               + "}},\n\"meshes\": {\"f\": {\"obj\": \"models/flag.obj\"}},\n\"instances\": [" + instance + "]}";
    };
    const auto scene = load(flag(R"({"pattern": "bowls", "size": 0.25, "depth": "0x1p-3"})"));
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    const Mesh& mesh = *scene->meshes[0];
    EXPECT_TRUE(mesh.isPatterned(0));
    EXPECT_EQ(mesh.materialOf(PolygonId{0}).relief, (Relief{ReliefPattern::Bowls, 0.25, 0.125}));
    EXPECT_FALSE(mesh.materialOf(PolygonId{0}).cutout.has_value());
    EXPECT_NE(scene->digest, load(flag(R"({"pattern": "bowls", "size": 0.25, "depth": 0.25})"))->digest);
    EXPECT_TRUE(
        says(refused(flag(R"({"pattern": "bowls", "size": 1, "depth": 1})", R"({"mesh": "f", "material": "cloth"})")),
             "its mesh's"));
}

/// Every value of a material in turn becomes something that it cannot be.
TEST_F(SceneFile, WhatIsWrongWithAMaterialIsSaidWithItsLine)
{
    const std::vector<std::string> noLength{"null",    "true",       "\"\"",  "\"x\"", "[]",     "{}",
                                            "[1]",     "{\"a\": 1}", "0",     "-1",    "\"-1\"", "\"nan\"",
                                            "\"inf\"", "\"-inf\"",   "1e999", "-0.0",  "\"1 \"", "\"0x\""};
    const std::vector<std::string> noShare{"null",   "true", "\"\"",    "\"x\"",   "[]",   "{}",
                                           "1.0001", "-1",   "\"nan\"", "\"inf\"", "1e999"};
    const std::vector<std::string> noPattern{"null",      "true", "1",  "\"\"",       "\"x\"",
                                             "\"Holes\"", "[]",   "{}", "[\"holes\"]"};
    const std::vector<std::string> noObject{"null",
                                            "true",
                                            "1",
                                            "\"holes\"",
                                            "[]",
                                            "{}",
                                            "{\"pattern\": \"holes\", \"size\": 1, \"depth\": 1, \"more\": 1}"};
    struct Place {
        std::string                     key, whole;
        const std::vector<std::string>* junk;
    };
    const std::vector<Place> places{
        {"opacity", R"("opacity": $)", &noShare},
        {"cutout", R"("cutout": $)", &noObject},
        {"relief", R"("relief": $)", &noObject},
        {"a cut-out's pattern", R"("cutout": {"size": 1, "pattern": $})", &noPattern},
        {"a cut-out's size", R"("cutout": {"pattern": "holes", "size": $})", &noLength},
        {"a relief's pattern", R"("relief": {"size": 1, "depth": 1, "pattern": $})", &noPattern},
        {"a relief's size", R"("relief": {"pattern": "bowls", "depth": 1, "size": $})", &noLength},
        {"a relief's depth", R"("relief": {"pattern": "bowls", "size": 1, "depth": $})", &noLength},
    };
    for (const Place& place : places)
        for (const std::string& junk : *place.junk) {
            std::string member = place.whole;
            member.replace(member.find('$'), 1, junk);
            const Error error = refused(
                "{\n\"materials\": {\"cloth\": {\n\"colour\": [1, 0, 0],\n" + member
                + "}},\n\"meshes\": {\"f\": {\"obj\": \"models/flag.obj\"}},\n\"instances\": [{\"mesh\": \"f\"}]}");
            EXPECT_EQ(error.kind, Trouble::Input) << place.key << ' ' << junk;
            EXPECT_EQ(error.line, 4) << place.key << ' ' << junk << ": " << error.text();
            EXPECT_EQ(error.file, path()) << place.key << ' ' << junk;
            EXPECT_FALSE(error.sentence.empty());
        }
}

TEST_F(SceneFile, EveryPartOfTheFormatIsRead)
{
    const auto scene = load(R"({
      "meshes": {"flag": {"obj": "models/flag.obj"}, "pot": {"builtin": "teapot?tessellation=2"}},
      "instances": [
        {"mesh": "flag", "matrix": [1, 0, 0, 2,  0, 1, 0, "0x1.8p+1",  0, 0, 1, 4]},
        {"mesh": "pot", "grid": {"count": [2, 1, 3], "step": [10, 20, 30]}, "material": "blue"},
        {"mesh": "flag", "random": {"count": 5, "seed": 9, "min": [0, 0, 0], "max": [1, 2, 3], "rotate": true},
            "colour": [0, 0.5, 1]},
        {"mesh": "flag"}],
      "materials": {"blue": {"colour": [0, 0, 1]}, "cloth": {"colour": [0, 1, 0], "opacity": 0.5}},
      "light": {"direction": [0, -1, 0]},
      "cameras": {
        "a": {"size": [640, 480], "eye": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 30, "near": 0.5,
            "far": "inf", "cull": "back"},
        "b": {"eye": [0,0,9], "right": [1,0,0], "up": [0,1,0], "forward": [0,0,-1], "focal": 2, "near": 1, "far": 99,
            "width": 32, "height": 16},
        "c": {"size": "300x200"}}})");
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    ASSERT_EQ(scene->meshes.size(), 2u);
    ASSERT_EQ(scene->instances.size(), 1u + 6 + 5 + 1);
    EXPECT_EQ(scene->instances[0].toWorld, Affine::translation({2, 3, 4}));
    for (unsigned i = 0; i < 6; ++i) {  // x fastest, then y, then z
        EXPECT_EQ(scene->instances[1 + i].toWorld, Affine::translation({10.0 * (i % 2), 0, 30.0 * (i / 2)}));
        EXPECT_EQ(scene->instances[1 + i].colour, (Rgb{0, 0, 1}));
    }
    for (std::size_t i = 7; i < 12; ++i) {
        const auto& rows = scene->instances[i].toWorld.rows;
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_GE(rows[k][3], 0);
            EXPECT_LE(rows[k][3], static_cast<double>(k + 1));
        }
        EXPECT_NE(rows[0][0], 1);
    }
    EXPECT_TRUE(scene->instances[12].toWorld.isIdentity());
    EXPECT_EQ(scene->meshes[0]->materialOf(PolygonId{0}).diffuse, (Rgb{0, 1, 0}));
    EXPECT_EQ(scene->meshes[0]->materialOf(PolygonId{0}).opacity, 0.5f);
    EXPECT_EQ(scene->light.direction, (dvec3{0, -1, 0}));
    ASSERT_EQ(scene->views.size(), 3u);
    EXPECT_EQ(scene->views[0].name, "a");
    EXPECT_EQ(scene->views[0].view.width, 640);
    EXPECT_EQ(scene->views[0].view.verticalFov, 30);
    EXPECT_TRUE(std::isinf(*scene->views[0].view.far));
    EXPECT_EQ(scene->views[0].view.faceCulling, FaceCulling::Back);
    ASSERT_TRUE(scene->views[1].view.exact.has_value());
    EXPECT_EQ(scene->views[1].view.exact->focal, 2);
    EXPECT_EQ(scene->views[2].view.height, 200);
    EXPECT_TRUE(scene->warnings.empty());
}

TEST_F(SceneFile, MeshOfManyInstancesIsHeldOnce)
{
    const auto scene = load(cubes(R"({"mesh": "c", "grid": {"count": [100, 100, 10], "step": [3, 3, 3]}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(scene->meshes.size(), 1u);
    EXPECT_EQ(scene->triangleCount(), 1'200'000u);
}

TEST_F(SceneFile, RandomInstancesDependOnTheSeedOnlyAndRotationsAreRotations)
{
    const auto group = [](int seed) {
        return cubes(R"({"mesh": "c", "random": {"count": 200, "seed": )" + std::to_string(seed)
                     + R"(, "min": [-1, -1, -1], "max": [1, 1, 1], "rotate": true}})");
    };
    const auto one = load(group(1)), again = load(group(1)), two = load(group(2));
    ASSERT_TRUE(one.ok() && again.ok() && two.ok());
    EXPECT_EQ(one->digest, again->digest);
    EXPECT_NE(one->digest, two->digest);
    for (const Instance& instance : one->instances) {
        const auto& m = instance.toWorld.rows;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                EXPECT_NEAR(m[i][0] * m[j][0] + m[i][1] * m[j][1] + m[i][2] * m[j][2], i == j ? 1 : 0, 1e-12);
        EXPECT_GT(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                      + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]),
                  0.99);
    }
}

TEST_F(SceneFile, CountsBeyondMemoryAreRefusedAtOnce)
{
    const auto  before = std::chrono::steady_clock::now();
    const Error huge =
        refused(cubes(R"({"mesh": "c", "grid": {"count": [100000, 100000, 100000], "step": [1, 1, 1]}})"));
    EXPECT_EQ(huge.kind, Trouble::Limit);
    EXPECT_EQ(huge.line, 2);
    const Error random =
        refused(cubes(R"({"mesh": "c", "random": {"count": 9007199254740992, "min": [0,0,0], "max": [1,1,1]}})"));
    EXPECT_EQ(random.kind, Trouble::Limit);
    const Error small =
        refused(cubes(R"({"mesh": "c", "grid": {"count": [100, 100, 100], "step": [1, 1, 1]}})"), 32 << 20);
    EXPECT_EQ(small.kind, Trouble::Limit);
    EXPECT_TRUE(says(small, "memory limit is 32 MiB")) << small.text();
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(2));
}

TEST_F(SceneFile, WhatIsWrongIsToldWithFileAndLine)
{
    struct Case {
        std::string text;
        int         line;
        const char* words;
    };
    const std::vector<Case> cases{
        {"", 1, "not JSON"},
        {"{\n\n  \"meshes\": }", 3, "not JSON"},
        {"[]", 1, "object"},
        {"{\"meshes\": {\"c\": {\"builtin\": \"cube\"}}}", 1, "no 'instances'"},
        {"{\"instances\": []}", 1, "no 'meshes'"},
        {"{\"meshes\": {},\n\"instances\": []}", 1, "meshes by name"},
        {"{\"meshes\":\n{\"c\": {}}, \"instances\": []}", 2, "either 'obj' or 'builtin'"},
        {"{\"meshes\":\n{\"c\": {\"builtin\": \"cube\", \"obj\": \"a.obj\"}}, \"instances\": []}", 2, "either"},
        {"{\"meshes\":\n{\"c\": {\"builtin\": 3}}, \"instances\": []}", 2, "must be a text"},
        {"{\"meshes\":\n{\"c\": {\"builtin\": \"cubs\"}}, \"instances\": []}", 2, "did you mean"},
        {"{\"meshes\":\n{\"c\": {\"builtin\": \"teapot?tessellation=0\"}}, \"instances\": []}", 2, "from 1 to"},
        {"{\"meshes\":\n{\"c\": {\"builtin\": \"cubes\"}}, \"instances\": []}", 2, "not one mesh"},
        {"{\"meshes\":\n{\"c\": {\"obj\": \"s.json\"}}, \"instances\": []}", 2, ".obj"},
        {cubes("{\"mesh\": \"c\"}", ",\n\"camera\": {}"), 3, "no 'camera'"},
        {cubes("{\"mesh\": \"d\"}"), 2, "no mesh 'd'"},
        {cubes("{}"), 2, "needs the name"},
        {cubes("{\"mesh\": \"c\", \"at\": 1}"), 2, "no 'at'"},
        {cubes("{\"mesh\": \"c\",\n\"matrix\": [1,2,3]}"), 3, "twelve"},
        {cubes("{\"mesh\": \"c\",\n\"matrix\": [1,0,0,0,0,1,0,0,0,0,1,\n\"inf\"]}"), 4, "finite"},
        {cubes("{\"mesh\": \"c\",\n\"matrix\": [1,0,0,0,0,1,0,0,0,0,1,\n\"nan\"]}"), 4, "not a number"},
        {cubes("{\"mesh\": \"c\",\n\"matrix\": [1,0,0,0,0,1,0,0,0,0,1,\n1e999]}"), 4, "largest"},
        {cubes("{\"mesh\": \"c\", \"grid\": {\"count\": [1,1,1], \"step\": [1,1,1]}, \"random\": {}}"), 2, "one of"},
        {cubes("{\"mesh\": \"c\", \"grid\": {\"count\": [1,0,1], \"step\": [1,1,1]}}"), 2, "whole number"},
        {cubes("{\"mesh\": \"c\", \"grid\": {\"count\": [1,1.5,1], \"step\": [1,1,1]}}"), 2, "whole number"},
        {cubes("{\"mesh\": \"c\", \"grid\": {\"count\": [1,1,1]}}"), 2, "'step'"},
        {cubes("{\"mesh\": \"c\", \"random\": {\"count\": -1, \"min\": [0,0,0], \"max\": [1,1,1]}}"), 2,
         "whole number"},
        {cubes("{\"mesh\": \"c\", \"random\": {\"count\": 1, \"min\": [2,0,0], \"max\": [1,1,1]}}"), 2, "above 'max'"},
        {cubes("{\"mesh\": \"c\", \"random\": {\"count\": 1, \"min\": [0,0,0], \"max\": [1,1,1], \"rotate\": 1}}"), 2,
         "true or false"},
        {cubes("{\"mesh\": \"c\", \"material\": \"gold\"}"), 2, "no material 'gold'"},
        {cubes("{\"mesh\": \"c\", \"colour\": [2, 0, 0]}"), 2, "from 0 to 1"},
        {cubes("", ",\n\"materials\": {\"m\": {\"opacity\": 1}}"), 3, "needs a 'colour'"},
        {cubes("", ",\n\"light\": {\"direction\": [0, 0, 0]}"), 3, "direction"},
        {cubes("", ",\n\"cameras\": {\"a\": {\"zoom\": 1}}"), 3, "no 'zoom'"},
        {cubes("", ",\n\"cameras\": {\"a\": {\"eye\": [0,0,1], \"target\": [0,0,1]}}"), 3, "same point"},
        {cubes("", ",\n\"cameras\": {\"a\": {\"size\": [0, 10]}}"), 3, "size"},
        {cubes("", ",\n\"cameras\": {\"a\": {\"size\": \"10*10\"}}"), 3, "size"},
        {cubes("", ",\n\"cameras\": {\"a\": {\"cull\": \"front\"}}"), 3, "cull"},
        {cubes("", ",\n\"light\": {\"direction\": [0,1,0]},\n\"light\": {\"direction\": [0,1,0]}"), 4, "twice"},
    };
    for (const Case& c : cases) {
        const Error error = refused(c.text);
        EXPECT_EQ(error.kind, Trouble::Input) << c.text;
        EXPECT_EQ(error.file, path()) << c.text << ": " << error.text();
        EXPECT_EQ(error.line, c.line) << c.text << ": " << error.text();
        EXPECT_TRUE(says(error, c.words)) << c.text << ": " << error.text();
    }
}

TEST_F(SceneFile, NothingOutsideTheFolderIsOpened)
{
    const auto mesh = [](const std::string& obj) {
        return "{\"meshes\": {\"m\": {\"obj\": \"" + obj + "\"}}, \"instances\": [{\"mesh\": \"m\"}]}";
    };
    ASSERT_TRUE(load(mesh("models/../models/flag.obj")).ok());
    EXPECT_TRUE(says(refused(mesh("../outside.obj")), "leads out"));
    EXPECT_TRUE(says(refused(mesh("models/../../outside.obj")), "leads out"));
    EXPECT_TRUE(says(refused(mesh(path("outside.obj"))), "absolute"));
    fs::create_symlink("../outside.obj", root / "scene" / "link.obj");
    EXPECT_TRUE(says(refused(mesh("link.obj")), "leads out"));
    fs::create_directory_symlink("..", root / "scene" / "up");
    EXPECT_TRUE(says(refused(mesh("up/outside.obj")), "leads out"));
    fs::create_symlink("models/flag.obj", root / "scene" / "inner.obj");
    EXPECT_TRUE(load(mesh("inner.obj")).ok());
    EXPECT_TRUE(says(refused(mesh("models/none.obj")), "cannot be opened"));
    fs::create_symlink("loop.obj", root / "scene" / "loop.obj");
    EXPECT_FALSE(load(mesh("loop.obj")).ok());
    EXPECT_FALSE(load(mesh("flag.obj\\u0000")).ok());
    fs::create_directories(root / "scene-two");  // a name that only begins alike is another folder
    write("scene-two/a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    EXPECT_TRUE(says(refused(mesh("../scene-two/a.obj")), "leads out"));
}

TEST_F(SceneFile, OnlyRegularFilesAreRead)
{
    fs::create_directory(root / "folder.json");
    EXPECT_TRUE(says(loadScene(path("folder.json")).error(), "directory"));
    ASSERT_EQ(::mkfifo(path("pipe.json").c_str(), 0600), 0);
    EXPECT_TRUE(says(loadScene(path("pipe.json")).error(), "FIFO"));  // and does not wait for a writer
    fs::create_symlink("/dev/zero", root / "zero.json");
    EXPECT_TRUE(says(loadScene(path("zero.json")).error(), "device"));
    EXPECT_TRUE(says(loadScene(path("none.json")).error(), "cannot be opened"));
    EXPECT_EQ(loadScene(path("none.json")).error().kind, Trouble::Input);
    ASSERT_EQ(::mkfifo((root / "scene" / "pipe.obj").c_str(), 0600), 0);
    EXPECT_FALSE(load("{\"meshes\": {\"m\": {\"obj\": \"pipe.obj\"}}, \"instances\": [{\"mesh\": \"m\"}]}").ok());
}

TEST_F(SceneFile, FilesBeyondTheLimitAreRefusedBeforeTheyAreRead)
{
    write("large.json", "{}");
    fs::resize_file(root / "large.json", kMaxSceneFileBytes + 1);  // sparse
    EXPECT_EQ(loadScene(path("large.json")).error().kind, Trouble::Limit);
    EXPECT_EQ(readRegularFile(path("outside.obj"), 3).error().kind, Trouble::Limit);
    std::string many = "{\"meshes\": [";
    for (int i = 0; i < 500'000; ++i) many += "1,";
    many += "1]}";
    EXPECT_EQ(refused(many, 8 << 20).kind, Trouble::Limit);
    EXPECT_TRUE(says(refused("{\"meshes\": " + std::string(100'000, '[')), "deeper"));
}

TEST_F(SceneFile, UnusedMaterialIsAWarning)
{
    const auto scene = load(cubes("{\"mesh\": \"c\"}", ",\n\"materials\": {\"m\": {\"colour\": [0, 0, 0]}}"));
    ASSERT_TRUE(scene.ok());
    ASSERT_EQ(scene->warnings.size(), 1u);
    EXPECT_EQ(scene->warnings[0].line, 3);
}

TEST_F(SceneFile, TroubleInsideAnObjIsToldWhereItIs)
{
    write("scene/models/bad.obj", "v 0 0 0\nf 1 2 3\n");
    const Error error = refused("{\"meshes\": {\"m\": {\"obj\": \"models/bad.obj\"}}, \"instances\": []}");
    EXPECT_NE(error.file.find("bad.obj"), std::string::npos) << error.text();
}

TEST_F(SceneFile, WordsThatAreNoSceneAreAUsageError)
{
    for (const char* word : {"", "scene", "a.stl", "builtin", "builtin:", "builtin:?", "builtin:nothing"})
        EXPECT_EQ(loadScene(word).error().kind, Trouble::Usage) << word;
}

TEST(Assets, EveryBundledSceneLoadsWithoutWarningAndHasAView)
{
    int scenes = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(ZSCOPE_SOURCE_DIR) / "assets")) {
        if (entry.path().extension() != ".json") continue;
        ++scenes;
        const auto scene = loadScene(entry.path().string());
        ASSERT_TRUE(scene.ok()) << scene.error().text();
        EXPECT_TRUE(scene->warnings.empty()) << scene->warnings.front().sentence;
        ASSERT_FALSE(scene->views.empty());
        EXPECT_GT(scene->triangleCount(), 1000u);
    }
    EXPECT_GE(scenes, 3);
}

}  // namespace
}  // namespace zscope
