// SPDX-License-Identifier: GPL-3.0-or-later
// What became of a node of the hierarchy: one colour, one shape and one word each, the same in every panel and picture.
#pragma once

#include "core/lesson/step_state.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

inline constexpr std::array kVerdicts{NodeVerdict::Entered, NodeVerdict::Drawn, NodeVerdict::Hidden,
                                      NodeVerdict::Outside, NodeVerdict::Small, NodeVerdict::Waiting};

const QColor& colourOf(NodeVerdict verdict, const Theme& theme);
QString       shapeOf(NodeVerdict verdict);
QString       nameOf(NodeVerdict verdict);  // translated

}  // namespace zscope::ui
