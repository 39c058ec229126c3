// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/measure/stages_model.h"

#include <QCoreApplication>
#include <QFont>
#include <QFontDatabase>

#include "core/measure/unit_costs.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {
namespace {

struct StageCostWords {
    Q_DECLARE_TR_FUNCTIONS(StageCosts)
};

QString costText(const UnitCost& cost)
{
    const QString ns = decimal(cost.ns, cost.ns < 100 ? 1 : 0);
    switch (cost.unit) {
        case WorkUnit::Vertex:
            return StageCostWords::tr("%1 / vertex").arg(ns);
        case WorkUnit::Triangle:
            return StageCostWords::tr("%1 / triangle").arg(ns);
        case WorkUnit::Pixel:
            return StageCostWords::tr("%1 / pixel").arg(ns);
        case WorkUnit::Edge:
            return StageCostWords::tr("%1 / edge").arg(ns);
        case WorkUnit::ActiveEdge:
            return StageCostWords::tr("%1 / active edge").arg(ns);
        case WorkUnit::Node:
            return StageCostWords::tr("%1 / node").arg(ns);
        case WorkUnit::Cell:
            return StageCostWords::tr("%1 / cell").arg(ns);
        case WorkUnit::Window:
            return StageCostWords::tr("%1 / window").arg(ns);
    }
    return {};
}

QString costTexts(const std::vector<UnitCost>& costs)
{
    QStringList texts;
    for (const UnitCost& cost : costs) texts << costText(cost);
    return texts.join(QStringLiteral(" \u00B7 "));
}

QVariant aligned(bool right)
{
    return QVariant::fromValue(Qt::Alignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
}

}  // namespace

void StagesModel::present(std::optional<Run> run)
{
    beginResetModel();
    m_run = std::move(run);
    m_stages.clear();
    if (m_run)
        for (const Stage stage : kStages)
            if (m_run->row.stageQuartiles[static_cast<std::size_t>(stage)].q3 > 0) m_stages.push_back(stage);
    endResetModel();
}

int StagesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !m_run ? 0 : static_cast<int>(m_stages.size()) + 1;
}
int StagesModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant StagesModel::data(const QModelIndex& at, int role) const
{
    if (!checkIndex(at, CheckIndexOption::IndexIsValid)) return {};
    const BenchRow&      row     = m_run->row;
    const auto           column  = static_cast<Column>(at.column());
    const bool           isWhole = isFrame(at.row());
    const Stage          stage   = isWhole ? Stage::Other : m_stages[static_cast<std::size_t>(at.row())];
    const StageQuartiles times   = isWhole ? StageQuartiles{row.q1Ms, row.medianMs, row.q3Ms}
                                           : row.stageQuartiles[static_cast<std::size_t>(stage)];
    if (role == Qt::TextAlignmentRole) return aligned(column != Name);
    if (role == Qt::FontRole && isWhole) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    if (role == Qt::ToolTipRole && column == Cost) {
        QStringList counts;
        for (const UnitCost& cost : isWhole ? frameCosts(row) : unitCosts(row, stage)) counts << grouped(cost.count);
        if (counts.isEmpty()) return tr("Nothing that is counted is what this stage works on");
        return costTexts(isWhole ? frameCosts(row) : unitCosts(row, stage)) + '\n'
               + tr("The stage's time in the median frame over %1").arg(counts.join(QStringLiteral(" \u00B7 ")));
    }
    if (role != Qt::DisplayRole) return {};
    switch (column) {
        case Name:
            return isWhole ? tr("frame") : said(zscope::wordOf(stage));
        case Q1:
            return decimal(times.q1, 3);
        case Median:
            return decimal(times.median, 3);
        case Q3:
            return decimal(times.q3, 3);
        case Share: {  // of the medians beside it, so that the column is theirs and adds up
            double whole = 0;
            for (const Stage each : m_stages) whole += row.stageQuartiles[static_cast<std::size_t>(each)].median;
            return whole > 0 ? decimal(100 * (isWhole ? whole : times.median) / whole, 1) : QString();
        }
        case Cost:
            return costTexts(isWhole ? frameCosts(row) : unitCosts(row, stage));
        case kColumns:
            break;
    }
    return {};
}

QVariant StagesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
    if (role == Qt::TextAlignmentRole) return aligned(section != Name);
    if (role == Qt::ToolTipRole && section == Share) return tr("Of what the stages' medians add up to");
    if (role == Qt::ToolTipRole && section == Cost)
        return tr(
            "The stage's time in the median frame over the number of things that it worked on in that frame; with "
            "several threads wall "
            "time, not work");
    if (role != Qt::DisplayRole) return {};
    switch (static_cast<Column>(section)) {
        case Name:
            return tr("stage");
        case Q1:
            return tr("Q1, ms");
        case Median:
            return tr("median, ms");
        case Q3:
            return tr("Q3, ms");
        case Share:
            return tr("share, %");
        case Cost:
            return tr("ns per piece");
        case kColumns:
            break;
    }
    return {};
}

void CountersModel::present(const std::optional<Run>& run)
{
    beginResetModel();
    m_counters.clear();
    if (run)
        for (const NamedCount& counter : run->row.counters)
            if (counter.value > 0) m_counters.push_back(counter);
    endResetModel();
}

int CountersModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_counters.size());
}
int CountersModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 2; }

QVariant CountersModel::data(const QModelIndex& at, int role) const
{
    if (!checkIndex(at, CheckIndexOption::IndexIsValid)) return {};
    const NamedCount& counter = m_counters[static_cast<std::size_t>(at.row())];
    if (role == Qt::TextAlignmentRole) return aligned(at.column() == 1);
    if (role == Qt::FontRole && at.column() == 0) {
        QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
        fixed.setPointSizeF(fixed.pointSizeF() * 0.9);
        return fixed;
    }
    if (role != Qt::DisplayRole) return {};
    if (at.column() == 0) return QString::fromStdString(counter.name);
    return grouped(counter.value);
}

QVariant CountersModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section > 1) return {};
    if (role == Qt::TextAlignmentRole) return aligned(section == 1);
    if (role != Qt::DisplayRole) return {};
    return section == 0 ? tr("work of the textbook method") : tr("count");
}

}  // namespace zscope::ui
