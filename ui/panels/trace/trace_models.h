// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a trace, and the fields of one of them beside ours. Marks have a shape, a colour, and a word for screen
// readers: ✓ the same, ≈ rounding alone, ✖ differs.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QAbstractTableModel>
#include <QPalette>

#include "core/check/trace_beside.h"
#include "ui/session/tracer.h"

namespace zscope::ui {

/// "On line 41": what a row says of its moment, in the language of the window.
QString momentOf(const check::MomentKey& key);

class TraceRowsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Mark, Line, Moment, kColumns };

    explicit TraceRowsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// nullptr: no rows.
    void present(std::shared_ptr<const check::Trace> trace, std::shared_ptr<const check::TraceAnswer> answer);
    /// The row that the step on show has reached.
    void presentNow(std::optional<std::size_t> row);
    void setPalette(const QPalette& palette);

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    void recolour(std::optional<std::size_t> row);

    std::shared_ptr<const check::Trace>       m_trace;
    std::shared_ptr<const check::TraceAnswer> m_answer;
    std::optional<std::size_t>                m_now;
    QPalette                                  m_palette;
};

class TraceFieldsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Mark, Field, Ours, Theirs, kColumns };

    explicit TraceFieldsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// Whether they are others than before.
    bool present(const std::vector<check::FieldBeside>& fields);
    void setPalette(const QPalette& palette);
    /// The row of the first field that differs and has no parts that do; -1: none.
    int firstDifference() const;

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<check::FieldBeside> m_fields;
    QPalette                        m_palette;
};

}  // namespace zscope::ui
