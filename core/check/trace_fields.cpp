// Pixels, triangles, pyramids and all other fields of a row against those of our run.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "core/base/quotable.h"
#include "core/check/trace_compare.h"
#include "core/lesson/pyramid_levels.h"
#include "core/lesson/replay.h"

namespace zscope::check {
namespace {

/// A row may write what it likes there, or they name the moment.
constexpr std::array<std::string_view, 8> kNotJudged{"algorithm", "grain", "step",  "count",
                                                     "sentence",  "event", "stage", "source"};

constexpr double kDepthSteps = 4 * 0x1p-23;  // relative

std::optional<double> realIn(const JsonValue& value)
{
    const auto number = realOf(value, {}, {});
    return number ? std::optional(*number) : std::nullopt;
}

/// Short enough for a sentence.
std::string shown(const JsonValue& value)
{
    if (const auto* text = value.text()) return quotable(*text);
    if (const auto* truth = value.truth()) return *truth ? "true" : "false";
    if (const auto number = realIn(value)) return fmt::format("{:.9g}", *number);
    if (value.array()) return fmt::format("a list of {}", value.array()->size());
    return value.object() ? "an object" : "null";
}

/// Numbers that are computed: two programs need not agree to the bit.
bool isNear(double a, double b)
{
    return a == b || std::abs(a - b) <= kDepthSteps * std::max(std::abs(a), std::abs(b));
}

}  // namespace

bool isJudged(std::string_view field) { return std::ranges::find(kNotJudged, field) == kNotJudged.end(); }

const JsonValue* memberOf(const JsonValue::Object& object, std::string_view name)
{
    const auto found = std::ranges::find(object, name, &JsonMember::first);
    return found == object.end() ? nullptr : &found->second;
}

std::optional<std::int64_t> wholeIn(const JsonValue& value)
{
    const auto* whole = std::get_if<std::int64_t>(&value.value);
    return whole ? std::optional(*whole) : std::nullopt;
}

double numberOf(const JsonValue& value) { return realIn(value).value_or(0); }

bool mayTie(const Place& a, const Place& b)
{
    return std::abs(a.depth - b.depth) <= a.slack + b.slack + 2 * 0x1p-23 * std::max(a.depth, b.depth);
}

PolygonLimits::PolygonLimits(const DrawRequest& request, double halfStep)
    : m_request(request), m_halfStep(halfStep), m_drawsFaces(drawsFaces(request.pipeline)),
      m_faces(request.scene->scene())
{}

const std::vector<ExactTriangle>& PolygonLimits::trianglesOf(std::int64_t polygon) const
{
    if (const auto known = m_kept.find(polygon); known != m_kept.end()) return known->second;
    if (m_kept.size() >= kMostKept) m_kept.clear();
    std::vector<ExactTriangle>& triangles = m_kept[polygon];
    const Scene&                scene     = m_request.scene->scene();
    if (polygon < 0 || polygon >= static_cast<std::int64_t>(scene.triangleCount())) return triangles;
    std::pair<std::int64_t, std::int64_t> range{polygon, polygon + 1};
    if (m_drawsFaces) range = m_faces.trianglesOf(m_faces.faceOf(polygon));
    for (std::int64_t id = range.first; id < range.second; ++id)
        triangles.emplace_back(scene, m_request.camera, TriangleId{static_cast<std::uint32_t>(id)}, m_halfStep);
    return triangles;
}

double PolygonLimits::shiftOf(std::int64_t polygon) const
{
    double most = 0;
    for (const ExactTriangle& triangle : trianglesOf(polygon)) most = std::max(most, triangle.mostShift());
    return most + ExactTriangle::kOurStep;
}

bool PolygonLimits::mayEndAt(std::int64_t polygon, int line) const
{
    return std::ranges::any_of(trianglesOf(polygon),
                               [line](const ExactTriangle& triangle) { return triangle.mayEndAt(line); });
}

bool PolygonLimits::mayVanish(std::int64_t polygon) const
{
    return std::ranges::any_of(trianglesOf(polygon), &ExactTriangle::mayVanish);
}

Place PolygonLimits::placeOf(std::int64_t polygon, int x, int y) const
{
    Place best;
    for (const ExactTriangle& triangle : trianglesOf(polygon)) {
        const Place place = triangle.placeOf(x, y);
        if (place.isCertain || (place.isPossible && !best.isPossible)) best = place;
        if (best.isCertain) break;
    }
    return best;
}

Place PolygonLimits::depthOf(std::int64_t triangle, int x, int y) const
{
    const auto& own = trianglesOf(triangle);
    return own.empty() ? Place() : own.front().depthOf(x, y);
}

std::uint64_t PolygonLimits::pixelsNearEdges(std::int64_t triangle) const
{
    std::uint64_t pixels = 0;
    for (const ExactTriangle& own : trianglesOf(triangle)) {
        const auto box = own.box();
        for (int y = box.y0; y <= box.y1; ++y)
            for (int x = box.x0; x <= box.x1; ++x) pixels += own.placeOf(x, y).isNearEdge();
    }
    return pixels;
}

/// Our state as a row writes it, but for what is compared otherwise.
const JsonValue::Object& RowComparison::ours(const JsonValue::Object& row)
{
    if (!m_json) {
        StepState state = m_ours;
        state.sweep.reset();
        if (state.hierarchy && !memberOf(row, "nodes")) state.hierarchy->nodes.clear();
        auto json = parseJson(stateToJson(state), "");
        assert(json);
        m_json = *std::move(json);
    }
    return *m_json->object();
}

RowComparison::Found RowComparison::absent(std::string_view what) const
{
    return said(fmt::format("our run has no '{}'.", what));
}

RowComparison::Found RowComparison::difference(const JsonValue::Object& theirs)
{
    for (const JsonMember& member : theirs)
        if (const Found found = field(member, theirs)) return found;
    return std::nullopt;
}

RowComparison::Found RowComparison::field(const JsonMember& theirs, const JsonValue::Object& row)
{
    const auto& [name, value] = theirs;
    if (!isJudged(name)) return std::nullopt;
    const bool isOfSweep = name == "line" || name == "active_edges" || name == "active_polygons" || name == "spans"
                           || name == "entered" || name == "left";
    if (isOfSweep && !m_ours.sweep) return absent(name);
    if (name == "line")
        return numberOf(value) == m_ours.sweep->y ? Found()
                                                  : said(fmt::format("'{}' is {} in your trace, and {} in our run.",
                                                                     name, shown(value), m_ours.sweep->y));
    if (name == "active_edges") return edges(EdgeList::Active, *value.array(), m_ours.sweep->activeEdges);
    if (name == "entered") return edges(EdgeList::Entered, *value.array(), m_ours.sweep->entered);
    if (name == "left") return edges(EdgeList::Left, *value.array(), m_ours.sweep->left);
    if (name == "active_polygons") return polygons(*value.array());
    if (name == "spans") return spans(*value.array());
    if (name == "pixel") return m_ours.pixel ? pixel(*value.object(), row) : absent(name);
    if (name == "triangle") return m_ours.triangle ? triangle(*value.object()) : absent(name);
    if (name == "pyramid")
        return m_ours.hierarchy && !m_ours.hierarchy->levels.empty() ? pyramid(*value.object(), row) : absent(name);
    const JsonValue* own = memberOf(ours(row), name);
    return own ? generic(name, value, *own) : absent(name);
}

RowComparison::Found RowComparison::depth(std::string_view what, const JsonValue& theirs, double ours, double slack)
{
    const auto value = realIn(theirs);
    if (value && *value == ours) return std::nullopt;
    if (value && std::abs(*value - ours) <= slack + kDepthSteps * std::abs(ours)) {
        m_isRounding = true;
        return std::nullopt;
    }
    return said(fmt::format("'{}' is {} in your trace, and {:.9g} in our run.", what, shown(theirs), ours));
}

RowComparison::Found RowComparison::pixel(const JsonValue::Object& theirs, const JsonValue::Object& row)
{
    const PixelState& ours  = *m_ours.pixel;
    const Place       own   = m_limits.depthOf(ours.triangle.value, ours.x, ours.y);
    const Place       rival = ours.rival ? m_limits.placeOf(ours.rival->value, ours.x, ours.y) : Place();
    const auto        held = ours.rival ? fmt::format("triangle {}", ours.rival->value) : std::string("the background");
    for (const auto& [name, value] : theirs) {
        Found found;
        if (name == "depth") {
            found = depth("depth", value, ours.depth, own.slack);
        } else if (name == "won") {
            if (!value.truth()) {
                found = said(fmt::format("'{}' is {} in your trace, and {} in our run.", name, shown(value), ours.won));
            } else if (*value.truth() != ours.won) {
                if (ours.rival && (mayTie(own, rival) || !rival.isCertain)) {
                    m_isRounding = true;
                } else {
                    found = said(fmt::format("your triangle {}, and ours {}: the pixel held {} at depth {:.9g}.",
                                             ours.won ? "loses" : "wins", ours.won ? "wins" : "loses", held,
                                             ours.rivalDepth));
                }
            }
        } else if (name == "rival") {
            const JsonValue::Object* object   = value.object();
            const JsonValue*         member   = object ? memberOf(*object, "triangle") : nullptr;
            const auto               triangle = member ? wholeIn(*member) : std::nullopt;
            const bool               isNull   = std::holds_alternative<std::monostate>(value.value);
            if (!isNull && !triangle) {
                found = said(fmt::format("'{}' is {} in your trace, and {} in our run.", name, shown(value), held));
            } else {
                const std::int64_t theirId = isNull ? -1 : *triangle;
                const std::int64_t ourId   = ours.rival ? static_cast<std::int64_t>(ours.rival->value) : -1;
                const Place        other   = theirId < 0 ? Place() : m_limits.placeOf(theirId, ours.x, ours.y);
                if (theirId != ourId) {
                    if ((ourId >= 0 && !rival.isCertain) || other.isNearEdge()
                        || (ourId >= 0 && theirId >= 0 && other.isPossible && mayTie(rival, other)))
                        m_isRounding = true;
                    else
                        found = said(fmt::format(
                            "your pixel held {} before, and ours {}.",
                            theirId < 0 ? std::string("the background") : fmt::format("triangle {}", theirId), held));
                } else if (const JsonValue* rivalDepth = object ? memberOf(*object, "depth") : nullptr) {
                    found = depth("rival.depth", *rivalDepth, ours.rivalDepth, rival.slack);
                }
            }
        } else {
            const JsonValue* one = memberOf(*memberOf(this->ours(row), "pixel")->object(), name);
            found                = one ? generic("pixel." + name, value, *one) : absent("pixel." + quotable(name));
        }
        if (found) return found;
    }
    return std::nullopt;
}

RowComparison::Found RowComparison::triangle(const JsonValue::Object& theirs)
{
    const TriangleState& ours = *m_ours.triangle;
    const auto           id   = static_cast<std::int64_t>(ours.triangle.value);
    for (const auto& [name, value] : theirs) {
        const auto differs = [&, &name = name, &value = value](const std::string& right) {
            return said(
                fmt::format("'triangle.{}' is {} in your trace, and {} in our run.", name, shown(value), right));
        };
        const auto number = realIn(value);
        if (name == "id") {
            if (number != static_cast<double>(id)) return differs(std::to_string(id));
        } else if (name == "pixels_won") {
            const auto right = static_cast<double>(ours.pixelsWon);
            if (number == right) continue;
            if (!number || std::abs(*number - right) > static_cast<double>(m_limits.pixelsNearEdges(id)))
                return differs(std::to_string(ours.pixelsWon));
            m_isRounding = true;
        } else if (name == "corners") {
            if (!value.array()) return differs("a list of 3");
            const double most = m_limits.shiftOf(id);
            for (const JsonValue& corner : *value.array()) {
                const auto* two = corner.array();
                const auto  x   = two && two->size() == 2 ? realIn((*two)[0]) : std::nullopt,
                           y    = two && two->size() == 2 ? realIn((*two)[1]) : std::nullopt;
                if (!x || !y) return said("a corner of your triangle is not two numbers.");
                double off = HUGE_VAL;
                for (const auto& own : ours.corners)
                    off = std::min(off, std::max(std::abs(own[0] - *x), std::abs(own[1] - *y)));
                if (off > most)
                    return said(
                        fmt::format("a corner of your triangle is ({:.9g}, {:.9g}), and none of ours.", *x, *y));
                m_isRounding = m_isRounding || off > 0;
            }
        } else {
            return absent("triangle." + quotable(name));
        }
    }
    return std::nullopt;
}

RowComparison::Found RowComparison::pyramid(const JsonValue::Object& theirs, const JsonValue::Object& row)
{
    for (const auto& [name, value] : theirs) {
        if (name == "levels") {
            const JsonValue* own = memberOf(*memberOf(ours(row), "pyramid")->object(), "levels");
            if (const Found found = generic("pyramid.levels", value, *own)) return found;
        } else if (name == "stored") {
            if (!value.array()) return said("'pyramid.stored' is no list in your trace.");
            for (const JsonValue& stored : *value.array()) {
                const JsonValue* level    = stored.object() ? memberOf(*stored.object(), "level") : nullptr;
                const JsonValue* farthest = stored.object() ? memberOf(*stored.object(), "farthest") : nullptr;
                const auto       number   = level ? realIn(*level) : std::nullopt;
                if (!number || !farthest) return said("a level of your pyramid does not say 'level' and 'farthest'.");
                if (!(*number >= 0 && *number < static_cast<double>(m_ours.hierarchy->levels.size())))
                    return said(fmt::format("your pyramid has a level {}, and ours has none.", shown(*level)));
                if (const Found found = cells(static_cast<std::int64_t>(*number), *farthest)) return found;
            }
        } else {
            return absent("pyramid." + quotable(name));
        }
    }
    return std::nullopt;
}

RowComparison::Found RowComparison::cells(std::int64_t level, const JsonValue& theirs)
{
    Grid<float> truth = storedDepths(m_ours.frame.visible);  // the farthest pixel below each cell
    for (std::int64_t i = 0; i < level; ++i) truth = farthestOfFour(truth);
    const auto&        stored = m_ours.hierarchy->cells;
    const auto         at     = static_cast<std::size_t>(level - Pyramid::kTileLevel);
    const Grid<float>& ours   = level >= Pyramid::kTileLevel && at < stored.size() ? stored[at] : truth;
    const float        empty  = m_ours.frame.visible.empty();

    const JsonValue::Array* rows = theirs.array();
    if (!rows || rows->size() != static_cast<std::size_t>(ours.height()))
        return said(fmt::format("level {} of your pyramid has not {} rows.", level, ours.height()));
    for (int y = 0; y < ours.height(); ++y) {
        const JsonValue::Array* row = (*rows)[static_cast<std::size_t>(y)].array();
        if (!row || row->size() != static_cast<std::size_t>(ours.width()))
            return said(fmt::format("row {} of level {} of your pyramid has not {} cells.", y, level, ours.width()));
        for (int x = 0; x < ours.width(); ++x) {
            const JsonValue& cell  = (*row)[static_cast<std::size_t>(x)];
            const auto       value = realIn(cell);
            // Background may be 0. A cell may lag behind its pixels, as ours does.
            const double least = ours.at(x, y) <= empty ? 0.0 : static_cast<double>(ours.at(x, y)),
                         most  = static_cast<double>(truth.at(x, y));
            if (value && *value >= least * (1 - kDepthSteps) && *value <= std::max(most, 0.0) * (1 + kDepthSteps)) {
                m_isRounding = m_isRounding || (*value != least && *value != most && *value != ours.at(x, y));
                continue;
            }
            return said(fmt::format("cell ({}, {}) of level {} is {} in your pyramid, and {:.9g} in ours.", x, y, level,
                                    shown(cell), ours.at(x, y)));
        }
    }
    return std::nullopt;
}

RowComparison::Found RowComparison::generic(const std::string& path, const JsonValue& theirs, const JsonValue& ours)
{
    const auto differs = [&] {
        return said(fmt::format("'{}' is {} in your trace, and {} in our run.", path, shown(theirs), shown(ours)));
    };
    if (const auto* object = theirs.object()) {
        if (!ours.object()) return differs();
        for (const auto& [name, value] : *object) {
            const JsonValue* own = memberOf(*ours.object(), name);
            if (!own) return absent(path + "." + quotable(name));
            if (const Found found = generic(path + "." + name, value, *own)) return found;
        }
        return std::nullopt;
    }
    if (const auto* list = theirs.array()) {
        if (!ours.array() || list->size() != ours.array()->size()) return differs();
        std::vector<const JsonValue*> rest;
        for (const JsonValue& own : *ours.array()) rest.push_back(&own);
        const bool isSet = path.substr(path.rfind('.') + 1) == kSet;
        for (std::size_t i = 0; i < list->size(); ++i) {
            Found first;
            for (std::size_t j = 0; j < rest.size(); ++j) {
                const Found found = generic(path, (*list)[i], *rest[j]);
                if (!first) first = found;
                if (!found) {
                    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(j));
                    first.reset();
                    break;
                }
                if (!isSet) return found;
            }
            if (first) return first;
        }
        return std::nullopt;
    }
    const auto number = realIn(theirs), own = realIn(ours);
    if (number && own && !theirs.text() && !ours.text()) {
        if (*number == *own) return std::nullopt;
        if (!isNear(*number, *own)) return differs();
        m_isRounding = true;
        return std::nullopt;
    }
    const bool isSame = theirs.text()    ? ours.text() && *theirs.text() == *ours.text()
                        : theirs.truth() ? ours.truth() && *theirs.truth() == *ours.truth()
                                         : !number && theirs.value.index() == ours.value.index();
    return isSame ? Found() : differs();
}

}  // namespace zscope::check
