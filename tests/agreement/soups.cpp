#include "tests/agreement/soups.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include <glm/geometric.hpp>

namespace zscope::tests {

namespace {

class Random {
public:
    explicit Random(std::uint64_t seed) : m_bits(seed * 0x9E37'79B9'7F4A'7C15ull + 1) {}

    double between(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(m_bits() >> 11) * 0x1p-53); }
    int    below(int n) { return static_cast<int>(m_bits() % static_cast<unsigned>(n)); }
    bool   chance(double share) { return between(0, 1) < share; }
    dvec3  direction()
    {
        for (;;) {
            const dvec3  v{between(-1, 1), between(-1, 1), between(-1, 1)};
            const double length = glm::length(v);
            if (length > 0.1 && length < 1) return v / length;
        }
    }

private:
    std::mt19937_64 m_bits;
};

Camera randomCamera(Random& random, const dvec3& eye, double unit, int width, int height)
{
    Camera camera;
    camera.eye     = eye;
    camera.forward = random.direction();
    camera.right   = glm::normalize(glm::cross(camera.forward, random.direction()));
    camera.up      = glm::cross(camera.right, camera.forward);
    camera.focal   = 1 / std::tan(random.between(0.3, 1.0));
    camera.near    = unit * random.between(0.05, 0.5);
    camera.far     = random.chance(0.5) ? std::numeric_limits<double>::infinity() : unit * random.between(10, 40);
    camera.width   = width;
    camera.height  = height;
    return camera;
}

/// Corners of one mesh, with what is needed to put them where the camera sees them.
struct Builder {
    Random&       random;
    const Camera& camera;
    double        unit;  // distances are given in these
    Mesh          mesh = {};

    std::uint32_t add(const dvec3& p)
    {
        mesh.positions.push_back(p);
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    }
    /// In braces, so that random parts are drawn from left to right: the order of function arguments is open.
    std::uint32_t seenAt(const dvec3& p) { return add(pointAt(camera, p.x, p.y, p.z * unit)); }
    void          triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { addFan(mesh, std::array{a, b, c}); }
    double        anyX(double margin = 0.3) { return random.between(-margin, 1 + margin) * camera.width; }
    double        anyY(double margin = 0.3) { return random.between(-margin, 1 + margin) * camera.height; }
    double        anyZ() { return random.between(1, 15); }
};

void loose(Builder& b, int triangles)
{
    for (int i = 0; i < triangles; ++i) {
        const double x = b.anyX(), y = b.anyY(), size = b.random.between(0.02, 0.6) * (b.camera.height + 2);
        const auto   corner = [&] {
            return b.seenAt({x + b.random.between(-size, size), y + b.random.between(-size, size), b.anyZ()});
        };
        const auto p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

void grid(Builder& b, int triangles)
{
    const int                  n = std::max(2, static_cast<int>(std::sqrt(triangles / 2.0)));
    std::vector<std::uint32_t> row;
    for (int j = 0; j <= n; ++j) {
        std::vector<std::uint32_t> next;
        for (int i = 0; i <= n; ++i) {
            next.push_back(b.seenAt({(i + b.random.between(-0.3, 0.3)) * b.camera.width / n,
                                     (j + b.random.between(-0.3, 0.3)) * b.camera.height / n, b.random.between(3, 5)}));
        }
        for (std::size_t i = 0; j > 0 && i < static_cast<std::size_t>(n); ++i) {
            b.triangle(row[i], row[i + 1], next[i + 1]);
            b.triangle(row[i], next[i + 1], next[i]);
        }
        row = next;
    }
}

void fan(Builder& b, int triangles)
{
    const double x = std::floor(b.anyX(0)) + 0.5, y = std::floor(b.anyY(0)) + 0.5;  // a pixel centre
    const auto   centre = b.seenAt({x, y, 4});
    const double radius = b.random.between(0.3, 1.0) * (b.camera.height + 1);
    const auto   rim    = [&](int i) {
        const double angle = 2 * 3.141592653589793 * i / triangles;
        return b.seenAt({x + radius * std::cos(angle), y + radius * std::sin(angle), 4 + std::sin(3 * angle)});
    };
    const auto first = rim(0);
    auto       last  = first;
    for (int i = 1; i <= triangles; ++i) {
        const auto next = i == triangles ? first : rim(i);
        b.triangle(centre, last, next);
        last = next;
    }
}

void coplanar(Builder& b, int triangles)
{
    const dvec3 origin = pointAt(b.camera, b.camera.width * 0.5, b.camera.height * 0.5, 5 * b.unit);
    const dvec3 s = b.random.direction(), t = b.random.direction();
    for (int i = 0; i < triangles; ++i) {
        const auto corner = [&] {
            const double alongS = b.unit * b.random.between(-3, 3);
            const double alongT = b.unit * b.random.between(-3, 3);
            return b.add(origin + s * alongS + t * alongT);
        };
        const auto p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

void nonPlanarQuads(Builder& b, int triangles)
{
    for (int i = 0; i < triangles / 2; ++i) {
        const double x = b.anyX(), y = b.anyY(), size = b.random.between(0.1, 0.5) * (b.camera.height + 2);
        const auto   corner = [&](double sx, double sy) {
            return b.seenAt(
                  {x + sx * size * b.random.between(0.5, 1), y + sy * size * b.random.between(0.5, 1), b.anyZ()});
        };
        addFan(b.mesh, std::array{corner(-1, -1), corner(-1, 1), corner(1, 1), corner(1, -1)});
    }
}

void eyeInside(Builder& b, int triangles)
{
    const auto around = [&](const dvec3& v, double size) { return b.add(b.camera.eye + v * (size * b.unit)); };
    std::array<std::uint32_t, 8> box;
    for (std::size_t i = 0; i < 8; ++i) box[i] = around({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1}, 9);
    for (const auto& side :
         {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
        std::array<std::uint32_t, 4> outline;
        for (std::size_t i = 0; i < 4; ++i) outline[i] = box[static_cast<std::size_t>(side[i])];
        addFan(b.mesh, outline);
    }
    for (int i = 12; i < triangles; ++i) {
        const dvec3 v      = b.random.direction();
        const auto  corner = [&] {
            const double distance = b.random.between(0.2, 8);
            return around(v + 0.4 * b.random.direction(), distance);
        };
        const auto p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

void huge(Builder& b, int triangles)
{
    for (int i = 0; i < triangles; ++i) {
        const auto corner = [&] { return b.seenAt({b.anyX(3000), b.anyY(3000), b.anyZ()}); };
        const auto p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

void slivers(Builder& b, int triangles)
{
    for (int i = 0; i < triangles; ++i) {
        const double x = b.anyX(), y = b.anyY(), angle = b.random.between(0, 6.28);
        const double length  = b.random.between(0.2, 2) * b.camera.width;
        const double halving = std::ldexp(1.0, -b.random.below(14));
        const double width   = halving * b.random.between(0, 1);  // pixels
        const double cx = std::cos(angle), cy = std::sin(angle), z = b.anyZ();
        const auto   p = b.seenAt({x, y, z});
        const auto   q = b.seenAt({x + length * cx, y + length * cy, b.random.chance(0.5) ? z : b.anyZ()});
        const auto   r = b.seenAt({x + length / 2 * cx - width * cy, y + length / 2 * cy + width * cx, b.anyZ()});
        b.triangle(p, q, r);
    }
}

void nearCrossing(Builder& b, int triangles)
{
    const double near = b.camera.near / b.unit;
    for (int i = 0; i < triangles; ++i) {
        const auto corner = [&] {
            const std::array<double, 7> z{near, near * 1.001, near * 0.5, -near, -3, near * 2, 8};
            const double                distance = b.random.chance(0.5) ? z[static_cast<std::size_t>(b.random.below(7))]
                                                                        : b.random.between(-2, 8) * near * 2;
            const double                x        = b.random.between(-3, 3);
            const double                y        = b.random.between(-3, 3);
            return b.add(b.camera.eye + (b.camera.forward * distance + b.camera.right * x + b.camera.up * y) * b.unit);
        };
        const auto p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
        if (i % 3 == 0) b.triangle(q, p, corner());  // a neighbour that lists the shared edge the other way
    }
}

void onTheGrid(Builder& b, int triangles)
{
    for (int i = 0; i < triangles; ++i) {
        const auto snap = [&](double v) {
            const std::array<double, 4> fractions{0, 0.5, 0.25, 0.5 / 256};
            return std::floor(v) + fractions[static_cast<std::size_t>(b.random.below(4))];
        };
        const double z      = std::ldexp(1, b.random.below(4));
        const auto   corner = [&] { return b.seenAt({snap(b.anyX()), snap(b.anyY()), z}); };
        const auto   p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

void dust(Builder& b, int triangles)
{
    for (int i = 0; i < triangles * 8; ++i) {
        const double x = b.anyX(0.05), y = b.anyY(0.05), z = b.anyZ();
        const auto   corner = [&] { return b.seenAt({x + b.random.between(-1, 1), y + b.random.between(-1, 1), z}); };
        const auto   p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

void repeated(Builder& b, int triangles)
{
    loose(b, std::max(1, triangles / 6));
    const auto once = b.mesh.triangles;
    for (int again = 0; again < 5; ++again) {
        for (const auto& [p, q, r] : once) again % 2 ? b.triangle(p, q, r) : b.triangle(r, q, p);
    }
}

void beyondTheGuard(Builder& b, int triangles)
{
    for (int i = 0; i < triangles; ++i) {
        const auto far = [&] {
            const double power = std::ldexp(b.random.chance(0.5) ? -1.0 : 1.0, 20 + b.random.below(40));
            return power * b.random.between(1, 2);
        };
        const auto corner = [&] {
            return b.random.chance(0.4) ? b.seenAt({far(), far(), b.anyZ()}) : b.seenAt({b.anyX(), b.anyY(), b.anyZ()});
        };
        const auto p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

void beyondFar(Builder& b, int triangles)
{
    const double far = b.camera.far / b.unit;
    for (int i = 0; i < triangles; ++i) {
        const double z      = far * (1 + (b.random.below(9) - 4) * 0x1p-24);
        const bool   level  = b.random.chance(0.6);
        const auto   corner = [&] {
            return b.seenAt({b.anyX(), b.anyY(), level ? z : far * b.random.between(0.7, 1.3)});
        };
        const auto p = corner(), q = corner(), r = corner();
        b.triangle(p, q, r);
    }
}

/// Places that turn, stretch and mirror the mesh about the point it is seen at.
std::vector<Affine> turns(Random& random, const dvec3& about)
{
    std::vector<Affine> places{Affine{}};
    for (int i = 0; i < 4; ++i) {
        const dvec3  x = random.direction();
        const dvec3  y = glm::normalize(glm::cross(x, random.direction()));
        const dvec3  z = glm::cross(x, y) * (random.chance(0.3) ? -1.0 : 1.0);
        const double s = random.between(0.3, 1.5);
        Affine       turn;
        for (int r = 0; r < 3; ++r) turn.rows[static_cast<std::size_t>(r)] = {s * x[r], s * y[r], s * z[r], 0};
        places.push_back(compose(Affine::translation(about), compose(turn, Affine::translation(-about))));
    }
    return places;
}

}  // namespace

Camera plainCamera(int width, int height)
{
    Camera camera;
    camera.forward = {0, 0, 1};
    camera.near    = 1;
    camera.far     = std::numeric_limits<double>::infinity();
    camera.width   = width;
    camera.height  = height;
    return camera;
}

dvec3 pointAt(const Camera& camera, double x, double y, double z)
{
    const double pixel = z / (camera.height * 0.5 * camera.focal);  // size of a pixel at that distance
    return camera.eye + camera.forward * z + camera.right * ((x - camera.width * 0.5) * pixel)
           + camera.up * ((camera.height * 0.5 - y) * pixel);
}

void addFan(Mesh& mesh, std::span<const std::uint32_t> outline)
{
    const PolygonId polygon{static_cast<std::uint32_t>(mesh.polygonCount())};
    mesh.corners.insert(mesh.corners.end(), outline.begin(), outline.end());
    for (std::size_t i = 2; i < outline.size(); ++i) {
        mesh.triangles.push_back({outline[0], outline[i - 1], outline[i]});
        mesh.trianglePolygon.push_back(polygon);
    }
    mesh.firstCorner.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    mesh.firstTriangle.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
    mesh.polygonMaterial.push_back({});
    mesh.polygonGroup.push_back({});
}

std::shared_ptr<const Scene> sceneOf(Mesh mesh, std::span<const Affine> places)
{
    Scene parts;
    parts.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
    for (const Affine& place : places) parts.instances.push_back({.mesh = MeshId{0}, .toWorld = place});
    auto scene = assemble(std::move(parts));
    assert(scene.ok());
    return std::make_shared<const Scene>(*std::move(scene));
}

std::shared_ptr<const Scene> sceneOf(std::span<const Corners> triangles)
{
    Mesh mesh;
    for (const Corners& corners : triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
        addFan(mesh, std::array{first, first + 1, first + 2});
    }
    return sceneOf(std::move(mesh), std::array{Affine{}});
}

std::span<const SoupKind> soupKinds()
{
    using enum SoupKind;
    static constexpr std::array kinds{Loose,         Grid,      Fan,      Coplanar,       NonPlanarQuads, EyeInside,
                                      FarFromOrigin, TinyScale, Huge,     Slivers,        NearCrossing,   OnTheGrid,
                                      Dust,          Turned,    Repeated, BeyondTheGuard, BeyondFar};
    return kinds;
}

std::string_view nameOf(SoupKind kind)
{
    static constexpr std::array<std::string_view, 17> names{"loose",
                                                            "grid",
                                                            "fan",
                                                            "coplanar",
                                                            "non-planar quads",
                                                            "eye inside",
                                                            "1e6 off the origin",
                                                            "scaled by 1e-6",
                                                            "3,000 times the view",
                                                            "slivers",
                                                            "near crossing",
                                                            "on the grid",
                                                            "dust",
                                                            "turned instances",
                                                            "repeated",
                                                            "beyond the guard",
                                                            "beyond far"};
    return names[static_cast<std::size_t>(kind)];
}

Soup makeSoup(SoupKind kind, std::uint64_t seed, int width, int height, int triangles)
{
    Random       random(seed);
    const double unit   = kind == SoupKind::TinyScale ? 1e-6 : 1;
    const dvec3  eye    = kind == SoupKind::FarFromOrigin ? random.direction() * 1e6 : random.direction() * unit;
    Camera       camera = randomCamera(random, eye, unit, width, height);
    // Cameras whose rounding is not the point: coordinates come out as they were asked for.
    if (kind == SoupKind::OnTheGrid || kind == SoupKind::BeyondTheGuard) camera = plainCamera(width, height);
    if (kind == SoupKind::BeyondFar) camera.far = 20;

    Builder builder{.random = random, .camera = camera, .unit = unit};
    switch (kind) {
        case SoupKind::Loose:
        case SoupKind::FarFromOrigin:
        case SoupKind::TinyScale:
        case SoupKind::Turned:
            loose(builder, triangles);
            break;
        case SoupKind::Grid:
            grid(builder, triangles);
            break;
        case SoupKind::Fan:
            fan(builder, triangles);
            break;
        case SoupKind::Coplanar:
            coplanar(builder, triangles);
            break;
        case SoupKind::NonPlanarQuads:
            nonPlanarQuads(builder, triangles);
            break;
        case SoupKind::EyeInside:
            eyeInside(builder, triangles);
            break;
        case SoupKind::Huge:
            huge(builder, triangles);
            break;
        case SoupKind::Slivers:
            slivers(builder, triangles);
            break;
        case SoupKind::NearCrossing:
            nearCrossing(builder, triangles);
            break;
        case SoupKind::OnTheGrid:
            onTheGrid(builder, triangles);
            break;
        case SoupKind::Dust:
            dust(builder, triangles);
            break;
        case SoupKind::Repeated:
            repeated(builder, triangles);
            break;
        case SoupKind::BeyondTheGuard:
            beyondTheGuard(builder, triangles);
            break;
        case SoupKind::BeyondFar:
            beyondFar(builder, triangles);
            break;
    }

    std::vector<Affine> places{Affine{}};
    if (kind == SoupKind::Turned) places = turns(random, pointAt(camera, width * 0.5, height * 0.5, 6));
    return {.scene  = sceneOf(std::move(builder.mesh), places),
            .camera = camera,
            .what = std::string(nameOf(kind)) + ", seed " + std::to_string(seed) + ", " + std::to_string(width) + " x "
                    + std::to_string(height)};
}

}  // namespace zscope::tests
