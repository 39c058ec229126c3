// SPDX-License-Identifier: GPL-3.0-or-later
// The pyramid of farthest depths at this step: all levels small, one large,
// what was asked last and what was written last.
#pragma once

#include "ui/panels/panel.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedLayout;

namespace zscope::ui {

class LevelThumbs;
class LevelView;

class PyramidPanel final : public Panel {
    Q_OBJECT

public:
    explicit PyramidPanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& now, Changes what) override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void showWords(const Snapshot& shown);

    LevelThumbs*    m_thumbs;
    LevelView*      m_large;
    QLabel *        m_question, *m_update, *m_hint;
    QCheckBox*      m_overlay;
    QPushButton*    m_follow;
    QStackedLayout* m_levelsOrHint;
};

}  // namespace zscope::ui
