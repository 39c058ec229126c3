// What a sweep says of its lines.
#include <algorithm>

#include <fmt/format.h>

#include "core/plain/active_edges.h"
#include "core/probe/words.h"

namespace zscope::plain {

namespace {

std::string changesOf(const EdgeChanges& changes, std::span<const Polygon> polygons, const Telling& telling)
{
    if (changes.entered == 0 && changes.left == 0) return "no edge enters or leaves";
    std::string text;
    if (changes.entered == 1)
        text = fmt::format("an edge of {} {} enters, because this is its first line", telling.polygon(),
                           withCommas(polygons[changes.polygonEntered].id.value));
    else if (changes.entered > 0)
        text = fmt::format("{} edges enter on their first line", withCommas(changes.entered));
    if (changes.left == 0) return text;
    if (!text.empty()) text += "; ";
    if (changes.left == 1)
        return text
               + fmt::format("an edge of {} {} leaves: its last line was {}", telling.polygon(),
                             withCommas(polygons[changes.polygonLeft].id.value), changes.lastLine);
    return text + fmt::format("{} edges leave: their last lines are past", withCommas(changes.left));
}

/// A polygon that the near plane has cut in two counts once.
std::size_t polygonsOf(std::span<const Edge> active, std::span<const Polygon> polygons)
{
    std::vector<TriangleId> ids;
    for (const Edge& edge : active) ids.push_back(polygons[edge.polygon].id);
    std::ranges::sort(ids);
    // Not std::ranges::unique: clang 14 cannot compile the standard library's.
    return static_cast<std::size_t>(std::unique(ids.begin(), ids.end()) - ids.begin());
}

}  // namespace

std::string LineReady::sentence(const Telling& telling) const
{
    return fmt::format("The sweep reaches line {}: {}. {}, sorted by x.", y, changesOf(changes, polygons, telling),
                       counted(active.size(), "edge is active", "edges are active"));
}

std::string LineFinished::sentence(const Telling& telling) const
{
    return fmt::format("Line {} is drawn: {}. {} between {} gave {}.", y, changesOf(changes, polygons, telling),
                       counted(polygonsOf(active, polygons), telling.polygon(), telling.polygons()),
                       counted(active.size(), "active edge", "active edges"), counted(spans, "span", "spans"));
}

}  // namespace zscope::plain
