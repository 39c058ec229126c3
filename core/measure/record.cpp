#include "core/measure/record.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/frame/faults.h"
#include "core/io/json_document.h"
#include "core/measure/strict_json.h"

namespace zscope {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kForm = 1;

Json toJson(const ExperimentText& text) { return {{"en", text.english}, {"zh_CN", text.chinese}}; }

ExperimentText textOf(const Json& json)
{
    return {json.at("en").get<std::string>(), json.at("zh_CN").get<std::string>()};
}

/// From JSON; knows which case it was reading when an exception ends it.
class RecordReader {
public:
    Record read(const Json& json)
    {
        Record      record;
        RecordHead& head       = record.head;
        const Json& experiment = json.at("experiment");
        head.title             = textOf(experiment.at("title"));
        head.question          = textOf(experiment.at("question"));
        experiment.at("baseline").get_to(head.baseline);
        experiment.at("digest").get_to(head.digest);
        json.at("program").at("version").get_to(head.version);
        json.at("program").at("compiler").get_to(head.compiler);
        json.at("machine").at("processor").get_to(head.processor);
        head.cores        = wholeOf<unsigned>(json.at("machine").at("cores"));
        head.caseCount    = wholeOf<std::size_t>(json.at("case_count"), 1, kMaxCases);
        const Json& cases = listOf(json.at("cases"));
        for (m_case = 0; *m_case < cases.size(); ++*m_case) {
            RecordCase one = caseOf(cases[*m_case], head.caseCount);
            if (record.find(one.index)) throw Json::other_error::create(501, "the same case twice", &cases[*m_case]);
            record.add(std::move(one));
        }
        return record;
    }

    /// Why it has stopped, where it knows.
    const std::string& trouble() const { return m_trouble; }
    /// And where, in the text.
    int line(const std::string& text) const
    {
        const Result<JsonValue> whole = parseJson(text, {});
        const auto*             top   = whole ? whole->object() : nullptr;
        if (!top) return 0;
        const auto  cases = std::ranges::find(*top, "cases", &JsonMember::first);
        const auto* list  = cases == top->end() ? nullptr : cases->second.array();
        return m_case && list && *m_case < list->size() ? (*list)[*m_case].line : whole->line;
    }

private:
    RecordCase caseOf(const Json& json, std::size_t caseCount)
    {
        RecordCase one{.index       = wholeOf<std::size_t>(json.at("index"), 0, caseCount - 1),
                       .part        = textOf(json.at("part")),
                       .x           = textOf(json.at("x")),
                       .scene       = json.at("scene").get<std::string>(),
                       .sceneDigest = json.at("scene_digest").get<std::string>(),
                       .place       = json.at("place").get<double>(),
                       .width       = wholeOf(json.at("width"), 1, kMaxPictureSide),
                       .height      = wholeOf(json.at("height"), 1, kMaxPictureSide),
                       .pathDigest  = json.value("path_digest", std::string()),
                       .rows        = json.at("rows").dump()};
        if (const auto rows = rowsOf(one); !rows) {
            m_trouble = rows.error().sentence;
            throw Json::other_error::create(501, "no rows", &json);
        }
        if (json.contains("word")) {  // older records have no view
            one.word          = json.at("word").get<std::string>();
            one.faceCulling   = json.at("cull") == "back" ? FaceCulling::Back : FaceCulling::None;
            const auto camera = cameraFromJson(json.at("camera").dump(), "record");
            if (!camera) throw Json::other_error::create(501, "no camera", &json);
            one.camera = *camera;
        }
        return one;
    }

    std::optional<std::size_t> m_case;
    std::string                m_trouble = "something is missing in this record, or is not what it should be";
};

}  // namespace

std::string processorName()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

RecordHead recordHeadFor(const Experiment& experiment)
{
    return {.title     = experiment.title,
            .question  = experiment.question,
            .baseline  = experiment.baseline,
            .digest    = experiment.digest,
            .version   = ZSCOPE_VERSION,
            .compiler  = __VERSION__,
            .processor = processorName(),
            .cores     = std::thread::hardware_concurrency(),
            .caseCount = experiment.caseCount()};
}

std::string whyNotComparable(const RecordHead& a, const RecordHead& b)
{
    const auto differ = [](std::string_view what, const auto& one, const auto& other) {
        return one == other ? std::string() : fmt::format("{} differs: {} and {}", what, one, other);
    };
    if (a.digest != b.digest)
        return fmt::format("they answer different questions: '{}' and '{}'", a.title.english, b.title.english);
    for (const std::string& why :
         {differ("the program's version", a.version, b.version), differ("its compiler", a.compiler, b.compiler),
          differ("the processor", a.processor, b.processor), differ("the number of cores", a.cores, b.cores),
          differ("the number of cases", a.caseCount, b.caseCount)})
        if (!why.empty()) return why;
    return {};
}

const RecordCase* Record::find(std::size_t index) const
{
    const auto found = std::ranges::lower_bound(cases, index, {}, &RecordCase::index);
    return found == cases.end() || found->index != index ? nullptr : &*found;
}

void Record::add(RecordCase measured)
{
    const auto place = std::ranges::lower_bound(cases, measured.index, {}, &RecordCase::index);
    cases.insert(place, std::move(measured));
}

std::string recordToJson(const Record& record)
{
    const RecordHead& head  = record.head;
    Json              cases = Json::array();
    for (const RecordCase& each : record.cases) {
        Json one{{"index", each.index},
                 {"part", toJson(each.part)},
                 {"scene", each.scene},
                 {"x", toJson(each.x)},
                 {"place", each.place},
                 {"scene_digest", each.sceneDigest},
                 {"path_digest", each.pathDigest},
                 {"width", each.width},
                 {"height", each.height},
                 {"rows", Json::parse(each.rows)}};
        if (!each.word.empty()) {
            one["word"]   = each.word;
            one["cull"]   = each.faceCulling == FaceCulling::Back ? "back" : "none";
            one["camera"] = Json::parse(cameraToJson(each.camera));
        }
        cases.push_back(std::move(one));
    }
    const Json all{{"record", kForm},
                   {"experiment",
                    {{"title", toJson(head.title)},
                     {"question", toJson(head.question)},
                     {"baseline", head.baseline},
                     {"digest", head.digest}}},
                   {"program", {{"version", head.version}, {"compiler", head.compiler}}},
                   {"machine", {{"processor", head.processor}, {"cores", head.cores}}},
                   {"case_count", head.caseCount},
                   {"cases", std::move(cases)}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<Record> recordFromJson(const std::string& text, const std::string& file)
{
    RecordReader reader;
    try {
        // Text is made of values again, level by level of the stack: what lies too deep for that is left out, and
        // refused.
        bool       isTooDeep = false;
        const Json json      = Json::parse(text, [&isTooDeep](int depth, Json::parse_event_t, const Json&) {
            isTooDeep = isTooDeep || depth > kMaxJsonDepth;
            return depth <= kMaxJsonDepth;
        });
        if (isTooDeep) return parseJson(text, file).error();
        // this parser would take it for the end
        if (text.find('\0') != std::string::npos) return parseJson(text, file).error();
        if (!json.is_object() || !json.contains("record"))
            return Error{Trouble::Input, "this is no record of an experiment: 'bench --experiment' makes them", file,
                         1};
        if (json.at("record") != kForm)
            return Error{Trouble::Input, "this record has a form that this version does not know", file,
                         reader.line(text)};
        return reader.read(json);
    } catch (const Json::parse_error&) {
        return parseJson(text, file).error();
    } catch (const Json::exception&) {
        return Error{Trouble::Input, reader.trouble(), file, reader.line(text)};
    }
}

Result<Record> joined(std::span<const NamedRecord> records)
{
    Record             all   = records.front().record;
    const std::string& first = records.front().file;
    for (const NamedRecord& other : records.subspan(1)) {
        if (const std::string why = whyNotComparable(all.head, other.record.head); !why.empty())
            return Error{Trouble::Input, fmt::format("this record cannot be joined with '{}': {}", first, why),
                         other.file};
        for (const RecordCase& each : other.record.cases) {
            const RecordCase* known = all.find(each.index);
            if (!known) {
                all.add(each);
            } else if (known->sceneDigest != each.sceneDigest) {
                return Error{Trouble::Input,
                             fmt::format("its scene '{}' is not the one of '{}': their digests are {} and {}",
                                         each.scene, first, each.sceneDigest, known->sceneDigest),
                             other.file};
            } else if (known->pathDigest != each.pathDigest) {
                return Error{Trouble::Input,
                             fmt::format("its camera path for '{}' is not the one of '{}'", each.scene, first),
                             other.file};
            }
        }
    }
    return all;
}

std::optional<Pipeline> pipelineNamed(std::string_view name)
{
    const Preset* preset = findPreset(name.substr(0, name.find('+')));
    if (!preset) return std::nullopt;
    Pipeline pipeline = preset->pipeline;
    for (std::size_t plus = name.find('+'); plus != std::string_view::npos;) {
        const std::size_t      next    = name.find('+', plus + 1);
        const std::string_view setting = name.substr(plus + 1, next == std::string_view::npos ? next : next - plus - 1);
        const std::size_t      equals  = setting.find('=');
        if (equals == std::string_view::npos) return std::nullopt;
        const std::string_view axis = setting.substr(0, equals), choice = setting.substr(equals + 1);
        if (axis == "fault") {
            const FaultEntry* fault = findFault(choice);
            if (!fault) return std::nullopt;
            pipeline.fault.add(fault->fault);
        } else {
            const Result<Pipeline> with = withChoice(pipeline, axis, choice);
            if (!with) return std::nullopt;
            pipeline = *with;
        }
        plus = next;
    }
    return pipeline;
}

Result<std::vector<BenchRow>> rowsOf(const RecordCase& measured)
{
    auto rows = benchFromJson(measured.rows);
    if (!rows)
        return Error{Trouble::Input, fmt::format("the rows of '{}' are not those of a benchmark", measured.scene)};
    for (BenchRow& row : *rows) row.scene = measured.scene;
    return rows;
}

}  // namespace zscope
