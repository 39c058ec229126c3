// What a silent probe costs: every preset drawn with NoProbe and with its probe statements removed from the text, turn
// and turn about on one thread, and the quotient of each pair of frames. No test: it prints, a reader judges. 1.00 is
// free.
//
//     probe_cost [SCENE [WIDTHxHEIGHT [PAIRS]]]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "core/frame/kernels.h"
#include "core/scene/load.h"
#include "tests/bench/drivers_without_probes.h"

namespace {

using namespace zscope;

constexpr int kWarmUp = 3;

double quantile(std::vector<double> values, double p)
{
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1) + 0.5)];
}

struct Subject {
    std::shared_ptr<PreparedScene> scene;
    Camera                         camera;
};

/// One frame without shading; milliseconds.
template <class Draw>
double timed(const Draw& draw, const Subject& subject, const Pipeline& pipeline, VisibilityBuffer& visible,
             StripeScratch& scratch)
{
    const Projection projection(subject.camera);
    const Stripe     whole{*subject.scene, projection, FaceCulling::None, visible, 0, subject.camera.height, {}};
    StageClock       clock;
    const auto       start = std::chrono::steady_clock::now();
    draw(pipeline, whole, scratch, clock);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// False if the two pictures differ: then there is nothing to compare.
bool measure(const Subject& subject, const Preset& preset, int pairs)
{
    const auto       silent  = kernelsOf(resolved(Simd::Auto)).drawStripe;
    const auto       removed = bench::drawStripeWithoutProbes;
    const Camera&    camera  = subject.camera;
    VisibilityBuffer first, second;
    for (VisibilityBuffer* buffer : {&first, &second})
        buffer->resize(camera.width, camera.height,
                       DepthEncoding(DepthFormat::ReversedFloat32, camera.near, camera.far));
    StripeScratch       scratch;  // shared, so that neither has the better place in memory
    std::vector<double> ratios, silentMs, removedMs;
    for (int i = -kWarmUp; i < pairs; ++i) {
        const bool swapped = i % 2 != 0;
        double     one = 0, other = 0;
        if (swapped) other = timed(removed, subject, preset.pipeline, second, scratch);
        one = timed(silent, subject, preset.pipeline, first, scratch);
        if (!swapped) other = timed(removed, subject, preset.pipeline, second, scratch);
        if (i < 0) continue;
        ratios.push_back(one / other);
        silentMs.push_back(one);
        removedMs.push_back(other);
    }
    if (!(pictureOf(first) == pictureOf(second))) {
        std::fprintf(stderr, "%s: the pictures differ\n", std::string(preset.name).c_str());
        return false;
    }
    std::printf("%-18s %10.3f %10.3f %8.3f %8.3f %8.3f\n", std::string(preset.name).c_str(), quantile(silentMs, 0.5),
                quantile(removedMs, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.5), quantile(ratios, 0.75));
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string word = argc > 1 ? argv[1] : "builtin:soccer-field?count=200";
    ViewRequest       view;
    if (argc > 2 && std::sscanf(argv[2], "%dx%d", &view.width, &view.height) != 2) {
        std::fprintf(stderr, "the size must be WIDTHxHEIGHT\n");
        return 2;
    }
    const int     pairs = std::max(1, argc > 3 ? std::atoi(argv[3]) : 31);
    Result<Scene> scene = loadScene(word);
    if (!scene) {
        std::fprintf(stderr, "%s\n", scene.error().text().c_str());
        return 3;
    }
    const int width = view.width, height = view.height;
    if (!scene->views.empty()) view = scene->views.front().view;
    view.width                  = width;
    view.height                 = height;
    const Result<Camera> camera = makeCamera(view, scene->bounds);
    if (!camera) {
        std::fprintf(stderr, "%s\n", camera.error().text().c_str());
        return 2;
    }
    const Subject subject{std::make_shared<PreparedScene>(std::make_shared<const Scene>(std::move(*scene))), *camera};
    std::printf("%s, %dx%d, one thread, %d pairs\n", word.c_str(), width, height, pairs);
    std::printf("%-18s %10s %10s %8s %8s %8s\n", "algorithm", "NoProbe ms", "removed ms", "q1", "ratio", "q3");
    bool equal = true;
    for (const Preset& preset : presets()) equal = measure(subject, preset, pairs) && equal;
    return equal ? 0 : 1;
}
