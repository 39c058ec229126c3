#include "core/frame/pipeline.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/frame/faults.h"
#include "core/frame/methods.h"
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
    static constexpr std::array kAxes{
        AxisEntry{"chooser", "What decides between methods", kChooserChoices},
        AxisEntry{"order", "In which order the scene is visited", kOrderChoices},
        AxisEntry{"cull", "What is skipped before it becomes pixels", kCullChoices},
        AxisEntry{"upkeep", "How the pyramid is kept true to the depth buffer", kUpkeepChoices},
        AxisEntry{"query", "What of a triangle the pyramid is asked about", kQueryChoices},
        AxisEntry{"scan", "How triangles become pixels", kScanChoices},
        AxisEntry{"depth", "When depth is tested and fragments are shaded", kDepthChoices},
        AxisEntry{"shading-cost", "What shading a fragment costs", kShadingCostChoices},
        AxisEntry{"transparency", "In which order transparent surfaces are blended", kTransparencyChoices},
        AxisEntry{"coherence", "What a frame takes over from the one before", kCoherenceChoices},
        AxisEntry{"snap", "How finely corners are snapped", kSnapChoices},
        AxisEntry{"vertices", "In which numbers vertices are transformed", kVertexChoices},
        AxisEntry{"depth-numbers", "How a fragment's depth is found", kDepthNumberChoices},
        AxisEntry{"depth-format", "How a depth is stored", kDepthFormatChoices},
        AxisEntry{"edges", "How edges move from line to line", kEdgeChoices},
        AxisEntry{"near", "What happens at the near plane", kNearChoices},
        AxisEntry{"cells", "How far down the pyramid is asked", kCellChoices},
        AxisEntry{"small-nodes", "What becomes of nodes that are small on the screen", kSmallNodeChoices},
    };
    return kAxes;
}

namespace {

/// Hands the member of `pipeline` that `axis` names to `use`; false if there is no such axis.
template <class Pipe, class Use>
bool withAxis(Pipe& pipeline, std::string_view axis, const Use& use)
{
    if (axis == "chooser") return use(pipeline.chooser), true;
    if (axis == "order") return use(pipeline.order), true;
    if (axis == "cull") return use(pipeline.cull), true;
    if (axis == "upkeep") return use(pipeline.upkeep), true;
    if (axis == "query") return use(pipeline.query), true;
    if (axis == "scan") return use(pipeline.scan), true;
    if (axis == "depth") return use(pipeline.depth), true;
    if (axis == "shading-cost") return use(pipeline.cost), true;
    if (axis == "transparency") return use(pipeline.transparency), true;
    if (axis == "coherence") return use(pipeline.coherence), true;
    if (axis == "snap") return use(pipeline.approximation.snap), true;
    if (axis == "vertices") return use(pipeline.approximation.vertex), true;
    if (axis == "depth-numbers") return use(pipeline.approximation.depth), true;
    if (axis == "depth-format") return use(pipeline.approximation.format), true;
    if (axis == "edges") return use(pipeline.approximation.edges), true;
    if (axis == "near") return use(pipeline.approximation.near), true;
    if (axis == "cells") return use(pipeline.approximation.cells), true;
    if (axis == "small-nodes") return use(pipeline.approximation.small), true;
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
        return Error{Trouble::Usage, "axis '" + std::string(axis) + "' has no choice '" + std::string(choice)
                                         + "'; its choices are " + joined(found->choices)};
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
    const auto differs = [&](const Preset& preset, const AxisEntry& axis) {
        return chosen(preset.pipeline, axis.word) != chosen(pipeline, axis.word);
    };
    const auto distance = [&](const Preset& preset) {
        return std::ranges::count_if(axes(), [&](const AxisEntry& axis) { return differs(preset, axis); });
    };
    const Preset& closest = *std::ranges::min_element(kPresets, {}, distance);
    std::string   name(closest.name);
    for (const AxisEntry& axis : axes())
        if (differs(closest, axis))
            name += '+' + std::string(axis.word) + '=' + std::string(chosen(pipeline, axis.word));
    for (const Fault fault : pipeline.fault) name += "+fault=" + std::string(entryOf(fault).word);
    return name;
}

std::string_view familyOf(const Pipeline& pipeline) { return methodOf(pipeline).family; }
bool             drawsLineByLine(const Pipeline& pipeline) { return methodOf(pipeline).drawsLineByLine; }
bool             drawsFaces(const Pipeline& pipeline) { return methodOf(pipeline).drawsFaces; }
bool drawsBatchByBatch(const Pipeline& pipeline) { return !drawsLineByLine(pipeline) && !methodOf(pipeline).whole; }
std::string_view whyNoFastText(const Pipeline& pipeline) { return methodOf(pipeline).whyNoFastText; }
Grain            ownGrainOf(const Pipeline& pipeline) { return methodOf(pipeline).grains.front(); }

Claim claimOf(const Pipeline& pipeline)
{
    if (!pipeline.usesExactRules() || pipeline.coherence == Coherence::LastPyramid
        || pipeline.transparency != BlendOrder::Sorted)
        return Claim::Approximate;
    return methodOf(pipeline).claim;
}

std::vector<Grain> grainsOf(const Pipeline& pipeline)
{
    std::vector<Grain> grains{Grain::Frame, Grain::Stage};
    if (pipeline.order != Order::Submitted) grains.push_back(Grain::Node);
    const bool hasCells = pipeline.upkeep != Upkeep::None || pipeline.depth == DepthMoment::ZCull;
    if (hasCells) grains.insert(grains.end(), {Grain::Query, Grain::Update});
    const auto own = methodOf(pipeline).grains;
    grains.insert(grains.end(), own.begin(), own.end());
    std::ranges::sort(grains);
    return grains;
}

namespace {

/// Whether only the chooser, what shading and blending do, the approximations and the faults differ from a plain
/// z-buffer's.
bool leavesChoicesOpen(const Pipeline& pipeline)
{
    return pipeline
           == Pipeline{.chooser       = pipeline.chooser,
                       .cost          = pipeline.cost,
                       .transparency  = pipeline.transparency,
                       .approximation = pipeline.approximation,
                       .fault         = pipeline.fault};
}

bool asksThePyramid(const Pipeline& pipeline) { return asksNodes(pipeline.cull) || asksTriangles(pipeline.cull); }

/// Why the approximations and the faults do not fit the rest, or nothing.
std::optional<std::string> explainMisfit(const Pipeline& pipeline)
{
    const Approximation& approximation = pipeline.approximation;
    const bool           walksLines    = methodOf(pipeline).stepsAlongLines;
    if (approximation.snap == SnapBits::Twelve && walksLines)
        return "Steps from line to line count in 1/256 pixel: choose scan=half-space for 12 bits";
    if (approximation.depth == DepthNumbers::Accumulated && !walksLines)
        return "Half-spaces have no span to carry a depth along: choose scan=edge-walk or a sweep";
    if (approximation.edges == EdgeSteps::Accumulated && pipeline.scan != Scan::EdgeWalk)
        return "Only the edge walk can step by float32: choose scan=edge-walk";
    if (approximation.cells == CellDescent::OneLevel) {
        if (!asksThePyramid(pipeline))
            return "Nobody asks the pyramid: choose a cull by nodes or triangles, or cells=descend";
        if (pipeline.query == TriangleQuery::Triangle)
            return "One level is asked by rectangles: choose query=box or cells=descend";
    }
    if (approximation.small != SmallNodes::Keep && pipeline.order == Order::Submitted)
        return "Only a hierarchy has nodes that could be small: choose order=octree or order=bvh, or small-nodes=keep";
    for (const Fault fault : pipeline.fault) {
        const FaultEntry& entry = entryOf(fault);
        if (entry.canHappen(pipeline)) continue;
        return "The fault '" + std::string(entry.word) + "' cannot happen here: it is one of "
               + std::string(entry.place) + ", as in " + std::string(entry.preset);
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> explainInvalid(const Pipeline& pipeline)
{
    if (pipeline.chooser == Chooser::Measured && !leavesChoicesOpen(pipeline))
        return "What is measured makes the choices itself: leave order, cull, upkeep, query, scan, depth and coherence "
               "as they are, or choose chooser=composed";
    if (auto misfit = explainMisfit(pipeline)) return misfit;
    if (pipeline.query == TriangleQuery::Triangle && !asksTriangles(pipeline.cull))
        return "Nobody asks the pyramid about triangles: choose cull=triangles or cull=nodes-triangles, or query=box";
    return methodOf(pipeline).explainMisfit(pipeline);
}

std::optional<std::string> misfitOfSweep(const Pipeline& pipeline)
{
    if (pipeline.order != Order::Submitted) return "A sweep sorts the scene by lines itself: choose order=submitted";
    if (asksThePyramid(pipeline) || pipeline.upkeep != Upkeep::None)
        return "A sweep keeps no depth buffer to build a pyramid on: choose cull=frustum and upkeep=none";
    if (shadesFragments(pipeline.depth))
        return "A sweep decides each line once and shades it once: choose depth=deferred";
    if (pipeline.coherence != Coherence::None) return "A sweep visits no nodes to remember: choose coherence=none";
    return std::nullopt;
}

std::optional<std::string> misfitOfWhole(const Pipeline& pipeline)
{
    const Order order = methodOf(pipeline).order;
    if (pipeline.order != order)
        return order == Order::Submitted ? "This method orders the scene itself: choose order=submitted"
                                         : "This method visits a bounding volume hierarchy: choose order=bvh";
    if (asksThePyramid(pipeline) || pipeline.upkeep != Upkeep::None)
        return "This method asks no pyramid: choose cull=frustum and upkeep=none";
    if (shadesFragments(pipeline.depth))
        return "This method is shaded when the picture is finished: choose depth=deferred";
    if (pipeline.coherence != Coherence::None)
        return "This method begins every frame from nothing: choose coherence=none";
    if (pipeline.approximation.snap == SnapBits::Twelve)
        return "This method tests large triangles in whole steps of 1/256 pixel: choose scan=half-space for 12 bits";
    return std::nullopt;
}

std::optional<std::string> misfitOfTriangles(const Pipeline& pipeline)
{
    const bool asks = asksThePyramid(pipeline);
    if (pipeline.depth == DepthMoment::ZCull && pipeline.scan != Scan::HalfSpace)
        return "An edge walk goes by lines and knows no tiles: choose scan=half-space or depth=early";
    if (pipeline.depth == DepthMoment::ZCull && pipeline.upkeep != Upkeep::None && pipeline.upkeep != Upkeep::OnQuery)
        return "Z-cull finds a stale tile's depth again when it reads it: choose upkeep=on-query or none";
    if (asks && pipeline.upkeep == Upkeep::None) return "Culling by depth needs a pyramid: choose an upkeep";
    if (!asks && pipeline.upkeep != Upkeep::None)
        return "Nobody would ask the pyramid: choose a cull by nodes or triangles, or upkeep=none";
    if (asksNodes(pipeline.cull) && pipeline.order == Order::Submitted)
        return "Culling nodes needs a hierarchy: choose order=octree or order=bvh";
    if (pipeline.upkeep == Upkeep::AfterPrepass && pipeline.depth != DepthMoment::Prepass)
        return "There is no pre-pass to build the pyramid after: choose depth=prepass or upkeep=on-query";
    const bool followsWrites = pipeline.upkeep != Upkeep::None && pipeline.upkeep != Upkeep::AfterPrepass;
    if (followsWrites && pipeline.depth == DepthMoment::Prepass)
        return "After a pre-pass depths no longer change: choose upkeep=after-prepass";
    if (pipeline.coherence == Coherence::LastPyramid && !asks)
        return "Nobody would ask the last frame's pyramid: choose a cull by nodes or triangles, or coherence=none";
    if (pipeline.coherence == Coherence::TwoPass && !asksNodes(pipeline.cull))
        return "Only nodes that the pyramid is asked about are remembered: choose a cull by nodes, or coherence=none";
    const bool testsTwice = pipeline.depth == DepthMoment::Prepass || pipeline.depth == DepthMoment::ZCull;
    if (pipeline.coherence != Coherence::None && testsTwice)
        return "Between frames only one test of depth is at work: choose depth=deferred, late or early, or "
               "coherence=none";
    if (pipeline.coherence != Coherence::None && pipeline.upkeep != Upkeep::OnQuery)
        return "What a frame takes over is brought up to date as a whole: choose upkeep=on-query, or coherence=none";
    return std::nullopt;
}

}  // namespace zscope
