// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/magnifier.h"

#include <QFontDatabase>
#include <QPainter>

#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kPixel = 10;  // logical pixels per picture pixel
constexpr int kMost  = 7;   // lines of text

}  // namespace

Magnifier::Magnifier(QWidget* parent) : QFrame(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    spoken(*this, [this] { setAccessibleName(tr("Magnifier")); });
}

QSize Magnifier::sizeHint() const
{
    const int lines = std::min<int>(static_cast<int>(m_facts.size()), kMost);
    return {kAcross * kPixel + 2 * kStep, kAcross * kPixel + 3 * kStep + lines * fontMetrics().lineSpacing()};
}

void Magnifier::present(const Snapshot& shown, const QImage& picture, const std::optional<QPoint>& pixel,
                        const QString& whose)
{
    const auto facts = pixel ? factsOf(shown, *pixel) : std::nullopt;
    if (!facts || picture.isNull()) {
        hide();
        return;
    }
    m_isPick = shown.picked == pixel;
    m_around = picture.copy(facts->pixel.x() - kAcross / 2, facts->pixel.y() - kAcross / 2, kAcross, kAcross)
                   .convertToFormat(QImage::Format_ARGB32);
    const QRect inside(QPoint(0, 0), picture.size());
    for (int y = 0; y < kAcross; ++y)
        for (int x = 0; x < kAcross; ++x)
            if (!inside.contains(facts->pixel + QPoint(x - kAcross / 2, y - kAcross / 2)))
                m_around.setPixel(x, y, 0);  // outside the picture: see-through

    m_facts = {{tr("pixel"), tr("%1, %2").arg(facts->pixel.x()).arg(facts->pixel.y())}};
    if (!whose.isEmpty()) m_facts.push_back({tr("picture"), whose});
    if (facts->theirs) {
        if (!facts->theirs->isCovered) m_facts.push_back({tr("background"), QString()});
        if (facts->theirs->id) m_facts.push_back({tr("id"), QString::number(*facts->theirs->id)});
        if (facts->theirs->depth) m_facts.push_back({tr("depth"), significant(*facts->theirs->depth, 6)});
    } else if (facts->triangle) {
        m_facts.push_back({tr("triangle"), grouped(facts->triangle->value)});
        m_facts.push_back({tr("depth D"), depthText(facts->depth)});
        m_facts.push_back({tr("distance z"), decimal(facts->z, 4)});
        if (!facts->instance.isEmpty()) m_facts.push_back({tr("instance"), facts->instance});
        if (!facts->material.isEmpty()) m_facts.push_back({tr("material"), facts->material});
    } else {
        m_facts.push_back({tr("background"), tr("no triangle")});
    }
    QStringList spoken;
    for (const Fact& fact : m_facts) spoken << fact.name + ' ' + fact.value;
    setAccessibleDescription(spoken.join(", "));
    resize(sizeHint());
    show();
    update();
}

void Magnifier::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme.border);
    painter.setBrush(theme.card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setRenderHint(QPainter::Antialiasing, false);

    const QRect lens(kStep, kStep, kAcross * kPixel, kAcross * kPixel);
    painter.fillRect(lens, theme.canvas);
    painter.drawImage(lens, m_around);
    painter.setBrush(Qt::NoBrush);
    // one of the two stands out from any picture
    const QPen frame(m_isPick ? theme.picked : theme.softText, 2), rim(theme.card, 4);
    for (const QPen& pen : {rim, frame}) {
        painter.setPen(pen);
        painter.drawRect(QRect(lens.left() + kAcross / 2 * kPixel, lens.top() + kAcross / 2 * kPixel, kPixel, kPixel));
    }

    int y = lens.bottom() + kStep;
    for (std::size_t i = 0; i < m_facts.size() && i < kMost; ++i) {
        const QRect line(kStep, y, width() - 2 * kStep, fontMetrics().lineSpacing());
        painter.setPen(theme.softText);
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, m_facts[i].name);
        painter.setPen(theme.text);
        const int room = line.width() - fontMetrics().horizontalAdvance(m_facts[i].name) - kStep;
        painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter,
                         fontMetrics().elidedText(m_facts[i].value, Qt::ElideRight, room));
        y += line.height();
    }
}

}  // namespace zscope::ui
