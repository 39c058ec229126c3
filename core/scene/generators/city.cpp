// builtin:city: blocks of buildings between streets, all of it polygons as an architect would draw them.
//
// Units      metres; y is up, streets at 0, pavements 0.15 above
// Blocks     each has two rows of lots: towers of glass panels on an eight- or twelve-cornered plan, houses with
//            windows set into the walls, L-shaped halls (concave roofs), gabled houses; one block in nine is a park
//            with trees
// Faces      walls and windows are quads, roofs n-gons; about 900 triangles a lot, half a million by default
// Promise    a block depends on seed and its place only

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/random.h"
#include "core/scene/generators/registry.h"

namespace zscope::generated {

namespace {

constexpr double kBlockX = 64, kBlockZ = 44;  // a block without its streets
constexpr double kStreet   = 14;
constexpr double kPavement = 0.15;
constexpr int    kLotsX = 3, kLotsZ = 2;
constexpr double kTrianglesPerBlock = 7500;  // on average, rounded up, for the memory check

enum Surface : std::uint32_t {
    Asphalt,
    Marking,
    Pavement,
    Grass,
    Sand,
    Brick,
    Plaster,
    Slate,
    Glass,
    DarkGlass,
    Roof,
    Tile,
    Bark,
    Leaf
};

std::vector<Material> surfaces()
{
    return {
        {"asphalt", {0.10f, 0.105f, 0.115f}},  {"marking", {0.72f, 0.71f, 0.66f}}, {"pavement", {0.40f, 0.39f, 0.37f}},
        {"grass", {0.18f, 0.36f, 0.15f}},      {"sand", {0.70f, 0.60f, 0.43f}},    {"brick", {0.50f, 0.22f, 0.14f}},
        {"plaster", {0.78f, 0.72f, 0.60f}},    {"slate", {0.36f, 0.42f, 0.50f}},   {"glass", {0.26f, 0.46f, 0.62f}},
        {"dark glass", {0.07f, 0.13f, 0.20f}}, {"roof", {0.30f, 0.29f, 0.29f}},    {"tile", {0.46f, 0.17f, 0.10f}},
        {"bark", {0.20f, 0.13f, 0.08f}},       {"leaf", {0.10f, 0.30f, 0.13f}}};
}

/// A point of a plan, as seen from above.
struct Place {
    double x, z;
};
using Plan = std::vector<Place>;  // an outline, counter-clockwise seen from above (x right, z down)

class CityBuilder {
public:
    CityBuilder(Mesh& mesh, std::uint64_t seed, int blocks) : m_mesh(mesh), m_seed(seed), m_blocks(blocks) {}

    void ground();
    void block(int column, int row);

    double west() const { return -0.5 * (m_blocks * (kBlockX + kStreet) - kStreet); }
    double north() const { return -0.5 * (m_blocks * (kBlockZ + kStreet) - kStreet); }

private:
    std::uint32_t vertex(double x, double y, double z)
    {
        m_mesh.positions.push_back({x, y, z});
        return static_cast<std::uint32_t>(m_mesh.positions.size() - 1);
    }
    void face(std::span<const std::uint32_t> outline, Surface surface)
    {
        m_mesh.addPolygon(outline, MaterialId{surface}, m_group);
    }
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, Surface surface)
    {
        face(std::array{a, b, c, d}, surface);
    }
    /// A level rectangle seen from above.
    void flat(double x0, double z0, double x1, double z1, double y, Surface surface)
    {
        quad(vertex(x0, y, z0), vertex(x0, y, z1), vertex(x1, y, z1), vertex(x1, y, z0), surface);
    }
    void level(const Plan& plan, double y, Surface surface);
    void plainWalls(const Plan& plan, double low, double high, Surface surface);
    void panelWall(Place from, Place to, double low, double high, int columns, int floors, Random& random);
    void windowWall(Place from, Place to, double low, double high, int columns, int floors, Surface wall);

    void tower(Random& random, Place middle, double reach);
    void house(Random& random, double x0, double z0, double x1, double z1);
    void hall(Random& random, double x0, double z0, double x1, double z1);
    void gabled(Random& random, double x0, double z0, double x1, double z1);
    void park(Random& random, double x0, double z0, double x1, double z1);
    void tree(Random& random, Place at);

    Mesh&         m_mesh;
    std::uint64_t m_seed;
    int           m_blocks;
    GroupId       m_group;
};

Plan rectangle(double x0, double z0, double x1, double z1) { return {{x0, z0}, {x0, z1}, {x1, z1}, {x1, z0}}; }

void CityBuilder::level(const Plan& plan, double y, Surface surface)
{
    std::vector<std::uint32_t> outline;
    for (const Place& p : plan) outline.push_back(vertex(p.x, y, p.z));
    face(outline, surface);
}

void CityBuilder::plainWalls(const Plan& plan, double low, double high, Surface surface)
{
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const Place a = plan[i], b = plan[(i + 1) % plan.size()];
        quad(vertex(a.x, low, a.z), vertex(b.x, low, b.z), vertex(b.x, high, b.z), vertex(a.x, high, a.z), surface);
    }
}

/// A curtain wall: a grid of panels with shared corners, some lighter than others.
void CityBuilder::panelWall(Place from, Place to, double low, double high, int columns, int floors, Random& random)
{
    const auto first = static_cast<std::uint32_t>(m_mesh.positions.size());
    for (int f = 0; f <= floors; ++f)
        for (int c = 0; c <= columns; ++c) {
            const double s = static_cast<double>(c) / columns;
            vertex(from.x + (to.x - from.x) * s, low + (high - low) * f / floors, from.z + (to.z - from.z) * s);
        }
    const auto at = [&](int c, int f) { return first + static_cast<std::uint32_t>(f * (columns + 1) + c); };
    for (int f = 0; f < floors; ++f)
        for (int c = 0; c < columns; ++c) {
            const auto draw = random.below(8);
            quad(at(c, f), at(c + 1, f), at(c + 1, f + 1), at(c, f + 1),
                 draw == 0  ? DarkGlass
                 : draw < 3 ? Slate
                            : Glass);
        }
}

/// A wall of cells, each with a window set into it: four quads of wall, four of reveal, one of glass.
void CityBuilder::windowWall(Place from, Place to, double low, double high, int columns, int floors, Surface wall)
{
    const double dx = to.x - from.x, dz = to.z - from.z;
    const double length = std::sqrt(dx * dx + dz * dz);
    const Place  inward{dz / length * 0.22, -dx / length * 0.22};  // how deep a window lies
    const auto   at = [&](double s, double t, double depth) {
        return vertex(from.x + dx * s + inward.x * depth, low + (high - low) * t, from.z + dz * s + inward.z * depth);
    };
    for (int f = 0; f < floors; ++f)
        for (int c = 0; c < columns; ++c) {
            const double     s0 = static_cast<double>(c) / columns, s1 = static_cast<double>(c + 1) / columns;
            const double     t0 = static_cast<double>(f) / floors, t1 = static_cast<double>(f + 1) / floors;
            const double     a = s0 + (s1 - s0) * 0.24, b = s1 - (s1 - s0) * 0.24;
            const double     d = t0 + (t1 - t0) * 0.28, e = t1 - (t1 - t0) * 0.18;
            const std::array cell{at(s0, t0, 0), at(s1, t0, 0), at(s1, t1, 0), at(s0, t1, 0)};
            const std::array frame{at(a, d, 0), at(b, d, 0), at(b, e, 0), at(a, e, 0)};
            const std::array pane{at(a, d, 1), at(b, d, 1), at(b, e, 1), at(a, e, 1)};
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t j = (i + 1) % 4;
                quad(cell[i], cell[j], frame[j], frame[i], wall);
                quad(frame[i], frame[j], pane[j], pane[i], Plaster);
            }
            face(pane, DarkGlass);
        }
}

void CityBuilder::tower(Random& random, Place middle, double reach)
{
    const std::size_t corners = random.below(2) == 0 ? 8 : 12;
    const double      height  = 30 + random.unit() * random.unit() * 75;
    const auto        ring    = [&](double radius) {
        Plan plan;
        for (std::size_t i = 0; i < corners; ++i) {
            const auto [c, s] = pointOnCircle((static_cast<double>(i) + 0.5) / static_cast<double>(corners));
            plan.push_back({middle.x + radius * c, middle.z - radius * s});
        }
        return plan;
    };
    const Plan   outer  = ring(reach);
    const Plan   inner  = ring(reach * 0.88);
    const Plan   crown  = ring(reach * 0.35);
    const double waist  = height * random.between(0.55, 0.8);
    const int    floors = std::max(3, static_cast<int>(height / 4.2));
    const int    below  = std::max(1, static_cast<int>(floors * waist / height));
    const int    across = corners == 8 ? 3 : 2;
    for (std::size_t i = 0; i < corners; ++i) {
        const std::size_t j = (i + 1) % corners;
        panelWall(outer[i], outer[j], kPavement, waist, across, below, random);
        panelWall(inner[i], inner[j], waist, height, across, floors - below, random);
    }
    level(outer, waist, Roof);
    level(inner, height, Roof);
    plainWalls(crown, height, height + 3, Slate);
    level(crown, height + 3, Roof);
}

void CityBuilder::house(Random& random, double x0, double z0, double x1, double z1)
{
    const Surface wall   = random.below(2) == 0 ? Brick : Plaster;
    const int     floors = 3 + static_cast<int>(random.below(4));
    const double  height = kPavement + floors * 3.3;
    const Plan    plan   = rectangle(x0, z0, x1, z1);
    for (std::size_t i = 0; i < plan.size(); ++i)
        windowWall(plan[i], plan[(i + 1) % 4], kPavement, height, i % 2 == 0 ? 4 : 3, floors, wall);
    // A parapet: walls up, the roof inside them a little lower.
    const Plan inside = rectangle(x0 + 0.4, z0 + 0.4, x1 - 0.4, z1 - 0.4);
    plainWalls(plan, height, height + 0.9, wall);
    for (std::size_t i = 0; i < 4; ++i) {
        const Place a = plan[i], b = plan[(i + 1) % 4], c = inside[(i + 1) % 4], d = inside[i];
        quad(vertex(a.x, height + 0.9, a.z), vertex(b.x, height + 0.9, b.z), vertex(c.x, height + 0.9, c.z),
             vertex(d.x, height + 0.9, d.z), Pavement);
        quad(vertex(d.x, height + 0.9, d.z), vertex(c.x, height + 0.9, c.z), vertex(c.x, height + 0.2, c.z),
             vertex(d.x, height + 0.2, d.z), wall);
    }
    level(inside, height + 0.2, Roof);
}

/// An L-shaped building under one flat roof of six corners.
void CityBuilder::hall(Random& random, double x0, double z0, double x1, double z1)
{
    const Surface wall   = random.below(2) == 0 ? Slate : Brick;
    const double  xm     = x0 + (x1 - x0) * random.between(0.4, 0.6);
    const double  zm     = z0 + (z1 - z0) * random.between(0.4, 0.6);
    const int     floors = 4 + static_cast<int>(random.below(5));
    const double  height = kPavement + floors * 3.6;
    const Plan    plan{{x0, z0}, {x0, z1}, {xm, z1}, {xm, zm}, {x1, zm}, {x1, z0}};
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const Place a = plan[i], b = plan[(i + 1) % plan.size()];
        windowWall(a, b, kPavement, height, i < 2 || i == 5 ? 4 : 2, floors, wall);
    }
    level(plan, height, Roof);
}

/// A house with two gables of five corners each, under a ridge.
void CityBuilder::gabled(Random& random, double x0, double z0, double x1, double z1)
{
    const Surface wall   = random.below(3) == 0 ? Brick : Plaster;
    const int     floors = 2 + static_cast<int>(random.below(3));
    const double  eaves  = kPavement + floors * 3.2;
    const double  zm     = 0.5 * (z0 + z1);
    const double  ridge  = eaves + 0.38 * (z1 - z0);
    windowWall({x0, z1}, {x1, z1}, kPavement, eaves, 5, floors, wall);
    windowWall({x1, z0}, {x0, z0}, kPavement, eaves, 5, floors, wall);
    for (const auto& [x, a, b] : {std::array{x1, z1, z0}, std::array{x0, z0, z1}})
        face(std::array{vertex(x, kPavement, a), vertex(x, kPavement, b), vertex(x, eaves, b), vertex(x, ridge, zm),
                        vertex(x, eaves, a)},
             wall);
    quad(vertex(x0, eaves, z1), vertex(x1, eaves, z1), vertex(x1, ridge, zm), vertex(x0, ridge, zm), Tile);
    quad(vertex(x1, eaves, z0), vertex(x0, eaves, z0), vertex(x0, ridge, zm), vertex(x1, ridge, zm), Tile);
}

/// A trunk of six sides under two cones.
void CityBuilder::tree(Random& random, Place at)
{
    const double height = random.between(4, 8);
    const auto   ring   = [&](double radius, double y) {
        std::array<std::uint32_t, 6> corners;
        for (std::size_t i = 0; i < 6; ++i) {
            const auto [c, s] = pointOnCircle(static_cast<double>(i) / 6);
            corners[i]        = vertex(at.x + radius * c, y, at.z - radius * s);
        }
        return corners;
    };
    const auto foot = ring(0.25, kPavement), neck = ring(0.2, kPavement + height * 0.35);
    for (std::size_t i = 0; i < 6; ++i) quad(foot[i], foot[(i + 1) % 6], neck[(i + 1) % 6], neck[i], Bark);
    for (const auto& [low, high, radius] : {std::array{0.25, 0.75, 0.28}, std::array{0.55, 1.0, 0.20}}) {
        const auto          skirt = ring(radius * height, kPavement + height * low);
        const std::uint32_t tip   = vertex(at.x, kPavement + height * high, at.z);
        for (std::size_t i = 0; i < 6; ++i) face(std::array{skirt[i], skirt[(i + 1) % 6], tip}, Leaf);
        face(std::array{skirt[5], skirt[4], skirt[3], skirt[2], skirt[1], skirt[0]}, Leaf);
    }
}

void CityBuilder::park(Random& random, double x0, double z0, double x1, double z1)
{
    flat(x0, z0, x1, z1, kPavement + 0.02, Grass);
    const double xm = 0.5 * (x0 + x1), zm = 0.5 * (z0 + z1);
    flat(x0, zm - 1.2, x1, zm + 1.2, kPavement + 0.04, Sand);
    flat(xm - 1.2, z0, xm + 1.2, z1, kPavement + 0.06, Sand);
    for (int i = 0; i < 60; ++i) {
        const double x = random.between(x0 + 2, x1 - 2);
        const double z = random.between(z0 + 2, z1 - 2);
        if (std::abs(x - xm) > 3 && std::abs(z - zm) > 3) tree(random, {x, z});
    }
}

void CityBuilder::ground()
{
    const double x = -west() + kStreet, z = -north() + kStreet;
    flat(-x, -z, x, z, 0, Asphalt);
    for (int line = 0; line + 1 < m_blocks; ++line) {  // dashes in the middle of every street
        const double alongX = west() + (line + 1) * (kBlockX + kStreet) - kStreet / 2;
        const double alongZ = north() + (line + 1) * (kBlockZ + kStreet) - kStreet / 2;
        for (double s = north(); s < -north(); s += 8) flat(alongX - 0.12, s, alongX + 0.12, s + 3, 0.02, Marking);
        for (double s = west(); s < -west(); s += 8) flat(s, alongZ - 0.12, s + 3, alongZ + 0.12, 0.02, Marking);
    }
}

void CityBuilder::block(int column, int row)
{
    const auto place = static_cast<std::uint64_t>(row) * 1'000'003u + static_cast<std::uint64_t>(column);
    Random     random(m_seed * 0x2545'F491'4F6C'DD1Dull + place);
    m_mesh.groups.push_back("block " + std::to_string(column) + " " + std::to_string(row));
    m_group = GroupId{static_cast<std::uint32_t>(m_mesh.groups.size() - 1)};

    const double x0 = west() + column * (kBlockX + kStreet), z0 = north() + row * (kBlockZ + kStreet);
    const Plan   kerb = rectangle(x0, z0, x0 + kBlockX, z0 + kBlockZ);
    plainWalls(kerb, 0, kPavement, Pavement);
    level(kerb, kPavement, Pavement);
    if (random.below(9) == 0) {
        park(random, x0 + 2, z0 + 2, x0 + kBlockX - 2, z0 + kBlockZ - 2);
        return;
    }
    constexpr double kLotX = (kBlockX - 6) / kLotsX, kLotZ = (kBlockZ - 6) / kLotsZ;
    for (int i = 0; i < kLotsX; ++i)
        for (int j = 0; j < kLotsZ; ++j) {
            const double gap = random.between(0.6, 2.2);
            const double a = x0 + 3 + i * kLotX + gap, b = a + kLotX - 2 * gap;
            const double c = z0 + 3 + j * kLotZ + gap, d = c + kLotZ - 2 * gap;
            switch (random.below(6)) {
                case 0:
                case 1:
                    tower(random, {0.5 * (a + b), 0.5 * (c + d)}, 0.5 * std::min(b - a, d - c));
                    break;
                case 2:
                case 3:
                    house(random, a, c, b, d);
                    break;
                case 4:
                    hall(random, a, c, b, d);
                    break;
                default:
                    gabled(random, a, c, b, d);
            }
        }
}

Result<Scene> make(const Arguments& arguments)
{
    const int    blocks = static_cast<int>(arguments.whole("blocks"));
    const double all    = static_cast<double>(blocks) * blocks * kTrianglesPerBlock;
    const double bytes  = meshBytes(all, 0.55 * all, 2 * all, all);
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("a city of so many blocks", bytes, arguments.memoryLimit);

    auto city       = std::make_shared<Mesh>();
    city->name      = "city";
    city->materials = surfaces();
    CityBuilder builder(*city, static_cast<std::uint64_t>(arguments.whole("seed")), blocks);
    builder.ground();
    for (int row = 0; row < blocks; ++row) {
        for (int column = 0; column < blocks; ++column) builder.block(column, row);
        arguments.progress.at((row + 1.0) / blocks, "blocks");
        if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the city was not wanted any more"};
    }

    Scene scene;
    scene.meshes.push_back(city);
    scene.instances.push_back({MeshId{0}, Affine{}});
    const double reach = 0.34 * blocks * (kBlockX + kStreet) + 60;
    ViewRequest  above;  // 45 degrees down
    above.eye         = dvec3{0.35 * reach, 0.9 * reach, 1.0 * reach};
    above.target      = dvec3{0.35 * reach * 0.1, 0, 0.1 * reach};
    above.verticalFov = 40;
    above.near        = 1;
    above.far         = 20 * reach;
    scene.views.push_back({"above", above});
    // A pedestrian in the middle of the street right of the middle block, looking north.
    const double street = builder.west() + (blocks / 2) * (kBlockX + kStreet) - kStreet / 2;
    ViewRequest  walk;
    walk.eye         = dvec3{street - 4.5, 2.0, std::min(-builder.north(), 0.25 * reach + 30)};
    walk.target      = dvec3{street + 3, 9.0, walk.eye->z - 90};
    walk.verticalFov = 60;
    walk.near        = 0.1;
    walk.far         = 20 * reach;
    scene.views.push_back({"street", walk});
    return scene;
}

}  // namespace

std::vector<Generator> city()
{
    return {{"city",
             "Streets, towers, houses and parks",
             {{"blocks", WholeNumber{10, 1, 200}}, {"seed", WholeNumber{1, 0, 1'000'000'000}}},
             make}};
}

}  // namespace zscope::generated
