#include "core/lesson/explain_sentences.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/probe/words.h"

namespace zscope {

namespace {

/// What is drawn: triangles, or faces as they were read.
std::string_view kindOf(const Pipeline& pipeline) { return drawsFaces(pipeline) ? "face" : "triangle"; }

std::string nameOf(TriangleId id, const Pipeline& pipeline)
{
    return fmt::format("{} {}", kindOf(pipeline), grouped(id.value));
}

std::string nameOf(const NodeName& node)
{
    return node.instance ? fmt::format("node {} of instance {}", node.path, grouped(node.instance->value))
                         : fmt::format("node {} of the instances", node.path);
}

std::string stepsOf(float a, float b) { return counted(float32StepsBetween(a, b), "float32 step", "float32 steps"); }

std::string_view tieRule(const Pipeline& pipeline)
{
    return pipeline.fault == Fault::FarFirst ? "on equal depth the first comer keeps it (a fault)"
                                             : "on equal depth the lower id wins";
}

/// What the pyramid was asked and found.
std::string questionOf(const PyramidQuery& q)
{
    if (q.cells == 0) return "its rectangle holds no pixel's centre, so nothing of it can be seen";
    const std::string asked = fmt::format(
        "its rectangle has {} x {} pixels, so level {} of the pyramid is asked: farthest there {:.9g}, itself at most "
        "{:.9g}",
        q.box.x1 - q.box.x0, q.box.y1 - q.box.y0, q.level, q.value, q.nearest);
    if (!q.hidden) return asked + "; that does not hide it";
    if (q.nearest < q.value) return asked + ", so everything there is strictly nearer";
    return asked + "; that does not decide, but all finer cells and pixels inside the rectangle are strictly nearer";
}

std::string setUpOf(const Event& e, const std::string& who)
{
    switch (e.setUp) {
        case SetUp::Drawn:
            return e.isCut ? who + " is cut at the near plane; what is left of it goes on to the pixels."
                           : who + " is set up and goes on to the pixels.";
        case SetUp::Transparent:
            return who + " is transparent: it is outside ids and depth, and blended afterwards.";
        case SetUp::Outside:
            return who + " is left out at set-up, because a corner of it lies outside the view (a fault).";
        case SetUp::ClippedAway:
            return who + " lies wholly before the near plane: nothing of it is left.";
        case SetUp::BackFacing:
            return who
                   + (e.isMirrored
                          ? " turns counter-clockwise on the grid and its instance is mirrored, so it shows its "
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

std::string nodeOf(const Event& e, const std::string& who, const Pipeline& pipeline)
{
    const std::string node  = nameOf(*e.node);
    const std::string named = capital(node) + fmt::format(", which holds {},", who);
    switch (e.happening) {
        case Happening::NodeOutside:
            return named + " lies outside the view: nothing in it is looked at.";
        case Happening::NodeSmall:
            return named + " has fewer pixels on the screen than this approximation keeps: it is left out.";
        case Happening::NodeRecalled:
            return named + " was visible in the last frame: the first pass draws it without asking.";
        case Happening::NodeHidden:
            return named + " is hidden: " + questionOf(*e.query)
                   + (e.pass == 2 ? ", by what the first pass left." : ".");
        default:
            break;
    }
    if (!e.query)
        return named + " is entered: it may be in view, and "
               + (asksNodes(pipeline.cull) && !e.isPrepass
                      ? "it reaches before the near plane, so nobody can say that it is hidden."
                      : "nobody asks whether it is hidden.");
    return named + " is entered: " + questionOf(*e.query) + ".";
}

std::string wonBy(const Event& e, const std::string& who, const Pipeline& pipeline)
{
    if (e.isPrepass)
        return fmt::format(
            "{}, near/z {:.9g}, is the nearest so far: the pre-pass keeps its depth and asks nobody's name.", who,
            e.depth);
    if (pipeline.depth == DepthMoment::Prepass && !e.rival)
        return fmt::format("{} has exactly the depth that the pre-pass kept, {:.9g}, so the pixel is its own.", who,
                           e.depth);
    if (!e.rival) return fmt::format("{}, near/z {:.9g}, takes the pixel from the background.", who, e.depth);
    const std::string rival = nameOf(*e.rival, pipeline);
    if (e.depth == e.rivalDepth)
        return fmt::format("{} is as near as {}, {:.9g}, and takes the pixel: {}.", who, rival, e.depth,
                           tieRule(pipeline));
    return fmt::format("{}, near/z {:.9g}, takes the pixel from {} at {:.9g}: it is {} nearer.", who, e.depth, rival,
                       e.rivalDepth, stepsOf(e.depth, e.rivalDepth));
}

std::string lostBy(const Event& e, const std::string& who, const Pipeline& pipeline, float background)
{
    if (e.isPrepass)
        return fmt::format("{}, near/z {:.9g}, is not nearer than {:.9g}, which the pre-pass has kept.", who, e.depth,
                           e.rivalDepth);
    if (e.depth > e.rivalDepth)
        return fmt::format(
            "{}, near/z {:.9g}, is nearer than {}: it has a hole here, so the pre-pass left it out, and it does not "
            "have the depth that was kept.",
            who, e.depth,
            e.rivalDepth <= background ? std::string("the background, which is all there is")
                                       : fmt::format("the depth {:.9g} that the pre-pass kept", e.rivalDepth));
    if (e.rivalDepth <= background && !e.rival)
        return fmt::format("{}, near/z {:.9g}, lies beyond the far plane and is not kept.", who, e.depth);
    const std::string holder = e.rival ? "of " + nameOf(*e.rival, pipeline) : std::string("that the pre-pass kept");
    if (e.depth == e.rivalDepth)
        return fmt::format("{} is exactly as near as the depth {}, {:.9g}, and loses: {}.", who, holder, e.depth,
                           tieRule(pipeline));
    return fmt::format("{}, near/z {:.9g}, loses the depth test: the depth {} is {:.9g}, {} nearer.", who, e.depth,
                       holder, e.rivalDepth, stepsOf(e.depth, e.rivalDepth));
}

std::string overtakenBy(const Event& e, const std::string& who, const Pipeline& pipeline)
{
    const std::string rival = capital(nameOf(*e.rival, pipeline));
    if (e.depth == e.rivalDepth)
        return fmt::format("{} is as near, {:.9g}, and takes the pixel from {}: {}.", rival, e.depth, who,
                           tieRule(pipeline));
    return fmt::format("{} at {:.9g} takes the pixel from {} at {:.9g}: it is {} nearer.", rival, e.rivalDepth, who,
                       e.depth, stepsOf(e.depth, e.rivalDepth));
}

std::string intervalOf(const Event& e, const std::string& who, const Pipeline& pipeline)
{
    const PixelBox&   i = *e.interval;
    const std::string where =
        i.x1 - i.x0 == 1
            ? fmt::format("Pixel {} of line {}", i.x0, i.y0)
            : fmt::format("Pixels {} to {} of line {}, between two neighbouring edges,", i.x0, i.x1 - 1, i.y0);
    const std::string verb = i.x1 - i.x0 == 1 ? " goes" : " go";
    if (e.happening == Happening::IntervalWon) {
        if (e.reason == IntervalReason::Alone)
            return fmt::format("{}{} to {} as a whole, without a test: no other is open there.", where, verb, who);
        if (e.reason == IntervalReason::TestedOnce)
            return fmt::format("{}{} to {} as a whole, because it is nearest at the left end (a fault).", where, verb,
                               who);
        return fmt::format(
            "{}{} to {} as a whole: it leads all others by more than 2 float32 steps at both ends, so it leads "
            "everywhere between.",
            where, verb, who);
    }
    const std::string rival = nameOf(*e.rival, pipeline);
    if (e.reason == IntervalReason::TestedOnce)
        return fmt::format(
            "{}{} to {} as a whole, because it is nearest at the left end (a fault); {} is never tested.", where, verb,
            rival, who);
    return fmt::format(
        "{}{} to {} as a whole, which leads by more than 2 float32 steps at both ends; {} is never tested. Here it is "
        "{:.9g} against {:.9g}, {} farther.",
        where, verb, rival, who, e.depth, e.rivalDepth, stepsOf(e.depth, e.rivalDepth));
}

std::string_view countedAs(PixelFate fate)
{
    switch (fate) {
        case PixelFate::Winner:
            return "is seen";
        case PixelFate::Overwritten:
            return "held the pixel for a while";
        case PixelFate::Farther:
            return "lost the depth test";
        case PixelFate::LostTie:
            return "lost by id at equal depth";
        case PixelFate::IntervalLost:
            return "lay behind the leader of an interval";
        case PixelFate::Hole:
            return "has a hole there";
        case PixelFate::BeyondFar:
            return "beyond far";
        case PixelFate::TileRejected:
            return "rejected with a tile";
        case PixelFate::TriangleHidden:
            return "hidden by the pyramid, one by one";
        case PixelFate::NodeHidden:
            return "hidden with a node";
        case PixelFate::NodeOutside:
            return "in a node outside the view";
        case PixelFate::NodeSmall:
            return "in a node that is too small";
        case PixelFate::BatchOutside:
            return "in a batch outside the view";
        case PixelFate::BackFace:
            return "showing its back";
        case PixelFate::NearClip:
            return "cut away at the near plane";
        case PixelFate::NotFilled:
            return "not filled there";
        case PixelFate::Blended:
            return "transparent, blended over it";
        case PixelFate::BehindOpaque:
            return "transparent, behind it";
    }
    return {};
}

}  // namespace

std::uint64_t float32StepsBetween(float a, float b)
{
    // Bits of negative floats run the other way.
    const auto place = [](float value) {
        const auto bits = std::bit_cast<std::int32_t>(value);
        return bits < 0 ? -(std::int64_t{bits} & 0x7FFFFFFF) : std::int64_t{bits};
    };
    const std::int64_t apart = place(a) - place(b);
    return static_cast<std::uint64_t>(apart < 0 ? -apart : apart);
}

std::string sentenceOf(IntervalReason reason)
{
    const std::string pixels = "the interval was compared pixel by pixel, because ";
    switch (reason) {
        case IntervalReason::BeyondFar:
            return pixels + "the nearest reaches beyond the far plane";
        case IntervalReason::DepthLimited:
            return pixels + "a depth is limited to that of a corner there";
        case IntervalReason::HasPattern:
            return pixels + "the nearest has holes or a relief and covers nothing whole";
        case IntervalReason::NoClearLead:
            return pixels + "none leads by more than 2 float32 steps at both ends";
        case IntervalReason::NotByEnds:
            return pixels + "depths are not stored as they are found";
        case IntervalReason::Alone:
        case IntervalReason::Leads:
        case IntervalReason::TestedOnce:
            break;
    }
    return "the interval went to one as a whole";
}

std::string sentenceOf(const Event& event, TriangleId drawnAs, const Pipeline& pipeline, float background)
{
    const std::string who = nameOf(drawnAs, pipeline), subject = capital(who);
    switch (event.happening) {
        case Happening::SetUp:
            return setUpOf(event, subject);
        case Happening::NodeOutside:
        case Happening::NodeHidden:
        case Happening::NodeSmall:
        case Happening::NodeEntered:
        case Happening::NodeRecalled:
            return nodeOf(event, who, pipeline);
        case Happening::TriangleHidden:
            return fmt::format("{} is hidden: {}.", subject, questionOf(*event.query));
        case Happening::TrianglePassed:
            return fmt::format("{} is asked about: {}.", subject, questionOf(*event.query));
        case Happening::TileRejected: {
            const TileTested& t = *event.tile;
            return fmt::format(
                "In the tile from ({}, {}) to ({}, {}) {} could be at most {:.9g} near, and the farthest depth stored "
                "there is {:.9g}: z-cull rejects it with the whole tile.",
                t.box.x0, t.box.y0, t.box.x1 - 1, t.box.y1 - 1, who, t.nearest, t.farthest);
        }
        case Happening::Discarded:
            return subject
                   + " has a hole at this pixel: the fragment does not exist, so it is out before it could win.";
        case Happening::Won:
            return wonBy(event, subject, pipeline);
        case Happening::Lost:
            return lostBy(event, subject, pipeline, background);
        case Happening::Overtaken:
            return overtakenBy(event, who, pipeline);
        case Happening::IntervalWon:
        case Happening::IntervalLost:
            return intervalOf(event, who, pipeline);
    }
    return {};
}

std::string sentenceOf(const PixelCandidate& c, const PixelExplanation& pixel, const Pipeline& pipeline, bool isShaded)
{
    const std::string who = capital(nameOf(c.drawnAs, pipeline));
    if (c.fate == PixelFate::Winner) {
        const std::string shown = fmt::format("{} is what the picture shows, at near/z {:.9g}", who, pixel.depth);
        if (!c.decisive) return shown + ".";
        return shown + ". " + c.events[*c.decisive].sentence;
    }
    if (c.decisive) return c.events[*c.decisive].sentence;
    switch (c.fate) {
        case PixelFate::Blended:
            return fmt::format(
                "Triangle {} has opacity {} and is, at near/z {:.9g}, nearer than the opaque depth {:.9g}: {}.",
                grouped(c.triangle.value), c.opacityText, c.depth, pixel.depth,
                c.opacity <= 0 ? "its share of the colour is 0, so nothing of it is seen"
                : isShaded     ? "it is blended over the colour, the farthest first"
                               : "it would be blended over the colour, but no colours were asked for");
        case PixelFate::BehindOpaque:
            return fmt::format(
                "Triangle {} has opacity {}, but is at near/z {:.9g} not nearer than the opaque depth {:.9g}, so "
                "nothing of it is blended.",
                grouped(c.triangle.value), c.opacityText, c.depth, pixel.depth);
        case PixelFate::NearClip:
            return fmt::format(
                "Triangle {} would meet this pixel before the near plane (near/z would be {:.9g}, above 1): that part "
                "of it is cut away.",
                grouped(c.triangle.value), c.depth);
        case PixelFate::BackFace:
            return fmt::format("Triangle {} shows its back here, and back faces are culled.",
                               grouped(c.triangle.value));
        case PixelFate::BatchOutside:
            return who + " was never set up: the batch of triangles that holds it lies outside the view.";
        default:
            break;
    }
    if (c.cover == Cover::Hole) return who + " has a hole at this pixel, so it does not cover it.";
    if (drawsFaces(pipeline))
        return fmt::format(
            "{} is filled by the winding of its outline, which does not go round this pixel's centre, although "
            "triangle {} covers it.",
            who, grouped(c.triangle.value));
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
    bool first = true;
    for (int fate = 0; fate <= static_cast<int>(PixelFate::BehindOpaque); ++fate) {
        const auto count = std::ranges::count(e.candidates, static_cast<PixelFate>(fate), &PixelCandidate::fate);
        if (count == 0) continue;
        text += fmt::format("{}{} {}", first ? "" : ", ", grouped(static_cast<std::uint64_t>(count)),
                            countedAs(static_cast<PixelFate>(fate)));
        first = false;
    }
    return text + ".";
}

std::string sentenceOf(const TriangleExplanation& e, const Pipeline& pipeline)
{
    const TriangleTally& t   = e.tally;
    const std::string    who = "Triangle " + grouped(e.triangle.value);
    const std::string    seen =
        e.drawnAs == e.triangle ? "" : fmt::format(", drawn as part of face {},", grouped(e.drawnAs.value));
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
            if (event.happening == Happening::SetUp && event.setUp != SetUp::Drawn) return event.sentence;
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
    std::string text = covers + fmt::format(" and is seen at {} of them", grouped(t.shown));
    if (!e.takers.empty()) {
        const Taker& most = e.takers.front();
        text += most.id < 0 ? fmt::format("; {} show the background", grouped(most.pixels))
                            : fmt::format("; most of the others, {}, show {}", grouped(most.pixels),
                                          nameOf(TriangleId{static_cast<std::uint32_t>(most.id)}, pipeline));
    }
    text += ".";
    if (t.shown > 0) return text;
    for (auto event = e.events.rbegin(); event != e.events.rend(); ++event) {
        const bool decides = e.fate == PixelFate::NodeHidden       ? event->happening == Happening::NodeHidden
                             : e.fate == PixelFate::NodeOutside    ? event->happening == Happening::NodeOutside
                             : e.fate == PixelFate::NodeSmall      ? event->happening == Happening::NodeSmall
                             : e.fate == PixelFate::TriangleHidden ? event->happening == Happening::TriangleHidden
                             : e.fate == PixelFate::TileRejected   ? event->happening == Happening::TileRejected
                             : e.fate == PixelFate::IntervalLost   ? event->happening == Happening::IntervalLost
                             : e.fate == PixelFate::Farther        ? event->happening == Happening::Lost
                                                                   : false;
        if (decides) return text + " " + event->sentence;
    }
    return text;
}

}  // namespace zscope
