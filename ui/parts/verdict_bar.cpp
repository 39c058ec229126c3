// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/verdict_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/text/numbers.h"
#include "ui/theme/verdicts.h"

namespace zscope::ui {

VerdictBar::VerdictBar(const VerdictSet& on, QWidget* parent) : QWidget(parent), m_chosen(on)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (const NodeVerdict verdict : kVerdicts) {
        const auto at     = static_cast<std::size_t>(verdict);
        auto*      button = new QToolButton;
        button->setObjectName("verdict");
        button->setCheckable(true);
        button->setChecked(m_chosen[at]);
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QToolButton::clicked, this, [this, at](bool isOn) {
            m_chosen[at] = isOn;
            dress();
            emit changed(m_chosen);
        });
        m_buttons[at] = button;
        layout->addWidget(button);
    }
    layout->addStretch(1);
    present({});
}

void VerdictBar::present(const VerdictCounts& counts)
{
    m_counts = counts;
    for (const NodeVerdict rare : {NodeVerdict::Small, NodeVerdict::Waiting})
        m_buttons[static_cast<std::size_t>(rare)]->setVisible(counts[static_cast<std::size_t>(rare)] > 0);
    dress();
}

void VerdictBar::dress()
{
    const Theme& theme = themeOf(palette());
    for (const NodeVerdict verdict : kVerdicts) {
        const auto   at     = static_cast<std::size_t>(verdict);
        QToolButton& button = *m_buttons[at];
        button.setText(shapeOf(verdict) + QStringLiteral(" ") + grouped(m_counts[at]));
        button.setAccessibleName(tr("%1 nodes, %2").arg(nameOf(verdict), grouped(m_counts[at])));
        button.setToolTip(m_chosen[at] ? tr("%1: shown. Click to hide them.").arg(nameOf(verdict))
                                       : tr("%1: not shown. Click to show them.").arg(nameOf(verdict)));
        const QString sheet = QStringLiteral(
                                  "QToolButton#verdict { color: %1; border: 1px solid %2; background: %3; padding: 2px "
                                  "6px; border-radius: 5px; }"
                                  "QToolButton#verdict:focus { border-color: %4; }")
                                  .arg(m_chosen[at] ? colourOf(verdict, theme).name() : theme.softText.name(),
                                       m_chosen[at] ? colourOf(verdict, theme).name() : theme.border.name(),
                                       theme.card.name(), theme.picked.name());
        if (button.styleSheet() != sheet) button.setStyleSheet(sheet);
    }
}

void VerdictBar::changeEvent(QEvent* event)
{
    if ((event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange) && m_buttons[0]) dress();
    QWidget::changeEvent(event);
}

}  // namespace zscope::ui
