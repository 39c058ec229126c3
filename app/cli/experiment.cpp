#include "app/cli/experiment.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "app/cli/bench_scenes.h"
#include "app/cli/bench_tables.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "app/cli/peers/peer_rows.h"
#include "app/cli/peers/peer_tables.h"
#include "app/cli/words.h"
#include "core/io/file_writer.h"
#include "core/io/read_file.h"
#include "core/measure/path_bench.h"
#include "core/measure/record.h"

namespace zscope::cli {
namespace {

/// At the line of the experiment that asked for it; where it is the line of another file that is wrong, at that one.
Error at(const std::string& file, int line, const Error& error)
{
    if (error.file.empty()) return {Trouble::Input, error.sentence, file, line};
    if (error.line > 0) return {Trouble::Input, error.sentence, error.file, error.line};
    return {Trouble::Input, fmt::format("'{}': {}", error.file, error.sentence), file, line};
}

/// Algorithms, files, names of scenes and their views of all parts are looked up before anything is measured: a
/// misspelt one must not cost an hour.
struct ReadyScene {
    BenchScene                  scene;
    std::vector<BenchAlgorithm> algorithms;  // as those of the part, with the scene's choices
    ViewWords                   view;
};
struct PreparedPart {
    std::vector<ReadyScene>  scenes;  // as those of the part
    std::optional<NamedPath> path;
};

std::optional<Error> whyNotThere(const BenchScene& scene)
{
    constexpr std::string_view kBuiltin = "builtin:";
    if (!scene.word.starts_with(kBuiltin)) {
        if (std::filesystem::exists(scene.word)) return std::nullopt;
        return Error{Trouble::Input, fmt::format("there is no file '{}'", scene.word)};
    }
    const std::string name = scene.word.substr(kBuiltin.size(), scene.word.find('?') - kBuiltin.size());
    if (std::ranges::find(builtinScenes(), name, &SceneEntry::name) != builtinScenes().end()) return std::nullopt;
    return Error{Trouble::Input, fmt::format("there is no builtin scene '{}': see 'zscope-cli list scenes'", name)};
}

/// Those of the part, each with the scene's choices set. They keep their names: the choices belong to the scene.
Result<std::vector<BenchAlgorithm>> algorithmsFor(const ExperimentScene& scene, const ExperimentPart& part,
                                                  const std::string& file)
{
    std::vector<BenchAlgorithm> algorithms;
    for (std::size_t i = 0; i < part.algorithms.size(); ++i) {
        const std::string& word = part.algorithms[i];
        const int          line = scene.choices.empty() ? part.algorithmLines[i] : scene.line;
        std::string        all  = word;
        for (const std::string& choice : scene.choices) all += '+' + choice;
        const auto named = algorithmsToTime(all, part.shortcuts);
        if (!named) return at(file, line, named.error());
        for (const NamedPipeline& each : *named) {
            if (const auto why = explainInvalid(each.pipeline))
                return Error{Trouble::Input, fmt::format("'{}' cannot be drawn: {}", all, *why), file, line};
            algorithms.push_back({scene.choices.empty() ? each.name : word, each.pipeline, each.claim});
        }
    }
    return algorithms;
}

ViewWords viewOf(const ExperimentScene& scene, const ExperimentPart& part)
{
    ViewWords view;
    if (!part.hasSize && scene.width == 0) return view;
    view.given          = {"--size"};
    view.request.width  = scene.width > 0 ? scene.width : part.width;
    view.request.height = scene.width > 0 ? scene.height : part.height;
    return view;
}

Result<PreparedPart> prepare(const ExperimentPart& part, const std::string& file)
{
    PreparedPart prepared;
    for (const ExperimentScene& from : part.scenes) {
        auto algorithms = algorithmsFor(from, part, file);
        if (!algorithms) return algorithms.error();
        const SuiteScene scene{.word        = from.word,
                               .view        = from.view,
                               .title       = from.title,
                               .camera      = from.camera,
                               .model       = from.model,
                               .modelCamera = from.modelCamera};
        auto             named = benchSceneOf(scene, part.faceCulling);
        if (!named) return at(file, from.line, named.error());
        if (auto why = whyNotThere(*named)) return at(file, from.line, *why);
        prepared.scenes.push_back({*std::move(named), *std::move(algorithms), viewOf(from, part)});
    }
    if (part.peers)
        if (const auto there = checkPeers(); !there) return at(file, part.line, there.error());
    if (!part.path.empty()) {
        auto path = cameraPathOf(part.path);
        if (!path) return at(file, part.pathLine, path.error());
        prepared.path = *std::move(path);
    }
    return prepared;
}

}  // namespace

Result<std::vector<BenchRow>> alongPath(const BenchRequest& request, const NamedPath& path)
{
    const auto cameras = camerasOf(path.path, request.scene->bounds, request.camera.width, request.camera.height);
    if (!cameras) return Error{Trouble::Input, cameras.error().sentence, path.file, cameras.error().line};
    return benchPath(request, {.cameras = *cameras, .cuts = path.path.cuts()});
}

namespace {

class ExperimentRun {
public:
    ExperimentRun(const ExperimentOptions& options, Session& session) : m_options(options), m_session(session) {}

    Result<Exit> run()
    {
        const auto text = readRegularFile(m_options.file, kMaxExperimentFile);
        if (!text) return text.error();
        Result<Experiment> read = experimentFromJson(*text, m_options.file);
        if (!read) return read.error();
        m_experiment = *std::move(read);
        for (const ExperimentPart& part : m_experiment.parts) {
            auto prepared = prepare(part, m_options.file);
            if (!prepared) return prepared.error();
            m_parts.push_back(*std::move(prepared));
        }
        if (const auto checked = checkTargets(); !checked) return checked.error();
        if (const auto known = checkBaseline(); !known) return known.error();
        if (const auto known = checkViews(); !known) return known.error();
        if (const auto begun = beginRecord(); !begun) return begun.error();

        for (const ExperimentCase& each : casesOf(m_experiment)) {
            if (!m_options.shard.has(each.index)) continue;
            if (const auto measured = measure(each); !measured) return measured.error();
        }
        // A shard without a case has a record as well: whoever joins them need not know how many cases there are.
        if (m_record.cases.empty())
            if (const auto written = writeRecord(); !written) return written.error();
        return tell();
    }

private:
    Result<Done> checkTargets() const
    {
        std::vector<std::string> inputs;
        for (const PreparedPart& part : m_parts) {
            if (part.path) inputs.push_back(part.path->file);
            for (const ReadyScene& each : part.scenes)
                inputs.insert(inputs.end(), {each.scene.word, each.scene.cameraFile});
        }
        return checkOutputs(outputs(), inputs);
    }
    std::vector<Output> outputs() const { return {{"--json", m_options.json}, {"--csv", m_options.csv}}; }

    Result<Done> checkBaseline() const
    {
        if (m_experiment.baseline.empty()) return Done{};
        std::vector<std::string> drawn;
        for (const PreparedPart& part : m_parts)
            for (const ReadyScene& scene : part.scenes)
                for (const BenchAlgorithm& each : scene.algorithms)
                    if (std::ranges::find(drawn, each.name) == drawn.end()) drawn.push_back(each.name);
        if (std::ranges::find(drawn, m_experiment.baseline) != drawn.end()) return Done{};
        return at(m_options.file, m_experiment.baselineLine, unknownWord("baseline", m_experiment.baseline, drawn));
    }

    /// What views a scene has is known once it is loaded: those with a view that was named are, each once.
    Result<Done> checkViews() const
    {
        std::map<std::string, std::vector<std::string>> viewsOf;
        for (const ExperimentCase& each : casesOf(m_experiment)) {
            const BenchScene& named   = preparedOf(each).scene;
            const bool        isModel = !each.scene->model.empty() && !named.isStandIn;  // its camera is in a file
            if (named.view.empty() || isModel) continue;
            auto known = viewsOf.find(named.word);
            if (known == viewsOf.end()) {
                const auto scene = load(each);
                if (!scene) return scene.error();
                known = viewsOf.emplace(named.word, std::vector<std::string>()).first;
                for (const NamedView& view : (*scene)->views) known->second.push_back(view.name);
            }
            const std::vector<std::string>& views = known->second;
            if (std::ranges::find(views, named.view) != views.end()) continue;
            return Error{Trouble::Input,
                         fmt::format("'{}' has no view '{}': it has {}", named.word, named.view,
                                     views.empty() ? "none" : fmt::format("{}", fmt::join(views, ", "))),
                         m_options.file, each.scene->line};
        }
        return Done{};
    }

    const PreparedPart& partOf(const ExperimentCase& each) const
    {
        return m_parts[static_cast<std::size_t>(each.part - m_experiment.parts.data())];
    }
    static std::size_t numberOf(const ExperimentCase& each)
    {
        return static_cast<std::size_t>(each.scene - each.part->scenes.data());
    }
    const ReadyScene& preparedOf(const ExperimentCase& each) const { return partOf(each).scenes[numberOf(each)]; }

    Result<std::shared_ptr<const Scene>> load(const ExperimentCase& each, LoadTimes* times = nullptr) const
    {
        auto scene = cli::loadScene(preparedOf(each).scene.word, m_session, m_options.memoryLimit, 0, times);
        if (!scene)
            return scene.error().kind != Trouble::Usage ? scene : at(m_options.file, each.scene->line, scene.error());
        if (const auto checked = checkOutputs(outputs(), (*scene)->files); !checked) return checked.error();
        return scene;
    }

    Result<Done> beginRecord()
    {
        m_record.head = recordHeadFor(m_experiment);
        if (!m_options.json || !std::filesystem::exists(*m_options.json)) return Done{};
        const auto text = readRegularFile(*m_options.json, kMaxRecordFile);
        if (!text) return text.error();
        Result<Record> begun = recordFromJson(*text, *m_options.json);
        if (!begun) return begun.error();
        if (const std::string why = whyNotComparable(m_record.head, begun->head); !why.empty())
            return Error{Trouble::Input, fmt::format("this record cannot be gone on with ({}): name another file", why),
                         *m_options.json};
        m_session.note(fmt::format("going on with '{}': {} of {} cases are there", *m_options.json, begun->cases.size(),
                                   m_experiment.caseCount()));
        m_record.cases = std::move(begun->cases);
        return Done{};
    }

    Result<Done> measure(const ExperimentCase& each)
    {
        const PreparedPart& prepared = partOf(each);
        const ReadyScene&   asked    = preparedOf(each);
        const BenchScene&   named    = asked.scene;

        LoadTimes  times;
        const auto scene = load(each, &times);
        if (!scene) return scene.error();
        const std::string pathDigest = prepared.path ? prepared.path->digest : std::string();
        if (const RecordCase* known = m_record.find(each.index)) {
            if (known->sceneDigest != (*scene)->digest)
                return Error{
                    Trouble::Input,
                    fmt::format(
                        "this record was made with another scene '{}': its digest was {} and is {}; name another file",
                        known->scene, known->sceneDigest, (*scene)->digest),
                    m_options.json.value_or("")};
            if (known->pathDigest != pathDigest)
                return Error{Trouble::Input,
                             fmt::format("this record was made along another camera path than '{}': name another file",
                                         each.part->path),
                             m_options.json.value_or("")};
            return Done{};
        }
        if (named.isStandIn)
            m_session.note(fmt::format("'{}' stands in for a model that is not here: {}", named.word, named.title));
        const auto view = named.viewOf(**scene, asked.view);
        if (!view) return view.error();

        const BenchRequest  request{.scene       = *scene,
                                    .camera      = view->camera,
                                    .faceCulling = view->faceCulling,
                                    .algorithms  = asked.algorithms,
                                    .threads     = each.part->threads,
                                    .shortcuts   = each.part->shortcuts,
                                    .frames      = each.part->frames,
                                    .rounds      = each.part->rounds,
                                    .pictures    = picturesOf(*each.part),
                                    .samples     = each.part->samples,
                                    .memoryLimit = m_options.memoryLimit,
                                    .load        = times,
                                    .progress    = m_session.progress()};
        std::vector<Camera> cameras;
        if (prepared.path)
            if (const auto along =
                    camerasOf(prepared.path->path, (*scene)->bounds, view->camera.width, view->camera.height))
                cameras = *along;
        auto rows = prepared.path ? alongPath(request, *prepared.path) : bench(request);
        if (!rows) return rows.error();
        if (each.part->peers) {
            auto others = benchPeers(request);
            if (!others) return others.error();
            std::ranges::move(*others, std::back_inserter(*rows));
        }
        m_record.add({.index       = each.index,
                      .part        = each.part->title,
                      .x           = each.part->x,
                      .scene       = named.nameFor(**scene),
                      .sceneDigest = (*scene)->digest,
                      .place       = each.scene->x.value_or(static_cast<double>(numberOf(each)) + 1),
                      .width       = view->camera.width,
                      .height      = view->camera.height,
                      .pathDigest  = pathDigest,
                      .word        = named.word,
                      .camera      = cameras.empty() ? view->camera : cameras.front(),
                      .faceCulling = view->faceCulling,
                      .rows        = benchToJson(*rows)});
        return writeRecord();
    }

    Result<Done> writeRecord() const
    {
        return m_options.json ? writeFile(*m_options.json, recordToJson(m_record)) : Result<Done>(Done{});
    }

    static BenchPictures picturesOf(const ExperimentPart& part)
    {
        if (!part.shade && part.peers) return BenchPictures::Both;  // each peer draws one of the two
        return part.shade.value_or(true) ? BenchPictures::Shaded : BenchPictures::Unshaded;
    }

    Result<Exit> tell()
    {
        std::vector<BenchRow> all;
        std::string           text = fmt::format("{}\n{}\n", m_experiment.title.english, m_experiment.question.english);
        for (std::size_t i = 0; i < m_record.cases.size();) {
            const ExperimentText& part = m_record.cases[i].part;
            std::vector<BenchRow> rows;
            for (; i < m_record.cases.size() && m_record.cases[i].part == part; ++i) {
                auto read = rowsOf(m_record.cases[i]);
                if (!read) return read.error();
                std::ranges::move(*read, std::back_inserter(rows));
            }
            text += fmt::format("\n{}\n{}", part.english, tableOf(rows));
            std::ranges::move(rows, std::back_inserter(all));
        }
        m_session.print(text);
        if (m_options.csv)
            if (const auto written = writeFile(*m_options.csv, benchToCsv(all)); !written) return written.error();
        return std::ranges::any_of(all, &BenchRow::isBroken) ? Exit::CheckFailed : Exit::Done;
    }

    std::string tableOf(std::span<const BenchRow> rows) const
    {
        if (std::ranges::any_of(rows, isPeer)) return peerTablesOf(rows);
        const std::string table = experimentTableOf(rows, m_experiment.baseline);
        return std::ranges::any_of(rows, [](const BenchRow& row) { return row.series.has_value(); })
                   ? table + "\n" + seriesTableOf(rows)
                   : table;
    }

    const ExperimentOptions&  m_options;
    Session&                  m_session;
    Experiment                m_experiment;
    std::vector<PreparedPart> m_parts;  // as those of the experiment
    Record                    m_record;
};

}  // namespace

Result<Shard> shardOf(const std::string& word)
{
    const std::size_t slash = word.find('/');
    const Error       wrong{Trouble::Usage,
                      fmt::format("--shard is written i/n with 1 <= i <= n, for example 2/4, not '{}'", word)};
    if (slash == std::string::npos) return wrong;
    const auto index = wholeNumber(word.substr(0, slash), "--shard", 1, 1'000'000);
    const auto count = wholeNumber(word.substr(slash + 1), "--shard", 1, 1'000'000);
    if (!index || !count || *index > *count) return wrong;
    return Shard{static_cast<std::size_t>(*index), static_cast<std::size_t>(*count)};
}

Result<Exit> runExperiment(const ExperimentOptions& options, Session& session)
{
    return ExperimentRun(options, session).run();
}

}  // namespace zscope::cli
