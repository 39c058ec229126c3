// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/compare/compare_words.h"

#include <QCoreApplication>

#include "ui/text/numbers.h"

namespace zscope::ui {
namespace {

struct CompareText {
    Q_DECLARE_TR_FUNCTIONS(Compare)
};

/// Of what another program drew.
CompareWords wordsOfTheirs(const Comparison& result)
{
    const Difference&   difference = result.difference;
    const std::uint64_t differing = difference.differing(), pixels = difference.kinds.values().size();
    const auto          count = [&](PixelDifference kind) { return difference.counts[static_cast<std::size_t>(kind)]; };
    CompareWords        words;
    words.isWrong = differing > 0;
    words.verdict =
        differing == 0
            ? CompareText::tr("B shows what A shows, but for rounding.")
            : counted(differing, CompareText::tr("1 pixel differs."), CompareText::tr("%1 pixels differ.")) + ' '
                  + CompareText::tr("Of all: %1.")
                        .arg(decimal(100.0 * static_cast<double>(differing) / static_cast<double>(pixels), 3)
                             + QStringLiteral("\u00A0%"));
    const QString right = QStringLiteral("A"), judged = QStringLiteral("B");
    const auto    figure = [&](const QString& name, PixelDifference kind) {
        words.figures.push_back({name, grouped(count(kind)), count(kind) > 0});
    };
    figure(CompareText::tr("holes: %1 shows something, %2 does not").arg(right, judged), PixelDifference::Hole);
    figure(CompareText::tr("spills: %1 shows something, %2 does not").arg(judged, right), PixelDifference::Spill);
    if (result.theirs->hasIds()) figure(CompareText::tr("another surface"), PixelDifference::Surface);
    if (result.theirs->hasDepth()) {
        figure(CompareText::tr("another depth, B nearer"), PixelDifference::DepthNearer);
        figure(CompareText::tr("another depth, B farther"), PixelDifference::DepthFarther);
    }
    words.figures.push_back({CompareText::tr("equal but for rounding"), grouped(result.rounding)});
    return words;
}

}  // namespace

CompareWords wordsOf(const Comparison& result)
{
    if (result.theirs) return wordsOfTheirs(result);
    const ErrorFigures& figures    = result.figures;
    const Difference&   difference = result.difference;
    const auto          count = [&](PixelDifference kind) { return difference.counts[static_cast<std::size_t>(kind)]; };
    CompareWords        words;
    const bool          isFinished = result.a || (result.stepA->isLast() && result.stepB->isLast());
    words.isWrong = isFinished && figures.wrongPixels() > 0;  // half done, one has simply come farther than the other
    if (figures.isExact())
        words.verdict = CompareText::tr("B is A to the bit: the same triangle and the same depth at all %1 pixels.")
                            .arg(grouped(figures.pixels));
    else if (difference.differing() == 0)
        words.verdict =
            CompareText::tr("Every pixel shows the same triangle; no depth is farther off than the tolerance.");
    else
        words.verdict =
            (isFinished ? counted(difference.differing(), CompareText::tr("1 pixel differs."),
                                  CompareText::tr("%1 pixels differ."))
                        : counted(difference.differing(), CompareText::tr("1 pixel differs at this moment."),
                                  CompareText::tr("%1 pixels differ at this moment.")))
            + ' '
            + CompareText::tr("Of all: %1.")
                  .arg(decimal(
                           100.0 * static_cast<double>(difference.differing()) / static_cast<double>(figures.pixels), 3)
                       + QStringLiteral("\u00A0%"));

    const QString right  = result.isAJudged ? QStringLiteral("B") : QStringLiteral("A"),
                  judged = result.isAJudged ? QStringLiteral("A") : QStringLiteral("B");
    words.figures        = {
               {CompareText::tr("holes: %1 shows something, %2 does not").arg(right, judged), grouped(figures.holes),
                isFinished && figures.holes > 0},
               {CompareText::tr("spills: %1 shows something, %2 does not").arg(judged, right), grouped(figures.spills),
                isFinished && figures.spills > 0},
               {CompareText::tr("another surface, farther off than a tie"), grouped(figures.realWrongSurface),
                isFinished && figures.realWrongSurface > 0},
               {CompareText::tr("another surface, a near tie"), grouped(figures.nearTies), isFinished && figures.nearTies > 0},
               {CompareText::tr("same triangle, B nearer"), grouped(count(PixelDifference::DepthNearer))},
               {CompareText::tr("same triangle, B farther"), grouped(count(PixelDifference::DepthFarther))},
               {CompareText::tr("most float32 steps on a triangle"), grouped(difference.mostSteps)},
               {CompareText::tr("steps at 99 of 100 pixels, at most"), grouped(figures.p99DepthSteps)},
               {CompareText::tr("triangles of %1 that %2 shows nowhere").arg(right, judged), grouped(figures.lostTriangles),
                isFinished && figures.lostTriangles > 0},
    };
    return words;
}

}  // namespace zscope::ui
