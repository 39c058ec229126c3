#include "core/lesson/sentences.h"

#include <string_view>

#include <fmt/format.h>

#include "core/lesson/words.h"

namespace zscope {

namespace {

std::uint64_t coveredPixels(const VisibilityBuffer& visible)
{
    std::uint64_t covered = 0;
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x) covered += visible.rankAt(x, y) != 0;
    return covered;
}

std::string stageOver(const StepState& state)
{
    switch (state.stage) {
        case Stage::Clear:
            return "The picture is cleared: every pixel is background, farther than anything that may be kept.";
        case Stage::Setup: {
            std::uint64_t edges = 0;
            for (const int starting : state.sweep->edgesStarting) edges += static_cast<std::uint64_t>(starting);
            return fmt::format("The edge table is complete: {} in the buckets of their first lines, none active yet.",
                               counted(edges, "edge waits", "edges wait"));
        }
        case Stage::Raster:
            return fmt::format("Every pixel is decided: {} a triangle, the nearest that covers it.",
                               counted(coveredPixels(state.frame.visible), "pixel shows", "pixels show"));
        case Stage::Shade:
            return fmt::format(
                "{} taken the colour of its triangle, once.",
                counted(coveredPixels(state.frame.visible), "covered pixel has", "covered pixels have each"));
        default:
            return fmt::format("The stage '{}' is over.", wordOf(state.stage));
    }
}

/// What a sweep's polygons are called.
std::string_view nameOfPolygons(const Pipeline& pipeline, bool several)
{
    if (drawsFaces(pipeline)) return several ? "faces" : "face";
    return several ? "triangles" : "triangle";
}

std::string changesOf(const SweepState& sweep, const Pipeline& pipeline)
{
    if (sweep.entered.empty() && sweep.left.empty()) return "no edge enters or leaves";
    std::string text;
    if (sweep.entered.size() == 1)
        text = fmt::format("an edge of {} {} enters, because this is its first line", nameOfPolygons(pipeline, false),
                           grouped(sweep.entered[0].polygon.value));
    else if (!sweep.entered.empty())
        text = fmt::format("{} edges enter on their first line", grouped(sweep.entered.size()));
    if (sweep.left.empty()) return text;
    if (!text.empty()) text += "; ";
    if (sweep.left.size() == 1)
        return text
               + fmt::format("an edge of {} {} leaves: its last line was {}", nameOfPolygons(pipeline, false),
                             grouped(sweep.left[0].polygon.value), sweep.left[0].lastLine);
    return text + fmt::format("{} edges leave: their last lines are past", grouped(sweep.left.size()));
}

std::string lineReady(const SweepState& sweep, const Pipeline& pipeline)
{
    return fmt::format("The sweep reaches line {}: {}. {}, sorted by x.", sweep.y, changesOf(sweep, pipeline),
                       counted(sweep.activeEdges.size(), "edge is active", "edges are active"));
}

std::string lineOver(const SweepState& sweep, const Pipeline& pipeline)
{
    return fmt::format(
        "Line {} is drawn: {}. {} between {} gave {}.", sweep.y, changesOf(sweep, pipeline),
        counted(sweep.activePolygons.size(), nameOfPolygons(pipeline, false), nameOfPolygons(pipeline, true)),
        counted(sweep.activeEdges.size(), "active edge", "active edges"), counted(sweep.spans.size(), "span", "spans"));
}

std::string spanOver(const StepState& state, const Pipeline& pipeline)
{
    const SpanRow&    span   = *state.span;
    const std::string pixels = span.x1 - span.x0 == 1 ? fmt::format("pixel {}", span.x0)
                                                      : fmt::format("pixels {} to {}", span.x0, span.x1 - 1);
    if (pipeline.scan == Scan::SweepIntervals || drawsFaces(pipeline))
        return fmt::format(
            "Between two neighbouring edges {} {} is the nearest that is open: {} of line {} {} its own.",
            nameOfPolygons(pipeline, false), grouped(span.polygon.value), pixels, state.sweep->y,
            span.x1 - span.x0 == 1 ? "is" : "are");
    return fmt::format("Triangle {} covers {} of its line: those whose centres lie between its left and right edge.",
                       grouped(span.polygon.value), pixels);
}

std::string nodeOver(const HierarchyState& hierarchy)
{
    const NodeRow&    node = hierarchy.nodes[static_cast<std::size_t>(hierarchy.now)];
    const std::string name = node.instance
                                 ? fmt::format("Node {} of instance {}", node.path, grouped(node.instance->value))
                                 : fmt::format("Node {} of the instances", node.path);
    if (hierarchy.pass == 1) return name + " was visible in the last frame: the first pass draws it without asking.";
    const bool        wasDrawn = hierarchy.pass == 2 && node.pass == 1;
    const std::string fate     = wasDrawn ? " The first pass has drawn it, and it " : "";
    if (node.verdict == NodeVerdict::Outside) return name + " lies outside the view: nothing in it is looked at.";
    if (node.verdict == NodeVerdict::Small)
        return name + " has fewer pixels on the screen than this approximation keeps: it is left out.";
    if (!hierarchy.query)
        return name + " is entered: it may be in view, and nobody can say that it is hidden."
               + (wasDrawn ? fate + "stays remembered." : "");
    const PyramidQuery& q    = *hierarchy.query;
    const std::string   size = fmt::format(
          " covers {} x {} pixels, so level {} of the pyramid is asked: farthest there {:.7g}, node at most {:.7g}:",
          q.box.x1 - q.box.x0, q.box.y1 - q.box.y0, q.level, q.value, q.nearest);
    if (wasDrawn)
        return name + size
               + (q.hidden ? " hidden." + fate + "is forgotten." : " not hidden." + fate + "stays remembered.");
    const std::string which = hierarchy.pass == 2 ? " by what the first pass left" : "";
    return name + size
           + (q.hidden ? " hidden" + which + ", and skipped with all that is in it."
                       : " not hidden" + which + ", so it is entered.");
}

std::string queryOver(const HierarchyState& hierarchy, const Pipeline& pipeline)
{
    const PyramidQuery& q  = *hierarchy.query;
    const NodeRow*    node = hierarchy.askedAbout ? nullptr : &hierarchy.nodes[static_cast<std::size_t>(hierarchy.now)];
    const std::string who  = !node ? fmt::format("triangle {}", grouped(hierarchy.askedAbout->value))
                             : node->instance
                                 ? fmt::format("node {} of instance {}", node->path, grouped(node->instance->value))
                                 : fmt::format("node {} of the instances", node->path);
    const std::string asked = fmt::format(
        "Is {} hidden? It reaches {} x {} pixels and is at most {:.7g} near; level {} of the pyramid holds {:.7g} as "
        "the farthest there:",
        who, q.box.x1 - q.box.x0, q.box.y1 - q.box.y0, q.nearest, q.level, q.value);
    if (q.cells == 0) return asked + " nothing is read, because it covers no pixel's centre; so it is hidden.";
    const bool oneLevel = pipeline.approximation.cells == CellDescent::OneLevel;
    if (!q.hidden && (oneLevel || pipeline.upkeep == Upkeep::Masked))
        return asked
               + (oneLevel ? " that is not nearer, and no finer level is asked; not hidden, after "
                           : " not hidden, because a tile's two depths do not vouch for it, and its pixels are not "
                             "read, after ")
               + counted(static_cast<std::uint64_t>(q.cells), "cell.", "cells.");
    if (!q.hidden)
        return asked + " not hidden, because a pixel was found that is not nearer, after "
               + counted(q.cells, "cell.", "cells.");
    if (q.nearest < q.value)
        return asked + " hidden, because everything there is strictly nearer, by "
               + counted(q.cells, "cell.", "cells.");
    return asked + " that does not decide, but the finer cells and pixels inside its rectangle do, after "
           + counted(q.cells, "cell", "cells") + ": all are strictly nearer, so it is hidden.";
}

std::string updateOver(const CellWrite& cell, Upkeep upkeep)
{
    const bool pushed = upkeep == Upkeep::Pushed || upkeep == Upkeep::PushedFarthest;
    const bool isTile = cell.level == Pyramid::kTileLevel;
    if (isTile && upkeep == Upkeep::Masked)
        return fmt::format(
            "Tile ({}, {}): the working layer's mask is full, so its depth {:.7g} becomes that of the whole tile "
            "instead of {:.7g}.",
            cell.x, cell.y, cell.after, cell.before);
    const std::string why  = !pushed  ? "because a question met it stale"
                             : isTile ? "because pixels of it were drawn"
                                      : "because a cell below it has changed";
    const std::string from = isTile ? "its pixels" : fmt::format("its children on level {}", cell.level - 1);
    const std::string what = fmt::format("Cell ({}, {}) of level {} becomes the farthest of {} again, {}:", cell.x,
                                         cell.y, cell.level, from, why);
    if (cell.before == cell.after)
        return what
               + fmt::format(" {:.7g} as before, so {}.", cell.after,
                             pushed ? "the way up ends here" : "it changes nothing above");
    return what
           + fmt::format(" {:.7g} instead of {:.7g}{}.", cell.after, cell.before,
                         pushed ? ", so the level above is next" : "");
}

std::string intervalOver(const IntervalState& interval, const Pipeline& pipeline)
{
    const std::string pixels = interval.x1 - interval.x0 == 1
                                   ? fmt::format("pixel {}", interval.x0)
                                   : fmt::format("pixels {} to {}", interval.x0, interval.x1 - 1);
    const std::string where  = fmt::format("Line {}, {} between neighbouring edges: {}", interval.y, pixels,
                                           counted(interval.open.size(), "polygon is open", "polygons are open"));
    const std::string name(nameOfPolygons(pipeline, false));
    const std::string winner = interval.winner ? fmt::format("{} {}", name, grouped(interval.winner->value)) : name;
    switch (interval.reason) {
        case IntervalReason::Alone:
            return where + fmt::format(", {}, so all of it is its own without a test.", winner);
        case IntervalReason::Leads:
            return where
                   + fmt::format(
                       "; {} leads all others by more than 2 float32 steps at both ends, so it leads everywhere "
                       "between and wins them all.",
                       winner);
        case IntervalReason::TestedOnce:
            return where + fmt::format("; {} is nearest at the left end and, by a fault, gets them all.", winner);
        case IntervalReason::BeyondFar:
            return where + "; the nearest reaches beyond the far plane, so they are compared pixel by pixel.";
        case IntervalReason::DepthLimited:
            return where + "; a depth is limited to its " + name
                   + "'s corners there, so the ends do not speak for the rest: compared pixel by pixel.";
        case IntervalReason::HasPattern:
            return where
                   + "; the nearest has holes or a relief and covers nothing whole, so they are compared pixel by "
                     "pixel.";
        case IntervalReason::NoClearLead:
            return where
                   + "; none leads by more than 2 float32 steps at both ends, as where they cross or touch: compared "
                     "pixel by pixel.";
        case IntervalReason::NotByEnds:
            return where
                   + "; depths are not stored as they are found, so the ends do not speak for the rest: compared "
                     "pixel by pixel.";
    }
    return where;
}

std::string tileOver(const TileTested& tile, float empty)
{
    const std::string who = fmt::format(
        "Tile ({}, {}) to ({}, {}): triangle {} could be as near as {:.7g} here, and the farthest depth in the tile",
        tile.box.x0, tile.box.y0, tile.box.x1 - 1, tile.box.y1 - 1, grouped(tile.triangle.value), tile.nearest);
    const std::string stored =
        tile.farthest > empty ? fmt::format(" is {:.7g}: ", tile.farthest) : std::string(" is the background's: ");
    return who + stored
           + (tile.rejected ? "rejected, none of its fragments is tested or shaded."
                            : "that rejects nothing, so its fragments are tested one by one.");
}

/// What the moment of shading meant for this fragment, as the end of its sentence.
std::string shadingOf(const PixelState& p, DepthMoment moment)
{
    if (p.discarded && moment == DepthMoment::Late) return ", which its shader finds out before the test.";
    if (p.discarded) return "; it passed the test, so nothing may be written before the hole is known.";
    if (moment == DepthMoment::Deferred || p.keep == Keep::DepthOnly) return ".";
    if (!p.won && p.shaded && p.unmovedDepth && moment != DepthMoment::Late)
        return "; where its triangle is it passed, so it was shaded, and only its shader knew how far back it lies.";
    if (!p.won) return p.shaded ? "; it was shaded although hidden." : "; it is never shaded.";
    if (!p.shaded) return ".";
    return moment == DepthMoment::Late ? "; its colour was ready before the test." : "; only now is it shaded.";
}

/// What the test found, without the end of the sentence.
std::string testOf(const PixelState& p, const Pipeline& pipeline)
{
    const std::string_view name      = nameOfPolygons(pipeline, false);
    const auto             movedFrom = [&p]() -> std::string {
        if (!p.unmovedDepth) return {};
        if (*p.unmovedDepth == p.depth) return " (as its material's relief leaves it)";
        return fmt::format(" (moved back from {:.7g} by its material's relief)", *p.unmovedDepth);
    };
    const std::string who = fmt::format("Pixel ({}, {}): {} {}, depth {:.7g}{},", p.x, p.y, name,
                                        grouped(p.triangle.value), p.depth, movedFrom());
    if (p.discarded) return who + " lies in a hole of its material: the fragment does not exist";
    if (p.keep == Keep::DepthOnly)
        return who
               + (p.won ? " is the nearest so far: the pre-pass keeps its depth and asks nobody's name"
                        : " is not nearer than what the pre-pass has kept");
    if (p.keep == Keep::Equal && p.won)
        return who + " has exactly the depth that the pre-pass kept, so it is the one that is seen";
    if (p.keep == Keep::Equal && !p.rival)
        return who + " is farther than the depth that the pre-pass kept and is hidden";
    if (!p.rival && p.won) return who + " takes it from the background";
    if (!p.rival) return who + " lies beyond the far plane and is not kept";
    const std::string rival = fmt::format("{} {}", name, grouped(p.rival->value));
    if (p.depth == p.rivalDepth) {
        return who
               + (p.won ? fmt::format(" is as near as {} and takes it: on equal depth the lower id wins", rival)
                        : fmt::format(" is as near as {} and loses: on equal depth the lower id wins", rival));
    }
    if (p.won) return who + fmt::format(" is nearer than {} at {:.7g} and takes it", rival, p.rivalDepth);
    return who + fmt::format(" is farther than {} at {:.7g} and is hidden", rival, p.rivalDepth);
}

std::string blendOver(const BlendState& blend, BlendOrder order)
{
    return fmt::format("Pixel ({}, {}): {} nearer than its opaque depth, blended over its colour, {}.", blend.x,
                       blend.y, counted(blend.surfaces, "transparent surface is", "transparent surfaces are"),
                       order == BlendOrder::Sorted ? "farthest first" : "back faces before front faces");
}

}  // namespace

std::string sentenceFor(const StepState& state, const Pipeline& pipeline, MomentRecorder::Moment moment,
                        std::uint64_t trianglesInScene)
{
    using Moment = MomentRecorder::Moment;
    switch (moment) {
        case Moment::None:
            return "Nothing has happened yet.";
        case Moment::StageOver:
            return stageOver(state);
        case Moment::NodeOver:
            return nodeOver(*state.hierarchy);
        case Moment::TriangleOver:
            return fmt::format("Triangle {} is drawn: it is nearest so far at {}.",
                               grouped(state.triangle->triangle.value),
                               counted(state.triangle->pixelsWon, "pixel", "pixels"));
        case Moment::QueryOver:
            return queryOver(*state.hierarchy, pipeline);
        case Moment::UpdateOver:
            return updateOver(*state.hierarchy->update, pipeline.upkeep);
        case Moment::IntervalOver:
            return intervalOver(*state.interval, pipeline);
        case Moment::LineReady:
            return lineReady(*state.sweep, pipeline);
        case Moment::LineOver:
            return lineOver(*state.sweep, pipeline);
        case Moment::SpanOver:
            return spanOver(state, pipeline);
        case Moment::TileOver:
            return tileOver(*state.tile, state.frame.visible.empty());
        case Moment::PixelOver:
            return testOf(*state.pixel, pipeline) + shadingOf(*state.pixel, pipeline.depth);
        case Moment::BlendOver:
            return blendOver(*state.blend, pipeline.transparency);
        case Moment::FrameOver:
            return fmt::format("The picture is finished: {} one of {}.",
                               counted(coveredPixels(state.frame.visible), "pixel shows", "pixels show"),
                               counted(trianglesInScene, "triangle", "triangles"));
    }
    return {};
}

}  // namespace zscope
