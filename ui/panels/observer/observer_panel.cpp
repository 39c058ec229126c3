// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/observer/observer_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "ui/panels/observer/observer_view.h"
#include "ui/parts/scrolling.h"
#include "ui/parts/verdict_bar.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

/// Entered nodes hold others that say more; those that wait say nothing yet.
constexpr VerdictSet kBoxesAtFirst{false, true, true, false, true, true};  // by NodeVerdict

}  // namespace

ObserverPanel::ObserverPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_view(new ObserverView), m_boxes(new VerdictBar(kBoxesAtFirst)), m_freeze(new QCheckBox),
      m_reset(new QPushButton), m_words(new QLabel), m_hint(new QLabel)
{
    m_freeze->setFocusPolicy(Qt::TabFocus);
    m_reset->setFocusPolicy(Qt::TabFocus);
    m_words->setObjectName("soft");
    m_words->setWordWrap(true);
    m_words->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setMargin(2 * kStep);

    auto* row = new QHBoxLayout;
    row->setSpacing(kStep);
    row->addWidget(m_freeze);
    row->addStretch(1);
    row->addWidget(m_reset);
    auto* view   = new ScrolledPart;
    auto* inside = new QVBoxLayout(view);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(6);
    inside->addWidget(m_boxes);
    inside->addWidget(m_view, 1);
    inside->addWidget(m_words);
    inside->addLayout(row);
    m_viewOrHint = new QStackedLayout(this);
    m_viewOrHint->addWidget(scrolling(view));
    m_viewOrHint->addWidget(m_hint);

    m_view->setBoxes(kBoxesAtFirst);
    connect(m_boxes, &VerdictBar::changed, m_view, &ObserverView::setBoxes);
    connect(m_reset, &QPushButton::clicked, m_view, &ObserverView::resetView);
    connect(m_view, &ObserverView::drawn, this, &ObserverPanel::showWords);
    connect(m_view, &ObserverView::picked, this, [this](int node) {
        const HierarchyState* hierarchy = m_frozen ? &*m_frozen->state.hierarchy : this->session().now().hierarchy();
        if (!hierarchy || node >= static_cast<int>(hierarchy->nodes.size())) return;
        this->session().selectNode(node < 0 ? std::nullopt
                                            : std::optional(nameOf(hierarchy->nodes[static_cast<std::size_t>(node)])));
    });
    connect(m_freeze, &QCheckBox::toggled, this, [this](bool on) {
        const Snapshot& now = this->session().now();
        m_frozen            = on && now.hierarchy() ? now.step : nullptr;
        m_frozenScene       = m_frozen ? now.scene : nullptr;
        showStep(now);
    });
    spoken(*this, [this] {
        m_boxes->setAccessibleName(tr("Boxes seen by the observer, by verdict"));
        m_freeze->setText(tr("Freeze the culling view"));
        m_reset->setText(tr("Whole scene"));
        m_freeze->setToolTip(tr("Keeps this step's view and verdicts here while the camera of the picture moves on"));
        m_reset->setToolTip(tr("Looks at the whole scene and the frustum again"));
        m_hint->setText(
            tr("The boxes appear here as soon as the hierarchy is visited. Press Right to go on, or choose the grain "
               "“node”."));
        showWords();
    });
}

void ObserverPanel::present(const Snapshot& shown, Changes what)
{
    if ((what & Change::Scene) && m_frozen && shown.scene != m_frozenScene) m_freeze->setChecked(false);
    if (what & (Change::Picture | Change::Pipeline | Change::Scene | Change::Selection)) showStep(shown);
}

void ObserverPanel::showStep(const Snapshot& shown)
{
    const bool  live = shown.hierarchy() && !shown.hierarchy()->nodes.empty();
    const auto& step = m_frozen ? m_frozen : live ? shown.step : nullptr;
    m_viewOrHint->setCurrentIndex(step ? 0 : 1);
    m_freeze->setEnabled(step != nullptr);
    if (!step) {
        m_view->present(nullptr, nullptr, -1);
        emit summaryChanged({});
        return;
    }
    const HierarchyState& hierarchy = *step->state.hierarchy;
    VerdictCounts         counts{};
    for (const NodeRow& node : hierarchy.nodes) ++counts[static_cast<std::size_t>(node.verdict)];
    m_boxes->present(counts);
    int selected = shown.selectedNode ? rowOf(hierarchy.nodes, *shown.selectedNode) : -1;
    if (selected < 0 && shown.showsStep) selected = hierarchy.now;
    m_view->present(step, m_frozen ? m_frozenScene : shown.scene, selected);
    emit summaryChanged(m_frozen ? tr("frozen") : tr("drag to orbit"));
}

void ObserverPanel::showWords()
{
    const auto& observer = m_view->observer();
    if (!observer) return;
    QString words = tr("%1 triangles: pale blue where drawn, else in the colour of their node's verdict.")
                        .arg(grouped(observer->trianglesShown()));
    if (observer->trianglesLeftOut() > 0)
        words += ' ' + tr("%1 more are left out.").arg(grouped(observer->trianglesLeftOut()));
    if (observer->boxesLeftOut() > 0)
        words += ' ' + tr("%1 boxes are left out.").arg(grouped(observer->boxesLeftOut()));
    m_words->setText(words);
}

}  // namespace zscope::ui
