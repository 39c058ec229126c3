// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that a widget sets once and that follow the language. What a widget says anew with every snapshot, or while it
// paints, needs nothing of this: the window presents everything again when the language has changed.
#pragma once

#include <functional>

#include <QObject>

namespace zscope::ui {

/// Runs `say` now, and again whenever `owner` hears that the language has changed: widgets, and whatever is their
/// child. `say` lives as long as the owner.
void spoken(QObject& owner, std::function<void()> say);

}  // namespace zscope::ui
