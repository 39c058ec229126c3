// Audits of foreign culling: a right culler is right; of a broken one exactly the lost objects are named; each broken
// pyramid is found at its cells, with its cause.
#include <algorithm>
#include <map>

#include "core/check/audit.h"
#include "core/scene/generators/random.h"
#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

using check::CullVerdict;

struct Boxes {
    std::shared_ptr<const check::Truth> truth;
    std::vector<CullVerdict>            boxes;   // one per instance, none culled
    std::vector<std::uint64_t>          pixels;  // that each instance shows
};

Boxes boxesOf(const std::string& word)
{
    const auto   scene  = preparedScene(word);
    const Camera camera = cameraOf(scene->scene(), 200, 140);
    Boxes        all{*check::truthOf(scene, camera, FaceCulling::None, 8, {}), {}, {}};
    for (std::uint32_t i = 0; i < scene->scene().instances.size(); ++i) {
        Bounds box;
        for (const dvec3& p : scene->scene().meshOf(InstanceId{i}).positions)
            box.include(scene->scene().instances[i].toWorld(p));
        all.boxes.push_back({.name = "box " + std::to_string(i), .box = box, .isCulled = false});
    }
    all.pixels.resize(all.boxes.size());
    for (const std::int64_t id : all.truth->picture.ids.values())
        if (id >= 0) ++all.pixels[scene->scene().instanceOf(TriangleId{static_cast<std::uint32_t>(id)}).value];
    return all;
}

TEST(AuditOfBoxes, CountsThePixelsOfEachBoxAndFindsWhatIsCulledAlthoughItIsSeen)
{
    Boxes all = boxesOf("builtin:soccer-field?count=100");
    // A culler that loses three of those that are seen, and culls half of the hidden ones.
    std::vector<std::size_t> lost;
    std::size_t              hidden = 0;
    for (std::size_t i = 0; i < all.boxes.size(); ++i) {
        if (all.pixels[i] > 0 && lost.size() < 3 && i % 7 == 3) lost.push_back(i), all.boxes[i].isCulled = true;
        if (all.pixels[i] == 0) all.boxes[i].isCulled = hidden++ % 2 == 0;
    }
    ASSERT_EQ(lost.size(), 3u);
    ASSERT_GT(hidden, 1u);
    const auto judged = check::auditVerdicts(*all.truth, all.boxes, "v.json");
    ASSERT_TRUE(judged);
    for (std::size_t i = 0; i < all.boxes.size(); ++i) {
        const check::CullJudgement& object = (*judged)[i];
        EXPECT_GE(object.pixels, all.pixels[i]) << i;  // more where boxes overlap
        EXPECT_EQ(object.isFalseCull(), object.isCulled && object.pixels > 0) << i;
    }
    for (const std::size_t i : lost) EXPECT_TRUE((*judged)[i].isFalseCull()) << i;
}

TEST(AuditOfNames, FindsInstancesMeshesAndGroupsAndRefusesStrangers)
{
    const Boxes              all = boxesOf("builtin:soccer-field?count=20");
    std::vector<CullVerdict> verdicts;
    for (std::size_t i = 0; i < all.pixels.size(); ++i)
        verdicts.push_back({.name = "instance " + std::to_string(i), .box = {}, .isCulled = i % 2 == 0});
    const auto judged = check::auditVerdicts(*all.truth, verdicts, "v.json");
    ASSERT_TRUE(judged);
    for (std::size_t i = 0; i < all.pixels.size(); ++i) EXPECT_EQ((*judged)[i].pixels, all.pixels[i]) << i;

    const Mesh& mesh = all.truth->scene->scene().meshOf(InstanceId{0});
    const auto  whole =
        check::auditVerdicts(*all.truth, {{.name = mesh.name, .box = {}, .isCulled = true, .line = 1}}, "v.json");
    ASSERT_TRUE(whole);
    EXPECT_GE((*whole)[0].pixels, all.pixels[0]);
    const auto stranger = check::auditVerdicts(*all.truth, {{.name = "nobody", .box = {}, .line = 7}}, "v.json");
    ASSERT_FALSE(stranger);
    EXPECT_EQ(stranger.error().line, 7);
    EXPECT_NE(stranger.error().sentence.find("'nobody'"), std::string::npos);
}

TEST(AuditFiles, AreReadOrRefusedWithTheirLine)
{
    const auto read = check::cullVerdictsOf(
        R"([{"name": "a", "min": [0, 0, 0], "max": [1, 2, 3], "culled": true}, {"group": "g", "culled": false}])",
        "v.json");
    ASSERT_TRUE(read);
    EXPECT_EQ((*read)[0].box->max.z, 3);
    EXPECT_FALSE((*read)[1].box);
    for (const char* text :
         {"{}", "[1]", R"([{"name": "a", "culled": true}])", R"([{"group": "a"}])",
          R"([{"name": "a", "min": [1, 0, 0], "max": [0, 0, 0], "culled": true}])",
          R"([{"name": "a", "min": [1, 0], "max": [0, 0, 0], "culled": true}])",
          R"([{"group": "a", "name": "b", "min": [0, 0, 0], "max": [0, 0, 0], "culled": true}])", "["}) {
        const auto broken = check::cullVerdictsOf(text, "v.json");
        ASSERT_FALSE(broken) << text;
        EXPECT_EQ(broken.error().file, "v.json");
    }
}

/// A pyramid as a program with a mistake would build it. `of`: a level from the one below.
template <class Of>
std::vector<Grid<double>> pyramidBy(int width, int height, const Of& of)
{
    Random       random(5);
    Grid<double> pixels(width, height);
    for (double& depth : pixels.values()) depth = 0.05 + 0.9 * random.unit();
    std::vector<Grid<double>> levels{std::move(pixels)};
    while (levels.back().width() > 1 || levels.back().height() > 1) {
        const Grid<double>& below = levels.back();
        Grid<double>        level((below.width() + 1) / 2, (below.height() + 1) / 2);
        for (int y = 0; y < level.height(); ++y)
            for (int x = 0; x < level.width(); ++x) level.at(x, y) = of(below, x, y);
        levels.push_back(std::move(level));
    }
    return levels;
}

double at(const Grid<double>& below, int x, int y)
{
    return below.at(std::clamp(x, 0, below.width() - 1), std::clamp(y, 0, below.height() - 1));
}
double farthest(const Grid<double>& below, int x, int y)
{
    return std::min({at(below, 2 * x, 2 * y), at(below, 2 * x + 1, 2 * y), at(below, 2 * x, 2 * y + 1),
                     at(below, 2 * x + 1, 2 * y + 1)});
}

TEST(AuditOfPyramids, FindsNothingInARightOne)
{
    const auto judged = check::auditPyramid(pyramidBy(77, 45, farthest));
    EXPECT_GT(judged.cells, 900u);
    EXPECT_EQ(judged.wrongCells, 0u);
    EXPECT_FALSE(judged.cause);
}

TEST(AuditOfPyramids, AFartherCellHidesNothingAndIsRight)
{
    const auto judged = check::auditPyramid(
        pyramidBy(64, 64, [](const Grid<double>& below, int x, int y) { return 0.5 * farthest(below, x, y); }));
    EXPECT_EQ(judged.wrongCells, 0u);
}

TEST(AuditOfPyramids, NamesTheCauseOfEachBrokenOne)
{
    const auto nearest = [](const Grid<double>& below, int x, int y) {
        return std::max({at(below, 2 * x, 2 * y), at(below, 2 * x + 1, 2 * y), at(below, 2 * x, 2 * y + 1),
                         at(below, 2 * x + 1, 2 * y + 1)});
    };
    const auto padded = [](const Grid<double>& below, int x, int y) {
        const bool isPadded = 2 * x + 1 >= below.width() || 2 * y + 1 >= below.height();
        return isPadded ? 1.0 : farthest(below, x, y);
    };
    const auto shifted = [](const Grid<double>& below, int x, int y) {
        return farthest(below, std::min(x + 1, (below.width() + 1) / 2 - 1), y);
    };
    const auto finer   = [](const Grid<double>& below, int x, int y) { return at(below, 2 * x, 2 * y); };
    const auto strange = [](const Grid<double>& below, int x, int y) { return farthest(below, x, y) + 0.01; };
    using check::PyramidCause;
    EXPECT_EQ(check::auditPyramid(pyramidBy(77, 45, nearest)).cause, PyramidCause::NearestInCells);
    EXPECT_EQ(check::auditPyramid(pyramidBy(77, 45, padded)).cause, PyramidCause::OddPadded);
    EXPECT_EQ(check::auditPyramid(pyramidBy(77, 45, shifted)).cause, PyramidCause::LevelShifted);
    EXPECT_EQ(check::auditPyramid(pyramidBy(77, 45, finer)).cause, PyramidCause::LevelTooFine);
    EXPECT_EQ(check::auditPyramid(pyramidBy(77, 45, strange)).cause, PyramidCause::Unknown);
}

TEST(AuditOfPyramids, FindsTheOneCellThatIsTooNear)
{
    auto levels = pyramidBy(64, 48, farthest);
    levels[2].at(5, 7) += 1e-9;
    const auto judged = check::auditPyramid(levels);
    ASSERT_EQ(judged.wrongCells, 1u);
    EXPECT_EQ(judged.wrong[0].level, 2);
    EXPECT_EQ(judged.wrong[0].x, 5);
    EXPECT_EQ(judged.wrong[0].y, 7);
}

TEST(AuditOfPyramids, LevelsMayBeRoundedUpOrDown)
{
    EXPECT_TRUE(check::isHalfOf(39, 77));
    EXPECT_TRUE(check::isHalfOf(38, 77));
    EXPECT_TRUE(check::isHalfOf(1, 1));
    EXPECT_FALSE(check::isHalfOf(77, 77));
    // Rounded down, the last cell stands for three columns: the third counts.
    Grid<double> pixels(5, 2, 0.5), level(2, 1, 0.5);
    pixels.at(4, 1) = 0.25;
    EXPECT_EQ(check::auditPyramid({pixels, level}).wrongCells, 1u);
}

}  // namespace
}  // namespace zscope::tests
