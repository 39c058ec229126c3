// SPDX-License-Identifier: GPL-3.0-or-later
// The charts of a report, drawn on paper's white whatever the window looks like.
//
// Fill, dash each stage has a filling and each algorithm a mark and a dash of its own, the same in all charts of a
// report
#pragma once

#include <span>
#include <vector>

#include <QImage>
#include <QString>

#include "core/measure/bench.h"

namespace zscope::ui {

/// One case of an experiment as charts want it.
struct ReportCase {
    QString               scene;
    double                place = 0;  // on the axis, if the part has one
    std::vector<BenchRow> rows;
};

struct ReportChart {
    QString name;   // of its file, without ending
    QString title;  // what is to be seen
    QImage  image;
};

/// Those of one part that have something to show. `axis`: what the places mean; empty: they are a list.
std::vector<ReportChart> chartsOf(std::span<const ReportCase> cases, const QString& axis, const std::string& baseline);

/// The slope of log(y) over log(x) by least squares: y grows like x to that power. At least two points, all above 0,
/// not all at one x.
double growthExponent(std::span<const double> x, std::span<const double> y);

}  // namespace zscope::ui
