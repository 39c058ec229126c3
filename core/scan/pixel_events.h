// What scan conversion tells: triangles begun and finished, tiles and spans, pixels tested.
#pragma once

#include <cstdint>
#include <string>

#include "core/geometry/screen_triangle.h"
#include "core/probe/about.h"
#include "core/probe/grain.h"
#include "core/probe/meaning.h"
#include "core/probe/telling.h"
#include "core/scan/shading_moment.h"

namespace zscope {

/// What becomes of a fragment that is tested.
enum class Keep {
    Nearest,    // the usual test: depth and rank of the winner
    DepthOnly,  // a depth pre-pass: the depth of the winner, no rank
    Equal,  // after a pre-pass, by plain text only: a fragment wins if it has the kept depth; of several, the lowest
            // rank. (In lanes Nearest finds the same winner: see lowerHalf() in core/fast/lanes/depth_test-inl.h.)
    Over,   // a painter's: depth and rank of the one that comes last, without a test; by plain text only
};

namespace fates {
inline constexpr PixelFate kFarther{"farther", "lost the depth test", FateKind::Behind, 0, true};
inline constexpr PixelFate kLostTie{"lost-tie", "lost by id at equal depth", FateKind::Behind, 1};
inline constexpr PixelFate kHole{"hole", "has a hole there", FateKind::Absent, 0};
inline constexpr PixelFate kBeyondFar{"beyond-far", "beyond far", FateKind::NotKept, 0};
inline constexpr PixelFate kTileRejected{"tile-rejected", "rejected with a tile", FateKind::Hidden, 0, true};
}  // namespace fates

/// A stream method is about to turn this triangle (or clipped part) into pixels.
struct TriangleReached {
    const ScreenTriangle& triangle;  // valid only during the call
};

/// All pixels of the triangle reached last have been tested.
struct TriangleFinished {
    static constexpr Grain grain = Grain::Triangle;
    TriangleId             triangle;

    About       about() const { return {.triangle = triangle}; }
    std::string sentence(const Telling& telling) const;
};

/// Pixels [x0, x1) of line y have been offered to the triangle's depth test; never empty.
struct SpanFilled {
    static constexpr Grain grain = Grain::Span;
    int                    y, x0, x1;
    TriangleId             triangle;
    bool                   isInterval = false;  // it is the nearest between two neighbouring edges

    About       about() const { return {.line = y, .pixels = PixelBox{x0, y, x1, y + 1}, .triangle = triangle}; }
    std::string sentence(const Telling& telling) const;
};

/// Rules of the depth test that faults have changed.
struct SpoiltTest {
    bool firstComerStays  = false;  // on equal depth, whatever the ids
    bool drawsOver        = false;  // whatever comes later in the file, without a test
    bool equalWantsNearer = false;  // after a pre-pass
    bool keepsLastDepths  = false;  // those of the frame before
    bool keepsFarthest    = false;  // of two depths the farther one
};

/// One covered pixel has been tested against the winner so far.
struct PixelTested {
    static constexpr Grain grain = Grain::Pixel;
    int                    x, y;
    TriangleId             triangle;
    float                  depth;
    bool                   won;
    std::uint32_t          rivalRank;   // who held the pixel: triangle id + 1, or 0 for background
    float                  rivalDepth;  // the buffer's value; for background the one just below every kept depth
    Keep                   keep;
    ShadingMoment          shading;  // of the method, even where no colours are asked for
    bool                   shaded;   // its colour was computed, before the test or because it passed
    // it lies in a hole of its material: before the test, or after passing it
    bool discarded = false;
    // its material's relief was asked: before the test, or after it passed unmoved
    bool       moved        = false;
    float      unmovedDepth = 0;  // if moved: where its triangle is
    SpoiltTest spoilt       = {};

    About about() const
    {
        return {.line = y, .pixels = PixelBox{x, y, x + 1, y + 1}, .triangle = triangle, .won = won};
    }
    std::string sentence(const Telling& telling) const;
    void        mean(Meanings& to) const;
};

/// A tile that the triangle may cover has been compared as a whole: the nearest that the triangle could be inside `box`
/// against the farthest that is stored anywhere in the tile.
struct TileTested {
    static constexpr Grain grain = Grain::Query;
    PixelBox               box;  // the tile's pixels that the triangle may cover
    TriangleId             triangle;
    float                  nearest;
    float                  farthest;
    bool                   rejected;

    About       about() const { return {.pixels = box, .triangle = triangle, .hidden = rejected}; }
    std::string sentence(const Telling& telling) const;
    void        mean(Meanings& to) const;
};

}  // namespace zscope
