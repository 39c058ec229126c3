// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the picture that another program drew, and which mistakes explain it. A click on a mistake
// switches it on in A, so that A shows it as well; another click brings the algorithm back that A was before.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ui/panels/panel.h"

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;
class QVBoxLayout;

namespace zscope::ui {

class CauseRow;

class DiagnosisPanel final : public Panel {
    Q_OBJECT

public:
    explicit DiagnosisPanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void showWork();
    void showAnswer(const Snapshot& shown);
    void showCauses(const Snapshot& shown);
    void toggle(std::size_t cause);

    QStackedLayout* m_bodyOrHint;
    QLabel *        m_hint, *m_title, *m_stale, *m_work, *m_sentence, *m_conventions, *m_causesTitle, *m_clusters;
    QPushButton *   m_open, *m_again, *m_back, *m_cancel, *m_first, *m_report;
    QProgressBar*   m_progress;
    // wrong and rounding, by mistake
    std::array<std::array<QLabel*, 2>, 4> m_counts{};
    std::array<QLabel*, 4>                m_countNames{};
    std::array<QLabel*, 2>                m_heads{};
    QVBoxLayout*                          m_rows;
    std::vector<CauseRow*>                m_causes;   // of the causes, the best first
    std::vector<QLabel*>                  m_lessons;  // below them: links
    std::optional<Pipeline>               m_before;   // what A was before a mistake was switched on
};

}  // namespace zscope::ui
