#include "tests/homework/homework_support.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

#include "app/cli/scene_export.h"
#include "core/scene/load.h"

namespace zscope::homework_test {

namespace fs = std::filesystem;

namespace {

struct View {
    const char* name;
    const char* scene;  // a builtin word, or a file in scenes/
    int         width, height;
    double      eye[3], target[3];  // equal: as the scene says, or framed
    double      fov;
};
constexpr View kViews[] = {
    {"blocks", "builtin:cubes", 160, 120, {}, {}, 45},
    {"inside", "builtin:cubes", 160, 120, {0.5, 0.6, 2.5}, {0, 0.3, -1}, 70},
    {"close", "builtin:cubes", 160, 120, {0, 1.5, 6}, {0.5, 1, 0}, 45},
    {"soup", "builtin:soup", 160, 120, {}, {}, 45},
    {"odd", "builtin:soup?count=3000", 67, 131, {}, {}, 45},
    {"stars", "stars.obj", 160, 120, {}, {}, 45},
    {"grid", "builtin:hard/A2", 16, 16, {}, {}, 45},
    {"ties", "builtin:hard/C2", 160, 120, {}, {}, 45},
};

template <class T>
T orThrow(Result<T> result)
{
    if (!result) throw std::runtime_error(result.error().text());
    return *std::move(result);
}

ViewRequest requestOf(const View& view, const Scene& scene)
{
    ViewRequest request = scene.views.empty() ? ViewRequest() : scene.views.front().view;
    request.width       = view.width;
    request.height      = view.height;
    if (std::equal(std::begin(view.eye), std::end(view.eye), view.target)) return request;
    request             = {};
    request.width       = view.width;
    request.height      = view.height;
    request.eye         = dvec3(view.eye[0], view.eye[1], view.eye[2]);
    request.target      = dvec3(view.target[0], view.target[1], view.target[2]);
    request.verticalFov = view.fov;
    request.near        = 0.2;
    request.far         = 100;
    return request;
}

}  // namespace

int statusOf(const std::string& command)
{
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000;
}

std::string contentsOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

Task taskNamed(const std::string& name, const fs::path& folder)
{
    const View* view = std::ranges::find(kViews, name, [](const View& each) { return std::string(each.name); });
    if (view == std::end(kViews)) throw std::runtime_error("there is no scene " + name);
    Task       task{.obj = (folder / (name + ".obj")).string(), .camera = (folder / (name + ".json")).string()};
    const bool isFile = std::string_view(view->scene).ends_with(".obj");
    task.scene = orThrow(loadScene(isFile ? ZSCOPE_SOURCE_DIR "/tests/homework/scenes/" + std::string(view->scene)
                                          : std::string(view->scene)));
    if (isFile)  // faces of many corners stay what they are
        fs::copy_file(task.scene.files.at(0), task.obj, fs::copy_options::overwrite_existing);
    else
        orThrow(cli::writeObj(task.scene, task.obj, nullptr));
    task.view = orThrow(makeCamera(requestOf(*view, task.scene), task.scene.bounds));
    std::ofstream(task.camera) << cameraToJson(task.view);
    return task;
}

Dump readDump(const fs::path& file)
{
    const std::string bytes = contentsOf(file);
    std::uint32_t     header[9];
    if (bytes.size() < 8 + sizeof header) return {};
    std::memcpy(header, bytes.data() + 8, sizeof header);
    Dump              dump{.width = header[1], .height = header[2]};
    const std::size_t pixels = std::size_t{dump.width} * dump.height;
    if (bytes.size() != 8 + sizeof header + pixels * 8) return {};
    dump.depth.resize(pixels);
    dump.ids.resize(pixels);
    std::memcpy(dump.depth.data(), bytes.data() + 8 + sizeof header, pixels * 4);
    std::memcpy(dump.ids.data(), bytes.data() + 8 + sizeof header + pixels * 4, pixels * 4);
    return dump;
}

void InAFolder::SetUp()
{
    std::string pattern = (fs::temp_directory_path() / "zscope-homework-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    m_folder = pattern;
}

}  // namespace zscope::homework_test
