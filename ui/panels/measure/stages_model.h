// SPDX-License-Identifier: GPL-3.0-or-later
// One run, stage by stage: quartiles, share of the frame, and what a piece of
// the stage's work cost. The last row is the frame.
#pragma once

#include <optional>
#include <vector>

#include <QAbstractTableModel>

#include "ui/panels/measure/measurer.h"

namespace zscope::ui {

class StagesModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Q1, Median, Q3, Share, Cost, kColumns };

    explicit StagesModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void present(std::optional<Run> run);

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    bool isFrame(int row) const { return row == static_cast<int>(m_stages.size()); }

    std::optional<Run> m_run;
    std::vector<Stage> m_stages;  // that took any time
};

/// The counters of a run that counted anything, as stats.json names them: the work of the textbook method.
class CountersModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit CountersModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void present(const std::optional<Run>& run);

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<NamedCount> m_counters;
};

}  // namespace zscope::ui
