// SPDX-License-Identifier: GPL-3.0-or-later
// A text of a panel that wraps, takes the width that there is, and can be copied.
#pragma once

#include <QLabel>

namespace zscope::ui {

/// `name` is what the style sheet knows it by: "title", "section", "soft", "hint".
inline QLabel* wrappedLabel(const char* name = nullptr)
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    if (name) label->setObjectName(name);
    return label;
}

}  // namespace zscope::ui
