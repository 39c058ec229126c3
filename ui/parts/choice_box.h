// SPDX-License-Identifier: GPL-3.0-or-later
// A box to choose from. A name that is longer than the box ends in an
// ellipsis, where Qt's own would be cut off in the middle of a letter, and a box that is as wide as its longest name is
// so under a style sheet, too; and who has chosen with the mouse has not turned the keys away from the picture: Space
// still plays.
#pragma once

#include <algorithm>

#include <QComboBox>
#include <QStyleOptionComboBox>
#include <QStylePainter>

namespace zscope::ui {

class ChoiceBox : public QComboBox {
public:
    explicit ChoiceBox(QWidget* parent = nullptr) : QComboBox(parent) { setFocusPolicy(Qt::TabFocus); }

    QSize sizeHint() const override
    {
        QSize hint = QComboBox::sizeHint();
        if (sizeAdjustPolicy() != AdjustToContents) return hint;
        int longest = 0;
        for (int i = 0; i < count(); ++i) longest = std::max(longest, fontMetrics().horizontalAdvance(itemText(i)));
        QStyleOptionComboBox option;
        initStyleOption(&option);
        option.rect = QRect(QPoint(0, 0), hint);
        // advances are rounded, and who shortens a name compares exactly
        hint.rwidth() += std::max(0, longest + 1 - roomIn(option));
        return hint;
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QStylePainter        painter(this);
        QStyleOptionComboBox option;
        initStyleOption(&option);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        option.currentText = option.fontMetrics.elidedText(option.currentText, Qt::ElideRight, roomIn(option));
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }

private:
    /// Logical pixels for the text; styles leave one on both sides of it.
    int roomIn(const QStyleOptionComboBox& option) const
    {
        return style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this).width() - 2;
    }
};

}  // namespace zscope::ui
