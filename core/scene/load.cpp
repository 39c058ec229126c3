#include "core/scene/load.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/base/stopwatch.h"
#include "core/io/read_file.h"
#include "core/scene/generators/registry.h"
#include "core/scene/obj/obj_import.h"
#include "core/scene/opacity.h"
#include "core/scene/scene_file.h"

namespace zscope {

namespace {

constexpr std::string_view kBuiltin = "builtin:";

/// The path with '/' for every backslash, as Windows writes paths, if only that one exists.
std::string onDisk(const std::string& path)
{
    std::error_code trouble;
    std::string     slashed = path;
    std::ranges::replace(slashed, '\\', '/');
    return !std::filesystem::exists(path, trouble) && std::filesystem::exists(slashed, trouble) ? slashed : path;
}

/// The one mesh of an OBJ file, where the file puts it.
Result<Scene> loadObj(const std::string& path, const LoadOptions& options)
{
    Result<ObjImport> import = importObj(path, {.memoryLimit = options.memoryLimit, .progress = options.progress});
    if (!import) return import.error();
    Scene scene;
    scene.name  = path;
    scene.files = std::move(import->libraries);
    scene.files.push_back(path);
    scene.meshes.push_back(std::move(import->mesh));
    scene.instances.push_back({MeshId{0}, Affine{}});
    scene.warnings = std::move(import->warnings);
    Stopwatch     watch;
    Result<Scene> whole = assemble(std::move(scene));
    if (options.times) {
        options.times->readMs += import->readMs;
        options.times->parseMs += import->parseMs;
        options.times->checkMs += watch.lap();
    }
    return whole;
}

Result<Scene> readScene(const std::string& word, const LoadOptions& options)
{
    if (word.starts_with(kBuiltin)) {
        Stopwatch     watch;
        Result<Scene> scene =
            generate(std::string_view(word).substr(kBuiltin.size()), options.memoryLimit, options.progress);
        if (options.times) options.times->parseMs += watch.lap();
        return scene;
    }
    if (hasEnding(word, ".json")) return loadSceneFile(onDisk(word), options);
    if (hasEnding(word, ".obj")) return loadObj(onDisk(word), options);
    return Error{
        Trouble::Usage,
        fmt::format("'{}' is no scene: give a path that ends in .obj or .json, or builtin:NAME", word.substr(0, 200))};
}

}  // namespace

Result<Scene> loadScene(const std::string& word, const LoadOptions& options)
{
    Result<Scene> scene = readScene(word, options);
    if (scene && !options.isPart)
        for (Warning& warning : invisibleMaterials(*scene)) scene->warnings.push_back(std::move(warning));
    return scene;
}

std::span<const SceneEntry> builtinScenes()
{
    static const std::vector<std::string> defaults = [] {
        std::vector<std::string> all;
        for (const Generator& generator : generators()) all.push_back(defaultsOf(generator));
        return all;
    }();
    static const std::vector<SceneEntry> entries = [] {
        std::vector<SceneEntry> all;
        for (const Generator& generator : generators())
            all.push_back({generator.name, generator.title, defaults[all.size()]});
        return all;
    }();
    return entries;
}

}  // namespace zscope
