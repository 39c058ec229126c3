// What a careful renderer draws is judged "rounding only", whatever model it draws; one pixel that it could not have
// drawn is judged wrong, at that pixel and nowhere else.
#include <random>

#include "core/frame/renderer.h"
#include "tests/agreement/soups.h"
#include "tests/check/careful_renderer.h"
#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

using check::Mistake;
namespace fs = std::filesystem;

/// Models that are handed out beside the project; none where it stands alone.
std::vector<std::string> models()
{
    std::vector<std::string> found{"builtin:teapot?tessellation=6", "builtin:city?blocks=4", "builtin:hard/B1"};
    for (const char* place : {"../shared/models", "../../shared/models"}) {
        const fs::path folder = fs::path(ZSCOPE_SOURCE_DIR) / place;
        if (!fs::exists(folder)) continue;
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".obj") found.push_back(entry.path().string());
        break;
    }
    std::ranges::sort(found);
    return found;
}

std::string firstWrongOf(const check::CheckAnswer& answer)
{
    if (!answer.firstWrong) return {};
    const auto& first = *answer.firstWrong;
    std::string text  = " (" + std::to_string(first.pixel.x) + ", " + std::to_string(first.pixel.y) + ") expected "
                       + std::to_string(first.expected.id.value_or(-9)) + " found "
                       + std::to_string(first.found.id.value_or(-9)) + " depth "
                       + std::to_string(first.found.depth.value_or(-9)) + ", covered by";
    for (const PixelCover& cover : first.covers)
        text += ' ' + std::to_string(cover.triangle.value) + ':' + std::to_string(cover.depth);
    return text;
}

class Rounding : public CheckFiles {
protected:
    check::CheckAnswer judged(check::Checker& checker, const Camera& camera, const Picture& picture,
                              bool withIds = true)
    {
        check::CheckRequest request;
        request.camera = camera;
        if (withIds) request.ids = writeIds("ids.npy", picture.ids);
        request.depth     = writeDepth("depth.npy", picture.depth);
        request.diagnoses = false;
        auto answer       = checker.check(request);
        EXPECT_TRUE(answer) << answer.error().text();
        return *std::move(answer);
    }
};

TEST_F(Rounding, AloneIsWhatACarefulRendererDiffersBy)
{
    std::uint64_t differences = 0;
    for (const std::string& model : models()) {
        const auto     scene = preparedScene(model);
        check::Checker checker(scene);
        for (const auto& [width, height] : {std::pair(160, 120), std::pair(333, 217), std::pair(640, 480)}) {
            const Camera camera = cameraOf(scene->scene(), width, height);
            for (const Grid8 grid : {Grid8::Snapped, Grid8::Unsnapped}) {
                const Picture picture = CarefulRenderer{.grid = grid}.draw(scene->scene(), camera);
                for (const bool withIds : {true, false}) {
                    const auto answer = judged(checker, camera, picture, withIds);
                    EXPECT_TRUE(answer.isRight())
                        << model << ' ' << width << 'x' << height
                        << (grid == Grid8::Snapped ? " snapped" : " unsnapped")
                        << (withIds ? " ids: " : " depth alone: ") << answer.sentence << firstWrongOf(answer);
                    EXPECT_GT(answer.covered, 100u) << model;
                    differences += answer.rounding.total();
                }
            }
        }
    }
    EXPECT_GT(differences, 100u) << "nothing was to be forgiven, so nothing was tested";
}

/// Far from the origin float32 places vertices by more than half a step of the grid.
TEST_F(Rounding, GrowsWithTheDistanceFromTheOrigin)
{
    const auto     near   = preparedScene("builtin:teapot?tessellation=6");
    const auto     place  = std::array{Affine::translation({20'000, -3'000, 50'000})};
    const auto     scene  = std::make_shared<const PreparedScene>(sceneOf(*near->scene().meshes[0], place));
    const Camera   camera = cameraOf(scene->scene(), 333, 217);
    check::Checker checker(scene);
    const auto     answer = judged(checker, camera, CarefulRenderer{}.draw(scene->scene(), camera));
    EXPECT_TRUE(answer.isRight()) << answer.sentence << firstWrongOf(answer);
    EXPECT_GT(answer.rounding.total(), 100u);
}

/// The reference's own picture with one pixel changed, in each way in which it can be.
TEST_F(Rounding, DoesNotExplainOneChangedPixel)
{
    for (const char* word :
         {"builtin:teapot?tessellation=6", "builtin:city?blocks=4", "builtin:soccer-field?count=20"}) {
        const auto     scene  = preparedScene(word);
        const Camera   camera = cameraOf(scene->scene(), 200, 150);
        check::Checker checker(scene);
        const Picture  right = *referencePicture(scene->scene(), camera, FaceCulling::None);
        std::mt19937   random(7);
        int            changed = 0;
        while (changed < 21) {
            const int x = static_cast<int>(random() % 200), y = static_cast<int>(random() % 150);
            // In the middle of what is shown there: pixels beside an edge may be drawn otherwise.
            const std::int64_t id      = right.ids.at(x, y);
            bool               isInner = true;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    isInner = isInner && x + dx >= 0 && y + dy >= 0 && x + dx < 200 && y + dy < 150
                              && right.ids.at(x + dx, y + dy) == id;
            if (!isInner) continue;
            Picture       picture = right;
            const Mistake kinds[] = {Mistake::Hole, Mistake::WrongSurface, Mistake::WrongDepth};
            Mistake       kind    = id < 0 ? Mistake::Spill : kinds[changed % 3];
            if (kind == Mistake::Hole) picture.ids.at(x, y) = -1;
            if (kind == Mistake::WrongDepth) picture.depth.at(x, y) *= 1.01f;
            if (kind == Mistake::WrongSurface || kind == Mistake::Spill) {
                const std::int64_t  other = static_cast<std::int64_t>(random() % scene->scene().triangleCount());
                const PixelPosition point[]{{x, y}};
                const auto          covers = *coversOf(scene->scene(), camera, FaceCulling::None, point);
                if (other == id
                    || std::ranges::any_of(covers[0], [&](const PixelCover& c) { return c.triangle.value == other; }))
                    continue;
                picture.ids.at(x, y) = other;
            }
            const auto answer = judged(checker, camera, picture);
            ++changed;
            EXPECT_EQ(answer.wrong.total(), 1u) << word << ' ' << x << ' ' << y << ' ' << wordOf(kind);
            EXPECT_EQ(answer.wrong.of(kind), 1u) << word << ' ' << x << ' ' << y << ' ' << wordOf(kind);
            EXPECT_EQ(answer.rounding.total(), 0u);
            ASSERT_TRUE(answer.firstWrong);
            EXPECT_EQ(answer.firstWrong->pixel, (PixelPosition{x, y}));
            EXPECT_EQ(answer.firstWrong->mistake, kind);
        }
    }
}

/// Samples exactly on edges may be filled by any rule; the sentence says so.
TEST_F(Rounding, ExplainsAnotherFillRuleAndSaysSo)
{
    const auto     scene  = preparedScene("builtin:hard/A3");
    const Camera   camera = cameraOf(scene->scene(), 64, 64);
    check::Checker checker(scene);
    const Picture  picture = CarefulRenderer{.ownsAllEdges = true}.draw(scene->scene(), camera);
    const auto     answer  = judged(checker, camera, picture);
    EXPECT_TRUE(answer.isRight()) << answer.sentence;
    EXPECT_GT(answer.rounding.total(), 0u);
    EXPECT_NE(answer.sentence.find("the fill rule is not the top-left rule"), std::string::npos) << answer.sentence;
}

TEST_F(Rounding, DoesNotExplainCentresAtWholeNumbers)
{
    const auto     scene  = preparedScene("builtin:teapot?tessellation=6");
    const Camera   camera = cameraOf(scene->scene(), 200, 150);
    check::Checker checker(scene);
    EXPECT_FALSE(judged(checker, camera, CarefulRenderer{.centre = 0}.draw(scene->scene(), camera)).isRight());
}

/// A coarser grid is rounding if --subpixel-bits names it.
TEST_F(Rounding, DependsOnTheGridThatIsSaid)
{
    const auto  scene  = preparedScene("builtin:city?blocks=4");
    const auto  camera = cameraOf(scene->scene(), 200, 150);
    DrawRequest request{
        .scene = scene, .camera = camera, .pipeline = *withChoice({}, "snap", "4-bits"), .shade = false};
    Frame frame;
    ASSERT_TRUE(Renderer().draw(request, frame));
    const Picture picture = pictureOf(frame.visible);
    for (const int bits : {8, 4}) {
        check::CheckRequest asked;
        asked.camera       = camera;
        asked.ids          = writeIds("ids.npy", picture.ids);
        asked.subpixelBits = bits;
        asked.diagnoses    = false;
        check::Checker checker(scene);
        const auto     answer = checker.check(asked);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->isRight(), bits == 4) << answer->sentence;
    }
}

}  // namespace
}  // namespace zscope::tests
