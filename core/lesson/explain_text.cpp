#include <fmt/format.h>

#include "core/lesson/explain.h"
#include "core/probe/words.h"

namespace zscope {

namespace {

/// "node 12, triangle 40, pixel 5,310": where a timeline shows it, from the step's own grain on.
std::string stepsOf(const Event& event, const std::vector<Grain>& grains)
{
    std::string text;
    for (const Grain grain : grains) {
        if (grain < event.grain) continue;
        text +=
            fmt::format("{}{} {}", text.empty() ? "" : ", ", wordOf(grain), withCommas(event.moment.at(grain).value));
    }
    return text;
}

std::string linesOf(const std::vector<Event>& events, const std::vector<Grain>& grains)
{
    std::string text;
    for (const Event& event : events) {
        if (event.isUsual) continue;
        text +=
            fmt::format("      {:<15} {}\n{:22}at step: {}\n", event.word, event.sentence, "", stepsOf(event, grains));
    }
    return text;
}

}  // namespace

std::string explanationToText(const PixelExplanation& e)
{
    std::string text = e.sentence + "\n";
    for (const PixelCandidate& c : e.candidates) {
        text += fmt::format("  triangle {} (instance {}): {}\n", withCommas(c.triangle.value),
                            withCommas(c.instance.value), wordOf(c.fate));
        text += linesOf(c.events, e.grains);
        if (!c.decisive) text += "      " + c.sentence + "\n";
    }
    return text;
}

std::string explanationToText(const TriangleExplanation& e)
{
    const TriangleTally& t    = e.tally;
    std::string          text = e.sentence + "\n";
    text += fmt::format("  instance {}, mesh '{}', material '{}', opacity {}, {}\n", withCommas(e.instance.value),
                        e.mesh, e.material, e.isTransparent ? e.opacityText : "1", wordOf(e.fate));
    text += fmt::format("  pixels: {} covered, {} shown, {} tested, {} passed at the time\n", withCommas(t.covered),
                        withCommas(t.shown), withCommas(t.of("tested")), withCommas(t.of("passed")));
    for (const Taker& taker : e.takers) {
        if (taker.id < 0)
            text += fmt::format("  {} show the background\n", counted(taker.pixels, "pixel", "pixels"));
        else
            text += fmt::format("  {} taken by triangle {}\n", counted(taker.pixels, "pixel", "pixels"),
                                withCommas(static_cast<std::uint64_t>(taker.id)));
    }
    if (e.otherTakers > 0)
        text += fmt::format("  and by {}\n", counted(e.otherTakers, "more triangle", "more triangles"));
    text += linesOf(e.events, e.grains);
    if (e.leftOut > 0) text += fmt::format("      and {}\n", counted(e.leftOut, "more event", "more events"));
    return text;
}

}  // namespace zscope
