// Area subdivision: the definition's picture; windows cover it once; what is said of a window is true of all its
// pixels.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/frame/observed_run.h"
#include "core/measure/verify.h"
#include "core/method/warnock.h"
#include "core/probe/recorders.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

using plain::WindowJudged;
using plain::WindowVerdict;

const Preset& warnock() { return *findPreset("warnock"); }

void expectExact(const Prepared& scene, const Camera& camera, FaceCulling culling, const std::string& what)
{
    const auto rows = verify(
        {.scene = scene, .camera = camera, .faceCulling = culling, .algorithms = {warnock()}, .threads = {1, 3}});
    ASSERT_TRUE(rows.ok()) << what;
    for (const VerifyRow& row : *rows)
        EXPECT_TRUE(row.passed()) << what << ": " << row.figures.wrongPixels() << " wrong pixels";
}

TEST(Warnock, DrawsTheDefinitionsPictureOfEveryKindOfSoup)
{
    for (const SoupKind kind : soupKinds())
        for (std::uint64_t seed = 1; seed <= shareOf(10); ++seed) {
            const Soup soup = makeSoup(kind, seed, 71, 53, 80);
            expectExact(prepared(soup.scene), soup.camera, seed % 2 ? FaceCulling::None : FaceCulling::Back, soup.what);
        }
}

/// Crossings, ties, planes that run together, patterns.
TEST(Warnock, DrawsTheDefinitionsPictureWhereALeadIsSmallOrNone)
{
    for (const char* word : {"hard/C1", "hard/C2", "hard/C3", "hard/C4", "hard/C5", "hard/C6", "hard/C7", "cutouts",
                             "reliefs", "glass", "layers?count=30"}) {
        const Scene scene = builtinScene(word);
        expectExact(prepared(scene), cameraFor(scene, 128, 97), FaceCulling::None, word);
    }
}

/// Holds every window against the reference.
struct WindowJudge {
    using Events = Wants<WindowJudged>;

    const Picture&      reference;
    Grid<std::uint32_t> decided;  // how many windows that were not divided hold the pixel
    std::uint64_t       windows = 0, whole = 0, largest = 0;

    explicit WindowJudge(const Picture& picture)
        : reference(picture), decided(picture.ids.width(), picture.ids.height(), 0)
    {}

    void observe(const WindowJudged& e)
    {
        ++windows;
        if (e.verdict == WindowVerdict::Divided) return;
        const bool isWhole = e.verdict == WindowVerdict::Surrounded;
        whole += isWhole;
        if (isWhole) largest = std::max(largest, e.window.area());
        EXPECT_EQ(isWhole, e.leader != nullptr);
        for (int y = e.window.y0; y < e.window.y1; ++y)
            for (int x = e.window.x0; x < e.window.x1; ++x) {
                ++decided.at(x, y);
                if (isWhole) {
                    EXPECT_EQ(reference.ids.at(x, y), std::int64_t{e.leader->id.value});
                }
                if (e.verdict == WindowVerdict::Empty) {
                    EXPECT_EQ(reference.ids.at(x, y), -1);
                }
            }
    }
};

WindowJudge judgeWindows(const std::string& word, const Picture& reference, const Scene& scene, const Camera& camera)
{
    Frame          frame;
    plain::Scratch scratch;
    WindowJudge    judge(reference);
    Listening      listening(judge);
    drawObserved({.scene = prepared(scene), .camera = camera, .pipeline = warnock().pipeline, .shade = false}, frame,
                 scratch, listening);
    for (const std::uint32_t times : judge.decided.values()) EXPECT_EQ(times, 1u) << word;
    return judge;
}

TEST(Warnock, WindowsCoverThePictureOnceAndThoseGivenAwayWholeBelongToOneTriangle)
{
    for (const char* word : {"cubes", "city?blocks=2", "teapot?tessellation=4"}) {
        const Scene       scene     = builtinScene(word);
        const Camera      camera    = cameraFor(scene, 101, 67);
        const Picture     reference = *referencePicture(scene, camera, FaceCulling::None);
        const WindowJudge judge     = judgeWindows(word, reference, scene, camera);
        EXPECT_GT(judge.whole, 20u) << word;
        EXPECT_GE(judge.largest, 8u) << word;
        EXPECT_LT(judge.windows, 101u * 67u * 4 / 3 + 100) << word << ": fewer than if all were divided";
    }
}

/// Each layer is two triangles that cover the picture: away from their common side a window belongs to the nearest one.
TEST(Warnock, DecidesMostOfManyLayersInAFewLargeWindows)
{
    const Scene       scene     = builtinScene("layers?count=30");
    const Camera      camera    = cameraFor(scene, 128, 128);
    const Picture     reference = *referencePicture(scene, camera, FaceCulling::None);
    const WindowJudge judge     = judgeWindows("layers", reference, scene, camera);
    EXPECT_GE(judge.largest, 32u * 32u);
    EXPECT_LT(judge.windows, 128u * 128u / 8);
}

}  // namespace
}  // namespace zscope::tests
