// SPDX-License-Identifier: GPL-3.0-or-later
// Room for what may be higher than its panel: without a frame, on the panel's own ground, scrolled up and down only.
#pragma once

class QWidget;

namespace zscope::ui {

QWidget* scrolling(QWidget* inside);

}  // namespace zscope::ui
