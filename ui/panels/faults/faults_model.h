// SPDX-License-Identifier: GPL-3.0-or-later
// The faults of the gallery as rows: which is switched on, and how many pixels each spoils.
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "ui/panels/faults/fault_pictures.h"

namespace zscope::ui {

class FaultsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Title, Wrong, kColumns };

    explicit FaultsModel(QObject* parent = nullptr);

    void forget();
    void add(FaultPicture picture);
    void setChosen(const FaultSet& faults);
    /// nullptr: not drawn yet, or not possible here.
    const FaultPicture* pictureOf(int row) const;

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<std::optional<FaultPicture>> m_pictures;  // in the order of faults()
    FaultSet                                 m_chosen;
};

}  // namespace zscope::ui
