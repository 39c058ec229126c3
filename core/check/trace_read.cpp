// Reading a trace: what each row says of its moment, and that its fields are those of a state.
#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/base/quotable.h"
#include "core/check/trace.h"
#include "core/io/json_document.h"
#include "core/io/read_file.h"
#include "core/io/text_encoding.h"

namespace zscope::check {
namespace {

constexpr std::array kFields{std::string_view("algorithm"),
                             std::string_view("grain"),
                             std::string_view("step"),
                             std::string_view("count"),
                             std::string_view("sentence"),
                             std::string_view("event"),
                             std::string_view("stage"),
                             std::string_view("source"),
                             std::string_view("line"),
                             std::string_view("active_edges"),
                             std::string_view("active_polygons"),
                             std::string_view("spans"),
                             std::string_view("entered"),
                             std::string_view("left"),
                             std::string_view("nodes"),
                             std::string_view("node"),
                             std::string_view("pass"),
                             std::string_view("query"),
                             std::string_view("update"),
                             std::string_view("pyramid"),
                             std::string_view("triangle"),
                             std::string_view("interval"),
                             std::string_view("span"),
                             std::string_view("tile"),
                             std::string_view("pixel"),
                             std::string_view("blend")};
constexpr std::array kListFields{std::string_view("active_edges"), std::string_view("active_polygons"),
                                 std::string_view("spans"),        std::string_view("entered"),
                                 std::string_view("left"),         std::string_view("nodes")};
constexpr std::array kObjectFields{
    std::string_view("query"),    std::string_view("update"),   std::string_view("pyramid"),
    std::string_view("triangle"), std::string_view("interval"), std::string_view("span"),
    std::string_view("tile"),     std::string_view("pixel"),    std::string_view("blend")};
/// Of the objects in lists, and of the edges among them.
constexpr std::array kEdgeFields{std::string_view("polygon"),     std::string_view("x"),
                                 std::string_view("x_subpixels"), std::string_view("dx"),
                                 std::string_view("first_line"),  std::string_view("last_line")};
constexpr std::array kSpanFields{std::string_view("x0"), std::string_view("x1"), std::string_view("polygon")};

template <class Names>
bool isOneOf(std::string_view name, const Names& names)
{
    return std::ranges::find(names, name) != names.end();
}

const JsonValue* find(const JsonValue::Object& object, std::string_view name)
{
    const auto found = std::ranges::find(object, name, &JsonMember::first);
    return found == object.end() ? nullptr : &found->second;
}

constexpr std::int64_t kLeast = -(std::int64_t{1} << 40), kMost = std::int64_t{1} << 40;

class RowReader {
public:
    RowReader(const std::string& file, const JsonValue::Object& row) : m_file(file), m_row(row) {}

    std::optional<Error> checkFields() const
    {
        for (const auto& [name, value] : m_row) {
            if (!isOneOf(name, kFields))
                return wrong(value, fmt::format("'{}' is no field of a step's state", quotable(name)));
            if (isOneOf(name, kListFields)) {
                if (!value.array()) return wrong(value, fmt::format("'{}' must be a list", name));
                if (const auto trouble = checkItems(name, *value.array())) return trouble;
            }
            const bool mayBeNull = name == "query" || name == "update";
            if (isOneOf(name, kObjectFields) && !value.object()
                && !(mayBeNull && std::holds_alternative<std::monostate>(value.value)))
                return wrong(value, fmt::format("'{}' must be an object", name));
        }
        return std::nullopt;
    }

    Result<MomentKey> key() const
    {
        const JsonValue *grain = find(m_row, "grain"), *step = find(m_row, "step");
        if (grain && step) {
            const std::string*         word  = grain->text();
            const std::optional<Grain> known = word ? grainOf(*word) : std::nullopt;
            if (!known) return wrong(*grain, "'grain' must be a grain: see zscope-cli list grains");
            const auto number = wholeOf(*step, m_file, "step", 0, kMost);
            if (!number) return number.error();
            return MomentKey{MomentKind::Step, static_cast<std::int64_t>(*known), *number};
        }
        struct Form {
            MomentKind                      kind;
            std::string_view                field;
            std::array<std::string_view, 3> members;
        };
        constexpr std::array<Form, 5> kForms{{{MomentKind::Pixel, "pixel", {"x", "y", "triangle"}},
                                              {MomentKind::Query, "query", {"triangle"}},
                                              {MomentKind::Update, "update", {"level", "x", "y"}},
                                              {MomentKind::Interval, "interval", {"line", "x0"}},
                                              {MomentKind::Triangle, "triangle", {"id"}}}};
        for (const Form& form : kForms) {
            const JsonValue* field = find(m_row, form.field);
            if (!field || !field->object()) continue;
            std::array<std::int64_t, 3> numbers{};
            for (std::size_t i = 0; i < numbers.size() && !form.members[i].empty(); ++i) {
                const JsonValue* member = find(*field->object(), form.members[i]);
                if (!member) return wrong(*field, fmt::format("'{}' must say '{}'", form.field, form.members[i]));
                const auto number = wholeOf(*member, m_file, form.members[i], kLeast, kMost);
                if (!number) return number.error();
                numbers[i] = *number;
            }
            return MomentKey{form.kind, numbers[0], numbers[1], numbers[2]};
        }
        if (const JsonValue* line = find(m_row, "line")) {
            const auto number = wholeOf(*line, m_file, "line", kLeast, kMost);
            if (!number) return number.error();
            return MomentKey{MomentKind::Line, *number};
        }
        for (const std::string_view list : {"active_edges", "active_polygons", "spans", "entered", "left"})
            if (const JsonValue* field = find(m_row, list))
                return wrong(*field, fmt::format("a row with '{}' must say its 'line'", list));
        return MomentKey{};
    }

    /// A preset that has these fields.
    std::string_view guess() const
    {
        const auto has = [this](std::string_view name) { return find(m_row, name) != nullptr; };
        if (has("interval")) return "interval";
        if (has("nodes") || has("node")) return "hzb-octree";
        if (has("query") || has("update") || has("pyramid")) return "quadtree";
        if (has("span") && !has("line")) return "edge-walk";
        return has("pixel") || has("triangle") || has("tile") ? "zbuffer" : "scanline";
    }

private:
    Error wrong(const JsonValue& value, std::string sentence) const
    {
        return {Trouble::Input, std::move(sentence), m_file, value.line};
    }

    std::optional<Error> checkItems(std::string_view name, const JsonValue::Array& items) const
    {
        if (name == "nodes") return std::nullopt;
        for (const JsonValue& item : items) {
            if (name == "active_polygons") {
                if (const auto number = wholeOf(item, m_file, name, kLeast, kMost); !number) return number.error();
                continue;
            }
            if (!item.object()) return wrong(item, fmt::format("'{}' must be a list of objects", name));
            for (const auto& [field, value] : *item.object()) {
                const bool isKnown = name == "spans" ? isOneOf(field, kSpanFields) : isOneOf(field, kEdgeFields);
                if (!isKnown) return wrong(value, fmt::format("'{}' has no field '{}'", name, quotable(field)));
                if (const auto trouble = checkNumber(field, value)) return trouble;
            }
            if (name != "spans") continue;
            for (const std::string_view field : kSpanFields)
                if (!find(*item.object(), field)) return wrong(item, fmt::format("'{}' must say '{}'", name, field));
        }
        return std::nullopt;
    }

    std::optional<Error> checkNumber(std::string_view field, const JsonValue& value) const
    {
        if (field == "x" || (field == "dx" && !value.array())) {
            const auto number = realOf(value, m_file, field);
            return number ? std::nullopt : std::optional(number.error());
        }
        if (field == "dx") {
            if (value.array()->size() != 2)
                return wrong(value, "'dx' must be a number, or two: [numerator, denominator]");
            for (const JsonValue& part : *value.array())
                if (const auto number = realOf(part, m_file, field); !number) return number.error();
            return std::nullopt;
        }
        const auto number = wholeOf(value, m_file, field, kLeast, kMost);
        return number ? std::nullopt : std::optional(number.error());
    }

    const std::string&       m_file;
    const JsonValue::Object& m_row;
};

}  // namespace

std::string phraseOf(const MomentKey& key)
{
    switch (key.kind) {
        case MomentKind::Step:
            return fmt::format("At step {} of grain {}", key.b, wordOf(static_cast<Grain>(key.a)));
        case MomentKind::Pixel:
            return fmt::format("At pixel ({}, {}), where triangle {} is tested,", key.a, key.b, key.c);
        case MomentKind::Query:
            return fmt::format("At the question about triangle {}", key.a);
        case MomentKind::Update:
            return fmt::format("At the update of cell ({}, {}) of level {}", key.b, key.c, key.a);
        case MomentKind::Interval:
            return fmt::format("At the interval of line {} from pixel {} on", key.a, key.b);
        case MomentKind::Triangle:
            return fmt::format("After triangle {}", key.a);
        case MomentKind::Line:
            return fmt::format("On line {}", key.a);
        case MomentKind::End:
            break;
    }
    return "In the finished picture";
}

Result<Trace> traceOf(std::string text, const std::string& file)
{
    Trace trace{.file = file, .text = std::move(text), .rows = {}, .algorithm = {}, .guess = "scanline"};
    if (auto trouble = encodingTrouble(trace.text)) return Error{Trouble::Input, *std::move(trouble), file};
    int         line        = 0;
    int         algorithmIn = 0;
    std::size_t at          = trace.text.size() - withoutMark(trace.text).size();
    while (at < trace.text.size()) {
        const std::size_t      end  = std::min(trace.text.find('\n', at), trace.text.size());
        const std::string_view rest = std::string_view(trace.text).substr(at, end - at);
        ++line;
        TraceRow row{line, at, end - at, {}};
        at = end + 1;
        if (rest.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        const auto value = parseJson(rest, file, 0, line);
        if (!value) return value.error();
        if (!value->object())
            return Error{Trouble::Input, "a row of a trace must be an object with fields of a step's state", file,
                         line};
        const RowReader reader(file, *value->object());
        if (const auto trouble = reader.checkFields()) return *trouble;
        const auto key = reader.key();
        if (!key) return key.error();
        row.key = *key;
        if (const JsonValue* named = find(*value->object(), "algorithm")) {
            if (!named->text()) return Error{Trouble::Input, "'algorithm' must be a text", file, line};
            if (!trace.algorithm) {
                trace.algorithm = *named->text();
                algorithmIn     = line;
            } else if (*trace.algorithm != *named->text()) {
                return Error{Trouble::Input,
                             fmt::format("a trace is of one algorithm, but line {} names another", algorithmIn), file,
                             line};
            }
        }
        if (trace.rows.empty()) trace.guess = reader.guess();
        trace.rows.push_back(row);
    }
    if (trace.rows.empty()) return Error{Trouble::Input, "the trace holds no row", file};
    return trace;
}

Result<Trace> readTrace(const std::string& path)
{
    Result<std::string> text = readRegularFile(path, kMaxTraceFile);
    if (!text) return text.error();
    return traceOf(*std::move(text), path);
}

Result<Pipeline> traceAlgorithm(const Trace& trace, const std::optional<std::string>& named)
{
    if (named) {
        if (const Preset* preset = findPreset(*named)) return preset->pipeline;
        return Error{Trouble::Usage, "'algorithm' must be a preset: see zscope-cli list algorithms"};
    }
    if (const Preset* preset = findPreset(trace.algorithm ? std::string_view(*trace.algorithm) : trace.guess))
        return preset->pipeline;
    return Error{Trouble::Input, "'algorithm' must be a preset: see zscope-cli list algorithms", trace.file};
}

bool hasTablesOf(const Trace& trace, const Pipeline& pipeline)
{
    const std::vector<Grain> grains    = grainsOf(pipeline);
    const auto               has       = [&](Grain grain) { return std::ranges::find(grains, grain) != grains.end(); };
    const MomentKey&         key       = trace.rows.front().key;
    const auto               hasMoment = [&] {
        switch (key.kind) {
            case MomentKind::Step:
                return has(static_cast<Grain>(key.a));
            case MomentKind::Pixel:
                return has(Grain::Pixel);
            case MomentKind::Query:
                return has(Grain::Query);
            case MomentKind::Update:
                return has(Grain::Update);
            case MomentKind::Interval:
                return has(Grain::Interval);
            case MomentKind::Triangle:
                return has(Grain::Triangle);
            case MomentKind::Line:
                return has(Grain::Line);
            case MomentKind::End:
                break;
        }
        return true;
    };
    if (!hasMoment()) return false;
    if (trace.guess == "interval") return has(Grain::Interval);
    if (trace.guess == "hzb-octree") return has(Grain::Node);
    if (trace.guess == "quadtree") return has(Grain::Query) || has(Grain::Update);
    if (trace.guess == "edge-walk") return has(Grain::Span);
    return trace.guess == "zbuffer" || has(Grain::Line);
}

}  // namespace zscope::check
