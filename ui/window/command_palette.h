// SPDX-License-Identifier: GPL-3.0-or-later
// Every command of the window by a few letters of its name, with its keys; driven by the keyboard alone.
//
// Keys       letters filter, Up and Down choose, Enter runs, Escape closes
#pragma once

#include <vector>

#include <QAbstractListModel>
#include <QDialog>
#include <QPointer>

class QAction;
class QLineEdit;
class QListView;

namespace zscope::ui {

class CommandModel final : public QAbstractListModel {
    Q_OBJECT

public:
    /// Besides the label a command is found by its object name, which no language changes.
    explicit CommandModel(std::vector<QAction*> commands, QObject* parent = nullptr);

    /// The best match first; with an empty query all, in the order of the menus.
    void     filter(const QString& query);
    QAction* at(int row) const;

    int      rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    std::vector<QPointer<QAction>> m_commands;
    std::vector<std::size_t>       m_shown;
};

class CommandPalette final : public QDialog {
    Q_OBJECT

public:
    CommandPalette(std::vector<QAction*> commands, QWidget* parent);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void run();

    CommandModel* m_model;
    QLineEdit*    m_query;
    QListView*    m_list;
};

}  // namespace zscope::ui
