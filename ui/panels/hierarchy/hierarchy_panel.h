// SPDX-License-Identifier: GPL-3.0-or-later
// The hierarchy as a tree with a filter and the verdicts so far, and how many
// nodes each depth has. Selecting a row frames its box in the picture; picking a pixel selects the node that holds its
// triangle.
#pragma once

#include <set>

#include "ui/panels/panel.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QStackedLayout;
class QTreeView;

namespace zscope::ui {

class DepthChart;
class NodeFilter;
class NodeModel;
class VerdictBar;

class HierarchyPanel final : public Panel {
    Q_OBJECT

public:
    explicit HierarchyPanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& now, Changes what) override;

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void showNodes(const Snapshot& shown);
    void showSelection(const Snapshot& shown);
    void unfold(int id);
    void fitColumns();
    bool isUnfolded(int id) const { return m_unfolded.contains(id); }

    NodeModel*      m_model;
    NodeFilter*     m_filter;
    QTreeView*      m_tree;
    QLineEdit*      m_text;
    VerdictBar*     m_verdicts;
    DepthChart*     m_depths;
    QCheckBox*      m_boxes;
    QLabel*         m_hint;
    QStackedLayout* m_treeOrHint;
    std::set<int>   m_unfolded;            // ids of the nodes of one generation
    std::uint64_t   m_generation = 0;      // whose ids these are
    bool            m_filling    = false;  // rows are being replaced: what happens to the selection is not the user's
};

}  // namespace zscope::ui
