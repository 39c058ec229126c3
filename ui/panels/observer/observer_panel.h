// SPDX-License-Identifier: GPL-3.0-or-later
// The observer camera: the view that culls stays where it is, the user flies
// outside and sees its frustum, the boxes by verdict, and what was culled.
#pragma once

#include "ui/panels/panel.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedLayout;

namespace zscope::ui {

class ObserverView;
class VerdictBar;

class ObserverPanel final : public Panel {
    Q_OBJECT

public:
    explicit ObserverPanel(Session& session, QWidget* parent = nullptr);

    void          present(const Snapshot& shown, Changes what) override;
    ObserverView& view() const { return *m_view; }

private:
    void showStep(const Snapshot& shown);
    void showWords();

    ObserverView*                      m_view;
    VerdictBar*                        m_boxes;
    QCheckBox*                         m_freeze;
    QPushButton*                       m_reset;
    QLabel *                           m_words, *m_hint;
    QStackedLayout*                    m_viewOrHint;
    std::shared_ptr<const ShownStep>   m_frozen;  // while the view is frozen: what it was
    std::shared_ptr<const LoadedScene> m_frozenScene;
};

}  // namespace zscope::ui
