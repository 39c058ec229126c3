// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pyramid/pyramid_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "ui/panels/pyramid/level_thumbs.h"
#include "ui/panels/pyramid/level_view.h"
#include "ui/panels/pyramid/pyramid_words.h"
#include "ui/parts/scrolling.h"
#include "ui/predict/predict_bar.h"
#include "ui/predict/predictions.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

PyramidPanel::PyramidPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_thumbs(new LevelThumbs), m_large(new LevelView), m_question(new QLabel),
      m_update(new QLabel), m_hint(new QLabel), m_overlay(new QCheckBox), m_follow(new QPushButton)
{
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setMargin(2 * kStep);
    for (QLabel* label : {m_question, m_update}) {
        label->setTextFormat(Qt::RichText);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    }
    m_overlay->setFocusPolicy(Qt::TabFocus);
    m_follow->setFocusPolicy(Qt::TabFocus);

    auto* row = new QHBoxLayout;
    row->setSpacing(kStep);
    row->addWidget(m_overlay);
    row->addStretch(1);
    row->addWidget(m_follow);

    auto* levels = new ScrolledPart;
    auto* inside = new QVBoxLayout(levels);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(kStep);
    inside->addWidget(new PredictBar(session, Topic::Pyramid));
    inside->addWidget(m_thumbs);
    inside->addWidget(m_large, 1);
    inside->addLayout(row);
    inside->addWidget(m_question);
    inside->addWidget(m_update);

    m_levelsOrHint = new QStackedLayout(this);
    m_levelsOrHint->addWidget(scrolling(levels));
    m_levelsOrHint->addWidget(m_hint);

    connect(m_thumbs, &LevelThumbs::chosen, this, [this](int level) { this->session().selectLevel(level); });
    connect(m_follow, &QPushButton::clicked, this, [this] { this->session().selectLevel({}); });
    connect(m_large, &LevelView::picked, this, [this](const QPoint& pixel) { this->session().pick(pixel); });
    connect(m_overlay, &QCheckBox::clicked, this, [this](bool on) {
        Layers layers  = this->session().now().layers;
        layers.pyramid = on;
        this->session().setLayers(layers);
    });
    spoken(*this, [this] {
        m_overlay->setText(tr("Over the picture"));
        m_follow->setText(tr("Follow the step"));
        m_question->setAccessibleName(tr("The last question to the pyramid"));
        m_update->setAccessibleName(tr("The cell written last"));
        m_overlay->setToolTip(tr("Lays the cells of this level over the picture, with their values when zoomed in"));
        m_follow->setToolTip(tr("Shows the level that the last question or update was about"));
    });
}

void PyramidPanel::present(const Snapshot& now, Changes what)
{
    const auto      before = session().predictions().before(Topic::Pyramid, now);  // while a question is open
    const Snapshot& shown  = before ? *before : now;
    m_overlay->setChecked(shown.layers.pyramid);
    if (!(what & (Change::Picture | Change::Selection | Change::Pipeline | Change::Scene))) return;
    m_thumbs->present(shown);
    m_large->present(shown);
    showWords(shown);
}

void PyramidPanel::showWords(const Snapshot& shown)
{
    const int level = levelOnShow(shown);
    m_levelsOrHint->setCurrentIndex(level < 0 ? 1 : 0);
    if (level < 0) {
        m_hint->setText(!shown.scene
                            ? tr("Open a scene to see its pyramid of depths.")
                            : tr("The pyramid appears when the frame has been cleared. Press Right to go on."));
        emit summaryChanged({});
        return;
    }
    const ShownStep&    step    = *shown.stepOfPicture();
    const PyramidLevel& large   = step.pyramid.levels[static_cast<std::size_t>(level)];
    QString             summary = tr("level %1 · %2 × %3").arg(level).arg(large.width()).arg(large.height());
    if (!large.isStored && level > 0) summary += tr(" · not stored");
    if (large.lagging > 0)
        summary +=
            tr(" · %1").arg(counted(static_cast<std::uint64_t>(large.lagging), tr("1 cell lags"), tr("%1 cells lag")));
    emit summaryChanged(summary);
    m_follow->setEnabled(shown.selectedLevel.has_value());

    const PyramidWords words = wordsOf(*step.state.hierarchy, step.pyramid.empty, themeOf(palette()));
    m_question->setText(words.question.isEmpty() ? tr("Nothing has been asked yet: step by the grain “query”.")
                                                 : words.question);
    m_update->setText(words.update);
    m_update->setVisible(!words.update.isEmpty());
}

void PyramidPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_levelsOrHint) present(session().now(), Change::Picture);
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
