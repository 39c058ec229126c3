// From the faces of a batch to the polygons that reach the pixels of a region.
//
// Outline    a face whose triangles all turn the same way once snapped, or that is mended: its sides, as one polygon.
//            Where the near plane cuts it, or a corner is out of range, the sides of what is left of its triangles, of
//            which those inside the face cancel in pairs
// By ears    any other, triangle by triangle: one that is not plane or that snapping turned over in part, and one so
//            thin that its depth comes from the snapped grid. A mended face never is: it keeps the even-odd rule
// Promise    a face covers the pixels that its triangles cover (a mended one: an odd number of them). What a triangle
//            has become is reported as of triangles alone, but that it is drawn where its face is
// Cost       per triangle of a face its turn; per face one plane
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/screen_face.h"
#include "core/geometry/set_up.h"

namespace zscope {

/// Scratch memory, reused batch after batch.
struct FaceScratch {
    enum class Where : std::uint8_t { Seen, Wide, Behind, OutOfRange };
    struct EarFate {
        SetUp fate;  // Drawn, NoPixelCentre: if its face is drawn
        bool  cut, wide;
    };

    std::vector<dvec3>        view;    // of the batch's vertices, where it is not plain
    std::vector<ScreenCorner> screen;  // likewise; of those that are Behind without meaning
    std::vector<Where>        where;
    std::vector<ScreenSide>   sides;    // of the face at hand
    std::vector<EarFate>      fates;    // of its triangles, if somebody hears what became of them
    TriangleList              parts;    // of the triangle at hand
    TriangleList              waiting;  // faces that are triangles, until there are several

    std::size_t bytes() const
    {
        return view.capacity() * sizeof(dvec3) + screen.capacity() * sizeof(ScreenCorner)
               + where.capacity() * sizeof(Where) + sides.capacity() * sizeof(ScreenSide)
               + fates.capacity() * sizeof(EarFate);
    }
};

/// What set-up needs to know of the faces it is working on.
struct FacePlace {
    const FaceBatches& mesh;
    std::uint32_t      batch;
    const Affine*      toWorld;        // nullptr: the identity
    std::uint32_t      firstTriangle;  // id of the instance's triangle 0

    const Batch& points() const { return mesh.points.batches[batch]; }
    bool         isMirrored() const { return toWorld && toWorld->isMirrored(); }
};

/// `Consume` takes (ScreenTriangle) and (ScreenFace, sides); `Report` takes TriangleSetUp and FaceSetUpAs.
template <class Consume, class Rules, class Report>
class FaceSetUp {
public:
    FaceSetUp(const FacePlace& place, const Projection& projection, FaceCulling culling, const PixelBox& region,
              FaceScratch& scratch, const Consume& consume, const Rules& rules, const Report& report)
        : m_place(place), m_projection(projection), m_facing(rules.facing({culling, place.isMirrored()})),
          m_region(region), m_scratch(scratch), m_consume(consume), m_rules(rules), m_report(report),
          m_depth(projection, place.toWorld)
    {}

    /// All vertices of the batch are in front of the near plane and inside the guard band.
    void plainly(const ScreenVertices& vertices)
    {
        const auto at = [&vertices](std::uint32_t place) { return vertices.corner(place); };
        forEachFace([&](std::uint32_t f) { whole(f, at, false); });
    }

    void carefully()
    {
        placeVertices();
        const auto at = [this](std::uint32_t place) -> const ScreenCorner& { return m_scratch.screen[place]; };
        forEachFace([&](std::uint32_t f) {
            bool isWide = false, isCut = false;
            for (const FaceEar& ear : m_place.mesh.earsOf(f))
                for (const std::uint32_t place : ear) {
                    isWide = isWide || m_scratch.where[place] == Where::Wide;
                    isCut =
                        isCut || m_scratch.where[place] == Where::Behind || m_scratch.where[place] == Where::OutOfRange;
                }
            if (isCut)
                cut(f);
            else
                whole(f, at, isWide);
        });
    }

private:
    using Where = FaceScratch::Where;
    using How   = FaceSetUpAs::How;

    template <class Visit>
    void forEachFace(const Visit& visit) const
    {
        const FaceBatch& batch = m_place.mesh.batches[m_place.batch];
        for (std::uint32_t f = batch.firstFace; f < batch.firstFace + batch.faceCount; ++f) visit(f);
    }

    TriangleId idOf(std::uint32_t face, std::uint32_t ear = 0) const
    {
        return {m_place.firstTriangle + m_place.mesh.faces[face].firstTriangle + ear};
    }

    /// A face all of whose corners have their place on the screen.
    template <class At>
    void whole(std::uint32_t f, const At& at, bool wide)
    {
        const auto ears = m_place.mesh.earsOf(f);
        const auto draw = [&](std::uint32_t i) {
            const auto& [a, b, c] = ears[i];
            ScreenTriangle triangle;
            const SetUp fate = setUpTriangle(at(a), at(b), at(c), idOf(f), wide, m_facing, m_region, m_rules, triangle);
            triangle.patterned = m_place.mesh.faces[f].patterned;
            if (fate == SetUp::Drawn) m_consume(triangle);
            m_report(TriangleSetUp{idOf(f, i), fate, false, wide && fate == SetUp::Drawn});
            return fate;
        };
        if (ears.size() == 1) return byEars(f, How::Triangle, draw);

        begin(wide);
        for (const auto& [a, b, c] : ears) {
            const SetUp fate = addEar({at(a), at(b), at(c)}, wide);
            tellLater({fate, false, wide && fate == SetUp::Drawn});
        }
        for (const FaceSide& side : m_place.mesh.sidesOf(f)) addSide(at(side.from), at(side.to));
        asOneOrByEars(f, draw);
    }

    /// A face with corners behind the near plane or out of range.
    void cut(std::uint32_t f)
    {
        const auto ears = m_place.mesh.earsOf(f);
        const auto draw = [&](std::uint32_t i) {
            m_scratch.parts.clear();
            const SetUp fate = setUpClipped(viewsOf(ears[i]), idOf(f, i), idOf(f), m_place.mesh.faces[f].patterned,
                                            m_projection, m_facing, m_region, m_rules, m_scratch.parts, m_report);
            for (std::size_t p = 0; p < m_scratch.parts.count; ++p) m_consume(m_scratch.parts[p]);
            return fate;
        };
        if (ears.size() == 1) return byEars(f, How::Triangle, draw);

        begin(false);
        for (const FaceEar& ear : ears) tellLater(addParts(viewsOf(ear)));
        asOneOrByEars(f, draw);
    }

    template <class Draw>
    void asOneOrByEars(std::uint32_t f, const Draw& draw)
    {
        const bool isMended = m_place.mesh.faces[f].isMended;
        if (m_seen.clockwise && m_seen.counterClockwise && !isMended) return byEars(f, How::UnlikeTurns, draw);
        if (m_seen.hasArea() && m_seen.isThin() && !isMended) return byEars(f, How::Thin, draw);
        const SetUp fate = asOne(f);
        if (fate == SetUp::OutOfRange) return byEars(f, How::Thin, draw);
        m_report(FaceSetUpAs{idOf(f), How::Outline, fate == SetUp::Drawn});
        if (m_report.isHeard())
            for (std::uint32_t i = 0; i < m_scratch.fates.size(); ++i) {
                const auto [own, isCut, wide] = m_scratch.fates[i];
                const bool sharesIt = fate != SetUp::Drawn && (own == SetUp::Drawn || own == SetUp::NoPixelCentre);
                m_report(TriangleSetUp{idOf(f, i), sharesIt ? fate : own, isCut, wide && !sharesIt});
            }
    }

    template <class Draw>
    void byEars(std::uint32_t f, How how, const Draw& draw)
    {
        const auto count   = static_cast<std::uint32_t>(m_place.mesh.earsOf(f).size());
        bool       isDrawn = false;
        for (std::uint32_t i = 0; i < count; ++i) {
            const bool drawn = draw(i) == SetUp::Drawn;
            isDrawn          = isDrawn || drawn;
        }
        m_report(FaceSetUpAs{idOf(f), how, isDrawn});
    }

    /// Hands the sides on unless nothing of them is to be drawn. OutOfRange: the face has no plane, and is not mended.
    SetUp asOne(std::uint32_t f)
    {
        const Face& face = m_place.mesh.faces[f];
        if (m_seen.isDropped) return SetUp::Outside;
        // walked there and back, no side is left
        if (!m_seen.hasArea() || m_scratch.sides.empty()) return SetUp::Degenerate;
        const bool isClockwise = face.isMended ? turnsClockwise(m_scratch.sides) : m_seen.clockwise;
        if (m_facing.isCulled(isClockwise ? 1 : -1)) return SetUp::BackFacing;
        if (!hasPixelCentre(m_seen.left, m_seen.top, m_seen.right, m_seen.bottom)) return SetUp::NoPixelCentre;
        DepthPlane depth = m_depth.of(m_place.mesh.planes[face.plane], m_seen.farthest, m_seen.nearest);
        if (!FaceDepth::isUsable(depth)) {
            if (!face.isMended) return SetUp::OutOfRange;
            depth.a = depth.b = 0;  // as a triangle without a plane
            depth.c           = depth.nearest;
        }
        m_consume(ScreenFace{depth, m_seen.top, idOf(f), m_seen.wide, face.isMended, face.patterned},
                  std::span<const ScreenSide>(m_scratch.sides));
        return SetUp::Drawn;
    }

    /// What the triangles and sides of the face at hand come to.
    struct Seen {
        bool wide = false, clockwise = false, counterClockwise = false, isDropped = false;
        // twice, unsnapped, of all triangles
        double area = 0;
        double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;            // of the corners, unsnapped
        double left = HUGE_VAL, right = -HUGE_VAL, top = HUGE_VAL, bottom = -HUGE_VAL;  // snapped
        double farthest = HUGE_VAL, nearest = -HUGE_VAL;                                // depths

        bool hasArea() const { return clockwise || counterClockwise; }
        /// As depthPlane() judges a triangle.
        bool isThin() const { return !(std::abs(area) > std::max(x1 - x0, y1 - y0) * 0x1p-10); }
        void include(const ScreenCorner& p)
        {
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
            left = std::min(left, p.xs), right = std::max(right, p.xs), top = std::min(top, p.ys),
            bottom   = std::max(bottom, p.ys);
            farthest = std::min(farthest, p.d), nearest = std::max(nearest, p.d);
        }
    };

    void begin(bool wide)
    {
        m_seen      = {};
        m_seen.wide = wide;
        m_scratch.sides.clear();
        m_scratch.fates.clear();
    }

    bool hasPixelCentre(double left, double top, double right, double bottom) const
    {
        return std::max(m_region.x0, m_rules.firstCentreFrom(left))
                   < std::min(m_region.x1, m_rules.firstCentreFrom(right))
               && std::max(m_region.y0, m_rules.firstCentreFrom(top))
                      < std::min(m_region.y1, m_rules.firstCentreFrom(bottom));
    }

    /// Takes note of how a triangle turns. Drawn if it would be on its own, whichever side it shows.
    SetUp addEar(const std::array<ScreenCorner, 3>& p, bool wide)
    {
        const int turn          = turnOf(p[0], p[1], p[2], wide);
        m_seen.clockwise        = m_seen.clockwise || turn > 0;
        m_seen.counterClockwise = m_seen.counterClockwise || turn < 0;
        m_seen.isDropped        = m_seen.isDropped || m_rules.dropsCrossing(p[0], p[1], p[2]);
        m_seen.area += (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
        if (turn == 0) return SetUp::Degenerate;
        if (m_report.isHeard()) {
            const auto [left, right] = std::minmax({p[0].xs, p[1].xs, p[2].xs});
            const auto [top, bottom] = std::minmax({p[0].ys, p[1].ys, p[2].ys});
            if (!hasPixelCentre(left, top, right, bottom)) return SetUp::NoPixelCentre;
        }
        return SetUp::Drawn;
    }

    void addSide(const ScreenCorner& a, const ScreenCorner& b)
    {
        m_scratch.sides.push_back({a.xs, a.ys, b.xs, b.ys});
        m_seen.include(a);  // the sides are closed, so every corner is the first of one
    }

    /// The sides of what the near plane leaves of a triangle, and its fate.
    FaceScratch::EarFate addParts(const std::array<dvec3, 3>& view)
    {
        ClippedTriangle kept = clipNear(view, m_projection.near);
        if (kept.isCut && m_rules.dropsAtNear()) kept.count = 0;
        FaceScratch::EarFate ear{SetUp::ClippedAway, kept.isCut, false};
        for (std::size_t p = 0; p < kept.parts(); ++p) {
            const std::array<dvec3, 3>  corners = kept.part(p);
            std::array<ScreenCorner, 3> part;
            for (std::size_t i = 0; i < 3; ++i) part[i] = screenOf(corners[i], m_projection, m_rules);
            if (!std::ranges::all_of(part, isInRange)) {
                if (ear.fate != SetUp::Drawn) ear.fate = SetUp::OutOfRange;
                continue;
            }
            const bool  wide = std::ranges::any_of(part, isBeyondGuardBand);
            const SetUp fate = addEar(part, wide);
            if (ear.fate != SetUp::Drawn) ear.fate = fate;
            if (fate == SetUp::Degenerate) continue;
            ear.wide    = ear.wide || (wide && fate == SetUp::Drawn);
            m_seen.wide = m_seen.wide || wide;
            for (std::size_t i = 0; i < 3; ++i) addSide(part[i], part[(i + 1) % 3]);
        }
        return ear;
    }

    void tellLater(const FaceScratch::EarFate& ear)
    {
        if (m_report.isHeard()) m_scratch.fates.push_back(ear);
    }

    /// Of closed sides: the sign of the area they go round, counted as often as they do.
    static bool turnsClockwise(std::span<const ScreenSide> sides)
    {
        __extension__ using Wide = __int128;
        Wide       area          = 0;
        const auto whole         = [](double value) { return static_cast<Wide>(value); };
        const Wide x = whole(sides.front().xa), y = whole(sides.front().ya);
        for (const ScreenSide& s : sides)
            area += (whole(s.xa) - x) * (whole(s.yb) - y) - (whole(s.ya) - y) * (whole(s.xb) - x);
        return area > 0;
    }

    static bool isBeyondGuardBand(const ScreenCorner& corner)
    {
        return std::max(std::abs(corner.xs), std::abs(corner.ys)) > kGuardBand;
    }

    void placeVertices()
    {
        const MeshBatches& mesh  = m_place.mesh.points;
        const std::size_t  first = m_place.points().firstVertex, count = m_place.points().vertexCount;
        m_scratch.view.resize(count);
        m_scratch.screen.resize(count);
        m_scratch.where.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const dvec3 view  = viewOf({mesh.x[first + i], mesh.y[first + i], mesh.z[first + i]}, m_place.toWorld,
                                       m_projection, m_rules);
            m_scratch.view[i] = view;
            if (!(view.z >= m_projection.near)) {
                m_scratch.where[i] = Where::Behind;
                continue;
            }
            const ScreenCorner corner = screenOf(view, m_projection, m_rules);
            m_scratch.screen[i]       = corner;
            m_scratch.where[i]        = !isInRange(corner)          ? Where::OutOfRange
                                        : isBeyondGuardBand(corner) ? Where::Wide
                                                                    : Where::Seen;
        }
    }

    std::array<dvec3, 3> viewsOf(const FaceEar& corner) const
    {
        return {m_scratch.view[corner[0]], m_scratch.view[corner[1]], m_scratch.view[corner[2]]};
    }

    const FacePlace&  m_place;
    const Projection& m_projection;
    Facing            m_facing;
    PixelBox          m_region;
    FaceScratch&      m_scratch;
    const Consume&    m_consume;
    const Rules&      m_rules;
    const Report&     m_report;
    FaceDepth         m_depth;
    Seen              m_seen;
};

}  // namespace zscope
