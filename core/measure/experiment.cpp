#include "core/measure/experiment.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include <fmt/format.h>

#include "core/base/thread_count.h"
#include "core/frame/shortcuts.h"
#include "core/io/json_document.h"

namespace zscope {
namespace {

constexpr int kMaxFrames  = 100'000;
constexpr int kMaxSamples = 100'000'000;

class ExperimentReader {
public:
    explicit ExperimentReader(const std::string& file) : m_file(file) {}

    Result<Experiment> read(const JsonValue& document)
    {
        Experiment experiment;
        const bool isRead = knows(document, "an experiment", {"title", "question", "baseline", "parts"})
                            && text(document, "title", experiment.title, true)
                            && text(document, "question", experiment.question, false)
                            && word(document, "baseline", experiment.baseline) && parts(document, experiment.parts);
        if (!isRead) return *m_error;
        if (const JsonValue* baseline = find(document, "baseline")) experiment.baselineLine = baseline->line;
        if (experiment.caseCount() > kMaxCases)
            return Error{Trouble::Limit,
                         fmt::format("an experiment has at most {} cases, not {}", kMaxCases, experiment.caseCount()),
                         m_file, document.line};
        experiment.digest = digestOf(experiment);
        return experiment;
    }

private:
    static std::string digestOf(const Experiment& experiment)
    {
        std::string all = experiment.baseline;
        for (const ExperimentPart& part : experiment.parts) {
            all += fmt::format("\n{}|{}x{}|{}|{}|{}|{}|{}|", fmt::join(part.algorithms, ","), part.width, part.height,
                               part.hasSize, part.faceCulling ? static_cast<int>(*part.faceCulling) : -1, part.frames,
                               part.rounds, part.shade.value_or(true));
            if (!part.path.empty()) all += fmt::format("path {}|", part.path);
            if (!part.shortcuts.isAll()) all += "shortcuts " + wordsOf(part.shortcuts) + "|";
            if (part.samples) all += fmt::format("sample {}|", *part.samples);
            if (part.peers) all += fmt::format("peers {}|", part.shade.has_value());
            for (const int threads : part.threads) all += fmt::format("{},", threads);
            for (const ExperimentScene& scene : part.scenes)
                all += fmt::format("\n {}|{}|{}|{}|{}|{}", scene.word, scene.view, scene.camera, scene.model,
                                   scene.modelCamera, scene.x.value_or(-1));
            for (const ExperimentScene& scene : part.scenes)
                if (scene.width > 0 || !scene.choices.empty())
                    all += fmt::format("\n {} {}x{} {}", scene.word, scene.width, scene.height,
                                       fmt::join(scene.choices, ","));
        }
        return digestOfText(all);
    }

    bool fail(const JsonValue& at, std::string sentence)
    {
        m_error = Error{Trouble::Input, std::move(sentence), m_file, at.line};
        return false;
    }

    bool knows(const JsonValue& value, std::string_view what, std::initializer_list<std::string_view> keys)
    {
        if (!value.object())
            return fail(value, fmt::format("{} is an object with some of: {}", what, fmt::join(keys, ", ")));
        for (const auto& [key, member] : *value.object())
            if (std::ranges::find(keys, key) == keys.end())
                return fail(member,
                            fmt::format("{} has no '{}': it has {}", what, key.substr(0, 60), fmt::join(keys, ", ")));
        return true;
    }

    static const JsonValue* find(const JsonValue& object, std::string_view key)
    {
        const auto found = std::ranges::find(*object.object(), key, &JsonMember::first);
        return found == object.object()->end() ? nullptr : &found->second;
    }

    /// A text that may be left out; `to` is then what it was.
    bool word(const JsonValue& object, std::string_view key, std::string& to)
    {
        const JsonValue* value = find(object, key);
        if (!value) return true;
        if (!value->text() || value->text()->empty()) return fail(*value, fmt::format("'{}' is a text", key));
        to = *value->text();
        return true;
    }

    bool text(const JsonValue& object, std::string_view key, ExperimentText& to, bool isWanted)
    {
        const JsonValue* value = find(object, key);
        if (!value) return isWanted ? fail(object, fmt::format("'{}' is missing", key)) : true;
        if (value->text()) {
            to = {*value->text(), *value->text()};
            return true;
        }
        if (!knows(*value, fmt::format("'{}'", key), {"en", "zh_CN"}) || !word(*value, "en", to.english)) return false;
        if (to.english.empty()) return fail(*value, fmt::format("'{}' has no text under 'en'", key));
        to.chinese = to.english;
        return word(*value, "zh_CN", to.chinese);
    }

    bool number(const JsonValue& object, std::string_view key, int min, int max, int& to)
    {
        const JsonValue* value = find(object, key);
        if (!value) return true;
        const auto read = wholeOf(*value, m_file, key, min, max);
        if (!read) return m_error = read.error(), false;
        to = static_cast<int>(*read);
        return true;
    }

    /// The members of a list that must not be empty.
    template <class Each>
    bool list(const JsonValue& object, std::string_view key, const Each& each)
    {
        const JsonValue* value = find(object, key);
        if (!value) return fail(object, fmt::format("'{}' is missing", key));
        if (!value->array() || value->array()->empty())
            return fail(*value, fmt::format("'{}' is a list that is not empty", key));
        return std::ranges::all_of(*value->array(), each);
    }

    bool parts(const JsonValue& document, std::vector<ExperimentPart>& to)
    {
        return list(document, "parts", [&](const JsonValue& value) {
            ExperimentPart part;
            part.line = value.line;
            if (!onePart(value, part)) return false;
            to.push_back(std::move(part));
            return true;
        });
    }

    bool onePart(const JsonValue& value, ExperimentPart& part)
    {
        if (!knows(value, "a part",
                   {"title", "scenes", "algorithms", "threads", "size", "cull", "shortcuts", "frames", "rounds",
                    "shade", "x", "path", "sample", "peers"}))
            return false;
        const auto algorithm = [&](const JsonValue& each) {
            if (!each.text() || each.text()->empty()) return fail(each, "an algorithm is a text");
            part.algorithms.push_back(*each.text());
            part.algorithmLines.push_back(each.line);
            return true;
        };
        if (!text(value, "title", part.title, true) || !text(value, "x", part.x, false)
            || !list(value, "algorithms", algorithm))
            return false;
        if (!list(value, "scenes", [&](const JsonValue& each) { return oneScene(each, part); })) return false;
        if (!size(value, part) || !culling(value, part) || !shortcuts(value, part) || !threads(value, part))
            return false;
        if (const JsonValue* path = find(value, "path")) part.pathLine = path->line;
        if (!word(value, "path", part.path) || !truth(value, "shade", part.shade)) return false;
        std::optional<bool> peers;
        if (!truth(value, "peers", peers)) return false;
        part.peers = peers.value_or(false);
        if (find(value, "sample")) {
            int samples = 0;
            if (!number(value, "sample", 1, kMaxSamples, samples)) return false;
            part.samples = static_cast<std::uint64_t>(samples);
        }
        return part.path.empty() ? frames(value, part) : passes(value, part);
    }

    /// Of one view.
    bool frames(const JsonValue& value, ExperimentPart& part)
    {
        if (!number(value, "frames", 1, kMaxFrames, part.frames)) return false;
        part.rounds = std::min(part.rounds, part.frames);
        if (!number(value, "rounds", 1, kMaxFrames, part.rounds)) return false;
        if (part.rounds <= part.frames) return true;
        return fail(
            *find(value, "rounds"),
            fmt::format("'rounds' are parts of the 'frames', so at most {}: only along a 'path' there may be more",
                        part.frames));
    }

    /// Along a path.
    bool passes(const JsonValue& value, ExperimentPart& part)
    {
        if (const JsonValue* frames = find(value, "frames"))
            return fail(*frames,
                        "a part with a 'path' has as many frames as the path: 'rounds' says how often it is flown");
        if (part.peers)
            return fail(*find(value, "peers"), "'peers' are timed on one view: a part with a 'path' has none");
        return number(value, "rounds", 1, kMaxFrames, part.rounds);
    }

    bool truth(const JsonValue& object, std::string_view key, std::optional<bool>& to)
    {
        const JsonValue* value = find(object, key);
        if (!value) return true;
        if (!value->truth()) return fail(*value, fmt::format("'{}' is true or false", key));
        to = *value->truth();
        return true;
    }

    bool oneScene(const JsonValue& value, ExperimentPart& part)
    {
        ExperimentScene scene;
        scene.line = value.line;
        if (value.text()) {
            scene.word = *value.text();
        } else {
            if (!knows(value, "a scene",
                       {"scene", "title", "view", "camera", "model", "model_camera", "x", "size", "choices"}))
                return false;
            const bool isRead = word(value, "scene", scene.word) && word(value, "title", scene.title)
                                && word(value, "view", scene.view) && word(value, "camera", scene.camera)
                                && word(value, "model", scene.model) && word(value, "model_camera", scene.modelCamera);
            if (!isRead) return false;
            if (const JsonValue* x = find(value, "x")) {
                const auto read = realOf(*x, m_file, "x");
                if (!read) return m_error = read.error(), false;
                if (!std::isfinite(*read)) return fail(*x, "'x' must be finite: it is a place on an axis");
                scene.x = *read;
            }
            if (!pair(value, "size", scene.width, scene.height)) return false;
            const auto choice = [&](const JsonValue& each) {
                if (!each.text() || each.text()->find('=') == std::string::npos)
                    return fail(each, "a choice is written axis=choice");
                scene.choices.push_back(*each.text());
                return true;
            };
            if (find(value, "choices") && !list(value, "choices", choice)) return false;
        }
        if (scene.word.empty()) return fail(value, "a scene has no word: a path, or builtin:NAME");
        part.scenes.push_back(std::move(scene));
        return true;
    }

    bool size(const JsonValue& value, ExperimentPart& part)
    {
        part.hasSize = find(value, "size") != nullptr;
        return pair(value, "size", part.width, part.height);
    }

    /// "WxH", which may be left out.
    bool pair(const JsonValue& value, std::string_view key, int& width, int& height)
    {
        std::string said;
        if (!word(value, key, said)) return false;
        if (said.empty()) return true;
        char rest = 0;
        if (std::sscanf(said.c_str(), "%5dx%5d%c", &width, &height, &rest) == 2 && width >= 1 && height >= 1
            && width <= kMaxPictureSide && height <= kMaxPictureSide)
            return true;
        return fail(*find(value, key), fmt::format("'{}' is written WxH, each from 1 to {} pixels, not '{}'", key,
                                                   kMaxPictureSide, said.substr(0, 60)));
    }

    bool culling(const JsonValue& value, ExperimentPart& part)
    {
        std::string said;
        if (!word(value, "cull", said)) return false;
        if (said == "back") part.faceCulling = FaceCulling::Back;
        if (said == "none") part.faceCulling = FaceCulling::None;
        return said.empty() || part.faceCulling ? true : fail(*find(value, "cull"), "'cull' is none or back");
    }

    bool shortcuts(const JsonValue& value, ExperimentPart& part)
    {
        std::string said;
        if (!word(value, "shortcuts", said)) return false;
        if (said.empty()) return true;
        const Result<ShortcutSet> chosen = shortcutsOf(said);
        if (!chosen) return fail(*find(value, "shortcuts"), chosen.error().sentence);
        part.shortcuts = *chosen;
        return true;
    }

    bool threads(const JsonValue& value, ExperimentPart& part)
    {
        if (!find(value, "threads")) return true;
        part.threads.clear();
        return list(value, "threads", [&](const JsonValue& each) {
            const auto read = wholeOf(each, m_file, "threads", 0, kMaxThreads);
            if (!read) return m_error = read.error(), false;
            part.threads.push_back(static_cast<int>(*read));
            return true;
        });
    }

    const std::string&   m_file;
    std::optional<Error> m_error;  // the first
};

}  // namespace

// Fowler, Noll and Vo's hash of 64 bits.
std::string digestOfText(std::string_view text)
{
    std::uint64_t hash = 0xCBF2'9CE4'8422'2325ull;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100'0000'01B3ull;
    return fmt::format("{:016x}", hash);
}

std::size_t Experiment::caseCount() const
{
    std::size_t count = 0;
    for (const ExperimentPart& part : parts) count += part.scenes.size();
    return count;
}

std::vector<ExperimentCase> casesOf(const Experiment& experiment)
{
    std::vector<ExperimentCase> cases;
    for (const ExperimentPart& part : experiment.parts)
        for (const ExperimentScene& scene : part.scenes) cases.push_back({cases.size(), &part, &scene});
    return cases;
}

Result<Experiment> experimentFromJson(const std::string& text, const std::string& file)
{
    const Result<JsonValue> document = parseJson(text, file);
    if (!document) return document.error();
    return ExperimentReader(file).read(*document);
}

}  // namespace zscope
