// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/linking.h"

#include <algorithm>

#include <QCoreApplication>

#include "core/lesson/pixel_changes.h"
#include "ui/session/marks.h"

namespace zscope::ui {
namespace {

struct Linking {
    Q_DECLARE_TR_FUNCTIONS(Linking)
};

StepWish toStep(Grain grain, std::uint64_t step)
{
    return {.grain = grain, .from = StepWish::From::Start, .offset = step, .counted = grain};
}

/// The same number where both have steps of that grain, else the same part of the run.
LinkedStep byNumber(const ShownStep& a, Grain grain)
{
    if (grain == a.state.grain) return {toStep(grain, a.state.step.value), LinkNote{}};
    const double part = static_cast<double>(a.state.step.value) / static_cast<double>(a.last());
    return {{.grain = grain, .from = StepWish::From::Fraction, .fraction = part, .counted = grain},
            LinkNote{LinkNote::What::PartOfRun}};
}

/// The same part of the same stage.
LinkedStep byStage(const ShownStep& a, Grain grain)
{
    StepWish wish{.grain = grain, .from = StepWish::From::Stage, .counted = grain};
    wish.stage = a.state.stage;
    for (std::size_t i = 0; i < a.stages.size(); ++i) {
        const std::uint64_t end = i + 1 < a.stages.size() ? a.stages[i + 1].first : a.state.count;
        if (a.state.step.value < a.stages[i].first || a.state.step.value >= end) continue;
        wish.fraction = static_cast<double>(a.state.step.value - a.stages[i].first)
                        / static_cast<double>(std::max<std::uint64_t>(1, end - a.stages[i].first));
    }
    return {wish, LinkNote{LinkNote::What::PartOfStage}};
}

Result<LinkedStep> byLine(const ShownStep& a, Grain grain, const DrawRequest& b)
{
    const auto line = lineOf(a.state);
    if (!line) {
        LinkedStep linked = byNumber(a, grain);
        linked.note       = {LinkNote::What::NoLine};
        return linked;
    }
    const Breakpoint at{.on = Breakpoint::On::Line, .line = *line};
    const auto       stop = nextStop(b, grain, {}, std::span(&at, 1), Direction::Forward);
    if (!stop) return stop.error();
    if (*stop) return LinkedStep{toStep(grain, (*stop)->step.value), LinkNote{LinkNote::What::FirstOnLine, *line}};
    return LinkedStep{toStep(grain, 0), LinkNote{LinkNote::What::NeverOnLine, *line}};
}

Result<LinkedStep> byPixel(const ShownStep& a, Grain grain, const std::optional<QPoint>& picked, const DrawRequest& b)
{
    if (!picked) {
        LinkedStep linked = byNumber(a, grain);
        linked.note       = {LinkNote::What::NoPixel};
        return linked;
    }
    const std::int64_t shown   = a.state.frame.visible.idAt(picked->x(), picked->y());
    const auto         changes = changesOfPixel(b, grain, {picked->x(), picked->y()});
    if (!changes) return changes.error();
    if (shown < 0) {
        if (changes->empty() || changes->front().step.value == 0)
            return LinkedStep{toStep(grain, 0), LinkNote{LinkNote::What::BackgroundInA}};
        return LinkedStep{toStep(grain, changes->front().step.value - 1), LinkNote{LinkNote::What::StillBackground}};
    }
    const auto same = std::ranges::find(*changes, shown, &PixelChange::id);
    if (same != changes->end())
        return LinkedStep{toStep(grain, same->step.value), LinkNote{LinkNote::What::SameTriangle}};
    if (changes->empty()) return LinkedStep{toStep(grain, 0), LinkNote{LinkNote::What::NoChange}};
    return LinkedStep{toStep(grain, changes->back().step.value), LinkNote{LinkNote::What::NeverShown}};
}

}  // namespace

Result<LinkedStep> linkedTo(const ShownStep& a, Link link, const std::optional<QPoint>& picked, const DrawRequest& b)
{
    const std::vector<Grain> grains = grainsOf(b.pipeline);
    const Grain grain = std::ranges::find(grains, a.state.grain) != grains.end() ? a.state.grain : grains.back();
    if (a.isLast()) return LinkedStep{{.grain = grain, .counted = grain}, LinkNote{}};
    switch (link) {
        case Link::Number:
            return byNumber(a, grain);
        case Link::Stage:
            return byStage(a, grain);
        case Link::Line:
            return byLine(a, grain, b);
        case Link::Pixel:
            return byPixel(a, grain, picked, b);
    }
    return byNumber(a, grain);
}

QString textOf(const LinkNote& note)
{
    switch (note.what) {
        case LinkNote::What::Nothing:
            return {};
        case LinkNote::What::PartOfRun:
            return Linking::tr("B stands at the same part of its run.");
        case LinkNote::What::PartOfStage:
            return Linking::tr("B stands at the same part of the same stage.");
        case LinkNote::What::NoLine:
            return Linking::tr("A works on no line of its own here.");
        case LinkNote::What::FirstOnLine:
            return Linking::tr("B comes to line %1 here for the first time.").arg(note.line);
        case LinkNote::What::NeverOnLine:
            return Linking::tr("B never works on line %1.").arg(note.line);
        case LinkNote::What::NoPixel:
            return Linking::tr("Pick a pixel for B to follow.");
        case LinkNote::What::BackgroundInA:
            return Linking::tr("The pixel shows the background in A.");
        case LinkNote::What::StillBackground:
            return Linking::tr("The last step at which the pixel still shows the background in B, too.");
        case LinkNote::What::SameTriangle:
            return Linking::tr("Here B gives the pixel to the triangle that it shows in A.");
        case LinkNote::What::NoChange:
            return Linking::tr("No step of B changes the pixel.");
        case LinkNote::What::NeverShown:
            return Linking::tr("B never shows that triangle in the pixel; this is its last change.");
    }
    return {};
}

}  // namespace zscope::ui
