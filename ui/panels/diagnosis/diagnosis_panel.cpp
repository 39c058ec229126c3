// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/diagnosis/diagnosis_panel.h"

#include <algorithm>

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "ui/panels/diagnosis/cause_row.h"
#include "ui/panels/diagnosis/diagnosis_words.h"
#include "ui/panels/lessons/lessons_panel.h"
#include "ui/parts/scrolling.h"
#include "ui/parts/wrapped_label.h"
#include "ui/session/course.h"
#include "ui/session/examiner.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

/// Core writes a pair's title as one's beside the other's, with quotation marks between them.
QString titleOf(const check::Cause& cause)
{
    QStringList titles;
    for (const QString& title : QString::fromStdString(cause.title).split(QStringLiteral("' and '")))
        titles << said(title.toStdString());
    return titles.join(QStringLiteral(" + "));
}

}  // namespace

DiagnosisPanel::DiagnosisPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_hint(wrappedLabel("hint")), m_title(wrappedLabel("title")), m_stale(wrappedLabel()),
      m_work(wrappedLabel("soft")), m_sentence(wrappedLabel()), m_conventions(wrappedLabel("soft")),
      m_causesTitle(wrappedLabel("section")), m_clusters(wrappedLabel()), m_open(new QPushButton),
      m_again(new QPushButton), m_back(new QPushButton), m_cancel(new QPushButton), m_first(new QPushButton),
      m_report(new QPushButton), m_progress(new QProgressBar), m_rows(new QVBoxLayout)
{
    m_hint->setAlignment(Qt::AlignCenter);
    m_progress->setTextVisible(false);
    for (QPushButton* button : {m_open, m_again, m_back, m_cancel, m_first, m_report})
        button->setFocusPolicy(Qt::TabFocus);

    auto* counts = new QGridLayout;
    counts->setHorizontalSpacing(2 * kStep);
    counts->setVerticalSpacing(3);
    counts->setColumnStretch(0, 1);
    for (std::size_t column = 0; column < 2; ++column) {
        m_heads[column] = new QLabel;
        m_heads[column]->setObjectName("soft");
        counts->addWidget(m_heads[column], 0, static_cast<int>(column) + 1, Qt::AlignRight);
    }
    for (std::size_t kind = 0; kind < 4; ++kind) {
        const int row      = static_cast<int>(kind) + 1;
        m_countNames[kind] = new QLabel;
        m_countNames[kind]->setObjectName("soft");
        counts->addWidget(m_countNames[kind], row, 0);
        for (std::size_t column = 0; column < 2; ++column) {
            m_counts[kind][column] = new QLabel;
            counts->addWidget(m_counts[kind][column], row, static_cast<int>(column) + 1, Qt::AlignRight);
        }
    }
    m_rows->setSpacing(4);
    auto* work = new QHBoxLayout;
    work->setSpacing(kStep);
    work->addWidget(m_progress, 1);
    work->addWidget(m_cancel);
    const auto row = [](QPushButton* left, QPushButton* right) {
        auto* buttons = new QHBoxLayout;
        buttons->setSpacing(kStep);
        buttons->addWidget(left);
        buttons->addWidget(right);
        buttons->addStretch(1);
        return buttons;
    };

    auto* body   = new ScrolledPart;
    auto* inside = new QVBoxLayout(body);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(kStep);
    inside->addWidget(m_title);
    inside->addWidget(m_stale);
    inside->addLayout(row(m_again, m_back));
    inside->addWidget(m_work);
    inside->addLayout(work);
    inside->addWidget(m_sentence);
    inside->addLayout(row(m_first, m_report));
    inside->addWidget(m_causesTitle);
    inside->addLayout(m_rows);
    inside->addWidget(m_clusters);
    inside->addLayout(counts);
    inside->addWidget(m_conventions);
    inside->addStretch(1);

    auto* empty  = new QWidget;
    auto* middle = new QVBoxLayout(empty);
    middle->setContentsMargins(2 * kStep, kStep, 2 * kStep, kStep);
    middle->setSpacing(kStep);
    middle->addStretch(1);
    middle->addWidget(m_hint);
    middle->addWidget(m_open, 0, Qt::AlignHCenter);
    middle->addStretch(1);
    m_bodyOrHint = new QStackedLayout(this);
    m_bodyOrHint->addWidget(scrolling(body));
    m_bodyOrHint->addWidget(empty);

    Examiner& examiner = session.examiner();
    connect(m_open, &QPushButton::clicked, &examiner, &Examiner::chooseFiles);
    connect(m_again, &QPushButton::clicked, &examiner, &Examiner::judgeAgain);
    connect(m_back, &QPushButton::clicked, &examiner, &Examiner::goBack);
    connect(m_report, &QPushButton::clicked, &examiner, &Examiner::chooseReport);
    connect(m_cancel, &QPushButton::clicked, &examiner, &Examiner::cancel);
    connect(&examiner, &Examiner::changed, this, &DiagnosisPanel::showWork);
    connect(m_first, &QPushButton::clicked, this, [this] {
        const auto theirs = this->session().now().compare.theirs;
        if (!theirs || !theirs->answer->firstWrong) return;
        const PixelPosition at = theirs->answer->firstWrong->pixel;
        this->session().pick(QPoint(at.x, at.y));
    });
    spoken(*this, [this] {
        m_hint->setText(
            tr("Drop what your own renderer drew on the window: depth, ids or a picture. Its mistakes are "
               "found and named here."));
        m_open->setText(tr("Open my picture…"));
        m_again->setText(tr("Judge again"));
        m_again->setToolTip(tr("Reads the files again and judges them by the camera on show (F7)"));
        m_back->setText(tr("Back to its view"));
        m_back->setToolTip(tr("Opens the scene and the camera by which the picture was judged"));
        m_cancel->setText(tr("Cancel"));
        m_first->setText(tr("First wrong pixel"));
        m_first->setToolTip(tr("Picks the first wrong pixel in reading order: the panel Why says what is wrong there"));
        m_report->setText(tr("Save report…"));
        m_report->setToolTip(tr("Writes a page with pictures, in English and Chinese, to hand in"));
        m_causesTitle->setText(tr("What explains it. A click draws A with it."));
        m_causesTitle->setToolTip(tr("A click switches the mistake on in A, another one switches it off"));
        m_sentence->setAccessibleName(tr("Diagnosis"));
        m_conventions->setAccessibleName(tr("Conventions found"));
        m_progress->setAccessibleName(tr("Progress of the judging"));
        m_heads[0]->setText(tr("wrong"));
        m_heads[1]->setText(tr("rounding"));
        for (const check::Mistake mistake : check::kMistakes)
            m_countNames[static_cast<std::size_t>(mistake)]->setText(nameOf(mistake));
        showWork();
        showAnswer(this->session().now());
    });
}

void DiagnosisPanel::present(const Snapshot& shown, Changes what)
{
    if (what & (Change::Compare | Change::Scene | Change::Camera)) showAnswer(shown);
    if (what & (Change::Pipeline | Change::Compare)) showCauses(shown);
}

void DiagnosisPanel::showWork()
{
    const Examiner&       examiner = session().examiner();
    const Examiner::Phase phase    = examiner.phase();
    const bool            isAtWork = phase != Examiner::Phase::Idle;
    const auto            theirs   = session().now().compare.theirs;
    m_bodyOrHint->setCurrentIndex(theirs || isAtWork ? 0 : 1);
    m_progress->setVisible(isAtWork);
    m_cancel->setVisible(isAtWork);
    m_progress->setRange(0, examiner.progress() < 0 ? 0 : 1000);
    if (examiner.progress() >= 0) m_progress->setValue(static_cast<int>(examiner.progress() * 1000));
    m_work->setText(phase == Examiner::Phase::Judging      ? tr("The reference is drawn and compared.")
                    : phase == Examiner::Phase::Diagnosing ? tr("Mistakes are tried, one after another.")
                    : theirs && !theirs->isDiagnosed       ? tr("Mistakes were not tried: it was cancelled.")
                                                           : QString());
    m_work->setVisible(!m_work->text().isEmpty());
    m_again->setEnabled(!isAtWork);
}

void DiagnosisPanel::showAnswer(const Snapshot& shown)
{
    showWork();
    const auto theirs = shown.compare.theirs;
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_title, m_sentence, m_conventions, m_again, m_first, m_report})
        part->setVisible(theirs != nullptr);
    const bool isOld = theirs && isStale(shown);
    m_stale->setVisible(isOld);
    m_back->setVisible(isOld);
    for (QLabel* label : m_heads) label->setVisible(theirs != nullptr);
    for (std::size_t kind = 0; kind < 4; ++kind) {
        m_countNames[kind]->setVisible(theirs != nullptr);
        for (QLabel* label : m_counts[kind]) label->setVisible(theirs != nullptr);
    }
    if (!theirs) {
        emit summaryChanged({});
        return showCauses(shown);
    }
    const Theme&              theme  = themeOf(palette());
    const check::CheckAnswer& answer = *theirs->answer;
    m_title->setText(theirs->title);
    m_stale->setText(QStringLiteral("\u26A0 ")
                     + (shown.scene && theirs->scene != shown.scene->scene().digest
                            ? tr("Another scene is open than the one by which this was judged.")
                            : tr("The camera has moved since this was judged.")));
    m_sentence->setText(said(answer.sentence));
    m_conventions->setText(tr("Found: %1.").arg(conventionsText(answer.conventions)));
    m_first->setEnabled(answer.firstWrong.has_value() && !isOld);
    for (const check::Mistake mistake : check::kMistakes) {
        const auto& labels = m_counts[static_cast<std::size_t>(mistake)];
        labels[0]->setText(answer.wrong.of(mistake) == 0
                               ? QStringLiteral("0")
                               : QStringLiteral("<span style='color:%1'><b>%2</b></span>")
                                     .arg(theme.error.name(), grouped(answer.wrong.of(mistake))));
        labels[1]->setText(grouped(answer.rounding.of(mistake)));
    }
    QStringList places;
    for (const check::Cluster& cluster : answer.clusters)
        places << tr("%1 % of the wrong pixels lie %2, and %3 % of all.")
                      .arg(cluster.share * 100, 0, 'f', 1)
                      .arg(said(cluster.where))
                      .arg(cluster.usual * 100, 0, 'f', 1);
    m_clusters->setText(places.join('\n'));
    m_clusters->setVisible(!places.isEmpty());
    emit summaryChanged(isOld ? tr("old") : counted(answer.wrong.total(), tr("1 wrong pixel"), tr("%1 wrong pixels")));
    showCauses(shown);
}

void DiagnosisPanel::showCauses(const Snapshot& shown)
{
    const auto        theirs = shown.compare.theirs;
    const std::size_t count  = theirs ? theirs->answer->causes.size() : 0;
    while (m_causes.size() < count) {
        const std::size_t at = m_causes.size();
        m_causes.push_back(new CauseRow);
        m_lessons.push_back(wrappedLabel());
        m_lessons.back()->setTextFormat(Qt::RichText);
        m_lessons.back()->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
        m_lessons.back()->setContentsMargins(kStep, 0, 0, 4);
        m_rows->addWidget(m_causes.back());
        m_rows->addWidget(m_lessons.back());
        connect(m_causes.back(), &QAbstractButton::clicked, this, [this, at] { toggle(at); });
        connect(m_lessons.back(), &QLabel::linkActivated, this, [this](const QString& name) {
            if (const auto lesson = this->session().course().find(name)) this->session().course().open(*lesson);
        });
    }
    m_causesTitle->setVisible(count > 0);
    if (!theirs) m_clusters->hide();
    for (std::size_t i = 0; i < m_causes.size(); ++i) {
        m_causes[i]->setVisible(i < count);
        m_lessons[i]->setVisible(false);
        if (i >= count) continue;
        const check::Cause& cause = theirs->answer->causes[i];
        m_causes[i]->present(titleOf(cause), cause.explains, shown.pipeline == cause.pipeline);
        QString tip =
            tr("%1 explains %2 of the wrong pixels.").arg(QString::fromStdString(cause.name), grouped(cause.explained));
        if (cause.adds > 0)
            tip += ' ' + counted(cause.adds, tr("It would spoil 1 more pixel."), tr("It would spoil %1 more pixels."));
        m_causes[i]->setToolTip(tip + '\n' + m_causesTitle->toolTip());
        const auto lesson = session().course().find(utf8Text(cause.lesson));
        if (cause.lesson.empty() || !lesson) continue;
        m_lessons[i]->setText(
            QStringLiteral("<a style='color:%1' href='%2'>%3</a>")
                .arg(themeOf(palette()).picked.name(), utf8Text(cause.lesson),
                     tr("Lesson: %1").arg(inLanguage(session().course().lessons()[*lesson].title)).toHtmlEscaped()));
        m_lessons[i]->setVisible(true);
    }
}

void DiagnosisPanel::toggle(std::size_t cause)
{
    const Snapshot& now = session().now();
    if (!now.compare.theirs || cause >= now.compare.theirs->answer->causes.size()) return;
    const auto& causes = now.compare.theirs->answer->causes;
    const bool  isOfCause =
        std::ranges::any_of(causes, [&](const check::Cause& of) { return of.pipeline == now.pipeline; });
    if (now.pipeline == causes[cause].pipeline) {
        session().setPipeline(m_before.value_or(findPreset("zbuffer")->pipeline));
    } else {
        if (!isOfCause) m_before = now.pipeline;  // what A was before the first of them
        session().setPipeline(causes[cause].pipeline);
    }
    if (now.compare.seen() == CompareShow::B) session().showCompared(CompareShow::A);  // where it can be seen
    showCauses(session().now());
}

void DiagnosisPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_bodyOrHint) showAnswer(session().now());
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
