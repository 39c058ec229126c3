#include "core/lesson/lesson_file.h"

#include <algorithm>
#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "core/frame/faults.h"
#include "core/io/json_document.h"
#include "core/io/read_file.h"
#include "core/io/text_encoding.h"
#include "core/lesson/lesson_facts.h"
#include "core/lesson/lesson_sections.h"
#include "core/scene/load.h"
#include "core/scene/view_json.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

bool Accepted::holds(const FactValue& value) const
{
    if (const auto* text = std::get_if<std::string>(&value)) return *text == word;
    const double number = std::get<double>(value);
    return word.empty() && from <= number && number <= to;
}

namespace {

/// Takes the members of one object, key by key, and knows where it stands.
class Reader {
public:
    Reader(const std::string& file) : m_file(file) {}

    using Take = std::function<std::optional<Error>(const JsonValue& value)>;
    struct Key {
        std::string_view word;
        Take             take;
    };

    Error wrong(const JsonValue& value, std::string sentence) const { return wrong(value.line, std::move(sentence)); }
    Error wrong(int line, std::string sentence) const { return {Trouble::Input, std::move(sentence), m_file, line}; }

    std::optional<Error> object(const JsonValue& value, std::string_view what, const std::vector<Key>& keys) const
    {
        const JsonValue::Object* members = value.object();
        if (!members) return wrong(value, fmt::format("{} must be an object in braces", what));
        for (const auto& [key, member] : *members) {
            const auto found = std::ranges::find(keys, key, &Key::word);
            if (found == keys.end()) {
                std::string words;
                for (const Key& known : keys) words += (words.empty() ? "" : ", ") + std::string(known.word);
                return wrong(member, fmt::format("{} has no '{}'; it has {}", what, key.substr(0, 60), words));
            }
            if (auto error = found->take(member)) return error;
        }
        return std::nullopt;
    }
    Take text(std::string& to, std::string_view what) const
    {
        return [this, &to, what](const JsonValue& value) -> std::optional<Error> {
            if (!value.text()) return wrong(value, fmt::format("'{}' must be text in quotes", what));
            to = *value.text();
            return std::nullopt;
        };
    }
    /// "text", or {"en": "text", "zh": "text"}.
    Take words(LessonText& to, std::string_view what) const
    {
        return [this, &to, what](const JsonValue& value) -> std::optional<Error> {
            if (value.text()) {
                to.english = *value.text();
                return std::nullopt;
            }
            if (!value.object())
                return wrong(value, fmt::format("'{}' must be text, or {{\"en\": text, \"zh\": text}}", what));
            return object(value, fmt::format("'{}'", what),
                          {{"en", text(to.english, "en")}, {"zh", text(to.chinese, "zh")}});
        };
    }
    template <class Whole>
    Take whole(Whole& to, std::string_view what, std::int64_t min, std::int64_t max) const
    {
        return [this, &to, what, min, max](const JsonValue& value) -> std::optional<Error> {
            const auto number = wholeOf(value, m_file, what, min, max);
            if (!number) return number.error();
            if constexpr (requires { to.emplace(); })
                to = static_cast<typename Whole::value_type>(*number);
            else
                to = static_cast<Whole>(*number);
            return std::nullopt;
        };
    }
    template <class Real>
    Take real(Real& to, std::string_view what) const
    {
        return [this, &to, what](const JsonValue& value) -> std::optional<Error> {
            const auto number = realOf(value, m_file, what);
            if (!number) return number.error();
            to = *number;
            return std::nullopt;
        };
    }
    Take pixel(std::optional<PixelPosition>& to, std::string_view what) const
    {
        return [this, &to, what](const JsonValue& value) -> std::optional<Error> {
            const JsonValue::Array* pair = value.array();
            if (!pair || pair->size() != 2) return wrong(value, fmt::format("'{}' must be [x, y]", what));
            PixelPosition pixel;
            if (auto error = whole(pixel.x, what, 0, kMaxPictureSide - 1)((*pair)[0])) return error;
            if (auto error = whole(pixel.y, what, 0, kMaxPictureSide - 1)((*pair)[1])) return error;
            to = pixel;
            return std::nullopt;
        };
    }
    /// One of the words of `all`, for which wordOf(one) says the word.
    template <class Value, class All, class WordOf>
    Take oneOf(Value& to, std::string_view what, const All& all, WordOf wordOf) const
    {
        return [this, &to, what, &all, wordOf](const JsonValue& value) -> std::optional<Error> {
            std::string words;
            for (const auto& one : all) {
                if (value.text() && *value.text() == wordOf(one)) {
                    to = one;
                    return std::nullopt;
                }
                words += (words.empty() ? "" : ", ") + std::string(wordOf(one));
            }
            return wrong(value, fmt::format("'{}' must be one of {}", what, words));
        };
    }
    const std::string& file() const { return m_file; }

private:
    const std::string& m_file;
};

constexpr std::array kVerdicts{Verdict::Outside, Verdict::Hidden, Verdict::Entered, Verdict::Small};
constexpr std::array kReasons{IntervalReason::Alone,       IntervalReason::Leads,        IntervalReason::TestedOnce,
                              IntervalReason::BeyondFar,   IntervalReason::DepthLimited, IntervalReason::HasPattern,
                              IntervalReason::NoClearLead, IntervalReason::NotByEnds};
constexpr std::array<std::string_view, 2> kWonLost{"lost", "won"};
constexpr std::array<std::string_view, 2> kShownHidden{"entered", "hidden"};
constexpr std::array<std::string_view, 3> kKinds{"choice", "number", "pixel"};
constexpr std::array<std::string_view, 3> kAts{"stop", "next", "end"};
constexpr std::array<std::string_view, 2> kOverlays{"boxes", "pyramid"};

std::string_view same(std::string_view word) { return word; }

/// The place of a word in its list.
template <class To, class List>
Reader::Take placeIn(const Reader& reader, To& to, std::string_view what, const List& list)
{
    return [&reader, &to, what, &list](const JsonValue& value) -> std::optional<Error> {
        std::string_view word;
        if (auto error = reader.oneOf(word, what, list, same)(value)) return error;
        to = static_cast<To>(std::ranges::find(list, word) - list.begin());
        return std::nullopt;
    };
}
template <class List>
Reader::Take truthIn(const Reader& reader, std::optional<bool>& to, std::string_view what, const List& list)
{
    return [&reader, &to, what, &list](const JsonValue& value) -> std::optional<Error> {
        std::string_view word;
        if (auto error = reader.oneOf(word, what, list, same)(value)) return error;
        to = word == list[1];
        return std::nullopt;
    };
}

std::optional<Error> readStop(const Reader& r, const JsonValue& value, LessonStop& stop)
{
    stop          = {};
    stop.fileLine = value.line;
    std::optional<std::string>   path;
    std::optional<std::uint32_t> instance, triangle;
    bool                         hasGrain = false, isEnd = false;
    const auto                   takeGrain = [&](const JsonValue& word) {
        hasGrain = true;
        return r.oneOf(stop.grain, "grain", kGrains, [](Grain grain) { return wordOf(grain); })(word);
    };
    const auto takeNode = [&](const JsonValue& word) -> std::optional<Error> {
        path.emplace();
        return r.text(*path, "node")(word);
    };
    const auto takeEnd = [&](const JsonValue& word) -> std::optional<Error> {
        if (!word.truth() || !*word.truth()) return r.wrong(word, "'end' must be true, or be left out");
        isEnd = true;
        return std::nullopt;
    };
    const auto error = r.object(
        value, "a stop",
        {{"grain", takeGrain},
         {"end", takeEnd},
         {"step", r.whole(stop.step, "step", 0, std::int64_t{1} << 53)},
         {"line", r.whole(stop.line, "line", 0, kMaxPictureSide - 1)},
         {"pixel", r.pixel(stop.pixel, "pixel")},
         {"triangle", r.whole(triangle, "triangle", 0, static_cast<std::int64_t>(kMaxTriangles))},
         {"node", takeNode},
         {"instance", r.whole(instance, "instance", 0, static_cast<std::int64_t>(kMaxTriangles))},
         {"stage", r.oneOf(stop.stage, "stage", kStages, [](Stage stage) { return wordOf(stage); })},
         {"verdict", r.oneOf(stop.verdict, "verdict", kVerdicts, [](Verdict verdict) { return wordOf(verdict); })},
         {"query", truthIn(r, stop.hidden, "query", kShownHidden)},
         {"update", r.whole(stop.update, "update", 0, 20)},
         {"interval",
          r.oneOf(stop.interval, "interval", kReasons, [](IntervalReason reason) { return wordOf(reason); })},
         {"test", truthIn(r, stop.won, "test", kWonLost)},
         {"nth", r.whole(stop.nth, "nth", 1, std::int64_t{1} << 53)}});
    if (error) return error;
    if (triangle) stop.triangle = TriangleId{*triangle};
    if (instance && !path) return r.wrong(value, "a stop at an instance names a 'node' of its tree, too");
    if (path) stop.node = NodeName{instance ? std::optional(InstanceId{*instance}) : std::nullopt, *path};
    if (!hasGrain && !isEnd) return r.wrong(value, "a stop names its 'grain': see zscope-cli list grains");
    LessonStop others = stop;
    others.step.reset();
    if (stop.step && !others.isEnd()) return r.wrong(value, "a stop is a 'step' by its number or an event, not both");
    if (isEnd && !stop.isEnd()) return r.wrong(value, "a stop at the 'end' names no event");
    if (!isEnd && stop.isEnd() && hasGrain) return r.wrong(value, "a stop names an event, a 'step', or \"end\": true");
    return std::nullopt;
}

/// "value": a word or a number, or "from" and "to".
struct AcceptedKeys {
    std::optional<FactValue> value;
    std::optional<double>    from, to;

    Reader::Take takeValue(const Reader& r)
    {
        return [this, &r](const JsonValue& json) -> std::optional<Error> {
            if (json.text()) {
                value = FactValue(*json.text());
                return std::nullopt;
            }
            double number = 0;
            if (auto error = r.real(number, "value")(json)) return error;
            value = FactValue(number);
            return std::nullopt;
        };
    }
    bool                 isGiven() const { return value || from || to; }
    std::optional<Error> read(const Reader& r, const JsonValue& owner, std::optional<Accepted>& accepted) const
    {
        if (!isGiven()) return std::nullopt;
        if (value && (from || to)) return r.wrong(owner, "give a 'value', or 'from' and 'to', not both");
        constexpr double kAll = std::numeric_limits<double>::infinity();
        Accepted         result{.from = from.value_or(-kAll), .to = to.value_or(kAll)};
        if (value) {
            if (const auto* word = std::get_if<std::string>(&*value))
                result.word = *word;
            else
                result.from = result.to = std::get<double>(*value);
        }
        if (result.from > result.to) return r.wrong(owner, "'from' is larger than 'to'");
        accepted = result;
        return std::nullopt;
    }
};

std::optional<Error> readChoice(const Reader& r, const JsonValue& value, LessonChoice& choice)
{
    AcceptedKeys keys;
    const auto   takeRight = [&](const JsonValue& truth) -> std::optional<Error> {
        if (!truth.truth()) return r.wrong(truth, "'right' must be true or false");
        choice.isRight = *truth.truth();
        return std::nullopt;
    };
    if (auto error = r.object(value, "a choice",
                              {{"text", r.words(choice.text, "text")},
                               {"right", takeRight},
                               {"value", keys.takeValue(r)},
                               {"from", r.real(keys.from, "from")},
                               {"to", r.real(keys.to, "to")}}))
        return error;
    if (choice.text.isEmpty()) return r.wrong(value, "a choice needs its 'text'");
    return keys.read(r, value, choice.when);
}

/// What the parts of a question must have together.
std::optional<Error> checkQuestion(const Reader& r, const JsonValue& value, const LessonQuestion& question)
{
    using Kind = LessonQuestion::Kind;
    if (question.ask.isEmpty()) return r.wrong(value, "a question needs its text, 'ask'");
    if (question.why.isEmpty()) return r.wrong(value, "a question needs the explanation of its answer, 'why'");
    const auto isPixelFact = [&] {
        return std::ranges::find(pixelFacts(), question.fact, &PixelFactEntry::word) != pixelFacts().end();
    };
    if (!question.fact.empty() && !(question.kind == Kind::Pixel ? isPixelFact() : isFact(question.fact)))
        return r.wrong(value, fmt::format("there is no fact '{}'{}: see docs/lessons.md", question.fact.substr(0, 60),
                                          question.kind == Kind::Pixel ? " of pixels" : ""));
    if (question.kind == Kind::Pixel) {
        if (question.fact.empty() || !question.accepted)
            return r.wrong(value, "a question for a pixel names a 'fact' and its 'value', or 'from' and 'to'");
    } else if (question.accepted) {
        return r.wrong(value, "'value', 'from' and 'to' belong to choices, and to questions for a pixel");
    }
    if (question.kind == Kind::Number) {
        if (question.fact.empty() && !question.answer)
            return r.wrong(value, "a question for a number names a 'fact', or its 'answer'");
        if (!(question.tolerance >= 0)) return r.wrong(value, "'tolerance' must not be negative");
    } else if (question.answer) {
        return r.wrong(value, "'answer' belongs to a question for a number");
    }
    if (question.kind != Kind::Choice)
        return question.choices.empty()
                   ? std::nullopt
                   : std::optional(r.wrong(value, "'choices' belong to a question of kind choice"));
    if (question.choices.size() < 2) return r.wrong(value, "a question of kind choice needs two 'choices' or more");
    for (const LessonChoice& choice : question.choices)
        if (choice.when.has_value() == question.fact.empty())
            return r.wrong(value, question.fact.empty()
                                      ? "a choice has a 'value' only if the question names a 'fact'"
                                      : "each choice needs a 'value', or 'from' and 'to', of the question's fact");
    if (question.fact.empty() && std::ranges::count_if(question.choices, &LessonChoice::isRight) != 1)
        return r.wrong(value, "exactly one choice must be 'right'");
    return std::nullopt;
}

std::optional<Error> readQuestion(const Reader& r, const JsonValue& value, LessonQuestion& question)
{
    question.fileLine = value.line;
    AcceptedKeys keys;
    bool         hasKind  = false;
    const auto   takeKind = [&](const JsonValue& word) {
        hasKind = true;
        return placeIn(r, question.kind, "kind", kKinds)(word);
    };
    const auto takeChoices = [&](const JsonValue& list) -> std::optional<Error> {
        if (!list.array()) return r.wrong(list, "'choices' must be a list in brackets");
        for (const JsonValue& one : *list.array())
            if (auto error = readChoice(r, one, question.choices.emplace_back())) return error;
        return std::nullopt;
    };
    if (auto error = r.object(value, "a question",
                              {{"kind", takeKind},
                               {"ask", r.words(question.ask, "ask")},
                               {"why", r.words(question.why, "why")},
                               {"fact", r.text(question.fact, "fact")},
                               {"at", placeIn(r, question.at, "at", kAts)},
                               {"choices", takeChoices},
                               {"answer", r.real(question.answer, "answer")},
                               {"tolerance", r.real(question.tolerance, "tolerance")},
                               {"unit", r.words(question.unit, "unit")},
                               {"value", keys.takeValue(r)},
                               {"from", r.real(keys.from, "from")},
                               {"to", r.real(keys.to, "to")}}))
        return error;
    if (!hasKind) return r.wrong(value, "a question names its 'kind': choice, number or pixel");
    if (auto error = keys.read(r, value, question.accepted)) return error;
    return checkQuestion(r, value, question);
}

std::optional<Error> readPipeline(const Reader& r, const JsonValue& value, Pipeline& pipeline)
{
    const Preset* preset = value.text() ? findPreset(*value.text()) : nullptr;
    if (!preset) return r.wrong(value, "'algorithm' must be a preset: see zscope-cli list algorithms");
    pipeline = preset->pipeline;
    return std::nullopt;
}

std::optional<Error> readChoices(const Reader& r, const JsonValue& value, Pipeline& pipeline)
{
    if (!value.object()) return r.wrong(value, "'choices' must be an object, such as {\"depth\": \"early\"}");
    for (const auto& [axis, choice] : *value.object()) {
        if (std::ranges::find(axes(), axis, &AxisEntry::word) == axes().end())
            return r.wrong(choice, fmt::format("there is no axis '{}': see zscope-cli list", axis.substr(0, 60)));
        if (!choice.text()) return r.wrong(choice, fmt::format("the choice of '{}' must be a word in quotes", axis));
        const auto changed = withChoice(pipeline, axis, *choice.text());
        if (!changed) return r.wrong(choice, changed.error().sentence);
        pipeline = *changed;
    }
    return std::nullopt;
}

std::optional<Error> readFault(const Reader& r, const JsonValue& value, Pipeline& pipeline)
{
    if (value.text() && *value.text() == "none") {
        pipeline.fault = {};
        return std::nullopt;
    }
    const std::optional<FaultSet> faults = value.text() ? findFaults(*value.text()) : std::nullopt;
    if (!faults) return r.wrong(value, "'fault' must be none or a fault: see zscope-cli list faults");
    pipeline.fault = *faults;
    return std::nullopt;
}

/// A scene beside the lesson's file.
std::string besideFile(const std::string& scene, const std::string& file)
{
    if (scene.starts_with("builtin:")) return scene;
    const std::filesystem::path path(scene);
    return path.is_absolute() ? scene : (std::filesystem::path(file).parent_path() / path).string();
}

/// `page` comes with what stays as on the page before.
std::optional<Error> readPage(const Reader& r, const JsonValue& value, LessonPage& page)
{
    const JsonValue *algorithm = nullptr, *choices = nullptr, *fault = nullptr, *size = nullptr, *view = nullptr,
                    *stop = nullptr, *compared = nullptr;
    const auto keep = [](const JsonValue*& to) {
        return [&to](const JsonValue& json) -> std::optional<Error> {
            to = &json;
            return std::nullopt;
        };
    };
    const std::string sceneBefore = page.scene;
    const auto        takeScene   = [&](const JsonValue& json) -> std::optional<Error> {
        if (auto error = r.text(page.scene, "scene")(json)) return error;
        page.scene = besideFile(page.scene, r.file());
        return std::nullopt;
    };
    const auto takeLayer = [&](const JsonValue& json) -> std::optional<Error> {
        const Layer* found = json.text() ? findLayer(*json.text()) : nullptr;
        if (!found) return r.wrong(json, "'layer' must be a layer: see zscope-cli list layers");
        page.layer = found;
        return std::nullopt;
    };
    const auto takeOverlays = [&](const JsonValue& json) -> std::optional<Error> {
        if (!json.array()) return r.wrong(json, "'overlays' must be a list in brackets");
        for (const JsonValue& one : *json.array()) {
            std::string_view word;
            if (auto error = r.oneOf(word, "overlays", kOverlays, same)(one)) return error;
            page.overlays.emplace_back(word);
        }
        return std::nullopt;
    };
    const auto takePanel = [&](const JsonValue& json) -> std::optional<Error> {
        std::string_view word;
        if (auto error = r.oneOf(word, "panel", kLessonPanels, same)(json)) return error;
        page.panel = word;
        return std::nullopt;
    };
    if (auto error = r.object(value, "a page",
                              {{"scene", takeScene},
                               {"size", keep(size)},
                               {"view", keep(view)},
                               {"algorithm", keep(algorithm)},
                               {"choices", keep(choices)},
                               {"fault", keep(fault)},
                               {"compare", keep(compared)},
                               {"stop", keep(stop)},
                               {"pick", r.pixel(page.pick, "pick")},
                               {"layer", takeLayer},
                               {"overlays", takeOverlays},
                               {"panel", takePanel}}))
        return error;
    if (page.scene.empty()) return r.wrong(value, "the first page names its 'scene'");
    if (page.scene != sceneBefore) {  // another scene has views of its own
        const int width = page.view.width, height = page.view.height;
        page.view       = {};
        page.view.width = width, page.view.height = height;
        page.hasView = false;
    }
    if (size) {
        std::optional<PixelPosition> pair;
        if (auto error = r.pixel(pair, "size")(*size)) return error;
        if (pair->x < 1 || pair->y < 1) return r.wrong(*size, "'size' must be [width, height], 1 or more each");
        page.view.width = pair->x, page.view.height = pair->y;
    }
    if (view) {
        const int  width = page.view.width, height = page.view.height;
        const auto read = viewOf(*view, r.file());
        if (!read) return read.error();
        page.view    = *read;
        page.hasView = true;
        if (!read->exact) page.view.width = width, page.view.height = height;
    }
    if (algorithm)
        if (auto error = readPipeline(r, *algorithm, page.pipeline)) return error;
    if (choices)
        if (auto error = readChoices(r, *choices, page.pipeline)) return error;
    if (fault)
        if (auto error = readFault(r, *fault, page.pipeline)) return error;
    if (const auto why = explainInvalid(page.pipeline)) return r.wrong(value, *why);
    if (compared)
        if (auto error = readPipeline(r, *compared, page.compared.emplace())) return error;
    if (stop)
        if (auto error = readStop(r, *stop, page.stop)) return error;
    const auto grains = grainsOf(page.pipeline);
    if (std::ranges::find(grains, page.stop.grain) == grains.end())
        return r.wrong(*stop,
                       fmt::format("{} has no steps of grain '{}'", nameOf(page.pipeline), wordOf(page.stop.grain)));
    const auto isInside = [&](const std::optional<PixelPosition>& pixel) {
        return !pixel || (pixel->x < page.view.width && pixel->y < page.view.height);
    };
    if (!isInside(page.pick)) return r.wrong(value, "'pick' lies outside the picture");
    if (!isInside(page.stop.pixel)) return r.wrong(*stop, "the stop's 'pixel' lies outside the picture");
    return std::nullopt;
}

class LessonBuilder {
public:
    explicit LessonBuilder(const std::string& file) : m_reader(file) { m_lesson.file = file; }

    std::optional<Error> add(const LessonSection& section)
    {
        if (section.word == "lesson" || section.word == "page" || section.word == "question") {
            const auto json = parseJson(section.body, m_reader.file(), 0, section.line + 1);
            if (!json) return json.error();
            return addJson(section, *json);
        }
        if (section.word != "en" && section.word != "zh")
            return m_reader.wrong(section.line,
                                  fmt::format("there is no section '{}'; there are lesson, page, en, zh and question",
                                              section.word.substr(0, 60)));
        if (m_lesson.pages.empty()) return m_reader.wrong(section.line, "a text stands before the first page");
        std::string& text =
            section.word == "en" ? m_lesson.pages.back().text.english : m_lesson.pages.back().text.chinese;
        if (!text.empty())
            return m_reader.wrong(section.line, fmt::format("this page has a text '{}' already", section.word));
        text = std::string(trimmed(section.body));
        if (text.empty()) return m_reader.wrong(section.line, "this text is empty");
        return std::nullopt;
    }
    Result<Lesson> finish(int lines)
    {
        if (!m_hasHead) return m_reader.wrong(1, "the file needs a section '=== lesson' with the title");
        if (m_lesson.pages.empty()) return m_reader.wrong(lines, "the lesson has no page: begin one with '=== page'");
        for (const LessonPage& page : m_lesson.pages)
            if (page.text.isEmpty())
                return m_reader.wrong(page.fileLine, "this page has no text: write it after '=== en' or '=== zh'");
        return std::move(m_lesson);
    }

private:
    std::optional<Error> addJson(const LessonSection& section, const JsonValue& json)
    {
        if (section.word == "lesson") {
            if (m_hasHead || !m_lesson.pages.empty())
                return m_reader.wrong(section.line, "a file holds one lesson, and its head comes first");
            m_hasHead = true;
            if (auto error = m_reader.object(json, "a lesson", {{"title", m_reader.words(m_lesson.title, "title")}}))
                return error;
            if (m_lesson.title.isEmpty()) return m_reader.wrong(json, "a lesson needs a 'title'");
            return std::nullopt;
        }
        if (section.word == "page") {
            LessonPage page;
            if (!m_lesson.pages.empty()) {
                const LessonPage& before = m_lesson.pages.back();
                page.scene               = before.scene;
                page.view                = before.view;
                page.hasView             = before.hasView;
                page.pipeline            = before.pipeline;
            } else {
                page.view.width = 320, page.view.height = 180;
            }
            page.fileLine = section.line;
            if (auto error = readPage(m_reader, json, page)) return error;
            m_lesson.pages.push_back(std::move(page));
            return std::nullopt;
        }
        if (m_lesson.pages.empty()) return m_reader.wrong(section.line, "a question stands before the first page");
        auto& question = m_lesson.pages.back().question;
        if (question) return m_reader.wrong(section.line, "a page has one question");
        return readQuestion(m_reader, json, question.emplace());
    }

    Reader m_reader;
    Lesson m_lesson;
    bool   m_hasHead = false;
};

}  // namespace

Result<Lesson> parseLesson(const std::string& text, const std::string& file)
{
    if (auto trouble = encodingTrouble(text)) return Error{Trouble::Input, *std::move(trouble), file};
    LessonBuilder builder(file);
    for (const LessonSection& section : sectionsOf(withoutMark(text)))
        if (auto error = builder.add(section)) return *error;
    return builder.finish(1 + static_cast<int>(std::ranges::count(text, '\n')));
}

Result<Lesson> readLesson(const std::string& file)
{
    const auto text = readRegularFile(file, kMaxLessonBytes);
    if (!text) return text.error();
    return parseLesson(*text, file);
}

}  // namespace zscope
