#include "core/frame/shortcuts.h"

#include <algorithm>

#include "core/base/quotable.h"
#include "core/geometry/rules.h"

namespace zscope {

namespace {

using Reason = std::string_view;  // empty: none

// Of approximations, in the words of the lists.
bool movesCorners(const Pipeline& pipeline)
{
    const Approximation& of = pipeline.approximation;
    return of.vertex != VertexNumbers::Float64 || of.snap != SnapBits::Eight;
}
bool hasOtherDepths(const Pipeline& pipeline)
{
    const Approximation& of = pipeline.approximation;
    return of.depth != DepthNumbers::Float64 || of.format != DepthFormat::ReversedFloat32;
}
bool dependsOnVisit(const Pipeline& pipeline)
{
    const Approximation& of = pipeline.approximation;
    return of.small != SmallNodes::Keep;
}

Reason ofCorners(const Pipeline& pipeline)
{
    if (movesCorners(pipeline))
        return "its margins are those of corners by the definition, and these corners may stand farther off";
    return {};
}

Reason ofTriangles(const Pipeline& pipeline)
{
    if (drawsLineByLine(pipeline)) return "the method draws line by line, not triangle by triangle";
    if (pipeline.scan != Scan::HalfSpace) return "the method walks along edges and tests no half-spaces";
    return {};
}

Reason ofPlanes(const Pipeline& pipeline)
{
    if (const Reason why = ofTriangles(pipeline); !why.empty()) return why;
    if (pipeline.depth == DepthMoment::Prepass) return "after a pre-pass the depth of every pixel is read";
    if (hasOtherDepths(pipeline)) return "planes stand for depths by the definition only";
    if (pipeline.upkeep != Upkeep::None && pipeline.upkeep != Upkeep::OnQuery)
        return "this upkeep of the pyramid reads pixels while the picture is drawn";
    return {};
}

Reason ofStacking(const Pipeline& pipeline)
{
    if (hasOtherDepths(pipeline) || pipeline.approximation.vertex != VertexNumbers::Float64)
        return "only depths by the definition may be scaled by a power of two without losing a bit";
    if (drawsFaces(pipeline)) return "whole faces know depths of one scale only";
    if (pipeline.coherence == Coherence::LastPyramid) return "the last frame's pyramid holds depths of its own scale";
    return {};
}

Reason ofEdges(const Pipeline& pipeline)
{
    if (!drawsLineByLine(pipeline)) return "the method has no edge table";
    return {};
}

Reason ofSubmitted(const Pipeline& pipeline)
{
    if (pipeline.order != Order::Submitted) return "the method draws the batches of a tree's nodes";
    return ofCorners(pipeline);
}

Reason ofStoredTiles(const Pipeline& pipeline)
{
    if (const Reason why = ofTriangles(pipeline); !why.empty()) return why;
    if (pipeline.depth == DepthMoment::Late) return "every covered fragment is shaded, so none may be left out";
    if (pipeline.upkeep != Upkeep::OnQuery && pipeline.depth != DepthMoment::ZCull)
        return "no pyramid waits for a question";
    return {};
}

Reason ofNodes(const Pipeline& pipeline)
{
    if (pipeline.order == Order::Submitted) return "the method visits no nodes";
    return {};
}

Reason ofNodeQuestions(const Pipeline& pipeline)
{
    if (const Reason why = ofNodes(pipeline); !why.empty()) return why;
    if (!asksNodes(pipeline.cull)) return "the method does not ask the pyramid about nodes";
    if (dependsOnVisit(pipeline)) return "the picture depends on what is asked about nodes";
    return {};
}

Reason ofQuestions(const Pipeline& pipeline)
{
    if (pipeline.upkeep == Upkeep::AfterPrepass && asksTriangles(pipeline.cull)) return {};
    if (pipeline.depth == DepthMoment::ZCull) return {};
    return ofNodeQuestions(pipeline);
}

Reason ofBalls(const Pipeline& pipeline)
{
    if (const Reason why = ofNodeQuestions(pipeline); !why.empty()) return why;
    return ofCorners(pipeline);
}

Reason ofPixelQuestions(const Pipeline& pipeline)
{
    if (const Reason why = ofTriangles(pipeline); !why.empty()) return why;
    if (const Reason why = ofBalls(pipeline); !why.empty()) return why;
    if (pipeline.cull != Cull::NodesAndTriangles || pipeline.upkeep != Upkeep::OnQuery
        || pipeline.depth != DepthMoment::Deferred)
        return "it is for methods that ask about nodes and triangles, refresh cells on demand and shade at the end";
    if (pipeline.coherence == Coherence::LastPyramid) return "the pyramid is the last frame's";
    if (hasOtherDepths(pipeline)) return "pixels are compared with depths by the definition";
    return {};
}

Reason never(const Pipeline&) { return {}; }

constexpr std::array<Shortcut, 0> kNothing{};
constexpr std::array              kLanes{Shortcut::Lanes};
constexpr std::array              kTwoLevels{Shortcut::TwoLevelPyramid};
constexpr std::array              kSquares{Shortcut::HiddenSquares};

constexpr std::array kShortcuts{
    ShortcutEntry{"lanes", "Vertices, triangles, edges and pixels side by side, in SIMD lanes",
                  ShortcutKind::Replacement, "one vertex, triangle and pixel after the other", kNothing, never},
    ShortcutEntry{"windows", "Small triangles of a batch together, in windows of 4 by 4 pixels",
                  ShortcutKind::Replacement, "each triangle by itself, over its box", kLanes, ofTriangles},
    ShortcutEntry{"large-triangles", "Which tiles a large triangle has pixels of first, then tile after tile",
                  ShortcutKind::Replacement, "each tile of a triangle's box in turn", kLanes, ofTriangles},
    ShortcutEntry{"wide-tiles", "Triangles beyond the guard band tile by tile, with edges in 128 bits",
                  ShortcutKind::Replacement, "walking along their edges", kLanes, ofTriangles},
    ShortcutEntry{"tile-planes", "A tile that one triangle covers is kept as that triangle's plane",
                  ShortcutKind::Storage, "a depth and an id for each pixel at once", kLanes, ofPlanes},
    ShortcutEntry{"stacked-depths", "The depths of each picture lie above those of the last one", ShortcutKind::Storage,
                  "clearing the picture before each frame", kLanes, ofStacking},
    ShortcutEntry{"shared-sides", "Where two triangles meet there is one edge, which closes one and opens the other",
                  ShortcutKind::Storage, "three edges for each triangle", kLanes, ofEdges},
    ShortcutEntry{"patched-batches", "Where back faces are culled, batches stand patch by patch", ShortcutKind::Storage,
                  "triangles in the order of the file", kLanes, ofSubmitted},
    ShortcutEntry{"facing-cones", "Where back faces are culled, batches and patches that face away are left out",
                  ShortcutKind::Filter, "the turn of each triangle", kLanes, ofCorners},
    ShortcutEntry{"patch-reach",
                  "Of a batch at the stripe's border, patches that reach none of its pixels are left out",
                  ShortcutKind::Filter, "the box of each triangle", kLanes, ofCorners},
    ShortcutEntry{"stored-tiles", "Tiles whose stored depth hides a triangle are left out, and tell their depth",
                  ShortcutKind::Filter, "a depth test for each covered pixel", kLanes, ofStoredTiles},
    ShortcutEntry{"two-level-pyramid", "A pyramid of two levels, of which a question reads many tiles at once",
                  ShortcutKind::Storage, "a pyramid with a level for each halving", kLanes, ofPixelQuestions},
    ShortcutEntry{"hidden-squares", "Before set-up, patches and triangles behind squares of nearer pixels are left out",
                  ShortcutKind::Filter, "a question about each triangle after its set-up", kTwoLevels,
                  ofPixelQuestions},
    ShortcutEntry{"node-balls", "A node reaches no farther than a ball around it", ShortcutKind::Filter,
                  "the rectangle of the node's box", kLanes, ofBalls},
    ShortcutEntry{"skipped-questions", "Questions that are seldom answered with \"hidden\" are mostly left out",
                  ShortcutKind::Order, "a question about each node, triangle and tile", kLanes, ofQuestions},
    ShortcutEntry{"nearest-node", "From within a tree's box the nearest of all nodes that wait is next",
                  ShortcutKind::Order, "branch after branch, nearer children first", kLanes, ofNodes},
    ShortcutEntry{"whole-nodes", "Small nodes are drawn with everything below them, not divided", ShortcutKind::Order,
                  "every node is divided down to its leaves", kSquares, ofPixelQuestions},
    ShortcutEntry{"nearest-triangle", "The large triangles of a node's batch, the nearest first", ShortcutKind::Order,
                  "the triangles of a batch as they stand", kLanes, ofNodes},
};
static_assert(kShortcuts.size() == kShortcutCount);

Shortcut at(std::size_t place) { return static_cast<Shortcut>(place); }

std::optional<Shortcut> find(std::string_view name)
{
    const auto entry = std::ranges::find(kShortcuts, name, &ShortcutEntry::name);
    if (entry == kShortcuts.end()) return std::nullopt;
    return at(static_cast<std::size_t>(entry - kShortcuts.begin()));
}

Error unknown(std::string_view name)
{
    std::string names;
    for (const ShortcutEntry& entry : kShortcuts) names += (names.empty() ? "" : ", ") + std::string(entry.name);
    return Error{Trouble::Usage,
                 "there is no shortcut '" + quotable(name)
                     + "'; shortcuts are all, none, all-NAME or names with commas between them, of: " + names};
}

}  // namespace

std::string_view wordOf(ShortcutKind kind)
{
    switch (kind) {
        case ShortcutKind::Replacement:
            return "replacement";
        case ShortcutKind::Filter:
            return "filter";
        case ShortcutKind::Order:
            return "order";
        case ShortcutKind::Storage:
            return "storage";
    }
    return "";
}

std::span<const ShortcutEntry> shortcutEntries() { return kShortcuts; }
const ShortcutEntry&           entryOf(Shortcut shortcut) { return kShortcuts[static_cast<std::size_t>(shortcut)]; }

ShortcutSet with(ShortcutSet set, Shortcut added)
{
    set.add(added);
    for (const Shortcut needed : entryOf(added).needs) set = with(set, needed);
    return set;
}

ShortcutSet without(ShortcutSet set, Shortcut left)
{
    set.remove(left);
    for (std::size_t i = 0; i < kShortcuts.size(); ++i)
        if (set.has(at(i)) && std::ranges::find(kShortcuts[i].needs, left) != kShortcuts[i].needs.end())
            set = without(set, at(i));
    return set;
}

Result<ShortcutSet> shortcutsOf(std::string_view words)
{
    if (words == "all") return ShortcutSet::all();
    if (words == "none") return ShortcutSet();
    constexpr std::string_view kAllBut = "all-";
    ShortcutSet                set     = words.starts_with(kAllBut) ? ShortcutSet::all() : ShortcutSet();
    for (std::string_view rest = words;;) {
        const std::size_t comma  = rest.find(',');
        std::string_view  name   = rest.substr(0, comma);
        const bool        leaves = name.starts_with(kAllBut);
        if (leaves) name.remove_prefix(kAllBut.size());
        const std::optional<Shortcut> shortcut = find(name);
        if (!shortcut) return unknown(name);
        set = leaves ? without(set, *shortcut) : with(set, *shortcut);
        if (comma == std::string_view::npos) return set;
        rest.remove_prefix(comma + 1);
    }
}

std::string wordsOf(ShortcutSet set)
{
    if (set.isAll()) return "all";
    if (set.isEmpty()) return "none";
    std::string names;
    for (std::size_t i = 0; i < kShortcuts.size(); ++i) {
        const std::string name(kShortcuts[i].name);
        if (without(ShortcutSet::all(), at(i)) == set) return "all-" + name;
        if (set.has(at(i))) names += (names.empty() ? "" : ",") + name;
    }
    return names;
}

std::string_view whyPlain(const Pipeline& pipeline)
{
    if (!pipeline.fault.isEmpty()) return "a faulty pipeline runs the plain text";
    if (const std::string_view why = whyNoFastText(pipeline); !why.empty()) return why;
    const Approximation& of = pipeline.approximation;
    if (of.cells != CellDescent::Descend)
        return "such questions are answered by what has been drawn before, and so by the plain text's order alone";
    if (of.snap == SnapBits::Twelve)
        return "lanes compute with whole steps of 1/256 pixel, and these corners lie between them";
    if (!of.suitsLanes())
        return "accumulated numbers are carried from pixel to pixel and from line to line, one after the other";
    return {};
}

ShortcutSet applicable(ShortcutSet set, const Pipeline& pipeline)
{
    if (!whyPlain(pipeline).empty()) return {};
    ShortcutSet all = set;
    for (std::size_t i = 0; i < kShortcuts.size(); ++i)
        if (!kShortcuts[i].whyNot(pipeline).empty()) all.remove(at(i));
    return all;
}

std::vector<ShortcutUse> usesOf(ShortcutSet chosen, const Pipeline& pipeline)
{
    const std::string_view   plain = whyPlain(pipeline);
    std::vector<ShortcutUse> uses;
    for (std::size_t i = 0; i < kShortcuts.size(); ++i) {
        const ShortcutEntry& entry = kShortcuts[i];
        ShortcutUse          use{entry.name, false, {}};
        if (const std::string_view why = plain.empty() ? entry.whyNot(pipeline) : plain; !why.empty())
            use.why = why;
        else if (!chosen.has(at(i)))
            use.why = "it was not chosen";
        else
            use = {entry.name, true, "in place of " + std::string(entry.replaces)};
        uses.push_back(std::move(use));
    }
    return uses;
}

}  // namespace zscope
