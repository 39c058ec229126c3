// What the interval scanline says of an interval.
#include <algorithm>

#include <fmt/format.h>

#include "core/method/intervals.h"
#include "core/probe/words.h"

namespace zscope::plain {

namespace {

/// As the picture stores it where rules are exact.
float depthOf(const DepthPlane& plane, PixelPosition p)
{
    const double z = plane.a * (p.x + 0.5) + (plane.b * (p.y + 0.5) + plane.c);
    return static_cast<float>(std::min(std::max(z, double{plane.farthest}), double{plane.nearest}));
}

/// What it means for `who`; `depth` is its own at the pixel, `winners` that of the polygon that gets the interval.
std::string intervalOf(const IntervalDecided& i, const std::string& who, bool isWinner, float depth, float winners,
                       const Telling& telling)
{
    const std::string where =
        i.x1 - i.x0 == 1
            ? fmt::format("Pixel {} of line {}", i.x0, i.y)
            : fmt::format("Pixels {} to {} of line {}, between two neighbouring edges,", i.x0, i.x1 - 1, i.y);
    const std::string verb = i.x1 - i.x0 == 1 ? " goes" : " go";
    if (isWinner) {
        if (i.reason == IntervalReason::Alone)
            return fmt::format("{}{} to {} as a whole, without a test: no other is open there.", where, verb, who);
        if (i.reason == IntervalReason::TestedOnce)
            return fmt::format("{}{} to {} as a whole, because it is nearest at the left end (a fault).", where, verb,
                               who);
        return fmt::format(
            "{}{} to {} as a whole: it leads all others by more than 2 float32 steps at both ends, so it leads "
            "everywhere between.",
            where, verb, who);
    }
    const std::string rival = telling.nameOf(i.winner->id);
    if (i.reason == IntervalReason::TestedOnce)
        return fmt::format(
            "{}{} to {} as a whole, because it is nearest at the left end (a fault); {} is never tested.", where, verb,
            rival, who);
    return fmt::format(
        "{}{} to {} as a whole, which leads by more than 2 float32 steps at both ends; {} is never tested. Here it is "
        "{:.9g} against {:.9g}, {} farther.",
        where, verb, rival, who, depth, winners, countedSteps(depth, winners));
}

/// Why an interval was compared pixel by pixel.
std::string whyCompared(IntervalReason reason)
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

}  // namespace

std::string IntervalDecided::sentence(const Telling& telling) const
{
    const std::string pixels = x1 - x0 == 1 ? fmt::format("pixel {}", x0) : fmt::format("pixels {} to {}", x0, x1 - 1);
    const std::string where  = fmt::format("Line {}, {} between neighbouring edges: {}", y, pixels,
                                           counted(open.size(), "polygon is open", "polygons are open"));
    const std::string name(telling.polygon());
    const std::string leader = winner ? fmt::format("{} {}", name, withCommas(winner->id.value)) : name;
    switch (reason) {
        case IntervalReason::Alone:
            return where + fmt::format(", {}, so all of it is its own without a test.", leader);
        case IntervalReason::Leads:
            return where
                   + fmt::format(
                       "; {} leads all others by more than 2 float32 steps at both ends, so it leads everywhere "
                       "between and wins them all.",
                       leader);
        case IntervalReason::TestedOnce:
            return where + fmt::format("; {} is nearest at the left end and, by a fault, gets them all.", leader);
        case IntervalReason::BeyondFar:
            return where + "; the nearest reaches beyond the far plane, so they are compared pixel by pixel.";
        case IntervalReason::DepthLimited:
            return where + "; a depth is limited to its " + name
                   + "'s corners there, so the ends do not speak for the rest: compared pixel by pixel.";
        case IntervalReason::HasPattern:
            return where
                   + "; the nearest has holes or a relief and covers nothing whole, so they are compared pixel by "
                     "pixel.";
        case IntervalReason::NoClearLead:
            return where
                   + "; none leads by more than 2 float32 steps at both ends, as where they cross or touch: compared "
                     "pixel by pixel.";
        case IntervalReason::NotByEnds:
            return where
                   + "; depths are not stored as they are found, so the ends do not speak for the rest: compared "
                     "pixel by pixel.";
    }
    return where;
}

void IntervalDecided::mean(Meanings& to) const
{
    const PixelBox pixels{x0, y, x1, y + 1};
    if (!to.asksAbout(pixels)) return;
    if (!winner) return to.remark(pixels, [this] { return whyCompared(reason); });
    for (const std::uint32_t part : open) {
        const Polygon& polygon = polygons[part];
        const bool     isIt    = polygon.id == winner->id;
        const Outcome  outcome =
            isIt ? Outcome{.word = "interval-won", .effect = Effect::Wins, .countedAs = {"interval_won"}}
                  : Outcome{.word = "interval-lost", .effect = Effect::Loses, .countedAs = {"interval_lost"}};
        to.of(polygon.id, pixels, outcome, [&](TriangleId id, PixelPosition at) {
            const float depth = depthOf(polygon.depth, at), winners = depthOf(winner->depth, at);
            Meaning     meaning{.depth = depth};
            if (!isIt) meaning.rival = winner->id, meaning.rivalDepth = winners, meaning.fate = fates::kIntervalLost;
            meaning.values   = {{"interval", Values{{"line", std::int64_t{y}},
                                                  {"x0", std::int64_t{x0}},
                                                  {"x1", std::int64_t{x1}},
                                                  {"reason", std::string(wordOf(reason))}}}};
            meaning.sentence = intervalOf(*this, to.telling().nameOf(id), isIt, depth, winners, to.telling());
            return meaning;
        });
    }
}

}  // namespace zscope::plain
