// Culling by a stripe's volume: never a box with something to draw in it, and most boxes without.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include <glm/geometric.hpp>

#include "core/geometry/near_clip.h"
#include "core/geometry/stripe_volume.h"

namespace zscope {
namespace {

class Random {
public:
    explicit Random(std::uint64_t seed) : m_bits(seed) {}
    double between(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(m_bits() >> 11) * 0x1p-53); }
    int    below(int n) { return static_cast<int>(m_bits() % static_cast<unsigned>(n)); }
    dvec3  direction()
    {
        for (;;) {
            const dvec3  v{between(-1, 1), between(-1, 1), between(-1, 1)};
            const double length = glm::length(v);
            if (length > 0.1 && length < 1) return v / length;
        }
    }
    dvec3 within(const Bounds& box)
    {
        const dvec3 t{share(), share(), share()};
        return box.min + t * (box.max - box.min);
    }

private:
    double share() { return below(4) == 0 ? below(2) : between(0, 1); }  // often on a face, an edge or a corner

    std::mt19937_64 m_bits;
};

/// A camera, a placement, a stripe: of any scale, far off the origin, of any field of view.
struct Setting {
    Camera camera;
    Affine toWorld;
    int    firstRow = 0, endRow = 0;
    double unit = 1;  // size of things

    explicit Setting(Random& random)
    {
        constexpr double units[]   = {1, 1, 1e-6, 1e-3, 1e6, 1e12};
        constexpr double angles[]  = {0.0001, 0.01, 1, 45, 90, 179, 179.999};  // degrees
        constexpr double offsets[] = {0, 0, 1, 1e6};                           // in units
        unit                       = units[random.below(6)];
        camera.eye                 = random.direction() * (offsets[random.below(4)] * unit);
        camera.forward             = random.direction();
        camera.right               = glm::normalize(glm::cross(camera.forward, random.direction()));
        camera.up                  = glm::cross(camera.right, camera.forward);
        camera.focal               = 1 / std::tan(angles[random.below(7)] * 3.141592653589793 / 360);
        camera.near                = unit * random.between(0.01, 1);
        camera.width               = 1 + random.below(random.below(2) ? 40 : 16384);
        camera.height              = 1 + random.below(random.below(2) ? 40 : 16384);
        firstRow                   = random.below(camera.height);
        endRow                     = firstRow + 1 + random.below(camera.height - firstRow);
        if (random.below(3) == 0) return;
        for (auto& row : toWorld.rows)
            for (std::size_t c = 0; c < 3; ++c) row[c] = random.between(-2, 2);
        if (random.below(3) == 0) toWorld.rows[2] = toWorld.rows[1];  // flattens everything
        for (std::size_t axis = 0; axis < 3; ++axis)
            toWorld.rows[axis][3] = camera.eye[static_cast<int>(axis)] + random.between(-2, 2) * unit;
    }

    /// A box in model space near something the camera may see, of any shape down to a point.
    Bounds box(Random& random) const
    {
        const double size   = unit * std::pow(10.0, random.between(-4, 2));
        dvec3        centre = random.direction() * (unit * random.between(0, 10));
        if (toWorld.isIdentity()) centre += camera.eye + camera.forward * (unit * random.between(-1, 10));
        Bounds box;
        for (int i = 0; i < 2; ++i)
            box.include(centre + random.direction() * size * (random.below(5) == 0 ? 0.0 : 1.0));
        return box;
    }
};

std::string describe(const Setting& s, const Bounds& b)
{
    std::ostringstream text;
    text.precision(17);
    text << s.camera.width << "x" << s.camera.height << ", rows " << s.firstRow << " to " << s.endRow << ", focal "
         << s.camera.focal << ", unit " << s.unit << ", box (" << b.min.x << ", " << b.min.y << ", " << b.min.z
         << ") to (" << b.max.x << ", " << b.max.y << ", " << b.max.z << ")";
    return text.str();
}

/// In the stripe grown by half a pixel on every side.
bool touches(const ScreenCorner& c, const Setting& s)
{
    return c.x >= -0.5 && c.x <= s.camera.width + 0.5 && c.y >= s.firstRow - 0.5 && c.y <= s.endRow + 0.5;
}

dvec3 viewOf(const Setting& s, const Projection& projection, const dvec3& model)
{
    return projection.toView(s.toWorld.isIdentity() ? model : s.toWorld(model));
}

TEST(StripeVolume, NeverMissesABoxHoldingAPointThatProjectsIntoTheStripe)
{
    Random        random(20261121);
    std::uint64_t seenPoints = 0, seenCrossings = 0;
    for (int i = 0; i < 20000; ++i) {
        const Setting      setting(random);
        const Projection   projection(setting.camera);
        const StripeVolume volume(projection, setting.camera.width, setting.firstRow, setting.endRow);
        const PlacedView   placed(projection, setting.toWorld);
        for (int b = 0; b < 4; ++b) {
            const Bounds box = setting.box(random);
            if (!volume.misses(placed(box))) continue;
            for (int p = 0; p < 8; ++p) {
                const dvec3 one   = viewOf(setting, projection, random.within(box)),
                            other = viewOf(setting, projection, random.within(box));
                if (one.z >= projection.near) {
                    ++seenPoints;
                    ASSERT_FALSE(touches(projection.toScreen(one), setting)) << describe(setting, box);
                }
                if ((one.z >= projection.near) == (other.z >= projection.near)) continue;
                ++seenCrossings;
                const dvec3 cut = one.z >= projection.near ? nearCrossing(one, other, projection.near)
                                                           : nearCrossing(other, one, projection.near);
                ASSERT_FALSE(touches(projection.toScreen(cut), setting)) << describe(setting, box);
            }
        }
    }
    EXPECT_GT(seenPoints, 10000u);  // boxes that were judged away did hold points in front of the eye
    EXPECT_GT(seenCrossings, 100u);
}

/// The tightest boxes: single points whose projection lies just inside the border of the stripe.
TEST(StripeVolume, NeverMissesAPointJustInsideTheStripesBorder)
{
    Random random(77);
    int    judged = 0;
    for (int i = 0; i < 200000; ++i) {
        const Setting    s(random);
        const Camera&    c = s.camera;
        const Projection projection(c);
        const bool       sideways = random.below(2) == 0;
        const double     x        = sideways ? (random.below(2) ? -0.5 : c.width + 0.5) : random.between(0, c.width);
        const double     y =
            sideways ? random.between(s.firstRow, s.endRow) : (random.below(2) ? s.firstRow - 0.5 : s.endRow + 0.5);
        const double z = c.near * std::pow(10.0, random.between(0, 6));
        const double k = c.height * 0.5 * c.focal;
        const dvec3  world =
            c.eye + c.forward * z + c.right * ((x - c.width * 0.5) / k * z) + c.up * ((c.height * 0.5 - y) / k * z);
        const Affine identity;
        const dvec3  view = projection.toView(world);
        if (!(view.z >= c.near) || !touches(projection.toScreen(view), s)) continue;
        ++judged;
        Bounds box;
        box.include(world);
        ASSERT_FALSE(
            StripeVolume(projection, c.width, s.firstRow, s.endRow).misses(PlacedView(projection, identity)(box)))
            << describe(s, box);
    }
    EXPECT_GT(judged, 50000);
}

TEST(StripeVolume, MissesMostBoxesThatAreClearlyOutside)
{
    Random random(5);
    int    outside = 0, missed = 0;
    for (int i = 0; i < 20000; ++i) {
        Setting s(random);
        s.toWorld          = {};
        const Camera&    c = s.camera;
        const Projection projection(c);
        const double     k = c.height * 0.5 * c.focal, z = c.near * random.between(2, 50);
        // A small box well beyond one side of the stripe, or behind the eye.
        const double far = 3.0 * (c.width + c.height), margin = random.between(10, far);
        double       x = c.width * 0.5, y = 0.5 * (s.firstRow + s.endRow), sign = 1;
        switch (random.below(5)) {
            case 0:
                x = -margin;
                break;
            case 1:
                x = c.width + margin;
                break;
            case 2:
                y = s.firstRow - margin;
                break;
            case 3:
                y = s.endRow + margin;
                break;
            default:
                sign = -1;
        }
        const dvec3 centre =
            c.eye
            + sign * (c.forward * z + c.right * ((x - c.width * 0.5) / k * z) + c.up * ((c.height * 0.5 - y) / k * z));
        const double half = std::min(z / k, z * 0.1) * 0.5;  // half a pixel, and not deep
        const Bounds box{centre - dvec3{half}, centre + dvec3{half}};
        ++outside;
        missed +=
            StripeVolume(projection, c.width, s.firstRow, s.endRow).misses(PlacedView(projection, s.toWorld)(box));
    }
    EXPECT_GT(missed, outside * 9 / 10);
}

TEST(StripeVolume, NumbersBeyondTheLargestAreNotMissed)
{
    const Projection   projection((Camera()));
    const StripeVolume volume(projection, 1280, 0, 720);
    const PlacedView   placed(projection, Affine{});
    EXPECT_FALSE(volume.misses(placed({dvec3{-1e308}, dvec3{1e308}})));
    EXPECT_FALSE(volume.misses(placed({dvec3{-1.7e308}, dvec3{1.7e308, 1.7e308, 0}})));
}

}  // namespace
}  // namespace zscope
