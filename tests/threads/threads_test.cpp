// The picture does not depend on how many threads draw it, on who else draws the same scene, or on when somebody
// asks to stop. Small scenes: the thread sanitizer runs this too.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/frame/renderer.h"
#include "core/lesson/replay.h"
#include "core/measure/reference.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

constexpr int kWidth  = 321;  // odd, so that stripes and vectors do not fit evenly
constexpr int kHeight = 193;

const char* const kScenes[] = {"builtin:cubes", "builtin:teapot?tessellation=4", "builtin:soccer-field?count=12&seed=3",
                               "builtin:soup?count=600&seed=11&size=2", "builtin:layers?count=20&order=back"};

std::shared_ptr<const PreparedScene> prepared(const std::string& word)
{
    Result<Scene> scene = loadScene(word);
    if (!scene) {
        ADD_FAILURE() << scene.error().text();
        return nullptr;
    }
    return std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(scene)));
}

Camera cameraOf(const Scene& scene)
{
    ViewRequest view;
    if (!scene.views.empty()) view = scene.views.front().view;
    view.width                  = kWidth;
    view.height                 = kHeight;
    const Result<Camera> camera = makeCamera(view, scene.bounds);
    EXPECT_TRUE(camera);
    return *camera;
}

struct Drawn {
    Picture             picture;
    Grid<std::uint32_t> colour;

    friend bool operator==(const Drawn&, const Drawn&) = default;
};

DrawRequest requestFor(const std::shared_ptr<const PreparedScene>& scene, const Preset& preset, int threads)
{
    DrawRequest request;
    request.scene    = scene;
    request.camera   = cameraOf(scene->scene());
    request.pipeline = preset.pipeline;
    request.threads  = threads;
    return request;
}

Drawn draw(Renderer& renderer, const DrawRequest& request)
{
    Frame      frame;
    const auto report = renderer.draw(request, frame);
    EXPECT_TRUE(report) << report.error().text();
    return {pictureOf(frame.visible), frame.colour};
}

TEST(Threads, AnyNumberOfThreadsDrawsTheSamePicture)
{
    for (const char* word : kScenes) {
        const auto scene = prepared(word);
        ASSERT_TRUE(scene);
        for (const Preset& preset : presets()) {
            Renderer    renderer;
            const Drawn alone = draw(renderer, requestFor(scene, preset, 1));
            EXPECT_TRUE(std::ranges::any_of(alone.picture.ids.values(), [](std::int64_t id) { return id >= 0; }));
            for (const int threads : {2, 3, 8})
                EXPECT_TRUE(draw(renderer, requestFor(scene, preset, threads)) == alone)
                    << word << ' ' << preset.name << " on " << threads << " threads";
        }
    }
}

TEST(Threads, SeveralRenderersShareOneScene)
{
    const auto scene = prepared("builtin:soccer-field?count=12&seed=3");
    ASSERT_TRUE(scene);
    for (const Preset& preset : presets()) {
        Renderer                 renderer;
        const Drawn              expected = draw(renderer, requestFor(scene, preset, 1));
        const auto               fresh    = prepared("builtin:soccer-field?count=12&seed=3");
        std::vector<Drawn>       pictures(3);
        std::vector<std::thread> workers;
        for (Drawn& picture : pictures)
            workers.emplace_back([&picture, &fresh, &preset] {
                Renderer own;
                picture = draw(own, requestFor(fresh, preset, 2));
            });
        for (std::thread& worker : workers) worker.join();
        for (const Drawn& picture : pictures) EXPECT_TRUE(picture == expected) << preset.name;
    }
}

TEST(Threads, AFrameCanBeCancelledFromAnotherThreadAndTheNextOneIsWhole)
{
    const auto scene = prepared("builtin:soup?count=600&seed=11&size=2");
    ASSERT_TRUE(scene);
    for (const Preset& preset : presets()) {
        Renderer          renderer;
        const Drawn       expected = draw(renderer, requestFor(scene, preset, 2));
        std::atomic<bool> cancel{false};
        DrawRequest       request = requestFor(scene, preset, 2);
        request.cancel            = &cancel;

        std::atomic<bool> drawing{false};
        std::thread       impatient([&] {
            while (!drawing.load()) std::this_thread::yield();
            cancel.store(true);
        });
        // Drawn again and again until the wish arrives, whatever the machine is busy with.
        Result<FrameReport> report = Error{};
        Frame               frame;
        do {
            drawing.store(true);
            report = renderer.draw(request, frame);
        } while (report);
        impatient.join();
        EXPECT_EQ(report.error().kind, Trouble::Cancelled);
        EXPECT_TRUE(draw(renderer, requestFor(scene, preset, 2)) == expected) << preset.name;
    }
}

TEST(Threads, SteppingFromAnotherThreadGivesTheSameState)
{
    const auto scene = prepared("builtin:cubes");
    ASSERT_TRUE(scene);
    for (const Preset& preset : presets()) {
        const DrawRequest request = requestFor(scene, preset, 2);
        Replay            here(request);
        const auto        count = here.count(Grain::Stage);
        ASSERT_TRUE(count);
        const auto expected = here.at(Grain::Stage, StepIndex{*count - 1});
        ASSERT_TRUE(expected);

        std::vector<std::string> states(2);
        std::vector<std::thread> workers;
        for (std::string& state : states)
            workers.emplace_back([&state, &request, &count] {
                Replay     own(request);
                const auto reached = own.at(Grain::Stage, StepIndex{*count - 1});
                if (reached) state = stateToJson(*reached);
            });
        for (std::thread& worker : workers) worker.join();
        for (const std::string& state : states) EXPECT_EQ(state, stateToJson(*expected)) << preset.name;
    }
}

TEST(Threads, TheReferenceIsDrawnByManyAndStillTheReference)
{
    const auto scene = prepared("builtin:teapot?tessellation=4");
    ASSERT_TRUE(scene);
    const Camera camera    = cameraOf(scene->scene());
    const auto   reference = referencePicture(scene->scene(), camera, FaceCulling::None);
    ASSERT_TRUE(reference);
    Renderer renderer;
    EXPECT_TRUE(draw(renderer, requestFor(scene, presets().front(), 1)).picture == *reference);
}

}  // namespace
}  // namespace zscope
