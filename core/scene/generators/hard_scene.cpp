#include "core/scene/generators/hard_scene.h"

#include "core/scene/generators/palette.h"

namespace zscope::hard {

Camera pixelCamera(int width, int height, double near, double far)
{
    Camera camera;
    camera.focal  = 2.0 / height;  // half the picture's height is seen at half the height at z = 1
    camera.near   = near;
    camera.far    = far;
    camera.width  = width;
    camera.height = height;
    return camera;
}

HardScene::HardScene(const Camera& exact) : camera(exact), m_mesh(std::make_shared<Mesh>())
{
    m_mesh->name = "hard case";
    m_mesh->materials.clear();
    for (const Rgb& colour : palette::kDistinct)
        m_mesh->materials.push_back({"colour " + std::to_string(m_mesh->materials.size()), colour});
}

Vertex HardScene::at(const Place& place, double depth)
{
    const double z = camera.near / depth;
    return inView({(place.x - camera.width * 0.5) * z, (camera.height * 0.5 - place.y) * z, z});
}

Vertex HardScene::inWorld(const dvec3& position)
{
    m_mesh->positions.push_back(position);
    return static_cast<Vertex>(m_mesh->positions.size() - 1);
}

bool HardScene::polygon(std::span<const Vertex> outline)
{
    const auto face   = m_mesh->polygonCount();
    const auto colour = static_cast<std::uint32_t>(face % m_mesh->materials.size());
    if (m_mesh->addPolygon(outline, MaterialId{colour})) return true;
    m_warnings.push_back({{},
                          0,
                          "face " + std::to_string(face)
                              + " has no area or crosses itself; its triangles are a fan from its first corner"});
    return false;
}

bool HardScene::polygon(std::span<const Place> outline, double depth)
{
    std::vector<Vertex> corners;
    for (const Place& place : outline) corners.push_back(at(place, depth));
    return polygon(corners);
}

void HardScene::triangle(Vertex a, Vertex b, Vertex c) { polygon(std::array{a, b, c}); }

void HardScene::triangle(const Place& a, const Place& b, const Place& c, double depth)
{
    const Vertex first = at(a, depth), second = at(b, depth), third = at(c, depth);
    triangle(first, second, third);
}

void HardScene::quad(Vertex a, Vertex b, Vertex c, Vertex d)
{
    triangle(a, b, c);
    triangle(a, c, d);
}

void HardScene::quad(const std::array<Place, 4>& corners, double depth)
{
    const Vertex a = at(corners[0], depth), b = at(corners[1], depth);
    const Vertex c = at(corners[2], depth), d = at(corners[3], depth);
    quad(a, b, c, d);
}

void HardScene::rectangle(const Place& topLeft, const Place& bottomRight, double depth)
{
    quad({topLeft, Place{topLeft.x, bottomRight.y}, bottomRight, Place{bottomRight.x, topLeft.y}}, depth);
}

Scene HardScene::finish()
{
    ViewRequest view;
    view.exact = camera;
    return finish(view);
}

Scene HardScene::finish(const ViewRequest& view)
{
    Scene scene;
    scene.meshes.push_back(std::move(m_mesh));
    scene.instances.push_back({MeshId{0}, Affine{}});
    scene.views.push_back({"default", view});
    scene.warnings = std::move(m_warnings);
    return scene;
}

}  // namespace zscope::hard
