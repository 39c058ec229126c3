// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/timeline/timeline_panel.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/timeline/step_track.h"
#include "ui/parts/choice_box.h"
#include "ui/predict/predictions.h"
#include "ui/text/grains.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr std::array kSpeeds{1, 2, 5, 10, 30, 60, 200, 1000, 10'000, 100'000};
constexpr int        kFirstSpeed = 30;

}  // namespace

QString positionText(const std::optional<Session::Position>& at)
{
    if (!at) return {};
    return TimelinePanel::tr("step %1 of %2").arg(grouped(at->step + 1), grouped(at->count));
}

QString timelineText(const std::optional<Session::Position>& at, const Marks& marks)
{
    QStringList parts;
    if (const QString where = positionText(at); !where.isEmpty()) parts << where;
    if (!marks.bookmarks.empty())
        parts << QStringLiteral("\u2605 ")
                     + counted(marks.bookmarks.size(), TimelinePanel::tr("1 bookmark"),
                               TimelinePanel::tr("%1 bookmarks"));
    if (marks.breakpoints.size() == 1)
        parts << QStringLiteral("\u25CF ")
                     + TimelinePanel::tr("breakpoint on %1").arg(textOf(marks.breakpoints.front()));
    else if (!marks.breakpoints.empty())
        parts << QStringLiteral("\u25CF ")
                     + counted(marks.breakpoints.size(), QString(), TimelinePanel::tr("%1 breakpoints"));
    return parts.join(QStringLiteral("    "));
}

TimelinePanel::TimelinePanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_first(new QPushButton), m_back(new QPushButton), m_play(new QPushButton),
      m_forward(new QPushButton), m_last(new QPushButton), m_grain(new ChoiceBox), m_speed(new ChoiceBox),
      m_bookmark(new QToolButton), m_position(new QLabel), m_track(new StepTrack), m_sentence(new QLabel)
{
    m_play->setObjectName("strong");
    m_forward->setLayoutDirection(Qt::RightToLeft);  // the arrow after the word
    for (const int speed : kSpeeds) {
        m_speed->addItem(QString(), speed);
        if (speed == kFirstSpeed) m_speed->setCurrentIndex(m_speed->count() - 1);
    }
    session.player().setSpeed(kFirstSpeed);
    m_bookmark->setText(QStringLiteral("\u2606"));
    m_bookmark->setCheckable(true);
    m_bookmark->setFocusPolicy(Qt::TabFocus);
    m_grain->setSizeAdjustPolicy(QComboBox::AdjustToContents);

    auto* row = new QHBoxLayout;
    row->setSpacing(kStep);
    for (QPushButton* button : {m_first, m_back, m_play, m_forward, m_last}) {
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    row->addSpacing(kStep);
    row->addWidget(m_grain);
    row->addWidget(m_speed);
    row->addWidget(m_bookmark);
    row->addStretch(1);
    row->addWidget(m_position);

    m_sentence->setWordWrap(true);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_sentence->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    QFont large = m_sentence->font();
    large.setPointSizeF(large.pointSizeF() * 1.15);
    m_sentence->setFont(large);
    m_sentence->setFixedHeight(2 * QFontMetrics(large).lineSpacing() + 2);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kStep + 4, kStep, kStep + 4, 6);
    layout->setSpacing(6);
    layout->addLayout(row);
    layout->addWidget(m_track);
    layout->addWidget(m_sentence);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);

    connect(m_first, &QPushButton::clicked, this, [this] { this->session().goToStart(); });
    connect(m_back, &QPushButton::clicked, this, [this] { this->session().stepBy(-1); });
    connect(m_forward, &QPushButton::clicked, this, [this] { this->session().stepBy(1); });
    connect(m_last, &QPushButton::clicked, this, [this] { this->session().goToEnd(); });
    connect(m_play, &QPushButton::clicked, this,
            [this] { this->session().player().setPlaying(!this->session().player().isPlaying()); });
    connect(&session.player(), &Player::playingChanged, this, &TimelinePanel::dressButtons);
    connect(m_track, &StepTrack::stepChosen, this, [this](std::uint64_t step) { this->session().goToStep(step); });
    connect(m_bookmark, &QToolButton::clicked, this, [this] { this->session().toggleBookmark(); });
    connect(m_grain, &QComboBox::activated, this,
            [this](int index) { this->session().setGrain(static_cast<Grain>(m_grain->itemData(index).toInt())); });
    connect(m_speed, &QComboBox::activated, this,
            [this](int index) { this->session().player().setSpeed(m_speed->itemData(index).toDouble()); });
    spoken(*this, [this] {
        m_back->setText(tr("Left"));
        m_forward->setText(tr("Right"));
        m_first->setAccessibleName(tr("First step"));
        m_first->setToolTip(tr("First step (Home)"));
        m_back->setToolTip(tr("One step back (Left); Shift+Left: one of the next coarser grain"));
        m_play->setToolTip(tr("Play or pause (Space)"));
        m_forward->setToolTip(tr("One step forward (Right); Shift+Right: one of the next coarser grain"));
        m_last->setAccessibleName(tr("Last step"));
        m_last->setToolTip(tr("The finished picture (End)"));
        m_grain->setAccessibleName(tr("Grain of a step"));
        m_grain->setToolTip(tr("How large a step is"));
        m_speed->setAccessibleName(tr("Speed of playing"));
        m_bookmark->setAccessibleName(tr("Bookmark of this step"));
        m_bookmark->setToolTip(tr("Marks this step, or takes its mark away (Ctrl+B)"));
        m_speed->setToolTip(tr("Steps per second while playing"));
        m_sentence->setAccessibleName(tr("What this step did"));
        for (int i = 0; i < m_speed->count(); ++i)
            m_speed->setItemText(i, tr("%1 / s").arg(grouped(m_speed->itemData(i).toUInt())));
        dressButtons();
    });
}

void TimelinePanel::dressButtons()
{
    const Theme& theme = themeOf(palette());
    m_first->setIcon(iconOf("first", theme.text));
    m_back->setIcon(iconOf("back", theme.text));
    m_forward->setIcon(iconOf("forward", theme.text));
    m_last->setIcon(iconOf("last", theme.text));
    m_play->setIcon(iconOf(session().player().isPlaying() ? "pause" : "play", theme.buttonText));
    m_play->setText(session().player().isPlaying() ? tr("Pause") : tr("Play"));
}

void TimelinePanel::present(const Snapshot& shown, Changes what)
{
    if (what & Change::Pipeline) showGrains(shown);
    if (what & (Change::Picture | Change::Pipeline | Change::Scene | Change::Busy | Change::Marks)) showStep(shown);
    if (what & (Change::Picture | Change::Pipeline | Change::Scene | Change::Selection | Change::Marks))
        showMarks(shown);
}

void TimelinePanel::showGrains(const Snapshot& shown)
{
    const QSignalBlocker quiet(m_grain);
    m_grain->clear();
    for (const Grain grain : grainsOf(shown.pipeline)) {
        m_grain->addItem(nameOf(grain), static_cast<int>(grain));
        if (grain == shown.grain) m_grain->setCurrentIndex(m_grain->count() - 1);
    }
}

void TimelinePanel::showStep(const Snapshot& shown)
{
    const auto at = session().position();
    if (at) m_track->present(at->step, at->count);
    m_track->setEnabled(at.has_value());
    m_position->setText(timelineText(at, shown.marks));
    const ShownStep* step = shown.stepOfPicture();
    m_sentence->setText(session().predictions().isAnyOpen()
                            ? tr("Say what this step brings: the question is above its table.")
                        : step        ? said(step->state.sentence)
                        : shown.scene ? QString()
                                      : tr("The steps of the algorithm appear here once a scene is open."));
    const bool scene = shown.scene != nullptr;
    for (QPushButton* button : {m_first, m_back, m_play, m_forward, m_last}) button->setEnabled(scene);
}

void TimelinePanel::showMarks(const Snapshot& shown)
{
    const ShownStep* step =
        shown.step && shown.step->state.grain == shown.grain && shown.step->pipeline == shown.pipeline
            ? shown.step.get()
            : nullptr;
    TrackMarks marks;
    if (step)
        for (const StageMark& stage : step->stages) marks.stages.push_back({nameOf(stage.stage), stage.first});
    for (const Bookmark& mark : shown.marks.bookmarks)
        if (mark.pipeline == shown.pipeline && mark.grain == shown.grain)
            marks.bookmarks.push_back({mark.name, mark.step});
    const PixelHistory* history = shown.marks.history.get();
    if (step && history && history->generation == step->generation && history->grain == shown.grain
        && history->pixel == shown.picked)
        for (const PixelChange& change : history->changes) marks.changes.push_back(change.step.value);
    m_track->showMarks(marks);

    const auto at = session().position();
    const bool isMarked =
        at && std::ranges::any_of(marks.bookmarks, [&](const auto& mark) { return mark.step == at->step; });
    m_bookmark->setChecked(isMarked);
    m_bookmark->setText(isMarked ? QStringLiteral("\u2605") : QStringLiteral("\u2606"));
    m_bookmark->setEnabled(at.has_value());
}

void TimelinePanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_sentence) dressButtons();
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
