// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown while nothing is open: open a file, begin with the first lesson, an example, or what was open before.
#pragma once

#include <functional>

#include <QWidget>

class QGridLayout;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace zscope::ui {

class StartPage final : public QWidget {
    Q_OBJECT

public:
    struct Requests {
        std::function<void()>               open;
        std::function<void(const QString&)> openWord;     // builtin:NAME or a path
        std::function<void()>               firstLesson;  // nothing: there is none
    };
    explicit StartPage(Requests requests, QWidget* parent = nullptr);

    void showRecent(const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;

private:
    void dress();
    void choose(const QListWidgetItem* item);

    Requests     m_requests;
    QPushButton *m_open, *m_lesson;
    QGridLayout* m_lists = nullptr;
    QLabel*      m_recentTitle;
    QListWidget *m_examples, *m_recent;
};

}  // namespace zscope::ui
