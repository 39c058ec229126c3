// What is said of nodes and of the pyramid.
#include <fmt/format.h>

#include "core/cull/cull_events.h"
#include "core/probe/words.h"
#include "core/scan/pixel_events.h"

namespace zscope {

std::string nameInWords(const NodePlace& place)
{
    const std::string path = pathOf(place.node);
    return place.isInstanceTree ? fmt::format("node {} of the instances", path)
                                : fmt::format("node {} of instance {}", path, withCommas(place.instance.value));
}

namespace {

/// What the pyramid was asked and found.
std::string questionOf(const PyramidQuery& q)
{
    if (q.cells == 0) return "its rectangle holds no pixel's centre, so nothing of it can be seen";
    const std::string asked = fmt::format(
        "its rectangle has {} x {} pixels, so level {} of the pyramid is asked: farthest there {:.9g}, itself at most "
        "{:.9g}",
        q.box.x1 - q.box.x0, q.box.y1 - q.box.y0, q.level, q.value, q.nearest);
    if (!q.hidden) return asked + "; that does not hide it";
    if (q.nearest < q.value) return asked + ", so everything there is strictly nearer";
    return asked + "; that does not decide, but all finer cells and pixels inside the rectangle are strictly nearer";
}

std::vector<int> listOf(const PixelBox& box) { return {box.x0, box.y0, box.x1, box.y1}; }

/// Of what the question was about, apart from the sentence.
Meaning meaningOf(const PyramidQuery& q)
{
    return {.depth  = q.nearest,
            .level  = q.level,
            .pixels = q.box,
            .values = {{"query", Values{{"rectangle", listOf(q.box)},
                                        {"level", std::int64_t{q.level}},
                                        {"value", double{q.value}},
                                        {"nearest", double{q.nearest}},
                                        {"cells_read", std::int64_t{q.cells}},
                                        {"hidden", q.hidden}}}}};
}

struct WordAndFate {
    std::string_view word;
    PixelFate        fate;
};

WordAndFate fateBy(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Outside:
            return {"node-outside", fates::kNodeOutside};
        case Verdict::Hidden:
            return {"node-hidden", fates::kNodeHidden};
        case Verdict::Small:
            return {"node-small", fates::kNodeSmall};
        case Verdict::Entered:
            break;
    }
    return {"node-entered", fates::kNotFilled};
}

/// What the verdict means for a triangle below the node.
std::string verdictFor(const NodeJudged& e, const std::string& who)
{
    const std::string named = capital(nameInWords(e.place)) + fmt::format(", which holds {},", who);
    switch (e.verdict) {
        case Verdict::Outside:
            return named + " lies outside the view: nothing in it is looked at.";
        case Verdict::Small:
            return named + " has fewer pixels on the screen than this approximation keeps: it is left out.";
        case Verdict::Hidden:
            return named + " is hidden: " + questionOf(*e.query)
                   + (e.pass == 2 ? ", by what the first pass left." : ".");
        case Verdict::Entered:
            break;
    }
    if (e.query) return named + " is entered: " + questionOf(*e.query) + ".";
    return named + " is entered: it may be in view, and "
           + (e.asksAboutNodes ? "it reaches before the near plane, so it cannot be called hidden."
                               : "this method does not ask whether it is hidden.");
}

}  // namespace

std::string NodeJudged::sentence(const Telling&) const
{
    const std::string name = capital(nameInWords(place));
    const std::string fate = isDrawnAhead ? " The first pass has drawn it, and it " : "";
    if (verdict == Verdict::Outside) return name + " lies outside the view: nothing in it is looked at.";
    if (verdict == Verdict::Small)
        return name + " has fewer pixels on the screen than this approximation keeps: it is left out.";
    if (!query)
        return name + " is entered: it may be in view, and it cannot be called hidden."
               + (isDrawnAhead ? fate + "stays remembered." : "");
    const PyramidQuery& q    = *query;
    const std::string   size = fmt::format(
          " covers {} x {} pixels, so level {} of the pyramid is asked: farthest there {:.7g}, node at most {:.7g}:",
          q.box.x1 - q.box.x0, q.box.y1 - q.box.y0, q.level, q.value, q.nearest);
    if (isDrawnAhead)
        return name + size
               + (q.hidden ? " hidden." + fate + "is forgotten." : " not hidden." + fate + "stays remembered.");
    const std::string which = pass == 2 ? " by what the first pass left" : "";
    return name + size
           + (q.hidden ? " hidden" + which + ", and skipped with all that is in it."
                       : " not hidden" + which + ", so it is entered.");
}

std::string PyramidAsked::sentence(const Telling&) const
{
    const PyramidQuery& q     = query;
    const std::string   who   = node ? nameInWords(*node) : fmt::format("triangle {}", withCommas(triangle.value));
    const std::string   asked = fmt::format(
          "Is {} hidden? It reaches {} x {} pixels and is at most {:.7g} near; level {} of the pyramid holds {:.7g} as "
            "the farthest there:",
          who, q.box.x1 - q.box.x0, q.box.y1 - q.box.y0, q.nearest, q.level, q.value);
    if (q.cells == 0) return asked + " nothing is read, because it covers no pixel's centre; so it is hidden.";
    if (!q.hidden && (isOneLevel || upkeep == AfterDrawing::Cover))
        return asked
               + (isOneLevel ? " that is not nearer, and no finer level is asked; not hidden, after "
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

std::string CellUpdated::sentence(const Telling&) const
{
    const bool pushed = upkeep == AfterDrawing::Push || upkeep == AfterDrawing::PushFromFarthest;
    const bool isTile = write.level == Pyramid::kTileLevel;
    if (isTile && upkeep == AfterDrawing::Cover)
        return fmt::format(
            "Tile ({}, {}): the working layer's mask is full, so its depth {:.7g} becomes that of the whole tile "
            "instead of {:.7g}.",
            write.x, write.y, write.after, write.before);
    const std::string why  = !pushed  ? "because a question met it stale"
                             : isTile ? "because pixels of it were drawn"
                                      : "because a cell below it has changed";
    const std::string from = isTile ? "its pixels" : fmt::format("its children on level {}", write.level - 1);
    const std::string what = fmt::format("Cell ({}, {}) of level {} becomes the farthest of {} again, {}:", write.x,
                                         write.y, write.level, from, why);
    if (write.before == write.after)
        return what
               + fmt::format(" {:.7g} as before, so {}.", write.after,
                             pushed ? "the way up ends here" : "it changes nothing above");
    return what
           + fmt::format(" {:.7g} instead of {:.7g}{}.", write.after, write.before,
                         pushed ? ", so the level above is next" : "");
}

std::string TileTested::sentence(const Telling& telling) const
{
    const std::string who = fmt::format(
        "Tile ({}, {}) to ({}, {}): triangle {} could be as near as {:.7g} here, and the farthest depth in the tile",
        box.x0, box.y0, box.x1 - 1, box.y1 - 1, withCommas(triangle.value), nearest);
    const std::string stored =
        farthest > telling.background() ? fmt::format(" is {:.7g}: ", farthest) : std::string(" is the background's: ");
    return who + stored
           + (rejected ? "rejected, none of its fragments is tested or shaded."
                       : "that rejects nothing, so its fragments are tested one by one.");
}

void NodeJudged::mean(Meanings& to) const
{
    const auto [word, fate] = fateBy(verdict);
    const Effect effect     = verdict == Verdict::Entered ? Effect::Passes : Effect::Ends;
    to.below(place, {.word = word, .effect = effect, .isOfAll = true}, [&, fate = fate](TriangleId id, PixelPosition) {
        Meaning meaning  = query ? meaningOf(*query) : Meaning();
        meaning.fate     = fate;
        meaning.sentence = verdictFor(*this, to.telling().nameOf(id));
        return meaning;
    });
}

void PyramidAsked::mean(Meanings& to) const
{
    if (node) return;  // that means what is made of it: NodeJudged
    const Outcome outcome{.word    = query.hidden ? "triangle-hidden" : "triangle-passed",
                          .effect  = query.hidden ? Effect::Ends : Effect::Passes,
                          .isOfAll = true};
    to.of(triangle, query.box, outcome, [&](TriangleId id, PixelPosition) {
        Meaning meaning = meaningOf(query);
        if (query.hidden) meaning.fate = fates::kTriangleHidden;
        meaning.sentence = fmt::format("{} is {}: {}.", capital(to.telling().nameOf(id)),
                                       query.hidden ? "hidden" : "asked about", questionOf(query));
        return meaning;
    });
}

void TileTested::mean(Meanings& to) const
{
    if (!rejected) return;
    const Outcome outcome{.word = "tile-rejected", .effect = Effect::Ends, .countedAs = {"tile_rejected"}};
    to.of(triangle, box, outcome, [&](TriangleId id, PixelPosition) {
        return Meaning{
            .depth    = nearest,
            .fate     = fates::kTileRejected,
            .values   = {{"tile",
                          Values{
                            {"rectangle", listOf(box)}, {"nearest", double{nearest}}, {"farthest", double{farthest}}}}},
            .sentence = fmt::format(
                "In the tile from ({}, {}) to ({}, {}) {} could be at most {:.9g} near, and the farthest depth stored "
                "there is {:.9g}: z-cull rejects it with the whole tile.",
                box.x0, box.y0, box.x1 - 1, box.y1 - 1, to.telling().nameOf(id), nearest, farthest)};
    });
}

}  // namespace zscope
