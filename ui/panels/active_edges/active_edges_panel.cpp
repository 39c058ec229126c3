// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/active_edges/active_edges_panel.h"

#include <algorithm>

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QStackedLayout>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/panels/active_edges/bucket_chart.h"
#include "ui/panels/active_edges/edge_table_model.h"
#include "ui/panels/active_edges/line_strip.h"
#include "ui/parts/row_delegate.h"
#include "ui/parts/scrolling.h"
#include "ui/predict/predict_bar.h"
#include "ui/predict/predictions.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

namespace {

constexpr int         kLowest        = 200;  // a few rows; what lies below them is scrolled to on a low screen
constexpr std::size_t kPolygonsNamed = 60;   // the tool tip of the list; the line itself shows what fits

}  // namespace

ActiveEdgesPanel::ActiveEdgesPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_model(new EdgeTableModel(this)), m_table(new QTableView), m_changes(new QLabel),
      m_polygons(new QLabel), m_hint(new QLabel), m_strip(new LineStrip), m_buckets(new BucketChart)
{
    m_table->setModel(m_model);
    m_table->setItemDelegate(new RowDelegate(m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setMinimumHeight(100);
    QFont small = m_table->font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    m_table->setFont(small);
    m_table->horizontalHeader()->setFont(small);
    m_table->viewport()->installEventFilter(this);              // its width is known last
    m_table->setColumnHidden(EdgeTableModel::FirstLine, true);  // in the tool tip; the last line decides
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setMinimumSectionSize(18);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);

    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setMargin(2 * kStep);
    m_changes->setTextFormat(Qt::RichText);
    m_polygons->setObjectName("soft");
    for (QLabel* label : {m_changes, m_polygons}) label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);

    auto* tableOrHint = new QWidget;
    m_tableOrHint     = new QStackedLayout(tableOrHint);
    m_tableOrHint->addWidget(m_table);
    m_tableOrHint->addWidget(m_hint);

    m_room       = new ScrolledPart;
    auto* layout = new QVBoxLayout(m_room);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(6);
    layout->addWidget(new PredictBar(session, Topic::Edges));
    layout->addWidget(tableOrHint, 1);
    layout->addWidget(m_changes);
    layout->addWidget(m_polygons);
    layout->addWidget(m_strip);
    layout->addWidget(m_buckets);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    QWidget* room = scrolling(m_room);
    room->setMinimumHeight(kLowest);
    whole->addWidget(room);

    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
        if (m_filling || !row.isValid()) return;
        this->session().selectEdge(m_model->rows()[static_cast<std::size_t>(row.row())].edge);
    });
    connect(m_strip, &LineStrip::picked, this, [this](int x) {
        if (const SweepState* sweep = this->session().now().sweep()) this->session().pick(QPoint(x, sweep->y));
    });
    spoken(*this, [this] { m_table->setAccessibleName(tr("Active edge table")); });
}

void ActiveEdgesPanel::present(const Snapshot& now, Changes what)
{
    const auto      before = session().predictions().before(Topic::Edges, now);  // while a question is open
    const Snapshot& shown  = before ? *before : now;
    if (!(what & (Change::Picture | Change::Selection | Change::Pipeline | Change::Scene))) return;
    showRows(shown, what);
    showWords(shown);
    m_strip->present(shown);
    m_buckets->present(shown);
}

void ActiveEdgesPanel::showRows(const Snapshot& shown, Changes what)
{
    const bool sameRows = !(what & (Change::Picture | Change::Pipeline | Change::Scene));
    m_filling           = true;
    if (sameRows) {
        m_model->presentPick(shown);
    } else {
        m_model->setPalette(palette());
        m_model->present(shown);
        fitColumns();
    }
    const int selected = shown.selectedEdge ? m_model->rowOf(*shown.selectedEdge) : -1;
    if (selected < 0)
        m_table->clearSelection();
    else if (!m_table->selectionModel()->isRowSelected(selected))
        m_table->selectRow(selected);
    m_filling = false;
    if (sameRows && selected >= 0) return;  // the row is under the user's hand
    const bool rows = !m_model->rows().empty();
    m_tableOrHint->setCurrentIndex(rows ? 0 : 1);  // before scrolling: a hidden table does not scroll

    int reveal = selected;
    if (reveal < 0) {  // what the step or the pick is about
        const auto picked = pickedTriangle(shown);
        const auto found  = std::ranges::find_if(m_model->rows(), [&](const EdgeTableModel::Row& row) {
            return picked ? row.edge.polygon == *picked : row.state == EdgeTableModel::State::Now;
        });
        if (found != m_model->rows().end()) reveal = static_cast<int>(found - m_model->rows().begin());
    }
    if (reveal >= 0) m_table->scrollTo(m_model->index(reveal, 0), QAbstractItemView::PositionAtCenter);

    const SweepState* sweep = shown.sweep();
    if (rows) return;
    if (!drawsLineByLine(shown.pipeline))
        m_hint->setText(tr("This algorithm keeps no active edges. Choose the scanline algorithm to see them."));
    else if (!sweep)
        m_hint->setText(shown.scene ? tr("The edges appear when the edge table has been built.")
                                    : tr("Open a scene to see its edges."));
    else if (shown.showsStep)
        m_hint->setText(shown.grain == Grain::Line
                            ? tr("No edge is active on this line. Press Right to go on.")
                            : tr("No edge is active here. Press Right to go on, or choose the grain “line”."));
    else
        m_hint->setText(
            tr("The picture is finished and no edge is active. Press Left to step back, or drag the timeline."));
}

void ActiveEdgesPanel::showWords(const Snapshot& shown)
{
    const SweepState* sweep = shown.sweep();
    const bool        line  = sweep && sweep->y >= 0;
    m_changes->setVisible(line);
    m_polygons->setVisible(line);
    if (!line) {
        emit summaryChanged({});
        return;
    }
    emit summaryChanged(tr("line %1 · %2 · %3")
                            .arg(grouped(static_cast<unsigned>(sweep->y)),
                                 counted(sweep->activeEdges.size(), tr("1 edge"), tr("%1 edges")),
                                 counted(sweep->activePolygons.size(), tr("1 polygon"), tr("%1 polygons"))));

    const Theme& theme = themeOf(palette());
    m_changes->setText(
        QStringLiteral("<span style='color:%1'>▲</span> %2 &nbsp;&nbsp; <span style='color:%3'>▼</span> %4")
            .arg(theme.entered.name(), tr("%1 entered").arg(grouped(sweep->entered.size())), theme.left.name(),
                 tr("%1 left").arg(grouped(sweep->left.size()))));

    QStringList ids;
    for (std::size_t i = 0; i < sweep->activePolygons.size() && i < kPolygonsNamed; ++i)
        ids << grouped(sweep->activePolygons[i].value);
    QString all = ids.join(QStringLiteral("   "));
    if (sweep->activePolygons.size() > kPolygonsNamed) all += QStringLiteral(" …");
    m_polygonText = tr("Active polygons   %1").arg(all.isEmpty() ? tr("none") : all);
    m_polygons->setToolTip(all);
    fitPolygons();
}

void ActiveEdgesPanel::fitPolygons()
{
    const QMargins margins = m_room->layout()->contentsMargins();
    const int      room    = m_room->width() - margins.left() - margins.right();
    m_polygons->setText(m_polygons->fontMetrics().elidedText(m_polygonText, Qt::ElideRight, room));
}

bool ActiveEdgesPanel::eventFilter(QObject* object, QEvent* event)
{
    if (object == m_table->viewport() && event->type() == QEvent::Resize) {
        fitColumns();
        fitPolygons();
    }
    return Panel::eventFilter(object, event);
}

void ActiveEdgesPanel::fitColumns()
{
    // As wide as the widest text, and no narrower than a little while ago, so that columns do not dance.
    using Model                 = EdgeTableModel;
    constexpr int      kPadding = 9, kSlack = 24;
    const QFontMetrics metrics = m_table->fontMetrics();
    for (int column = 0; column < Model::kColumns; ++column) {
        int width = metrics.horizontalAdvance(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        if (const int row = m_model->widestRow(static_cast<Model::Column>(column)); row >= 0)
            width = std::max(width, metrics.horizontalAdvance(m_model->index(row, column).data().toString()));
        width += kPadding;
        int& kept = m_widths[static_cast<std::size_t>(column)];
        if (width > kept || width < kept - kSlack) kept = width;
    }
    m_widths[Model::Mark] = 20;
    int free              = m_table->viewport()->width();
    for (int column = 0; column < Model::kColumns; ++column)
        if (!m_table->isColumnHidden(column)) free -= m_widths[static_cast<std::size_t>(column)];
    const int share = std::max(0, free) / (Model::kColumns - 2);  // all but the mark and the hidden one
    for (int column = 0; column < Model::kColumns; ++column)
        m_table->setColumnWidth(column,
                                m_widths[static_cast<std::size_t>(column)] + (column == Model::Mark ? 0 : share));
    m_table->verticalHeader()->setDefaultSectionSize(metrics.height() + 5);
}

void ActiveEdgesPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        m_model->setPalette(palette());
        present(session().now(), Change::Picture);
    }
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
