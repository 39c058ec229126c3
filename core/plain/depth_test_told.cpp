// What the depth test says of a fragment.
#include <fmt/format.h>

#include "core/probe/words.h"
#include "core/scan/pixel_events.h"

namespace zscope {

namespace {

/// What the moment of shading meant for this fragment, as the end of its sentence.
std::string shadingOf(const PixelTested& p)
{
    if (p.discarded && p.shading == ShadingMoment::BeforeTest) return ", which its shader finds out before the test.";
    if (p.discarded) return "; it passed the test, so nothing may be written before the hole is known.";
    if (p.shading == ShadingMoment::Never || p.keep == Keep::DepthOnly) return ".";
    if (!p.won && p.shaded && p.moved && p.shading != ShadingMoment::BeforeTest)
        return "; where its triangle is it passed, so it was shaded, and only its shader knew how far back it lies.";
    if (!p.won) return p.shaded ? "; it was shaded although hidden." : "; it is never shaded.";
    if (!p.shaded) return ".";
    return p.shading == ShadingMoment::BeforeTest ? "; its colour was ready before the test."
                                                  : "; only now is it shaded.";
}

/// What the test found, without the end of the sentence.
std::string testOf(const PixelTested& p, const Telling& telling)
{
    const std::string_view name      = telling.polygon();
    const auto             movedFrom = [&p]() -> std::string {
        if (!p.moved) return {};
        if (p.unmovedDepth == p.depth) return " (as its material's relief leaves it)";
        return fmt::format(" (moved back from {:.7g} by its material's relief)", p.unmovedDepth);
    };
    const std::string who = fmt::format("Pixel ({}, {}): {} {}, depth {:.7g}{},", p.x, p.y, name,
                                        grouped(p.triangle.value), p.depth, movedFrom());
    if (p.discarded) return who + " lies in a hole of its material: the fragment does not exist";
    if (p.keep == Keep::DepthOnly)
        return who
               + (p.won ? " is the nearest so far: the pre-pass keeps its depth and asks nobody's name"
                        : " is not nearer than what the pre-pass has kept");
    if (p.keep == Keep::Equal && p.won)
        return who + " has exactly the depth that the pre-pass kept, so it is the one that is seen";
    if (p.keep == Keep::Equal && p.rivalRank == 0)
        return who + " is farther than the depth that the pre-pass kept and is hidden";
    if (p.rivalRank == 0 && p.won) return who + " takes it from the background";
    if (p.rivalRank == 0) return who + " lies beyond the far plane and is not kept";
    const std::string rival = fmt::format("{} {}", name, grouped(p.rivalRank - 1));
    if (p.depth == p.rivalDepth) {
        return who
               + (p.won ? fmt::format(" is as near as {} and takes it: on equal depth the lower id wins", rival)
                        : fmt::format(" is as near as {} and loses: on equal depth the lower id wins", rival));
    }
    if (p.won) return who + fmt::format(" is nearer than {} at {:.7g} and takes it", rival, p.rivalDepth);
    return who + fmt::format(" is farther than {} at {:.7g} and is hidden", rival, p.rivalDepth);
}

}  // namespace

std::string PixelTested::sentence(const Telling& telling) const { return testOf(*this, telling) + shadingOf(*this); }

}  // namespace zscope
