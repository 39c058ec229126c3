// Interval scanline: between two neighbouring active edges the same polygons are open, so the nearest of them is found
// once for the whole interval, mostly without a z-buffer.
//
// Nearest    judged at both end pixels. Depth is affine along the line, so a polygon that leads every rival by more
//            than two float32 steps at both ends, with no depth clamped there to those of the polygon's corners, leads
//            everywhere between
// Crossing   an interval without such a leader (polygons that cross, touch or are equally near) is compared pixel by
//            pixel: that is where the textbook's one test per interval goes wrong
// Patterns   a polygon with holes or a relief covers no interval whole, so it does not lead
// Cost       per interval about four depths per open polygon; a line with more than 256 polygons open at once is
//            resolved like a line of the scanline z-buffer, whose cost does not grow with the number of intervals
// Source     Watkins: A Real Time Visible Surface Algorithm, 1970; docs/correctness.md, Rules that make methods exact
#pragma once

#include "core/plain/work.h"
#include "core/sweep/interval_reason.h"

namespace zscope::plain {

/// The part resolveLine of the interval scanline.
void resolveByIntervals(Call work, int y);

}  // namespace zscope::plain

namespace zscope::fates {
inline constexpr PixelFate kIntervalLost{"interval-lost", "lay behind the leader of an interval", FateKind::Behind, 2,
                                         true};
}

namespace zscope::plain {

/// The pixels [x0, x1) between two neighbouring active edges of line y are decided; never empty.
struct IntervalDecided {
    static constexpr Grain         grain = Grain::Interval;
    int                            y, x0, x1;
    std::span<const std::uint32_t> open;  // polygons of the edge table; valid only during the call, like the next
    std::span<const Polygon>       polygons;
    const Polygon*                 winner;  // nullptr: the open polygons were compared pixel by pixel
    IntervalReason                 reason;

    About       about() const { return {.line = y, .pixels = PixelBox{x0, y, x1, y + 1}, .interval = wordOf(reason)}; }
    std::string sentence(const Telling& telling) const;
    void        mean(Meanings& to) const;
};

}  // namespace zscope::plain
