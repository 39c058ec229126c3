// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a benchmark: one HTML page with its tables and charts, in
// every language of the window, that needs nothing but itself; and the charts as PNG files beside it.
//
// Charts     per part of an experiment: stages as bars; times along the axis that the part names, with the exponent of
//            their growth; how many times as long as the baseline along the same axis; along a camera path times with
//            the frame rate and wrong pixels, frame by frame; speed against error
// Print      every chart can be read without colour: marks, dashes and fillings differ as well
// Needs      a QApplication, on the platform "offscreen" too; no window
// Errors     the record's, or Output
#pragma once

#include <string>

#include "core/base/result.h"

namespace zscope::ui {

/// `record`: a file of `zscope-cli bench --experiment --json`. The folder is made if it is not there. The page is its
/// index.html; returned is its path.
Result<std::string> writeReport(const std::string& record, const std::string& folder);

}  // namespace zscope::ui
