#include "tests/check/careful_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace zscope::tests {
namespace {

using Vector = std::array<float, 4>;
using Matrix = std::array<Vector, 4>;  // rows

Vector times(const Matrix& m, const Vector& v)
{
    Vector result{};
    for (std::size_t r = 0; r < 4; ++r) result[r] = m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2] + m[r][3] * v[3];
    return result;
}

Matrix times(const Matrix& a, const Matrix& b)
{
    Matrix m{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t k = 0; k < 4; ++k) m[r][c] += a[r][k] * b[k][c];
    return m;
}

Matrix viewOf(const Camera& camera)
{
    const auto row = [&](const dvec3& axis, double sign) {
        const std::array<float, 3> a{static_cast<float>(sign * axis.x), static_cast<float>(sign * axis.y),
                                     static_cast<float>(sign * axis.z)};
        const std::array<float, 3> e{static_cast<float>(camera.eye.x), static_cast<float>(camera.eye.y),
                                     static_cast<float>(camera.eye.z)};
        return Vector{a[0], a[1], a[2], -(a[0] * e[0] + a[1] * e[1] + a[2] * e[2])};
    };
    return {row(camera.right, 1), row(camera.up, 1), row(camera.forward, -1), {0, 0, 0, 1}};
}

/// glFrustum, far plane aside: z_clip = w - 2 near.
Matrix projectionOf(const Camera& camera)
{
    const auto f = static_cast<float>(camera.focal), n = static_cast<float>(camera.near);
    return {{{f * static_cast<float>(camera.height) / static_cast<float>(camera.width), 0, 0, 0},
             {0, f, 0, 0},
             {0, 0, -1, -2 * n},
             {0, 0, -1, 0}}};
}

struct Corner {
    double x, y;   // pixels: float32, or on the grid
    float  depth;  // near/z
};

bool isTopLeft(const Corner& a, const Corner& b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

}  // namespace

Picture CarefulRenderer::draw(const Scene& scene, const Camera& camera) const
{
    Picture      picture{Grid<std::int64_t>(camera.width, camera.height, -1), Grid<float>(camera.width, camera.height)};
    const Matrix clipFromWorld = times(projectionOf(camera), viewOf(camera));
    const auto   near = static_cast<float>(camera.near), far = static_cast<float>(camera.near / camera.far);
    const auto   width = static_cast<float>(camera.width), height = static_cast<float>(camera.height);

    const auto project = [&](const Vector& clip) {
        const float x = (clip[0] / clip[3] * 0.5f + 0.5f) * width, y = (0.5f - clip[1] / clip[3] * 0.5f) * height;
        if (grid == Grid8::Unsnapped) return Corner{x, y, near / clip[3]};
        return Corner{std::rint(x * 256.0) / 256, std::rint(y * 256.0) / 256, near / clip[3]};
    };
    const auto fill = [&](Corner a, Corner b, Corner c, std::int64_t id, bool isMirrored) {
        double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (area == 0) return;
        if (culling == FaceCulling::Back && (isMirrored ? area < 0 : area > 0)) return;
        if (area < 0) std::swap(b, c), area = -area;
        const auto first = [&](double least) {
            return std::max(0, static_cast<int>(std::max(std::floor(least) - 1, -1.0)));
        };
        const auto last = [&](double most, int side) {
            return std::min(side - 1, static_cast<int>(std::min(std::ceil(most) + 1, 1e6)));
        };
        for (int j = first(std::min({a.y, b.y, c.y})); j <= last(std::max({a.y, b.y, c.y}), camera.height); ++j)
            for (int i = first(std::min({a.x, b.x, c.x})); i <= last(std::max({a.x, b.x, c.x}), camera.width); ++i) {
                const double x = i + centre, y = j + centre;
                const auto   edge = [&](const Corner& p, const Corner& q) {
                    return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
                };
                const auto owns = [&](double e, const Corner& p, const Corner& q) {
                    return e > 0 || (e == 0 && (ownsAllEdges || isTopLeft(p, q)));
                };
                const double ab = edge(a, b), bc = edge(b, c), ca = edge(c, a);
                if (!owns(ab, a, b) || !owns(bc, b, c) || !owns(ca, c, a)) continue;
                const float wa = static_cast<float>(bc / area), wb = static_cast<float>(ca / area), wc = 1 - wa - wb;
                const float depth = wa * a.depth + wb * b.depth + wc * c.depth;
                if (depth < far || depth <= picture.depth.at(i, j)) continue;
                picture.depth.at(i, j) = depth;
                picture.ids.at(i, j)   = id;
            }
    };

    std::int64_t id = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = *scene.meshes[instance.mesh.value];
        for (const auto& triangle : mesh.triangles) {
            std::array<Vector, 3> clip;
            for (std::size_t k = 0; k < 3; ++k) {
                const dvec3 world = instance.toWorld.in<float>(mesh.positions[triangle[k]]);
                clip[k] = times(clipFromWorld, Vector{static_cast<float>(world.x), static_cast<float>(world.y),
                                                      static_cast<float>(world.z), 1});
            }
            std::array<Vector, 4> kept{};
            std::size_t           count  = 0;
            const auto            inside = [](const Vector& v) { return v[2] + v[3]; };  // z >= -w
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector& p = clip[k];
                const Vector& q = clip[(k + 1) % 3];
                if (inside(p) >= 0) kept[count++] = p;
                if ((inside(p) >= 0) == (inside(q) >= 0)) continue;
                const Vector& in  = inside(p) >= 0 ? p : q;
                const Vector& out = inside(p) >= 0 ? q : p;
                const float   t   = inside(in) / (inside(in) - inside(out));
                for (std::size_t m = 0; m < 4; ++m) kept[count][m] = in[m] + t * (out[m] - in[m]);
                ++count;
            }
            for (std::size_t k = 2; k < count; ++k)
                fill(project(kept[0]), project(kept[k - 1]), project(kept[k]), id, instance.toWorld.isMirrored());
            ++id;
        }
    }
    return picture;
}

}  // namespace zscope::tests
