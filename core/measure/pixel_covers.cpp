#include "core/measure/pixel_covers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "core/measure/reference_walk.h"

namespace zscope {

using namespace definition;

namespace {

bool coversWithHoles(const Part& part, int i, int j)
{
    return std::ranges::all_of(part.sides(), [&](const Side& side) { return side.at(i, j) >= 0; });
}

/// What one part is to a pixel that lies in its box.
std::optional<Cover> coverOf(const Part& part, PixelPosition p, float depth, bool isTransparent, const View& view,
                             FaceCulling culling)
{
    if (!coversWithHoles(part, p.x, p.y)) return std::nullopt;
    if (culling == FaceCulling::Back && part.isBack()) return Cover::BackFace;
    if (part.isHole(p.x, p.y)) return Cover::Hole;
    if (depth < view.farDepth) return Cover::BeyondFar;
    return isTransparent ? Cover::Transparent : Cover::Opaque;
}

/// Rays through pixel centres against what the near plane cuts away.
class BeforeNear {
public:
    BeforeNear(const Scene& scene, const Camera& camera) : m_scene(scene), m_camera(camera) {}

    /// Whether anything of the box may lie between the eye and the near plane.
    bool mayHold(const Bounds& box, const Affine& toWorld) const
    {
        if (box.isEmpty()) return false;
        double lo = HUGE_VAL, hi = -HUGE_VAL;
        for (int i = 0; i < 8; ++i) {
            const dvec3  q{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
            const double z = viewOf(toWorld(q)).z;
            lo = std::min(lo, z), hi = std::max(hi, z);
        }
        return lo < m_camera.near && hi > 0;
    }

    std::array<dvec3, 3> cornersOf(InstanceId instance, std::uint32_t meshTriangle) const
    {
        const Mesh&          mesh = m_scene.meshOf(instance);
        std::array<dvec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] =
                viewOf(m_scene.instances[instance.value].toWorld(mesh.positions[mesh.triangles[meshTriangle][i]]));
        return corners;
    }

    /// near/z where the ray through the pixel's centre meets the triangle, if that lies before the near plane.
    std::optional<float> meets(const std::array<dvec3, 3>& corners, PixelPosition p) const
    {
        if (std::ranges::all_of(corners, [](const dvec3& v) { return v.z <= 0; })) return std::nullopt;
        const dvec3  ray{(p.x + 0.5) - m_camera.width * 0.5, m_camera.height * 0.5 - (p.y + 0.5),
                        m_camera.height * 0.5 * m_camera.focal};
        const dvec3  e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
        const dvec3  h   = glm::cross(ray, e2);
        const double det = glm::dot(e1, h);
        if (det == 0) return std::nullopt;
        const double u = -glm::dot(corners[0], h) / det;
        const dvec3  q = glm::cross(-corners[0], e1);
        const double v = glm::dot(ray, q) / det, t = glm::dot(e2, q) / det;
        if (!(u >= 0 && v >= 0 && u + v <= 1 && t > 0)) return std::nullopt;
        const double z = t * ray.z;
        if (!(z < m_camera.near)) return std::nullopt;
        return static_cast<float>(m_camera.near / z);
    }

private:
    dvec3 viewOf(const dvec3& world) const
    {
        const dvec3 d = world - m_camera.eye;
        return {glm::dot(m_camera.right, d), glm::dot(m_camera.up, d), glm::dot(m_camera.forward, d)};
    }

    const Scene&  m_scene;
    const Camera& m_camera;
};

/// The near plane may have cut something away.
bool mayBeCut(Fate fate, const std::vector<Part>& parts)
{
    if (fate == Fate::BehindNear) return true;
    return std::ranges::any_of(parts, [](const Part& part) {
        return std::ranges::any_of(part.corners(), [](const Corner& corner) { return corner.depth == 1; });
    });
}

/// Fills `parts` for a transparent triangle too; tells what it is. One that leaves nothing counts as without area
/// unless it lies behind the near plane.
struct Geometry {
    Fate fate;
    bool isTransparent;
};
Geometry geometryOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle, const View& view, Fate fate,
                    std::vector<Part>& parts)
{
    if (fate != Fate::Transparent) return {fate, false};
    transparentPartsOf(scene, instance, meshTriangle, view, parts);
    if (!parts.empty()) return {Fate::Drawn, true};
    const auto corners = BeforeNear(scene, view.camera).cornersOf(instance, meshTriangle);
    const bool isSeen  = std::ranges::any_of(corners, [&](const dvec3& v) { return v.z >= view.camera.near; });
    return {isSeen ? Fate::Degenerate : Fate::BehindNear, true};
}

void keepBest(std::vector<PixelCover>& covers)
{
    std::ranges::sort(covers, [](const PixelCover& a, const PixelCover& b) {
        if (a.triangle != b.triangle) return a.triangle < b.triangle;
        return a.cover != b.cover ? a.cover < b.cover : a.depth > b.depth;
    });
    const auto sameTriangle = [](const PixelCover& a, const PixelCover& b) { return a.triangle == b.triangle; };
    covers.erase(std::unique(covers.begin(), covers.end(), sameTriangle), covers.end());
}

}  // namespace

std::string_view wordOf(Cover cover)
{
    constexpr std::array<std::string_view, 6> words{"opaque", "transparent", "beyond-far",
                                                    "hole",   "back-face",   "before-near"};
    return words[static_cast<std::size_t>(cover)];
}

Result<std::vector<std::vector<PixelCover>>> coversOf(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                                      std::span<const PixelPosition> points, const Progress& progress)
{
    const View                           view(camera, FaceCulling::None);
    const PointsByRow                    rows(points, camera.height);
    const BeforeNear                     beforeNear(scene, camera);
    std::vector<std::vector<PixelCover>> all(points.size());
    std::vector<Bounds>                  boxes(scene.meshes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const dvec3& p : scene.meshes[i]->positions) boxes[i].include(p);

    const auto reachesAPoint = [&](InstanceId i) {
        const Instance& instance = scene.instances[i.value];
        const Bounds&   box      = boxes[instance.mesh.value];
        return rows.within(reachOf(box, instance.toWorld, view), [](auto) {})
               || beforeNear.mayHold(box, instance.toWorld);
    };
    const auto add = [&all](std::uint32_t point, const PixelCover& cover) {
#pragma omp critical(zscope_pixel_covers)
        all[point].push_back(cover);
    };
    const auto done = forEachTriangle(
        scene, view, progress, reachesAPoint, [&](std::uint32_t id, Fate fate, const std::vector<Part>& opaque) {
            std::vector<Part>   transparent;
            const InstanceId    instance     = scene.instanceOf(TriangleId{id});
            const std::uint32_t meshTriangle = id - scene.firstTriangle[instance.value];
            const Geometry      geometry     = geometryOf(scene, instance, meshTriangle, view, fate, transparent);
            const auto&         parts        = geometry.isTransparent ? transparent : opaque;
            for (const Part& part : parts)
                rows.within(part.box(), [&](std::uint32_t point) {
                    const PixelPosition p     = points[point];
                    const float         depth = part.depth(p.x, p.y);
                    if (const auto cover = coverOf(part, p, depth, geometry.isTransparent, view, faceCulling))
                        add(point, {TriangleId{id}, *cover, depth});
                });
            if (!mayBeCut(geometry.fate, parts)) return;
            const std::array<dvec3, 3> corners = beforeNear.cornersOf(instance, meshTriangle);
            for (std::uint32_t point = 0; point < points.size(); ++point)
                if (const auto depth = beforeNear.meets(corners, points[point]))
                    add(point, {TriangleId{id}, Cover::BeforeNear, *depth});
        });
    if (!done) return done.error();
    for (std::vector<PixelCover>& covers : all) keepBest(covers);
    return all;
}

TriangleCovers coversOf(const Scene& scene, const Camera& camera, FaceCulling faceCulling, TriangleId triangle)
{
    const View          view(camera, FaceCulling::None);
    const InstanceId    instance     = scene.instanceOf(triangle);
    const std::uint32_t meshTriangle = triangle.value - scene.firstTriangle[instance.value];
    std::vector<Part>   parts;
    const Fate          fate     = partsOf(scene, instance, meshTriangle, view, parts);
    const Geometry      geometry = geometryOf(scene, instance, meshTriangle, view, fate, parts);

    TriangleCovers covers;
    covers.isTransparent = geometry.isTransparent;
    covers.parts         = static_cast<int>(parts.size());
    covers.isBehindNear  = geometry.fate == Fate::BehindNear;
    covers.isDegenerate  = geometry.fate == Fate::Degenerate;
    covers.isOutOfRange  = geometry.fate == Fate::OutOfRange;
    std::vector<std::pair<PixelPosition, PixelCover>> found;
    for (const Part& part : parts)
        for (int y = part.box().y0; y <= part.box().y1; ++y)
            for (int x = part.box().x0; x <= part.box().x1; ++x) {
                const PixelPosition p{x, y};
                const float         depth = part.depth(x, y);
                if (const auto cover = coverOf(part, p, depth, geometry.isTransparent, view, faceCulling))
                    found.push_back({p, {triangle, *cover, depth}});
            }
    std::ranges::sort(found, [](const auto& a, const auto& b) {
        const auto key = [](const auto& f) {
            return std::tuple(f.first.y, f.first.x, f.second.cover, -f.second.depth);
        };
        return key(a) < key(b);
    });
    found.erase(
        std::unique(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
        found.end());
    for (const auto& [p, cover] : found) {
        covers.beyondFar += cover.cover == Cover::BeyondFar;
        covers.holes += cover.cover == Cover::Hole;
        covers.backFacing += cover.cover == Cover::BackFace;
        if (cover.cover != Cover::Opaque && cover.cover != Cover::Transparent) continue;
        covers.opaque.push_back(p);
        covers.depth.push_back(cover.depth);
    }
    return covers;
}

}  // namespace zscope
