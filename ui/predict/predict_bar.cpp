// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/predict/predict_bar.h"

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/predict/predictions.h"
#include "ui/session/session.h"
#include "ui/text/grains.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

QLabel* wrapped(Qt::TextFormat format)
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextFormat(format);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    return label;
}

}  // namespace

PredictBar::PredictBar(Session& session, Topic topic, QWidget* parent)
    : QWidget(parent), m_session(session), m_topic(topic), m_on(new QCheckBox), m_score(new QLabel),
      m_save(new QPushButton), m_question(wrapped(Qt::PlainText)), m_answer(new QWidget), m_choices(new QHBoxLayout),
      m_number(new QLineEdit), m_check(new QPushButton), m_verdict(wrapped(Qt::RichText))
{
    m_on->setFocusPolicy(Qt::TabFocus);
    m_save->setFocusPolicy(Qt::TabFocus);
    m_score->setObjectName("soft");
    m_question->setObjectName("section");
    m_number->setMaximumWidth(120);
    m_number->setProperty("ownsEnter", true);

    auto* head = new QHBoxLayout;
    head->setSpacing(kStep);
    head->addWidget(m_on);
    head->addStretch(1);
    head->addWidget(m_score);
    head->addWidget(m_save);
    auto* answer = new QHBoxLayout(m_answer);
    answer->setContentsMargins(0, 0, 0, 0);
    answer->setSpacing(kStep);
    answer->addWidget(m_number);
    answer->addWidget(m_check);
    answer->addLayout(m_choices);
    answer->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addLayout(head);
    layout->addWidget(m_question);
    layout->addWidget(m_answer);
    layout->addWidget(m_verdict);

    connect(m_on, &QCheckBox::clicked, this, [this](bool on) { m_session.predictions().setOn(m_topic, on); });
    connect(m_check, &QPushButton::clicked, this, &PredictBar::check);
    connect(m_number, &QLineEdit::returnPressed, this, &PredictBar::check);
    connect(m_save, &QPushButton::clicked, this, &PredictBar::save);
    connect(&session.predictions(), &Predictions::changed, this, &PredictBar::present);
    connect(&session, &Session::changed, this, [this](Changes what) {
        if ((what & (Change::Pipeline | Change::Scene)) && !m_session.predictions().open(m_topic)) presentQuestion();
    });
    spoken(*this, [this] {
        m_on->setText(tr("Predict"));
        m_on->setToolTip(tr("Before the next step is shown here, say what it brings"));
        m_save->setText(tr("Save score…"));
        m_save->setToolTip(tr("Writes every question, answer and result as a table (CSV) that a spreadsheet opens"));
        m_check->setText(tr("Check"));
        m_number->setAccessibleName(tr("Your prediction, a number"));
        m_verdict->setAccessibleName(tr("Whether the prediction was right"));
        present();
    });
}

void PredictBar::present()
{
    m_on->setChecked(m_session.predictions().isOn(m_topic));
    presentQuestion();
    presentScore();
}

void PredictBar::presentQuestion()
{
    const Riddle* riddle = m_session.predictions().open(m_topic);
    if (!riddle && m_answer->isAncestorOf(QApplication::focusWidget())) hearSteps();
    const QString hint = riddle ? QString() : hintText();
    m_question->setVisible(riddle || !hint.isEmpty());
    m_answer->setVisible(riddle);
    for (QPushButton* button : m_buttons) button->deleteLater();
    m_buttons.clear();
    m_question->setText(hint);
    if (!riddle) return;
    m_question->setText(askText(*riddle));
    m_number->setVisible(riddle->isNumber());
    m_check->setVisible(riddle->isNumber());
    m_number->clear();
    const QStringList choices = choicesOf(*riddle);
    for (qsizetype i = 0; i < choices.size(); ++i) {
        auto* button = new QPushButton(choices[i]);
        m_choices->addWidget(button);
        button->show();  // the layout would show it later, and what is not shown takes no focus
        m_buttons.push_back(button);
        connect(button, &QPushButton::clicked, this, [this, i] { answer(static_cast<double>(i)); });
    }
    if (m_on->isVisible()) (riddle->isNumber() ? static_cast<QWidget*>(m_number) : m_buttons.front())->setFocus();
}

/// Which steps ask, while those of another grain are taken, which never do.
QString PredictBar::hintText() const
{
    const Snapshot& now  = m_session.now();
    const bool      asks = m_topic == Topic::Edges || now.grain == Grain::Node
                      || (m_topic == Topic::Pyramid && (now.grain == Grain::Query || now.grain == Grain::Update));
    if (asks || !m_session.predictions().isOn(m_topic) || !now.scene) return {};
    return tr("Steps by the grain “%1” ask.").arg(nameOf(m_topic == Topic::Pyramid ? Grain::Query : Grain::Node));
}

void PredictBar::presentScore()
{
    const Predictions& all   = m_session.predictions();
    const int          count = all.countOf(m_topic);
    m_score->setVisible(count > 0);
    m_save->setVisible(count > 0);
    const int skipped = all.skippedOf(m_topic);
    m_score->setText(skipped == 0 ? tr("%1 of %2 right").arg(all.rightOf(m_topic)).arg(count)
                                  : tr("%1 of %2 right, %3 skipped").arg(all.rightOf(m_topic)).arg(count).arg(skipped));
    const Predicted* last = all.last(m_topic);
    m_verdict->setVisible(last);
    if (!last) return;
    const Theme& theme = themeOf(palette());
    m_verdict->setText(QStringLiteral("<b style='color:%1'>%2</b> %3")
                           .arg((last->isRight ? theme.entered
                                 : last->given ? theme.error
                                               : theme.softText)
                                    .name(),
                                last->isRight ? tr("✔ Right.")
                                : last->given ? tr("✘ Not right.")
                                              : tr("– Skipped."),
                                truthText(last->riddle).toHtmlEscaped()));
}

void PredictBar::check()
{
    bool   isNumber = false;
    double value    = QLocale::c().toDouble(m_number->text().trimmed(), &isNumber);
    if (!isNumber) value = QLocale().toDouble(m_number->text().trimmed(), &isNumber);
    if (!isNumber) return;
    answer(value);
}

void PredictBar::hearSteps() { window()->setFocus(); }

void PredictBar::answer(double given)
{
    hearSteps();
    m_session.predictions().answer(m_topic, given);
}

void PredictBar::save()
{
    QString file = QFileDialog::getSaveFileName(this, tr("Save the score"),
                                                QDir::home().filePath("zscope-predictions.csv"), tr("Tables (*.csv)"));
    if (file.isEmpty()) return;
    if (!file.endsWith(".csv", Qt::CaseInsensitive)) file += ".csv";
    if (const auto trouble = m_session.predictions().save(file)) emit m_session.failed(*trouble);
}

}  // namespace zscope::ui
