// What the pyramid promises, against every pixel asked one by one: hidden exactly when each pixel of the box is
// strictly nearer. Hard cases D1 to D7 and D9 of docs/correctness.md.
#include "core/depth/pyramid_told.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/scene/generators/random.h"

namespace zscope {
namespace {

constexpr float kEmpty = 0.0009765f;

int tilesRead = 0;

/// As whoever draws would read a tile, with one lane.
PixelKey leastKey(const PixelKey* first, std::ptrdiff_t stride, int lines)
{
    ++tilesRead;
    PixelKey least = *first;
    for (int y = 0; y < lines; ++y)
        for (int x = 0; x < 1 << Pyramid::kTileLevel; ++x) least = std::min(least, first[y * stride + x]);
    return least;
}

/// Depths and the pyramid over the lines [firstRow, endRow) of them. Lines outside hold the farthest depth, or the
/// nearest: whatever they hold, no answer may depend on it.
struct Screen {
    Screen(int width, int height, int first, int end, float outside) : firstRow(first), endRow(end)
    {
        visible.resize(width, height, DepthEncoding::withBackground(kEmpty));
        visible.clearRows(0, height);
        for (int y = 0; y < height; ++y)
            if (y < firstRow || y >= endRow) std::fill_n(visible.row(y), width, keyOf(outside, 0));
        pyramid.reset(visible, firstRow, endRow);
        pyramid.readTilesBy(leastKey);
    }
    Screen(int width, int height) : Screen(width, height, 0, height, 0) {}

    PixelBox region() const { return {0, firstRow, visible.width(), endRow}; }

    /// As triangles do: depths only grow.
    void draw(const PixelBox& box, float depth)
    {
        write(box, depth);
        pyramid.touched(box);
    }
    /// The same, by one who has seen all pixels of the tiles that are drawn over as a whole.
    void drawByTiles(const PixelBox& box, float depth)
    {
        write(box, depth);
        for (int y = (box.y0 - firstRow) >> Pyramid::kTileLevel; firstRow + (y << Pyramid::kTileLevel) < box.y1; ++y)
            for (int x = box.x0 >> Pyramid::kTileLevel; x << Pyramid::kTileLevel < box.x1; ++x) {
                const PixelBox tile = cell(Pyramid::kTileLevel, x, y);
                const PixelBox drawn{std::max(tile.x0, box.x0), std::max(tile.y0, box.y0), std::min(tile.x1, box.x1),
                                     std::min(tile.y1, box.y1)};
                if (drawn == tile)
                    pyramid.drawnTile(tile.x0, tile.y0, farthest(tile), Untold{});
                else
                    pyramid.touched(drawn);
            }
    }
    void write(const PixelBox& box, float depth)
    {
        visible.open(box);
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) visible.row(y)[x] = std::max(visible.row(y)[x], keyOf(depth, 0));
    }
    float farthest(const PixelBox& box) const
    {
        float least = std::numeric_limits<float>::infinity();
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) least = std::min(least, visible.storedAt(x, y));
        return least;
    }
    /// The pixels of a cell that exist.
    PixelBox cell(int level, int x, int y) const
    {
        return {x << level, firstRow + (y << level), std::min((x + 1) << level, visible.width()),
                std::min(firstRow + ((y + 1) << level), endRow)};
    }
    PixelBox anyBox(Random& random) const
    {
        const auto side = [&random](int low, int high) {
            const int a    = low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low)));
            const int most = random.below(3) == 0 ? high - a : std::min(high - a, 12);
            return std::array{a, a + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(most)))};
        };
        const auto [x0, x1] = side(0, visible.width());
        const auto [y0, y1] = side(firstRow, endRow);
        return {x0, y0, x1, y1};
    }

    int              firstRow, endRow;
    VisibilityBuffer visible;
    Pyramid          pyramid;
};

void expectExact(Screen& screen, const PixelBox& box, float nearest, const char* when)
{
    const bool hidden = nearest < screen.farthest(box);
    const auto query  = screen.pyramid.ask(box, nearest);
    ASSERT_EQ(query.hidden, hidden) << when << ": box " << box.x0 << ' ' << box.y0 << ' ' << box.x1 << ' ' << box.y1
                                    << " at " << nearest << ", farthest pixel " << screen.farthest(box);
    ASSERT_EQ(query.box, box);
    // It begins on a level where the box takes at most 2 x 2 cells.
    ASSERT_LE(((box.x1 - 1) >> query.level) - (box.x0 >> query.level), 1);
    ASSERT_LE(((box.y1 - 1 - screen.firstRow) >> query.level) - ((box.y0 - screen.firstRow) >> query.level), 1);
    ASSERT_GE(query.cells, 1);
}

/// No stored cell is nearer than its pixels, refreshed or not.
void expectNoCellTooNear(const Screen& screen)
{
    for (int level = Pyramid::kTileLevel; level < screen.pyramid.levels(); ++level) {
        const auto stored = screen.pyramid.stored(level);
        for (int y = 0; y < stored.height; ++y)
            for (int x = 0; x < stored.width; ++x)
                ASSERT_LE(stored.at(x, y), screen.farthest(screen.cell(level, x, y))) << level << ": " << x << ' ' << y;
    }
}

constexpr std::array<std::array<int, 2>, 10> kSizes{
    {{1, 1}, {1, 67}, {67, 1}, {8, 8}, {9, 8}, {17, 33}, {64, 64}, {130, 5}, {257, 193}, {1023, 769}}};

TEST(Pyramid, AnswersExactlyAfterAnySequenceOfWritesInEverySizeAndStripe)
{
    std::array<int, 2> answers{};
    for (const auto& [width, height] : kSizes)
        for (const int first : {0, 8, 16, 56}) {
            if (first >= height) continue;
            for (const int end : {height, first + (height - first + 1) / 2}) {
                for (const float outside : {0.0f, 1.0f}) {
                    SCOPED_TRACE(testing::Message() << width << 'x' << height << ", lines " << first << " to " << end);
                    Random    random(static_cast<std::uint64_t>(width * 4096 + height + first * 7 + end));
                    Screen    screen(width, height, first, end, outside);
                    const int steps = width > 500 ? 60 : 250;
                    for (int i = 0; i < steps; ++i) {
                        // Depths come near in time, so that the pyramid changes at every step (D9).
                        const auto depth =
                            static_cast<float>(static_cast<double>(i + 1) / steps * random.between(0.5, 1));
                        const PixelBox drawn = random.below(8) == 0 ? screen.region() : screen.anyBox(random);
                        if (random.below(2) == 0)
                            screen.drawByTiles(drawn, depth);
                        else
                            screen.draw(drawn, depth);
                        for (int q = 0; q < 3; ++q) {
                            const PixelBox box      = screen.anyBox(random);
                            const float    farthest = screen.farthest(box);
                            const float below = std::nextafter(farthest, 0.0f), above = std::nextafter(farthest, 2.0f);
                            for (const float nearest : {below, farthest, above, static_cast<float>(random.unit())}) {
                                expectExact(screen, box, nearest, "after a write");
                                ++answers[nearest < farthest];
                                if (testing::Test::HasFatalFailure()) return;
                            }
                        }
                    }
                    expectNoCellTooNear(screen);
                }
            }
        }
    EXPECT_GT(answers[0], 1000);
    EXPECT_GT(answers[1], 1000);
}

TEST(Pyramid, ATileDrawnOverAsAWholeHidesWithoutItsPixelsBeingReadAgain)
{
    Screen screen(64, 32);
    screen.drawByTiles({8, 8, 40, 24}, 0.5f);
    std::fill_n(screen.visible.row(9), 64, keyOf(kEmpty, 0));  // whoever reads all of it is misled
    EXPECT_TRUE(screen.pyramid.hides({8, 8, 40, 24}, 0.4f));
    EXPECT_FALSE(screen.pyramid.hides({8, 8, 41, 24}, 0.4f));
    std::vector<CellWrite> told;
    const auto             tell = [&told](const CellWrite& write) { told.push_back(write); };
    screen.pyramid.drawnTile(8, 8, 0.6f, tell);
    screen.pyramid.drawnTile(8, 8, 0.6f, tell);  // no news
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].level, Pyramid::kTileLevel);
    EXPECT_EQ(told[0].before, 0.5f);
    EXPECT_EQ(told[0].after, 0.6f);
    EXPECT_TRUE(screen.pyramid.hidesTile(15, 15, 0.59f));
    EXPECT_FALSE(screen.pyramid.hidesTile(15, 15, 0.6f)) << "on equal depth the lower id wins";
}

TEST(Pyramid, TilesOfFullWidthAreReadByWhoDrawsAndTheOthersPixelByPixel)
{
    // two columns of tiles are 8 pixels wide, the third has 5; the last of four lines of them has 3 lines
    Screen screen(21, 27), onItsOwn(21, 27);
    onItsOwn.pyramid.readTilesBy(nullptr);
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        const PixelBox box   = i == 0 ? screen.region() : screen.anyBox(random);
        const auto     depth = static_cast<float>(1 + random.below(100)) / 100;
        screen.draw(box, depth);
        onItsOwn.draw(box, depth);
    }
    tilesRead = 0;
    screen.pyramid.complete();
    EXPECT_EQ(tilesRead, 2 * 4);
    onItsOwn.pyramid.complete();
    EXPECT_EQ(tilesRead, 2 * 4);
    for (int level = Pyramid::kTileLevel; level < screen.pyramid.levels(); ++level) {
        const auto stored = screen.pyramid.stored(level), expected = onItsOwn.pyramid.stored(level);
        for (int y = 0; y < stored.height; ++y)
            for (int x = 0; x < stored.width; ++x) {
                EXPECT_EQ(stored.at(x, y), expected.at(x, y)) << level << ": " << x << ' ' << y;
                EXPECT_EQ(stored.at(x, y), screen.farthest(screen.cell(level, x, y))) << level << ": " << x << ' ' << y;
            }
    }
}

TEST(Pyramid, TilesThatWereSeenAreNoLongerStaleAndTheirAncestorsAre)
{
    Screen screen(64, 32);
    screen.write({0, 0, 16, 16}, 0.5f);
    for (const int y : {0, 8}) screen.pyramid.touched({0, y, 8, y + 8});
    for (const int y : {0, 8}) screen.pyramid.drawnTiles(0, y, std::array{0.5f, 0.5f}, Untold{});
    std::fill_n(screen.visible.row(3), 64, keyOf(kEmpty, 0));  // whoever reads is misled
    EXPECT_TRUE(screen.pyramid.hides({0, 0, 16, 16}, 0.4f));
    EXPECT_EQ(screen.pyramid.stored(Pyramid::kTileLevel + 1).row(0)[0], 0.5f);

    Screen fresh(64, 32);
    fresh.write({0, 0, 16, 16}, 0.5f);
    for (const int y : {0, 8}) fresh.pyramid.drawnTiles(0, y, std::array{0.5f, 0.5f}, Untold{});
    EXPECT_TRUE(fresh.pyramid.hides({0, 0, 16, 16}, 0.4f));
    EXPECT_EQ(fresh.pyramid.stored(Pyramid::kTileLevel + 1).row(0)[0], 0.5f);
}

TEST(Pyramid, AtFullSpeedACornerOfTheBoxAnswersWhereWhoeverListensSeesCellsBroughtUpToDate)
{
    const PixelBox box{4, 4, 44, 44};
    for (const int x : {box.x0, box.x1 - 1})
        for (const int y : {box.y0, box.y1 - 1}) {
            Screen silent(64, 64), heard(64, 64);
            int    writes = 0;
            for (Screen* screen : {&silent, &heard}) {  // all but this corner is in front
                for (int line = 0; line < 64; ++line)
                    for (int column = 0; column < 64; ++column)
                        if (column != x || line != y) screen->write({column, line, column + 1, line + 1}, 0.5f);
                screen->pyramid.touched({0, 0, 64, 64});
            }
            EXPECT_FALSE(silent.pyramid.ask(box, 0.4f, WholeBox{}, Untold{}).hidden) << x << ' ' << y;
            EXPECT_FALSE(heard.pyramid.ask(box, 0.4f, WholeBox{}, [&](const CellWrite&) { ++writes; }).hidden)
                << x << ' ' << y;
            EXPECT_GT(writes, 0) << x << ' ' << y;
            const auto stored = silent.pyramid.stored(Pyramid::kTileLevel);
            for (int row = 0; row < stored.height; ++row)
                EXPECT_EQ(std::ranges::count(stored.row(row), kEmpty), stored.width) << x << ' ' << y;
        }
}

TEST(Pyramid, D3EveryCellOfAnySizeIsTheMinimumOfThePixelsThatExistOnceAQueryNeededIt)
{
    for (const auto& [width, height] : kSizes) {
        const int first = height > 10 ? 8 : 0;
        Random    random(static_cast<std::uint64_t>(width + height));
        Screen    screen(width, height, first, height, 0.0f);
        for (int y = first; y < height; ++y)
            for (int x = 0; x < width; ++x)
                screen.visible.row(y)[x] = keyOf(static_cast<float>(random.between(0.1, 1)), 0);
        screen.pyramid.allTouched();
        int refreshed = 0;
        for (int level = Pyramid::kTileLevel; level < screen.pyramid.levels(); ++level) {
            const auto stored = screen.pyramid.stored(level);
            ASSERT_EQ(stored.width, (width + (1 << level) - 1) >> level);
            ASSERT_EQ(stored.height, (height - first + (1 << level) - 1) >> level);
            for (int y = 0; y < stored.height; ++y)
                for (int x = 0; x < stored.width; ++x) {
                    const PixelBox box = screen.cell(level, x, y);
                    // Hidden by a hair, so that no pixel denies it: all of it is looked at.
                    const auto query = screen.pyramid.ask(box, std::nextafter(screen.farthest(box), 0.0f));
                    ASSERT_TRUE(query.hidden);
                    if (query.level != level) continue;  // a cell that the border cuts is asked about further down
                    const bool isFew = (box.x1 - box.x0) * (box.y1 - box.y0) <= Pyramid::kFewPixels;
                    if (level == Pyramid::kTileLevel && isFew) continue;  // read without their tile
                    ++refreshed;
                    ASSERT_EQ(stored.at(x, y), screen.farthest(box)) << width << 'x' << height << ", level " << level;
                    ASSERT_EQ(query.value, screen.farthest(box));
                }
        }
        EXPECT_TRUE(refreshed > 0 || width * height <= Pyramid::kFewPixels) << width << 'x' << height;
        expectNoCellTooNear(screen);
    }
}

TEST(Pyramid, D1AnOccluderOnTileBordersHidesItsOwnBoxAndNotOneAPixelWider)
{
    for (int level = 0; level <= 8; ++level)
        for (const int first : {0, 8}) {
            const int side = 1 << level;
            Screen    screen(800, 800 + first, first, 800 + first, 0.0f);
            for (const int times : {1, 2}) {
                const PixelBox tile{side, first + side, side + times * side, first + side + times * side};
                screen.draw(tile, 0.5f);
                expectExact(screen, tile, 0.25f, "its own box");
                EXPECT_TRUE(screen.pyramid.hides(tile, 0.25f)) << level;
                for (const PixelBox& wider : {PixelBox{tile.x0 - 1, tile.y0, tile.x1, tile.y1},
                                              PixelBox{tile.x0, tile.y0 - 1, tile.x1, tile.y1},
                                              PixelBox{tile.x0, tile.y0, tile.x1 + 1, tile.y1},
                                              PixelBox{tile.x0, tile.y0, tile.x1, tile.y1 + 1}})
                    EXPECT_FALSE(screen.pyramid.hides(wider, 0.25f)) << level;
            }
        }
}

TEST(Pyramid, D2AHoleOfOnePixelIsFoundInEveryCornerOfEveryCell)
{
    constexpr int kSide = 131;
    for (int level = 0; level < 8; ++level)
        for (int corner = 0; corner < 4; ++corner) {
            // The four pixels that meet at the corner where four cells of this level meet.
            const int x = (1 << level) - (corner & 1), y = (1 << level) - (corner >> 1);
            if (x >= kSide || y >= kSide) continue;
            Screen screen(kSide, kSide);
            screen.draw({0, 0, kSide, y}, 0.5f), screen.draw({0, y + 1, kSide, kSide}, 0.5f);
            screen.draw({0, y, x, y + 1}, 0.5f), screen.draw({x + 1, y, kSide, y + 1}, 0.5f);
            EXPECT_FALSE(screen.pyramid.hides(screen.region(), 0.25f)) << x << ' ' << y;
            EXPECT_FALSE(screen.pyramid.hides({x, y, x + 1, y + 1}, 0.25f)) << x << ' ' << y;
            for (int reach = 1; reach < kSide; reach *= 2) {
                const PixelBox over{std::max(0, x - reach), std::max(0, y - reach), std::min(kSide, x + reach),
                                    std::min(kSide, y + reach)};
                EXPECT_FALSE(screen.pyramid.hides(over, 0.25f));
                if (x > 0) {
                    EXPECT_TRUE(screen.pyramid.hides({std::max(0, x - reach), over.y0, x, over.y1}, 0.25f));
                }
                if (y > 0) {
                    EXPECT_TRUE(screen.pyramid.hides({over.x0, std::max(0, y - reach), over.x1, y}, 0.25f));
                }
            }
            screen.draw({x, y, x + 1, y + 1}, 0.5f);
            EXPECT_TRUE(screen.pyramid.hides(screen.region(), 0.25f)) << "the hole is closed";
        }
}

TEST(Pyramid, D4AndD5EqualDepthIsNotHiddenAndOneStepFartherIs)
{
    Screen screen(100, 60);
    for (const float depth : {0.25f, 0.3f, 0.9999999f}) {
        screen.draw(screen.region(), depth);
        for (const PixelBox& box : {PixelBox{0, 0, 1, 1}, PixelBox{3, 5, 61, 60}, screen.region()}) {
            EXPECT_FALSE(screen.pyramid.hides(box, depth)) << "it may still win by its id";
            EXPECT_FALSE(screen.pyramid.hides(box, std::nextafter(depth, 2.0f)));
            EXPECT_TRUE(screen.pyramid.hides(box, std::nextafter(depth, 0.0f)));
        }
    }
}

TEST(Pyramid, D7ABoxAsWideAsThePictureIsAnsweredThoughOnePixelDecides)
{
    for (const int width : {1023, 1024, 1025, 4097}) {
        Screen screen(width, 9);
        for (const int hole : {0, width / 2 - 1, width / 2, width - 1}) {
            screen.pyramid.reset(screen.visible, 0, 9);
            screen.visible.clearRows(0, 9);
            if (hole > 0) screen.draw({0, 3, hole, 5}, 0.5f);
            if (hole < width - 1) screen.draw({hole + 1, 3, width, 5}, 0.5f);
            screen.draw({hole, 3, hole + 1, 4}, 0.5f);
            EXPECT_TRUE(screen.pyramid.hides({0, 3, width, 4}, 0.25f)) << width << ' ' << hole;
            EXPECT_FALSE(screen.pyramid.hides({0, 3, width, 5}, 0.25f)) << width << ' ' << hole;
            if (hole > 0) {
                EXPECT_TRUE(screen.pyramid.hides({0, 3, hole, 5}, 0.25f));
            }
            if (hole < width - 1) {
                EXPECT_TRUE(screen.pyramid.hides({hole + 1, 3, width, 5}, 0.25f));
            }
        }
    }
}

/// D9: far to near, so that every write changes something.
TEST(Pyramid, PushingKeepsEveryCellTheMinimumOfItsPixelsAndStopsAtTheFirstLevelThatDoesNotChange)
{
    for (const auto& [width, height] : kSizes)
        for (const bool fromFarthest : {false, true}) {
            SCOPED_TRACE(testing::Message()
                         << width << 'x' << height << (fromFarthest ? ", from the farthest corner" : ""));
            const int first = height > 10 ? 8 : 0;
            Random    random(static_cast<std::uint64_t>(width * 8192 + height));
            Screen    screen(width, height, first, height, 0.0f);
            const int steps = width > 500 ? 12 : 60;
            for (int i = 0; i < steps; ++i) {
                const PixelBox box   = screen.anyBox(random);
                const auto     depth = static_cast<float>(i + 1) / static_cast<float>(steps);
                for (int y = box.y0; y < box.y1; ++y)
                    std::fill_n(screen.visible.row(y) + box.x0, box.x1 - box.x0, keyOf(depth, 0));
                std::vector<CellWrite> writes;
                const auto             told = [&writes](const CellWrite& write) { writes.push_back(write); };
                if (fromFarthest)
                    screen.pyramid.pushFrom(
                        box, {.fromRight = random.below(2) == 0, .fromBottom = random.below(2) == 0}, told);
                else
                    screen.pyramid.push(box, told);
                for (std::size_t w = 0; w + 1 < writes.size(); ++w) {
                    if (writes[w + 1].level == Pyramid::kTileLevel) continue;
                    if (writes[w + 1].level != writes[w].level + 1) {  // the first step up from a tile written before
                        EXPECT_TRUE(fromFarthest && writes[w + 1].level == Pyramid::kTileLevel + 1);
                        continue;
                    }
                    if (writes[w].level == Pyramid::kTileLevel && fromFarthest) continue;
                    EXPECT_NE(writes[w].before, writes[w].after)
                        << "only a cell that changed is followed by the one above";
                    EXPECT_EQ(writes[w + 1].x, writes[w].x / 2);
                    EXPECT_EQ(writes[w + 1].y, writes[w].y / 2);
                }
                for (int level = Pyramid::kTileLevel; level < screen.pyramid.levels(); ++level) {
                    const auto stored = screen.pyramid.stored(level);
                    for (int y = 0; y < stored.height; ++y)
                        for (int x = 0; x < stored.width; ++x)
                            ASSERT_EQ(stored.at(x, y), screen.farthest(screen.cell(level, x, y)))
                                << level << ": " << x << ' ' << y;
                }
            }
        }
}

TEST(Pyramid, ACompleteOneAnswersByItsCellsAloneHoweverThePixelsChange)
{
    Screen screen(67, 41);
    screen.draw({0, 0, 67, 20}, 0.5f);
    screen.pyramid.complete();
    EXPECT_TRUE(screen.pyramid.continues(screen.visible, 0, 41));
    EXPECT_FALSE(screen.pyramid.continues(screen.visible, 0, 40)) << "another stripe";
    VisibilityBuffer next;
    next.resize(67, 41, DepthEncoding::withBackground(kEmpty));
    next.clearRows(0, 41);
    ASSERT_TRUE(screen.pyramid.continues(next, 0, 41));
    EXPECT_TRUE(screen.pyramid.hides({3, 0, 60, 16}, 0.25f))
        << "whole tiles of what was drawn, though the pixels are empty now";
    EXPECT_FALSE(screen.pyramid.hides({3, 0, 60, 18}, 0.25f))
        << "a tile that was half drawn hides nothing, nor does its drawn half";
    EXPECT_FALSE(screen.pyramid.hides({3, 0, 60, 16}, 0.5f));
    for (int y = 0; y < 41; ++y) std::fill_n(next.row(y), 67, keyOf(0.9f, 0));
    EXPECT_FALSE(screen.pyramid.hides({3, 24, 60, 32}, 0.25f)) << "nothing was there";
    VisibilityBuffer wider;
    wider.resize(68, 41, DepthEncoding::withBackground(kEmpty));
    EXPECT_FALSE(screen.pyramid.continues(wider, 0, 41));
    screen.pyramid.reset(next, 0, 41);
    EXPECT_FALSE(screen.pyramid.continues(next, 0, 41)) << "a frame that is being drawn";
}

TEST(Pyramid, BackgroundHidesOnlyWhatTheFarTestDrops)
{
    Screen screen(20, 20);
    EXPECT_FALSE(screen.pyramid.hides(screen.region(), std::nextafter(kEmpty, 1.0f)))
        << "the farthest depth that is kept";
    EXPECT_TRUE(screen.pyramid.hides(screen.region(), std::nextafter(kEmpty, 0.0f)));
}

TEST(Pyramid, AFullPictureIsDecidedByOneCellAndAnotherFrameBeginsEmpty)
{
    Screen screen(1024, 512);
    screen.draw(screen.region(), 0.5f);
    EXPECT_TRUE(screen.pyramid.hides(screen.region(), 0.25f));
    EXPECT_EQ(screen.pyramid.ask({0, 0, 512, 512}, 0.25f).cells, 1);
    EXPECT_LE(screen.pyramid.ask({500, 100, 530, 120}, 0.25f).cells, 4);
    screen.visible.clearRows(0, 512);
    screen.pyramid.reset(screen.visible, 0, 512);
    EXPECT_FALSE(screen.pyramid.hides({3, 3, 4, 4}, 0.25f));
}

}  // namespace
}  // namespace zscope
