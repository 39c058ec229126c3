#include "core/geometry/normal_cone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace zscope {

namespace {

/// Triangles with a smaller ratio of altitude to side have no normal worth trusting.
constexpr double kThinnest = 1e-6;
/// Cones as wide as this see the front of something from almost anywhere.
constexpr double kWidest = 0.05;

struct Normal {
    dvec3  direction{0, 0, 0};  // of length 1, or 0 if the triangle has none
    double altitude = 0;
};

Normal normalOf(const dvec3& a, const dvec3& b, const dvec3& c)
{
    const dvec3  ab = b - a, ac = c - a, bc = c - b;
    const dvec3  across  = glm::cross(ab, ac);
    const double area    = glm::length(across);
    const double longest = std::sqrt(std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)}));
    if (!(area > kThinnest * longest * longest) || !(area < 1e150)) return {};
    return {across / area, area / longest};
}

}  // namespace

NormalCone normalConeOf(std::span<const std::array<dvec3, 3>> triangles, const dvec3& centre)
{
    std::vector<Normal> normals;
    normals.reserve(triangles.size());
    dvec3  sum{0, 0, 0};
    double altitude = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : triangles) {
        normals.push_back(normalOf(a, b, c));
        sum      = sum + normals.back().direction;
        altitude = std::min(altitude, normals.back().altitude);
    }
    const double length = glm::length(sum);
    if (!(length > 0) || !(altitude > 0)) return {};

    const dvec3 axis   = sum / length;
    double      cosine = 1, back = 0;  // the apex must lie so far behind the centre
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const double towards = glm::dot(normals[i].direction, axis);
        if (!(towards - kConeSlack > kWidest)) return {};
        cosine = std::min(cosine, towards - kConeSlack);
        back   = std::max(back, glm::dot(centre - triangles[i][0], normals[i].direction) / towards);
    }
    return {.axis     = axis,
            .apex     = centre - axis * back,
            .cosine   = cosine,
            .sine     = std::sqrt(1 - cosine * cosine),
            .altitude = altitude};
}

BackFaces::BackFaces(const PlacedView& view, const Projection& projection, bool isMirrored)
    : m_near(projection.near), m_focal(projection.focalPixels)
{
    const auto&      axes = view.axes();
    const glm::dmat3 linear(axes[0], axes[1], axes[2]);
    // View space is left-handed: below 0 unless something is mirrored. Where the instance alone is, its fronts are too
    // (core/geometry/facing.h), so an eye in front of a triangle's plane still sees the front.
    const double volume = glm::determinant(linear) * (isMirrored ? 1 : -1);
    const double stretch =
        std::sqrt(glm::dot(axes[0], axes[0]) + glm::dot(axes[1], axes[1]) + glm::dot(axes[2], axes[2]));
    if (!(volume > 1e-3 * stretch * stretch * stretch)) return;
    m_volume  = volume;
    m_stretch = stretch;
    m_eye     = -(glm::inverse(linear) * view.origin());
}

std::optional<BehindQuestion> BackFaces::question(const ViewBox& box) const
{
    if (!(m_volume > 0)) return {};
    const double error = PlacedView::kError * box.magnitude, deep = box.spread(0, 0, 1) + error;
    const double nearest = box.centre.z - deep, farthest = box.centre.z + deep;
    if (!(nearest >= m_near)) return {};
    const double wide  = std::abs(box.centre.x) + box.spread(1, 0, 0) + error,
                 high  = std::abs(box.centre.y) + box.spread(0, 1, 0) + error;
    const double slope = std::sqrt(wide * wide + high * high) / nearest, pixels = m_focal / nearest;
    if (!(m_focal * slope < 1e6)) return {};  // positions beyond some thousand pictures have roundings of their own

    const double moved = 0.7072 / kSubpixels + 2 * pixels * error * (1 + slope) + kConeSlack / kSubpixels;
    return BehindQuestion{.eye             = m_eye,
                          .slack           = kConeSlack * (glm::length(m_eye) + box.magnitude / m_stretch),
                          .areaPerDistance = m_focal * m_focal * m_volume / (farthest * farthest * farthest),
                          .change          = (1 + 1e-6) * 3 * moved * pixels * m_stretch * std::sqrt(1 + slope * slope),
                          .changePerAltitude = (1 + 1e-6) * 4 * moved * moved};
}

bool BehindQuestion::holdsOf(const NormalCone& cone) const
{
    if (!cone.promises()) return false;
    const dvec3  ahead = cone.apex - eye;
    const double along = glm::dot(ahead, cone.axis);
    if (!(along > 0)) return false;
    const dvec3  aside    = ahead - cone.axis * along;
    const double place    = std::abs(cone.apex.x) + std::abs(cone.apex.y) + std::abs(cone.apex.z);
    const double distance = along * cone.cosine - glm::length(aside) * cone.sine - (slack + kConeSlack * place);
    return distance > 0
           && areaPerDistance * cone.altitude * distance * cone.altitude > change * cone.altitude + changePerAltitude;
}

bool BackFaces::hold(const NormalCone& cone, const ViewBox& box) const
{
    const std::optional<BehindQuestion> asked = question(box);
    return asked && asked->holdsOf(cone);
}

}  // namespace zscope
