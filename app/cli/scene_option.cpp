#include "app/cli/options.h"

#include "core/scene/load.h"

namespace zscope::cli {
namespace {

/// A damaged file can have as many warnings as faces; drawing it shows these and counts the rest.
constexpr std::size_t kWarningsShown = 20;

}  // namespace

Result<std::shared_ptr<const Scene>> loadScene(const std::string& word, Session& session, std::uint64_t memoryLimit,
                                               std::size_t warningsShown, LoadTimes* times)
{
    Result<Scene> scene = zscope::loadScene(
        word, LoadOptions{.memoryLimit = memoryLimit, .progress = session.progress(), .times = times});
    if (!scene) {
        // A path of any kind is an input, whether or not it looks like a scene; a misspelt generator is a wrong word.
        Error error = scene.error();
        if (error.kind == Trouble::Usage && !word.starts_with("builtin:")) error.kind = Trouble::Input;
        return error;
    }
    session.warn(scene->warnings, warningsShown);
    return std::make_shared<const Scene>(*std::move(scene));
}

void SceneOption::add(CLI::App& parser)
{
    parser.add_option("SCENE", m_word, "An .obj file, a scene .json file, or builtin:NAME[?key=value&...]")
        ->type_name("")
        ->required();
}

Result<std::shared_ptr<const Scene>> SceneOption::load(Session& session, std::uint64_t memoryLimit) const
{
    return cli::loadScene(m_word, session, memoryLimit, kWarningsShown);
}

Result<LoadedScene> SceneOption::prepare(Session& session, std::uint64_t memoryLimit) const
{
    const auto scene = load(session, memoryLimit);
    if (!scene) return scene.error();
    if (session.interrupted()) return Error{Trouble::Cancelled, "interrupted"};
    return LoadedScene{*scene, std::make_shared<const PreparedScene>(*scene)};
}

}  // namespace zscope::cli
