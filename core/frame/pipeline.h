// An algorithm is a composition of choices, one per axis; a preset is a composition that has a textbook name.
//
// Words      axes, choices and presets are named by the words that the command line and the window use
// Growing    a choice is one header in its folder and one line in registry.h; a preset one line in presets.h; a method
//            that stands alone, with its preset, one row in methods.h
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/approximation.h"
#include "core/base/blend_order.h"
#include "core/base/fault.h"
#include "core/base/result.h"
#include "core/probe/grain.h"

namespace zscope {

/// In which order the scene is visited.
enum class Order { Submitted, Octree, Bvh };
/// What is skipped before it becomes pixels; everything outside the frustum always is.
enum class Cull { Frustum, Nodes, Triangles, NodesAndTriangles };
/// How the pyramid is kept true to the depth buffer.
enum class Upkeep { None, OnQuery, AfterPrepass, Pushed, PushedFarthest, Masked };
/// What a triangle is to the pyramid when it is asked about.
enum class TriangleQuery { Box, Triangle };
/// How triangles become pixels: a row of core/frame/methods.h. Those with a fast text have names here, and come first.
enum class Scan { HalfSpace, EdgeWalk, SweepZLine, SweepIntervals, SweepPolygons };
/// When depth is tested, and with it when fragments are shaded.
enum class DepthMoment { Deferred, Late, Early, ZCull, Prepass };
/// Operations of the fragment shader.
enum class ShadingCost { None, Ten, Hundred, Thousand };

/// Fragments are shaded as they come, not once the picture is finished.
constexpr bool shadesFragments(DepthMoment moment) { return moment != DepthMoment::Deferred; }
constexpr int  operationsOf(ShadingCost cost)
{
    return cost == ShadingCost::None ? 0 : cost == ShadingCost::Ten ? 10 : cost == ShadingCost::Hundred ? 100 : 1000;
}
/// What a frame takes over from the one before.
enum class Coherence { None, TwoPass, LastPyramid };

constexpr bool asksNodes(Cull cull) { return cull == Cull::Nodes || cull == Cull::NodesAndTriangles; }
constexpr bool asksTriangles(Cull cull) { return cull == Cull::Triangles || cull == Cull::NodesAndTriangles; }

/// Who makes the choices: the pipeline itself, or core/frame/auto_choice.h from what earlier frames cost.
enum class Chooser { Composed, Measured };

struct Pipeline {
    Chooser       chooser       = Chooser::Composed;
    Order         order         = Order::Submitted;
    Cull          cull          = Cull::Frustum;
    Upkeep        upkeep        = Upkeep::None;
    TriangleQuery query         = TriangleQuery::Box;
    Scan          scan          = Scan::HalfSpace;
    DepthMoment   depth         = DepthMoment::Deferred;
    ShadingCost   cost          = ShadingCost::None;
    Coherence     coherence     = Coherence::None;
    BlendOrder    transparency  = BlendOrder::Sorted;  // in a scene that has transparent surfaces
    Approximation approximation = {};                  // each of its members is an axis
    FaultSet      fault         = {};                  // see core/frame/faults.h

    bool        usesExactRules() const { return !approximation.isAny() && fault.isEmpty(); }
    friend bool operator==(const Pipeline&, const Pipeline&) = default;
};

struct ChoiceEntry {
    std::string_view word;
    std::string_view title;
};

/// One axis of the composition and what can be chosen on it.
struct AxisEntry {
    std::string_view             word;
    std::string_view             title;
    std::span<const ChoiceEntry> choices;
};
std::span<const AxisEntry> axes();

/// The word chosen on `axis`, which must be a word of axes().
std::string_view chosen(const Pipeline& pipeline, std::string_view axis);
/// Sets one axis by words. Errors (Usage) name the words that would have been right.
Result<Pipeline> withChoice(Pipeline pipeline, std::string_view axis, std::string_view choice);

/// What a method promises of its pictures.
enum class Claim {
    Exact,  // the definition's picture, to the bit
    // draws whole faces: which pixels each of them covers is exact; ids are those of a face's first triangle,
    ExactByFace,
    // and the depth on faces that are not plane is a figure
    Approximate,  // publishes its error figures
};

struct Preset {
    std::string_view name;
    std::string_view title;  // one line
    Pipeline         pipeline;
    Claim            claim = Claim::Exact;

    constexpr bool isExact() const { return claim == Claim::Exact; }
};
std::span<const Preset> presets();
/// What draws where nobody has said how.
inline constexpr std::string_view kDefaultPreset = "auto";
const Preset*                     findPreset(std::string_view name);  // nullptr: no preset has this name
/// The name of the preset that the pipeline is, or of the one that comes closest with what differs:
/// "zbuffer+near=drop".
std::string nameOf(const Pipeline& pipeline);

/// Of a measured pipeline, what follows speaks of the z-buffer, with which it begins where little is in view; what a
/// larger scene begins with may have more grains, see repeatable() in core/frame/frame_plan.h.

/// The word for methods of its kind: "stream" draws triangle after triangle, "sweep" the scene line by line. Others
/// have families of their own.
std::string_view familyOf(const Pipeline& pipeline);
/// It draws the scene line by line, with an edge table and active edges, not triangle after triangle.
bool drawsLineByLine(const Pipeline& pipeline);
/// It draws whole faces as they were read, so that the ids in its pictures are those of faces' first triangles.
bool drawsFaces(const Pipeline& pipeline);
/// Its run can begin again before any batch; else only once everything is set up.
bool drawsBatchByBatch(const Pipeline& pipeline);
/// Why no shortcuts draw it, in one clause; empty: there is a fast text of it.
std::string_view whyNoFastText(const Pipeline& pipeline);
inline bool      hasFastText(const Pipeline& pipeline) { return whyNoFastText(pipeline).empty(); }
/// The coarsest grain of the method itself: that in which a lecture would step through it.
Grain ownGrainOf(const Pipeline& pipeline);
/// What it promises of its pictures: nothing but figures as soon as an approximation or a fault is chosen.
Claim              claimOf(const Pipeline& pipeline);
std::vector<Grain> grainsOf(const Pipeline& pipeline);  // coarse to fine
/// Why this composition cannot run, in one sentence; nothing if it can.
std::optional<std::string> explainInvalid(const Pipeline& pipeline);

}  // namespace zscope
