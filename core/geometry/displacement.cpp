#include "core/geometry/displacement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/base/approximation.h"
#include "core/geometry/placed_view.h"
#include "core/geometry/prepared_scene.h"
#include "core/scene/view.h"

namespace zscope {

namespace {

static_assert(Displacement().pixels == 1 / kSubpixels);

constexpr double kRounding = 0x1p-24;  // of float32, relative

/// The largest sum of magnitudes that is added up to place a vertex in the world.
struct PlacingMagnitude {
    double most = 0;
};

double magnitudeOf(const Bounds& box, const Affine& toWorld)
{
    if (box.isEmpty()) return 0;
    double sum = 0;
    for (const auto& row : toWorld.rows)
        sum += std::abs(row[0]) * std::max(std::abs(box.min.x), std::abs(box.max.x))
               + std::abs(row[1]) * std::max(std::abs(box.min.y), std::abs(box.max.y))
               + std::abs(row[2]) * std::max(std::abs(box.min.z), std::abs(box.max.z)) + std::abs(row[3]);
    return sum;
}

double placingMagnitudeOf(const PreparedScene& prepared)
{
    const auto measured = [&prepared] {
        const Scene&        scene = prepared.scene();
        std::vector<Bounds> boxes;
        for (const auto& mesh : scene.meshes) boxes.push_back(mesh->bounds());
        auto all = std::make_unique<PlacingMagnitude>();
        for (const Instance& instance : scene.instances)
            all->most = std::max(all->most, magnitudeOf(boxes[instance.mesh.value], instance.toWorld));
        return all;
    };
    return prepared.derived().get<PlacingMagnitude>(measured).most;
}

/// No float32 on the way from the model to a pixel of the picture overflows, or loses bits to underflow.
bool isFarFromLimits(const Camera& camera, double placing)
{
    const auto isWithin = [](double value, double most) { return value > 1 / most && value < most; };
    const auto isAxis   = [&](const dvec3& axis) { return isWithin(glm::length(axis), 0x1p20); };
    return isWithin(camera.near, 0x1p40) && isWithin(camera.focal, 0x1p40) && isAxis(camera.right) && isAxis(camera.up)
           && isAxis(camera.forward) && glm::length(camera.eye) < 0x1p60 && placing < 0x1p60;
}

}  // namespace

Displacement displacementOf(const Approximation& approximation, const Camera& camera, const PreparedScene& scene)
{
    Displacement displacement;
    if (approximation.snap == SnapBits::Four) displacement.pixels = 1.0 / 16;
    if (approximation.vertex == VertexNumbers::Float64) return displacement;
    displacement.instances = placingMagnitudeOf(scene);
    displacement.view =
        isFarFromLimits(camera, displacement.instances) ? 32 * kRounding : std::numeric_limits<double>::infinity();
    displacement.pixels += 16 * kRounding * std::max(camera.width, camera.height);
    return displacement;
}

}  // namespace zscope
