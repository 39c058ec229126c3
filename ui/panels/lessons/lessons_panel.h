// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons: the list of them, or the page that is being read, with its
// question. Everything can be done by keyboard: the arrow keys and Enter in the list and among the choices,
// Ctrl+Shift+PageDown and Ctrl+Shift+PageUp for the pages.
#pragma once

#include <vector>

#include "core/lesson/lesson.h"
#include "ui/panels/panel.h"

class QButtonGroup;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QRadioButton;
class QScrollArea;
class QStackedLayout;
class QVBoxLayout;

namespace zscope::ui {

/// In the language of the window.
QString inLanguage(const LessonText& text);

class LessonsPanel final : public Panel {
    Q_OBJECT

public:
    explicit LessonsPanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeList();
    QWidget* makePage();
    QWidget* makeQuestion();
    void     showAll();
    void     showList();
    void     showPage();
    void     showQuestion();
    void     showChoices();
    void     showVerdict();
    void     showPick();
    void     check();

    struct ChoiceRow {
        QWidget*      row;
        QRadioButton* button;
        QLabel*       text;
    };

    QStackedLayout* m_listOrPage = nullptr;
    QListWidget*    m_list       = nullptr;
    QLabel *        m_listHint = nullptr, *m_troubles = nullptr;
    QScrollArea*    m_scroll = nullptr;
    QLabel *        m_title = nullptr, *m_text = nullptr, *m_where = nullptr;
    QPushButton *   m_contents = nullptr, *m_again = nullptr, *m_back = nullptr, *m_next = nullptr;
    QWidget*        m_question = nullptr;
    QLabel *        m_ask = nullptr, *m_unit = nullptr, *m_pixel = nullptr, *m_verdict = nullptr, *m_why = nullptr;
    QVBoxLayout*    m_choicesRoom = nullptr;
    QButtonGroup*   m_choices     = nullptr;
    std::vector<ChoiceRow> m_rows;
    QWidget*               m_numberRow = nullptr;
    QLineEdit*             m_number    = nullptr;
    QPushButton*           m_check     = nullptr;
    const void*            m_shownPage = nullptr;  // whose question the widgets are filled with
};

}  // namespace zscope::ui
