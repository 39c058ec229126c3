// SPDX-License-Identifier: GPL-3.0-or-later
// The choices that make up the algorithm, one combo box per axis, and what ran in the last frame.
#pragma once

#include <vector>

#include "ui/panels/panel.h"

class QComboBox;
class QGridLayout;
class QLabel;

namespace zscope::ui {

class PipelinePanel final : public Panel {
    Q_OBJECT

public:
    explicit PipelinePanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

private:
    struct StageRow {
        QLabel *name, *ms;
    };

    void addAxes(QGridLayout& grid);
    void addStages(QGridLayout& grid);
    void choose(std::size_t axis, int choice);
    void showChoices(const Snapshot& shown);
    void showStages(const Snapshot& shown);

    std::vector<QComboBox*> m_axes;    // in the order of axes()
    std::vector<StageRow>   m_stages;  // in the order of kStages
    QLabel*                 m_notRun;
};

}  // namespace zscope::ui
