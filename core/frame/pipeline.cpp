#include "core/frame/pipeline.h"

#include <algorithm>
#include <array>

#include "core/frame/presets.h"
#include "core/frame/registry.h"

namespace zscope {

namespace {

std::string joined(std::span<const ChoiceEntry> choices)
{
    std::string words;
    for (const ChoiceEntry& choice : choices) words += (words.empty() ? "" : ", ") + std::string(choice.word);
    return words;
}

}  // namespace

std::span<const AxisEntry> axes()
{
    static constexpr std::array<AxisEntry, 1> kAxes{
        AxisEntry{"scan", "How triangles become pixels", kScanChoices},
    };
    return kAxes;
}

std::string_view chosen(const Pipeline& pipeline, std::string_view)
{
    return kScanChoices[static_cast<std::size_t>(pipeline.scan)].word;
}

Result<Pipeline> withChoice(Pipeline pipeline, std::string_view axis, std::string_view choice)
{
    const auto found = std::ranges::find(axes(), axis, &AxisEntry::word);
    if (found == axes().end()) {
        std::string words;
        for (const AxisEntry& entry : axes()) words += (words.empty() ? "" : ", ") + std::string(entry.word);
        return Error{Trouble::Usage, "there is no axis '" + std::string(axis) + "'; the axes are " + words};
    }
    const auto entry = std::ranges::find(found->choices, choice, &ChoiceEntry::word);
    if (entry == found->choices.end()) {
        return Error{Trouble::Usage, "axis '" + std::string(axis) + "' has no choice '" + std::string(choice) +
                                         "'; its choices are " + joined(found->choices)};
    }
    pipeline.scan = static_cast<Scan>(entry - found->choices.begin());
    return pipeline;
}

std::span<const Preset> presets() { return kPresets; }

const Preset* findPreset(std::string_view name)
{
    const auto found = std::ranges::find(kPresets, name, &Preset::name);
    return found == kPresets.end() ? nullptr : &*found;
}

std::string nameOf(const Pipeline& pipeline)
{
    const auto found = std::ranges::find(kPresets, pipeline, &Preset::pipeline);
    if (found != kPresets.end()) return std::string(found->name);
    std::string name;
    for (const AxisEntry& axis : axes()) name += (name.empty() ? "" : "+") + std::string(chosen(pipeline, axis.word));
    return name;
}

Family familyOf(const Pipeline& pipeline)
{
    const bool sweeps = pipeline.scan == Scan::SweepZLine || pipeline.scan == Scan::SweepIntervals;
    return sweeps ? Family::Sweep : Family::Stream;
}

std::vector<Grain> grainsOf(const Pipeline& pipeline)
{
    switch (pipeline.scan) {
    case Scan::HalfSpace: return {Grain::Frame, Grain::Stage, Grain::Triangle, Grain::Pixel};
    case Scan::EdgeWalk: return {Grain::Frame, Grain::Stage, Grain::Triangle, Grain::Span, Grain::Pixel};
    case Scan::SweepZLine:
    case Scan::SweepIntervals: return {Grain::Frame, Grain::Stage, Grain::Line, Grain::Span, Grain::Pixel};
    }
    return {};
}

std::optional<std::string> explainInvalid(const Pipeline&) { return std::nullopt; }

}  // namespace zscope
