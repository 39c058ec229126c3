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
                                : fmt::format("node {} of instance {}", path, grouped(place.instance.value));
}

std::string NodeJudged::sentence(const Telling&) const
{
    const std::string name = capital(nameInWords(place));
    const std::string fate = isDrawnAhead ? " The first pass has drawn it, and it " : "";
    if (verdict == Verdict::Outside) return name + " lies outside the view: nothing in it is looked at.";
    if (verdict == Verdict::Small)
        return name + " has fewer pixels on the screen than this approximation keeps: it is left out.";
    if (!query)
        return name + " is entered: it may be in view, and nobody can say that it is hidden."
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
    const std::string   who   = node ? nameInWords(*node) : fmt::format("triangle {}", grouped(triangle.value));
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
        box.x0, box.y0, box.x1 - 1, box.y1 - 1, grouped(triangle.value), nearest);
    const std::string stored =
        farthest > telling.background() ? fmt::format(" is {:.7g}: ", farthest) : std::string(" is the background's: ");
    return who + stored
           + (rejected ? "rejected, none of its fragments is tested or shaded."
                       : "that rejects nothing, so its fragments are tested one by one.");
}

}  // namespace zscope
