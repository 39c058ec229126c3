// SPDX-License-Identifier: GPL-3.0-or-later
// The strip above a table that asks what comes: the switch, the question with
// its field or buttons, right or wrong in words, and the score.
//
// Keys       an open question holds none: Left and Right step from its buttons and from its field while that is empty,
//            Escape leaves the field
#pragma once

#include <QWidget>

#include "ui/predict/riddle.h"

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace zscope::ui {

class Session;

class PredictBar final : public QWidget {
    Q_OBJECT

public:
    PredictBar(Session& session, Topic topic, QWidget* parent = nullptr);

private:
    void    present();
    void    presentQuestion();
    void    presentScore();
    QString hintText() const;
    void    check();
    void    answer(double given);
    /// Gives the focus to where the keys for stepping are heard.
    void hearSteps();
    void save();

    Session&                  m_session;
    const Topic               m_topic;
    QCheckBox*                m_on;
    QLabel*                   m_score;
    QPushButton*              m_save;
    QLabel*                   m_question;
    QWidget*                  m_answer;
    QHBoxLayout*              m_choices;
    std::vector<QPushButton*> m_buttons;
    QLineEdit*                m_number;
    QPushButton*              m_check;
    QLabel*                   m_verdict;
};

}  // namespace zscope::ui
