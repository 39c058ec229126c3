// Scenes that a wall hides: builtin:wall-and-city, a city behind a garden wall, seen past its end in a narrow strip;
// builtin:hole-in-wall, balls behind a wall with a square hole of one cell of the pyramid.
//
// Exact      the hole of level L is a square of 2^L pixels of the default view, its sides on borders of cells of that
//            level and all below

#include <array>

#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"
#include "core/scene/generators/soccer_ball.h"

namespace zscope::generated {

namespace {

/// A wall with pillars and a coping, its front at z, `depth` thick, on a meadow that reaches back to `meadow`.
std::shared_ptr<const Mesh> gardenWall(double x0, double x1, double height, double z, double depth, double meadow)
{
    auto wall       = std::make_shared<Mesh>();
    wall->name      = "wall";
    wall->materials = {
        {"brick", {0.50f, 0.22f, 0.14f}}, {"coping", {0.42f, 0.40f, 0.37f}}, {"grass", {0.18f, 0.36f, 0.15f}}};
    const auto block = [&wall](const dvec3& low, const dvec3& high, std::uint32_t material) {
        const auto first = static_cast<std::uint32_t>(wall->positions.size());
        for (int i = 0; i < 8; ++i)
            wall->positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
            {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
        for (const auto& face : kFaces)
            wall->addPolygon(std::array{first + face[0], first + face[1], first + face[2], first + face[3]},
                             MaterialId{material});
    };
    for (const auto& [x, end] : {std::pair{-400.0, meadow}, {-400.0, z + 60}, {400.0, z + 60}, {400.0, meadow}})
        wall->positions.push_back({x, 0, end});
    wall->addPolygon(std::array{0u, 1u, 2u, 3u}, MaterialId{2});
    block({x0, 0, z - depth}, {x1, height, z}, 0);
    block({x0 - 0.1, height, z - depth - 0.1}, {x1 + 0.1, height + 0.25, z + 0.1}, 1);
    constexpr double kBay = 4;  // metres between two pillars
    for (double x = x1; x > x0; x -= kBay) block({x - 0.5, 0, z}, {x, height, z + 0.15}, 0);
    return wall;
}

Result<Scene> makeWallAndCity(const Arguments& arguments)
{
    const std::string word =
        "city?blocks=" + std::to_string(arguments.whole("blocks")) + "&seed=" + std::to_string(arguments.whole("seed"));
    const Result<Scene> city = generate(word, arguments.memoryLimit, arguments.progress);
    if (!city) return city.error();

    // The eye stands south of the city, twelve metres before the wall, which ends right of the middle.
    const double south = city->bounds.max.z;
    Scene        scene;
    scene.meshes = {gardenWall(-80, 7.5, 14, south + 20, 0.5, south), city->meshes[0]};
    scene.instances.push_back({MeshId{1}, Affine{}});
    scene.instances.push_back({MeshId{0}, Affine{}});  // last in the file: the order as submitted does not help
    ViewRequest view;
    view.eye    = dvec3{0, 2, south + 32};
    view.target = dvec3{0, 2.4, south};
    view.near   = 0.1;
    view.far    = 5000;
    scene.views.push_back({"default", view});
    ViewRequest above = view;
    above.eye         = dvec3{60, 90, south + 150};
    above.target      = dvec3{0, 0, 0};
    scene.views.push_back({"above", above});
    return scene;
}

Result<Scene> makeHoleInWall(const Arguments& arguments)
{
    // One unit is one pixel at distance 256 of a picture 512 pixels high: corners of the wall are seen exactly where
    // they are put, and the middle of the picture is a border of cells of every level up to 8.
    constexpr double kWall = 256, kHalf = 256;
    const double     side = static_cast<double>(std::int64_t{1} << arguments.whole("level"));

    auto wall        = std::make_shared<Mesh>();
    wall->name       = "wall with a hole";
    wall->materials  = {{"plaster", palette::kGrey}};
    const auto piece = [&wall](double x0, double y0, double x1, double y1) {
        if (x0 >= x1 || y0 >= y1) return;
        const auto first = static_cast<std::uint32_t>(wall->positions.size());
        for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
            wall->positions.push_back({x, y, -kWall});
        wall->addPolygon(std::array{first, first + 1, first + 2, first + 3});
    };
    // The hole is right of and below the middle of the picture; y is up.
    piece(-kHalf, -kHalf, 0, kHalf);
    piece(0, 0, kHalf, kHalf);
    piece(side, -side, kHalf, 0);
    piece(0, -kHalf, kHalf, -side);

    Scene scene;
    scene.meshes         = {makeSoccerBall(), wall};
    std::uint64_t number = 0;
    for (int layer = 2; layer >= 0; --layer)
        for (int row = -2; row <= 2; ++row)
            for (int column = -2; column <= 2; ++column) {
                Affine       toWorld;
                const double distance = 340 + 90.0 * layer, radius = 44, step = 100 + 30.0 * layer;
                for (std::size_t k = 0; k < 3; ++k) toWorld.rows[k][k] = radius;
                toWorld.rows[0][3] = step * column, toWorld.rows[1][3] = step * row, toWorld.rows[2][3] = -distance;
                scene.instances.push_back({MeshId{0}, toWorld, palette::colourOf(number++)});
            }
    scene.instances.push_back({MeshId{1}, Affine{}});

    Camera camera;
    camera.focal  = 1;
    camera.near   = 1;
    camera.far    = 1e4;
    camera.width  = 512;
    camera.height = 512;
    ViewRequest view;
    view.exact = camera;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> walls()
{
    return {{"wall-and-city",
             "A city behind a wall that ends just inside the picture",
             {{"blocks", WholeNumber{10, 1, 200}}, {"seed", WholeNumber{1, 0, 1'000'000'000}}},
             makeWallAndCity},
            {"hole-in-wall",
             "Balls behind a wall with a square hole of 2^level pixels",
             {{"level", WholeNumber{3, 0, 8}}},
             makeHoleInWall}};
}

}  // namespace zscope::generated
