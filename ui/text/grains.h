// SPDX-License-Identifier: GPL-3.0-or-later
// Grains and stages in the words of the window.
#pragma once

#include <QString>

#include "core/base/stages.h"
#include "core/probe/grain.h"

namespace zscope::ui {

QString nameOf(Grain grain);  // translated
QString nameOf(Stage stage);

}  // namespace zscope::ui
