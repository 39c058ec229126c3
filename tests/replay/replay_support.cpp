#include "tests/replay/replay_support.h"

#include <gtest/gtest.h>

#include "core/scene/load.h"

namespace zscope::tests {

DrawRequest SeenScene::request(const Pipeline& pipeline) const
{
    DrawRequest request;
    request.scene    = scene;
    request.camera   = camera;
    request.pipeline = pipeline;
    request.threads  = 1;
    return request;
}

SeenScene builtinScene(const std::string& word, int width, int height)
{
    Result<Scene> scene = loadScene("builtin:" + word);
    EXPECT_TRUE(scene.ok()) << scene.error().text();
    ViewRequest view            = scene->views.empty() ? ViewRequest{} : scene->views.front().view;
    view.width                  = width;
    view.height                 = height;
    const Result<Camera> camera = makeCamera(view, scene->bounds);
    EXPECT_TRUE(camera.ok()) << camera.error().text();
    return {.what   = word + " at " + std::to_string(width) + "x" + std::to_string(height),
            .scene  = std::make_shared<PreparedScene>(std::make_shared<const Scene>(std::move(*scene))),
            .camera = *camera};
}

SeenScene soupScene(SoupKind kind, std::uint64_t seed, int width, int height, int triangles)
{
    const Soup soup = makeSoup(kind, seed, width, height, triangles);
    return {.what = soup.what, .scene = std::make_shared<PreparedScene>(soup.scene), .camera = soup.camera};
}

std::string contentsOf(const StepState& state)
{
    StepState timeless;
    timeless.algorithm = state.algorithm;
    timeless.sentence  = state.sentence;
    timeless.event     = state.event;
    timeless.stage     = state.stage;
    timeless.sweep     = state.sweep;
    timeless.hierarchy = state.hierarchy;
    timeless.interval  = state.interval;
    timeless.triangle  = state.triangle;
    timeless.pixel     = state.pixel;
    timeless.span      = state.span;
    return stateToJson(timeless);
}

bool areIdentical(const StepState& a, const StepState& b)
{
    const auto buckets = [](const StepState& s) { return s.sweep ? s.sweep->edgesStarting : std::vector<int>{}; };
    return stateToJson(a) == stateToJson(b) && pictureOf(a.frame.visible) == pictureOf(b.frame.visible)
           && a.frame.colour == b.frame.colour && buckets(a) == buckets(b);
}

}  // namespace zscope::tests
