// SPDX-License-Identifier: GPL-3.0-or-later
// Which step of B belongs to a step of A, when the two are stepped together.
//
// Threads    runs on the worker: it may replay B
// Promise    A's last step is B's last, whatever links them
#pragma once

#include <optional>

#include <QPoint>
#include <QString>

#include "ui/session/engine.h"

namespace zscope::ui {

struct LinkedStep {
    StepWish wish;
    LinkNote note;
};
/// Errors: those of a search through B's run.
Result<LinkedStep> linkedTo(const ShownStep& a, Link link, const std::optional<QPoint>& picked, const DrawRequest& b);

}  // namespace zscope::ui
