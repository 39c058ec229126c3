#include "tests/agreement/agreement_support.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "core/measure/verify.h"
#include "core/scene/load.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {

#ifdef ZSCOPE_SANITIZED_TESTS
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

std::uint64_t shareOf(std::uint64_t whole) { return kSanitized ? std::max<std::uint64_t>(1, whole / 10) : whole; }

std::vector<Simd> targetsTested()
{
    if (kSanitized) return {resolved(Simd::Auto)};
    std::vector<Simd> targets;
    for (const SimdEntry& entry : simdTargets())
        if (entry.available && entry.target != Simd::Scalar) targets.push_back(entry.target);
    if (targets.empty()) targets.push_back(Simd::Scalar);
    return targets;
}

std::vector<Preset> exactPresets()
{
    std::vector<Preset> exact;
    for (const Preset& preset : presets()) {
        if (preset.claim != Claim::Approximate) exact.push_back(preset);
    }
    return exact;
}

std::uint64_t expectAgreement(const std::shared_ptr<const PreparedScene>& scene, const Camera& camera,
                              FaceCulling culling, const std::string& what, const Agreement& with)
{
    VerifyRequest       request{.scene       = scene,
                                .camera      = camera,
                                .faceCulling = culling,
                                .algorithms  = {},
                                .threads     = kSanitized ? std::vector{2} : with.threads,
                                .simd        = with.targets};
    std::vector<Preset> alone;  // plain text has one lane, whatever the target
    for (const Preset& preset : exactPresets())
        (hasFastText(preset.pipeline) ? request.algorithms : alone).push_back(preset);
    auto rows = verify(request);
    if (rows && !alone.empty()) {
        request.algorithms = alone;
        request.simd       = {with.targets.front()};
        auto more          = verify(request);
        if (more)
            std::ranges::move(*more, std::back_inserter(*rows));
        else
            rows = more;
    }
    if (!rows) {
        ADD_FAILURE() << what << ": " << rows.error().text();
        return 0;
    }
    const bool isOfTriangles = std::ranges::all_of(
        scene->scene().meshes, [](const auto& mesh) { return mesh->triangles.size() == mesh->polygonCount(); });
    for (const VerifyRow& row : *rows) {
        EXPECT_TRUE(row.passed() && (!isOfTriangles || row.figures.isExact()))
            << what << ", culling " << (culling == FaceCulling::Back ? "back" : "none") << ", " << row.algorithm << ", "
            << row.threads << " threads, " << wordOf(row.simd) << ": " << row.figures.holes << " holes, "
            << row.figures.spills << " spills, " << row.figures.wrongSurface() << " wrong surfaces, "
            << row.figures.depthBitsDiffer << " depths differ by up to " << row.figures.maxDepthSteps << " steps";
        EXPECT_EQ(row.falseCulls, 0u) << what << ", " << row.algorithm;
    }
    return rows->empty() ? 0 : rows->front().figures.covered;
}

Camera cameraFor(const Scene& scene, int width, int height)
{
    ViewRequest view = scene.views.empty() ? ViewRequest{} : scene.views.front().view;
    if (view.exact) {
        width  = view.exact->width;
        height = view.exact->height;
    }
    view.width        = width;
    view.height       = height;
    const auto camera = makeCamera(view, scene.bounds);
    EXPECT_TRUE(camera.ok()) << (camera.ok() ? "" : camera.error().text());
    return camera.ok() ? *camera : plainCamera(width, height);
}

Prepared prepared(std::shared_ptr<const Scene> scene)
{
    return std::make_shared<const PreparedScene>(std::move(scene));
}
Prepared prepared(Scene scene) { return prepared(std::make_shared<const Scene>(std::move(scene))); }

Scene builtinScene(const std::string& word)
{
    Result<Scene> scene = loadScene("builtin:" + word);
    EXPECT_TRUE(scene.ok()) << word;
    return scene.ok() ? *std::move(scene) : Scene{};
}

std::map<std::string, std::uint64_t> countersOf(const DrawRequest& request)
{
    const Result<FrameWork>              work = Renderer().count(request);
    std::map<std::string, std::uint64_t> counters;
    EXPECT_TRUE(work.ok());
    if (work.ok())
        for (const NamedCount& counter : work->counters) counters[counter.name] = counter.value;
    return counters;
}

std::optional<std::string> firstDifference(const Frame& a, const Frame& b)
{
    for (int y = 0; y < a.visible.height(); ++y)
        for (int x = 0; x < a.visible.width(); ++x) {
            const std::string where = "at (" + std::to_string(x) + ", " + std::to_string(y) + "): ";
            const float       here = a.visible.storedAt(x, y), there = b.visible.storedAt(x, y);
            if (a.visible.idAt(x, y) != b.visible.idAt(x, y))
                return where + "triangles " + std::to_string(a.visible.idAt(x, y)) + " and "
                       + std::to_string(b.visible.idAt(x, y));
            if (a.visible.idAt(x, y) >= 0 && std::memcmp(&here, &there, sizeof here) != 0)
                return where + "depths " + std::to_string(here) + " and " + std::to_string(there);
            if (a.colour.at(x, y) != b.colour.at(x, y)) return where + "colours";
        }
    return std::nullopt;
}

void drawAlone(const DrawRequest& request, Frame& frame)
{
    Renderer renderer;
    for (int i = 0; i < (request.pipeline.coherence == Coherence::None ? 1 : 2); ++i) {
        const auto report = renderer.draw(request, frame);
        EXPECT_TRUE(report.ok()) << nameOf(request.pipeline) << ": " << (report.ok() ? "" : report.error().text());
    }
}

}  // namespace zscope::tests
