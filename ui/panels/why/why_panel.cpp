// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/why/why_panel.h"

#include <algorithm>
#include <span>

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/lesson/explain.h"
#include "ui/panels/diagnosis/diagnosis_words.h"
#include "ui/panels/why/why_model.h"
#include "ui/parts/row_delegate.h"
#include "ui/parts/scrolling.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

QString takenBy(const PixelExplanation&) { return {}; }  // it lists them

/// What its pixels show in its place, where that is more than the sentence has room for: a line of its own, or nothing.
QString takenBy(const TriangleExplanation& explanation)
{
    constexpr std::size_t kMost = 4;
    const std::size_t     count = std::min(kMost, explanation.takers.size());
    if (explanation.takers.size() < 2) return {};
    QStringList takers;
    for (const Taker& taker : std::span(explanation.takers).first(count)) {
        const QString pixels = counted(taker.pixels, WhyPanel::tr("1 pixel"), WhyPanel::tr("%1 pixels"));
        takers << (taker.id < 0
                       ? WhyPanel::tr("the background at %1").arg(pixels)
                       : WhyPanel::tr("triangle %1 at %2").arg(grouped(static_cast<std::uint64_t>(taker.id)), pixels));
    }
    const std::uint64_t more = explanation.takers.size() - count + explanation.otherTakers;
    if (more > 0) takers << counted(more, WhyPanel::tr("1 other triangle"), WhyPanel::tr("%1 other triangles"));
    return '\n' + WhyPanel::tr("In its place its pixels show %1.").arg(takers.join(QStringLiteral(", ")));
}

}  // namespace

WhyPanel::WhyPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_model(new WhyModel(this)), m_tree(new QTreeView), m_theirs(new QLabel),
      m_sentence(new QLabel), m_detail(new QLabel), m_hint(new QLabel), m_trouble(new QLabel), m_jump(new QPushButton),
      m_triangle(new QLineEdit), m_worker(std::make_unique<Worker>())
{
    m_tree->setModel(m_model);
    m_tree->viewport()->installEventFilter(this);
    m_tree->setItemDelegate(new RowDelegate(m_tree));
    m_tree->setUniformRowHeights(true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setIndentation(12);
    m_tree->setSelectionMode(QAbstractItemView::SingleSelection);
    m_tree->setMinimumHeight(90);
    m_tree->setExpandsOnDoubleClick(false);
    m_tree->setProperty("ownsArrows", true);
    m_tree->setProperty("ownsEnter", true);  // it jumps
    QFont small = m_tree->font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    m_tree->setFont(small);
    m_tree->header()->setFont(small);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionsMovable(false);
    m_tree->header()->setSectionResizeMode(QHeaderView::Fixed);
    for (QLabel* label : {m_theirs, m_sentence, m_detail, m_trouble}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    }
    m_theirs->setTextFormat(Qt::RichText);
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setMargin(2 * kStep);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    m_jump->setFocusPolicy(Qt::TabFocus);
    m_triangle->setValidator(new QRegularExpressionValidator(QRegularExpression("[0-9]{0,9}"), m_triangle));
    m_triangle->setMaximumWidth(150);

    auto* row = new QHBoxLayout;
    row->setSpacing(kStep);
    row->addWidget(m_jump);
    row->addStretch(1);
    row->addWidget(m_triangle);
    auto* answer = new ScrolledPart;
    auto* inside = new QVBoxLayout(answer);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(6);
    inside->addWidget(m_theirs);
    inside->addWidget(m_hint, 1);
    inside->addWidget(m_sentence);
    inside->addWidget(m_tree, 1);
    inside->addWidget(m_detail);
    inside->addWidget(m_trouble);
    inside->addLayout(row);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolling(answer));
    complain({});

    connect(m_tree->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& at) { showRow(at); });
    connect(m_tree, &QTreeView::activated, this, &WhyPanel::jump);
    connect(m_jump, &QPushButton::clicked, this, [this] { jump(m_tree->currentIndex()); });
    connect(m_triangle, &QLineEdit::returnPressed, this, [this] {
        bool       isNumber = false;
        const uint number   = m_triangle->text().toUInt(&isNumber);
        if (isNumber) askAbout(TriangleId{number});
    });
    connect(&session, &Session::pickedAgain, this, [this] {
        m_about.reset();
        complain({});
        ask();
    });
    spoken(*this, [this] {
        m_jump->setText(tr("Go there"));
        m_tree->setAccessibleName(tr("Triangles that cover the pixel"));
        m_theirs->setAccessibleName(tr("What B has at the pixel"));
        m_sentence->setAccessibleName(tr("Why"));
        m_detail->setAccessibleName(tr("What happened to the chosen triangle"));
        showRow({});  // says what the button does, or why it does nothing
        m_triangle->setPlaceholderText(tr("Why not triangle …"));
        m_triangle->setAccessibleName(tr("Number of a triangle to ask about"));
    });
}

WhyPanel::~WhyPanel() = default;

void WhyPanel::askAbout(TriangleId triangle)
{
    m_about = triangle;
    complain({});
    ask();
}

void WhyPanel::present(const Snapshot& shown, Changes what)
{
    if (what & (Change::Picture | Change::Selection | Change::Scene | Change::Compare)) showTheirs(shown);
    if (!(what & (Change::Picture | Change::Selection | Change::Scene))) return;
    if (shown.picked != m_lastPick || (what & Change::Scene)) {
        m_about.reset();
        complain({});
    }
    m_lastPick = shown.picked;
    ask();
    saySentence();
}

void WhyPanel::showTheirs(const Snapshot& shown)
{
    const auto theirs  = shown.compare.theirs;
    const bool isThere = theirs && shown.picked && shown.picked->x() < theirs->camera().width
                         && shown.picked->y() < theirs->camera().height && !isStale(shown);
    m_theirs->setVisible(isThere);
    if (isThere) m_theirs->setText(pixelText(*theirs, *shown.picked, themeOf(palette())));
}

void WhyPanel::saySentence()
{
    const bool isOnTheWay = session().now().showsStep && !m_said.isEmpty();
    m_sentence->setText(
        isOnTheWay ? m_said + '\n' + tr("That is the finished picture; the step on show may not have come so far.")
                   : m_said);
}

void WhyPanel::tell(const QString& sentence)
{
    m_hint->setText(sentence);
    m_hint->show();
    for (QWidget* part : {static_cast<QWidget*>(m_sentence), static_cast<QWidget*>(m_tree),
                          static_cast<QWidget*>(m_detail), static_cast<QWidget*>(m_jump)})
        part->hide();
    m_answered.reset();
    emit summaryChanged({});
}

void WhyPanel::showAnswer()
{
    m_hint->hide();
    m_sentence->show();
    m_tree->show();
    m_jump->show();
    m_answered = m_asked;
}

void WhyPanel::refuse(const Question& question, const QString& trouble)
{
    if (!question.triangle) return tell(trouble);
    const bool isOther = m_answered && m_answered->triangle != question.triangle;
    m_about            = isOther ? m_answered->triangle : std::nullopt;
    m_asked            = isOther ? m_answered : std::nullopt;
    ask();  // nothing, if that answer is of this very picture
    complain(trouble);
}

void WhyPanel::complain(const QString& trouble)
{
    m_trouble->setText(trouble);
    m_trouble->setVisible(!trouble.isEmpty());
}

void WhyPanel::ask()
{
    const Snapshot& now = session().now();
    if (!isVisible()) return;
    m_triangle->setVisible(now.scene != nullptr);
    if (!now.scene || !now.frame || (!now.picked && !m_about)) {
        m_asked.reset();
        m_pixelAnswer.reset();
        m_model->clear();
        m_worker->cancel();
        return tell(
            !now.scene
                ? tr("Open a scene to ask why a pixel shows what it shows.")
                : tr("Click a pixel of the picture: everything that covers it appears here, with what became of it."));
    }
    const Question question{now.frame->generation, now.picked, m_about};
    if (m_asked == question) return;
    m_asked = question;
    if (m_model->rowCount() == 0) tell(tr("Running the frame once more, to see …"));
    DrawRequest request = session().request();
    request.camera      = now.frame->camera;
    request.pipeline    = now.frame->pipeline;
    m_worker->post(Worker::Slot::Draw, [this, question, request](const std::atomic<bool>& cancel) mutable {
        request.cancel = &cancel;
        Progress progress;
        progress.cancel    = &cancel;
        const auto deliver = [this, &question](auto answer, const QString& trouble) {
            m_worker->deliver([this, question, answer, trouble] {
                if (m_asked != question) return;
                if (!answer) return refuse(question, trouble);
                m_model->setPalette(palette());
                m_model->present(answer);
                showAnswer();
                m_said = said(answer->sentence) + takenBy(*answer);
                saySentence();
                if constexpr (std::is_same_v<decltype(answer), std::shared_ptr<const PixelExplanation>>) {
                    m_pixelAnswer = answer;
                    emit summaryChanged(
                        tr("pixel %1, %2 · %3")
                            .arg(answer->pixel.x)
                            .arg(answer->pixel.y)
                            .arg(counted(answer->candidates.size(), tr("1 triangle"), tr("%1 triangles"))));
                } else {
                    m_pixelAnswer.reset();
                    emit summaryChanged(tr("triangle %1").arg(grouped(answer->triangle.value)));
                }
                fitColumns();
                showRow({});
            });
        };
        const auto hand = [&](auto made) {
            using Answer = std::remove_cvref_t<decltype(*made)>;
            if (cancel) return;
            if (made)
                deliver(std::make_shared<const Answer>(std::move(made).value()), QString());
            else
                deliver(std::shared_ptr<const Answer>(), said(made.error()));
        };
        if (question.triangle)
            hand(explainTriangle(request, *question.triangle, progress));
        else
            hand(explainPixel(request, {question.pixel->x(), question.pixel->y()}, progress));
    });
}

void WhyPanel::showRow(const QModelIndex& at)
{
    m_detail->setText(m_model->sentenceOf(at));
    m_detail->setVisible(!m_detail->text().isEmpty());
    m_jump->setEnabled(m_model->eventOf(at) != nullptr);
    m_jump->setToolTip(m_jump->isEnabled() ? tr("Goes to the step of the run that the chosen row tells of (Enter)")
                                           : tr("Choose a row that tells of a step"));
    if (!at.isValid()) return;
    session().selectTriangle(m_model->triangleOf(at));
    const Event* event = m_model->eventOf(at);
    if (event && event->node) session().selectNode(event->node);
    if (event && event->level) session().selectLevel(*event->level);
}

void WhyPanel::jump(const QModelIndex& at)
{
    const Event* event = m_model->eventOf(at);
    if (!event) return;
    session().goToStepOf(event->grain, event->moment.at(event->grain).value);
    showRow(at);  // the step may have chosen another level
}

void WhyPanel::fitColumns()
{
    const QFontMetrics metrics = m_tree->fontMetrics();
    const int          depth   = metrics.horizontalAdvance(QStringLiteral("0.000000000")) + 14;
    const int          fate    = metrics.horizontalAdvance(QStringLiteral("\u25BD ") + tr("node too small")) + 18;
    const int          room    = m_tree->viewport()->width();
    m_tree->setColumnWidth(WhyModel::Depth, depth);
    m_tree->setColumnWidth(WhyModel::Fate, fate);
    m_tree->setColumnWidth(WhyModel::What, std::max(76, room - depth - fate));
}

/// Of the panel's width scroll bars take some, which come and go with what is said.
bool WhyPanel::eventFilter(QObject* object, QEvent* event)
{
    if (object == m_tree->viewport() && event->type() == QEvent::Resize) fitColumns();
    return Panel::eventFilter(object, event);
}

void WhyPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    ask();
}

void WhyPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_model) {
        m_model->setPalette(palette());
        showTheirs(session().now());
    }
    // asked again with the next snapshot, or when it is seen
    if (event->type() == QEvent::LanguageChange && m_triangle) {
        m_asked.reset();
        m_pixelAnswer.reset();
        m_model->clear();
        m_said.clear();
        m_sentence->clear();
        m_detail->clear();
        complain({});
        tell(QString());
    }
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
