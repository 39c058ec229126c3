#include "core/check/exact_triangle.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace zscope::check {
namespace {

constexpr double kRounding = 0x1p-24;  // of float32, relative

struct Placed {
    dvec3 view;   // x right, y up, z forward
    dvec3 error;  // of each
};

Placed placed(const dvec3& q, const Affine& toWorld, const Camera& camera)
{
    const dvec3 d = toWorld(q) - camera.eye;
    dvec3       sums;
    for (int i = 0; i < 3; ++i) {
        const auto& row = toWorld.rows[static_cast<std::size_t>(i)];
        sums[i]         = std::abs(row[0] * q.x) + std::abs(row[1] * q.y) + std::abs(row[2] * q.z) + std::abs(row[3])
                  + std::abs(camera.eye[i]);
    }
    const auto error = [&sums](const dvec3& axis) {
        return 12 * kRounding * (std::abs(axis.x) * sums.x + std::abs(axis.y) * sums.y + std::abs(axis.z) * sums.z);
    };
    return {{glm::dot(camera.right, d), glm::dot(camera.up, d), glm::dot(camera.forward, d)},
            {error(camera.right), error(camera.up), error(camera.forward)}};
}

dvec3 largest(const dvec3& a, const dvec3& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

}  // namespace

ExactTriangle::ExactTriangle(const Scene& scene, const Camera& camera, TriangleId id, double halfStep)
    : m_camera(&camera), m_halfStep(halfStep), m_scale(camera.height * 0.5 * camera.focal)
{
    const InstanceId    instance     = scene.instanceOf(id);
    const Mesh&         mesh         = scene.meshOf(instance);
    const std::uint32_t meshTriangle = id.value - scene.firstTriangle[instance.value];
    if (mesh.materialOf(mesh.trianglePolygon[meshTriangle]).opacity < 1) return;
    const Affine&         toWorld = scene.instances[instance.value].toWorld;
    std::array<Placed, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        p[i]    = placed(mesh.positions[mesh.triangles[meshTriangle][i]], toWorld, camera);
        m_error = largest(m_error, p[i].error);
    }
    const double near   = camera.near;
    const auto   output = [&](const dvec3& v, bool isCrossing) {
        const double depth                             = near / v.z;
        m_corners[static_cast<std::size_t>(m_count++)] = {camera.width * 0.5 + v.x / v.z * m_scale,
                                                          camera.height * 0.5 - v.y / v.z * m_scale, depth, isCrossing};
        if (!isCrossing) m_zError = std::max(m_zError, depth * m_error.z / near);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 &a = p[i].view, &b = p[(i + 1) % 3].view;
        if (a.z >= near) output(a, false);
        if ((a.z >= near) == (b.z >= near)) continue;
        m_isCut        = true;
        const double t = (a.z - near) / (a.z - b.z);
        output({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), near}, true);
    }
    if (m_count == 0) return;

    // Scaled to the largest edge, so that tiny triangles keep their normal.
    const dvec3  e1 = p[1].view - p[0].view, e2 = p[2].view - p[0].view;
    const dvec3  normal = glm::cross(e1, e2);
    const double height = glm::dot(normal, p[0].view);
    m_isEdgeOn          = !(std::abs(height) > 1e-12 * glm::length(normal) * glm::length(p[0].view));
    if (!m_isEdgeOn) {
        m_a = near * normal.x / (m_scale * height);
        m_b = -near * normal.y / (m_scale * height);
        m_c = near * normal.z / height - (m_a * camera.width * 0.5 + m_b * camera.height * 0.5);
    }
    m_lo = m_hi = m_corners[0].depth;
    m_left = m_top = HUGE_VAL;
    m_right = m_bottom = -HUGE_VAL;
    for (int i = 0; i < m_count; ++i) {
        const Corner& corner = m_corners[static_cast<std::size_t>(i)];
        const Shift   shift  = shiftAt(corner.x, corner.y, corner.depth);
        m_mostShift          = std::max({m_mostShift, shift.x, shift.y});
        m_lo                 = std::min(m_lo, corner.depth);
        m_hi                 = std::max(m_hi, corner.depth);
        m_left               = std::min(m_left, corner.x - shift.x);
        m_right              = std::max(m_right, corner.x + shift.x);
        m_top                = std::min(m_top, corner.y - shift.y);
        m_bottom             = std::max(m_bottom, corner.y + shift.y);
    }
    setBack(toWorld.isMirrored());
}

/// How far a point of the triangle may be moved.
ExactTriangle::Shift ExactTriangle::shiftAt(double x, double y, double depth) const
{
    const double perUnit = m_scale * depth / m_camera->near;  // pixels per unit of view space, at that distance
    const auto   along   = [&](double error, double fromCentre, double position, int side) {
        return m_halfStep + perUnit * (error + std::abs(fromCentre) / m_scale * m_error.z)
               + 6 * kRounding * std::max<double>(side, std::abs(position));
    };
    return {along(m_error.x, x - m_camera->width * 0.5, x, m_camera->width),
            along(m_error.y, y - m_camera->height * 0.5, y, m_camera->height)};
}

double ExactTriangle::doubleArea() const
{
    double area = 0;
    for (int i = 2; i < m_count; ++i) {
        const Corner &a = m_corners[0], &b = m_corners[static_cast<std::size_t>(i - 1)],
                     &c = m_corners[static_cast<std::size_t>(i)];
        area += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }
    return area;
}

void ExactTriangle::setBack(bool isMirrored)
{
    const double area    = doubleArea();
    double       longest = 0, shift = 0;
    for (int i = 0; i < m_count; ++i) {
        const Corner &a = m_corners[static_cast<std::size_t>(i)],
                     &b = m_corners[static_cast<std::size_t>((i + 1) % m_count)];
        const Shift s   = shiftAt(a.x, a.y, a.depth);
        longest         = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
        shift           = std::max({shift, s.x, s.y});
    }
    m_isThin       = std::abs(area) <= 4 * shift * (longest + shift);
    m_isSurelyBack = (isMirrored ? area < 0 : area > 0) && !m_isThin;
}

bool ExactTriangle::mayVanish() const
{
    if (isEmpty()) return false;
    const double inward        = 2 * m_mostShift + kOurStep;
    const auto   holdsNoCentre = [inward](double from, double to) {
        return std::ceil(from + inward - 0.5) > std::floor(to - inward - 0.5);
    };
    return m_isThin || holdsNoCentre(m_left, m_right) || holdsNoCentre(m_top, m_bottom);
}

bool ExactTriangle::mayEndAt(int line) const
{
    for (int i = 0; i < m_count; ++i) {
        const Corner& corner = m_corners[static_cast<std::size_t>(i)];
        if (std::abs(corner.y - (line + 0.5)) <= shiftAt(corner.x, corner.y, corner.depth).y + kOurStep) return true;
    }
    return false;
}

Place ExactTriangle::depthOf(int i, int j) const
{
    Place place;
    if (isEmpty()) return place;
    const double x = i + 0.5, y = j + 0.5, range = m_hi - m_lo;
    const double plane = m_isEdgeOn ? m_hi : m_a * x + m_b * y + m_c;
    place.depth        = std::clamp(plane, m_lo, m_hi);
    const Shift  shift = shiftAt(x, y, place.depth);
    const double tilt  = m_isEdgeOn ? range : std::abs(m_a) * shift.x + std::abs(m_b) * shift.y;
    place.slack        = std::min(tilt, range) + place.depth * m_zError;
    return place;
}

Place ExactTriangle::placeOf(int i, int j) const
{
    Place place = depthOf(i, j);
    if (isEmpty()) return place;
    const double x = i + 0.5, y = j + 0.5;
    if (x < m_left || x > m_right || y < m_top || y > m_bottom) return place;
    const double turn = doubleArea() < 0 ? -1 : 1;
    place.isPossible = place.isCertain = true;
    for (int k = 0; k < m_count; ++k) {
        const Corner &a = m_corners[static_cast<std::size_t>(k)],
                     &b = m_corners[static_cast<std::size_t>((k + 1) % m_count)];
        const double ex = b.x - a.x, ey = b.y - a.y, length = std::hypot(ex, ey);
        if (!(length > 0)) continue;
        const double nx = -ey / length * turn, ny = ex / length * turn;
        const double inside = nx * (x - a.x) + ny * (y - a.y);
        const double t      = std::clamp((ex * (x - a.x) + ey * (y - a.y)) / (length * length), 0.0, 1.0);
        const double depth  = a.depth + t * (b.depth - a.depth);
        const Shift  shift  = shiftAt(a.x + t * ex, a.y + t * ey, depth);
        double       most   = std::abs(nx) * shift.x + std::abs(ny) * shift.y;
        // the edge function itself, where it is evaluated in float32
        most += 4 * kRounding * (std::abs(x - a.x) + std::abs(y - a.y));
        if (a.isCrossing && b.isCrossing && !m_isEdgeOn) {
            // where the plane meets the near distance moves with the error of z
            const double slope = std::hypot(m_a, m_b);
            most += m_error.z / m_camera->near / std::max(slope, 1e-300);
        }
        if (inside < -most) place.isPossible = false;
        if (inside < most) place.isCertain = false;
    }
    place.isCertain = place.isCertain && place.isPossible;
    return place;
}

ExactTriangle::Box ExactTriangle::box() const
{
    if (isEmpty() || !(m_left <= m_right)) return {};
    const auto whole = [](double v, int side) { return static_cast<int>(std::clamp(v, -1.0, side + 1.0)); };
    return {std::max(0, whole(std::ceil(m_left - 0.5), m_camera->width)),
            std::min(m_camera->width - 1, whole(std::floor(m_right - 0.5), m_camera->width)),
            std::max(0, whole(std::ceil(m_top - 0.5), m_camera->height)),
            std::min(m_camera->height - 1, whole(std::floor(m_bottom - 0.5), m_camera->height))};
}

}  // namespace zscope::check
