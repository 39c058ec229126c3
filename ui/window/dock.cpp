// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dock.h"

#include <QCloseEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "ui/panels/registry.h"
#include "ui/text/spoken.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

/// The timeline explains itself: a title would only cost height.
bool isTitled(const PanelEntry& entry) { return entry.area != Qt::BottomDockWidgetArea; }

/// As much of its text as there is room for: a long summary makes no dock wider.
class Summary final : public QLabel {
public:
    QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        painter.drawText(rect(), Qt::AlignRight | Qt::AlignVCenter,
                         fontMetrics().elidedText(text(), Qt::ElideRight, width()));
    }
};

}  // namespace

PanelDock::PanelDock(const PanelEntry& entry, Panel* panel, QWidget* parent)
    : QDockWidget(parent), m_entry(entry), m_panel(panel)
{
    setObjectName(QString("dock-") + entry.word);
    spoken(*this, [this] {
        setWindowTitle(m_entry.translatedTitle());
        setAccessibleName(m_entry.translatedTitle());
    });
    auto* body = new QFrame;
    body->setObjectName("cardBody");
    auto* layout = new QVBoxLayout(body);
    layout->setContentsMargins(1, 0, 1, 1);
    layout->addWidget(panel);
    const auto roomFor = [](QWidget* card) {
        auto* room   = new QWidget;
        auto* around = new QVBoxLayout(room);
        around->setContentsMargins(0, 0, 0, 0);
        around->addWidget(card);
        return room;
    };
    m_bodyRoom = roomFor(body);
    if (isTitled(entry)) {
        m_titleRoom = roomFor(makeTitle());
        setTitleBarWidget(m_titleRoom);
    } else {
        body->setObjectName("cardWhole");
        setTitleBarWidget(new QWidget);
        setFeatures(DockWidgetClosable);
    }
    setWidget(m_bodyRoom);
    connect(this, &QDockWidget::dockLocationChanged, this, &PanelDock::keepOffTheEdge);
    keepOffTheEdge(entry.area);
    dress();
}

QWidget* PanelDock::makeTitle()
{
    auto* title = new QFrame;
    title->setObjectName("cardTitle");
    auto* name = new QLabel;
    name->setObjectName("title");
    m_summary = new Summary;
    m_summary->setObjectName("soft");
    m_close = new QToolButton;
    m_close->setObjectName("plain");
    m_close->setFocusPolicy(Qt::TabFocus);
    spoken(*title, [this, name] {
        name->setText(m_entry.translatedTitle());
        m_close->setAccessibleName(tr("Close the panel %1").arg(m_entry.translatedTitle()));
        m_close->setToolTip(tr("Close; the View menu opens it again"));
    });
    connect(m_close, &QToolButton::clicked, this, [this] { setWanted(false); });
    connect(m_panel, &Panel::summaryChanged, m_summary, &QLabel::setText);

    auto* layout = new QHBoxLayout(title);
    layout->setContentsMargins(kStep + 4, kStep, kStep, 6);
    layout->setSpacing(kStep);
    layout->addWidget(name);
    layout->addStretch(1);
    layout->addWidget(m_summary);
    layout->addWidget(m_close);
    return title;
}

void PanelDock::keepOffTheEdge(Qt::DockWidgetArea area)
{
    const bool bottom = area == Qt::BottomDockWidgetArea;
    const int  left   = bottom || area == Qt::LeftDockWidgetArea ? kStep : 0;
    const int  right  = bottom || area == Qt::RightDockWidgetArea ? kStep : 0;
    m_bodyRoom->layout()->setContentsMargins(left, 0, right, bottom ? kStep : 0);
    if (m_titleRoom) m_titleRoom->layout()->setContentsMargins(left, 0, right, 0);
}

void PanelDock::dress()
{
    if (m_close) m_close->setIcon(iconOf("close", themeOf(palette()).softText));
}

void PanelDock::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) dress();
    QDockWidget::changeEvent(event);
}

void PanelDock::closeEvent(QCloseEvent* event)
{
    QDockWidget::closeEvent(event);
    setWanted(false);
}

void PanelDock::setWanted(bool wanted)
{
    const bool changed = wanted != m_wanted;
    m_wanted           = wanted;
    setVisible(m_wanted && m_needed);
    if (changed) emit wantedChanged(wanted);
}

void PanelDock::setNeeded(bool needed)
{
    m_needed = needed;
    setVisible(m_wanted && m_needed);
}

}  // namespace zscope::ui
