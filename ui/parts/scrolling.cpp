// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/scrolling.h"

#include <QLayout>
#include <QScrollArea>

namespace zscope::ui {

int ScrolledPart::heightForWidth(int width) const { return layout()->totalMinimumHeightForWidth(width); }

QWidget* scrolling(ScrolledPart* inside)
{
    constexpr int kLowest = 88;
    auto*         area    = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    area->setMinimumHeight(kLowest);
    area->setWidget(inside);
    area->viewport()->setAutoFillBackground(false);
    inside->setAutoFillBackground(false);
    return area;
}

}  // namespace zscope::ui
