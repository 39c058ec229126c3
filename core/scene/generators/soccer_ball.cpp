// builtin:soccer-ball, and the ball itself.

#include "core/scene/generators/soccer_ball.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/products.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"
#include "core/scene/generators/welder.h"

namespace zscope {

namespace {

constexpr double kSeam = 0.985;  // radius where two patches meet; 1 elsewhere

dvec3 onSphere(const dvec3& p, double radius) { return p * (radius / std::sqrt(dotAsWritten(p, p))); }

/// A ring of a patch: how far out it lies, 1 being the seam, and into how many segments each side is cut.
struct Ring {
    double        reach;
    std::uint32_t segments;
};
constexpr std::array<Ring, 3> kPentagonRings{{{0.34, 1}, {0.90, 3}, {1.0, 4}}};
constexpr std::array<Ring, 5> kHexagonRings{{{0.24, 1}, {0.48, 2}, {0.72, 3}, {0.93, 4}, {1.0, 4}}};

/// Vertices of one ring, counter-clockwise from outside, starting at the first corner.
std::vector<std::uint32_t> ringVertices(Welder& welder, std::span<const dvec3> corners, const Ring& ring)
{
    dvec3 middle{0, 0, 0};
    for (const dvec3& corner : corners) middle += corner;
    middle = middle * (1.0 / static_cast<double>(corners.size()));

    std::vector<std::uint32_t> vertices;
    for (std::size_t side = 0; side < corners.size(); ++side)
        for (std::uint32_t s = 0; s < ring.segments; ++s) {
            const double along = static_cast<double>(s) / ring.segments;
            const dvec3& from  = corners[side];
            const dvec3& to    = corners[(side + 1) % corners.size()];
            const dvec3  edge  = from * (1 - along) + to * along;
            vertices.push_back(
                welder.vertexAt(onSphere(middle + (edge - middle) * ring.reach, ring.reach < 1 ? 1 : kSeam)));
        }
    return vertices;
}

/// The strip between two rings: a quad wherever the inner one has a segment to give, a triangle elsewhere.
void addStrip(Mesh& ball, std::span<const std::uint32_t> inner, std::uint32_t innerSegments,
              std::span<const std::uint32_t> outer, std::uint32_t outerSegments, MaterialId material, GroupId group)
{
    std::size_t in = 0;
    for (std::size_t out = 0; out < outer.size(); ++out) {
        const std::size_t   next     = (out + 1) % outer.size();
        const std::uint32_t s        = static_cast<std::uint32_t>(out % outerSegments);
        const bool          advances = (s + 1) * innerSegments / outerSegments > s * innerSegments / outerSegments;
        const std::size_t   nextIn   = (in + 1) % inner.size();
        if (advances) {
            ball.addPolygon(std::array{inner[in], outer[out], outer[next], inner[nextIn]}, material, group);
            in = nextIn;
        } else {
            ball.addPolygon(std::array{inner[in], outer[out], outer[next]}, material, group);
        }
    }
}

void addPatch(Mesh& ball, Welder& welder, std::span<const dvec3> corners, std::span<const Ring> rings,
              MaterialId material, GroupId group)
{
    std::vector<std::uint32_t> inner = ringVertices(welder, corners, rings[0]);
    ball.addPolygon(inner, material, group);
    for (std::size_t r = 1; r < rings.size(); ++r) {
        std::vector<std::uint32_t> outer = ringVertices(welder, corners, rings[r]);
        addStrip(ball, inner, rings[r - 1].segments, outer, rings[r].segments, material, group);
        inner = std::move(outer);
    }
}

/// The twelve corners of an icosahedron of edge length 2.
std::array<dvec3, 12> icosahedron()
{
    const double          golden = (1 + std::sqrt(5.0)) / 2;
    std::array<dvec3, 12> corners;
    std::size_t           n = 0;
    for (double a : {-1.0, 1.0})
        for (double b : {-golden, golden}) {
            corners[n++] = {0, a, b};
            corners[n++] = {a, b, 0};
            corners[n++] = {b, 0, a};
        }
    return corners;
}

bool areNeighbours(const dvec3& a, const dvec3& b)
{
    const dvec3 apart = a - b;
    return dotAsWritten(apart, apart) < 5 && dotAsWritten(apart, apart) > 1;  // 4 along an edge, above 10 otherwise
}

bool turnsLeft(const dvec3& a, const dvec3& b, const dvec3& c) { return dotAsWritten(crossAsWritten(a, b), c) > 0; }

}  // namespace

std::shared_ptr<const Mesh> makeSoccerBall()
{
    auto ball       = std::make_shared<Mesh>();
    ball->name      = "soccer ball";
    ball->materials = {{"white", palette::kWhite}, {"black", palette::kInk}};
    ball->groups    = {"default", "pentagons", "hexagons"};
    Welder     welder(*ball);
    const auto corners = icosahedron();
    const auto third   = [](const dvec3& near, const dvec3& far) { return (near * 2.0 + far) * (1.0 / 3); };

    for (const dvec3& a : corners) {  // a corner of the icosahedron is cut off: a pentagon
        dvec3 neighbour{};
        for (const dvec3& b : corners)
            if (areNeighbours(a, b)) neighbour = b;
        std::array<dvec3, 5> pentagon;
        for (dvec3& corner : pentagon) {
            corner = third(a, neighbour);
            for (const dvec3& c : corners)
                if (areNeighbours(a, c) && areNeighbours(neighbour, c) && turnsLeft(a, neighbour, c)) {
                    neighbour = c;
                    break;
                }
        }
        addPatch(*ball, welder, pentagon, kPentagonRings, MaterialId{1}, GroupId{1});
    }
    for (std::size_t i = 0; i < corners.size(); ++i)  // what is left of a face: a hexagon
        for (std::size_t j = i + 1; j < corners.size(); ++j)
            for (std::size_t k = i + 1; k < corners.size(); ++k) {
                const dvec3 &a = corners[i], &b = corners[j], &c = corners[k];
                if (!areNeighbours(a, b) || !areNeighbours(b, c) || !areNeighbours(c, a) || !turnsLeft(a, b, c))
                    continue;
                const std::array hexagon{third(a, b), third(b, a), third(b, c), third(c, b), third(c, a), third(a, c)};
                addPatch(*ball, welder, hexagon, kHexagonRings, MaterialId{0}, GroupId{2});
            }
    return ball;
}

namespace generated {

namespace {

Result<Scene> make(const Arguments&)
{
    Scene scene;
    scene.meshes.push_back(makeSoccerBall());
    scene.instances.push_back({MeshId{0}, Affine{}});
    ViewRequest view;
    view.eye         = dvec3{1.1, 1.3, 4.2};
    view.target      = dvec3{0, 0, 0};
    view.verticalFov = 32;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> soccer_ball()
{
    return {{"soccer-ball", "A ball of black pentagons and white hexagons, cut into polygons", {}, make}};
}

}  // namespace generated

}  // namespace zscope
