// zscope-cli bench: how long algorithms take, on pictures that have been checked first.
#include <algorithm>

#include <fmt/format.h>

#include "app/cli/bench_scenes.h"
#include "app/cli/bench_tables.h"
#include "app/cli/commands.h"
#include "app/cli/experiment.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "app/cli/peers/peer_rows.h"
#include "app/cli/peers/peer_tables.h"
#include "app/cli/words.h"
#include "core/frame/shortcuts.h"
#include "core/io/file_writer.h"
#include "core/measure/bench.h"
#include "core/measure/suites.h"

namespace zscope::cli {
namespace {

struct BenchOptions {
    std::vector<std::string>   scenes;
    ViewOptions                view;
    std::optional<std::string> suite, experiment, shard, algorithms, threads, simd, shortcuts, frames, seconds, rounds,
        memoryLimit, path, sample, json, csv;
    bool noVerify = false, noShade = false, noCount = false, peers = false, ladder = false;
};

constexpr double       kMaxSeconds       = 3'600;
constexpr int          kLadderRounds     = 15;  // if nothing else is said
constexpr std::int64_t kMaxSampledPixels = 100'000'000;
constexpr std::size_t  kWarningsInTables = 0;  // 'info' is the place for them; here they would part the table

/// The suite that was asked for, or nullptr.
Result<const Suite*> suiteOf(const BenchOptions& options)
{
    if (!options.suite) {
        if (options.scenes.empty())
            return Error{Trouble::Usage, "SCENE is missing: name a scene, or a suite with --suite"};
        return nullptr;
    }
    if (const Suite* suite = findSuite(*options.suite)) return suite;
    std::vector<std::string> valid;
    for (const Suite& each : suites()) valid.emplace_back(each.name);
    return unknownWord("suite", *options.suite, valid);
}

BenchPictures picturesOf(const BenchOptions& options, const Suite* suite)
{
    if (options.noShade) return BenchPictures::Unshaded;
    if (options.peers) return BenchPictures::Both;  // each peer draws one of the two
    return suite ? suite->pictures : BenchPictures::Shaded;
}

/// Everything of the request that does not depend on the scene.
Result<BenchRequest> requestOf(const BenchOptions& options, const Suite* suite, Session& session)
{
    BenchRequest request;
    request.verify   = !options.noVerify;
    request.count    = !options.noCount;
    request.pictures = picturesOf(options, suite);
    request.progress = session.progress();

    if (options.shortcuts) {
        const Result<ShortcutSet> shortcuts = shortcutsOf(*options.shortcuts);
        if (!shortcuts) return shortcuts.error();
        request.shortcuts = *shortcuts;
    }
    const std::string byDefault  = suite ? fmt::format("{}", fmt::join(suite->algorithms, ",")) : "all";
    const auto        algorithms = algorithmsToTime(options.algorithms.value_or(byDefault), request.shortcuts);
    if (!algorithms) return algorithms.error();
    for (const NamedPipeline& each : *algorithms) request.algorithms.push_back({each.name, each.pipeline, each.claim});
    if (suite) request.threads.assign(suite->threads.begin(), suite->threads.end());
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
    if (options.ladder) {
        if (options.shortcuts)
            return Error{Trouble::Usage, "--ladder draws with many sets of shortcuts: --shortcuts does not go with it"};
        if (options.path) return Error{Trouble::Usage, "--ladder is climbed on one view, not along a path"};
        if (options.peers) return Error{Trouble::Usage, "--peers have no shortcuts: they do not go with --ladder"};
        std::vector<BenchAlgorithm> rungs;
        for (const BenchAlgorithm& algorithm : request.algorithms) {
            if (algorithm.pipeline.chooser == Chooser::Measured) continue;  // it is one of the others
            const std::vector<BenchAlgorithm> own = ladderOf(algorithm);
            rungs.insert(rungs.end(), own.begin(), own.end());
        }
        if (rungs.empty()) return Error{Trouble::Usage, "--ladder needs an algorithm that is composed, not chosen"};
        request.algorithms = std::move(rungs);
    }
    if (options.frames) {
        const auto frames = wholeNumber(*options.frames, "--frames", 1, kMaxFrames);
        if (!frames) return frames.error();
        request.frames = static_cast<int>(*frames);
    }
    if (options.seconds) {
        const auto seconds = realNumber(*options.seconds, "--seconds");
        if (!seconds) return seconds.error();
        if (*seconds < 0 || *seconds > kMaxSeconds)
            return Error{Trouble::Usage,
                         fmt::format("--seconds is from 0 to {:.0f}, not '{}'", kMaxSeconds, *options.seconds)};
        request.leastMs = *seconds * 1000;
    }
    if (options.rounds) {
        const auto rounds = wholeNumber(*options.rounds, "--rounds", 1, request.frames);
        if (!rounds) return rounds.error();
        request.rounds = static_cast<int>(*rounds);
    } else if (options.ladder) {
        request.rounds = std::min(request.frames, kLadderRounds);
    }
    if (options.memoryLimit) {
        const auto limit = memoryLimitOf(*options.memoryLimit);
        if (!limit) return limit.error();
        request.memoryLimit = *limit;
    }
    return request;
}

/// An experiment says itself what is drawn how: nothing else may.
Result<Exit> benchExperiment(const BenchOptions& options, const ViewWords& words, Session& session)
{
    const bool saysMore = !options.scenes.empty() || !words.given.empty() || words.faceCulling || options.suite
                          || options.algorithms || options.threads || options.simd || options.shortcuts
                          || options.ladder || options.frames || options.seconds || options.rounds || options.path
                          || options.sample || options.peers || options.noVerify || options.noShade || options.noCount;
    if (saysMore)
        return Error{
            Trouble::Usage,
            "an experiment says which scenes are drawn how: only --shard, --memory-limit, --json and --csv go with it"};
    ExperimentOptions experiment{.file = *options.experiment, .json = options.json, .csv = options.csv};
    if (options.shard) {
        const auto shard = shardOf(*options.shard);
        if (!shard) return shard.error();
        experiment.shard = *shard;
    }
    if (options.memoryLimit) {
        const auto limit = memoryLimitOf(*options.memoryLimit);
        if (!limit) return limit.error();
        experiment.memoryLimit = *limit;
    }
    return runExperiment(experiment, session);
}

/// The path that was asked for, if any: it says where the camera is, so little else may.
Result<std::optional<NamedPath>> pathOf(const BenchOptions& options, const ViewWords& words)
{
    if (!options.path) return std::optional<NamedPath>();
    for (const std::string& option : words.given)
        if (option != "--size")
            return Error{
                Trouble::Usage,
                fmt::format("--path says where the camera is: only --size and --cull go with it, not {}", option)};
    if (options.peers) return Error{Trouble::Usage, "--peers are timed on one view, not along a path"};
    if (options.rounds)
        return Error{Trouble::Usage,
                     "--path is travelled as often as the timed frames need: --rounds part the frames of one view"};
    if (options.seconds)
        return Error{Trouble::Usage,
                     "--path is travelled as often as the timed frames need: --seconds are of one view"};
    auto path = cameraPathOf(*options.path);
    if (!path) return path.error();
    return std::optional(*std::move(path));
}

Result<std::optional<std::uint64_t>> samplesOf(const BenchOptions& options)
{
    if (!options.sample) return std::optional<std::uint64_t>();
    if (options.noVerify)
        return Error{Trouble::Usage, "--sample says how much is checked, and --no-verify that nothing is"};
    const auto samples = wholeNumber(*options.sample, "--sample", 1, kMaxSampledPixels);
    if (!samples) return samples.error();
    return std::optional(static_cast<std::uint64_t>(*samples));
}

Result<Exit> benchScenes(const BenchOptions& options, Session& session)
{
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    std::vector<std::string> inputs = options.scenes;
    for (const auto& file : {options.experiment, options.path}) inputs.push_back(file.value_or(""));
    inputs.push_back(options.view.cameraFile());
    const std::vector<Output> outputs{{"--json", options.json}, {"--csv", options.csv}};
    if (const auto checked = checkOutputs(outputs, inputs); !checked) return checked.error();
    if (options.experiment) return benchExperiment(options, *words, session);
    if (options.shard)
        return Error{Trouble::Usage, "--shard parts the cases of an experiment: name one with --experiment"};
    const Result<const Suite*> suite = suiteOf(options);
    if (!suite) return suite.error();
    Result<BenchRequest> request = requestOf(options, *suite, session);
    if (!request) return request.error();

    const auto path = pathOf(options, *words);
    if (!path) return path.error();
    const auto samples = samplesOf(options);
    if (!samples) return samples.error();
    request->samples = *samples;
    // As many passes as the timed frames need.
    if (*path) request->rounds = (request->frames + (*path)->path.frameCount() - 1) / (*path)->path.frameCount();

    if (options.peers) {
        if (const auto there = checkPeers(); !there) return there.error();
        for (const std::string& missing : missingPeers()) session.note(missing);
    }
    const auto scenes = benchScenesOf(options.scenes, *suite);
    if (!scenes) return scenes.error();

    // The peers come last: what their libraries leave in the process may make our later frames longer
    // (docs/performance.md).
    std::vector<std::vector<BenchRow>> rowsOf(scenes->size());
    for (const bool ofPeers : {false, true}) {
        if (ofPeers && !options.peers) break;
        for (std::size_t i = 0; i < scenes->size(); ++i) {
            const BenchScene& each = (*scenes)[i];
            request->load          = {};
            const auto scene =
                cli::loadScene(each.word, session, request->memoryLimit, kWarningsInTables, &request->load);
            if (!scene) return scene.error();
            if (const auto checked = checkOutputs(outputs, (*scene)->files); !checked) return checked.error();
            const auto view = each.viewOf(**scene, *words);
            if (!view) return view.error();
            if (each.isStandIn && !ofPeers)
                session.note(fmt::format("'{}' stands in for a model that is not here: {}", each.word, each.title));
            request->scene                         = *scene;
            request->camera                        = view->camera;
            request->faceCulling                   = view->faceCulling;
            Result<std::vector<BenchRow>> measured = ofPeers ? benchPeers(*request)
                                                     : *path ? alongPath(*request, **path)
                                                             : bench(*request);
            if (!measured) return measured.error();
            for (BenchRow& row : *measured) {
                row.scene = each.nameFor(**scene);
                rowsOf[i].push_back(std::move(row));
            }
        }
    }
    std::vector<BenchRow> rows;
    for (std::vector<BenchRow>& each : rowsOf) std::ranges::move(each, std::back_inserter(rows));
    if (options.csv)
        if (const auto done = writeFile(*options.csv, benchToCsv(rows)); !done) return done.error();
    if (options.json)
        if (const auto done = writeFile(*options.json, benchToJson(rows)); !done) return done.error();
    session.print(options.peers    ? peerTablesOf(rows)
                  : options.ladder ? ladderTableOf(rows)
                  : *suite         ? suiteTableOf(rows)
                                   : benchTableOf(rows));
    if (*path) session.print("\n" + seriesTableOf(rows));
    const auto isWrong = [](const BenchRow& row) { return !isPeer(row) && row.wrongPixels.value_or(0) != 0; };
    return std::ranges::any_of(rows, isWrong) ? Exit::CheckFailed : Exit::Done;
}

}  // namespace

Command addBench(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("bench", "Check algorithms, then time them");
    auto      options = std::make_shared<BenchOptions>();
    parser->add_option("SCENE", options->scenes, "One or more scenes, as for render; with --suite instead of its own")
        ->type_name("");
    options->view.add(*parser);
    const auto option = [&](const char* name, std::optional<std::string>& value, const char* type, const char* help) {
        parser->add_option(name, value, help)->type_name(type);
    };
    option("--suite", options->suite, "NAME", "A named choice of scenes, algorithms and threads, see 'list suites'");
    option("--experiment", options->experiment, "FILE.json",
           "A question written down in a file: its scenes, algorithms and rounds (docs/experiments.md)");
    option("--shard", options->shard, "I/N", "Only every N-th case of the experiment, beginning with the I-th");
    option("--algorithms", options->algorithms, "NAME[,NAME...]|all", "Which algorithms (default all, or the suite's)");
    option("--threads", options->threads, "N[,N...]", "Thread counts; 0: one per core (default 0, or the suite's)");
    option("--simd", options->simd, "WORD[,WORD...]", "Vector instructions, see 'list simd' (default auto)");
    option("--shortcuts", options->shortcuts, "all|none|NAME,...|all-NAME",
           "Which shortcuts draw: see 'list shortcuts'; none: the plain text; same bits (default all)");
    option("--frames", options->frames, "N", "Timed frames of every run (default 30)");
    option("--seconds", options->seconds, "S",
           "Timed frames go on, beyond --frames, until those of a run took S seconds (default 0)");
    option("--rounds", options->rounds, "N",
           "Turns that these frames are parted in, every run after the other in each (default 1)");
    option("--path", options->path, "FILE.json",
           "Move the camera from key frame to key frame, as often as the timed frames need (docs/experiments.md)");
    option("--sample", options->sample, "N", "Check N random pixels of each picture instead of all");
    option("--memory-limit", options->memoryLimit, "MIB", "Most memory that may be taken");
    parser->add_flag("--peers", options->peers, "Time Embree and llvmpipe too, on the same triangles and camera");
    parser->add_flag("--ladder", options->ladder,
                     "Each algorithm with no shortcut, with each alone, with each left out, and with all, in turn");
    parser->add_flag("--no-shade", options->noShade, "Time ids and depth alone, without shading");
    parser->add_flag("--no-count", options->noCount, "Do not count the work behind the times");
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
