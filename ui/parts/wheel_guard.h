// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel scrolls what is under the cursor and changes nothing on its way:
// a box with choices never turns by it, a field with a number or a slider only while it has the focus, and the wheel
// gives the focus to none of them.
#pragma once

#include <QObject>

namespace zscope::ui {

/// An event filter of the application.
class WheelGuard final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace zscope::ui
