// The buffer's background makes the far test free, rows are apart, and derived values are made once.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/derived.h"
#include "core/base/ids.h"
#include "core/depth/visibility_buffer.h"
#include "core/scene/generators/random.h"

namespace zscope {
namespace {

TEST(VisibilityBuffer, BackgroundIsTheLargestDepthThatTheFarTestDrops)
{
    for (const double far : {1.5, 2.0, 3.0, 1e3, 1e30, 1e300, std::numeric_limits<double>::infinity()}) {
        const auto  kept  = static_cast<float>(1.0 / far);
        const float empty = DepthEncoding(DepthFormat::ReversedFloat32, 1.0, far).empty;
        EXPECT_LT(empty, kept) << far;
        EXPECT_EQ(std::nextafter(empty, 2.0f), kept) << far;
    }
    EXPECT_LT(DepthEncoding(DepthFormat::ReversedFloat32, 0.1, std::numeric_limits<double>::infinity()).empty, 0.0f)
        << "without a far plane even depth 0 is kept";
}

/// Draws value 7 at depth 1/2 over the box.
void draw(VisibilityBuffer& buffer, const PixelBox& box)
{
    buffer.open(box);
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x) buffer.row(y)[x] = keyOf(0.5f, 7);
}

TEST(VisibilityBuffer, ClearingRowsLeavesTheOthers)
{
    VisibilityBuffer buffer;
    for (const int width : {1, 15, 16, 17, 1000}) {
        buffer.resize(width, 29, DepthEncoding::withBackground(-1.0f));
        buffer.clearRows(0, 29);
        draw(buffer, {0, 0, width, 29});
        buffer.clearRows(8, 24);
        for (int y = 0; y < 29; ++y) {
            const bool isCleared = y >= 8 && y < 24;
            for (int x = 0; x < width; ++x) {
                EXPECT_EQ(buffer.idAt(x, y), isCleared ? -1 : 6);
                EXPECT_EQ(buffer.depthAt(x, y), isCleared ? 0.0f : 0.5f);
            }
        }
    }
}

TEST(VisibilityBuffer, WhatIsDrawnToIsEmptyBeforeAndEverythingElseIsAfterTheFrame)
{
    VisibilityBuffer buffer;
    std::mt19937_64  random(3);
    for (const auto& [width, height] : {std::pair{1, 1}, {64, 8}, {65, 9}, {200, 61}}) {
        buffer.resize(width, height, DepthEncoding::withBackground(-1.0f));
        const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
        for (int frame = 0; frame < 40; ++frame) {
            buffer.emptyRows(0, height);
            Grid<char> drawn(width, height);
            for (int i = below(4); i > 0; --i) {
                const int      x = below(width), y = below(height);
                const PixelBox box{x, y, x + 1 + below(width - x), y + 1 + below(height - y)};
                buffer.open(box);
                for (int row = box.y0; row < box.y1; ++row)
                    for (int column = box.x0; column < box.x1; ++column) {
                        ASSERT_TRUE(buffer.isReadable(column, row));
                        ASSERT_EQ(buffer.rankAt(column, row), drawn.at(column, row) ? 7u : 0u);
                        ASSERT_EQ(buffer.storedAt(column, row), drawn.at(column, row) ? 0.5f : -1.0f);
                        drawn.at(column, row) = 1;
                    }
                draw(buffer, box);
            }
            buffer.finishRows(0, height);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    ASSERT_EQ(buffer.idAt(x, y), drawn.at(x, y) ? 6 : -1) << frame << ": " << x << ' ' << y;
                    ASSERT_EQ(buffer.storedAt(x, y), drawn.at(x, y) ? 0.5f : -1.0f);
                }
        }
    }
}

/// Of pictures with this n/F, by exact rules.
DepthEncoding plainEncoding(double farthest) { return {DepthFormat::ReversedFloat32, farthest, 1.0}; }

TEST(DepthEncoding, PicturesLieAboveEachOtherUntilFloat32EndsAndHoldTheSameDepths)
{
    for (const double farthest : {0.9, 0.5, 0.1, 1e-3, 1.0 / 65536, 1e-10, 1e-30, 1e-37}) {
        const DepthEncoding plain = plainEncoding(farthest);
        DepthEncoding       last  = plain.above(plain);
        EXPECT_EQ(last.scale, 1) << "nothing is known of what came before";
        EXPECT_FALSE(last.isAbove(plain));
        int stacked = 0;
        for (int picture = 0; picture < 1000; ++picture) {
            const DepthEncoding next = plain.above(last);
            stacked += next.isAbove(last);
            EXPECT_EQ(next.isAbove(last), keyOf(next.empty, 0) > keyOf(static_cast<float>(last.scale), 1))
                << farthest << ": " << picture;
            EXPECT_TRUE(std::isnormal(next.empty)) << farthest << ": " << picture;
            for (const double depth : {farthest, std::sqrt(farthest), 0.5 + farthest / 2, 1.0}) {
                const auto stored = static_cast<float>(depth * next.scale);
                EXPECT_TRUE(std::isnormal(stored) && stored > next.empty) << farthest << ": " << picture;
                EXPECT_EQ(next.depthOf(stored), static_cast<float>(depth)) << farthest << ": " << picture;
                EXPECT_LT(keyOf(stored, 1), keyOf(std::numeric_limits<float>::max(), 1));
            }
            EXPECT_EQ(next.atScaleOne(next.empty), plain.empty);
            last = next;
        }
        EXPECT_GE(stacked, farthest > 1e-30 ? 500 : 0) << farthest;
    }
}

TEST(VisibilityBuffer, OfAPictureAboveTheLastOneTilesAreNotEmptiedAndShowOnlyWhatWasDrawn)
{
    VisibilityBuffer buffer;
    std::mt19937_64  random(5);
    const auto       below  = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
    constexpr int    kWidth = 200, kHeight = 61;
    int              keptMemory = 0;
    for (int picture = 0; picture < 400; ++picture) {
        const DepthEncoding encoding = buffer.encodingAbove(plainEncoding(picture < 200 ? 1e-3 : 1e-5));
        buffer.resize(kWidth, kHeight, encoding);
        buffer.emptyRows(0, kHeight);
        Grid<PixelKey> expected(kWidth, kHeight, buffer.background());
        for (int i = below(4); i > 0; --i) {
            const int           x = below(kWidth), y = below(kHeight);
            const PixelBox      box{x, y, x + 1 + below(kWidth - x), y + 1 + below(kHeight - y)};
            const auto          depth = static_cast<float>((0.25 + 0.125 * below(7)) * encoding.scale);
            const std::uint32_t rank  = 1 + static_cast<std::uint32_t>(below(1000));
            if (below(3) == 0) {  // the whole tile as a plane, in place of what it holds
                const PixelBox tile{x / 64 * 64, y / 8 * 8, std::min(x / 64 * 64 + 64, kWidth),
                                    std::min(y / 8 * 8 + 8, kHeight)};
                buffer.setPlane(x, y, {{0, 0, depth, depth, depth}, rank});
                for (int row = tile.y0; row < tile.y1; ++row)
                    for (int column = tile.x0; column < tile.x1; ++column)
                        expected.at(column, row) = keyOf(depth, rank);
                continue;
            }
            buffer.open(box);
            for (int row = box.y0; row < box.y1; ++row)
                for (int column = box.x0; column < box.x1; ++column) {
                    keptMemory += buffer.row(row)[column] < buffer.background();
                    PixelKey& key            = buffer.row(row)[column];
                    key                      = std::max(key, keyOf(depth, rank));
                    expected.at(column, row) = std::max(expected.at(column, row), keyOf(depth, rank));
                }
        }
        buffer.finishRows(0, kHeight);
        if (below(2) == 0)
            buffer.storePlanes(0, kHeight, [&buffer](const PixelBox& tile, const TilePlane& plane) {
                for (int y = tile.y0; y < tile.y1; ++y)
                    for (int x = tile.x0; x < tile.x1; ++x) buffer.row(y)[x] = plane.keyAt(x, y);
            });
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                ASSERT_EQ(buffer.keyAt(x, y), expected.at(x, y)) << picture << ": " << x << ' ' << y;
                ASSERT_EQ(buffer.depthAt(x, y), buffer.rankAt(x, y) == 0
                                                    ? 0.0f
                                                    : static_cast<float>(depthOf(expected.at(x, y)) / encoding.scale));
            }
    }
    EXPECT_GT(keptMemory, 10000) << "memory was never left as it was";
}

TEST(VisibilityBuffer, ATileKeptAsAPlaneShowsItsTriangleUntilTheFrameEndsAndItsPixelsAreWrittenWhenSomethingElseIsDrawn)
{
    VisibilityBuffer buffer;
    buffer.resize(200, 29, DepthEncoding::withBackground(-1.0f));
    buffer.clearRows(0, 29);
    draw(buffer, {0, 0, 200, 29});
    buffer.emptyRows(0, 29);

    const PixelBox whole{64, 8, 128, 16}, last{192, 24, 200, 29};
    for (const PixelBox& box : {whole, last}) EXPECT_TRUE(buffer.isWholeTile(box));
    for (const PixelBox& part :
         {PixelBox{64, 8, 127, 16}, {65, 8, 128, 16}, {64, 9, 128, 16}, {64, 8, 128, 15}, {192, 24, 200, 28}})
        EXPECT_FALSE(buffer.isWholeTile(part));

    const TilePlane first{{0.001, -0.002, 0.3, 0.31f, 0.5f}, 12}, second{{0, 0, 0.25, 0.25f, 0.25f}, 4};
    const auto      expectPlane = [&buffer](const PixelBox& tile, const TilePlane& plane) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                const double z = std::clamp(plane.depth.a * (x + 0.5) + (plane.depth.b * (y + 0.5) + plane.depth.c),
                                                 double{plane.depth.farthest}, double{plane.depth.nearest});
                ASSERT_EQ(buffer.rankAt(x, y), plane.rank) << x << ' ' << y;
                ASSERT_EQ(buffer.storedAt(x, y), static_cast<float>(z)) << x << ' ' << y;
            }
    };
    EXPECT_EQ(buffer.planeAt(100, 10), nullptr);
    buffer.setPlane(127, 15, second);
    expectPlane(whole, second);
    buffer.setPlane(64, 8, first);
    buffer.setPlane(192, 24, first);
    EXPECT_TRUE(buffer.isOpen(100, 10));
    ASSERT_NE(buffer.planeAt(100, 10), nullptr);
    EXPECT_EQ(buffer.planeAt(63, 8), nullptr);
    EXPECT_EQ(buffer.row(10)[100], keyOf(0.5f, 7)) << "its pixels are not written";
    expectPlane(whole, first);
    buffer.finishRows(0, 29);
    expectPlane(whole, first);

    buffer.open({100, 10, 101, 11});
    EXPECT_EQ(buffer.planeAt(64, 8), nullptr);
    expectPlane(whole, first);
    EXPECT_NE(buffer.planeAt(199, 28), nullptr) << "another tile";
    int stored = 0;
    buffer.storePlanes(0, 29, [&](const PixelBox& tile, const TilePlane& plane) {
        EXPECT_EQ(tile, last);
        EXPECT_EQ(plane.rank, first.rank);
        ++stored;
    });
    EXPECT_EQ(stored, 1);
    EXPECT_EQ(buffer.planeAt(199, 28), nullptr);

    buffer.setPlane(64, 8, second);
    buffer.emptyRows(0, 29);
    EXPECT_EQ(buffer.planeAt(64, 8), nullptr);
    EXPECT_FALSE(buffer.isOpen(100, 10));
    buffer.finishRows(0, 29);
    EXPECT_EQ(buffer.rankAt(100, 10), 0u);
}

TEST(VisibilityBuffer, APlaneIsNearestAndFarthestInTwoCornersOfARectangle)
{
    Random random(9);
    for (int i = 0; i < 3'000; ++i) {
        const int      x = static_cast<int>(random.below(16000)), y = static_cast<int>(random.below(16000));
        const PixelBox box{x, y, x + 1 + static_cast<int>(random.below(12)), y + 1 + static_cast<int>(random.below(8))};
        const double   steep = std::pow(10.0, random.between(-12, 0));
        DepthPlane     plane{steep * random.between(-1, 1), steep * random.between(-1, 1), 0, 0, 0};
        plane.c        = 0.5 - plane.a * x - plane.b * y;
        plane.farthest = static_cast<float>(0.5 - 3 * steep * random.unit());
        plane.nearest  = static_cast<float>(0.5 + 3 * steep * random.unit());
        float nearest = -1, farthest = 2;
        for (int row = box.y0; row < box.y1; ++row)
            for (int column = box.x0; column < box.x1; ++column) {
                nearest  = std::max(nearest, depthAt(plane, column, row));
                farthest = std::min(farthest, depthAt(plane, column, row));
            }
        ASSERT_EQ(nearestOver(plane, box), nearest);
        ASSERT_EQ(farthestOver(plane, box), farthest);
    }
}

TEST(VisibilityBuffer, AVectorMayBeReadAtTheLastPixelOfEveryRow)
{
    for (int width = 1; width < 70; ++width) {
        VisibilityBuffer buffer;
        buffer.resize(width, 3, DepthEncoding::withBackground(0.0f));
        buffer.clearRows(0, 3);
        for (int y = 0; y < 3; ++y) {
            for (int past = 0; past < kRowPadding; ++past) buffer.row(y)[width - 1 + past] = 99;  // asan watches
            if (y > 0) {
                EXPECT_GE(buffer.row(y) - buffer.row(y - 1), width + kRowPadding);
            }
        }
        if (width > 1) {
            EXPECT_EQ(buffer.idAt(0, 1), -1) << "padding of one row is not the next row";
        }
    }
}

TEST(VisibilityBuffer, TheLargestIdIsReportedAsItself)
{
    VisibilityBuffer buffer;
    buffer.resize(1, 1, DepthEncoding::withBackground(0.0f));
    buffer.row(0)[0] = keyOf(0.5f, static_cast<std::uint32_t>(kMaxTriangles));  // rank of the last possible triangle
    EXPECT_EQ(buffer.idAt(0, 0), static_cast<std::int64_t>(kMaxTriangles) - 1);
}

struct Number {
    int value;
};

TEST(Derived, AValueIsMadeOnceHoweverManyThreadsAsk)
{
    Derived                  derived;
    std::atomic<int>         made = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&] {
            const Number& n = derived.get<Number>([&] { return std::make_unique<Number>(Number{++made}); });
            EXPECT_EQ(n.value, 1);
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(made, 1);
}

TEST(Derived, AMakerThatFailedIsAskedAgain)
{
    Derived derived;
    EXPECT_THROW(derived.get<Number>([]() -> std::unique_ptr<Number> { throw std::bad_alloc(); }), std::bad_alloc);
    EXPECT_EQ(derived.get<Number>([] { return std::make_unique<Number>(Number{5}); }).value, 5);
}

}  // namespace
}  // namespace zscope
