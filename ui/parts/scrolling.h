// SPDX-License-Identifier: GPL-3.0-or-later
// Room for what may be higher than its panel: without a frame, on the panel's own ground, scrolled up and down only.
#pragma once

#include <QWidget>

namespace zscope::ui {

/// What is scrolled; needs a layout. Lists and pictures in it give way down to their least height before anything
/// scrolls: a scroll area by itself leaves a text that wraps, and with it everything beside it, the height that it
/// likes best.
class ScrolledPart : public QWidget {
public:
    using QWidget::QWidget;
    int heightForWidth(int width) const override;
};

QWidget* scrolling(ScrolledPart* inside);

}  // namespace zscope::ui
