// Large triangles, which are drawn by lists of tiles: edges that pass exactly through the pixels in the corners of
// tiles, wide triangles' too, more tiles of one kind than a list holds, all kinds in one triangle, and what lies
// exactly as deep as the pyramid says give the reference's picture.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/generators/random.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// What is special about corners.
enum class Corner {
    AtTiles,   // on the first or last pixel centres of tiles, or a subpixel beside them
    Anywhere,  // up to a third of the picture beyond it
    Needles,   // two of three nearly in one place, across the picture
    Far,       // half of them up to 60,000 pixels away, just inside the guard band
    FarOut,    // half of them beyond it, up to 2^27 pixels away, where tiles are still asked
    FarAlong,  // that far out on a line through, or a subpixel beside, the first or last pixel centre of a tile
};

class LargeTriangles : public testing::TestWithParam<Corner> {
protected:
    // of the pyramid, and of the visibility buffer, whose tiles are as high
    static constexpr int kTile = 8, kStoredWidth = 64;

    using OnScreen = std::array<double, 2>;  // in pixels

    /// A pixel centre in a corner of a tile.
    static OnScreen centreAtTile(Random& random, const Camera& camera)
    {
        const auto along = [&random](int pixels, int tile) {
            const double first = tile * static_cast<double>(random.below(static_cast<std::uint64_t>(pixels / tile)));
            return first + (random.below(2) == 0 ? 0 : tile - 1) + 0.5;
        };
        const double x = along(camera.width, random.below(2) == 0 ? kTile : kStoredWidth);
        return {x, along(camera.height, kTile)};
    }

    /// Two corners with such a centre exactly between them, or a subpixel beside, and one anywhere.
    static std::array<OnScreen, 3> alongCentre(Random& random, const Camera& camera)
    {
        const auto step = [&random](int most) {
            return static_cast<double>(random.below(2 * static_cast<std::uint64_t>(most) + 1)) - most;
        };
        OnScreen way{};
        while (way[0] == 0 && way[1] == 0) way = {step(1000) / 256, step(1000) / 256};
        // mostly beyond the guard band
        const auto     away = [&random] { return std::floor(std::exp2(random.between(20, 25))); };
        const double   back = away(), on = away(), beside = random.below(3) == 0 ? step(1) / 256 : 0;
        const OnScreen centre = centreAtTile(random, camera);
        const auto     at     = [&](double steps) {
            return OnScreen{centre[0] + way[0] * steps + beside, centre[1] + way[1] * steps};
        };
        return {at(-back), at(on), cornerAt(Corner::FarOut, random, camera)};
    }

    /// A corner on the screen.
    static OnScreen cornerAt(Corner kind, Random& random, const Camera& camera)
    {
        const double width = camera.width, height = camera.height;
        if (kind == Corner::AtTiles) {
            const auto along = [&random](int pixels) {
                const double first =
                    kTile * static_cast<double>(random.below(static_cast<std::uint64_t>(pixels / kTile + 2)));
                const double pixel = random.below(2) == 0 ? first : first - 1;
                return pixel + 0.5 + (static_cast<double>(random.below(3)) - 1) / 256;
            };
            const double x = along(camera.width);
            return {x, along(camera.height)};
        }
        if ((kind == Corner::Far || kind == Corner::FarOut) && random.below(2) == 0) {
            const auto along = [&random, kind] {
                const double away =
                    kind == Corner::Far ? random.between(100, 60'000) : std::exp2(random.between(10, 27));
                return random.below(2) == 0 ? away : -away;
            };
            const double x = along();
            return {x, along()};
        }
        const double x = random.between(-0.33 * width, 1.33 * width);
        return {x, random.between(-0.33 * height, 1.33 * height)};
    }

    static std::shared_ptr<const PreparedScene> triangles(Corner kind, Random& random, const Camera& camera, int count)
    {
        std::vector<Corners> all;
        const bool           isLevel = random.below(2) == 0;  // depths that tie, all over a tile
        while (static_cast<int>(all.size()) < count) {
            const double z = 2 + static_cast<double>(random.below(3));
            Corners      corners;
            OnScreen     last{};
            const auto   along = kind == Corner::FarAlong ? alongCentre(random, camera) : std::array<OnScreen, 3>{};
            for (std::size_t k = 0; k < 3; ++k) {
                auto at = kind == Corner::FarAlong ? along[k] : cornerAt(kind, random, camera);
                if (kind == Corner::Needles && k == 2)
                    at = {last[0] + random.between(-9, 9), last[1] + random.between(-9, 9)};
                corners[k] = pointAt(camera, at[0], at[1], isLevel ? z : random.between(1.5, 5));
                last       = at;
            }
            all.push_back(corners);
        }
        return std::make_shared<const PreparedScene>(sceneOf(all));
    }
};

TEST_P(LargeTriangles, EveryPresetDrawsWhatTheReferenceDraws)
{
    Random        random(5 + static_cast<std::uint64_t>(GetParam()));
    std::uint64_t covered = 0;
    for (const auto& [width, height] : {std::pair{512, 256}, {640, 203}, {193, 256}}) {
        const Camera camera = plainCamera(width, height);
        for (std::uint64_t i = 0; i < shareOf(8); ++i) {
            const auto scene = triangles(GetParam(), random, camera, i % 2 == 0 ? 24 : 3);
            const auto what =
                "scene " + std::to_string(i) + " in " + std::to_string(width) + " x " + std::to_string(height);
            covered += expectAgreement(scene, camera, FaceCulling::None, what, {.threads = {1, 2}});
        }
    }
    EXPECT_GT(covered, shareOf(8) * (GetParam() == Corner::Needles ? 3'000 : 60'000));
}

INSTANTIATE_TEST_SUITE_P(Corners, LargeTriangles,
                         testing::Values(Corner::AtTiles, Corner::Anywhere, Corner::Needles, Corner::Far,
                                         Corner::FarOut, Corner::FarAlong));

}  // namespace
}  // namespace zscope::tests
