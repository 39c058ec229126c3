// The homework kit: with its gaps it builds and draws nothing; with them filled it draws ZScope's picture to the bit;
// and each variant of the solution errs as variants.json says.
#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/check/check.h"
#include "core/measure/reference.h"
#include "tests/homework/homework_support.h"

namespace zscope::homework_test {
namespace {

namespace fs = std::filesystem;

const std::string kKit      = ZSCOPE_SOURCE_DIR "/assets/homework";
const std::string kTests    = ZSCOPE_SOURCE_DIR "/tests/homework";
const std::string kSolution = kTests + "/solution";

class Kit : public InAFolder {
protected:
    /// Runs a program on the task; what it wrote, and what it said in `said`.
    Dump draw(const std::string& program, const Task& task, const std::string& method)
    {
        const std::string out = path("out");
        fs::remove_all(out);
        fs::create_directory(out);
        EXPECT_EQ(statusOf(fmt::format("'{}' '{}' '{}' '{}' {} 2>'{}'", program, task.obj, task.camera, out, method,
                                       path("said"))),
                  0);
        m_said = contentsOf(path("said"));
        return readDump(out + "/out.zdump");
    }

    std::string m_said;
};

Dump dumpOf(const Picture& picture, const Camera& camera)
{
    Dump dump{.width = static_cast<std::uint32_t>(camera.width), .height = static_cast<std::uint32_t>(camera.height)};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            dump.depth.push_back(picture.depth.at(x, y));
            dump.ids.push_back(static_cast<std::int32_t>(picture.ids.at(x, y)));
        }
    return dump;
}

std::size_t differences(const Dump& a, const Dump& b)
{
    if (a.ids.size() != b.ids.size()) return std::max(a.ids.size(), b.ids.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.ids.size(); ++i) count += a.ids[i] != b.ids[i] || a.depth[i] != b.depth[i] ? 1 : 0;
    return count;
}

/// As a student builds it: the kit's own CMake file, warnings are errors.
TEST_F(Kit, BuildsWithItsGapsAndSaysWhichAreEmpty)
{
    ASSERT_EQ(statusOf(fmt::format("cmake -S '{}' -B '{}' -DCMAKE_CXX_FLAGS=-Werror >'{}' && cmake --build '{}' >>'{}'",
                                   kKit, path("build"), path("log"), path("build"), path("log"))),
              0)
        << contentsOf(path("log"));
    const Task task = taskNamed("blocks", m_folder);
    for (const auto& [method, gap] :
         std::map<std::string, std::string>{{"zbuffer", "zbuffer.cpp: drawTriangle() is still empty\n"},
                                            {"scanline", "scanline.cpp: makeEdgeTable() is still empty\n"},
                                            {"hierarchical", "hierarchical.cpp: isHidden() is still empty\n"}}) {
        const Dump dump = draw(path("build/homework"), task, method);
        ASSERT_EQ(dump.ids.size(), 160u * 120);
        EXPECT_TRUE(std::ranges::all_of(dump.ids, [](int id) { return id == -1; })) << method;
        EXPECT_NE(m_said.find(gap), std::string::npos) << m_said;
        const std::string picture = contentsOf(path("out/picture.ppm"));
        EXPECT_EQ(picture.substr(0, 15), "P6\n160 120\n255\n");
        EXPECT_EQ(picture.size(), 15u + 3 * 160 * 120);
    }
    EXPECT_NE(statusOf(fmt::format("'{}' '{}' '{}' '{}' 2>'{}'", path("build/homework"), task.obj, task.camera,
                                   path("nowhere"), path("said"))),
              0);
    EXPECT_NE(contentsOf(path("said")).find("nowhere/out.zdump: cannot be written: does the folder exist?"),
              std::string::npos)
        << contentsOf(path("said"));
}

/// As a student builds it without CMake: one line.
TEST_F(Kit, TheSolutionDrawsZScopesPictureToTheBit)
{
    fs::create_directory(path("source"));
    for (const std::string& folder : {kKit, kSolution})
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
                fs::copy_file(entry.path(), fs::path(path("source")) / entry.path().filename(),
                              fs::copy_options::overwrite_existing);
    ASSERT_EQ(statusOf(fmt::format(
                  "cd '{}' && c++ -std=c++17 -O1 -Wall -Wextra -Wpedantic -Werror -ffp-contract=off *.cpp -o "
                  "homework",
                  path("source"))),
              0);
    for (const char* name : {"blocks", "inside", "close", "soup", "odd", "grid"}) {
        const Task task      = taskNamed(name, m_folder);
        const auto reference = referencePicture(task.scene, task.view, FaceCulling::None);
        const auto culled    = referencePicture(task.scene, task.view, FaceCulling::Back);
        ASSERT_TRUE(reference && culled);
        const Dump truth = dumpOf(*reference, task.view);
        EXPECT_GT(std::ranges::count_if(truth.ids, [](int id) { return id >= 0; }), 20) << name;
        for (const char* method : {"zbuffer", "scanline", "hierarchical"}) {
            EXPECT_EQ(differences(draw(path("source/homework"), task, method), truth), 0u) << name << ' ' << method;
            EXPECT_EQ(m_said, "");
        }
        EXPECT_EQ(differences(draw(path("source/homework"), task, "scanline --cull"), dumpOf(*culled, task.view)), 0u)
            << name;
        EXPECT_EQ(differences(draw(kTests + "/solution_python/renderer.py", task, ""), truth), 0u) << name;
    }
}

/// Faces that are not convex are split in an order of the kit's own, so that ids are those of the same face only.
TEST_F(Kit, ConcaveFacesCoverWhatZScopeCovers)
{
    ASSERT_EQ(statusOf(fmt::format("'{}/make_variants.py' '{}' solution-zbuffer", kTests, path("class"))), 0);
    const Task task      = taskNamed("stars", m_folder);
    const auto reference = referencePicture(task.scene, task.view, FaceCulling::None);
    ASSERT_TRUE(reference);
    const Dump  truth = dumpOf(*reference, task.view);
    const Dump  drawn = draw(path("class/solution-zbuffer/render"), task, "");
    std::size_t other = 0;
    ASSERT_EQ(drawn.ids.size(), truth.ids.size());
    const auto faceOf = [&](std::int32_t id) {
        return id < 0 ? -1 : static_cast<int>(task.scene.firstOfFace(TriangleId{static_cast<std::uint32_t>(id)}).value);
    };
    for (std::size_t i = 0; i < truth.ids.size(); ++i) other += faceOf(truth.ids[i]) != faceOf(drawn.ids[i]) ? 1 : 0;
    EXPECT_EQ(other, 0u);
}

std::string verdictOf(const check::CheckAnswer& answer)
{
    return !answer.isRight() ? "wrong" : answer.rounding.total() > 0 ? "rounding" : "right";
}

/// `check` gives each variant the verdict of the table, says the sentence that stands there, and names its cause first.
/// "miss" says why it does not.
TEST_F(Kit, EachVariantErrsAsTheTableSays)
{
    const std::string table = contentsOf(kTests + "/variants.json");
    const auto        all   = nlohmann::json::parse(table)["variants"];
    ASSERT_EQ(statusOf(fmt::format("'{}/make_variants.py' '{}'", kTests, path("class"))), 0);
    std::map<std::string, Task>           tasks;
    std::map<std::string, check::Checker> checkers;
    int                                   wrong = 0;
    for (const auto& variant : all) {
        const std::string name = variant["name"], scene = variant["scene"];
        SCOPED_TRACE(name);
        if (!tasks.contains(scene)) {
            tasks.emplace(scene, taskNamed(scene, m_folder));
            checkers.emplace(
                scene, std::make_shared<const PreparedScene>(std::make_shared<const Scene>(tasks.at(scene).scene)));
        }
        draw(path("class/" + name + "/render"), tasks.at(scene), "");
        const auto answer = checkers.at(scene).check({.camera = tasks.at(scene).view, .dump = path("out/out.zdump")});
        ASSERT_TRUE(answer) << answer.error().text();
        EXPECT_EQ(verdictOf(*answer), variant["verdict"]) << answer->sentence;
        if (variant.contains("says")) {
            EXPECT_NE(answer->sentence.find(variant["says"].get<std::string>()), std::string::npos) << answer->sentence;
        }
        if (variant.contains("miss") || answer->plight == check::Plight::NothingDrawn) continue;
        EXPECT_EQ(answer->causes.empty(), variant["cause"].is_null()) << answer->sentence;
        if (answer->causes.empty() || variant["cause"].is_null()) continue;
        EXPECT_EQ(answer->causes.front().name, variant["cause"]) << answer->sentence;
        ++wrong;
    }
    EXPECT_GE(wrong, 20);
}

}  // namespace
}  // namespace zscope::homework_test
