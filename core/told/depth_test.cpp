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
                                        withCommas(p.triangle.value), p.depth, movedFrom());
    if (p.discarded) return who + " lies in a hole of its material: the fragment does not exist";
    if (p.keep == Keep::DepthOnly)
        return who
               + (p.won ? " is the nearest so far: the pre-pass keeps its depth and no id"
                        : " is not nearer than what the pre-pass has kept");
    if (p.keep == Keep::Equal && p.won)
        return who + " has exactly the depth that the pre-pass kept, so it is the one that is seen";
    if (p.keep == Keep::Equal && p.rivalRank == 0)
        return who + " is farther than the depth that the pre-pass kept and is hidden";
    if (p.rivalRank == 0 && p.won) return who + " takes it from the background";
    if (p.rivalRank == 0 || (p.keep == Keep::Over && !p.won)) return who + " lies beyond the far plane and is not kept";
    const std::string rival = fmt::format("{} {}", name, withCommas(p.rivalRank - 1));
    if (p.keep == Keep::Over)
        return who + fmt::format(" is painted over {} at {:.7g}: no depth is compared", rival, p.rivalDepth);
    if (p.spoilt.keepsFarthest && p.depth != p.rivalDepth && p.won == (p.depth < p.rivalDepth))
        return who
               + (p.won ? fmt::format(" is farther than {} at {:.7g} and takes it: the farther one wins (a fault)",
                                      rival, p.rivalDepth)
                        : fmt::format(" is nearer than {} at {:.7g} and loses: the farther one wins (a fault)", rival,
                                      p.rivalDepth));
    if (p.depth == p.rivalDepth) {
        return who
               + (p.won ? fmt::format(" is as near as {} and takes it: on equal depth the lower id wins", rival)
                        : fmt::format(" is as near as {} and loses: on equal depth the lower id wins", rival));
    }
    if (p.won) return who + fmt::format(" is nearer than {} at {:.7g} and takes it", rival, p.rivalDepth);
    return who + fmt::format(" is farther than {} at {:.7g} and is hidden", rival, p.rivalDepth);
}

TriangleId rivalOf(const PixelTested& e) { return {e.rivalRank - 1}; }

std::string_view tieRule(const PixelTested& e)
{
    return e.spoilt.firstComerStays ? "on equal depth the first comer keeps it (a fault)"
                                    : "on equal depth the lower id wins";
}

std::string wonBy(const PixelTested& e, const std::string& who, const Telling& telling)
{
    if (e.keep == Keep::DepthOnly)
        return fmt::format("{}, near/z {:.9g}, is the nearest so far: the pre-pass keeps its depth and no id.", who,
                           e.depth);
    if (e.keep == Keep::Equal && e.rivalRank == 0)
        return fmt::format("{} has exactly the depth that the pre-pass kept, {:.9g}, so the pixel is its own.", who,
                           e.depth);
    if (e.rivalRank == 0) return fmt::format("{}, near/z {:.9g}, takes the pixel from the background.", who, e.depth);
    const std::string rival = telling.nameOf(rivalOf(e));
    if (e.keep == Keep::Over)
        return fmt::format("{}, near/z {:.9g}, is painted over {} at {:.9g}: no depth is compared.", who, e.depth,
                           rival, e.rivalDepth);
    if (e.spoilt.drawsOver)
        return fmt::format("{} comes after {} in the file and is drawn over it without a test (a fault).", who, rival);
    if (e.depth == e.rivalDepth)
        return fmt::format("{} is as near as {}, {:.9g}, and takes the pixel: {}.", who, rival, e.depth, tieRule(e));
    if (e.spoilt.keepsFarthest)
        return fmt::format("{} at {:.9g} takes the pixel from {} at {:.9g}: the farther one wins (a fault).", who,
                           e.depth, rival, e.rivalDepth);
    return fmt::format("{}, near/z {:.9g}, takes the pixel from {} at {:.9g}: it is {} nearer.", who, e.depth, rival,
                       e.rivalDepth, countedSteps(e.depth, e.rivalDepth));
}

std::string lostBy(const PixelTested& e, const std::string& who, const Telling& telling)
{
    if (e.keep == Keep::DepthOnly)
        return fmt::format("{}, near/z {:.9g}, is not nearer than {:.9g}, which the pre-pass has kept.", who, e.depth,
                           e.rivalDepth);
    if (e.spoilt.drawsOver && e.rivalRank != 0)
        return fmt::format("{} comes before {} in the file, which stays drawn over it (a fault).", who,
                           telling.nameOf(rivalOf(e)));
    if (e.spoilt.equalWantsNearer && e.depth == e.rivalDepth)
        return fmt::format(
            "{} has exactly the depth that the pre-pass kept, {:.9g}, and loses: the second pass wants a nearer one (a "
            "fault).",
            who, e.depth);
    if (e.spoilt.keepsFarthest && e.rivalRank != 0 && e.depth > e.rivalDepth)
        return fmt::format("{} at {:.9g} loses the pixel to {} at {:.9g}: the farther one wins (a fault).", who,
                           e.depth, telling.nameOf(rivalOf(e)), e.rivalDepth);
    if (e.depth > e.rivalDepth)
        return fmt::format(
            "{}, near/z {:.9g}, is nearer than {}: it has a hole here, so the pre-pass left it out, and it does not "
            "have the depth that was kept.",
            who, e.depth,
            e.rivalDepth <= telling.background()
                ? std::string("the background, which is all there is")
                : fmt::format("the depth {:.9g} that the pre-pass kept", e.rivalDepth));
    if (e.keep == Keep::Over || (e.rivalDepth <= telling.background() && e.rivalRank == 0))
        return fmt::format("{}, near/z {:.9g}, lies beyond the far plane and is not kept.", who, e.depth);
    const std::string holder = e.rivalRank != 0           ? "of " + telling.nameOf(rivalOf(e))
                               : e.spoilt.keepsLastDepths ? std::string("that the frame before has left")
                                                          : std::string("that the pre-pass kept");
    if (e.depth == e.rivalDepth)
        return fmt::format("{} is exactly as near as the depth {}, {:.9g}, and loses: {}.", who, holder, e.depth,
                           tieRule(e));
    return fmt::format("{}, near/z {:.9g}, loses the depth test: the depth {} is {:.9g}, {} nearer.", who, e.depth,
                       holder, e.rivalDepth, countedSteps(e.depth, e.rivalDepth));
}

/// `who` held the pixel.
std::string overtakenBy(const PixelTested& e, const std::string& who, const Telling& telling)
{
    const std::string winner = capital(telling.nameOf(e.triangle));
    if (e.keep == Keep::Over)
        return fmt::format("{}, near/z {:.9g}, is painted over {} at {:.9g}: no depth is compared.", winner, e.depth,
                           who, e.rivalDepth);
    if (e.spoilt.drawsOver)
        return fmt::format("{} comes after {} in the file and is drawn over it without a test (a fault).", winner, who);
    if (e.depth == e.rivalDepth)
        return fmt::format("{} is as near, {:.9g}, and takes the pixel from {}: {}.", winner, e.depth, who, tieRule(e));
    if (e.spoilt.keepsFarthest)
        return fmt::format("{} at {:.9g} takes the pixel from {} at {:.9g}: the farther one wins (a fault).", winner,
                           e.depth, who, e.rivalDepth);
    return fmt::format("{} at {:.9g} takes the pixel from {} at {:.9g}: it is {} nearer.", winner, e.depth, who,
                       e.rivalDepth, countedSteps(e.rivalDepth, e.depth));
}

/// What a fragment that lost comes to.
PixelFate fateOf(const PixelTested& e, const Telling& telling)
{
    if (e.keep == Keep::Over) return fates::kBeyondFar;
    if (e.spoilt.keepsFarthest && e.depth > e.rivalDepth) return fates::kFarther;
    if (e.depth > e.rivalDepth) return fates::kHole;  // after a pre-pass that left it out
    if (e.rivalRank == 0 && e.rivalDepth <= telling.background()) return fates::kBeyondFar;
    return e.depth == e.rivalDepth ? fates::kLostTie : fates::kFarther;
}

Meaning meaningOf(const PixelTested& e, TriangleId polygon, const Telling& telling)
{
    const std::string who = capital(telling.nameOf(polygon));
    Meaning           meaning{.depth = e.depth};
    if (e.moved) meaning.unmovedDepth = e.unmovedDepth;
    if (e.rivalRank != 0) meaning.rival = rivalOf(e);
    if (e.discarded) {
        meaning.fate = fates::kHole;
        meaning.sentence =
            who + " has a hole at this pixel: the fragment does not exist, so it is out before it could win.";
        return meaning;
    }
    meaning.rivalDepth = e.rivalDepth;
    if (!e.won) meaning.fate = fateOf(e, telling);
    meaning.sentence = e.won ? wonBy(e, who, telling) : lostBy(e, who, telling);
    return meaning;
}

}  // namespace

std::string PixelTested::sentence(const Telling& telling) const { return testOf(*this, telling) + shadingOf(*this); }

void PixelTested::mean(Meanings& to) const
{
    const PixelBox here{x, y, x + 1, y + 1};
    if (!to.asksAbout(here)) return;
    const bool isPrepass = keep == Keep::DepthOnly;
    if (won && !isPrepass && rivalRank != 0)
        to.of(rivalOf(*this), here, {.word = "overtaken", .effect = Effect::Overtaken},
              [&](TriangleId loser, PixelPosition) {
                  return Meaning{.depth      = rivalDepth,
                                 .rival      = triangle,
                                 .rivalDepth = depth,
                                 .fate       = fates::kOverwritten,
                                 .sentence   = overtakenBy(*this, to.telling().nameOf(loser), to.telling())};
              });
    const Outcome outcome{.word      = discarded ? "discarded"
                                       : won     ? "won"
                                                 : "lost",
                          .effect    = discarded ? Effect::IsAbsent
                                       : won     ? Effect::Wins
                                                 : Effect::Loses,
                          .countedAs = {isPrepass ? "prepass_tested" : "tested", !won        ? ""
                                                                                 : isPrepass ? "prepass_passed"
                                                                                             : "passed"}};
    to.of(triangle, here, outcome,
          [&](TriangleId polygon, PixelPosition) { return meaningOf(*this, polygon, to.telling()); });
}

}  // namespace zscope
