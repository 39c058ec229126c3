// Algorithms side by side from the command line: exit statuses, the sheet's pixels and its words.
#include <algorithm>
#include <cstdlib>
#include <set>

#include <png.h>

#include "core/frame/pipeline.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

std::vector<std::string> comparing(const std::string& scene, const std::string& algorithms,
                                   const std::vector<std::string>& more)
{
    std::vector<std::string> arguments{"compare",      scene,      "--size",   "97x61",
                                       "--algorithms", algorithms, "--frames", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

struct Sheet {
    unsigned              width = 0, height = 0;
    std::vector<unsigned> pixels;
};

Sheet sheetOf(const std::string& file)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&image, file.c_str())) << image.message;
    image.format = PNG_FORMAT_RGBA;
    Sheet sheet{image.width, image.height, std::vector<unsigned>(static_cast<std::size_t>(image.width) * image.height)};
    EXPECT_TRUE(png_image_finish_read(&image, nullptr, sheet.pixels.data(), 0, nullptr)) << image.message;
    return sheet;
}

TEST_F(Cli, CompareFindsThatEveryPresetDrawsTheSamePicture)
{
    const Answer answer = run(comparing("builtin:cubes", "all", {"--require-equal"}));
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    for (const Preset& preset : presets())
        EXPECT_EQ(answer.out.find(std::string(preset.name) + ' ') != std::string::npos, hasFastText(preset.pipeline))
            << preset.name;
    EXPECT_EQ(answer.out.find("DIFFERS"), std::string::npos) << answer.out;
}

TEST_F(Cli, CompareWritesASheetWithAColumnPerAlgorithmAndTheCommandInside)
{
    ASSERT_EQ(run(comparing("builtin:cubes", "zbuffer,scanline", {"-o", path("two.png")})).status, 0);
    ASSERT_EQ(run(comparing("builtin:cubes", "zbuffer,scanline,hzb-octree", {"-o", path("three.png")})).status, 0);
    const Sheet two = sheetOf(path("two.png")), three = sheetOf(path("three.png"));
    EXPECT_GT(three.width, two.width);
    EXPECT_GT(std::set<unsigned>(two.pixels.begin(), two.pixels.end()).size(), 20u) << "pictures, bars and letters";
    const std::string bytes = contentsOf(path("two.png"));
    EXPECT_NE(bytes.find("zscope-cli compare builtin:cubes"), std::string::npos);
    EXPECT_NE(bytes.find("--algorithms zbuffer,scanline"), std::string::npos);
}

TEST_F(Cli, ASheetWhoseNameEndsInPdfIsAPageWithTextAndPictures)
{
    const Answer answer = run(comparing("builtin:cubes", "zbuffer,scanline", {"-o", path("sheet.pdf")}));
    if (answer.status == 2 && answer.err.find("writes no PDF") != std::string::npos) GTEST_SKIP() << answer.err;
    ASSERT_EQ(answer.status, 0) << answer.err;
    const std::string bytes = contentsOf(path("sheet.pdf"));
    EXPECT_TRUE(bytes.starts_with("%PDF-"));
    EXPECT_NE(bytes.find("%%EOF"), std::string::npos);
    std::size_t pictures = 0;
    for (std::size_t at = bytes.find("/Subtype /Image"); at != std::string::npos;
         at             = bytes.find("/Subtype /Image", at + 1))
        ++pictures;
    EXPECT_EQ(pictures, 3u) << "two pictures and a difference";
    if (std::system("command -v pdftotext > /dev/null 2>&1") != 0) return;
    ASSERT_EQ(std::system(("pdftotext -layout '" + path("sheet.pdf") + "' '" + path("sheet.txt") + "'").c_str()), 0);
    const std::string text = contentsOf(path("sheet.txt"));
    for (const char* word :
         {"zbuffer", "scanline", "Reference: same to the bit", "raster", "zscope-cli compare builtin:cubes"})
        EXPECT_NE(text.find(word), std::string::npos) << word << '\n' << text;
}

TEST_F(Cli, CompareRefusesToCallDifferentPicturesEqual)
{
    // Panes that cross: blended in another order they have other colours, though ids and depths agree.
    const std::string scene = "builtin:glass";
    ASSERT_EQ(run(comparing(scene, "zbuffer,scanline", {"--require-equal"})).status, 0);
    ASSERT_EQ(run({"render", scene, "--size", "97x61", "-o", path("whole.png")}).status, 0);
    const Answer answer = run(
        comparing(scene, "zbuffer,zbuffer+transparency=back-then-front", {"--require-equal", "-o", path("sheet.png")}));
    EXPECT_EQ(answer.status, 1) << answer.out << answer.err;
    EXPECT_NE(answer.out.find("DIFFERS"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(path("sheet.png"))) << "the sheet is what shows how they differ";
}

TEST_F(Cli, CompareThatFindsADifferenceIsNoFailureUnlessEqualityIsRequired)
{
    const Answer answer =
        run(comparing("builtin:cubes", "edge-walk,edge-walk+fault=x-truncated", {"-o", path("sheet.png")}));
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_NE(answer.out.find("DIFFERS"), std::string::npos);
    const Sheet sheet = sheetOf(path("sheet.png"));
    EXPECT_GT(std::ranges::count(sheet.pixels, 0xFF005ED5u), 3) << "other triangles, in the colour for it";
}

}  // namespace
}  // namespace zscope::cli_test
