// SPDX-License-Identifier: GPL-3.0-or-later
// The active edge table of the line that the sweep has reached: the table, the active polygons, the line's strip, and
// the edge table's buckets. Selecting a row highlights the edge in the picture; picking a pixel lights up the rows.
#pragma once

#include <array>

#include "ui/panels/panel.h"

class QLabel;
class QStackedLayout;
class QTableView;

namespace zscope::ui {

class BucketChart;
class EdgeTableModel;
class LineStrip;
class ScrolledPart;

class ActiveEdgesPanel final : public Panel {
    Q_OBJECT

public:
    explicit ActiveEdgesPanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& now, Changes what) override;

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void showRows(const Snapshot& shown, Changes what);
    void showWords(const Snapshot& shown);
    void fitColumns();
    void fitPolygons();

    EdgeTableModel*    m_model;
    QTableView*        m_table;
    QLabel*            m_changes;
    QLabel*            m_polygons;
    QString            m_polygonText;  // before it is made to fit
    QLabel*            m_hint;
    ScrolledPart*      m_room = nullptr;  // of all of them, scrolled where the panel is low
    LineStrip*         m_strip;
    BucketChart*       m_buckets;
    QStackedLayout*    m_tableOrHint;
    std::array<int, 8> m_widths{};         // of the columns
    bool               m_filling = false;  // rows are being replaced: what happens to the selection is not the user's
};

}  // namespace zscope::ui
