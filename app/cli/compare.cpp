// zscope-cli compare: algorithms side by side on a sheet, and whether their pictures are the same.
#include <algorithm>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/compare_sheet.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "app/cli/table.h"
#include "app/cli/words.h"
#include "core/frame/shortcuts.h"
#include "core/io/png.h"
#include "core/measure/compare.h"

namespace zscope::cli {
namespace {

struct CompareOptions {
    SceneOption                scene;
    ViewOptions                view;
    std::optional<std::string> algorithms, threads, simd, shortcuts, frames, memoryLimit, sheet;
    bool                       requireEqual = false;
};

bool isPdf(const std::string& path) { return endingOf(path) == ".pdf"; }

/// Everything of the request that does not depend on the scene.
Result<CompareRequest> requestOf(const CompareOptions& options, Session& session)
{
    CompareRequest request;
    request.progress = session.progress();
    if (options.shortcuts) {
        const Result<ShortcutSet> shortcuts = shortcutsOf(*options.shortcuts);
        if (!shortcuts) return shortcuts.error();
        request.shortcuts = *shortcuts;
    }
    if (!options.algorithms)
        return Error{Trouble::Usage, "--algorithms is missing: name two or more, see 'zscope-cli list algorithms'"};
    const auto algorithms = algorithmsToTime(*options.algorithms, request.shortcuts);
    if (!algorithms) return algorithms.error();
    if (algorithms->size() < 2) return Error{Trouble::Usage, "--algorithms wants two or more to compare: A,B[,C...]"};
    for (const NamedPipeline& each : *algorithms) request.algorithms.push_back({each.name, each.pipeline, each.claim});
    if (!options.sheet && !options.requireEqual)
        return Error{Trouble::Usage,
                     "say with -o where the sheet goes, or ask with --require-equal whether the pictures are the same"};
    if (options.sheet && isPdf(*options.sheet) && !kHasPdf)
        return Error{Trouble::Usage, "this build writes no PDF, only PNG: Cairo was not found when it was made"};
    if (options.threads) {
        const Result<int> threads = threadsOf(*options.threads);
        if (!threads) return threads.error();
        request.threads = *threads;
    }
    if (options.simd) {
        const Result<Simd> simd = simdOf(*options.simd);
        if (!simd) return simd.error();
        request.simd = *simd;
    }
    if (options.frames) {
        const auto frames = wholeNumber(*options.frames, "--frames", 1, kMaxFrames);
        if (!frames) return frames.error();
        request.frames = static_cast<int>(*frames);
    }
    if (options.memoryLimit) {
        const auto limit = memoryLimitOf(*options.memoryLimit);
        if (!limit) return limit.error();
        request.memoryLimit = *limit;
    }
    return request;
}

std::string tableOf(const Comparison& comparison)
{
    Table table({{"algorithm", Table::Align::Left},
                 {"median ms"},
                 {"best ms"},
                 {"holes"},
                 {"spills"},
                 {"wrong surface"},
                 {"depth steps"},
                 {"differ from first"},
                 {"depth bits differ"},
                 {"colours differ"},
                 {"", Table::Align::Left}});
    for (const ComparedAlgorithm& a : comparison.algorithms) {
        const ErrorFigures& f = *a.againstReference;
        table.row({a.algorithm.name, fmt::format("{:.3f}", a.report.frameMs), fmt::format("{:.3f}", a.bestMs),
                   grouped(f.holes), grouped(f.spills), grouped(f.wrongSurface()), grouped(f.maxDepthSteps),
                   grouped(a.againstFirst.wrongPixels()), grouped(a.againstFirst.depthBitsDiffer),
                   grouped(a.coloursDiffer), a.isEqualToFirst ? "same picture" : "DIFFERS"});
    }
    return table.text();
}

Result<Done> writeSheet(const std::string& path, const Comparison& comparison, const Scene& scene, const Camera& camera,
                        Session& session)
{
    const SheetWords           words = sheetWordsOf(comparison, scene, camera, session.reproducingCommand());
    std::optional<TextPainter> text;
    if (kHasText) {
        auto opened = TextPainter::open();
        if (!opened) return opened.error();
        text.emplace(std::move(*opened));
    } else {
        session.note(
            "this build was made without FreeType and Fontconfig: the sheet has pictures and bars, but no text");
    }
    if (isPdf(path)) {
        if (!text)
            return Error{Trouble::Output,
                         "a PDF needs letters, and this build was made without FreeType and Fontconfig", path};
        return writePdfSheet(path, comparison, scene, words, *text);
    }
    const Grid<std::uint32_t> sheet = composeSheet(comparison, scene, words, text ? &*text : nullptr);
    if (session.interrupted()) return Error{Trouble::Cancelled, "interrupted"};
    return writePng(path, sheet.view(), reproducingTexts(session.reproducingCommand(), scene.digest),
                    {.cancel = session.cancel()});
}

Result<Exit> compareOnSheet(const CompareOptions& options, Session& session)
{
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    Result<CompareRequest> request = requestOf(options, session);
    if (!request) return request.error();
    const std::vector<Output> outputs{{"-o", options.sheet, {".png", ".pdf"}}};
    if (const auto checked = checkOutputs(outputs, {options.scene.word(), options.view.cameraFile()}); !checked)
        return checked.error();
    const Result<LoadedScene> scene = options.scene.prepare(session, request->memoryLimit);
    if (!scene) return scene.error();
    if (const auto checked = checkOutputs(outputs, scene->scene->files); !checked) return checked.error();
    const auto view = words->of(*scene->scene);
    if (!view) return view.error();
    request->scene       = scene->prepared;
    request->camera      = view->camera;
    request->faceCulling = view->faceCulling;

    const auto comparison = compareAlgorithms(*request);
    if (!comparison) return comparison.error();
    if (options.sheet)
        if (const auto done = writeSheet(*options.sheet, *comparison, *scene->scene, view->camera, session); !done)
            return done.error();
    session.print(tableOf(*comparison));
    return options.requireEqual && !comparison->areAllEqual() ? Exit::CheckFailed : Exit::Done;
}

}  // namespace

Command addCompare(CLI::App& parent)
{
    CLI::App* parser =
        parent.add_subcommand("compare", "Put algorithms side by side: pictures, differences, figures and times");
    auto options = std::make_shared<CompareOptions>();
    options->scene.add(*parser);
    options->view.add(*parser);
    const auto option = [&](const char* name, std::optional<std::string>& value, const char* type, const char* help) {
        parser->add_option(name, value, help)->type_name(type);
    };
    option("--algorithms", options->algorithms, "A,B[,C...]|all",
           "Which algorithms; the others are held against the first");
    option("--threads", options->threads, "N", "How many threads; 0: one per core (default 0)");
    option("--simd", options->simd, "WORD", "Vector instructions, see 'list simd' (default auto)");
    option("--shortcuts", options->shortcuts, "all|none|NAME,...|all-NAME",
           "Which shortcuts draw: see 'list shortcuts'; none: the plain text; same bits (default all)");
    option("--frames", options->frames, "N", "Timed frames of each (default 9)");
    option("--memory-limit", options->memoryLimit, "MIB", "Most memory that may be taken");
    parser->add_flag("--require-equal", options->requireEqual,
                     "Exit with 1 unless all pictures are the same, ids, depth bits and colours; by face where whole "
                     "faces are drawn");
    parser
        ->add_option("-o,--output", options->sheet,
                     "The sheet: a PDF if its name ends in .pdf, a PNG if it ends in .png or has no ending")
        ->type_name("FILE.png|FILE.pdf")
        ->group("Output");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = compareOnSheet(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
