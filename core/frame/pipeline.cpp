#include "core/frame/pipeline.h"

#include <algorithm>
#include <array>
#include <type_traits>

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
    static constexpr std::array<AxisEntry, 5> kAxes{
        AxisEntry{"order", "In which order the scene is visited", kOrderChoices},
        AxisEntry{"cull", "What is skipped before it becomes pixels", kCullChoices},
        AxisEntry{"upkeep", "How the pyramid is kept true to the depth buffer", kUpkeepChoices},
        AxisEntry{"scan", "How triangles become pixels", kScanChoices},
        AxisEntry{"depth", "When depth is decided", kDepthChoices},
    };
    return kAxes;
}

namespace {

/// Hands the member of `pipeline` that `axis` names to `use`; false if there is no such axis.
template <class Pipe, class Use>
bool withAxis(Pipe& pipeline, std::string_view axis, const Use& use)
{
    if (axis == "order") return use(pipeline.order), true;
    if (axis == "cull") return use(pipeline.cull), true;
    if (axis == "upkeep") return use(pipeline.upkeep), true;
    if (axis == "scan") return use(pipeline.scan), true;
    if (axis == "depth") return use(pipeline.depth), true;
    return false;
}

}  // namespace

std::string_view chosen(const Pipeline& pipeline, std::string_view axis)
{
    const auto  entry = std::ranges::find(axes(), axis, &AxisEntry::word);
    std::size_t index = 0;
    withAxis(pipeline, axis, [&index](const auto& choice) { index = static_cast<std::size_t>(choice); });
    return entry->choices[index].word;
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
    withAxis(pipeline, axis, [&](auto& member) {
        member = static_cast<std::remove_reference_t<decltype(member)>>(entry - found->choices.begin());
    });
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
    if (familyOf(pipeline) == Family::Sweep) return {Grain::Frame, Grain::Stage, Grain::Line, Grain::Span, Grain::Pixel};
    std::vector<Grain> grains{Grain::Frame, Grain::Stage};
    if (pipeline.order != Order::Submitted) grains.push_back(Grain::Node);
    grains.push_back(Grain::Triangle);
    if (pipeline.scan == Scan::EdgeWalk) grains.push_back(Grain::Span);
    grains.push_back(Grain::Pixel);
    return grains;
}

std::optional<std::string> explainInvalid(const Pipeline& pipeline)
{
    const bool asks = asksNodes(pipeline.cull) || asksTriangles(pipeline.cull);
    if (familyOf(pipeline) == Family::Sweep) {
        if (pipeline.order != Order::Submitted) return "A sweep sorts the scene by lines itself: choose order=submitted";
        if (asks || pipeline.upkeep != Upkeep::None) return "A sweep keeps no depth buffer to build a pyramid on: choose cull=frustum and upkeep=none";
        if (pipeline.depth != DepthMoment::AtOnce) return "A sweep decides each line once: choose depth=at-once";
        return std::nullopt;
    }
    if (asks && pipeline.upkeep == Upkeep::None) return "Culling by depth needs a pyramid: choose an upkeep";
    if (!asks && pipeline.upkeep != Upkeep::None) return "Nobody would ask the pyramid: choose a cull by nodes or triangles, or upkeep=none";
    if (asksNodes(pipeline.cull) && pipeline.order == Order::Submitted) return "Culling nodes needs a hierarchy: choose order=octree or order=bvh";
    if (pipeline.upkeep == Upkeep::AfterPrepass && pipeline.depth != DepthMoment::Prepass) return "There is no pre-pass to build the pyramid after: choose depth=prepass or upkeep=on-query";
    if (pipeline.upkeep == Upkeep::OnQuery && pipeline.depth == DepthMoment::Prepass) return "After a pre-pass depths no longer change: choose upkeep=after-prepass";
    return std::nullopt;
}

}  // namespace zscope
