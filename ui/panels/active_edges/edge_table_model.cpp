// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/active_edges/edge_table_model.h"

#include <algorithm>
#include <cmath>

#include <QFont>
#include <QFontDatabase>

#include "ui/text/numbers.h"
#include "ui/theme/theme.h"
#include "ui/view/overlay.h"

namespace zscope::ui {

std::vector<EdgeTableModel::Row> rowsOf(const StepState& state)
{
    using Row = EdgeTableModel::Row;
    std::vector<Row> rows;
    if (!state.sweep) return rows;
    const SweepState& sweep = *state.sweep;

    std::optional<TriangleId> now;  // whose span or pixel this step is about
    if (state.pixel)
        now = state.pixel->triangle;
    else if (state.span && state.event >= Grain::Span)
        now = state.span->polygon;

    const EdgeNames entered(sweep.entered);
    for (const EdgeRow& edge : sweep.activeEdges) {
        rows.push_back({edge, now && edge.polygon == *now ? EdgeTableModel::State::Now
                              : entered.holds(edge)       ? EdgeTableModel::State::Entered
                                                          : EdgeTableModel::State::Active});
    }
    for (const EdgeRow& edge : sweep.left) rows.push_back({edge, EdgeTableModel::State::Left});
    std::ranges::stable_sort(rows, {}, [](const Row& row) { return row.edge.x; });
    return rows;
}

void EdgeTableModel::present(const Snapshot& shown)
{
    beginResetModel();
    const ShownStep* step = shown.stepOfPicture();
    m_rows                = step ? rowsOf(step->state) : std::vector<Row>{};
    m_picked              = pickedTriangle(shown);
    endResetModel();
}

void EdgeTableModel::presentPick(const Snapshot& shown)
{
    m_picked = pickedTriangle(shown);
    recolour();
}

void EdgeTableModel::setPalette(const QPalette& palette)
{
    m_palette = palette;
    recolour();
}

void EdgeTableModel::recolour()
{
    if (!m_rows.empty())
        emit dataChanged(index(0, 0), index(static_cast<int>(m_rows.size()) - 1, kColumns - 1),
                         {Qt::ForegroundRole, Qt::BackgroundRole});
}

int EdgeTableModel::rowOf(const EdgeRow& edge) const
{
    const auto found = std::ranges::find_if(m_rows, [&](const Row& row) { return isSameEdge(row.edge, edge); });
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

int EdgeTableModel::widestRow(Column column) const
{
    const auto digits = [](double value) {
        double count = value < 0 ? 2 : 1;  // the sign's place
        for (double power = 10; power < 1e18 && std::abs(value) >= power; power *= 10) ++count;
        return count;
    };
    const auto length = [&](const Row& row) {
        const EdgeRow& edge = row.edge;
        const auto     top = static_cast<double>(edge.dx[0]), bottom = static_cast<double>(edge.dx[1]);
        switch (column) {
            case Polygon:
                return digits(edge.polygon.value);
            case X:
                return digits(edge.x);
            case XSubpixels:
                return digits(static_cast<double>(edge.xSubpixels));
            case Dx:
                return digits(std::trunc(top / bottom)) + 0.5 * (top < 0);
            case DxFraction:
                return digits(top) + digits(bottom);
            case FirstLine:
                return digits(edge.firstLine);
            case LastLine:
                return digits(edge.lastLine);
            case Mark:
            case kColumns:
                break;
        }
        return 0.0;
    };
    const auto widest = std::ranges::max_element(m_rows, {}, length);
    return widest == m_rows.end() ? -1 : static_cast<int>(widest - m_rows.begin());
}

int EdgeTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int EdgeTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString EdgeTableModel::stateText(State state) const
{
    switch (state) {
        case State::Entered:
            return tr("entered on this line");
        case State::Left:
            return tr("has left: its last line is over");
        case State::Now:
            return tr("this step is about its polygon");
        case State::Active:
            break;
    }
    return tr("active");
}

QString EdgeTableModel::text(const Row& row, Column column) const
{
    const EdgeRow& edge = row.edge;
    switch (column) {
        case Mark:
            switch (row.state) {
                case State::Entered:
                    return QStringLiteral("\u25B2");
                case State::Left:
                    return QStringLiteral("\u25BC");
                case State::Now:
                    return QStringLiteral("\u25CF");
                case State::Active:
                    return {};
            }
            return {};
        case Polygon:
            return grouped(edge.polygon.value);
        case X:
            return decimal(edge.x, 2);
        case XSubpixels:
            return groupedSigned(edge.xSubpixels);
        case Dx:
            return signedDecimal(static_cast<double>(edge.dx[0]) / static_cast<double>(edge.dx[1]), 4);
        case DxFraction:
            return fraction(edge.dx);
        case FirstLine:
            return groupedSigned(edge.firstLine);
        case LastLine:
            return groupedSigned(edge.lastLine);
        case kColumns:
            break;
    }
    return {};
}

QVariant EdgeTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Row&   row    = m_rows[static_cast<std::size_t>(index.row())];
    const auto   column = static_cast<Column>(index.column());
    const Theme& theme  = themeOf(m_palette);
    const bool   picked = m_picked && row.edge.polygon == *m_picked;
    switch (role) {
        case Qt::DisplayRole:
            return text(row, column);
        case Qt::AccessibleTextRole:
            return column == Mark ? stateText(row.state) : text(row, column);
        case Qt::ToolTipRole:
            return tr("Triangle %1, lines %2 to %3: %4")
                .arg(grouped(row.edge.polygon.value), groupedSigned(row.edge.firstLine),
                     groupedSigned(row.edge.lastLine), stateText(row.state));
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(
                Qt::Alignment(column == Mark ? Qt::AlignCenter : Qt::AlignRight | Qt::AlignVCenter));
        case Qt::BackgroundRole:
            if (picked) return theme.pickedTint;
            if (row.state == State::Now) return theme.nowTint;
            return {};
        case Qt::ForegroundRole:
            if (column == Mark)
                return row.state == State::Entered ? theme.entered : row.state == State::Left ? theme.left : theme.now;
            if (row.state == State::Left || column == XSubpixels || column == DxFraction || column == FirstLine)
                return theme.softText;
            return theme.text;
        default:
            return {};
    }
}

QVariant EdgeTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    const auto column = static_cast<Column>(section);
    if (role == Qt::ToolTipRole) {
        switch (column) {
            case Mark:
                return tr("\u25B2 entered on this line, \u25BC has just left, \u25CF this step");
            case Polygon:
                return tr("The triangle that the edge bounds");
            case X:
                return tr("Where the edge meets the line's centre, in pixels");
            case XSubpixels:
                return tr("The same in 1/256 of a pixel, rounded down");
            case Dx:
                return tr("How far x moves from one line to the next, in pixels");
            case DxFraction:
                return tr("The same as an exact fraction");
            case FirstLine:
                return tr("The first line that the edge crosses");
            case LastLine:
                return tr("The last line that the edge crosses");
            case kColumns:
                return {};
        }
    }
    if (role != Qt::DisplayRole) return {};
    switch (column) {
        case Mark:
            return QString();
        case Polygon:
            return tr("polygon");
        case X:
            return tr("x");
        case XSubpixels:
            return tr("x·256");
        case Dx:
            return tr("dx");
        case DxFraction:
            return tr("exact");
        case FirstLine:
            return tr("first");
        case LastLine:
            return tr("last");
        case kColumns:
            break;
    }
    return {};
}

}  // namespace zscope::ui
