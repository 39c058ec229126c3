// SPDX-License-Identifier: GPL-3.0-or-later
// The fault gallery: classic mistakes, what each does to the view on show,
// why, and the rule that is right. Any of them can be switched on in the run.
#pragma once

#include <memory>

#include "ui/panels/panel.h"

class QLabel;
class QPushButton;
class QStackedLayout;
class QTableView;

namespace zscope::ui {

class FaultsModel;

class FaultsPanel final : public Panel {
    Q_OBJECT

public:
    explicit FaultsPanel(Session& session, QWidget* parent = nullptr);
    ~FaultsPanel() override;

    void present(const Snapshot& shown, Changes what) override;
    /// Whether the panel is before the others of its place: behind them, nothing is drawn for it.
    void setSeen(bool seen);
    bool isIdle() const { return !m_worker->isBusy(); }

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// What the pictures depend on: whether a fault is switched on does not matter.
    struct Question {
        const LoadedScene* scene = nullptr;
        Camera             camera;
        Pipeline           pipeline;
        FaceCulling        culling = FaceCulling::None;

        friend bool operator==(const Question&, const Question&) = default;
    };
    void ask();
    void showFault();
    void toggle();

    FaultsModel*            m_model;
    QTableView*             m_table;
    QLabel *                m_picture, *m_words, *m_hint;
    QPushButton*            m_switch;
    QStackedLayout*         m_bodyOrHint;
    bool                    m_isSeen = false;
    std::optional<Question> m_asked;
    std::unique_ptr<Worker> m_worker;  // last: stops before anything else goes
};

}  // namespace zscope::ui
