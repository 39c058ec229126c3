// Level L2 of docs/correctness.md: what the definition's own float64 arithmetic costs, measured against exact
// rational numbers on every kind of soup.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/measure/error_figures.h"
#include "core/measure/reference.h"
#include "tests/agreement/rational_reference.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// Pixels. Up to here the stored depth of a thick part is within one step of the exact one. From about 2^45 on, where
/// float64 steps are no longer small beside a pixel, the definition's plane is off by more (88,425 steps at 2^51) and
/// only the limits hold it: a property of the definition that every exact method shares.
constexpr double kFarthestTrusted = 0x1p40;

bool reachesBeyond(const definition::Part& part, double pixels)
{
    return std::ranges::any_of(part.corners(), [pixels](const definition::Corner& c) {
        return std::abs(c.x) > pixels || std::abs(c.y) > pixels;
    });
}

struct Tally {
    std::uint64_t parts = 0, pixels = 0, samples = 0;
    std::uint64_t snapDifferences = 0;  // corners whose float64 lies on the other side of a snapping tie
    std::uint64_t nearTies        = 0;  // corners whose float64 lies on the other side of the near plane
    std::uint64_t openCuts        = 0;  // triangles with an edge in the near plane, cut where rounding says
    std::uint64_t coverage        = 0;  // pixels of a part covered by one and not by the other: must be 0
    std::uint64_t thickDepths     = 0;  // one step, where the part is thicker than 1/1024 px
    std::uint64_t thinDepths      = 0;  // any difference, where it is not
    std::uint64_t ids             = 0;
    std::uint64_t unexplainedIds  = 0;  // differ although all depths at the pixel agree: must be 0
    std::uint32_t thickSteps      = 0;  // most steps on a thick part: must be <= 1
    std::uint32_t stepsBeyond     = 0;  // the same on parts that reach beyond kFarthestTrusted: published only
    std::uint64_t outsideLimits   = 0;  // must be 0
    std::uint64_t unmatchedParts  = 0;  // drawn by one and not by the other: must be 0
};

/// Whether a snapped coordinate is the exact one's, or can be excused: the exact value is as near to the tie as
/// float64 can tell for a coordinate of its size (and `reach`, the size of what was subtracted to get it).
enum class Snap { Same, Tie, Wrong };
Snap compareSnap(std::int64_t found, const mpz_class& wanted, const mpq_class& exactPixels)
{
    if (wanted == mpz_class(static_cast<long>(found))) return Snap::Same;
    const mpq_class exact = exactPixels * 256;
    const mpq_class away  = abs(mpq_class(exact - mpz_class(static_cast<long>(found))));
    const mpq_class slack = 0.5 + 1e-6 + abs(exact) * 0x1p-44;
    return away <= slack ? Snap::Tie : Snap::Wrong;
}

/// The rational part that is the same part of the triangle as `part`, with its snapped corners made equal.
std::optional<std::size_t> match(const definition::Part& part, std::vector<RationalPart>& candidates, Tally& tally)
{
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        bool          same = true;
        std::uint64_t ties = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const definition::Corner& found  = part.corners()[i];
            const RationalCorner&     wanted = candidates[c].corners()[i];
            for (const Snap snap :
                 {compareSnap(found.xs, wanted.xs, wanted.x), compareSnap(found.ys, wanted.ys, wanted.y)}) {
                same = same && snap != Snap::Wrong;
                ties += snap == Snap::Tie;
            }
        }
        if (!same) continue;
        tally.snapDifferences += ties;
        candidates[c].adoptSnapped(part.corners());
        return c;
    }
    return std::nullopt;
}

struct Winner {
    std::int64_t id    = -1;
    float        depth = 0;

    void offer(std::int64_t otherId, float otherDepth)
    {
        if (id < 0 || otherDepth > depth || (otherDepth == depth && otherId < id)) *this = {otherId, otherDepth};
    }
};

void offerDefinition(const std::vector<definition::Part>& parts, std::int64_t id, float far, Grid<Winner>& picture)
{
    for (const definition::Part& part : parts) {
        for (int y = part.box().y0; y <= part.box().y1; ++y) {
            for (int x = part.box().x0; x <= part.box().x1; ++x) {
                if (part.covers(x, y) && part.depth(x, y) >= far) picture.at(x, y).offer(id, part.depth(x, y));
            }
        }
    }
}

void measure(const Soup& soup, FaceCulling culling, Tally& tally)
{
    const Scene&           scene  = *soup.scene;
    const Camera&          camera = soup.camera;
    const definition::View view(camera, culling);
    const float far = std::isinf(camera.far) ? 0.0f : toFloat(mpq_class(camera.near) / mpq_class(camera.far));
    ASSERT_EQ(far, view.farDepth);

    Grid<Winner>                  exact(camera.width, camera.height);
    Grid<std::uint8_t>            depthDiffers(camera.width, camera.height, 0);
    std::vector<definition::Part> parts;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const InstanceId instance{i};
        for (std::uint32_t t = 0; t < scene.meshOf(instance).triangles.size(); ++t) {
            const std::int64_t id                = scene.firstTriangle[i] + t;
            const auto         fate              = definition::partsOf(scene, instance, t, view, parts);
            auto [rational, nearTies, cutIsOpen] = rationalTriangle(scene, instance, t, camera);
            tally.nearTies += static_cast<std::uint64_t>(nearTies);
            if (cutIsOpen) {  // nothing to compare with: the picture takes the definition's own samples
                ++tally.openCuts;
                offerDefinition(parts, id, far, exact);
                continue;
            }
            std::vector<bool> matched(rational.size(), false);
            for (const definition::Part& part : parts) {
                const auto which = match(part, rational, tally);
                if (!which || matched[*which]) {
                    ++tally.unmatchedParts;
                    continue;
                }
                matched[*which]       = true;
                const RationalPart& r = rational[*which];
                ++tally.parts;
                std::uint32_t& most = reachesBeyond(part, kFarthestTrusted) ? tally.stepsBeyond : tally.thickSteps;
                const definition::PixelBox box = part.box();
                const definition::PixelBox all{std::max(0, box.x0 - 1), std::min(camera.width - 1, box.x1 + 1),
                                               std::max(0, box.y0 - 1), std::min(camera.height - 1, box.y1 + 1)};
                for (int y = all.y0; !box.isEmpty() && y <= all.y1; ++y) {
                    for (int x = all.x0; x <= all.x1; ++x) {
                        const bool covered = r.covers(x, y);
                        tally.coverage += covered != part.covers(x, y);
                        if (!covered) continue;
                        ++tally.samples;
                        const float wanted = r.depth(x, y);
                        const float found  = part.depth(x, y);
                        tally.outsideLimits += found < r.lo() || found > r.hi();
                        if (const std::uint32_t steps = stepsBetween(wanted, found); steps > 0) {
                            ++(r.isThick() ? tally.thickDepths : tally.thinDepths);
                            if (r.isThick()) most = std::max(most, steps);
                            depthDiffers.at(x, y) = 1;
                        }
                        if (wanted >= far) exact.at(x, y).offer(id, wanted);
                    }
                }
            }
            for (std::size_t r = 0; r < rational.size(); ++r) {
                if (matched[r] || fate == definition::Fate::OutOfRange) continue;
                const bool turnsOver = scene.instances[i].toWorld.isMirrored();
                const int  sign      = turnsOver ? -rational[r].sign() : rational[r].sign();
                tally.unmatchedParts += sign < 0 || (sign > 0 && culling == FaceCulling::None);
            }
        }
    }

    const auto picture = referencePicture(scene, camera, culling);
    ASSERT_TRUE(picture.ok());
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            tally.pixels += exact.at(x, y).id >= 0;
            if (picture->ids.at(x, y) == exact.at(x, y).id) continue;
            ++tally.ids;
            tally.unexplainedIds += !depthDiffers.at(x, y);
        }
    }
}

class L2 : public testing::TestWithParam<SoupKind> {};

TEST_P(L2, TheDefinitionRoundsNothingButTheSnapAndTheStoredDepth)
{
    Tally       tally;
    std::string seeds;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Soup soup =
            makeSoup(GetParam(), seed, 48 + static_cast<int>(seed), 37, GetParam() == SoupKind::Slivers ? 400 : 50);
        SCOPED_TRACE(soup.what);
        measure(soup, seed % 3 == 0 ? FaceCulling::Back : FaceCulling::None, tally);
    }
    std::printf(
        "L2 %-22.*s parts %6llu  pixels %6llu  samples %7llu  snap ties %3llu  near ties %2llu  open cuts %2llu  ids "
        "%3llu  depth steps: thick %3llu "
        "(max %u, beyond 2^40 px %u)  thin %llu\n",
        static_cast<int>(nameOf(GetParam()).size()), nameOf(GetParam()).data(),
        static_cast<unsigned long long>(tally.parts), static_cast<unsigned long long>(tally.pixels),
        static_cast<unsigned long long>(tally.samples), static_cast<unsigned long long>(tally.snapDifferences),
        static_cast<unsigned long long>(tally.nearTies), static_cast<unsigned long long>(tally.openCuts),
        static_cast<unsigned long long>(tally.ids), static_cast<unsigned long long>(tally.thickDepths),
        tally.thickSteps, tally.stepsBeyond, static_cast<unsigned long long>(tally.thinDepths));
    EXPECT_GT(tally.samples, 100u) << "the soup draws next to nothing: it tests nothing";
    EXPECT_EQ(tally.coverage, 0u);
    EXPECT_EQ(tally.unmatchedParts, 0u);
    EXPECT_EQ(tally.unexplainedIds, 0u);
    EXPECT_EQ(tally.outsideLimits, 0u);
    EXPECT_LE(tally.thickSteps, 1u);
}

INSTANTIATE_TEST_SUITE_P(Soups, L2, testing::ValuesIn(soupKinds().begin(), soupKinds().end()), [](const auto& kind) {
    std::string name;
    for (const char c : nameOf(kind.param)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
});

TEST(RationalReference, RationalsAreRoundedToTheNearestFloatAndInteger)
{
    for (const float f : {0.0f, 1.0f, 0.1f, 0x1p-149f, 0x1.8p-140f, 0x1.fffffep-1f, 0x1.000002p-20f}) {
        EXPECT_EQ(toFloat(mpq_class(f)), f);
        const float up   = std::nextafter(f, 2.0f);
        const auto  half = mpq_class((mpq_class(f) + mpq_class(up)) / 2);
        EXPECT_EQ(toFloat(half), static_cast<float>(half.get_d())) << f;  // float64 holds the middle: ties to even
        EXPECT_EQ(toFloat(half + mpq_class(0x1p-200)), up) << f;
        EXPECT_EQ(toFloat(half - mpq_class(0x1p-200)), f) << f;
    }
    EXPECT_EQ(toInteger(mpq_class(5, 2)), 2);
    EXPECT_EQ(toInteger(mpq_class(7, 2)), 4);
    EXPECT_EQ(toInteger(mpq_class(-5, 2)), -2);
    EXPECT_EQ(toInteger(mpq_class(-7, 2)), -4);
    EXPECT_EQ(toInteger(mpq_class(-8, 3)), -3);
    EXPECT_EQ(toInteger(mpq_class(7, 3)), 2);
}

}  // namespace
}  // namespace zscope::tests
