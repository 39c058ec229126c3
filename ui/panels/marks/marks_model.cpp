// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/marks/marks_model.h"

#include "ui/text/grains.h"
#include "ui/text/numbers.h"

namespace zscope::ui {

void MarksModel::present(const Marks& marks)
{
    if (marks.bookmarks == m_marks.bookmarks && marks.breakpoints == m_marks.breakpoints) return;
    if (marks.bookmarks.size() == m_marks.bookmarks.size() && marks.breakpoints.size() == m_marks.breakpoints.size()) {
        m_marks = marks;  // the selection stays
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
        return;
    }
    beginResetModel();
    m_marks = marks;
    endResetModel();
}

std::optional<std::size_t> MarksModel::bookmarkOf(int row) const
{
    if (row < 0 || row >= static_cast<int>(m_marks.bookmarks.size())) return {};
    return static_cast<std::size_t>(row);
}

std::optional<std::size_t> MarksModel::breakpointOf(int row) const
{
    const int first = static_cast<int>(m_marks.bookmarks.size());
    if (row < first || row >= rowCount()) return {};
    return static_cast<std::size_t>(row - first);
}

int MarksModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_marks.bookmarks.size() + m_marks.breakpoints.size());
}

int MarksModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant MarksModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) return {};
    if (const auto at = bookmarkOf(index.row())) {
        const Bookmark& mark = m_marks.bookmarks[*at];
        if (role == Qt::EditRole && index.column() == Name) return mark.name;
        if (role == Qt::ToolTipRole) return tr("Enter goes there, F2 renames it, Del removes it");
        if (role != Qt::DisplayRole) return {};
        if (index.column() == Name) return QStringLiteral("\u2605 ") + mark.name;
        return tr("%1, %2 %3")
            .arg(QString::fromStdString(zscope::nameOf(mark.pipeline)), nameOf(mark.grain), grouped(mark.step + 1));
    }
    if (const auto at = breakpointOf(index.row())) {
        if (role == Qt::ToolTipRole) return tr("F5 runs to where it is met next, Shift+F5 back, Del removes it");
        if (role != Qt::DisplayRole) return {};
        return index.column() == Name ? QStringLiteral("\u25CF ") + textOf(m_marks.breakpoints[*at]) : tr("breakpoint");
    }
    return {};
}

QVariant MarksModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == Name ? tr("mark") : tr("where");
}

Qt::ItemFlags MarksModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.column() == Name && bookmarkOf(index.row()) ? flags | Qt::ItemIsEditable : flags;
}

bool MarksModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const auto at = bookmarkOf(index.row());
    if (role != Qt::EditRole || index.column() != Name || !at || value.toString().trimmed().isEmpty()) return false;
    m_session.nameBookmark(*at, value.toString());
    return true;
}

}  // namespace zscope::ui
