#include <set>
#include <vector>

#include <fmt/format.h>

#include "app/cli/options.h"
#include "app/cli/words.h"
#include "core/base/quotable.h"
#include "core/base/thread_count.h"
#include "core/frame/faults.h"
#include "core/frame/shortcuts.h"

namespace zscope::cli {
namespace {

std::vector<std::string> presetNames()
{
    std::vector<std::string> names;
    for (const Preset& preset : presets()) names.emplace_back(preset.name);
    return names;
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

/// Of "name" or "name+name".
Result<FaultSet> faultsOf(std::string_view words)
{
    if (const auto all = findFaults(words)) return *all;
    std::vector<std::string> known;
    for (const FaultEntry& entry : faults()) known.emplace_back(entry.word);
    std::size_t plus = words.find('+');
    while (plus != std::string_view::npos && findFault(words.substr(0, plus))) {
        words.remove_prefix(plus + 1);
        plus = words.find('+');
    }
    return unknownWord("fault", words.substr(0, plus), known);
}

void rename(NamedPipeline& algorithm, const Pipeline& changed)
{
    algorithm = {nameOf(changed), changed, claimOf(changed)};
}

/// "axis=choice" put into every pipeline; a pipeline that changes is reported by its new name.
Result<Done> apply(const std::string& setting, std::vector<NamedPipeline>& algorithms)
{
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
        return Error{Trouble::Usage, fmt::format("a setting is written axis=choice, not '{}'", setting)};
    for (NamedPipeline& algorithm : algorithms) {
        const auto changed = withChoice(algorithm.pipeline, setting.substr(0, equals), setting.substr(equals + 1));
        if (!changed) return changed.error();
        if (*changed == algorithm.pipeline) continue;
        rename(algorithm, *changed);
    }
    return Done{};
}

/// The same, or "fault=name".
Result<Done> applyOrFault(const std::string& setting, std::vector<NamedPipeline>& algorithms)
{
    constexpr std::string_view kFault = "fault=";
    if (!setting.starts_with(kFault)) return apply(setting, algorithms);
    const FaultEntry* fault = findFault(setting.substr(kFault.size()));
    if (!fault)
        return Error{Trouble::Usage,
                     fmt::format("unknown fault '{}': see 'zscope-cli list faults'", setting.substr(kFault.size()))};
    for (NamedPipeline& algorithm : algorithms) {
        Pipeline faulty = algorithm.pipeline;
        faulty.fault.add(fault->fault);
        rename(algorithm, faulty);
    }
    return Done{};
}

/// Of two choices for one axis nobody could say which was meant.
Result<Done> eachAxisOnce(const std::vector<std::string>& settings)
{
    std::set<std::string, std::less<>> axes;
    for (const std::string& setting : settings) {
        // A pipeline may have several faults.
        const std::string axis = setting.starts_with("fault=") ? setting : setting.substr(0, setting.find('='));
        if (!axes.insert(axis).second) return Error{Trouble::Usage, fmt::format("'{}' is chosen twice", axis)};
    }
    return Done{};
}

/// No algorithm was named: the first preset that takes the settings and the faults.
std::optional<NamedPipeline> firstFitting(const std::vector<std::string>& settings, const FaultSet& faults)
{
    for (const Preset& preset : presets()) {
        std::vector<NamedPipeline> one{{std::string(preset.name), preset.pipeline, preset.claim}};
        for (const std::string& setting : settings)
            if (!apply(setting, one)) return std::nullopt;
        Pipeline changed = one.front().pipeline;
        changed.fault    = faults;
        rename(one.front(), changed);
        if (!explainInvalid(changed)) return one.front();
    }
    return std::nullopt;
}

/// Several algorithms were asked for by one word: those that the settings do not fit are left out.
void keepValid(std::vector<NamedPipeline>& algorithms)
{
    std::erase_if(algorithms, [](const NamedPipeline& each) { return explainInvalid(each.pipeline).has_value(); });
}

}  // namespace

void HowOptions::add(CLI::App& parser, Algorithms algorithms)
{
    m_algorithms            = algorithms;
    const bool        one   = algorithms == Algorithms::One;
    const std::string which = joined(presetNames());
    parser
        .add_option("--algorithm", m_algorithm,
                    one ? fmt::format("Which algorithm draws: {} (default {})", which, kDefaultPreset)
                        : fmt::format("Which algorithms: all, or some of {} (default {})", which, kDefaultPreset))
        ->type_name(one ? "NAME" : "NAME[,NAME...]|all")
        ->group("How");
    parser.add_option("--set", m_set, "Change one choice of the algorithm, see 'list choices' (repeatable)")
        ->type_name("AXIS=CHOICE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group("How");
    parser.add_option("--fault", m_fault, "Make mistakes on purpose, see 'list faults'")
        ->type_name("NAME[+NAME...]")
        ->group("How");
    parser.add_option("--threads", m_threads, "Threads to draw with; 0: one per core (default 0)")
        ->type_name("N")
        ->group("How");
    parser.add_option("--simd", m_simd, "Vector instructions: auto, scalar, sse4, avx2 or avx512 (default auto)")
        ->type_name("WORD")
        ->group("How");
    parser
        .add_option(
            "--shortcuts", m_shortcuts,
            "Which shortcuts draw: all, none (the plain text), names with commas between them, or all-NAME; the "
            "picture has the same bits (default all)")
        ->type_name("WORDS")
        ->group("How");
    parser
        .add_option("--memory-limit", m_memoryLimit,
                    "Most memory that may be taken (default: three quarters of the machine's)")
        ->type_name("MIB")
        ->group("How");
}

Result<std::vector<NamedPipeline>> algorithmsOf(std::string_view words)
{
    std::vector<NamedPipeline> algorithms;
    const auto                 add = [&algorithms](const Preset& preset) {
        algorithms.push_back({std::string(preset.name), preset.pipeline, preset.claim});
    };
    if (words == "all") {
        for (const Preset& preset : presets()) add(preset);
        return algorithms;
    }
    for (const std::string& word : listOf(words)) {
        // As nameOf() writes it: a preset, and after each plus what differs.
        std::size_t   plus   = word.find('+');
        const Preset* preset = findPreset(word.substr(0, plus));
        if (!preset) return unknownWord("algorithm", word.substr(0, plus), presetNames());
        std::vector<NamedPipeline> one{{std::string(preset->name), preset->pipeline, preset->claim}};
        std::vector<std::string>   settings;
        while (plus != std::string::npos) {
            const std::size_t next = word.find('+', plus + 1);
            settings.push_back(word.substr(plus + 1, next - plus - 1));
            plus = next;
        }
        if (const Result<Done> once = eachAxisOnce(settings); !once) return once.error();
        for (const std::string& setting : settings)
            if (const Result<Done> done = applyOrFault(setting, one); !done) return done.error();
        algorithms.push_back(std::move(one.front()));
    }
    return algorithms;
}

Result<std::vector<NamedPipeline>> algorithmsToTime(std::string_view words, ShortcutSet shortcuts)
{
    auto algorithms = algorithmsOf(words);
    if (algorithms && words == "all" && shortcuts.has(Shortcut::Lanes))
        std::erase_if(*algorithms, [](const NamedPipeline& each) { return !hasFastText(each.pipeline); });
    return algorithms;
}

Result<int> threadsOf(std::string_view word)
{
    const auto threads = wholeNumber(word, "--threads", 0, kMaxThreads);
    if (!threads) return threads.error();
    return static_cast<int>(*threads);
}

Result<Simd> simdOf(std::string_view word)
{
    if (word == "auto") return Simd::Auto;
    std::vector<std::string> words{"auto"};
    for (const SimdEntry& entry : simdTargets()) {
        words.emplace_back(entry.word);
        if (entry.word != word) continue;
        if (entry.available) return entry.target;
        return Error{Trouble::Usage, fmt::format("this machine or build has no {}: see 'list simd'", entry.word)};
    }
    return unknownWord("vector target", word, words);
}

Result<std::uint64_t> memoryLimitOf(std::string_view word)
{
    constexpr std::int64_t kMebibyte = 1 << 20;
    const auto             limit     = wholeNumber(word, "--memory-limit", 1, (std::int64_t{1} << 62) / kMebibyte);
    if (!limit) return limit.error();
    return static_cast<std::uint64_t>(*limit * kMebibyte);
}

Result<How> HowOptions::read() const
{
    How      how;
    FaultSet faults;
    if (m_fault) {
        const Result<FaultSet> all = faultsOf(*m_fault);
        if (!all) return all.error();
        faults = *all;
    }
    const std::string_view usual     = faults.isEmpty() ? kDefaultPreset : entryOf(*faults.begin()).preset;
    const std::string      algorithm = m_algorithm.value_or(std::string(usual));
    if (m_algorithms == Algorithms::One && (algorithm == "all" || listOf(algorithm).size() != 1))
        return unknownWord("algorithm", algorithm, presetNames());
    auto algorithms = algorithmsOf(algorithm);
    if (!algorithms) return algorithms.error();
    how.algorithms = *std::move(algorithms);
    if (const Result<Done> once = eachAxisOnce(m_set); !once) return once.error();
    for (const std::string& setting : m_set)
        if (const Result<Done> done = apply(setting, how.algorithms); !done) return done.error();
    if (!faults.isEmpty()) {
        for (NamedPipeline& each : how.algorithms) {
            Pipeline faulty = each.pipeline;
            faulty.fault    = faults;
            rename(each, faulty);
        }
    }
    if (!m_algorithm && explainInvalid(how.algorithm().pipeline)) {
        if (auto fitting = firstFitting(m_set, faults)) how.algorithms = {*std::move(fitting)};
    }
    const NamedPipeline first = how.algorithm();
    if (algorithm == "all") keepValid(how.algorithms);
    if (how.algorithms.empty()) return Error{Trouble::Usage, *explainInvalid(first.pipeline)};
    for (const NamedPipeline& chosen : how.algorithms)
        if (const auto why = explainInvalid(chosen.pipeline)) return Error{Trouble::Usage, *why};

    if (m_threads) {
        const Result<int> threads = threadsOf(*m_threads);
        if (!threads) return threads.error();
        how.threads = *threads;
    }
    if (m_simd) {
        const Result<Simd> simd = simdOf(*m_simd);
        if (!simd) return simd.error();
        how.simd = *simd;
    }
    if (m_shortcuts) {
        const Result<ShortcutSet> shortcuts = shortcutsOf(*m_shortcuts);
        if (!shortcuts) return shortcuts.error();
        how.shortcuts = *shortcuts;
    }
    if (m_memoryLimit) {
        const Result<std::uint64_t> limit = memoryLimitOf(*m_memoryLimit);
        if (!limit) return limit.error();
        how.memoryLimit = *limit;
    }
    return how;
}

DrawRequest How::request(const LoadedScene& scene, const ViewWords::View& view, const Session& session) const
{
    return {.scene       = scene.prepared,
            .camera      = view.camera,
            .faceCulling = view.faceCulling,
            .pipeline    = algorithm().pipeline,
            .threads     = threads,
            .simd        = simd,
            .shortcuts   = shortcuts,
            .shade       = true,
            .memoryLimit = memoryLimit,
            .cancel      = session.cancel()};
}

}  // namespace zscope::cli
