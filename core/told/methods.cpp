// What the methods say of a triangle, a span, a recalled node and a blended pixel.
#include <fmt/format.h>

#include "core/cull/cull_events.h"
#include "core/method/scanline.h"
#include "core/probe/words.h"
#include "core/scan/pixel_events.h"
#include "core/sweep/blend_events.h"

namespace zscope {

std::string TriangleFinished::sentence(const Telling& telling) const
{
    return fmt::format("Triangle {} is drawn: it is nearest so far at {}.", withCommas(triangle.value),
                       counted(telling.pixelsWon(), "pixel", "pixels"));
}

std::string SpanFilled::sentence(const Telling& telling) const
{
    const std::string pixels = x1 - x0 == 1 ? fmt::format("pixel {}", x0) : fmt::format("pixels {} to {}", x0, x1 - 1);
    if (isInterval)
        return fmt::format(
            "Between two neighbouring edges {} {} is the nearest that is open: {} of line {} {} its own.",
            telling.polygon(), withCommas(triangle.value), pixels, y, x1 - x0 == 1 ? "is" : "are");
    return fmt::format("{} {} covers {} of its line: those whose centres lie between its left and right edge.",
                       capital(std::string(telling.polygon())), withCommas(triangle.value), pixels);
}

std::string NodeRecalled::sentence(const Telling&) const
{
    return capital(nameInWords(place)) + " was visible in the last frame: the first pass draws it without asking.";
}

void NodeRecalled::mean(Meanings& to) const
{
    to.below(place, {.word = "node-recalled", .isOfAll = true}, [&](TriangleId id, PixelPosition) {
        return Meaning{.sentence = fmt::format(
                           "{}, which holds {}, was visible in the last frame: the first pass draws it without asking.",
                           capital(nameInWords(place)), to.telling().nameOf(id))};
    });
}

std::string PixelBlended::sentence(const Telling&) const
{
    return fmt::format("Pixel ({}, {}): {} nearer than its opaque depth, blended over its colour, {}.", x, y,
                       counted(surfaces, "transparent surface is", "transparent surfaces are"),
                       order == BlendOrder::Sorted ? "farthest first" : "back faces before front faces");
}

namespace plain {

std::string sentenceOfEdgeTable(std::uint64_t edges)
{
    return fmt::format("The edge table is complete: {} in the buckets of their first lines, none active yet.",
                       counted(edges, "edge waits", "edges wait"));
}

}  // namespace plain

}  // namespace zscope
