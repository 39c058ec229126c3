// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of the hierarchy that the run has come to know, as a tree of rows, and the filter over it.
//
// Rows       children in the order in which they became known, which is that of the visit
// Ids        a node's row number in the state is its index's internal id: stable from step to step of one picture
#pragma once

#include <memory>
#include <vector>

#include <QAbstractItemModel>
#include <QPalette>
#include <QSortFilterProxyModel>

#include "core/lesson/outside_view.h"
#include "ui/session/snapshot.h"

namespace zscope::ui {

class NodeModel final : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { Node, Verdict, Screen, Nearest, kColumns };

    explicit NodeModel(QObject* parent = nullptr) : QAbstractItemModel(parent) {}

    void present(const Snapshot& shown);
    void setPalette(const QPalette& palette);

    bool           isEmpty() const { return m_nodes == nullptr || m_nodes->empty(); }
    const NodeRow& row(int id) const { return (*m_nodes)[static_cast<std::size_t>(id)]; }
    int idOf(const QModelIndex& index) const { return index.isValid() ? static_cast<int>(index.internalId()) : -1; }
    QModelIndex             indexOf(int id, int column = 0) const;
    int                     count() const { return m_nodes ? static_cast<int>(m_nodes->size()) : 0; }
    const std::vector<int>& childrenOf(int id) const
    {
        return id < 0 ? m_roots : m_children[static_cast<std::size_t>(id)];
    }

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int         rowCount(const QModelIndex& parent = {}) const override;
    int         columnCount(const QModelIndex& parent = {}) const override;
    QVariant    data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant    headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const NodeRow& row, Column column) const;

    std::shared_ptr<const ShownStep>   m_step;  // keeps m_nodes
    std::shared_ptr<const LoadedScene> m_scene;
    const std::vector<NodeRow>*        m_nodes = nullptr;
    std::vector<std::vector<int>>      m_children;
    std::vector<int>                   m_roots, m_place;  // m_place: which child of its parent a node is
    int                                m_now = -1;
    QPalette                           m_palette;
};

class NodeFilter final : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit NodeFilter(NodeModel& model, QObject* parent = nullptr);

    /// Part of a path, or the number of an instance.
    void setText(const QString& text);
    void setVerdicts(const VerdictSet& verdicts);
    bool isFiltering() const { return !m_text.isEmpty() || m_verdicts != everyVerdict(); }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    NodeModel& m_model;
    QString    m_text;
    VerdictSet m_verdicts = everyVerdict();
};

/// How many nodes have each verdict, on each depth of the hierarchy.
std::vector<std::array<std::size_t, 6>> countsByDepth(const std::vector<NodeRow>& nodes);

}  // namespace zscope::ui
