// SPDX-License-Identifier: GPL-3.0-or-later
// Whether keys are letters and digits to a widget before they are commands of the window.
#pragma once

#include <QAbstractSpinBox>
#include <QLineEdit>

namespace zscope::ui {

inline bool isTyping(const QWidget& widget)
{
    return qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget);
}

}  // namespace zscope::ui
