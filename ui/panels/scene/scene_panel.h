// SPDX-License-Identifier: GPL-3.0-or-later
// The scene in numbers, its warnings, and the turn of the model by y-z-y angles.
#pragma once

#include <array>

#include "ui/panels/panel.h"

class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace zscope::ui {

class ScenePanel final : public Panel {
    Q_OBJECT

public:
    explicit ScenePanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

private:
    void showScene(const Snapshot& shown);
    void showAngles();
    void turn();

    QLabel*                        m_title;
    QLabel*                        m_hint;
    QWidget*                       m_facts;
    std::array<QLabel*, 5>         m_values{};
    QWidget*                       m_turning;
    std::array<QDoubleSpinBox*, 3> m_angles{};
    QPushButton*                   m_normalise;
    QLabel*                        m_warningsTitle;
    QListWidget*                   m_warnings;
};

}  // namespace zscope::ui
