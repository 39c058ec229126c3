// Edge tables, active polygons and spans of a row against those of our run.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "core/check/trace_compare.h"

namespace zscope::check {

TheirEdge edgeOf(const JsonValue::Object& object)
{
    TheirEdge  edge;
    const auto whole = [&](std::string_view name) -> std::optional<std::int64_t> {
        const JsonValue* value = memberOf(object, name);
        if (!value) return std::nullopt;
        return static_cast<std::int64_t>(numberOf(*value));
    };
    const auto real = [&](std::string_view name) -> std::optional<double> {
        const JsonValue* value = memberOf(object, name);
        if (!value) return std::nullopt;
        if (const auto* pair = value->array()) return numberOf((*pair)[0]) / numberOf((*pair)[1]);
        return numberOf(*value);
    };
    edge.polygon   = whole("polygon");
    edge.firstLine = whole("first_line");
    edge.lastLine  = whole("last_line");
    edge.x = real("x"), edge.xSubpixels = real("x_subpixels"), edge.dx = real("dx");
    return edge;
}

double slopeOf(const EdgeRow& edge) { return static_cast<double>(edge.dx[0]) / static_cast<double>(edge.dx[1]); }

namespace {

struct FieldDifference {
    std::string_view name;
    double           theirs = 0, ours = 0;
    bool             isRounding = false;
};

/// A field in which an edge differs from one of ours of the same polygon: the first that rounding does not explain, or
/// else the last that it does.
std::optional<FieldDifference> differenceOf(const TheirEdge& theirs, const EdgeRow& ours, const PolygonLimits& limits)
{
    std::optional<FieldDifference> rounding;
    const auto                     polygon = static_cast<std::int64_t>(ours.polygon.value);
    const auto compare = [&](std::string_view name, std::optional<double> value, double right, const auto& isAllowed) {
        if (!value || *value == right) return std::optional<FieldDifference>();
        const FieldDifference difference{name, *value, right, isAllowed(*value)};
        if (!difference.isRounding) return std::optional(difference);
        rounding = difference;
        return std::optional<FieldDifference>();
    };
    const auto lineOf = [](const std::optional<std::int64_t>& line) {
        return line ? std::optional(static_cast<double>(*line)) : std::nullopt;
    };
    const auto mayMove = [&](int between) { return limits.mayEndAt(polygon, between); };
    if (const auto wrong = compare("last_line", lineOf(theirs.lastLine), ours.lastLine, [&](double line) {
            return (line == ours.lastLine + 1 && mayMove(ours.lastLine + 1))
                   || (line == ours.lastLine - 1 && mayMove(ours.lastLine));
        }))
        return wrong;
    if (const auto wrong = compare("first_line", lineOf(theirs.firstLine), ours.firstLine, [&](double line) {
            return (line == ours.firstLine + 1 && mayMove(ours.firstLine))
                   || (line == ours.firstLine - 1 && mayMove(ours.firstLine - 1));
        }))
        return wrong;
    const double slope = std::abs(slopeOf(ours));
    const auto   most  = [&] { return limits.shiftOf(polygon) * (1 + slope); };
    if (const auto wrong = compare("x", theirs.x, ours.x, [&](double x) { return std::abs(x - ours.x) <= most(); }))
        return wrong;
    if (const auto wrong = compare("x_subpixels", theirs.xSubpixels, static_cast<double>(ours.xSubpixels),
                                   [&](double x) { return std::abs(x / 256 - ours.x) <= most() + 1.0 / 256; }))
        return wrong;
    const double lines = std::max(ours.lastLine - ours.firstLine, 1);
    // An edge that crosses one line alone may be arbitrarily short: its slope says nothing.
    if (const auto wrong = compare("dx", theirs.dx, slopeOf(ours), [&](double dx) {
            return ours.lastLine == ours.firstLine || std::abs(dx - slopeOf(ours)) <= 2 * most() / lines;
        }))
        return wrong;
    return rounding;
}

template <class Pixels>
void sortOnce(Pixels& pixels)
{
    std::ranges::sort(pixels);
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
}

std::string_view nameOf(EdgeList list)
{
    return list == EdgeList::Active    ? "your table"
           : list == EdgeList::Entered ? "your list of edges that entered"
                                       : "your list of edges that left";
}

/// Where an edge of the table would meet the centre of a line, pixels, on whichever side of its ends.
double xAt(const plain::Edge& edge, int line)
{
    const ScreenSide& side  = edge.side;
    const double      slope = (side.xb - side.xa) / (side.yb - side.ya);
    return (side.xa + slope * (256.0 * line + 128 - side.ya)) / 256;
}

}  // namespace

Likeness likenessOf(const TheirEdge& theirs, const EdgeRow& ours, const PolygonLimits& limits)
{
    const auto difference = differenceOf(theirs, ours, limits);
    return !difference ? Likeness::Same : difference->isRounding ? Likeness::Rounding : Likeness::Differs;
}

std::vector<EdgePair> RowComparison::pairsOf(EdgeList list, const std::vector<TheirEdge>& theirs,
                                             const std::vector<EdgeRow>& ours) const
{
    std::unordered_map<std::int64_t, std::vector<std::size_t>> byPolygon;
    std::vector<std::size_t>                                   all;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        byPolygon[static_cast<std::int64_t>(ours[i].polygon.value)].push_back(i);
        all.push_back(i);
    }
    static const std::vector<std::size_t> kNone;
    const auto                            candidatesOf = [&](const TheirEdge& edge) -> const std::vector<std::size_t>& {
        if (!edge.polygon) return all;
        const auto found = byPolygon.find(*edge.polygon);
        return found == byPolygon.end() ? kNone : found->second;
    };

    // First what agrees to the bit, then what agrees but for rounding.
    std::vector<EdgePair> pairs(theirs.size());
    std::vector<bool>     isTaken(ours.size(), false);
    for (const Likeness allowed : {Likeness::Same, Likeness::Rounding})
        for (std::size_t i = 0; i < theirs.size(); ++i) {
            if (pairs[i].ours) continue;
            pairs[i].theirs = i;
            for (const std::size_t own : candidatesOf(theirs[i])) {
                if (isTaken[own]) continue;
                const Likeness likeness = likenessOf(theirs[i], ours[own], m_limits);
                if (likeness > allowed) continue;
                pairs[i].ours     = own;
                pairs[i].likeness = likeness;
                isTaken[own]      = true;
                break;
            }
        }

    const int  y          = m_ours.sweep->y;
    const auto mayEndHere = [&](std::int64_t polygon) {
        return m_limits.mayVanish(polygon) || m_limits.mayEndAt(polygon, y)
               || (list != EdgeList::Active && m_limits.mayEndAt(polygon, y - 1));
    };
    for (EdgePair& pair : pairs) {
        if (pair.ours) continue;
        const TheirEdge& edge = theirs[*pair.theirs];
        pair.likeness         = edge.polygon && mayEndHere(*edge.polygon) ? Likeness::Rounding : Likeness::Differs;
        const bool isOver     = list == EdgeList::Active
                            && ((edge.lastLine && *edge.lastLine < y) || (edge.firstLine && *edge.firstLine > y));
        if (pair.likeness == Likeness::Rounding || !edge.polygon || isOver) continue;
        const auto away = [&](std::size_t own) { return edge.x ? std::abs(ours[own].x - *edge.x) : 0.0; };
        for (const std::size_t own : candidatesOf(edge))  // the one that is meant most likely
            if (!isTaken[own] && (!pair.ours || away(own) < away(*pair.ours))) pair.ours = own;
        if (pair.ours) isTaken[*pair.ours] = true;
    }
    for (std::size_t own = 0; own < ours.size(); ++own) {
        if (isTaken[own]) continue;
        const bool mayBeAbsent = mayEndHere(static_cast<std::int64_t>(ours[own].polygon.value));
        pairs.push_back({std::nullopt, own, mayBeAbsent ? Likeness::Rounding : Likeness::Differs});
    }
    return pairs;
}

RowComparison::Found RowComparison::edges(EdgeList list, const JsonValue::Array& theirs,
                                          const std::vector<EdgeRow>& ours)
{
    std::vector<TheirEdge> edges;
    for (const JsonValue& item : theirs) edges.push_back(edgeOf(*item.object()));
    const std::vector<EdgePair> pairs = pairsOf(list, edges, ours);
    for (const EdgePair& pair : pairs) {
        m_isRounding = m_isRounding || pair.likeness == Likeness::Rounding;
        if (pair.likeness == Likeness::Differs)
            return unequal(list, pair.theirs ? &edges[*pair.theirs] : nullptr, pair.ours ? &ours[*pair.ours] : nullptr);
    }
    if (list != EdgeList::Active) return std::nullopt;
    std::optional<std::size_t> before;  // the edge of ours that stands farthest right so far
    for (const EdgePair& pair : pairs) {
        if (!pair.theirs || !pair.ours) continue;
        const EdgeRow& edge = ours[*pair.ours];
        if (before && edge.x < ours[*before].x) {
            const EdgeRow& left = ours[*before];
            const auto     most = [&](const EdgeRow& of) {
                return m_limits.shiftOf(static_cast<std::int64_t>(of.polygon.value)) * (1 + std::abs(slopeOf(of)));
            };
            if (left.x - edge.x > most(left) + most(edge))
                return said(
                    fmt::format("your table is not sorted by x: the edge of polygon {} at x {:.9g} stands "
                                "before the edge of polygon {} at x {:.9g}.",
                                left.polygon.value, left.x, edge.polygon.value, edge.x));
            m_isRounding = true;
        } else {
            before = pair.ours;
        }
    }
    return std::nullopt;
}

/// What differs between two edges of one polygon, or what one list lacks.
RowComparison::Found RowComparison::unequal(EdgeList list, const TheirEdge* theirs, const EdgeRow* ours) const
{
    const std::string_view where = nameOf(list);
    if (!ours) return extraEdge(list, *theirs);
    if (!theirs)
        return said(fmt::format("{} lacks an edge of polygon {} at x {:.9g}; its lines are {} to {}.", where,
                                ours->polygon.value, ours->x, ours->firstLine, ours->lastLine));
    const auto difference = differenceOf(*theirs, *ours, m_limits);
    return said(fmt::format("an edge of polygon {} has {} {:.9g} in {}, and {:.9g} in ours.", *theirs->polygon,
                            difference->name, difference->theirs, where, difference->ours));
}

/// An edge that our list does not hold: why, if our edge table knows it.
RowComparison::Found RowComparison::extraEdge(EdgeList list, const TheirEdge& edge) const
{
    const int         y    = m_ours.sweep->y;
    const std::string name = edge.polygon ? fmt::format("an edge of polygon {}", *edge.polygon) : "an edge";
    if (list == EdgeList::Active) {
        std::optional<std::int64_t> first = edge.firstLine, last = edge.lastLine;
        if (!first && !last && edge.polygon && m_table) {  // the edge of our table that is meant most likely
            double nearest = HUGE_VAL;
            for (std::size_t i = 0; i < m_table->edgeCount(); ++i) {
                const plain::Edge& own = m_table->edge(static_cast<std::uint32_t>(i));
                if (m_table->polygons()[own.polygon].id.value != *edge.polygon) continue;
                if (own.firstLine <= y && own.lastLine >= y) continue;
                const int    away = own.lastLine < y ? y - own.lastLine : own.firstLine - y;
                const double distance =
                    edge.x ? std::min(std::abs(xAt(own, y) - *edge.x), std::abs(xAt(own, own.lastLine) - *edge.x))
                           : away;
                if (distance >= nearest) continue;
                nearest = distance;
                first   = own.firstLine;
                last    = own.lastLine;
            }
        }
        if (last && *last < y)
            return said(fmt::format("your table still holds {}, whose last line was {}.", name, *last));
        if (first && *first > y)
            return said(fmt::format("your table already holds {}, whose first line is {}.", name, *first));
    }
    const std::string_view where = nameOf(list);
    const std::string      at    = edge.x ? fmt::format(" at x {:.9g}", *edge.x) : "";
    return said(fmt::format("{} holds {}{}, and ours does not.", where, name, at));
}

RowComparison::Found RowComparison::polygons(const JsonValue::Array& theirs)
{
    std::set<std::int64_t> found, right;
    for (const JsonValue& item : theirs) found.insert(static_cast<std::int64_t>(numberOf(item)));
    for (const TriangleId polygon : m_ours.sweep->activePolygons) right.insert(polygon.value);
    const auto firstMissing = [&](const auto& in, const auto& from) -> std::optional<std::int64_t> {
        for (const std::int64_t polygon : in) {
            if (from.contains(polygon)) continue;
            if (!m_limits.mayVanish(polygon) && !m_limits.mayEndAt(polygon, m_ours.sweep->y)) return polygon;
            m_isRounding = true;
        }
        return std::nullopt;
    };
    if (const auto polygon = firstMissing(found, right))
        return said(fmt::format("polygon {} is active in your trace, and not in our run.", *polygon));
    if (const auto polygon = firstMissing(right, found))
        return said(fmt::format("polygon {} is active in our run, and not in your trace.", *polygon));
    return std::nullopt;
}

RowComparison::Found RowComparison::spans(const JsonValue::Array& theirs)
{
    const int              width = m_limits.width();
    std::vector<PixelSpan> found;
    for (const JsonValue& item : theirs) {
        const JsonValue::Object& span = *item.object();
        const auto               x0   = static_cast<std::int64_t>(numberOf(*memberOf(span, "x0"))),
                   x1                 = static_cast<std::int64_t>(numberOf(*memberOf(span, "x1"))),
                   polygon            = static_cast<std::int64_t>(numberOf(*memberOf(span, "polygon")));
        if (x0 < 0 || x1 > width || x0 >= x1)
            return said(fmt::format("a span of polygon {} goes from pixel {} to {}, and a line has pixels 0 to {}.",
                                    polygon, x0, x1 - 1, width - 1));
        if (found.size() + static_cast<std::size_t>(x1 - x0) > kMostSpanPixels)
            return said(fmt::format("the spans of your trace hold more than {} pixels.", kMostSpanPixels));
        for (std::int64_t x = x0; x < x1; ++x) found.emplace_back(x, polygon);
    }
    sortOnce(found);
    return spanPixels(found, pixelsOfOurSpans());
}

std::vector<RowComparison::PixelSpan> RowComparison::pixelsOfOurSpans() const
{
    std::vector<PixelSpan> pixels;
    for (const SpanRow& span : m_ours.sweep->spans)
        for (int x = span.x0; x < span.x1; ++x) pixels.emplace_back(x, span.polygon.value);
    sortOnce(pixels);
    return pixels;
}

RowComparison::Found RowComparison::spanPixels(std::span<const PixelSpan> found, std::span<const PixelSpan> right)
{
    const int y = m_ours.sweep->y;
    /// Whether another polygon of a list ties with this one at the pixel.
    const auto ties = [&](const PixelSpan& pixel, const Place& place, std::span<const PixelSpan> list) {
        const int x = static_cast<int>(pixel.first);
        for (auto at = std::ranges::lower_bound(list, PixelSpan(pixel.first, std::numeric_limits<std::int64_t>::min()));
             at != list.end(); ++at) {
            if (at->first != pixel.first) break;
            if (at->second != pixel.second && mayTie(m_limits.placeOf(at->second, x, y), place)) return true;
        }
        return false;
    };
    std::vector<PixelSpan> extra, missing;
    std::ranges::set_difference(found, right, std::back_inserter(extra));
    std::ranges::set_difference(right, found, std::back_inserter(missing));
    for (const PixelSpan& pixel : extra) {
        const Place place = m_limits.placeOf(pixel.second, static_cast<int>(pixel.first), y);
        m_isRounding      = true;
        if (place.isNearEdge() || (place.isPossible && ties(pixel, place, right))) continue;
        // A neighbour that ends here by rounding lets another be seen.
        const auto hides = std::ranges::find(missing, pixel.first, &PixelSpan::first);
        if (place.isPossible && hides != missing.end()
            && !m_limits.placeOf(hides->second, static_cast<int>(pixel.first), y).isCertain)
            continue;
        return said(fmt::format("pixel {} lies in a span of polygon {} in your trace, and not in our run.", pixel.first,
                                pixel.second));
    }
    for (const PixelSpan& pixel : missing) {
        const Place place = m_limits.placeOf(pixel.second, static_cast<int>(pixel.first), y);
        m_isRounding      = true;
        if (!place.isCertain || ties(pixel, place, found)) continue;
        const auto hides = std::ranges::find(extra, pixel.first, &PixelSpan::first);
        if (hides != extra.end() && m_limits.placeOf(hides->second, static_cast<int>(pixel.first), y).isNearEdge())
            continue;
        return said(fmt::format("pixel {} lies in a span of polygon {} in our run, and not in your trace.", pixel.first,
                                pixel.second));
    }
    return std::nullopt;
}

}  // namespace zscope::check
