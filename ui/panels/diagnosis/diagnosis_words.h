// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of another program's picture: conventions, verdicts, values. No widgets.
#pragma once

#include <QString>

#include "ui/session/snapshot.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

/// "depth window · rows top-down · ..." in the words of the command line where they are its words.
QString conventionsText(const check::Conventions& conventions);
/// "holes", "spills", ...: the name of a count.
QString nameOf(check::Mistake mistake);
/// "right", "wrong: hole", "rounding (wrong depth)".
QString nameOf(const check::Verdict& verdict);
/// Rich text: what is right at the pixel, what B has there, and the verdict.
QString pixelText(const TheirPicture& theirs, const QPoint& pixel, const Theme& theme);

}  // namespace zscope::ui
