// zscope-cli bench: how long algorithms take, on pictures that have been checked first.
#include <algorithm>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/table.h"
#include "app/cli/words.h"
#include "core/io/file_writer.h"
#include "core/measure/bench.h"

namespace zscope::cli {
namespace {

struct BenchOptions {
    std::vector<std::string>   scenes;
    ViewOptions                view;
    std::optional<std::string> algorithms, threads, simd, frames, memoryLimit, json, csv;
    bool                       noVerify = false;
};

constexpr std::int64_t kMaxFrames     = 1'000'000;
constexpr std::size_t  kWarningsShown = 0;  // 'info' is the place for them; here they would part the table

/// Everything of the request that does not depend on the scene.
Result<BenchRequest> requestOf(const BenchOptions& options, Session& session)
{
    BenchRequest request;
    request.verify   = !options.noVerify;
    request.progress = session.progress();

    const auto algorithms = algorithmsOf(options.algorithms.value_or("all"));
    if (!algorithms) return algorithms.error();
    for (const NamedPipeline& each : *algorithms) request.algorithms.push_back({each.name, each.pipeline, each.claim});
    if (options.threads) {
        request.threads.clear();
        for (const std::string& word : listOf(*options.threads)) {
            const Result<int> threads = threadsOf(word);
            if (!threads) return threads.error();
            request.threads.push_back(*threads);
        }
    }
    if (options.simd) {
        request.simd.clear();
        for (const std::string& word : listOf(*options.simd)) {
            const Result<Simd> simd = simdOf(word);
            if (!simd) return simd.error();
            request.simd.push_back(*simd);
        }
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

std::string tableOf(const std::vector<BenchRow>& rows)
{
    Table table({{"scene", Table::Align::Left}, {"algorithm", Table::Align::Left}, {"threads"},
                 {"simd", Table::Align::Left}, {"picture", Table::Align::Left}, {"best ms"}, {"median"}, {"q1"}, {"q3"},
                 {"transform"}, {"setup"}, {"build"}, {"raster"}, {"shade"}});
    for (const BenchRow& row : rows) {
        const auto        ms      = [](double value) { return fmt::format("{:.3f}", value); };
        const auto        stage   = [&](Stage s) { return ms(row.stageMs[static_cast<std::size_t>(s)]); };
        const std::string picture = !row.wrongPixels        ? "not checked"
                                    : *row.wrongPixels == 0 ? "verified"
                                                            : fmt::format("{} wrong", *row.wrongPixels);
        table.row({row.scene, row.algorithm, std::to_string(row.threads), std::string(wordOf(row.simd)), picture,
                   ms(row.bestMs), ms(row.medianMs), ms(row.q1Ms), ms(row.q3Ms), stage(Stage::Transform),
                   stage(Stage::Setup), stage(Stage::Build), stage(Stage::Raster), stage(Stage::Shade)});
    }
    return table.text();
}

Result<Exit> benchScenes(const BenchOptions& options, Session& session)
{
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    Result<BenchRequest> request = requestOf(options, session);
    if (!request) return request.error();

    std::vector<BenchRow> rows;
    for (const std::string& word : options.scenes) {
        const auto scene = cli::loadScene(word, session, request->memoryLimit, kWarningsShown);
        if (!scene) return scene.error();
        const auto view = words->of(**scene);
        if (!view) return view.error();
        request->scene       = *scene;
        request->camera      = view->camera;
        request->faceCulling = view->faceCulling;
        Result<std::vector<BenchRow>> measured = bench(*request);
        if (!measured) return measured.error();
        rows.insert(rows.end(), measured->begin(), measured->end());
    }
    if (options.csv)
        if (const auto done = writeFile(*options.csv, benchToCsv(rows)); !done) return done.error();
    if (options.json)
        if (const auto done = writeFile(*options.json, benchToJson(rows)); !done) return done.error();
    session.print(tableOf(rows));
    const auto isWrong = [](const BenchRow& row) { return row.wrongPixels.value_or(0) != 0; };
    return std::ranges::any_of(rows, isWrong) ? Exit::CheckFailed : Exit::Done;
}

}  // namespace

Command addBench(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("bench", "Check algorithms, then time them");
    auto      options = std::make_shared<BenchOptions>();
    parser->add_option("SCENE", options->scenes, "One or more scenes, as for render")->type_name("")->required();
    options->view.add(*parser);
    const auto option = [&](const char* name, std::optional<std::string>& value, const char* type, const char* help) {
        parser->add_option(name, value, help)->type_name(type);
    };
    option("--algorithms", options->algorithms, "NAME[,NAME...]|all", "Which algorithms (default all)");
    option("--threads", options->threads, "N[,N...]", "Thread counts (default: one per core)");
    option("--simd", options->simd, "WORD[,WORD...]", "Vector instructions, see 'list simd' (default auto)");
    option("--frames", options->frames, "N", "Timed frames of every run (default 30)");
    option("--memory-limit", options->memoryLimit, "MIB", "Most memory that may be taken");
    parser->add_flag("--no-verify", options->noVerify, "Do not compare the pictures with the reference first");
    parser->add_option("--csv", options->csv, "The table as CSV")->type_name("FILE.csv")->group("Output");
    parser->add_option("--json", options->json, "The table with stages and counters, JSON")
        ->type_name("FILE.json")
        ->group("Output");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = benchScenes(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
