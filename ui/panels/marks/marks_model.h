// SPDX-License-Identifier: GPL-3.0-or-later
// Bookmarks, then breakpoints, as rows. A bookmark's name can be edited.
#pragma once

#include <QAbstractTableModel>

#include "ui/session/session.h"

namespace zscope::ui {

class MarksModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Where, kColumns };

    explicit MarksModel(Session& session, QObject* parent = nullptr) : QAbstractTableModel(parent), m_session(session)
    {}

    void present(const Marks& marks);

    /// The number of a row's bookmark; nothing: the row is a breakpoint.
    std::optional<std::size_t> bookmarkOf(int row) const;
    std::optional<std::size_t> breakpointOf(int row) const;
    const Marks&               marks() const { return m_marks; }

    int           rowCount(const QModelIndex& parent = {}) const override;
    int           columnCount(const QModelIndex& parent = {}) const override;
    QVariant      data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant      headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool          setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

private:
    Session& m_session;
    Marks    m_marks;
};

}  // namespace zscope::ui
