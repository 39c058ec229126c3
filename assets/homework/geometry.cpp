#include "geometry.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace {

struct Corner {
    double x, y, depth;  // pixels; near / z
};

Vec3 toView(Vec3 p, const Camera& camera)
{
    const Vec3 d{p.x - camera.eye.x, p.y - camera.eye.y, p.z - camera.eye.z};
    const auto along = [&d](Vec3 axis) { return (axis.x * d.x + axis.y * d.y) + axis.z * d.z; };
    return {along(camera.right), along(camera.up), along(camera.forward)};
}

/// Where the edge from `a`, which is inside, to `b`, which is outside, meets the near plane.
Vec3 crossing(Vec3 a, Vec3 b, double near)
{
    const double t = (a.z - near) / (a.z - b.z);
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), near};
}

/// What lies behind the near plane: 0, 3 or 4 corners.
std::vector<Vec3> clipNear(const Vec3 (&corners)[3], double near)
{
    std::vector<Vec3> kept;
    for (int i = 0; i < 3; ++i) {
        const Vec3 a = corners[i], b = corners[(i + 1) % 3];
        const bool aIn = a.z >= near, bIn = b.z >= near;
        if (aIn) kept.push_back(a);
        if (aIn != bIn) kept.push_back(aIn ? crossing(a, b, near) : crossing(b, a, near));
    }
    return kept;
}

Corner project(Vec3 v, const Camera& camera)
{
    const double depth = camera.near / v.z;
    const double scale = ((camera.height * 0.5) * camera.focal) / camera.near;
    return {camera.width * 0.5 + (v.x * depth) * scale, camera.height * 0.5 - (v.y * depth) * scale, depth};
}

/// The plane of depth over the screen. A triangle that is hardly wider than a line uses its rounded corners.
void setPlane(ScreenTriangle& t, const Corner (&p)[3])
{
    const double d1 = p[1].depth - p[0].depth, d2 = p[2].depth - p[0].depth;
    double       x0 = p[0].x, y0 = p[0].y;
    double       e1x = p[1].x - x0, e1y = p[1].y - y0, e2x = p[2].x - x0, e2y = p[2].y - y0;
    double       det     = e1x * e2y - e2x * e1y;
    const double longest = std::max({std::abs(e1x), std::abs(e1y), std::abs(e2x), std::abs(e2y)});
    if (!(std::abs(det) > longest / 1024)) {
        x0  = double(t.x[0]) / 256;
        y0  = double(t.y[0]) / 256;
        e1x = double(t.x[1]) / 256 - x0;
        e1y = double(t.y[1]) / 256 - y0;
        e2x = double(t.x[2]) / 256 - x0;
        e2y = double(t.y[2]) / 256 - y0;
        det = e1x * e2y - e2x * e1y;
    }
    const double inverse = 1 / det;
    t.a                  = (d1 * e2y - d2 * e1y) * inverse;
    t.b                  = (d2 * e1x - d1 * e2x) * inverse;
    t.c                  = p[0].depth - (t.a * x0 + t.b * y0);
    t.lo                 = float(std::min({p[0].depth, p[1].depth, p[2].depth}));
    t.hi                 = float(std::max({p[0].depth, p[1].depth, p[2].depth}));
}

/// False: it cannot be seen.
bool setUp(ScreenTriangle& t, const Corner (&p)[3], Cull cull)
{
    for (int i = 0; i < 3; ++i) {
        t.x[i] = std::llrint(p[i].x * 256);
        t.y[i] = std::llrint(p[i].y * 256);
    }
    const long long area = (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.y[1] - t.y[0]) * (t.x[2] - t.x[0]);
    if (area == 0) return false;
    if (cull == Cull::BackFaces && area > 0) return false;  // counter-clockwise is the front
    setPlane(t, p);
    if (area < 0) {
        std::swap(t.x[1], t.x[2]);
        std::swap(t.y[1], t.y[2]);
    }
    return true;
}

/// Products of such coordinates fit into 64 bits.
bool isInRange(const Corner& p) { return std::abs(p.x) < 2e6 && std::abs(p.y) < 2e6; }

}  // namespace

std::vector<ScreenTriangle> toScreen(const Scene& scene, const Camera& camera, Cull cull)
{
    std::vector<ScreenTriangle> onScreen;
    int                         outOfRange = 0;
    for (std::size_t id = 0; id < scene.triangles.size(); ++id) {
        Vec3 corners[3];
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = toView(scene.vertices[std::size_t(scene.triangles[id][i])], camera);
        const std::vector<Vec3> kept = clipNear(corners, camera.near);
        for (std::size_t i = 2; i < kept.size(); ++i) {
            const Corner p[3] = {project(kept[0], camera), project(kept[i - 1], camera), project(kept[i], camera)};
            if (!isInRange(p[0]) || !isInRange(p[1]) || !isInRange(p[2])) {
                ++outOfRange;
                continue;
            }
            ScreenTriangle triangle;
            triangle.id = int(id);
            if (setUp(triangle, p, cull)) onScreen.push_back(triangle);
        }
    }
    if (outOfRange > 0)
        std::cerr << outOfRange
                  << " triangles reach more than two million pixels beyond the picture and are left out\n";
    return onScreen;
}

float depthAt(const ScreenTriangle& t, int i, int j)
{
    const float depth = float(t.a * (i + 0.5) + (t.b * (j + 0.5) + t.c));
    return std::min(std::max(depth, t.lo), t.hi);
}

Box boxOf(const ScreenTriangle& t, int width, int height)
{
    // The first centre at or behind the least corner, and the last one at or before the greatest.
    const auto first = [](const long long(&v)[3]) { return ceilDiv(std::min({v[0], v[1], v[2]}) - 128, 256); };
    const auto last  = [](const long long(&v)[3]) { return -ceilDiv(128 - std::max({v[0], v[1], v[2]}), 256); };
    return {int(std::max(first(t.x), 0LL)), int(std::max(first(t.y), 0LL)), int(std::min(last(t.x), width - 1LL)),
            int(std::min(last(t.y), height - 1LL))};
}

long long ceilDiv(long long numerator, long long denominator)
{
    const long long quotient = numerator / denominator;
    return quotient + (numerator % denominator > 0 ? 1 : 0);
}
