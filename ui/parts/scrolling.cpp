// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/scrolling.h"

#include <QScrollArea>

namespace zscope::ui {

QWidget* scrolling(QWidget* inside)
{
    constexpr int kLowest = 88;
    auto* area = new QScrollArea;
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
