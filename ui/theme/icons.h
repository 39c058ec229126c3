// SPDX-License-Identifier: GPL-3.0-or-later
// Our own icons, drawn in the colour of the text they stand beside.
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace zscope::ui {

/// Makes the resources of this library known to Qt; call it once before any icon is asked for.
void registerIcons();

/// The icon resources/icons/NAME.svg, whose "currentColor" becomes `colour`. Sharp at every size it is asked for.
QIcon iconOf(const QString& name, const QColor& colour);

}  // namespace zscope::ui
