// One row of a trace against one state of our run: the first difference in a sentence, or all fields side by side.
//
// Rounding   a difference that a careful renderer may have is none; isRounding() says that there was one. d is the most
//            that the corners of a polygon may lie elsewhere, in both programs together
//                x          within d (1 + |dx|) pixels; dx within 2 d (1 + |dx|) per line of the edge
//                lines      an edge may begin or end a line earlier or later if a corner lies within d of its centre,
//                           and a polygon may have no edges that may have no area on a grid, or whose box may hold
//                           no pixel's centre
//                spans      a pixel whose centre lies within d of an edge, or where the two surfaces tie
//                depths     four float32 steps and what d changes; so who wins where two depths tie
#pragma once

#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/check/exact_triangle.h"
#include "core/check/trace.h"
#include "core/check/trace_beside.h"
#include "core/check/truth.h"
#include "core/io/json_document.h"
#include "core/lesson/step_state.h"
#include "core/plain/edge_table.h"

namespace zscope::check {

/// What rounding may do to the polygons of a view.
class PolygonLimits {
public:
    PolygonLimits(const DrawRequest& request, double halfStep);

    /// Most that a corner may lie elsewhere, pixels; what a polygon that is not there would have: 0.
    double shiftOf(std::int64_t polygon) const;
    /// A corner may lie on the other side of this line's centre.
    bool mayEndAt(std::int64_t polygon, int line) const;
    /// It may be left out: ExactTriangle::mayVanish().
    bool mayVanish(std::int64_t polygon) const;
    /// The polygon's place at the centre of a pixel: of a face, of any of its triangles.
    Place placeOf(std::int64_t polygon, int x, int y) const;
    /// The triangle's plane there, whether or not it covers the pixel.
    Place depthOf(std::int64_t triangle, int x, int y) const;
    int   width() const { return m_request.camera.width; }
    bool  isInside(std::int64_t x, std::int64_t y) const
    {
        return x >= 0 && y >= 0 && x < width() && y < m_request.camera.height;
    }
    /// Pixels whose centres lie within d of an edge.
    std::uint64_t pixelsNearEdges(std::int64_t triangle) const;

private:
    const std::vector<ExactTriangle>& trianglesOf(std::int64_t polygon) const;

    const DrawRequest& m_request;
    double             m_halfStep;
    bool               m_drawsFaces;
    FaceNumbers        m_faces;

    static constexpr std::size_t                                         kMostKept = 1 << 16;
    mutable std::unordered_map<std::int64_t, std::vector<ExactTriangle>> m_kept;
};

/// An edge as far as a row says it.
struct TheirEdge {
    std::optional<std::int64_t> polygon = {}, firstLine = {}, lastLine = {};
    std::optional<double>       x = {}, xSubpixels = {}, dx = {};
};
enum class EdgeList { Active, Entered, Left };
/// Places of one edge in both lists; nothing: that list lacks it.
struct EdgePair {
    std::optional<std::size_t> theirs = {}, ours = {};
    Likeness                   likeness = Likeness::Same;
};

/// Whether two depths may be those of surfaces that tie.
bool mayTie(const Place& a, const Place& b);

class RowComparison {
public:
    /// `table`: of sweeps; nullptr elsewhere. All of them outlive it.
    RowComparison(const PolygonLimits& limits, const StepState& ours, const plain::EdgeTable* table, std::string phrase)
        : m_limits(limits), m_ours(ours), m_table(table), m_phrase(std::move(phrase))
    {}

    /// The first difference; nothing: there is none. `theirs` passed traceOf().
    std::optional<std::string> difference(const JsonValue::Object& theirs);
    bool                       isRounding() const { return m_isRounding; }
    /// Every field that is judged, in the order of the row.
    std::vector<FieldBeside> beside(const JsonValue::Object& theirs);

private:
    using Found     = std::optional<std::string>;
    using PixelSpan = std::pair<std::int64_t, std::int64_t>;  // pixel, polygon

    // trace_edges.cpp
    std::vector<EdgePair> pairsOf(EdgeList list, const std::vector<TheirEdge>& theirs,
                                  const std::vector<EdgeRow>& ours) const;
    Found                 edges(EdgeList list, const JsonValue::Array& theirs, const std::vector<EdgeRow>& ours);
    Found                 unequal(EdgeList list, const TheirEdge* theirs, const EdgeRow* ours) const;
    Found                 extraEdge(EdgeList list, const TheirEdge& edge) const;
    Found                 polygons(const JsonValue::Array& theirs);
    Found                 spans(const JsonValue::Array& theirs);
    /// Both sorted. Of the line of our run.
    Found                  spanPixels(std::span<const PixelSpan> theirs, std::span<const PixelSpan> ours);
    std::vector<PixelSpan> pixelsOfOurSpans() const;

    // trace_beside.cpp
    template <class Compare>
    Likeness                    verdictOf(const Compare& compare);
    const std::vector<EdgeRow>& edgesOf(EdgeList list) const;
    void besideEdges(EdgeList list, const JsonValue::Array& theirs, std::vector<FieldBeside>& fields) const;
    void besidePolygons(const JsonValue::Array& theirs, std::vector<FieldBeside>& fields) const;
    void besideSpans(const JsonValue::Array& theirs, std::vector<FieldBeside>& fields);
    void besidePyramid(const JsonValue::Object& theirs, const JsonValue* ours, std::vector<FieldBeside>& fields);
    void besideParts(int depth, const std::string& path, const std::string& name, const JsonValue& theirs,
                     const JsonValue* ours, std::vector<FieldBeside>& fields);

    // trace_fields.cpp
    Found field(const JsonMember& theirs, const JsonValue::Object& row);
    Found pixel(const JsonValue::Object& theirs, const JsonValue::Object& row);
    Found triangle(const JsonValue::Object& theirs);
    Found pyramid(const JsonValue::Object& theirs, const JsonValue::Object& row);
    Found cells(std::int64_t level, const JsonValue& theirs);
    Found generic(const std::string& path, const JsonValue& theirs, const JsonValue& ours);
    Found depth(std::string_view what, const JsonValue& theirs, double ours, double slack);

    const JsonValue::Object& ours(const JsonValue::Object& row);
    std::string              said(const std::string& rest) const { return m_phrase + " " + rest; }
    Found                    absent(std::string_view what) const;

    const PolygonLimits&     m_limits;
    const StepState&         m_ours;
    const plain::EdgeTable*  m_table;
    std::string              m_phrase;
    bool                     m_isRounding = false;
    std::optional<JsonValue> m_json;  // ours(), once it was asked for
};

inline constexpr std::size_t kMostSpanPixels = std::size_t{1} << 24;  // of one row
/// Of fields that are compared as they stand: a list in which the order means nothing.
inline constexpr std::string_view kSet = "open";
/// Whether a field of a row is compared at all.
bool isJudged(std::string_view field);
/// The member of an object; nullptr: it has none.
const JsonValue* memberOf(const JsonValue::Object& object, std::string_view name);
/// Nothing if it is no whole number.
std::optional<std::int64_t> wholeIn(const JsonValue& value);
/// Of a number that traceOf() has checked.
double numberOf(const JsonValue& value);
/// An edge of a row that traceOf() has checked.
TheirEdge edgeOf(const JsonValue::Object& object);
/// Whether the two agree, to the bit or but for rounding.
Likeness likenessOf(const TheirEdge& theirs, const EdgeRow& ours, const PolygonLimits& limits);
double   slopeOf(const EdgeRow& edge);

}  // namespace zscope::check
