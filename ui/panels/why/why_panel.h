// SPDX-License-Identifier: GPL-3.0-or-later
// Why this pixel, and why not this triangle: everything that covers the
// picked pixel with what became of it, as links into the run. The answer is made on a thread of the panel's own; the
// newest question wins.
#pragma once

#include <memory>

#include "core/lesson/explanation.h"
#include "ui/panels/panel.h"
#include "ui/session/worker.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeView;

namespace zscope::ui {

class WhyModel;

class WhyPanel final : public Panel {
    Q_OBJECT

public:
    explicit WhyPanel(Session& session, QWidget* parent = nullptr);
    ~WhyPanel() override;

    void present(const Snapshot& shown, Changes what) override;
    bool isIdle() const { return !m_worker->isBusy(); }
    /// Why it is not seen, or where; ends with another pick.
    void askAbout(TriangleId triangle);

    const std::shared_ptr<const PixelExplanation>& answer() const { return m_pixelAnswer; }

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    /// What an answer depends on.
    struct Question {
        std::uint64_t             generation = 0;
        std::optional<QPoint>     pixel;
        std::optional<TriangleId> triangle;

        friend bool operator==(const Question&, const Question&) = default;
    };

    void ask();
    void saySentence();
    /// What another program has at the pixel, above the answer.
    void showTheirs(const Snapshot& shown);
    /// In place of an answer.
    void tell(const QString& sentence);
    void showAnswer();
    /// A question without an answer; the answer before it stays, and so does the field.
    void refuse(const Question& question, const QString& trouble);
    void complain(const QString& trouble);
    void showRow(const QModelIndex& index);
    void jump(const QModelIndex& index);
    void fitColumns();

    WhyModel*                               m_model;
    QTreeView*                              m_tree;
    QString                                 m_said;  // of the answer, whatever step is on show
    QLabel *                                m_theirs, *m_sentence, *m_detail, *m_hint, *m_trouble;
    QPushButton*                            m_jump;
    QLineEdit*                              m_triangle;
    std::optional<Question>                 m_asked;     // of the answer on show or on its way
    std::optional<Question>                 m_answered;  // of the answer on show
    std::optional<TriangleId>               m_about;     // nothing: about the picked pixel
    std::optional<QPoint>                   m_lastPick;
    std::shared_ptr<const PixelExplanation> m_pixelAnswer;
    std::unique_ptr<Worker>                 m_worker;  // last: stops before anything else goes
};

}  // namespace zscope::ui
