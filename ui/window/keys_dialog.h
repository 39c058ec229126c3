// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of every command: found by its name, changed, and put back. Changes hold at once.
#pragma once

#include <vector>

#include <QAbstractTableModel>
#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace zscope::ui {

class KeyBindings;

class KeysModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Command, Keys, Default, kColumns };

    explicit KeysModel(KeyBindings& bindings, QObject* parent = nullptr);

    void     refresh();
    QAction* at(int row) const;

    int      rowCount(const QModelIndex& parent = {}) const override;
    int      columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    KeyBindings&          m_bindings;
    std::vector<QAction*> m_commands;  // those that are listed
};

class KeysDialog final : public QDialog {
    Q_OBJECT

public:
    KeysDialog(KeyBindings& bindings, QWidget* parent);

private:
    QAction* chosen() const;
    void     showChosen();
    void     showConflict();
    void     change(const QList<QKeySequence>& keys);

    KeyBindings&           m_bindings;
    KeysModel*             m_model;
    QSortFilterProxyModel* m_found;
    QLineEdit*             m_filter;
    QTableView*            m_table;
    QKeySequenceEdit*      m_keys;
    QLabel*                m_conflict;
    QPushButton *          m_assign, *m_none, *m_default, *m_all;
};

}  // namespace zscope::ui
