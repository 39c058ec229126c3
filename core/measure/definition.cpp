#include "core/measure/definition.h"

#include <algorithm>
#include <cmath>

namespace zscope::definition {

namespace {

constexpr double kEndOfGrid = 0x1p61;  // snapped coordinates stay below, so that areas fit into 128 bits

/// Seen from the eye: x to the right, y up, z forward.
dvec3 viewSpace(const dvec3& q, const Affine& toWorld, const Camera& camera)
{
    const dvec3 p     = toWorld.isIdentity() ? q : toWorld(q);
    const dvec3 d     = p - camera.eye;
    const auto  along = [&d](const dvec3& axis) { return (axis.x * d.x + axis.y * d.y) + axis.z * d.z; };
    return {along(camera.right), along(camera.up), along(camera.forward)};
}

/// Where the edge meets the near plane, computed from its inside end so that both neighbours get the same point.
dvec3 crossing(const dvec3& inside, const dvec3& outside, double near)
{
    const double t = (inside.z - near) / (inside.z - outside.z);
    return {inside.x + t * (outside.x - inside.x), inside.y + t * (outside.y - inside.y), near};
}

/// The corners in front of the near plane, walked in order: none, three or four.
struct Outline {
    std::array<dvec3, 4> points;
    int                  count = 0;
};
Outline clipNear(const std::array<dvec3, 3>& corners, double near)
{
    Outline    outline;
    const auto output = [&outline](const dvec3& p) { outline.points[static_cast<std::size_t>(outline.count++)] = p; };
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3& a       = corners[i];
        const dvec3& b       = corners[(i + 1) % 3];
        const bool   aInside = a.z >= near;
        const bool   bInside = b.z >= near;
        if (aInside) output(a);
        if (aInside != bInside) output(aInside ? crossing(a, b, near) : crossing(b, a, near));
    }
    return outline;
}

/// False if the corner is beyond the grid. Written so that NaN, too, is beyond it.
bool project(const dvec3& v, const View& view, Corner& corner)
{
    const Camera& camera = view.camera;
    corner.depth         = camera.near / v.z;
    corner.x             = camera.width * 0.5 + (v.x * corner.depth) * view.k;
    corner.y             = camera.height * 0.5 - (v.y * corner.depth) * view.k;
    const double xs      = corner.x * 256;
    const double ys      = corner.y * 256;
    if (!(std::abs(xs) < kEndOfGrid) || !(std::abs(ys) < kEndOfGrid)) return false;
    corner.xs = static_cast<std::int64_t>(std::rint(xs));  // ties to even
    corner.ys = static_cast<std::int64_t>(std::rint(ys));
    return true;
}

Wide doubleAreaOf(const std::array<Corner, 3>& c)
{
    const auto x = [&c](std::size_t i) { return static_cast<Wide>(c[i].xs); };
    const auto y = [&c](std::size_t i) { return static_cast<Wide>(c[i].ys); };
    return (x(1) - x(0)) * (y(2) - y(0)) - (y(1) - y(0)) * (x(2) - x(0));
}

Side sideFrom(const Corner& a, const Corner& b)
{
    Side       side{.xa = a.xs, .ya = a.ys, .dx = static_cast<Wide>(b.xs) - a.xs, .dy = static_cast<Wide>(b.ys) - a.ys};
    const bool leftOrTop = side.dy < 0 || (side.dy == 0 && side.dx > 0);
    side.bias            = leftOrTop ? 0 : 1;
    return side;
}

}  // namespace

View::View(const Camera& c, FaceCulling culling)
    : camera(c), faceCulling(culling), k(((c.height * 0.5) * c.focal) / c.near),
      farDepth(static_cast<float>(c.near / c.far))
{}

PixelBox pixelsWithin(std::int64_t minXs, std::int64_t maxXs, std::int64_t minYs, std::int64_t maxYs,
                      const Camera& camera)
{
    // Centre 256 i + 128 >= min from i = ceil((min - 128) / 256) on, <= max up to floor((max - 128) / 256).
    const auto first = [](std::int64_t min) { return std::max<std::int64_t>((min + 127) >> 8, 0); };
    const auto last  = [](std::int64_t max, int size) { return std::min<std::int64_t>((max - 128) >> 8, size - 1); };
    const std::int64_t x0 = first(minXs), x1 = last(maxXs, camera.width);
    const std::int64_t y0 = first(minYs), y1 = last(maxYs, camera.height);
    if (x0 > x1 || y0 > y1) return {};
    return {static_cast<int>(x0), static_cast<int>(x1), static_cast<int>(y0), static_cast<int>(y1)};
}

namespace {

dvec3 crossProduct(const dvec3& p, const dvec3& q)
{
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// Where x lies in its cell of width 1, in [0, 1].
double placeInCell(double x) { return x - std::floor(x); }

}  // namespace

Patterns::Patterns(const Material& material, const std::array<dvec3, 3>& model, const std::array<dvec3, 3>& view,
                   const Camera& camera)
    : m_cutout(material.cutout), m_relief(material.relief),
      m_deepest(m_relief ? std::min(m_relief->depth / camera.near, 0x1p1000) : 0), m_view(view),
      m_weight(crossProduct(view[1] - view[0], view[2] - view[0])), m_halfWidth(camera.width * 0.5),
      m_halfHeight(camera.height * 0.5), m_focal(m_halfHeight * camera.focal)
{
    const dvec3  normal = crossProduct(model[1] - model[0], model[2] - model[0]);
    const double byX = std::abs(normal.x), byY = std::abs(normal.y), byZ = std::abs(normal.z);
    const int    left  = byX >= byY && byX >= byZ ? 0 : byY >= byZ ? 1 : 2;
    const auto   along = [&model](int axis) { return std::array{model[0][axis], model[1][axis], model[2][axis]}; };
    m_first            = coordinate(along(left == 0 ? 1 : 0));
    m_second           = coordinate(along(left == 2 ? 1 : 2));
}

Patterns::Coordinate Patterns::coordinate(const std::array<double, 3>& ofCorner) const
{
    const double second = ofCorner[1] - ofCorner[0], third = ofCorner[2] - ofCorner[0];
    const dvec3  p = crossProduct(m_view[2] - m_view[0], m_view[0]), q = crossProduct(m_view[0], m_view[1] - m_view[0]);
    return {ofCorner[0], {second * p.x + third * q.x, second * p.y + third * q.y, second * p.z + third * q.z}};
}

Patterns::Cell Patterns::cellAt(int i, int j, double size) const
{
    const double x = (i + 0.5) - m_halfWidth, y = m_halfHeight - (j + 0.5);
    const auto   onRay  = [&](const dvec3& f) { return (f.x * x + f.y * y) + f.z * m_focal; };
    const double weight = onRay(m_weight);
    return {(m_first.origin + onRay(m_first.gain) / weight) / size,
            (m_second.origin + onRay(m_second.gain) / weight) / size};
}

bool Patterns::isHole(int i, int j) const
{
    if (!m_cutout) return false;
    const auto [a, b] = cellAt(i, j, m_cutout->size);
    switch (m_cutout->pattern) {
        case CutoutPattern::Checker:
            return placeInCell((std::floor(a) + std::floor(b)) * 0.5) > 0.25;
        case CutoutPattern::Stripes:
            return placeInCell(a) >= 0.5;
        case CutoutPattern::Holes:
            break;
    }
    const double p = placeInCell(a) - 0.5, q = placeInCell(b) - 0.5;
    return p * p + q * q < 0.09375;
}

double Patterns::reliefAt(int i, int j) const
{
    const auto [a, b] = cellAt(i, j, m_relief->size);
    switch (m_relief->pattern) {
        case ReliefPattern::Bricks: {
            const double courses = b * 2, course = std::floor(courses);
            const bool   joint = placeInCell(a + placeInCell(course * 0.5)) < 0.0625 || courses - course < 0.125;
            return joint ? 1 : 0;
        }
        case ReliefPattern::Louvres:
            return placeInCell(b) > 0 ? placeInCell(b) : 0;
        case ReliefPattern::Bowls:
            break;
    }
    const double p = placeInCell(a) - 0.5, q = placeInCell(b) - 0.5, r = p * p + q * q;
    return r < 0.25 ? 1 - r * 4 : 0;
}

double Patterns::movedBack(double depth, int i, int j) const
{
    return depth / (1 + depth * (m_deepest * reliefAt(i, j)));
}

Part::Part(const std::array<Corner, 3>& corners, Wide doubleArea, const Camera& camera,
           const std::optional<Patterns>& patterns, bool isBack)
    : m_corners(corners), m_patterns(patterns), m_isBack(isBack)
{
    const auto& [a, b, c] = m_corners;
    m_box = pixelsWithin(std::min({a.xs, b.xs, c.xs}), std::max({a.xs, b.xs, c.xs}), std::min({a.ys, b.ys, c.ys}),
                         std::max({a.ys, b.ys, c.ys}), camera);
    setPlane();
    setSides(doubleArea);
}

void Part::setPlane()
{
    const auto& [c0, c1, c2] = m_corners;
    m_lo                     = static_cast<float>(std::min({c0.depth, c1.depth, c2.depth}));
    m_hi                     = static_cast<float>(std::max({c0.depth, c1.depth, c2.depth}));

    double       x0 = c0.x, y0 = c0.y;
    double       e1x = c1.x - c0.x, e1y = c1.y - c0.y;
    double       e2x = c2.x - c0.x, e2y = c2.y - c0.y;
    double       det     = e1x * e2y - e2x * e1y;
    const double longest = std::max({std::abs(e1x), std::abs(e1y), std::abs(e2x), std::abs(e2y)});
    if (!(std::abs(det) > longest * 0x1p-10)) {  // too thin: its own plane is pure rounding, the snapped one is not
        const auto pixels = [](std::int64_t s) { return static_cast<double>(s) / 256; };
        x0                = pixels(c0.xs);
        y0                = pixels(c0.ys);
        e1x               = pixels(c1.xs) - x0;
        e1y               = pixels(c1.ys) - y0;
        e2x               = pixels(c2.xs) - x0;
        e2y               = pixels(c2.ys) - y0;
        det               = e1x * e2y - e2x * e1y;
    }
    m_isFlat         = det == 0;
    const double d1  = c1.depth - c0.depth;
    const double d2  = c2.depth - c0.depth;
    const double inv = 1 / det;
    m_a              = (d1 * e2y - d2 * e1y) * inv;
    m_b              = (d2 * e1x - d1 * e2x) * inv;
    m_c              = c0.depth - (m_a * x0 + m_b * y0);
}

void Part::setSides(Wide doubleArea)
{
    std::array<Corner, 3> c = m_corners;
    if (doubleArea < 0) std::swap(c[1], c[2]);
    m_sides = {sideFrom(c[0], c[1]), sideFrom(c[1], c[2]), sideFrom(c[2], c[0])};
}

bool Part::covers(int i, int j) const
{
    return m_sides[0].at(i, j) >= 0 && m_sides[1].at(i, j) >= 0 && m_sides[2].at(i, j) >= 0 && !isHole(i, j);
}

double Part::limitedDepth(int i, int j) const
{
    if (m_isFlat) return m_hi;
    const double z = m_a * (i + 0.5) + (m_b * (j + 0.5) + m_c);
    return z < m_lo ? m_lo : z > m_hi ? m_hi : z;
}

float Part::depth(int i, int j) const
{
    if (m_patterns && m_patterns->hasRelief())
        return static_cast<float>(m_patterns->movedBack(limitedDepth(i, j), i, j));
    if (m_isFlat) return m_hi;
    float z = static_cast<float>(m_a * (i + 0.5) + (m_b * (j + 0.5) + m_c));
    z       = z < m_lo ? m_lo : z;
    return z > m_hi ? m_hi : z;
}

float Part::farthestDepth() const
{
    if (!m_patterns || !m_patterns->hasRelief()) return m_lo;
    // The quotient falls with the depth but for its roundings, which one float32 step outweighs by far.
    return std::max(0.0f, std::nextafter(static_cast<float>(m_patterns->movedBackWholly(m_lo)), -1.0f));
}

bool isMirrored(const Affine& matrix)
{
    const auto&  m = matrix.rows;
    const double det =
        (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]))
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return det < 0;
}

namespace {

/// partsOf(), whatever the triangle's material.
Fate geometryOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle, const View& view,
                std::vector<Part>& parts)
{
    const Mesh&     mesh         = scene.meshOf(instance);
    const Material& material     = mesh.materialOf(mesh.trianglePolygon[meshTriangle]);
    const auto      modelCorners = [&mesh](std::uint32_t triangle) {
        const auto& vertices = mesh.triangles[triangle];
        return std::array{mesh.positions[vertices[0]], mesh.positions[vertices[1]], mesh.positions[vertices[2]]};
    };
    const Affine& toWorld   = scene.instances[instance.value].toWorld;
    const bool    turnsOver = isMirrored(toWorld);
    const auto    seen      = [&](std::array<dvec3, 3> corners) {
        for (dvec3& q : corners) q = viewSpace(q, toWorld, view.camera);
        return corners;
    };
    std::optional<Patterns> patterns;
    if (material.isPatterned() && material.opacity >= 1) {
        const auto face = modelCorners(mesh.firstTriangle[mesh.trianglePolygon[meshTriangle].value]);
        patterns.emplace(material, face, seen(face), view.camera);
    }
    const std::array<dvec3, 3> corners = seen(modelCorners(meshTriangle));
    const Outline              outline = clipNear(corners, view.camera.near);
    if (outline.count == 0) return Fate::BehindNear;

    Fate fate = Fate::BehindNear;
    for (std::size_t i = 2; i < static_cast<std::size_t>(outline.count); ++i) {  // fan from the first point
        std::array<Corner, 3> part;
        const bool onGrid = project(outline.points[0], view, part[0]) && project(outline.points[i - 1], view, part[1])
                            && project(outline.points[i], view, part[2]);
        if (!onGrid) {
            fate = std::min(fate, Fate::OutOfRange);
            continue;
        }
        const Wide doubleArea = doubleAreaOf(part);
        if (doubleArea == 0) {
            fate = std::min(fate, Fate::Degenerate);
            continue;
        }
        const bool isBack = turnsOver ? doubleArea < 0 : doubleArea > 0;
        if (isBack && view.faceCulling == FaceCulling::Back) {
            fate = std::min(fate, Fate::Culled);
        } else {
            fate = Fate::Drawn;
            parts.emplace_back(part, doubleArea, view.camera, patterns, isBack);
        }
    }
    return fate;
}

bool isTransparent(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle)
{
    const Mesh& mesh = scene.meshOf(instance);
    return mesh.materialOf(mesh.trianglePolygon[meshTriangle]).opacity < 1;
}

}  // namespace

Fate partsOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle, const View& view,
             std::vector<Part>& parts)
{
    parts.clear();
    return isTransparent(scene, instance, meshTriangle) ? Fate::Transparent
                                                        : geometryOf(scene, instance, meshTriangle, view, parts);
}

bool transparentPartsOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle, const View& view,
                        std::vector<Part>& parts)
{
    parts.clear();
    if (!isTransparent(scene, instance, meshTriangle)) return false;
    geometryOf(scene, instance, meshTriangle, view, parts);
    return true;
}

}  // namespace zscope::definition
