// builtin:office-tower: one furnished office, n x n x n times, wall to wall and floor on floor.
//
// Module     8 x 3.5 x 8 metres, about 15,000 triangles: floor slab, two walls with a doorway each (the neighbours'
//            walls close the other sides), six desks with keyboards key by key, chairs, four shelves of books, lamps
// Memory     one mesh of 3 MiB and 132 bytes per module: 5 MiB of instances for 33^3, 538 million triangles
// Promise    a module closes its floor, so that no storey sees another

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/random.h"
#include "core/scene/generators/registry.h"

namespace zscope::generated {

namespace {

constexpr double kSide = 8, kStorey = 3.5;  // metres
constexpr double kWall = 0.2, kSlab = 0.3;

enum Surface : std::uint32_t { Concrete, Wall, Wood, Steel, Fabric, Screen, Key, Lamp, Book };

std::vector<Material> surfaces()
{
    std::vector<Material> list{{"concrete", {0.40f, 0.39f, 0.38f}}, {"wall", {0.78f, 0.76f, 0.70f}},
                               {"wood", {0.46f, 0.30f, 0.17f}},     {"steel", {0.45f, 0.47f, 0.50f}},
                               {"fabric", {0.14f, 0.22f, 0.36f}},   {"screen", {0.05f, 0.06f, 0.08f}},
                               {"key", {0.62f, 0.62f, 0.60f}},      {"lamp", {0.86f, 0.85f, 0.78f}}};
    for (const Rgb& colour : palette::kDistinct) list.push_back({"book " + std::to_string(list.size() - Book), colour});
    return list;
}

class OfficeBuilder {
public:
    explicit OfficeBuilder(Mesh& mesh) : m_mesh(mesh) {}

    void shell();
    void desk(double x, double z, double turned);
    void shelf(double x, double z, double facing, Random& random);
    void lamps();

private:
    /// A box; faces turn counter-clockwise when seen from outside.
    void box(const dvec3& low, const dvec3& high, std::uint32_t surface)
    {
        const auto first = static_cast<std::uint32_t>(m_mesh.positions.size());
        for (int i = 0; i < 8; ++i)
            m_mesh.positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
            {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
        for (const auto& f : kFaces)
            m_mesh.addPolygon(std::array{first + f[0], first + f[1], first + f[2], first + f[3]}, MaterialId{surface});
    }
    /// The same about a middle on the floor; `turned` is +1 or -1 and mirrors x and z by turning half round.
    void part(const dvec3& origin, double turned, const dvec3& a, const dvec3& b, std::uint32_t surface)
    {
        const dvec3 p{origin.x + turned * a.x, origin.y + a.y, origin.z + turned * a.z};
        const dvec3 q{origin.x + turned * b.x, origin.y + b.y, origin.z + turned * b.z};
        box({std::min(p.x, q.x), p.y, std::min(p.z, q.z)}, {std::max(p.x, q.x), q.y, std::max(p.z, q.z)}, surface);
    }
    /// An upright prism of `sides` sides with both ends.
    void post(const dvec3& foot, double radius, double height, std::uint32_t sides, std::uint32_t surface)
    {
        const auto                 first = static_cast<std::uint32_t>(m_mesh.positions.size());
        std::vector<std::uint32_t> low, high;
        for (std::uint32_t i = 0; i < sides; ++i) {
            const auto [c, s] = pointOnCircle(static_cast<double>(i) / sides);
            m_mesh.positions.push_back({foot.x + radius * c, foot.y, foot.z - radius * s});
            m_mesh.positions.push_back({foot.x + radius * c, foot.y + height, foot.z - radius * s});
            low.insert(low.begin(), first + 2 * i);
            high.push_back(first + 2 * i + 1);
        }
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t j = (i + 1) % sides;
            m_mesh.addPolygon(std::array{first + 2 * i, first + 2 * j, first + 2 * j + 1, first + 2 * i + 1},
                              MaterialId{surface});
        }
        m_mesh.addPolygon(low, MaterialId{surface});
        m_mesh.addPolygon(high, MaterialId{surface});
    }

    Mesh& m_mesh;
};

void OfficeBuilder::shell()
{
    constexpr double kDoorFrom = 5.6, kDoorTo = 6.6, kDoorTop = kSlab + 2.1;
    box({0, 0, 0}, {kSide, kSlab, kSide}, Concrete);
    box({0, kSlab, 0}, {kDoorFrom, kStorey, kWall}, Wall);  // the wall at z = 0
    box({kDoorTo, kSlab, 0}, {kSide, kStorey, kWall}, Wall);
    box({kDoorFrom, kDoorTop, 0}, {kDoorTo, kStorey, kWall}, Wall);
    box({0, kSlab, kWall}, {kWall, kStorey, kDoorFrom}, Wall);  // the wall at x = 0
    box({0, kSlab, kDoorTo}, {kWall, kStorey, kSide}, Wall);
    box({0, kDoorTop, kDoorFrom}, {kWall, kStorey, kDoorTo}, Wall);
}

void OfficeBuilder::desk(double x, double z, double turned)
{
    const dvec3 at{x, kSlab, z};
    const auto  add = [&](const dvec3& a, const dvec3& b, std::uint32_t surface) { part(at, turned, a, b, surface); };
    add({-0.8, 0.70, -0.4}, {0.8, 0.74, 0.4}, Wood);
    for (const double leg : {-0.76, 0.72})
        for (const double side : {-0.38, 0.34}) add({leg, 0, side}, {leg + 0.04, 0.70, side + 0.04}, Steel);
    for (int drawer = 0; drawer < 3; ++drawer)
        add({0.3, 0.1 + 0.2 * drawer, -0.3}, {0.7, 0.28 + 0.2 * drawer, 0.36}, Wood);
    add({-0.35, 0.84, -0.25}, {0.35, 1.24, -0.22}, Screen);
    add({-0.05, 0.74, -0.26}, {0.05, 0.9, -0.24}, Steel);
    add({-0.15, 0.74, -0.3}, {0.15, 0.76, -0.1}, Steel);
    add({-0.24, 0.74, 0.08}, {0.24, 0.755, 0.26}, Steel);
    for (int row = 0; row < 6; ++row)
        for (int key = 0; key < 14; ++key) {
            const double kx = -0.23 + 0.033 * key, kz = 0.085 + 0.028 * row;
            add({kx, 0.755, kz}, {kx + 0.028, 0.765, kz + 0.023}, Key);
        }
    post({x + turned * 0.5, kSlab + 0.74, z + turned * 0.1}, 0.04, 0.1, 16, Lamp);  // a mug

    const double chairZ = z + turned * 0.75;
    add({-0.25, 0.44, 0.5}, {0.25, 0.5, 1.0}, Fabric);
    add({-0.25, 0.55, 0.97}, {0.25, 1.05, 1.02}, Fabric);
    add({-0.03, 0.5, 0.99}, {0.03, 0.6, 1.01}, Steel);
    post({x, kSlab + 0.08, chairZ}, 0.03, 0.36, 12, Steel);
    add({-0.28, 0.04, 0.73}, {0.28, 0.08, 0.77}, Steel);
    add({-0.02, 0.04, 0.47}, {0.02, 0.08, 1.03}, Steel);
}

/// Two metres of shelves against a wall; `facing` is +1 towards larger x.
void OfficeBuilder::shelf(double x, double z, double facing, Random& random)
{
    constexpr int kBoards = 6, kBooks = 20;
    const dvec3   at{x, kSlab, z};
    const auto    add = [&](const dvec3& a, const dvec3& b, std::uint32_t surface) { part(at, facing, a, b, surface); };
    add({0, 0, 0}, {0.02, 2.2, 1.2}, Wood);
    add({0.02, 0, 0}, {0.32, 2.2, 0.02}, Wood);
    add({0.02, 0, 1.18}, {0.32, 2.2, 1.2}, Wood);
    for (int board = 0; board < kBoards; ++board) {
        const double y = 0.05 + 0.36 * board;
        add({0.02, y, 0.02}, {0.32, y + 0.02, 1.18}, Wood);
        double from = 0.03;
        for (int book = 0; book < kBooks; ++book) {
            const double thick = random.between(0.02, 0.05), high = random.between(0.2, 0.32),
                         deep = random.between(0.15, 0.27);
            const auto cover  = Book + static_cast<std::uint32_t>(random.below(palette::kDistinct.size()));
            add({0.02, y + 0.02, from}, {0.02 + deep, y + 0.02 + high, from + thick}, cover);
            from += thick + 0.002;
        }
    }
}

void OfficeBuilder::lamps()
{
    for (const double x : {2.2, 5.8})
        for (const double z : {2.2, 5.8}) {
            box({x - 0.6, kStorey - 0.12, z - 0.3}, {x + 0.6, kStorey - 0.06, z - 0.28}, Steel);
            box({x - 0.6, kStorey - 0.12, z + 0.28}, {x + 0.6, kStorey - 0.06, z + 0.3}, Steel);
            for (int slat = 0; slat < 14; ++slat) {
                const double sx = x - 0.6 + 0.085 * slat;
                box({sx, kStorey - 0.12, z - 0.28}, {sx + 0.01, kStorey - 0.06, z + 0.28}, Steel);
            }
            box({x - 0.6, kStorey - 0.06, z - 0.3}, {x + 0.6, kStorey - 0.04, z + 0.3}, Lamp);
        }
}

std::shared_ptr<const Mesh> office()
{
    auto mesh       = std::make_shared<Mesh>();
    mesh->name      = "office";
    mesh->materials = surfaces();
    OfficeBuilder builder(*mesh);
    Random        random(1);
    builder.shell();
    for (const double x : {1.9, 4.0, 6.1}) {
        builder.desk(x, 3.2, 1);
        builder.desk(x, 2.3, -1);
    }
    for (const double z : {0.6, 1.9, 3.2}) builder.shelf(kWall, z, 1, random);
    builder.shelf(kSide, 5.0, -1, random);
    builder.lamps();
    return mesh;
}

Result<Scene> make(const Arguments& arguments)
{
    const std::int64_t n     = arguments.whole("n");
    const double       count = static_cast<double>(n * n * n);
    const double       bytes = count * (sizeof(Instance) + sizeof(std::uint32_t)) + (4 << 20);
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("so many offices", bytes, arguments.memoryLimit);

    Scene scene;
    scene.meshes = {office()};
    scene.instances.reserve(static_cast<std::size_t>(n * n * n));
    const double west = -0.5 * kSide * static_cast<double>(n);
    for (std::int64_t storey = 0; storey < n; ++storey) {
        for (std::int64_t row = 0; row < n; ++row)
            for (std::int64_t column = 0; column < n; ++column)
                scene.instances.push_back({MeshId{0}, Affine::translation({west + kSide * static_cast<double>(column),
                                                                           kStorey * static_cast<double>(storey),
                                                                           west + kSide * static_cast<double>(row)})});
        if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the tower was not wanted any more"};
    }

    // In the middle of the southern front, at a desk of the middle storey, looking north-west into the tower.
    const double storey = kStorey * static_cast<double>(n / 2), reach = kSide * static_cast<double>(n);
    const dvec3  room{west + kSide * static_cast<double>(n / 2), storey, west + kSide * static_cast<double>(n - 1)};
    ViewRequest  inside;
    inside.eye         = room + dvec3{7.2, kSlab + 1.65, 7.2};
    inside.target      = room + dvec3{3.0, kSlab + 1.1, 1.0};
    inside.verticalFov = 60;
    inside.near        = 0.05;
    inside.far         = 4 * reach;
    scene.views.push_back({"default", inside});
    ViewRequest outside;
    outside.eye    = dvec3{0.9 * reach, 0.5 * kStorey * static_cast<double>(n), 1.3 * reach};
    outside.target = dvec3{0, 0.5 * kStorey * static_cast<double>(n), 0};
    outside.near   = 1;
    outside.far    = 8 * reach;
    scene.views.push_back({"outside", outside});
    return scene;
}

}  // namespace

std::vector<Generator> office_tower()
{
    return {
        {"office-tower", "One office, n x n x n times: 538 million triangles", {{"n", WholeNumber{33, 1, 65}}}, make}};
}

}  // namespace zscope::generated
