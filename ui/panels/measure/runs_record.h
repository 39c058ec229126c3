// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of one view as a record of one case, in the form that experiments write (core/measure/record.h).
#pragma once

#include <vector>

#include "core/measure/record.h"
#include "ui/panels/measure/measurer.h"
#include "ui/session/session.h"

namespace zscope::ui {

/// `view` is the view of the session's scene that `rows` were measured on.
Record recordOf(const Session& session, const MeasuredView& view, const std::vector<BenchRow>& rows);

}  // namespace zscope::ui
