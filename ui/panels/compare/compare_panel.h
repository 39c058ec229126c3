// SPDX-License-Identifier: GPL-3.0-or-later
// A and B: which two ways to draw are compared, how they are shown, what
// differs. The keys belong to actions of the window.
#pragma once

#include <array>
#include <vector>

#include "ui/panels/panel.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;
class QToolButton;

namespace zscope::ui {

class ComparePanel final : public Panel {
    Q_OBJECT

public:
    explicit ComparePanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void showChoices(const Snapshot& shown);
    void showResult(const Snapshot& shown);

    QComboBox *                 m_a, *m_b, *m_link;
    QPushButton *               m_swap, *m_keep, *m_worst;
    std::array<QToolButton*, 5> m_shows{};  // by CompareShow
    QSlider*                    m_wipe;
    QSpinBox*                   m_tolerance;
    QCheckBox*                  m_linked;
    QLabel *                    m_verdict, *m_times, *m_hint, *m_linkNote, *m_toleranceName;
    QGridLayout*                m_grid;
    std::vector<QLabel*>        m_names, m_values;
    QWidget*                    m_body;
};

}  // namespace zscope::ui
