// Which pixels an instance can reach, so that a scene of a million instances can be judged at a few pixels.
//
// Why it is safe  every operation of the definition from the mesh to the grid (product, sum, quotient, rint) is
//                 monotone in each operand, and so is rounding to nearest. Intervals pushed through the SAME
//                 operations with the SAME roundings therefore hold every value that any vertex takes: nothing
//                 needs to be widened. What cannot be bounded so (an instance that touches the near plane, a NaN)
//                 reaches the whole picture.
#include <algorithm>
#include <cmath>

#include "core/measure/definition.h"

namespace zscope::definition {

namespace {

struct Interval {
    double lo, hi;
};

Interval operator+(Interval a, Interval b) { return {a.lo + b.lo, a.hi + b.hi}; }
Interval operator-(Interval a, Interval b) { return {a.lo - b.hi, a.hi - b.lo}; }
Interval operator*(Interval a, Interval b)
{
    const std::array<double, 4> ends{a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
    for (const double end : ends) {
        if (std::isnan(end)) return {-HUGE_VAL, HUGE_VAL};
    }
    return {std::min({ends[0], ends[1], ends[2], ends[3]}), std::max({ends[0], ends[1], ends[2], ends[3]})};
}

Interval exactly(double value) { return {value, value}; }

using Box = std::array<Interval, 3>;

}  // namespace

PixelBox reachOf(const Bounds& meshBox, const Affine& toWorld, const View& view)
{
    const Camera&  camera = view.camera;
    const PixelBox nothing;
    const PixelBox everything{0, camera.width - 1, 0, camera.height - 1};
    if (meshBox.isEmpty()) return nothing;

    const auto along = [](double x, double y, double z, const Box& b) {
        return (exactly(x) * b[0] + exactly(y) * b[1]) + exactly(z) * b[2];
    };
    Box p{{{meshBox.min.x, meshBox.max.x}, {meshBox.min.y, meshBox.max.y}, {meshBox.min.z, meshBox.max.z}}};
    if (!toWorld.isIdentity()) {
        const Box q = p;
        for (std::size_t r = 0; r < 3; ++r) {
            const auto& row = toWorld.rows[r];
            p[r]            = along(row[0], row[1], row[2], q) + exactly(row[3]);
        }
    }
    const Box      d{p[0] - exactly(camera.eye.x), p[1] - exactly(camera.eye.y), p[2] - exactly(camera.eye.z)};
    const Interval z = along(camera.forward.x, camera.forward.y, camera.forward.z, d);
    if (z.hi < camera.near) return nothing;  // every corner is outside, however it is rounded
    if (!(z.lo >= camera.near)) return everything;

    const Interval depth{camera.near / z.hi, camera.near / z.lo};
    const Interval x = exactly(camera.width * 0.5)
                       + (along(camera.right.x, camera.right.y, camera.right.z, d) * depth) * exactly(view.k);
    const Interval y =
        exactly(camera.height * 0.5) - (along(camera.up.x, camera.up.y, camera.up.z, d) * depth) * exactly(view.k);
    if (!(x.lo <= x.hi) || !(y.lo <= y.hi)) return everything;

    // Parts beyond the end of the grid are not drawn, so an end out there may as well stand at it.
    const auto snapped = [](double pixels) {
        return static_cast<std::int64_t>(std::rint(std::clamp(pixels * 256, -0x1p61, 0x1p61)));
    };
    return pixelsWithin(snapped(x.lo), snapped(x.hi), snapped(y.lo), snapped(y.hi), camera);
}

}  // namespace zscope::definition
