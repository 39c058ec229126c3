#include "core/lesson/explain_sentences.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/probe/words.h"

namespace zscope {

namespace {

/// What is drawn: triangles, or faces as they were read.
std::string_view kindOf(const Pipeline& pipeline) { return drawsFaces(pipeline) ? "face" : "triangle"; }

std::string nameOf(TriangleId id, const Pipeline& pipeline)
{
    return fmt::format("{} {}", kindOf(pipeline), withCommas(id.value));
}

}  // namespace

std::string sentenceOf(const TriangleSetUp& e, const std::string& polygon, bool isMirrored)
{
    const std::string who = capital(polygon);
    switch (e.fate) {
        case SetUp::Drawn:
            return e.cut ? who + " is cut at the near plane; what is left of it goes on to the pixels."
                         : who + " is set up and goes on to the pixels.";
        case SetUp::Transparent:
            return who + " is transparent: it is outside ids and depth, and blended afterwards.";
        case SetUp::Outside:
            return who + " is left out at set-up, because a corner of it lies outside the view (a fault).";
        case SetUp::ClippedAway:
            return who + " lies wholly before the near plane: nothing of it is left.";
        case SetUp::BackFacing:
            if (e.isFlipped) return who + " shows its front, is taken for a back face and is left out (a fault).";
            return who
                   + (isMirrored ? " turns counter-clockwise on the grid and its instance is mirrored, so it shows its "
                                   "back, and back faces are culled."
                                 : " turns clockwise on the grid, so it shows its back, and back faces are culled.");
        case SetUp::Degenerate:
            return who + " has no area once its corners are snapped to the grid, so it covers nothing.";
        case SetUp::NoPixelCentre:
            return who + " has no pixel's centre within its box, so it covers nothing.";
        case SetUp::OutOfRange:
            return who + " has a corner beyond the range of the grid and is not drawn.";
    }
    return who;
}

std::string sentenceOf(const PixelCandidate& c, const PixelExplanation& pixel, const Pipeline& pipeline, bool isShaded)
{
    const std::string who = capital(nameOf(c.drawnAs, pipeline));
    if (c.fate == fates::kWinner) {
        const std::string shown = fmt::format("{} is what the picture shows, at near/z {:.9g}", who, pixel.depth);
        if (!c.decisive) return shown + ".";
        return shown + ". " + c.events[*c.decisive].sentence;
    }
    if (c.decisive) return c.events[*c.decisive].sentence;
    if (c.fate == fates::kBlended)
        return fmt::format(
            "Triangle {} has opacity {} and is, at near/z {:.9g}, nearer than the opaque depth {:.9g}: {}.",
            withCommas(c.triangle.value), c.opacityText, c.depth, pixel.depth,
            c.opacity <= 0 ? "its share of the colour is 0, so nothing of it is seen"
            : isShaded     ? "it is blended over the colour, the farthest first"
                           : "it would be blended over the colour, but no colours were asked for");
    if (c.fate == fates::kBehindOpaque)
        return fmt::format(
            "Triangle {} has opacity {}, but is at near/z {:.9g} not nearer than the opaque depth {:.9g}, so "
            "nothing of it is blended.",
            withCommas(c.triangle.value), c.opacityText, c.depth, pixel.depth);
    if (c.fate == fates::kNearClip)
        return fmt::format(
            "Triangle {} would meet this pixel before the near plane (near/z would be {:.9g}, above 1): that part "
            "of it is cut away.",
            withCommas(c.triangle.value), c.depth);
    if (c.fate == fates::kBackFace)
        return fmt::format("Triangle {} shows its back here, and back faces are culled.", withCommas(c.triangle.value));
    if (c.fate == fates::kBatchOutside)
        return who + " was never set up: the batch of triangles that holds it lies outside the view.";
    if (c.cover == Cover::Hole) return who + " has a hole at this pixel, so it does not cover it.";
    if (drawsFaces(pipeline))
        return fmt::format(
            "{} is filled by the winding of its outline, which does not go round this pixel's centre, although "
            "triangle {} covers it.",
            who, withCommas(c.triangle.value));
    return who + " covers this pixel by the definition, but this method fills it by another rule and left it out.";
}

std::string sentenceOf(const PixelExplanation& e, const Pipeline& pipeline)
{
    const std::string where = fmt::format("Pixel ({}, {}) shows ", e.pixel.x, e.pixel.y);
    const std::string what =
        e.winner < 0 ? std::string("the background")
                     : fmt::format("{} at near/z {:.9g}",
                                   nameOf(TriangleId{static_cast<std::uint32_t>(e.winner)}, pipeline), e.depth);
    std::string text = where + what + ". ";
    if (e.candidates.empty()) return text + "No triangle meets it.";
    text += counted(e.candidates.size(), "triangle meets it: ", "triangles meet it: ");
    std::vector<std::pair<PixelFate, std::uint64_t>> counts;
    for (const PixelCandidate& c : e.candidates) {
        const auto known = std::ranges::find_if(counts, [&c](const auto& each) { return each.first == c.fate; });
        if (known == counts.end())
            counts.emplace_back(c.fate, 1);
        else
            ++known->second;
    }
    std::ranges::sort(counts, {},
                      [](const auto& each) { return std::tuple(each.first.kind, each.first.place, each.first.word); });
    for (const auto& [fate, count] : counts)
        text += fmt::format("{}{} {}", fate == counts.front().first ? "" : ", ", withCommas(count), fate.countedAs);
    return text + ".";
}

std::string sentenceOf(const TriangleExplanation& e, const Pipeline& pipeline)
{
    const TriangleTally& t   = e.tally;
    const std::string    who = "Triangle " + withCommas(e.triangle.value);
    const std::string    seen =
        e.drawnAs == e.triangle ? "" : fmt::format(", drawn as part of face {},", withCommas(e.drawnAs.value));
    if (t.covered == 0) {
        if (t.backFacing > 0)
            return fmt::format("{}{} shows its back at {}, and back faces are culled.", who, seen,
                               counted(t.backFacing, "pixel", "pixels"));
        if (t.inHoles > 0)
            return fmt::format("{}{} meets {}, all of them in holes of its material.", who, seen,
                               counted(t.inHoles, "pixel", "pixels"));
        if (t.beyondFar > 0)
            return fmt::format("{}{} meets {}, all of them beyond the far plane.", who, seen,
                               counted(t.beyondFar, "pixel", "pixels"));
        for (const Event& event : e.events)
            if (event.word == kSetUpWord && event.effect == Effect::Ends) return event.sentence;
        return fmt::format(
            "{}{} covers no pixel of the picture: it lies outside of it, or between the centres of its pixels.", who,
            seen);
    }
    const std::string covers = fmt::format("{}{} covers {}", who, seen, counted(t.covered, "pixel", "pixels"));
    if (e.isTransparent)
        return covers + fmt::format(" and has opacity {}: ", e.opacityText)
               + (e.opacity <= 0 ? "nothing of it is seen."
                                 : "it is outside ids and depth, and blended where it is nearer than the opaque "
                                   "picture.");
    if (t.shown == t.covered && e.drawnAs == e.triangle) return covers + " and is seen at all of them.";
    std::string text = covers + fmt::format(" and is seen at {} of them", withCommas(t.shown));
    if (!e.takers.empty()) {
        const Taker& most = e.takers.front();
        text += most.id < 0 ? fmt::format("; {} show the background", withCommas(most.pixels))
                            : fmt::format("; most of the others, {}, show {}", withCommas(most.pixels),
                                          nameOf(TriangleId{static_cast<std::uint32_t>(most.id)}, pipeline));
    }
    text += ".";
    if (t.shown > 0) return text;
    if (!e.fate.isReason) return text;
    for (auto event = e.events.rbegin(); event != e.events.rend(); ++event)
        if (event->fate == e.fate) return text + " " + event->sentence;
    return text;
}

}  // namespace zscope
