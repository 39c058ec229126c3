// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/compare/compare_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/compare/compare_words.h"
#include "ui/parts/choice_box.h"
#include "ui/parts/scrolling.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kWipeSteps = 1000;

QString wordOf(const Pipeline& pipeline) { return QString::fromStdString(nameOf(pipeline)); }

QComboBox* presetBox()
{
    auto* box = new ChoiceBox;
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    for (std::size_t i = 0; i < presets().size(); ++i) box->addItem(utf8Text(presets()[i].name), static_cast<int>(i));
    return box;
}

/// What the presets of a box are, `first` being the first one's row.
void sayTitles(QComboBox& box, int first)
{
    for (std::size_t i = 0; i < presets().size(); ++i)
        box.setItemData(first + static_cast<int>(i), said(presets()[i].title), Qt::ToolTipRole);
}

/// A composition without a name of its own stands below the others while it is chosen, and so does what another
/// program drew.
void choose(QComboBox& box, const std::optional<Pipeline>& pipeline, const QString& name, int first)
{
    const QSignalBlocker quiet(&box);
    const int            named = first + static_cast<int>(presets().size());
    while (box.count() > named) box.removeItem(named);
    if (name.isEmpty()) return box.setCurrentIndex(0);
    for (std::size_t i = 0; i < presets().size(); ++i)
        if (presets()[i].pipeline == pipeline) return box.setCurrentIndex(first + static_cast<int>(i));
    box.addItem(name, -2);
    box.setCurrentIndex(named);
}

}  // namespace

ComparePanel::ComparePanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_a(presetBox()), m_b(presetBox()), m_link(new ChoiceBox), m_swap(new QPushButton),
      m_keep(new QPushButton), m_worst(new QPushButton), m_wipe(new QSlider(Qt::Horizontal)), m_tolerance(new QSpinBox),
      m_linked(new QCheckBox), m_verdict(new QLabel), m_times(new QLabel), m_hint(new QLabel), m_linkNote(new QLabel),
      m_toleranceName(new QLabel), m_grid(new QGridLayout), m_body(new QWidget)
{
    m_b->insertItem(0, QString(), -1);
    m_wipe->setRange(0, kWipeSteps);
    m_tolerance->setRange(0, 1'000'000'000);
    m_tolerance->setAlignment(Qt::AlignRight);
    m_tolerance->setKeyboardTracking(false);
    m_linked->setFocusPolicy(Qt::TabFocus);
    for (int i = 0; i < 4; ++i) m_link->addItem(QString());    // by Link
    m_link->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // in another language, too
    m_linkNote->setObjectName("soft");
    m_linkNote->setWordWrap(true);
    m_verdict->setWordWrap(true);
    m_verdict->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    m_times->setObjectName("soft");
    m_times->setWordWrap(true);
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    for (QPushButton* button : {m_swap, m_keep, m_worst}) button->setFocusPolicy(Qt::TabFocus);

    auto* choices = new QGridLayout;
    choices->setHorizontalSpacing(kStep);
    choices->setVerticalSpacing(6);
    choices->addWidget(new QLabel(QStringLiteral("A")), 0, 0);
    choices->addWidget(m_a, 0, 1);
    choices->addWidget(m_swap, 0, 2);
    choices->addWidget(new QLabel(QStringLiteral("B")), 1, 0);
    choices->addWidget(m_b, 1, 1);
    choices->addWidget(m_keep, 1, 2);
    choices->setColumnStretch(1, 1);

    auto* shows = new QHBoxLayout;
    shows->setSpacing(4);
    for (std::size_t i = 0; i < m_shows.size(); ++i) {
        m_shows[i] = new QToolButton;
        m_shows[i]->setCheckable(true);
        m_shows[i]->setFocusPolicy(Qt::TabFocus);
        shows->addWidget(m_shows[i]);
        connect(m_shows[i], &QToolButton::clicked, this, [this, i] {
            this->session().showCompared(static_cast<CompareShow>(i));
            showChoices(this->session().now());  // a click on the one that is on leaves it on
        });
    }
    shows->addStretch(1);

    auto* tolerance = new QHBoxLayout;
    tolerance->setSpacing(kStep);
    m_toleranceName->setObjectName("soft");
    tolerance->addWidget(m_toleranceName);
    tolerance->addWidget(m_tolerance, 1);
    auto* times = new QHBoxLayout;  // in two rows, that they fit into a narrow panel
    times->setSpacing(kStep);
    times->addWidget(m_times, 1);
    times->addWidget(m_worst);

    m_grid->setVerticalSpacing(3);
    m_grid->setColumnStretch(0, 1);
    auto* body = new QVBoxLayout(m_body);
    body->setContentsMargins(0, 0, 0, 0);
    body->setSpacing(kStep);
    body->addLayout(shows);
    body->addWidget(m_wipe);
    body->addWidget(m_verdict);
    body->addLayout(m_grid);
    body->addLayout(tolerance);
    body->addLayout(times);
    auto* links = new QHBoxLayout;
    links->setSpacing(kStep);
    links->addWidget(m_linked);
    links->addWidget(m_link);
    links->addStretch(1);
    body->addLayout(links);
    body->addWidget(m_linkNote);

    auto* inside = new ScrolledPart;
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(kStep);
    layout->addLayout(choices);
    layout->addWidget(m_hint);
    layout->addWidget(m_body);
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolling(inside));

    connect(m_a, &QComboBox::activated, this, [this](int index) {
        if (const int i = m_a->itemData(index).toInt(); i >= 0)
            this->session().setPipeline(presets()[static_cast<std::size_t>(i)].pipeline);
    });
    connect(m_b, &QComboBox::activated, this, [this](int index) {
        const int i = m_b->itemData(index).toInt();
        if (i >= 0)
            this->session().compareWith(presets()[static_cast<std::size_t>(i)].pipeline);
        else if (i == -1)
            this->session().compareWith({});
    });
    connect(m_keep, &QPushButton::clicked, this,
            [this] { this->session().compareWith(this->session().now().pipeline); });
    connect(m_swap, &QPushButton::clicked, this, [this] { this->session().swapCompared(); });
    connect(m_worst, &QPushButton::clicked, this, [this] {
        const auto& result = this->session().now().compare.result;
        if (result && result->difference.worst)
            this->session().pick(QPoint((*result->difference.worst)[0], (*result->difference.worst)[1]));
    });
    connect(m_wipe, &QSlider::valueChanged, this,
            [this](int value) { this->session().setWipe(static_cast<double>(value) / kWipeSteps); });
    connect(m_tolerance, &QSpinBox::valueChanged, this,
            [this](int steps) { this->session().setTolerance(static_cast<std::uint32_t>(steps)); });
    connect(m_link, &QComboBox::activated, this,
            [this](int index) { this->session().linkBy(static_cast<Link>(index)); });
    connect(m_linked, &QCheckBox::clicked, this, [this](bool on) { this->session().linkSteps(on); });
    spoken(*this, [this] {
        m_a->setAccessibleName(tr("Algorithm A"));
        m_b->setAccessibleName(tr("Algorithm B"));
        m_swap->setText(tr("Swap"));
        m_keep->setText(tr("Keep A as B"));
        m_worst->setText(tr("Worst pixel"));
        m_linked->setText(tr("Step B with A"));
        m_keep->setToolTip(tr("Keeps A as it is as B, so that you can change A and see what that does"));
        m_worst->setToolTip(tr("Picks a pixel where the two differ most: another surface before another depth"));
        m_wipe->setAccessibleName(tr("Where the wipe lies"));
        m_tolerance->setAccessibleName(tr("Tolerance in float32 steps"));
        m_tolerance->setToolTip(tr("Depths of one triangle that are no more float32 steps apart count as equal"));
        m_linked->setToolTip(tr("B is stepped with A, and stops where the box beside says"));
        m_link->setAccessibleName(tr("What of A's step B follows"));
        const std::array linkNames{tr("same step"), tr("same line"), tr("same stage"), tr("picked pixel")};
        const std::array linkTips{tr("The same number, or the same part of the run where B has no steps of that grain"),
                                  tr("Where B works on A's line for the first time"),
                                  tr("The same part of the same stage"),
                                  tr("Where B gives the picked pixel to the triangle that it shows in A")};
        for (std::size_t i = 0; i < linkNames.size(); ++i) {
            m_link->setItemText(static_cast<int>(i), linkNames[i]);
            m_link->setItemData(static_cast<int>(i), linkTips[i], Qt::ToolTipRole);
        }
        m_verdict->setAccessibleName(tr("Result of the comparison"));
        m_hint->setText(tr("Choose B, or press Shift and a digit, to hold one algorithm against another."));
        m_toleranceName->setText(tr("tolerance, float32 steps"));
        m_b->setItemText(0, tr("nothing"));
        sayTitles(*m_a, 0);
        sayTitles(*m_b, 1);
        const std::array texts{tr("A"), tr("B"), tr("Wipe"), tr("Difference"), tr("Both")};
        const std::array tips{
            tr("A (T goes to and fro)"), tr("B (T goes to and fro; hold Shift to see it for a moment)"),
            tr("A to the left, B to the right of a handle (W)"), tr("Where they differ, and by how much (D)"),
            tr("A and B side by side, moved and zoomed together (B)")};
        for (std::size_t i = 0; i < m_shows.size(); ++i) {
            m_shows[i]->setText(texts[i]);
            m_shows[i]->setToolTip(tips[i]);
        }
    });
}

void ComparePanel::present(const Snapshot& shown, Changes what)
{
    if (what & (Change::Compare | Change::Pipeline | Change::Scene)) showChoices(shown);
    if (what & (Change::Compare | Change::Picture | Change::Pipeline | Change::Scene)) showResult(shown);
}

void ComparePanel::showChoices(const Snapshot& shown)
{
    const CompareState& compare = shown.compare;
    choose(*m_a, shown.pipeline, wordOf(shown.pipeline), 0);
    choose(*m_b, compare.other, nameOfOther(compare), 1);
    m_swap->setEnabled(compare.other.has_value());
    m_swap->setToolTip(compare.other    ? tr("B becomes A, and A becomes B")
                       : compare.theirs ? tr("What another program drew cannot be drawn again as A")
                                        : tr("There is no B: choose one below"));
    m_body->setVisible(compare.isOn());
    m_hint->setVisible(!compare.isOn());
    for (QWidget* of : std::initializer_list<QWidget*>{m_toleranceName, m_tolerance, m_linked, m_link})
        of->setVisible(compare.other.has_value());
    for (std::size_t i = 0; i < m_shows.size(); ++i)
        m_shows[i]->setChecked(i == static_cast<std::size_t>(compare.seen()));
    m_wipe->setVisible(compare.seen() == CompareShow::Wipe);
    const QSignalBlocker quietWipe(m_wipe), quietTolerance(m_tolerance);
    m_wipe->setValue(static_cast<int>(compare.wipe * kWipeSteps + 0.5));
    m_tolerance->setValue(static_cast<int>(compare.tolerance));
    m_linked->setChecked(compare.isLinked);
    m_link->setCurrentIndex(static_cast<int>(compare.link));
    m_link->setEnabled(compare.isLinked);
    m_linkNote->setText(textOf(compare.linkNote));
    m_linkNote->setVisible(compare.other && shown.showsStep && compare.isLinked && !m_linkNote->text().isEmpty());
}

void ComparePanel::showResult(const Snapshot& shown)
{
    const CompareState& compare = shown.compare;
    const Comparison*   result  = compare.isOn() ? compare.result.get() : nullptr;
    m_worst->setEnabled(result && result->difference.worst);
    m_times->setVisible(compare.other.has_value());
    if (!compare.isOn()) {
        emit summaryChanged({});
        return;
    }
    if (!result) {
        m_verdict->setText(isStale(shown)   ? tr("B is of another scene or camera.")
                           : compare.theirs ? tr("B is being compared.")
                                            : tr("B is being drawn."));
        for (QLabel* label : m_names) label->hide();
        for (QLabel* label : m_values) label->hide();
        m_times->clear();
        return;
    }
    const Theme&       theme   = themeOf(palette());
    const CompareWords words   = wordsOf(*result);
    const bool         isEqual = result->theirs ? result->difference.differing() == 0 : result->figures.isExact();
    m_verdict->setText(QStringLiteral("<span style='color:%1'>%2 <b>%3</b></span>")
                           .arg(words.isWrong ? theme.error.name()
                                : isEqual     ? theme.entered.name()
                                              : theme.text.name(),
                                words.isWrong ? QStringLiteral("\u2716")
                                : isEqual     ? QStringLiteral("\u2713")
                                              : QStringLiteral("\u2248"),
                                words.verdict.toHtmlEscaped()));
    while (m_names.size() < words.figures.size()) {
        const int row = static_cast<int>(m_names.size());
        m_names.push_back(new QLabel);
        m_values.push_back(new QLabel);
        m_names.back()->setObjectName("soft");
        m_values.back()->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(m_names.back(), row, 0);
        m_grid->addWidget(m_values.back(), row, 1);
    }
    for (std::size_t i = words.figures.size(); i < m_names.size(); ++i) m_names[i]->hide(), m_values[i]->hide();
    for (std::size_t i = 0; i < words.figures.size(); ++i) {
        m_names[i]->setText(words.figures[i].name);
        m_values[i]->setText(words.figures[i].isWrong ? QStringLiteral("<span style='color:%1'><b>%2</b></span>")
                                                            .arg(theme.error.name(), words.figures[i].value)
                                                      : words.figures[i].value);
        m_names[i]->show();
        m_values[i]->show();
    }
    if (shown.frame && compare.frame)
        m_times->setText(
            tr("A %1 · B %2, this frame")
                .arg(milliseconds(shown.frame->report.frameMs), milliseconds(compare.frame->report.frameMs)));
    emit summaryChanged(isEqual ? tr("equal")
                                : counted(result->difference.differing(), tr("1 pixel"), tr("%1 pixels")));
}

void ComparePanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_body) showResult(session().now());
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
