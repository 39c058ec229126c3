// zscope-cli explain: why a pixel shows what it shows, or what has become of a triangle.
#include <limits>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/words.h"
#include "core/lesson/explain.h"

namespace zscope::cli {
namespace {

struct ExplainOptions {
    SceneOption                scene;
    ViewOptions                view;
    HowOptions                 how;
    std::optional<std::string> pixel, triangle;
    bool                       json = false;
};

struct AskedAbout {
    std::optional<PixelPosition> pixel;
    std::optional<TriangleId>    triangle;
};

Result<AskedAbout> askedBy(const ExplainOptions& options)
{
    if (options.pixel.has_value() == options.triangle.has_value())
        return usage("say either --pixel X,Y or --triangle ID");
    AskedAbout asked;
    if (options.triangle) {
        const auto id = wholeNumber(*options.triangle, "--triangle", 0, static_cast<std::int64_t>(kMaxTriangles));
        if (!id) return id.error();
        asked.triangle = TriangleId{static_cast<std::uint32_t>(*id)};
        return asked;
    }
    const std::vector<std::string> parts = listOf(*options.pixel);
    if (parts.size() != 2) return usage("--pixel wants two whole numbers: X,Y");
    const auto x = wholeNumber(parts[0], "--pixel", 0, std::numeric_limits<int>::max());
    if (!x) return x.error();
    const auto y = wholeNumber(parts[1], "--pixel", 0, std::numeric_limits<int>::max());
    if (!y) return y.error();
    asked.pixel = PixelPosition{static_cast<int>(*x), static_cast<int>(*y)};
    return asked;
}

template <class Explanation>
Exit shown(const Explanation& explanation, bool json, Session& session)
{
    session.print(json ? explanationToJson(explanation) : explanationToText(explanation));
    return Exit::Done;
}

Result<Exit> explain(const ExplainOptions& options, Session& session)
{
    const Result<AskedAbout> asked = askedBy(options);
    if (!asked) return asked.error();
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    const Result<How> how = options.how.read();
    if (!how) return how.error();
    const Result<LoadedScene> scene = options.scene.prepare(session, how->memoryLimit);
    if (!scene) return scene.error();
    const auto view = words->of(*scene->scene);
    if (!view) return view.error();

    const DrawRequest request = how->request(*scene, *view, session);
    if (asked->pixel) {
        const auto explanation = explainPixel(request, *asked->pixel, session.progress());
        if (!explanation) return explanation.error();
        return shown(*explanation, options.json, session);
    }
    const auto explanation = explainTriangle(request, *asked->triangle, session.progress());
    if (!explanation) return explanation.error();
    return shown(*explanation, options.json, session);
}

}  // namespace

Command addExplain(CLI::App& parent)
{
    CLI::App* parser =
        parent.add_subcommand("explain", "Say why a pixel shows what it shows, or what has become of a triangle");
    auto options = std::make_shared<ExplainOptions>();
    options->scene.add(*parser);
    options->view.add(*parser);
    options->how.add(*parser, HowOptions::Algorithms::One);
    parser
        ->add_option("--pixel", options->pixel,
                     "Every triangle that meets this pixel, 0,0 is the top left, and what became of it")
        ->type_name("X,Y");
    parser->add_option("--triangle", options->triangle, "What became of this triangle, and who took its pixels")
        ->type_name("ID");
    parser->add_flag("--json", options->json, "JSON instead of text");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = explain(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
