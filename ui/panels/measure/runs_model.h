// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of one view as a table that can be sorted. Units stand in the headers, numbers are right-aligned.
#pragma once

#include <vector>

#include <QAbstractTableModel>
#include <QPalette>
#include <QSortFilterProxyModel>

#include "ui/panels/measure/measurer.h"

namespace zscope::ui {

class RunsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Algorithm, Choices, Median, Wrong, Worst, Q1, Q3, Best, kColumns };
    static constexpr int kSortRole = Qt::UserRole;  // a number, or for names the text

    explicit RunsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void present(std::vector<Run> runs);
    void setPalette(const QPalette& palette);

    const std::vector<Run>& runs() const { return m_runs; }

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<Run> m_runs;
    QPalette         m_palette;
};

/// The same, sorted; the header of the column that decides says which way.
class SortedRuns final : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit SortedRuns(RunsModel& runs, QObject* parent = nullptr);

    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void     sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
};

/// A run in words: what was timed, and what of its picture. The times of a broken one are called no result.
QString sentenceOf(const Run& run);
/// The preset's name, and after it what differs from it: "near=drop".
QString algorithmOf(const Run& run);
QString choicesOf(const Run& run);

}  // namespace zscope::ui
