// SPDX-License-Identifier: GPL-3.0-or-later
// What the chart of speed against error shows, and what it says in words. No widgets.
#pragma once

#include <vector>

#include <QColor>
#include <QString>

#include "core/measure/bench.h"

namespace zscope::ui {

struct Theme;

/// What went with the picture of a run; each has a shape of its own.
enum class RunMark {
    Exact,        // promised the reference's picture, and drew it
    ByFace,       // likewise, face by face
    Approximate,  // promised nothing but figures
    Broken,       // promised it, and drew another
    Unchecked,    // nobody asked for a reference
};
RunMark       markOf(const BenchRow& row);
QString       shapeOf(RunMark mark);  // one character
QString       nameOf(RunMark mark);   // translated
const QColor& colourOf(RunMark mark, const Theme& theme);

enum class ErrorMeasure {
    WrongPixels,    // that show another triangle, or one or none where it should be otherwise
    DepthDistance,  // the largest relative depth error where both show a triangle
};
/// Of a run that was checked.
double errorOf(const BenchRow& row, ErrorMeasure measure);
/// "no wrong pixel", "12 wrong pixels", "depth off by up to 1.2e-04".
QString errorText(double error, ErrorMeasure measure);

struct SpeedErrorPoint {
    QString name;
    double  ms = 1, q1 = 1, q3 = 1;  // above 0
    double  error = 0;
    RunMark mark  = RunMark::Exact;
};
/// Indices of the points worth choosing, by rising time; a broken one is never among them.
std::vector<std::size_t> worthChoosing(const std::vector<SpeedErrorPoint>& points);

/// What the chart says: how many runs, the fastest without error, and those that nothing beats in both.
QString sentenceOf(const std::vector<SpeedErrorPoint>& points, ErrorMeasure measure);
/// One point in words.
QString sentenceOf(const SpeedErrorPoint& point, ErrorMeasure measure);

}  // namespace zscope::ui
