#include "core/check/trace_beside.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/quotable.h"
#include "core/check/trace_compare.h"
#include "core/lesson/replay.h"

namespace zscope::check {
namespace {

constexpr std::size_t kMostParts = 6;  // of a list that is written out

std::string cellOf(const JsonValue& value)
{
    std::vector<std::string> parts;
    if (const auto* list = value.array()) {
        if (list->size() > kMostParts) return fmt::format("[{} \u2026]", list->size());
        for (const JsonValue& part : *list) parts.push_back(cellOf(part));
        return fmt::format("[{}]", fmt::join(parts, ", "));
    }
    if (const auto* object = value.object()) {
        for (const auto& [name, part] : *object) parts.push_back(quotable(name) + " " + cellOf(part));
        return fmt::format("{}", fmt::join(parts, ", "));
    }
    if (const auto* text = value.text()) return quotable(*text);
    if (const auto* truth = value.truth()) return *truth ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&value.value)) return std::to_string(*whole);
    if (const auto* large = std::get_if<std::uint64_t>(&value.value)) return std::to_string(*large);
    if (const auto* real = std::get_if<double>(&value.value)) return fmt::format("{:.9g}", *real);
    return "null";
}

/// A field of an edge, as both write it.
struct EdgeColumn {
    std::string_view name;
    /// A copy that says this field and the polygon alone.
    TheirEdge (*alone)(const TheirEdge& edge);
    std::string (*ours)(const EdgeRow& edge);
};
constexpr std::array<EdgeColumn, 5> kEdgeColumns{
    {{"x", [](const TheirEdge& edge) { return TheirEdge{.polygon = edge.polygon, .x = edge.x}; },
      [](const EdgeRow& edge) { return fmt::format("{:.9g}", edge.x); }},
     {"x_subpixels",
      [](const TheirEdge& edge) { return TheirEdge{.polygon = edge.polygon, .xSubpixels = edge.xSubpixels}; },
      [](const EdgeRow& edge) { return std::to_string(edge.xSubpixels); }},
     {"dx", [](const TheirEdge& edge) { return TheirEdge{.polygon = edge.polygon, .dx = edge.dx}; },
      [](const EdgeRow& edge) { return fmt::format("{:.9g}", slopeOf(edge)); }},
     {"first_line",
      [](const TheirEdge& edge) { return TheirEdge{.polygon = edge.polygon, .firstLine = edge.firstLine}; },
      [](const EdgeRow& edge) { return std::to_string(edge.firstLine); }},
     {"last_line", [](const TheirEdge& edge) { return TheirEdge{.polygon = edge.polygon, .lastLine = edge.lastLine}; },
      [](const EdgeRow& edge) { return std::to_string(edge.lastLine); }}}};

/// What stands beside a row for which our run has no state.
void besideNothing(int depth, const std::string& name, const JsonValue& theirs, Likeness likeness,
                   std::vector<FieldBeside>& fields)
{
    const auto* object = theirs.object();
    fields.push_back({depth, name, {}, object ? std::string() : cellOf(theirs), likeness});
    if (!object) return;
    for (const auto& [part, value] : *object) besideNothing(depth + 1, quotable(part), value, likeness, fields);
}

}  // namespace

template <class Compare>
Likeness RowComparison::verdictOf(const Compare& compare)
{
    m_isRounding = false;
    if (compare()) return Likeness::Differs;
    return m_isRounding ? Likeness::Rounding : Likeness::Same;
}

const std::vector<EdgeRow>& RowComparison::edgesOf(EdgeList list) const
{
    return list == EdgeList::Active    ? m_ours.sweep->activeEdges
           : list == EdgeList::Entered ? m_ours.sweep->entered
                                       : m_ours.sweep->left;
}

std::vector<FieldBeside> RowComparison::beside(const JsonValue::Object& theirs)
{
    constexpr std::array     kEdgeLists{std::pair("active_edges", EdgeList::Active),
                                    std::pair("entered", EdgeList::Entered), std::pair("left", EdgeList::Left)};
    std::vector<FieldBeside> fields;
    for (const JsonMember& member : theirs) {
        const std::string& name  = member.first;
        const JsonValue&   value = member.second;
        if (!isJudged(name)) continue;
        const Likeness likeness  = verdictOf([&] { return field(member, theirs); });
        const bool     isOfSweep = value.array() && name != "nodes";  // the other lists of a row
        if (name == "line" && m_ours.sweep) {
            fields.push_back({0, name, std::to_string(m_ours.sweep->y), cellOf(value), likeness});
            continue;
        }
        if (isOfSweep && m_ours.sweep) {
            fields.push_back({0, name, {}, {}, likeness});
            const auto edges = std::ranges::find_if(kEdgeLists, [&](const auto& entry) { return name == entry.first; });
            if (edges != kEdgeLists.end())
                besideEdges(edges->second, *value.array(), fields);
            else if (name == "active_polygons")
                besidePolygons(*value.array(), fields);
            else
                besideSpans(*value.array(), fields);
            continue;
        }
        const JsonValue* own   = memberOf(ours(theirs), name);
        const auto*      parts = value.object();
        if (!own || !parts || !own->object()) {
            besideParts(0, name, name, value, own, fields);
            continue;
        }
        fields.push_back({0, name, {}, {}, likeness});
        if (name == "pyramid") {
            besidePyramid(*parts, own, fields);
            continue;
        }
        for (const JsonMember& part : *parts) {
            const std::size_t first = fields.size();
            besideParts(1, name + "." + part.first, part.first, part.second, memberOf(*own->object(), part.first),
                        fields);
            if (name != "pixel" && name != "triangle") continue;
            // These two have limits of their own, and what is inside them is no worse than they are.
            fields[first].likeness =
                verdictOf([&] { return name == "pixel" ? pixel({part}, theirs) : triangle({part}); });
            for (FieldBeside& inside : std::span(fields).subspan(first + 1))
                inside.likeness = std::min(inside.likeness, fields[first].likeness);
        }
    }
    return fields;
}

void RowComparison::besideEdges(EdgeList list, const JsonValue::Array& theirs, std::vector<FieldBeside>& fields) const
{
    const std::vector<EdgeRow>&           ours = edgesOf(list);
    std::vector<TheirEdge>                edges;
    std::array<bool, kEdgeColumns.size()> isWritten{};
    for (const JsonValue& item : theirs) {
        edges.push_back(edgeOf(*item.object()));
        for (std::size_t i = 0; i < kEdgeColumns.size(); ++i)
            isWritten[i] = isWritten[i] || memberOf(*item.object(), kEdgeColumns[i].name);
    }
    if (theirs.empty()) isWritten = {true, false, false, true, true};
    const auto xOf = [&](const EdgePair& pair) {
        return pair.ours ? std::optional(ours[*pair.ours].x) : edges[*pair.theirs].x;
    };
    // Their order; an edge that they lack stands before the first one to its right.
    std::vector<EdgePair> pairs, absent;
    for (const EdgePair& pair : pairsOf(list, edges, ours)) (pair.theirs ? pairs : absent).push_back(pair);
    std::ranges::stable_sort(absent, {}, xOf);
    std::vector<EdgePair> all;
    auto                  next = absent.begin();
    for (const EdgePair& pair : pairs) {
        const std::optional<double> x = xOf(pair);
        for (; next != absent.end() && x && *xOf(*next) < *x; ++next) all.push_back(*next);
        all.push_back(pair);
    }
    all.insert(all.end(), next, absent.end());
    for (const EdgePair& pair : all) {
        const EdgeRow*   own     = pair.ours ? &ours[*pair.ours] : nullptr;
        const TheirEdge* their   = pair.theirs ? &edges[*pair.theirs] : nullptr;
        const auto       polygon = their && their->polygon ? *their->polygon
                                   : own                   ? static_cast<std::int64_t>(own->polygon.value)
                                                           : -1;
        fields.push_back(
            {1, polygon >= 0 ? fmt::format("polygon {}", polygon) : std::string("edge"), {}, {}, pair.likeness});
        for (std::size_t i = 0; i < kEdgeColumns.size(); ++i) {
            const EdgeColumn& field = kEdgeColumns[i];
            if (!isWritten[i]) continue;
            const JsonValue* value    = their ? memberOf(*theirs[*pair.theirs].object(), field.name) : nullptr;
            Likeness         likeness = pair.likeness;
            if (their && own) likeness = value ? likenessOf(field.alone(*their), *own, m_limits) : Likeness::Same;
            const bool isFraction = value && value->array();
            fields.push_back({2, std::string(field.name), own ? field.ours(*own) : std::string(),
                              isFraction ? fmt::format("{:.9g}", *their->dx)
                              : value    ? cellOf(*value)
                                         : std::string(),
                              likeness});
        }
    }
}

void RowComparison::besidePolygons(const JsonValue::Array& theirs, std::vector<FieldBeside>& fields) const
{
    std::vector<std::int64_t> found, right;  // ascending, each once
    for (const JsonValue& item : theirs) found.push_back(static_cast<std::int64_t>(numberOf(item)));
    for (const TriangleId polygon : m_ours.sweep->activePolygons) right.push_back(polygon.value);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<std::int64_t> both;
    std::ranges::set_union(found, right, std::back_inserter(both));
    for (const std::int64_t polygon : both) {
        const bool isFound       = std::ranges::binary_search(found, polygon),
                   isRight       = std::ranges::binary_search(right, polygon);
        const std::string number = std::to_string(polygon);
        const bool        mayBe  = m_limits.mayVanish(polygon) || m_limits.mayEndAt(polygon, m_ours.sweep->y);
        fields.push_back({1, "polygon " + number, isRight ? number : std::string(), isFound ? number : std::string(),
                          isFound == isRight ? Likeness::Same
                          : mayBe            ? Likeness::Rounding
                                             : Likeness::Differs});
    }
}

void RowComparison::besideSpans(const JsonValue::Array& theirs, std::vector<FieldBeside>& fields)
{
    struct Span {
        std::int64_t x0 = 0, x1 = 0, polygon = 0;
        auto         operator<=>(const Span&) const = default;
    };
    std::vector<Span>      found, right;
    std::vector<PixelSpan> pixels;
    for (const JsonValue& item : theirs) {
        const auto number = [&](std::string_view name) {
            return static_cast<std::int64_t>(numberOf(*memberOf(*item.object(), name)));
        };
        found.push_back({number("x0"), number("x1"), number("polygon")});
    }
    const auto isInside = [width = m_limits.width()](const Span& span) {
        return span.x0 >= 0 && span.x1 <= width && span.x0 < span.x1;
    };
    std::int64_t room = static_cast<std::int64_t>(kMostSpanPixels);
    for (const Span& span : found)
        if (isInside(span) && (room -= span.x1 - span.x0) >= 0)
            for (std::int64_t x = span.x0; x < span.x1; ++x) pixels.emplace_back(x, span.polygon);
    std::ranges::sort(pixels);
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    const std::vector<PixelSpan> ourPixels = pixelsOfOurSpans();
    for (const SpanRow& span : m_ours.sweep->spans) right.push_back({span.x0, span.x1, span.polygon.value});
    std::ranges::sort(found);
    std::ranges::sort(right);
    std::vector<Span> all;
    std::ranges::set_union(found, right, std::back_inserter(all));
    /// The pixels of a list below a span.
    const auto below = [](const std::vector<PixelSpan>& list, const Span& span) {
        const auto from = std::ranges::lower_bound(list, span.x0, {}, &PixelSpan::first),
                   to   = std::ranges::lower_bound(list, span.x1, {}, &PixelSpan::first);
        return std::span<const PixelSpan>(from, to);
    };
    for (const Span& span : all) {
        const bool isFound = std::ranges::binary_search(found, span), isRight = std::ranges::binary_search(right, span);
        const std::string cell     = fmt::format("[{}, {})", span.x0, span.x1);
        Likeness          likeness = Likeness::Same;
        if (isFound != isRight)
            likeness = isInside(span) && room >= 0
                           ? verdictOf([&] { return spanPixels(below(pixels, span), below(ourPixels, span)); })
                           : Likeness::Differs;
        fields.push_back({1, fmt::format("polygon {}", span.polygon), isRight ? cell : std::string(),
                          isFound ? cell : std::string(), likeness});
    }
}

void RowComparison::besidePyramid(const JsonValue::Object& theirs, const JsonValue* ours,
                                  std::vector<FieldBeside>& fields)
{
    for (const JsonMember& part : theirs) {
        if (part.first != "stored" || !part.second.array()) {
            besideParts(1, "pyramid." + part.first, part.first, part.second, memberOf(*ours->object(), part.first),
                        fields);
            continue;
        }
        for (const JsonValue& stored : *part.second.array()) {
            const JsonValue* level    = stored.object() ? memberOf(*stored.object(), "level") : nullptr;
            const JsonValue* farthest = stored.object() ? memberOf(*stored.object(), "farthest") : nullptr;
            const auto       number   = level ? wholeIn(*level) : std::nullopt;
            const auto&      levels   = m_ours.hierarchy->levels;
            const bool       isThere  = number && *number >= 0 && *number < static_cast<std::int64_t>(levels.size());
            FieldBeside field{1, level ? "level " + cellOf(*level) : std::string("level"), {}, {}, Likeness::Differs};
            if (isThere) {
                const auto& [width, height] = levels[static_cast<std::size_t>(*number)];
                field.ours                  = fmt::format("{} \u00D7 {}", width, height);
            }
            if (farthest && farthest->array() && !farthest->array()->empty())
                field.theirs = fmt::format(
                    "{} \u00D7 {}", farthest->array()->front().array() ? farthest->array()->front().array()->size() : 0,
                    farthest->array()->size());
            if (isThere && farthest) field.likeness = verdictOf([&] { return cells(*number, *farthest); });
            fields.push_back(std::move(field));
        }
    }
}

/// A field without a rule of its own, and the parts that it holds.
void RowComparison::besideParts(int depth, const std::string& path, const std::string& name, const JsonValue& theirs,
                                const JsonValue* ours, std::vector<FieldBeside>& fields)
{
    const Likeness likeness = ours ? verdictOf([&] { return generic(path, theirs, *ours); }) : Likeness::Differs;
    const auto *   object = theirs.object(), *ownObject = ours ? ours->object() : nullptr;
    const auto *   list = theirs.array(), *ownList = ours ? ours->array() : nullptr;
    const bool     hasPlaces = list && ownList && list->size() == ownList->size() && list->size() > kMostParts;
    fields.push_back({depth, quotable(name), {}, {}, likeness});
    if (object && ownObject) {
        for (const auto& [part, value] : *object)
            besideParts(depth + 1, path + "." + part, part, value, memberOf(*ownObject, part), fields);
    } else if (hasPlaces && name != kSet) {
        for (std::size_t i = 0; i < list->size(); ++i)
            besideParts(depth + 1, path, fmt::format("[{}]", i), (*list)[i], &(*ownList)[i], fields);
    } else {
        fields.back().ours   = ours ? cellOf(*ours) : std::string();
        fields.back().theirs = cellOf(theirs);
    }
}

struct TraceBeside::Kept {
    std::shared_ptr<const Trace>       trace;
    std::shared_ptr<const TraceAnswer> answer;
    DrawRequest                        request;
    PolygonLimits                      limits;
    Replay                             replay;

    Kept(std::shared_ptr<const Trace> of, std::shared_ptr<const TraceAnswer> judged, const DrawRequest& drawn,
         double halfStep)
        : trace(std::move(of)), answer(std::move(judged)), request(drawn), limits(request, halfStep), replay(request)
    {}
};

TraceBeside::TraceBeside(std::shared_ptr<const Trace> trace, std::shared_ptr<const TraceAnswer> answer,
                         const DrawRequest& request, double halfStep)
    : m_kept(std::make_unique<Kept>(std::move(trace), std::move(answer), request, halfStep))
{}

TraceBeside::~TraceBeside() = default;

Result<std::vector<FieldBeside>> TraceBeside::row(std::size_t row)
{
    const Trace&     trace  = *m_kept->trace;
    const JudgedRow& judged = m_kept->answer->rows[row];
    const auto       theirs = parseJson(trace.textOf(trace.rows[row]), trace.file, 0, trace.rows[row].line);
    if (!theirs) return theirs.error();
    std::vector<FieldBeside> fields;
    if (!judged.grain) {
        for (const auto& [name, value] : *theirs->object())
            if (isJudged(name))
                besideNothing(0, name, value, judged.isWrong() ? Likeness::Differs : Likeness::Rounding, fields);
        return fields;
    }
    const auto state = m_kept->replay.at(*judged.grain, judged.step);
    if (!state) return state.error();
    return RowComparison(m_kept->limits, *state, nullptr, {}).beside(*theirs->object());
}

}  // namespace zscope::check
