// zscope-cli check: what another program drew, judged against the reference, with likely causes of what is wrong.
#include <algorithm>
#include <filesystem>

#include "app/cli/check_output.h"
#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "app/cli/words.h"
#include "core/check/report.h"
#include "core/io/file_writer.h"
#include "core/io/read_file.h"

namespace zscope::cli {
namespace {

struct CheckOptions {
    SceneOption                scene;
    std::optional<std::string> camera, matrix, size;
    std::optional<std::string> depth, ids, picture, dump, trace, algorithm;
    std::optional<std::string> depthIs, rows, idsAre, idsFrom, cull, subpixelBits;
    std::optional<std::string> report, junit, gradescope;
    bool                       doesNotDiagnose = false;
    bool                       json            = false;
};

/// One of a few words, or nothing if none was given.
template <class Value>
Result<Done> choose(const std::optional<std::string>& word, const char* option, std::optional<Value>& into,
                    const std::vector<std::pair<std::string_view, Value>>& choices)
{
    if (!word) return Done{};
    std::vector<std::string> valid;
    for (const auto& [name, value] : choices) {
        if (name == *word) {
            into = value;
            return Done{};
        }
        valid.emplace_back(name);
    }
    return unknownWord(std::string("choice of ") + option, *word, valid);
}

Result<Done> readConventions(const CheckOptions& options, check::CheckRequest& request)
{
    std::vector<std::pair<std::string_view, check::DepthMeaning>> meanings;
    for (const check::DepthMeaning meaning : check::kDepthMeanings)
        meanings.emplace_back(check::wordOf(meaning), meaning);
    check::Conventions& given = request.given;
    for (const Result<Done>& done :
         {choose(options.depthIs, "--depth-is", given.depth, meanings),
          choose<check::Rows>(options.rows, "--rows", given.rows,
                              {{"top-down", check::Rows::TopDown}, {"bottom-up", check::Rows::BottomUp}}),
          choose<check::IdKind>(options.idsAre, "--ids-are", given.ids,
                                {{"triangles", check::IdKind::Triangles}, {"faces", check::IdKind::Faces}}),
          choose<int>(options.idsFrom, "--ids-from", given.idsFrom, {{"0", 0}, {"1", 1}}),
          choose<FaceCulling>(options.cull, "--cull", given.cull,
                              {{"none", FaceCulling::None}, {"back", FaceCulling::Back}})})
        if (!done) return done.error();
    if (!options.subpixelBits) return Done{};
    const auto bits = wholeNumber(*options.subpixelBits, "--subpixel-bits", 1, 24);
    if (!bits) return bits.error();
    request.subpixelBits = static_cast<int>(*bits);
    return Done{};
}

/// `ofScene` is filled where the scene's own view is meant.
Result<Done> readCamera(const CheckOptions& options, check::CheckRequest& request, std::optional<ViewWords>& ofScene)
{
    if (options.camera && options.matrix) return usage("--camera and --matrix say the same: give one of them");
    if (options.camera && options.size) return usage("--camera sets all ten numbers and cannot be mixed with --size");
    if (options.matrix && !options.size) return usage("--matrix says nothing of the picture's size: add --size");
    if (!options.camera && !options.size && !options.dump)
        return usage("say what the picture was seen with: --camera, --matrix, --dump, or --size for the scene's view");
    if (options.size) {
        const auto size = pictureSize(*options.size, "--size");
        if (!size) return size.error();
        ViewRequest view;  // refuses the sizes that any other command refuses
        view.width = size->width, view.height = size->height;
        Bounds anyBox;
        anyBox.include({-1, -1, -1});
        anyBox.include({1, 1, 1});
        if (const Result<Camera> possible = makeCamera(view, anyBox); !possible) return possible.error();
        request.matrix = options.matrix;
        request.width = size->width, request.height = size->height;
        if (!options.matrix) ofScene = ViewWords{.request = view, .given = {"--size"}, .faceCulling = {}};
    }
    if (options.camera) {
        const Result<std::string> text = readRegularFile(*options.camera, kMaxCameraFile);
        if (!text) return text.error();
        const Result<Camera> camera = cameraFromJson(*text, *options.camera);
        if (!camera) return camera.error();
        request.camera = *camera;
    }
    return Done{};
}

Result<Exit> checkFiles(const CheckOptions& options, Session& session)
{
    const bool hasPicture = options.depth || options.ids || options.picture || options.dump;
    if (!hasPicture && !options.trace)
        return Error{Trouble::Usage, "say what is to be checked: --depth, --ids, --picture, --dump or --trace"};
    if (options.report && !hasPicture)
        return Error{Trouble::Usage, "--report shows pictures: add --depth, --ids, --picture or --dump"};
    if (options.algorithm && !options.trace) return Error{Trouble::Usage, "--algorithm belongs to --trace"};
    if (options.algorithm && !findPreset(*options.algorithm)) {
        std::vector<std::string> names;
        for (const Preset& preset : presets()) names.emplace_back(preset.name);
        return unknownWord("algorithm", *options.algorithm, names);
    }
    std::vector<Output> outputs{{"--junit", options.junit, {".xml"}}, {"--gradescope", options.gradescope, {".json"}}};
    std::vector<std::string> inputs{options.scene.word()};
    for (const auto& file :
         {options.camera, options.matrix, options.depth, options.ids, options.picture, options.dump, options.trace})
        if (file) inputs.push_back(*file);
    if (const auto done = checkOutputs(outputs, inputs); !done) return done.error();

    check::CheckRequest request;
    if (const auto done = readConventions(options, request); !done) return done.error();
    std::optional<ViewWords> ofScene;
    if (const auto done = readCamera(options, request, ofScene); !done) return done.error();
    if (options.report) {
        if (const auto done = check::makeFolder(*options.report); !done) return done.error();
        outputs.push_back({"--report", (std::filesystem::path(*options.report) / check::kReportFile).string()});
        if (const auto done = checkOutputs(outputs, inputs); !done) return done.error();
    }
    request.depth     = options.depth;
    request.ids       = options.ids;
    request.picture   = options.picture;
    request.dump      = options.dump;
    request.diagnoses = !options.doesNotDiagnose;
    request.progress  = session.progress();

    std::optional<check::Trace> trace;
    std::optional<Pipeline>     pipeline;
    if (options.trace) {
        auto read = check::readTrace(*options.trace);
        if (!read) return read.error();
        trace           = *std::move(read);
        const auto with = check::traceAlgorithm(*trace, options.algorithm);
        if (!with) return with.error();
        pipeline = *with;
    }
    const Result<LoadedScene> scene = options.scene.prepare(session, 0);
    if (!scene) return scene.error();
    if (const auto done = checkOutputs(outputs, scene->scene->files); !done) return done.error();
    if (ofScene) {
        const auto view = ofScene->of(*scene->scene);
        if (!view) return view.error();
        request.camera = view->camera;
    }
    check::Checker                    checker(scene->prepared);
    std::optional<check::CheckAnswer> picture;
    if (hasPicture) {
        auto answer = checker.check(request);
        if (!answer) return answer.error();
        picture            = *std::move(answer);
        request.camera     = picture->camera;
        request.given.cull = picture->conventions.cull;
    }
    std::optional<check::TraceAnswer> traced;
    if (trace) {
        auto answer = checker.checkTrace(request, *trace, *pipeline);
        if (!answer) return answer.error();
        traced = *std::move(answer);
    }
    const Judged judged{picture ? &*picture : nullptr, traced ? &*traced : nullptr, trace ? &*trace : nullptr};

    session.print(options.json ? textOf(cli::jsonOf(judged)) : textOf(judged));
    if (options.report)
        if (const auto path = check::writeReport(*picture, session.reproducingCommand(), *options.report,
                                                 {judged.trace, judged.rows});
            !path)
            return path.error();
    if (options.junit)
        if (const auto done = writeFile(*options.junit, junitOf(judged, scene->scene->name)); !done)
            return done.error();
    if (options.gradescope)
        if (const auto done = writeFile(*options.gradescope, gradescopeOf(judged, scene->scene->name)); !done)
            return done.error();
    return judged.isRight() ? Exit::Done : Exit::CheckFailed;
}

}  // namespace

Command addCheck(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("check", "Judge what another program drew, and name likely causes");
    auto      options = std::make_shared<CheckOptions>();
    options->scene.add(*parser);
    const auto option = [&](const char* name, std::optional<std::string>& value, const char* type, const char* help,
                            const char* group) {
        parser->add_option(name, value, help)->type_name(type)->group(group);
    };
    option("--camera", options->camera, "FILE", "All ten numbers of the camera from a JSON file", "View");
    option("--matrix", options->matrix, "FILE", "View and projection as 4x4 matrices from a JSON file", "View");
    option("--size", options->size, "WxH", "Size of the picture in pixels: with --matrix, or of the scene's own view",
           "View");
    option("--depth", options->depth, "FILE", "Depth: .npy, .pfm, .png of 16 bits, or .raw", "Files");
    option("--ids", options->ids, "FILE", "Ids of triangles or faces: .npy, .png (colour = id + 1), or .raw", "Files");
    option("--picture", options->picture, "FILE", "A picture: .png, .bmp or .ppm; only coverage is judged", "Files");
    option("--dump", options->dump, "FILE", "All of it in one file, as zscope_dump.h writes it", "Files");
    option("--trace", options->trace, "FILE", "Its steps, as JSON lines with the fields that step --state writes",
           "Files");
    option("--algorithm", options->algorithm, "NAME",
           "What the trace is held against; by default what it names, or what has its fields", "Files");
    const char* conventions = "Conventions (what is not given is found out)";
    option("--depth-is", options->depthIs, "WORD", "near/z, z, distance, ndc, window, window-reversed or linear",
           conventions);
    option("--rows", options->rows, "top-down|bottom-up", "Which row comes first", conventions);
    option("--ids-are", options->idsAre, "triangles|faces", "What ids number", conventions);
    option("--ids-from", options->idsFrom, "0|1", "Number of the first triangle or face", conventions);
    option("--cull", options->cull, "none|back", "Faces that are not drawn", conventions);
    option("--subpixel-bits", options->subpixelBits, "N", "Corners are snapped to 1/2^N pixel (default 8)",
           conventions);
    parser->add_flag("--no-diagnose", options->doesNotDiagnose, "Look for no causes");
    parser->add_flag("--json", options->json, "JSON instead of text");
    option("--report", options->report, "DIR", "Also write a page with pictures into this folder: report.html",
           "Reports");
    option("--junit", options->junit, "FILE.xml", "Also write a JUnit report", "Reports");
    option("--gradescope", options->gradescope, "FILE.json", "Also write results as Gradescope reads them", "Reports");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = checkFiles(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
