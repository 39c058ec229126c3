// SPDX-License-Identifier: GPL-3.0-or-later
// The active edge table of one line as rows, with the edges that have just left it in their places.
//
// Rows       sorted by x as the algorithm keeps them; an edge that left stands where its x would be
// Marks      entered, left, now: a shape and a colour each, and the word in the tool tip and for screen readers
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QAbstractTableModel>
#include <QPalette>

#include "ui/session/snapshot.h"

namespace zscope::ui {

class EdgeTableModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Mark, Polygon, X, XSubpixels, Dx, DxFraction, FirstLine, LastLine, kColumns };
    enum class State { Active, Entered, Left, Now };

    struct Row {
        EdgeRow edge;
        State   state = State::Active;
    };

    explicit EdgeTableModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// Replaces all rows.
    void present(const Snapshot& shown);
    /// Keeps the rows; those of the picked triangle light up.
    void presentPick(const Snapshot& shown);
    void setPalette(const QPalette& palette);

    const std::vector<Row>& rows() const { return m_rows; }
    /// The row of the same edge, or -1.
    int rowOf(const EdgeRow& edge) const;
    /// The row with the longest number of a column, found without writing them all; -1 if there is none.
    int widestRow(Column column) const;

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const Row& row, Column column) const;
    QString stateText(State state) const;
    void    recolour();

    std::vector<Row>          m_rows;
    std::optional<TriangleId> m_picked;
    QPalette                  m_palette;
};

/// The rows of a sweep's state: active edges and those that left, marked, sorted by x.
std::vector<EdgeTableModel::Row> rowsOf(const StepState& state);

}  // namespace zscope::ui
