// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/speed_error_points.h"

#include <algorithm>

#include <QCoreApplication>

#include "core/measure/speed_error.h"
#include "ui/text/numbers.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

struct SpeedErrorWords {
    Q_DECLARE_TR_FUNCTIONS(SpeedError)
};

QString timeText(double ms) { return SpeedErrorWords::tr("%1 ms").arg(decimal(ms, 3)); }

}  // namespace

RunMark markOf(const BenchRow& row)
{
    if (!row.figures) return RunMark::Unchecked;
    if (row.isBroken()) return RunMark::Broken;
    switch (row.claim) {
        case Claim::Exact:
            return RunMark::Exact;
        case Claim::ExactByFace:
            return RunMark::ByFace;
        case Claim::Approximate:
            break;
    }
    return RunMark::Approximate;
}

QString shapeOf(RunMark mark)
{
    switch (mark) {
        case RunMark::Exact:
            return QStringLiteral("\u25CF");
        case RunMark::ByFace:
            return QStringLiteral("\u25C6");
        case RunMark::Approximate:
            return QStringLiteral("\u25B2");
        case RunMark::Broken:
            return QStringLiteral("\u2716");
        case RunMark::Unchecked:
            return QStringLiteral("\u25CB");
    }
    return {};
}

QString nameOf(RunMark mark)
{
    switch (mark) {
        case RunMark::Exact:
            return SpeedErrorWords::tr("exact");
        case RunMark::ByFace:
            return SpeedErrorWords::tr("exact by face");
        case RunMark::Approximate:
            return SpeedErrorWords::tr("approximate");
        case RunMark::Broken:
            return SpeedErrorWords::tr("wrong");
        case RunMark::Unchecked:
            return SpeedErrorWords::tr("unchecked");
    }
    return {};
}

const QColor& colourOf(RunMark mark, const Theme& theme)
{
    switch (mark) {
        case RunMark::Exact:
            return theme.entered;
        case RunMark::ByFace:
            return theme.picked;
        case RunMark::Approximate:
            return theme.left;
        case RunMark::Broken:
            return theme.error;
        case RunMark::Unchecked:
            break;
    }
    return theme.outside;
}

double errorOf(const BenchRow& row, ErrorMeasure measure)
{
    if (measure == ErrorMeasure::DepthDistance) return row.figures->worstDistance();
    // Of a method that draws faces it is what that method promises: coverage.
    return static_cast<double>(row.claim == Claim::ExactByFace ? row.figures->wrongCoverage()
                                                               : row.figures->wrongPixels());
}

QString errorText(double error, ErrorMeasure measure)
{
    if (measure == ErrorMeasure::WrongPixels)
        return error <= 0 ? SpeedErrorWords::tr("no wrong pixel")
                          : counted(static_cast<std::uint64_t>(error), SpeedErrorWords::tr("1 wrong pixel"),
                                    SpeedErrorWords::tr("%1 wrong pixels"));
    return error <= 0 ? SpeedErrorWords::tr("no depth is off")
                      : SpeedErrorWords::tr("depth off by up to %1").arg(significant(error, 3));
}

std::vector<std::size_t> worthChoosing(const std::vector<SpeedErrorPoint>& points)
{
    std::vector<SpeedError>  sound;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].mark == RunMark::Broken) continue;
        sound.push_back({points[i].ms, points[i].error});
        which.push_back(i);
    }
    std::vector<std::size_t> chosen = nonDominated(sound);
    for (std::size_t& i : chosen) i = which[i];
    return chosen;
}

QString sentenceOf(const std::vector<SpeedErrorPoint>& points, ErrorMeasure measure)
{
    if (points.empty()) return SpeedErrorWords::tr("No run of this view has been checked against the reference.");
    QString said = counted(points.size(), SpeedErrorWords::tr("One run."), SpeedErrorWords::tr("%1 runs."));
    const SpeedErrorPoint* fastest = nullptr;
    for (const SpeedErrorPoint& point : points)
        if (point.mark != RunMark::Broken && point.error <= 0 && (!fastest || point.ms < fastest->ms)) fastest = &point;
    said += ' '
            + (fastest ? SpeedErrorWords::tr("The fastest without error is %1, at %2.")
                             .arg(fastest->name, timeText(fastest->ms))
                       : SpeedErrorWords::tr("None is without error."));
    QStringList beyond;
    for (const std::size_t i : worthChoosing(points))
        if (points[i].error > 0)
            beyond << SpeedErrorWords::tr("%1 (%2, %3)")
                          .arg(points[i].name, timeText(points[i].ms), errorText(points[i].error, measure));
    if (!beyond.isEmpty())
        said +=
            ' '
            + SpeedErrorWords::tr("Faster at the price of an error: %1.").arg(beyond.join(SpeedErrorWords::tr(", ")));
    else if (fastest)
        said += ' ' + SpeedErrorWords::tr("No error buys more speed.");
    const auto broken = static_cast<std::uint64_t>(std::ranges::count(points, RunMark::Broken, &SpeedErrorPoint::mark));
    if (broken > 0)
        said += ' '
                + counted(broken, SpeedErrorWords::tr("1 is wrong although it promised to be exact."),
                          SpeedErrorWords::tr("%1 are wrong although they promised to be exact."));
    return said;
}

QString sentenceOf(const SpeedErrorPoint& point, ErrorMeasure measure)
{
    return SpeedErrorWords::tr("%1, %2: %3, half of the frames between %4 and %5; %6.")
        .arg(point.name, nameOf(point.mark), timeText(point.ms), decimal(point.q1, 3), timeText(point.q3),
             errorText(point.error, measure));
}

}  // namespace zscope::ui
