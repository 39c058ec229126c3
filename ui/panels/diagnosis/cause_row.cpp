// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/diagnosis/cause_row.h"

#include <algorithm>

#include <QPainter>

#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kPad = 6, kBarHigh = 6, kMark = 18;  // logical pixels

}  // namespace

CauseRow::CauseRow(QWidget* parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void CauseRow::present(const QString& title, double share, bool isOn)
{
    m_share = share;
    setText(title);
    setChecked(isOn);
    setAccessibleName(title + ' ' + shareText());
    updateGeometry();
    update();
}

QString CauseRow::shareText() const { return QString::number(m_share * 100, 'f', 1) + QStringLiteral("\u00A0%"); }

QRect CauseRow::titleIn(int width) const
{
    const int right = fontMetrics().horizontalAdvance(QStringLiteral("100.0\u00A0%")) + kPad;
    const int room  = std::max(40, width - 2 * kPad - kMark - right);
    return fontMetrics()
        .boundingRect(QRect(0, 0, room, 10000), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text())
        .translated(kPad + kMark, kPad)
        .united(QRect(kPad + kMark, kPad, room, 1));
}

int   CauseRow::heightForWidth(int width) const { return titleIn(width).height() + kBarHigh + 3 * kPad; }
QSize CauseRow::sizeHint() const { return {240, heightForWidth(240)}; }
QSize CauseRow::minimumSizeHint() const { return {120, heightForWidth(std::max(120, width()))}; }

void CauseRow::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? theme.picked : isChecked() ? theme.error : theme.border);
    painter.setBrush(isChecked() ? theme.errorTint : underMouse() ? theme.ground : theme.card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
    const QRect title = titleIn(width());
    painter.setPen(isChecked() ? theme.error : theme.softText);
    painter.drawText(QRect(kPad, kPad, kMark, fontMetrics().height()), Qt::AlignLeft | Qt::AlignVCenter,
                     isChecked() ? QStringLiteral("\u2716") : QStringLiteral("\u25CB"));
    painter.setPen(theme.text);
    painter.drawText(title, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text());
    painter.drawText(QRect(kPad, kPad, width() - 2 * kPad, fontMetrics().height()), Qt::AlignRight | Qt::AlignVCenter,
                     shareText());
    const QRectF bar(kPad, height() - kPad - kBarHigh, width() - 2 * kPad, kBarHigh);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.border);
    painter.drawRoundedRect(bar, 3, 3);
    painter.setBrush(theme.idle);
    painter.drawRoundedRect(QRectF(bar.topLeft(), QSizeF(std::max(kBarHigh * 1.0, bar.width() * m_share), kBarHigh)), 3,
                            3);
}

}  // namespace zscope::ui
