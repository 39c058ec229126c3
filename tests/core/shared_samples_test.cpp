// Small inputs that people have sent in, in a folder beside the project; its README.md says what is right for each.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/measure/reference.h"
#include "core/measure/reference_colours.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

const std::filesystem::path kSamples = std::filesystem::path(ZSCOPE_SOURCE_DIR).parent_path() / "shared" / "bugs";

class SharedSamples : public testing::Test {
protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(kSamples)) GTEST_SKIP() << "the folder of shared samples is not there";
    }

    static Result<Scene> load(const std::string& name) { return loadScene(kSamples / name); }

    static std::string errorOf(const std::string& name)
    {
        const auto scene = load(name);
        return scene.ok() ? "none" : scene.error().text().substr(kSamples.string().size() + 1);
    }
    /// "line: sentence" of every warning, one per line.
    static std::string warningsOf(const Scene& scene)
    {
        std::string all;
        for (const Warning& w : scene.warnings) all += std::to_string(w.line) + ": " + w.sentence + "\n";
        return all;
    }
    /// Two faces, the left one red and the right one green, and these warnings.
    static void expectRedAndGreen(const std::string& name, const std::string& warnings = {})
    {
        const auto scene = load(name);
        ASSERT_TRUE(scene.ok()) << scene.error().text();
        const Mesh& mesh = *scene->meshes.at(0);
        ASSERT_EQ(mesh.polygonCount(), 2u) << name;
        EXPECT_EQ(mesh.materialOf(PolygonId{0}).diffuse, (Rgb{1, 0, 0})) << name;
        EXPECT_EQ(mesh.materialOf(PolygonId{1}).diffuse, (Rgb{0, 1, 0})) << name;
        EXPECT_EQ(warningsOf(*scene), warnings) << name;
    }
    static void expectFaces(const std::string& name, std::size_t faces, const std::string& warnings = {})
    {
        const auto scene = load(name);
        ASSERT_TRUE(scene.ok()) << scene.error().text();
        EXPECT_EQ(scene->meshes.at(0)->polygonCount(), faces) << name;
        EXPECT_EQ(warningsOf(*scene), warnings) << name;
    }
};

TEST_F(SharedSamples, WithOddNamesAreRedAndGreen)
{
    expectRedAndGreen("m01b_hash_first.obj");
    expectRedAndGreen("m05d_sjis_5c.obj");
    expectRedAndGreen("m20_long_names.obj");
    expectRedAndGreen("m20b_control_names.obj");
}

TEST_F(SharedSamples, WithNumberedGroupsHaveTwo)
{
    expectFaces("m01d_hash_groups.obj", 2);
    const auto scene = load("m01d_hash_groups.obj");
    EXPECT_EQ(scene->meshes.at(0)->groups, (std::vector<std::string>{"default", "Wheel #1", "Wheel #2"}));
}

TEST_F(SharedSamples, WithOddLibraryNamesFindTheLibrary)
{
    expectRedAndGreen("m03_quoted.obj");
    expectRedAndGreen("m03b_quoted_blank.obj");
    expectRedAndGreen("m04_abs_windows.obj",
                      "1: material library: the path 'C:\\Users\\someone\\models\\m04_abs_windows.mtl' is absolute; "
                      "'m04_abs_windows.mtl' beside this file is read instead\n");
    const auto scene = load("m21_case.obj");
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene->warnings.at(0).sentence,
              "material library: 'm21_case.mtl' cannot be opened: No such file or directory; 'm21_Case.MTL' would fit, "
              "but for the case of its letters");
    EXPECT_EQ(scene->meshes.at(0)->materialOf(PolygonId{0}).diffuse, Material{}.diffuse);
}

TEST_F(SharedSamples, WithOddLibrariesAreRead)
{
    expectRedAndGreen("m26_comment_in_mtl.obj");
    expectRedAndGreen("m30_upper_kd.obj");
    expectFaces("m22_tex_black.obj", 2, "3: textures ('map_Kd') are not read; materials have the colour of Kd\n");
}

TEST_F(SharedSamples, WithOddBlanksKeepTheirFaces)
{
    expectFaces("m06_cont_blank.obj", 2);
    expectFaces("m07_ff_vt.obj", 2);
    expectFaces("m41_bom_mid.obj", 2);
}

TEST_F(SharedSamples, WithBadNumbersQuoteThem)
{
    expectFaces("m07b_nbsp.obj", 1,
                "2: vertex 2 has a coordinate '1<U+00A0>-1<U+00A0>0' that is not a number; faces that use it are left "
                "out\n"
                "5: face uses vertex 2, which has no usable coordinates; the face is left out\n");
    const auto scene = load("m16d_ind.obj");
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene->warnings.at(0).sentence,
              "vertex 1 has a coordinate '-1.#IND' that is not a number; faces that use it are left out");
    EXPECT_EQ(scene->warnings.at(1).sentence,
              "vertex 5 has a coordinate '1.#QNAN' that is not a number; faces that use it are left out");
}

TEST_F(SharedSamples, OfBrokenJsonAreToldWithLineAndColumn)
{
    EXPECT_EQ(errorOf("j02_trailing_comma.json"),
              "j02_trailing_comma.json:1: this is not JSON at column 104: no comma may stand before '}'");
    EXPECT_EQ(errorOf("j03_comment.json"), "j03_comment.json:1: this is not JSON at column 1: JSON has no comments");
    EXPECT_EQ(errorOf("j06_single_quotes.json"),
              "j06_single_quotes.json:1: this is not JSON at column 2: a text stands "
              "in double quotes, not in single ones");
    EXPECT_EQ(errorOf("j11_utf16.json"), "j11_utf16.json: the text is UTF-16; save it as UTF-8 or plain ASCII");
}

TEST_F(SharedSamples, WithNothingToSeeSayWhichStatementHidesIt)
{
    expectFaces("m02_tr1.obj", 2,
                "3: material 'a' has opacity 0 (Tr 1.0): its faces are not drawn\n"
                "6: material 'b' has opacity 0 (Tr 1.0): its faces are not drawn\n");
}

/// One cube on the left and its mirror image on the right: both closed, and as bright.
TEST_F(SharedSamples, OfMirroredInstancesAreClosedAndLitAlike)
{
    const auto scene = load("j14_mirrored_cubes.json");
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    ASSERT_EQ(scene->instances.size(), 2u);
    EXPECT_NE(scene->instances[0].toWorld.isMirrored(), scene->instances[1].toWorld.isMirrored());
    ViewRequest request = scene->views.empty() ? ViewRequest{} : scene->views[0].view;
    request.width = 320, request.height = 180;
    const Camera          camera  = makeCamera(request, scene->bounds).value();
    const auto            culled  = referencePicture(*scene, camera, FaceCulling::Back);
    const auto            colours = referenceColours(*scene, camera, FaceCulling::Back, *culled);
    std::array<int, 2>    covered{};
    std::array<double, 2> blue{};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const std::int64_t id = culled->ids.at(x, y);
            if (id < 0) continue;
            const std::size_t which = scene->instanceOf(TriangleId{static_cast<std::uint32_t>(id)}).value;
            ++covered[which];
            blue[which] += colours->at(x, y) & 0xFFu;
        }
    EXPECT_GT(covered[0], 1000);
    EXPECT_NEAR(covered[0], covered[1], 0.01 * covered[0]);
    EXPECT_NEAR(blue[0] / covered[0], blue[1] / covered[1], 20) << "lit from behind it would be half as bright";
}

TEST_F(SharedSamples, ThatNameTheirMeshAsWindowsDoesAreRead)
{
    expectFaces("F09.Obj", 1);
    expectFaces("j09_upper_obj.json", 1);
    expectFaces("j10_backslash.json", 1);
}

}  // namespace
}  // namespace zscope
