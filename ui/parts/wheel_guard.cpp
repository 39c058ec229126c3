// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace zscope::ui {

bool WheelGuard::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) return false;
    const auto* box    = qobject_cast<QComboBox*>(object);
    const auto* number = qobject_cast<QAbstractSpinBox*>(object);
    if (!box && !number && !qobject_cast<QSlider*>(object)) return false;
    auto* widget = static_cast<QWidget*>(object);
    if (event->type() == QEvent::Polish) {  // before it is seen for the first time
        if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (!box && widget->hasFocus()) return false;
    event->ignore();  // goes on to what is around it
    return true;
}

}  // namespace zscope::ui
