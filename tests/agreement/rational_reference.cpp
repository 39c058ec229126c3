#include "tests/agreement/rational_reference.h"

#include <algorithm>
#include <cmath>

namespace zscope::tests {

namespace {

struct RationalPoint {
    mpq_class x, y, z;
    bool      inside = true;  // of the near plane
};

RationalPoint viewSpace(const dvec3& q, const Affine& toWorld, const Camera& camera)
{
    const auto row = [&q](const std::array<double, 4>& m) {
        return mpq_class(mpq_class(m[0]) * q.x + mpq_class(m[1]) * q.y + mpq_class(m[2]) * q.z + m[3]);
    };
    const mpq_class x     = row(toWorld.rows[0]) - camera.eye.x;
    const mpq_class y     = row(toWorld.rows[1]) - camera.eye.y;
    const mpq_class z     = row(toWorld.rows[2]) - camera.eye.z;
    const auto      along = [&](const dvec3& axis) { return mpq_class(x * axis.x + y * axis.y + z * axis.z); };
    return {along(camera.right), along(camera.up), along(camera.forward)};
}

/// z as float64 has it, for the one decision that the definition takes on a rounded number.
double roundedZ(const dvec3& q, const Affine& toWorld, const Camera& camera)
{
    const dvec3 d = (toWorld.isIdentity() ? q : toWorld(q)) - camera.eye;
    return (camera.forward.x * d.x + camera.forward.y * d.y) + camera.forward.z * d.z;
}

std::vector<RationalPoint> clipNear(const std::array<RationalPoint, 3>& corners, const mpq_class& near)
{
    std::vector<RationalPoint> kept;
    for (std::size_t i = 0; i < 3; ++i) {
        const RationalPoint& a = corners[i];
        const RationalPoint& b = corners[(i + 1) % 3];
        if (a.inside) kept.push_back(a);
        if (a.inside == b.inside) continue;
        const mpq_class t = a.z == b.z ? mpq_class(0) : mpq_class((near - a.z) / (b.z - a.z));
        kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), near});
    }
    return kept;
}

RationalCorner project(const RationalPoint& v, const Camera& camera)
{
    const mpq_class halfHeight(camera.height, 2);
    const mpq_class scale = halfHeight * camera.focal / v.z;
    RationalCorner  corner;
    corner.x     = mpq_class(camera.width, 2) + scale * v.x;
    corner.y     = halfHeight - scale * v.y;
    corner.depth = mpq_class(camera.near) / v.z;
    corner.xs    = toInteger(corner.x * 256);
    corner.ys    = toInteger(corner.y * 256);
    return corner;
}

mpz_class cross(const mpz_class& ax, const mpz_class& ay, const mpz_class& bx, const mpz_class& by)
{
    return ax * by - ay * bx;
}

mpz_class fromInt64(std::int64_t value)
{
    static_assert(sizeof(long) == sizeof(std::int64_t));
    return mpz_class(static_cast<long>(value));
}

}  // namespace

mpz_class toInteger(const mpq_class& value)
{
    mpz_class below, rest;  // value = below + rest / den, 0 <= rest < den
    mpz_fdiv_qr(below.get_mpz_t(), rest.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
    const int side = cmp(mpz_class(rest * 2), value.get_den());
    if (side > 0 || (side == 0 && mpz_odd_p(below.get_mpz_t()))) ++below;
    return below;
}

float toFloat(const mpq_class& value)
{
    if (value == 0) return 0;
    // The unit of the last place: 2^(e - 23) where 2^e <= value < 2^(e + 1), and 2^-149 for denormals.
    auto e = static_cast<int>(mpz_sizeinbase(value.get_num_mpz_t(), 2))
             - static_cast<int>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
    const auto power = [](int n) {
        mpq_class p = 1;
        if (n >= 0)
            mpq_mul_2exp(p.get_mpq_t(), p.get_mpq_t(), static_cast<mp_bitcnt_t>(n));
        else
            mpq_div_2exp(p.get_mpq_t(), p.get_mpq_t(), static_cast<mp_bitcnt_t>(-n));
        return p;
    };
    if (value < power(e)) --e;
    const int unit = std::max(e, -126) - 23;
    return static_cast<float>(std::ldexp(toInteger(value / power(unit)).get_d(), unit));
}

RationalPart::RationalPart(const std::array<RationalCorner, 3>& corners) : m_corners(corners)
{
    const auto& [c0, c1, c2] = m_corners;
    m_lo                     = toFloat(std::min({c0.depth, c1.depth, c2.depth}));
    m_hi                     = toFloat(std::max({c0.depth, c1.depth, c2.depth}));

    const mpq_class e1x = c1.x - c0.x, e1y = c1.y - c0.y, e2x = c2.x - c0.x, e2y = c2.y - c0.y;
    const mpq_class e3x = c2.x - c1.x, e3y = c2.y - c1.y;
    const mpq_class det = e1x * e2y - e2x * e1y;
    m_isEdgeOn          = det == 0;
    if (m_isEdgeOn) return;
    const mpq_class d1 = c1.depth - c0.depth, d2 = c2.depth - c0.depth;
    m_a = (d1 * e2y - d2 * e1y) / det;
    m_b = (d2 * e1x - d1 * e2x) / det;
    m_c = c0.depth - m_a * c0.x - m_b * c0.y;

    const mpq_class longest = std::max(
        {mpq_class(e1x * e1x + e1y * e1y), mpq_class(e2x * e2x + e2y * e2y), mpq_class(e3x * e3x + e3y * e3y)});
    m_isThick = det * det * 1024 * 1024 > longest;  // the height over the longest side is |det| / length
}

void RationalPart::adoptSnapped(const std::array<definition::Corner, 3>& corners)
{
    for (std::size_t i = 0; i < 3; ++i) {
        m_corners[i].xs = fromInt64(corners[i].xs);
        m_corners[i].ys = fromInt64(corners[i].ys);
    }
}

int RationalPart::sign() const
{
    const auto& [a, b, c] = m_corners;
    return sgn(cross(b.xs - a.xs, b.ys - a.ys, c.xs - a.xs, c.ys - a.ys));
}

bool RationalPart::covers(int i, int j) const
{
    const mpz_class px = 256 * i + 128, py = 256 * j + 128;
    const int       turn = sign();
    for (std::size_t k = 0; k < 3; ++k) {
        const RationalCorner& a = m_corners[k];
        const RationalCorner& b = m_corners[(k + 1) % 3];
        // Seen with the part on the positive side, that is with the edge turned round if the part is a front.
        const mpz_class dx = turn * (b.xs - a.xs), dy = turn * (b.ys - a.ys);
        const mpz_class e         = cross(dx, dy, px - a.xs, py - a.ys);
        const bool      leftOrTop = dy < 0 || (dy == 0 && dx > 0);
        if (e < 0 || (e == 0 && !leftOrTop)) return false;
    }
    return true;
}

float RationalPart::depth(int i, int j) const
{
    if (m_isEdgeOn) return m_hi;
    mpq_class z = m_a * mpq_class(2 * i + 1, 2) + m_b * mpq_class(2 * j + 1, 2) + m_c;
    z           = std::clamp(z, mpq_class(0), mpq_class(1));
    return std::clamp(toFloat(z), m_lo, m_hi);
}

RationalTriangle rationalTriangle(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle,
                                  const Camera& camera)
{
    const Mesh&                  mesh    = scene.meshOf(instance);
    const Affine&                toWorld = scene.instances[instance.value].toWorld;
    const mpq_class              near(camera.near);
    std::array<RationalPoint, 3> corners;
    RationalTriangle             triangle;
    const auto isOnPlane = [&near](const RationalPoint& p) { return abs(mpq_class(p.z - near)) < near * 0x1p-40; };
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3& q    = mesh.positions[mesh.triangles[meshTriangle][i]];
        corners[i]        = viewSpace(q, toWorld, camera);
        corners[i].inside = corners[i].z >= near;
        const bool inside = roundedZ(q, toWorld, camera) >= camera.near;
        if (inside != corners[i].inside && isOnPlane(corners[i])) {
            corners[i].inside = inside;
            ++triangle.nearTies;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const RationalPoint& a = corners[i];
        const RationalPoint& b = corners[(i + 1) % 3];
        triangle.cutIsOpen |= a.inside != b.inside && isOnPlane(a) && isOnPlane(b);
    }
    const std::vector<RationalPoint> outline = clipNear(corners, near);
    for (std::size_t i = 2; i < outline.size(); ++i) {
        triangle.parts.emplace_back(
            std::array{project(outline[0], camera), project(outline[i - 1], camera), project(outline[i], camera)});
    }
    return triangle;
}

}  // namespace zscope::tests
