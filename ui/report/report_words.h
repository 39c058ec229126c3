// SPDX-License-Identifier: GPL-3.0-or-later
// Where the words of a report are looked up.
#pragma once

#include <QCoreApplication>

namespace zscope::ui {

struct Report {
    Q_DECLARE_TR_FUNCTIONS(Report)
};

}  // namespace zscope::ui
