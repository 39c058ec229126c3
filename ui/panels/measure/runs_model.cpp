// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/measure/runs_model.h"

#include <QCoreApplication>
#include <QFont>

#include "ui/charts/speed_error_points.h"
#include "ui/text/numbers.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

struct RunsWords {
    Q_DECLARE_TR_FUNCTIONS(Runs)
};

double timeOf(const BenchRow& row, RunsModel::Column column)
{
    switch (column) {
        case RunsModel::Median:
            return row.medianMs;
        case RunsModel::Q1:
            return row.q1Ms;
        case RunsModel::Q3:
            return row.q3Ms;
        default:
            return row.bestMs;
    }
}

bool isNumber(int column) { return column >= RunsModel::Median; }

}  // namespace

QString algorithmOf(const Run& run)
{
    const QString name = QString::fromStdString(run.row.algorithm);
    return name.section(QLatin1Char('+'), 0, 0);
}

QString choicesOf(const Run& run)
{
    QString choices = QString::fromStdString(run.row.algorithm)
                          .section(QLatin1Char('+'), 1)
                          .replace(QLatin1Char('+'), QLatin1Char(' '));
    if (!run.row.chosen.empty())
        choices += (choices.isEmpty() ? QString() : QStringLiteral(" ")) + QStringLiteral("\u2192 ")
                   + QString::fromStdString(run.row.chosen);
    return choices;
}

QString sentenceOf(const Run& run)
{
    const BenchRow& row  = run.row;
    const QString   name = QString::fromStdString(row.algorithm);
    const QString   simd = QString::fromUtf8(zscope::wordOf(row.simd).data());
    QString         said = row.threads == 1 ? RunsWords::tr("%1, 1 thread, %2.").arg(name, simd)
                                            : RunsWords::tr("%1, %2 threads, %3.").arg(name).arg(row.threads).arg(simd);
    if (!row.chosen.empty()) said += ' ' + RunsWords::tr("It chose %1.").arg(QString::fromStdString(row.chosen));
    if (!row.figures) return said + ' ' + RunsWords::tr("Its picture was not checked.");
    const ErrorFigures& figures = *row.figures;
    if (row.isBroken())
        said += ' '
                + RunsWords::tr("Its picture is WRONG although it promised to be exact: %1. Its time is no result.")
                      .arg(counted(*row.wrongPixels, RunsWords::tr("1 pixel differs in triangle or depth"),
                                   RunsWords::tr("%1 pixels differ in triangle or depth")));
    else if (*row.wrongPixels == 0)
        return said + ' '
               + (row.claim == Claim::ExactByFace ? RunsWords::tr("Its faces cover exactly what they should.")
                                                  : RunsWords::tr("Its picture is the reference's, to the bit."));
    said += ' '
            + RunsWords::tr(
                  "%1 holes, %2 spills, %3 other surfaces, of them %4 near ties; %5 depths differ, by up to %6 float32 "
                  "steps.")
                  .arg(grouped(figures.holes), grouped(figures.spills), grouped(figures.wrongSurface()),
                       grouped(figures.nearTies), grouped(figures.depthBitsDiffer), grouped(figures.maxDepthSteps));
    return said;
}

SortedRuns::SortedRuns(RunsModel& runs, QObject* parent) : QSortFilterProxyModel(parent)
{
    setSourceModel(&runs);
    setSortRole(RunsModel::kSortRole);
}

QVariant SortedRuns::headerData(int section, Qt::Orientation orientation, int role) const
{
    const QVariant title = QSortFilterProxyModel::headerData(section, orientation, role);
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section != sortColumn()) return title;
    return title.toString()
           + (sortOrder() == Qt::AscendingOrder ? QStringLiteral(" \u25B4") : QStringLiteral(" \u25BE"));
}

void SortedRuns::sort(int column, Qt::SortOrder order)
{
    QSortFilterProxyModel::sort(column, order);
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

void RunsModel::present(std::vector<Run> runs)
{
    beginResetModel();
    m_runs = std::move(runs);
    endResetModel();
}

void RunsModel::setPalette(const QPalette& palette)
{
    m_palette = palette;
    if (!m_runs.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1), {Qt::ForegroundRole});
}

int RunsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_runs.size());
}
int RunsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant RunsModel::data(const QModelIndex& at, int role) const
{
    if (!checkIndex(at, CheckIndexOption::IndexIsValid)) return {};
    const Run&      run    = m_runs[static_cast<std::size_t>(at.row())];
    const BenchRow& row    = run.row;
    const auto      column = static_cast<Column>(at.column());
    switch (role) {
        case Qt::DisplayRole:
            switch (column) {
                case Algorithm:
                    return shapeOf(markOf(row)) + ' ' + algorithmOf(run);
                case Choices:
                    return choicesOf(run);
                case Wrong:
                    return row.figures ? grouped(static_cast<std::uint64_t>(errorOf(row, ErrorMeasure::WrongPixels)))
                                       : QStringLiteral("\u2013");
                case Worst:
                    return row.figures ? significant(errorOf(row, ErrorMeasure::DepthDistance), 3)
                                       : QStringLiteral("\u2013");
                default:
                    return decimal(timeOf(row, column), 3);
            }
        case kSortRole:
            switch (column) {
                case Algorithm:
                    return algorithmOf(run) + ' ' + choicesOf(run);
                case Choices:
                    return choicesOf(run);
                case Wrong:
                    return row.figures ? errorOf(row, ErrorMeasure::WrongPixels) : -1;
                case Worst:
                    return row.figures ? errorOf(row, ErrorMeasure::DepthDistance) : -1;
                default:
                    return timeOf(row, column);
            }
        case Qt::ToolTipRole:
            return sentenceOf(run);
        case Qt::AccessibleDescriptionRole:
            return sentenceOf(run);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(
                Qt::Alignment((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
        case Qt::ForegroundRole: {
            const Theme& theme = themeOf(m_palette);
            if (row.isBroken()) return theme.error;
            return column == Choices || column == Q1 || column == Q3 ? theme.softText : theme.text;
        }
        case Qt::FontRole: {
            if (!row.isBroken() || column == Wrong || column == Worst) return {};
            QFont struck;
            struck.setStrikeOut(true);
            return struck;
        }
        default:
            return {};
    }
}

QVariant RunsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment((isNumber(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    if (role == Qt::ToolTipRole && section == Wrong)
        return tr("Pixels that show another triangle than the reference, or one or none where it does not");
    if (role == Qt::ToolTipRole && section == Worst)
        return tr("The largest relative error of a view distance, wherever both show a triangle");
    if (role == Qt::ToolTipRole && (section == Q1 || section == Q3))
        return tr("Half of the frames took between the two quartiles");
    if (role != Qt::DisplayRole) return {};
    switch (static_cast<Column>(section)) {
        case Algorithm:
            return tr("algorithm");
        case Choices:
            return tr("choices");
        case Median:
            return tr("median, ms");
        case Q1:
            return tr("Q1, ms");
        case Q3:
            return tr("Q3, ms");
        case Best:
            return tr("best, ms");
        case Wrong:
            return tr("wrong px");
        case Worst:
            return tr("depth error");
        case kColumns:
            break;
    }
    return {};
}

}  // namespace zscope::ui
