#include "app/cli/bench_scenes.h"

#include <fmt/format.h>

#include "app/cli/options.h"
#include "app/cli/project_file.h"
#include "core/io/read_file.h"
#include "core/measure/experiment.h"

namespace zscope::cli {
namespace {

Result<Done> readCamera(std::string_view file, BenchScene& scene)
{
    const auto path = findProjectFile(file);
    if (!path)
        return Error{Trouble::Input, "this file of the project was not found, neither here nor above the program",
                     std::string(file)};
    const Result<std::string> text = readRegularFile(*path, kMaxCameraFile);
    if (!text) return text.error();
    const Result<Camera> camera = cameraFromJson(*text, *path);
    if (!camera) return camera.error();
    scene.cameraFile = *path;
    scene.camera     = *camera;
    return Done{};
}

}  // namespace

std::string BenchScene::nameFor(const Scene& scene) const
{
    if (!title.empty()) return title;
    return view.empty() ? scene.name : fmt::format("{} ({})", scene.name, view);
}

Result<ViewWords::View> BenchScene::viewOf(const Scene& scene, const ViewWords& words) const
{
    const bool keepsFile = camera && (words.given.empty() || words.given == std::vector<std::string>{"--size"});
    if (!keepsFile) {
        Result<ViewWords::View> said = words.of(scene, view);
        if (said && !words.faceCulling && faceCulling) said->faceCulling = *faceCulling;
        return said;
    }
    Camera sized = *camera;
    if (!words.given.empty()) {
        sized.width  = words.request.width;
        sized.height = words.request.height;
    }
    return ViewWords::View{sized, words.faceCulling.value_or(faceCulling.value_or(FaceCulling::None))};
}

std::string BenchScene::options() const
{
    std::string words = fmt::format("'{}'", word);
    if (!cameraFile.empty()) words += fmt::format(" --camera {}", cameraFile);
    if (faceCulling) words += *faceCulling == FaceCulling::Back ? " --cull back" : " --cull none";
    return words;
}

Result<BenchScene> benchSceneOf(const SuiteScene& from, std::optional<FaceCulling> faceCulling)
{
    BenchScene       scene{.word        = std::string(from.word),
                           .view        = std::string(from.view),
                           .title       = std::string(from.title),
                           .faceCulling = faceCulling};
    std::string_view camera = from.camera;
    if (!from.model.empty()) {
        const auto model = findProjectFile(from.model);
        scene.isStandIn  = !model;
        if (model) {
            scene.word = *model;
            camera     = from.modelCamera;
        } else {
            scene.title += " (stand-in)";
        }
    }
    if (camera.empty()) return scene;
    const auto read = readCamera(camera, scene);
    return read ? Result<BenchScene>(std::move(scene)) : read.error();
}

Result<std::vector<BenchScene>> benchScenesOf(const std::vector<std::string>& said, const Suite* suite)
{
    std::vector<BenchScene> scenes;
    for (const std::string& word : said)
        scenes.push_back({.word = word, .faceCulling = suite ? suite->faceCulling : std::nullopt});
    if (!scenes.empty()) return scenes;
    for (const SuiteScene& scene : suite->scenes) {
        Result<BenchScene> resolved = benchSceneOf(scene, suite->faceCulling);
        if (!resolved) return resolved.error();
        scenes.push_back(*std::move(resolved));
    }
    return scenes;
}

Result<NamedPath> cameraPathOf(const std::string& file)
{
    const auto found = findProjectFile(file);
    if (!found)
        return Error{Trouble::Input, "this camera path was not found, neither here nor above the program", file};
    const Result<std::string> text = readRegularFile(*found, kMaxPathFile);
    if (!text) return text.error();
    Result<CameraPath> path = cameraPathFromJson(*text, *found);
    if (!path) return path.error();
    const std::string digest = digestOfText(cameraPathToJson(*path));
    return NamedPath{*std::move(path), file, digest};
}

}  // namespace zscope::cli
