// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/trace/trace_models.h"

#include <QRegularExpression>

#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

using check::Likeness;

Likeness likenessOf(const check::JudgedRow& row)
{
    return row.isWrong() ? Likeness::Differs : row.isRounding ? Likeness::Rounding : Likeness::Same;
}

QString shapeOf(Likeness likeness)
{
    switch (likeness) {
        case Likeness::Same:
            return QStringLiteral("\u2713");
        case Likeness::Rounding:
            return QStringLiteral("\u2248");
        case Likeness::Differs:
            break;
    }
    return QStringLiteral("\u2716");
}

QString nameOf(Likeness likeness)
{
    switch (likeness) {
        case Likeness::Same:
            return TraceRowsModel::tr("the same");
        case Likeness::Rounding:
            return TraceRowsModel::tr("differs by rounding alone");
        case Likeness::Differs:
            break;
    }
    return TraceRowsModel::tr("differs");
}

const QColor& colourOf(Likeness likeness, const Theme& theme)
{
    return likeness == Likeness::Differs ? theme.error : likeness == Likeness::Same ? theme.entered : theme.softText;
}

}  // namespace

QString momentOf(const check::MomentKey& key)
{
    static const QRegularExpression comma(QStringLiteral("[,\uFF0C]$"));
    return said(check::phraseOf(key)).remove(comma);
}

// Rows --------------------------------------------------------------------------------------------------------------

void TraceRowsModel::present(std::shared_ptr<const check::Trace>       trace,
                             std::shared_ptr<const check::TraceAnswer> answer)
{
    if (m_answer == answer) return;
    beginResetModel();
    m_trace  = std::move(trace);
    m_answer = std::move(answer);
    m_now.reset();
    endResetModel();
}

void TraceRowsModel::presentNow(std::optional<std::size_t> row)
{
    if (row == m_now) return;
    const auto before = std::exchange(m_now, row);
    recolour(before);
    recolour(m_now);
}

void TraceRowsModel::recolour(std::optional<std::size_t> row)
{
    if (!row || static_cast<int>(*row) >= rowCount()) return;
    const int at = static_cast<int>(*row);
    emit      dataChanged(index(at, 0), index(at, kColumns - 1), {Qt::ForegroundRole, Qt::BackgroundRole});
}

void TraceRowsModel::setPalette(const QPalette& palette)
{
    m_palette = palette;
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1), {Qt::ForegroundRole, Qt::BackgroundRole});
}

int TraceRowsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !m_answer ? 0 : static_cast<int>(m_answer->rows.size());
}

int TraceRowsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant TraceRowsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const auto              at       = static_cast<std::size_t>(index.row());
    const check::JudgedRow& judged   = m_answer->rows[at];
    const check::TraceRow&  row      = m_trace->rows[at];
    const Likeness          likeness = likenessOf(judged);
    const Theme&            theme    = themeOf(m_palette);
    switch (role) {
        case Qt::DisplayRole:
            return index.column() == Mark   ? shapeOf(likeness)
                   : index.column() == Line ? grouped(static_cast<std::uint64_t>(row.line))
                                            : momentOf(row.key);
        case Qt::AccessibleTextRole:
            return index.column() == Mark ? nameOf(likeness) : data(index, Qt::DisplayRole);
        case Qt::ToolTipRole:
            return judged.isWrong() ? said(judged.sentence) : nameOf(likeness);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::Alignment(index.column() == Mark   ? Qt::AlignCenter
                                                     : index.column() == Line ? Qt::AlignRight | Qt::AlignVCenter
                                                                              : Qt::AlignLeft | Qt::AlignVCenter));
        case Qt::ForegroundRole:
            return index.column() == Mark || likeness == Likeness::Differs ? colourOf(likeness, theme)
                   : index.column() == Line                                ? theme.softText
                                                                           : theme.text;
        case Qt::BackgroundRole:
            if (m_now == at) return theme.nowTint;
            return {};
        default:
            return {};
    }
}

QVariant TraceRowsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment(section == Line ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter));
    if (role == Qt::ToolTipRole) {
        if (section == Mark) return tr("✓ the same, ≈ differs by rounding alone, ✖ differs");
        return section == Line ? tr("Line of the file") : tr("The step of our run that the row is held against");
    }
    if (role != Qt::DisplayRole || section == Mark) return {};
    return section == Line ? tr("line") : tr("moment");
}

// Fields ------------------------------------------------------------------------------------------------------------

bool TraceFieldsModel::present(const std::vector<check::FieldBeside>& fields)
{
    if (fields == m_fields) return false;
    beginResetModel();
    m_fields = fields;
    endResetModel();
    return true;
}

void TraceFieldsModel::setPalette(const QPalette& palette)
{
    m_palette = palette;
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1), {Qt::ForegroundRole, Qt::BackgroundRole});
}

int TraceFieldsModel::firstDifference() const
{
    int found = -1;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (m_fields[i].likeness != Likeness::Differs) continue;
        const bool isPart = found >= 0 && m_fields[i].depth > m_fields[static_cast<std::size_t>(found)].depth;
        if (found >= 0 && !isPart) break;
        found = static_cast<int>(i);
    }
    return found;
}

int TraceFieldsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_fields.size());
}

int TraceFieldsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant TraceFieldsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const check::FieldBeside& field   = m_fields[static_cast<std::size_t>(index.row())];
    const Theme&              theme   = themeOf(m_palette);
    const bool                isValue = index.column() == Ours || index.column() == Theirs;
    const bool                isEmpty = field.ours.empty() && field.theirs.empty();  // its parts follow
    switch (role) {
        case Qt::DisplayRole:
            if (index.column() == Mark) return field.likeness == Likeness::Same ? QString() : shapeOf(field.likeness);
            if (index.column() == Field) return QString(3 * field.depth, ' ') + utf8Text(field.name);
            if (isEmpty) return {};
            return field.likeness == Likeness::Differs && (index.column() == Ours ? field.ours : field.theirs).empty()
                       ? QStringLiteral("\u2013")
                       : utf8Text(index.column() == Ours ? field.ours : field.theirs);
        case Qt::AccessibleTextRole:
            return index.column() == Mark ? nameOf(field.likeness) : data(index, Qt::DisplayRole);
        case Qt::ToolTipRole:
            return isValue && !isEmpty ? data(index, Qt::DisplayRole) : nameOf(field.likeness);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::Alignment(index.column() == Mark ? Qt::AlignCenter
                                                     : isValue              ? Qt::AlignRight | Qt::AlignVCenter
                                                                            : Qt::AlignLeft | Qt::AlignVCenter));
        case Qt::ForegroundRole:
            return index.column() == Mark || field.likeness == Likeness::Differs ? colourOf(field.likeness, theme)
                                                                                 : theme.text;
        case Qt::BackgroundRole:
            if (field.likeness == Likeness::Differs && isValue && !isEmpty) return theme.errorTint;
            return {};
        default:
            return {};
    }
}

QVariant TraceFieldsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) return {};
    const bool isValue = section == Ours || section == Theirs;
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment(isValue ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter));
    if (role == Qt::ToolTipRole) {
        if (section == Ours) return tr("What our run holds after the step of this row");
        return section == Theirs ? tr("What the row of your trace says") : QString();
    }
    if (role != Qt::DisplayRole || section == Mark) return {};
    return section == Field ? tr("field") : section == Ours ? tr("ours") : tr("yours");
}

}  // namespace zscope::ui
