// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/lessons/lessons_panel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QStackedLayout>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/parts/scrolling.h"
#include "ui/session/course.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

/// Lessons hold both languages; a translation says which of them it is.
bool speaksChinese()
{
    return LessonsPanel::tr("en", "the language of this translation: zh in Chinese") == QLatin1String("zh");
}
QLabel* wrapped(Qt::TextFormat format = Qt::PlainText)
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextFormat(format);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    return label;
}

}  // namespace

QString inLanguage(const LessonText& text) { return QString::fromStdString(text.in(speaksChinese())); }

LessonsPanel::LessonsPanel(Session& session, QWidget* parent) : Panel(session, parent)
{
    m_listOrPage = new QStackedLayout(this);
    m_listOrPage->addWidget(makeList());
    m_listOrPage->addWidget(makePage());
    connect(&session.course(), &Course::changed, this, &LessonsPanel::showAll);
    // After the panel has been raised: what is not seen takes no focus.
    connect(&session.course(), &Course::opened, this,
            [this] { QTimer::singleShot(0, m_scroll, qOverload<>(&QWidget::setFocus)); });
    connect(&session.course(), &Course::listWanted, this,
            [this] { QTimer::singleShot(0, m_list, qOverload<>(&QWidget::setFocus)); });
    spoken(*this, [this] {
        m_list->setAccessibleName(tr("Lessons"));
        m_contents->setText(tr("All lessons"));
        m_again->setText(tr("Show again"));
        m_again->setToolTip(tr("Brings scene, algorithm and step of this page back"));
        m_back->setText(tr("Back"));
        m_back->setToolTip(tr("The page before (Ctrl+Shift+PageUp)"));
        m_next->setText(tr("Next"));
        m_next->setToolTip(tr("The next page (Ctrl+Shift+PageDown)"));
        m_check->setText(tr("Check"));
        m_number->setAccessibleName(tr("Your answer, a number"));
        m_scroll->setAccessibleName(tr("Page of the lesson"));
        m_verdict->setAccessibleName(tr("Whether the answer is right"));
        m_shownPage = nullptr;  // its question is said again
        showAll();
    });
}

QWidget* LessonsPanel::makeList()
{
    auto* page = new QWidget;
    m_list     = new QListWidget;
    m_list->setObjectName("lessons");
    m_list->setWordWrap(true);
    m_list->setSpacing(2);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setProperty("ownsArrows", true);
    m_list->setProperty("ownsEnter", true);
    m_listHint = wrapped();
    m_listHint->setObjectName("soft");
    m_troubles = wrapped();
    m_troubles->setObjectName("troubles");
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(kStep);
    layout->addWidget(m_listHint);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_troubles);
    const auto open = [this](QListWidgetItem* item) {
        session().course().open(static_cast<std::size_t>(m_list->row(item)));
    };
    connect(m_list, &QListWidget::itemActivated, this, open);
    connect(m_list, &QListWidget::itemClicked, this, open);

    return page;
}

QWidget* LessonsPanel::makePage()
{
    auto* page = new QWidget;
    m_title    = wrapped();
    m_title->setObjectName("title");
    m_text  = wrapped(Qt::MarkdownText);
    m_where = new QLabel;
    m_where->setObjectName("soft");
    m_contents = new QPushButton;
    m_again    = new QPushButton;
    m_back     = new QPushButton;
    m_next     = new QPushButton;
    m_next->setObjectName("strong");

    auto* reading = new ScrolledPart;
    auto* inside  = new QVBoxLayout(reading);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(kStep);
    inside->addWidget(m_title);
    inside->addWidget(m_text);
    inside->addWidget(makeQuestion());
    inside->addStretch(1);
    m_scroll = qobject_cast<QScrollArea*>(scrolling(reading));
    m_scroll->setFocusPolicy(Qt::StrongFocus);
    m_scroll->setProperty("ownsUpAndDown", true);  // they scroll; Left and Right step

    auto* pages = new QHBoxLayout;
    pages->setContentsMargins(kStep + 4, 0, kStep + 4, 0);
    pages->setSpacing(kStep);
    pages->addWidget(m_back);
    pages->addWidget(m_where, 1, Qt::AlignCenter);
    pages->addWidget(m_next);
    auto* elsewhere = new QHBoxLayout;
    elsewhere->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    elsewhere->setSpacing(kStep);
    elsewhere->addWidget(m_contents, 1);
    elsewhere->addWidget(m_again, 1);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kStep);
    layout->addWidget(m_scroll, 1);
    layout->addLayout(pages);
    layout->addLayout(elsewhere);
    connect(m_back, &QPushButton::clicked, this, [this] { session().course().back(); });
    connect(m_next, &QPushButton::clicked, this, [this] { session().course().next(); });
    connect(m_contents, &QPushButton::clicked, this, [this] {
        session().course().close();
        m_list->setFocus();
    });
    connect(m_again, &QPushButton::clicked, this, [this] { session().course().show(); });
    return page;
}

QWidget* LessonsPanel::makeQuestion()
{
    m_question = new QFrame;
    m_question->setObjectName("question");
    m_ask = wrapped();
    m_ask->setObjectName("section");
    m_choices     = new QButtonGroup(this);
    m_choicesRoom = new QVBoxLayout;
    m_choicesRoom->setSpacing(6);
    m_number    = new QLineEdit;
    m_unit      = new QLabel;
    m_numberRow = new QWidget;
    auto* row   = new QHBoxLayout(m_numberRow);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_number, 1);
    row->addWidget(m_unit);
    m_pixel      = wrapped();
    m_check      = new QPushButton;
    m_verdict    = wrapped(Qt::RichText);
    m_why        = wrapped();
    auto* layout = new QVBoxLayout(m_question);
    layout->setContentsMargins(0, kStep, 0, 0);
    layout->setSpacing(kStep);
    layout->addWidget(m_ask);
    layout->addLayout(m_choicesRoom);
    layout->addWidget(m_numberRow);
    layout->addWidget(m_pixel);
    layout->addWidget(m_check, 0, Qt::AlignLeft);
    layout->addWidget(m_verdict);
    layout->addWidget(m_why);
    connect(m_check, &QPushButton::clicked, this, &LessonsPanel::check);
    connect(m_number, &QLineEdit::returnPressed, this, &LessonsPanel::check);
    m_number->setProperty("ownsEnter", true);
    return m_question;
}

void LessonsPanel::present(const Snapshot&, Changes what)
{
    if (what & Change::Selection) showPick();
    if (what == kEverything) showAll();  // another appearance or language
}

void LessonsPanel::showAll()
{
    const Course& course = session().course();
    if (course.page())
        showPage();
    else
        showList();
    m_listOrPage->setCurrentIndex(course.page() ? 1 : 0);
}

void LessonsPanel::showList()
{
    const Course& course = session().course();
    const int     row    = m_list->currentRow();
    m_list->clear();
    for (std::size_t i = 0; i < course.lessons().size(); ++i) {
        const Lesson& lesson = course.lessons()[i];
        QString       line   = tr("%1  %2").arg(i + 1).arg(inLanguage(lesson.title));
        if (const Course::Score score = course.scoreOf(i); score.answered > 0)
            line += tr("  (%1 of %2 right)").arg(score.right).arg(score.questions);
        m_list->addItem(line);
    }
    m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    m_listHint->setText(course.lessons().empty()
                            ? tr("There are no lessons here. Choose a folder of lessons in the menu Lessons.")
                            : tr("Choose a lesson: each brings its own scenes, stops and questions."));
    m_troubles->setVisible(!course.troubles().isEmpty());
    m_troubles->setText(course.troubles().join('\n'));
    emit summaryChanged(counted(course.lessons().size(), tr("1 lesson"), tr("%1 lessons")));
}

void LessonsPanel::showPage()
{
    const Course&     course = session().course();
    const Lesson&     lesson = *course.lesson();
    const LessonPage& page   = *course.page();
    m_title->setText(tr("%1  %2").arg(course.lessonNumber() + 1).arg(inLanguage(lesson.title)));
    m_where->setText(tr("page %1 of %2").arg(course.pageNumber() + 1).arg(lesson.pages.size()));
    m_back->setEnabled(course.pageNumber() > 0);
    m_next->setEnabled(course.pageNumber() + 1 < lesson.pages.size());
    emit summaryChanged(m_where->text());
    if (m_shownPage != &page) {
        m_text->setText(inLanguage(page.text));
        m_scroll->ensureVisible(0, 0);
        m_shownPage = &page;
        m_question->setVisible(page.question.has_value());
        if (page.question) showChoices();
    }
    if (page.question) showQuestion();
}

void LessonsPanel::showChoices()
{
    using Kind                     = LessonQuestion::Kind;
    const LessonQuestion& question = *session().course().page()->question;
    m_ask->setText(inLanguage(question.ask));
    for (const ChoiceRow& row : m_rows) {
        m_choices->removeButton(row.button);
        row.row->hide();
        row.row->deleteLater();
    }
    m_rows.clear();
    for (const LessonChoice& choice : question.choices) {
        ChoiceRow row{new QWidget, new QRadioButton, wrapped()};
        row.text->setText(inLanguage(choice.text));
        row.text->setBuddy(row.button);
        row.button->setAccessibleName(inLanguage(choice.text));
        row.button->setProperty("ownsArrows", true);
        auto* layout = new QHBoxLayout(row.row);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(4);
        layout->addWidget(row.button, 0, Qt::AlignTop);
        layout->addWidget(row.text, 1);
        m_choices->addButton(row.button, static_cast<int>(m_rows.size()));
        m_choicesRoom->addWidget(row.row);
        m_rows.push_back(row);
    }
    m_numberRow->setVisible(question.kind == Kind::Number);
    m_unit->setText(inLanguage(question.unit));
    m_number->clear();
    m_pixel->setVisible(question.kind == Kind::Pixel);
    const GivenAnswer* given = session().course().given();
    if (given && given->choice) m_rows[*given->choice].button->setChecked(true);
    if (given && question.kind == Kind::Number) m_number->setText(given->text);
    showPick();
}

void LessonsPanel::showPick()
{
    const LessonPage* page = session().course().page();
    if (!page || !page->question || page->question->kind != LessonQuestion::Kind::Pixel) return;
    const auto& picked = session().now().picked;
    m_pixel->setText(picked ? tr("Picked pixel: %1, %2").arg(picked->x()).arg(picked->y())
                            : tr("Click the pixel in the picture, or move to it with Ctrl and the arrow keys."));
}

void LessonsPanel::showQuestion()
{
    const Course& course = session().course();
    m_check->setEnabled(course.isReady());
    m_check->setToolTip(course.isReady() ? QString() : tr("The page is still on its way to its step"));
    showVerdict();
}

void LessonsPanel::showVerdict()
{
    const Course&         course   = session().course();
    const LessonQuestion& question = *course.page()->question;
    const GivenAnswer*    given    = course.given();
    m_verdict->setVisible(given != nullptr);
    m_why->setVisible(given != nullptr);
    if (!given) return;
    const Theme& theme    = themeOf(palette());
    const bool   isNumber = question.kind == LessonQuestion::Kind::Number;
    QString      words    = given->isRight ? tr("✔ Right.")
                            : isNumber     ? tr("✘ %1 is not right.").arg(given->text.toHtmlEscaped())
                                           : tr("✘ Not right.");
    if (!given->isRight && course.right()) {
        const LessonAnswer& right = *course.right();
        if (right.choice)
            words += ' ' + tr("It is: %1").arg(inLanguage(question.choices[*right.choice].text).toHtmlEscaped());
        else if (right.number)
            words += ' ' + tr("It is %1.").arg(QLocale::c().toString(*right.number, 'g', 7));
        else
            words += ' ' + tr("Pixel %1 is none of those that were asked for.").arg(given->text);
    }
    m_verdict->setText(
        QStringLiteral("<b style='color:%1'>%2</b>").arg((given->isRight ? theme.entered : theme.error).name(), words));
    m_why->setText(inLanguage(question.why));
    QTimer::singleShot(0, this, [this] { m_scroll->ensureWidgetVisible(m_why); });
}

void LessonsPanel::check()
{
    Course&           course = session().course();
    const LessonPage* page   = course.page();
    if (!page || !page->question || !course.isReady()) return;
    if (page->question->kind == LessonQuestion::Kind::Choice && m_choices->checkedId() >= 0)
        course.answerChoice(static_cast<std::size_t>(m_choices->checkedId()));
    if (page->question->kind == LessonQuestion::Kind::Number) course.answerNumber(m_number->text());
    if (page->question->kind == LessonQuestion::Kind::Pixel && session().now().picked)
        course.answerPixel(*session().now().picked);
    if (page->question->kind == LessonQuestion::Kind::Number && !m_number->text().trimmed().isEmpty()
        && (!course.given() || course.given()->text != m_number->text().trimmed())) {
        m_verdict->setText(tr("“%1” is no number.").arg(m_number->text().trimmed().toHtmlEscaped()));
        m_verdict->show();
        m_why->hide();
    }
    // the page is read on, and the keys step
    if (course.given() && course.given()->isRight) return m_scroll->setFocus();
    // to be answered anew; elsewhere its digits would choose algorithms
    if (page->question->kind == LessonQuestion::Kind::Number && course.given()) {
        m_number->clear();  // in an empty field Left and Right step
        m_number->setFocus();
    } else if (course.given()) {
        m_scroll->setFocus();
    }
}

void LessonsPanel::keyPressEvent(QKeyEvent* event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && m_choices->checkedId() >= 0 && qobject_cast<QRadioButton*>(focusWidget())) return check();
    Panel::keyPressEvent(event);
}

}  // namespace zscope::ui
