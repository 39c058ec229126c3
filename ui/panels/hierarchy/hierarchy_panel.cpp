// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/hierarchy/hierarchy_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QStackedLayout>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/panels/hierarchy/depth_chart.h"
#include "ui/panels/hierarchy/node_model.h"
#include "ui/parts/row_delegate.h"
#include "ui/parts/scrolling.h"
#include "ui/parts/verdict_bar.h"
#include "ui/predict/predict_bar.h"
#include "ui/predict/predictions.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

HierarchyPanel::HierarchyPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_model(new NodeModel(this)), m_filter(new NodeFilter(*m_model, this)),
      m_tree(new QTreeView), m_text(new QLineEdit), m_verdicts(new VerdictBar(everyVerdict())),
      m_depths(new DepthChart), m_boxes(new QCheckBox), m_hint(new QLabel)
{
    m_tree->setModel(m_filter);
    m_tree->setItemDelegate(new RowDelegate(m_tree));
    m_tree->setUniformRowHeights(true);
    m_tree->setProperty("ownsArrows", true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setIndentation(8);
    m_tree->setTextElideMode(Qt::ElideLeft);  // the end of a path tells siblings apart
    m_tree->setSelectionMode(QAbstractItemView::SingleSelection);
    m_tree->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_tree->setMinimumHeight(110);
    m_tree->viewport()->installEventFilter(this);  // its width is known last
    QFont small = m_tree->font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    m_tree->setFont(small);
    m_tree->header()->setFont(small);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionsMovable(false);
    m_tree->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_text->setClearButtonEnabled(true);
    m_boxes->setFocusPolicy(Qt::TabFocus);
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setMargin(2 * kStep);

    auto* tree   = new ScrolledPart;
    auto* inside = new QVBoxLayout(tree);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(6);
    inside->addWidget(new PredictBar(session, Topic::Nodes));
    inside->addWidget(m_text);
    inside->addWidget(m_verdicts);
    inside->addWidget(m_tree, 1);
    inside->addWidget(m_depths);
    inside->addWidget(m_boxes);
    m_treeOrHint = new QStackedLayout(this);
    m_treeOrHint->addWidget(scrolling(tree));
    m_treeOrHint->addWidget(m_hint);

    connect(m_text, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_filling = true;
        m_filter->setText(text);
        if (m_filter->isFiltering() && !text.isEmpty()) m_tree->expandAll();
        m_filling = false;
    });
    connect(m_verdicts, &VerdictBar::changed, this, [this](const VerdictSet& chosen) {
        m_filling = true;
        m_filter->setVerdicts(chosen);
        m_filling = false;
        this->session().showNodes(chosen);
    });
    connect(m_tree, &QTreeView::expanded, this, [this](const QModelIndex& at) {
        if (!m_filling) m_unfolded.insert(m_model->idOf(m_filter->mapToSource(at)));
    });
    connect(m_tree, &QTreeView::collapsed, this, [this](const QModelIndex& at) {
        if (!m_filling) m_unfolded.erase(m_model->idOf(m_filter->mapToSource(at)));
    });
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& at) {
        if (m_filling || !at.isValid()) return;
        this->session().selectNode(nameOf(m_model->row(m_model->idOf(m_filter->mapToSource(at)))));
    });
    connect(m_boxes, &QCheckBox::clicked, this, [this](bool on) {
        Layers layers = this->session().now().layers;
        layers.boxes  = on;
        this->session().setLayers(layers);
    });
    spoken(*this, [this] {
        m_verdicts->setAccessibleName(tr("Nodes in the tree, by verdict"));
        m_boxes->setText(tr("Boxes over the picture"));
        m_tree->setAccessibleName(tr("Nodes of the hierarchy"));
        m_text->setPlaceholderText(tr("Filter: part of a path, or an instance"));
        m_text->setAccessibleName(tr("Filter of the nodes"));
        m_boxes->setToolTip(tr("Draws the boxes of the nodes that the switches above let through"));
    });
}

void HierarchyPanel::present(const Snapshot& now, Changes what)
{
    const auto      before = session().predictions().before(Topic::Nodes, now);  // while a question is open
    const Snapshot& shown  = before ? *before : now;
    m_boxes->setChecked(shown.layers.boxes);
    if (what & (Change::Picture | Change::Pipeline | Change::Scene))
        showNodes(shown);
    else if (what & Change::Selection)
        showSelection(shown);
}

void HierarchyPanel::showNodes(const Snapshot& shown)
{
    m_filling = true;
    m_model->setPalette(palette());
    m_model->present(shown);
    m_filling = false;
    m_treeOrHint->setCurrentIndex(m_model->isEmpty() ? 1 : 0);
    if (m_model->isEmpty()) {
        m_hint->setText(!shown.scene ? tr("Open a scene to see its hierarchy.")
                        : shown.grain == Grain::Node
                            ? tr("The nodes appear here as the visit comes to know them. Press Right to go on.")
                            : tr("The nodes appear here as the visit comes to know them. Press Right to go on, or "
                                 "choose the grain “node”."));
        emit summaryChanged({});
        return;
    }
    const ShownStep& step = *shown.stepOfPicture();
    if (step.generation != m_generation) {
        m_unfolded.clear();
        for (const NodeRow& node : step.state.hierarchy->nodes)
            if (node.depth <= 1) m_unfolded.insert(node.id);
    }
    m_generation = step.generation;

    const auto    byDepth = countsByDepth(step.state.hierarchy->nodes);
    VerdictCounts all{};
    for (const auto& counts : byDepth)
        for (std::size_t i = 0; i < all.size(); ++i) all[i] += counts[i];
    m_verdicts->present(all);
    m_depths->present(byDepth);
    emit summaryChanged(counted(static_cast<std::uint64_t>(m_model->count()), tr("1 node"), tr("%1 nodes")));

    m_filling = true;
    for (const int id : m_unfolded)
        if (id < m_model->count()) m_tree->setExpanded(m_filter->mapFromSource(m_model->indexOf(id)), true);
    m_filling = false;
    showSelection(shown);
    fitColumns();
}

void HierarchyPanel::unfold(int id)
{
    for (int above = m_model->row(id).parent; above >= 0; above = m_model->row(above).parent) {
        m_unfolded.insert(above);
        m_tree->setExpanded(m_filter->mapFromSource(m_model->indexOf(above)), true);
    }
}

void HierarchyPanel::showSelection(const Snapshot& shown)
{
    if (m_model->isEmpty()) return;
    const HierarchyState& hierarchy = *shown.stepOfPicture()->state.hierarchy;
    const int             selected  = shown.selectedNode ? rowOf(hierarchy.nodes, *shown.selectedNode) : -1;
    const int             reveal    = selected >= 0 ? selected : shown.showsStep ? hierarchy.now : -1;
    m_filling                       = true;
    if (reveal >= 0) unfold(reveal);
    const QModelIndex at = m_filter->mapFromSource(m_model->indexOf(reveal));
    if (selected >= 0 && at.isValid())
        m_tree->setCurrentIndex(at);
    else
        m_tree->selectionModel()->clear();
    if (at.isValid() && !m_tree->hasFocus()) m_tree->scrollTo(at, QAbstractItemView::PositionAtCenter);
    m_filling = false;
}

void HierarchyPanel::fitColumns()
{
    const QFontMetrics metrics = m_tree->fontMetrics();
    const auto         wide    = [&](const QString& text) { return metrics.horizontalAdvance(text) + 14; };
    const int          verdict = wide(QStringLiteral("\u25A0 ") + tr("too small") + QStringLiteral(" "));
    const int          screen  = std::max(wide(tr("screen px")), wide(tr("around the eye")));
    const int          nearest = std::max(wide(tr("nearest D")), wide(QStringLiteral("0.0000")));
    const int          room    = m_tree->viewport()->width();
    m_tree->setColumnWidth(NodeModel::Verdict, verdict);
    m_tree->setColumnWidth(NodeModel::Screen, screen);
    m_tree->setColumnWidth(NodeModel::Nearest, nearest);
    m_tree->setColumnWidth(NodeModel::Node, std::max(92, room - verdict - screen - nearest));
}

bool HierarchyPanel::eventFilter(QObject* object, QEvent* event)
{
    if (object == m_tree->viewport() && event->type() == QEvent::Resize) fitColumns();
    return Panel::eventFilter(object, event);
}

void HierarchyPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_model) m_model->setPalette(palette());
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
