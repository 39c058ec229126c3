// SPDX-License-Identifier: GPL-3.0-or-later
// How a row of a table or tree is drawn: its marks and verdicts keep their
// colours when it is selected, and no cell of it gets a box of its own.
#pragma once

#include <QStyledItemDelegate>

namespace zscope::ui {

class RowDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->state.setFlag(QStyle::State_HasFocus, false);
        option->palette.setBrush(QPalette::HighlightedText, option->palette.brush(QPalette::Text));
    }
};

}  // namespace zscope::ui
