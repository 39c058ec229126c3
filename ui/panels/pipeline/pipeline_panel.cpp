// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pipeline/pipeline_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "ui/parts/choice_box.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

PipelinePanel::PipelinePanel(Session& session, QWidget* parent) : Panel(session, parent), m_notRun(new QLabel)
{
    auto* inside = new QWidget;
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(kStep);
    auto* choices = new QGridLayout;
    choices->setColumnStretch(1, 1);
    choices->setHorizontalSpacing(kStep);
    choices->setVerticalSpacing(4);
    addAxes(*choices);
    layout->addLayout(choices);

    auto* ran = new QLabel;
    ran->setObjectName("section");
    spoken(*ran, [ran] { ran->setText(tr("What ran")); });
    layout->addSpacing(4);
    layout->addWidget(ran);
    auto* stages = new QGridLayout;
    stages->setColumnStretch(0, 1);
    stages->setVerticalSpacing(3);
    addStages(*stages);
    layout->addLayout(stages);
    m_notRun->setObjectName("soft");
    m_notRun->setWordWrap(true);
    layout->addWidget(m_notRun);
    layout->addStretch(1);

    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(inside);
    // The scroll bar takes its width from the choices, which must not be cut off.
    inside->ensurePolished();
    scroll->setMinimumWidth(inside->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);
}

void PipelinePanel::addAxes(QGridLayout& grid)
{
    for (std::size_t i = 0; i < axes().size(); ++i) {
        const AxisEntry& axis  = axes()[i];
        auto*            name  = new QLabel;
        auto*            combo = new ChoiceBox;
        name->setObjectName("soft");
        spoken(*combo, [combo, name, &axis] {
            name->setText(said(axis.word));
            name->setToolTip(said(axis.title));
            combo->setAccessibleName(said(axis.title));
        });
        combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        combo->setMinimumContentsLength(10);
        combo->setObjectName("compact");
        // showChoices() adds its title
        for (const ChoiceEntry& choice : axis.choices) combo->addItem(utf8Text(choice.word));
        name->setBuddy(combo);
        grid.addWidget(name, static_cast<int>(i), 0);
        grid.addWidget(combo, static_cast<int>(i), 1);
        m_axes.push_back(combo);
        connect(combo, &QComboBox::activated, this, [this, i](int choice) { choose(i, choice); });
    }
}

void PipelinePanel::addStages(QGridLayout& grid)
{
    for (const Stage stage : kStages) {
        const StageRow row{new QLabel, new QLabel};
        const int      line = static_cast<int>(m_stages.size());
        spoken(*row.name, [name = row.name, stage] { name->setText(said(wordOf(stage))); });
        row.ms->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid.addWidget(row.name, line, 0);
        grid.addWidget(row.ms, line, 1);
        m_stages.push_back(row);
    }
}

void PipelinePanel::choose(std::size_t axis, int choice)
{
    const AxisEntry& entry = axes()[axis];
    const auto       wanted =
        withChoice(session().now().pipeline, entry.word, entry.choices[static_cast<std::size_t>(choice)].word);
    if (wanted && !explainInvalid(*wanted))
        session().setPipeline(*wanted);
    else
        showChoices(session().now());
}

void PipelinePanel::present(const Snapshot& shown, Changes what)
{
    if (what & Change::Pipeline) showChoices(shown);
    if (what & (Change::Picture | Change::Scene)) showStages(shown);
}

void PipelinePanel::showChoices(const Snapshot& shown)
{
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        const AxisEntry&     axis = axes()[i];
        const QSignalBlocker quiet(m_axes[i]);
        auto*                model = qobject_cast<QStandardItemModel*>(m_axes[i]->model());
        for (std::size_t c = 0; c < axis.choices.size(); ++c) {
            if (axis.choices[c].word == chosen(shown.pipeline, axis.word)) {
                m_axes[i]->setCurrentIndex(static_cast<int>(c));
                m_axes[i]->setToolTip(said(axis.choices[c].title));
            }
            const auto     possible = withChoice(shown.pipeline, axis.word, axis.choices[c].word);
            const auto     why      = possible ? explainInvalid(*possible) : std::nullopt;
            QStandardItem* item     = model->item(static_cast<int>(c));
            item->setEnabled(!why);
            item->setToolTip(why ? said(*why) : said(axis.choices[c].title));
        }
    }
    const Preset* preset = findPreset(nameOf(shown.pipeline));
    const bool    byFace = preset && preset->claim == Claim::ExactByFace;
    emit          summaryChanged(!preset             ? QString()
                                 : preset->isExact() ? tr("exact")
                                 : byFace            ? tr("exact by face")
                                                     : tr("approximate"));
}

void PipelinePanel::showStages(const Snapshot& shown)
{
    QStringList notRun;
    for (std::size_t i = 0; i < m_stages.size(); ++i) {
        const StageTime* stage = nullptr;
        if (shown.frame && i < shown.frame->report.stages.size()) stage = &shown.frame->report.stages[i];
        const bool ran = stage && stage->ran;
        m_stages[i].name->setVisible(ran);
        m_stages[i].ms->setVisible(ran);
        if (ran) {
            m_stages[i].ms->setText(milliseconds(stage->ms));
            m_stages[i].name->setToolTip(said(stage->why));
        } else if (stage) {
            QString why = said(wordOf(stage->stage));
            if (!stage->why.empty()) why += ": " + said(stage->why);
            notRun << why;
        }
    }
    if (!shown.frame)
        m_notRun->setText(tr("Nothing yet: open a scene."));
    else
        m_notRun->setText(notRun.isEmpty() ? QString() : tr("Not needed: %1").arg(notRun.join("; ")));
}

}  // namespace zscope::ui
