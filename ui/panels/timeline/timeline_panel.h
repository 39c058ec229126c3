// SPDX-License-Identifier: GPL-3.0-or-later
// The timeline: to and fro by steps of a chosen grain, play, stages and
// marks, and one sentence on what the step did. The keys belong to actions of the window, which the buttons trigger.
#pragma once

#include "ui/panels/panel.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace zscope::ui {

class StepTrack;

class TimelinePanel final : public Panel {
    Q_OBJECT

public:
    explicit TimelinePanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void showGrains(const Snapshot& shown);
    void showStep(const Snapshot& shown);
    void showMarks(const Snapshot& shown);
    void dressButtons();

    QPushButton *m_first, *m_back, *m_play, *m_forward, *m_last;
    QComboBox *  m_grain, *m_speed;
    QToolButton* m_bookmark;
    QLabel*      m_position;
    StepTrack*   m_track;
    QLabel*      m_sentence;
};

/// "step 479 of 900", counted from 1 as people count; empty while the number is not known.
QString positionText(const std::optional<Session::Position>& at);
/// The same, with how many bookmarks and breakpoints there are.
QString timelineText(const std::optional<Session::Position>& at, const Marks& marks);

}  // namespace zscope::ui
