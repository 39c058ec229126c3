#include "core/check/truth.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/check/exact_triangle.h"
#include "core/measure/reference.h"
#include "core/scene/triangulate.h"

namespace zscope::check {

FaceNumbers::FaceNumbers(const Scene& scene) : m_scene(&scene), m_first{0}
{
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
        m_first.push_back(m_first.back() + static_cast<std::int64_t>(scene.meshOf(InstanceId{i}).polygonCount()));
}

std::int64_t FaceNumbers::faceOf(std::int64_t triangle) const
{
    const TriangleId id{static_cast<std::uint32_t>(triangle)};
    const InstanceId instance = m_scene->instanceOf(id);
    const auto       local    = id.value - m_scene->firstTriangle[instance.value];
    return m_first[instance.value] + m_scene->meshOf(instance).trianglePolygon[local].value;
}

FaceNumbers::Place FaceNumbers::placeOf(std::int64_t face) const
{
    const auto after    = std::upper_bound(m_first.begin(), m_first.end(), face);
    const auto instance = static_cast<std::uint32_t>(after - m_first.begin() - 1);
    return {InstanceId{instance}, PolygonId{static_cast<std::uint32_t>(face - m_first[instance])}};
}

std::pair<std::int64_t, std::int64_t> FaceNumbers::trianglesOf(std::int64_t face) const
{
    const auto [instance, polygon] = placeOf(face);
    const Mesh&        mesh        = m_scene->meshOf(instance);
    const std::int64_t start       = m_scene->firstTriangle[instance.value];
    return {start + mesh.firstTriangle[polygon.value], start + mesh.firstTriangle[polygon.value + 1]};
}

std::size_t FaceNumbers::cornersOf(std::int64_t face) const
{
    const auto [instance, polygon] = placeOf(face);
    return m_scene->meshOf(instance).polygon(polygon).size();
}

bool FaceNumbers::mayBeCutOtherwise(std::int64_t face) const
{
    const auto [instance, polygon] = placeOf(face);
    const Mesh& mesh               = m_scene->meshOf(instance);
    const auto  outline            = mesh.polygon(polygon);
    if (outline.size() <= 3) return false;
    if (mesh.isMended(polygon)) return true;
    PolygonSplitter                        splitter;
    std::vector<PolygonSplitter::Triangle> triangles;
    return splitter.split(mesh.positions, outline, triangles) != PolygonSplit::Fan;
}

std::pair<std::int64_t, std::int64_t> FaceNumbers::surfaceOf(std::int64_t triangle) const
{
    const std::int64_t face = faceOf(triangle);
    return mayBeCutOtherwise(face) ? trianglesOf(face) : std::pair(triangle, triangle + 1);
}

bool FaceNumbers::areOneSurface(std::int64_t triangle, std::int64_t other) const
{
    if (triangle == other) return true;
    const std::int64_t face = faceOf(triangle);
    return face == faceOf(other) && mayBeCutOtherwise(face);
}

double halfStepOf(int subpixelBits) { return std::ldexp(1.0, -1 - std::min(subpixelBits, 8)); }

Result<std::shared_ptr<const Truth>> truthOf(const std::shared_ptr<const PreparedScene>& scene, const Camera& camera,
                                             FaceCulling culling, int subpixelBits, const Progress& progress)
try {
    Result<Picture> picture = referencePicture(scene->scene(), camera, culling, progress);
    if (!picture) return picture.error();
    const double halfStep = halfStepOf(subpixelBits);
    Truth        truth{scene, FaceNumbers(scene->scene()), camera, culling, halfStep, *std::move(picture), {}, 0};
    truth.slack.reset(camera.width, camera.height);
    std::uint64_t covered = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : covered)
    for (int y = 0; y < camera.height; ++y) {
        std::int64_t                 last = -1;
        std::optional<ExactTriangle> triangle;
        for (int x = 0; x < camera.width; ++x) {
            const std::int64_t id = truth.picture.ids.at(x, y);
            if (id < 0) continue;
            ++covered;
            if (id != last)
                triangle.emplace(scene->scene(), camera, TriangleId{static_cast<std::uint32_t>(id)}, halfStep);
            last                 = id;
            truth.slack.at(x, y) = static_cast<float>(triangle->depthOf(x, y).slack);
        }
    }
    truth.covered = covered;
    return std::make_shared<const Truth>(std::move(truth));
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "the reference picture does not fit into memory"};
}

}  // namespace zscope::check
