// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/predict/predictions.h"

#include <algorithm>

#include <QDir>
#include <QSaveFile>

#include "ui/session/session.h"
#include "ui/text/phrase_book.h"
#include "ui/text/utf8_text.h"

namespace zscope::ui {
namespace {

bool isSameMoment(const ShownStep& a, const ShownStep& b)
{
    return a.generation == b.generation && a.state.grain == b.state.grain && a.state.step == b.state.step;
}
bool followsDirectly(const ShownStep& before, const ShownStep& after)
{
    return before.generation == after.generation && before.state.grain == after.state.grain
           && after.state.step.value == before.state.step.value + 1;
}

bool isLater(const ShownStep& before, const ShownStep& after)
{
    return before.generation == after.generation && before.state.grain == after.state.grain
           && after.state.step.value > before.state.step.value;
}

/// A cell of the table. What a spreadsheet would take for a formula is marked as text.
QString cell(QString text)
{
    static const QString kFormula = QStringLiteral("=+-@");
    bool                 isNumber = false;
    text.toDouble(&isNumber);
    if (!isNumber && !text.isEmpty() && kFormula.contains(text.front())) text.prepend('\'');
    if (!text.contains(',') && !text.contains('"') && !text.contains('\n')) return text;
    return '"' + text.replace('"', "\"\"") + '"';
}

QString answerText(const Riddle& riddle, double value)
{
    if (riddle.isNumber()) return QString::number(value, 'g', 8);
    const QStringList choices = choicesOf(riddle);
    const auto        place   = static_cast<qsizetype>(value);
    return place >= 0 && place < choices.size() ? choices[place] : QString();
}

}  // namespace

Predictions::Predictions(Session& session, QObject* parent) : QObject(parent), m_session(session)
{
    // Before any panel hears of a step, which hides what it must not show yet.
    connect(&session, &Session::changed, this, [this](Changes what) {
        if (what & Change::Picture) hear();
    });
}

void Predictions::setOn(Topic topic, bool on)
{
    if (isOn(topic) == on) return;
    m_on[static_cast<std::size_t>(topic)] = on;
    at(topic)                             = {};
    emit changed();
    m_session.presentAgain();
}

void Predictions::hear()
{
    const auto& now = m_session.now().step;
    if (now == m_step) return;
    const auto before = std::exchange(m_step, now);
    if (before && now && isSameMoment(*before, *now)) return;  // only painted anew
    bool asks = false;
    for (const Topic topic : kTopics) {
        const bool isSkipped = at(topic).riddle && before && now && isLater(*before, *now);
        if (isSkipped) keep(topic, *before, {});
        at(topic) = {};
        if (isSkipped) at(topic).last = m_all.size() - 1;
        if (!isOn(topic) || !before || !now || !followsDirectly(*before, *now)) continue;
        if (auto riddle = riddleOf(topic, *before, *now, m_session.now().scene->scene())) {
            at(topic).riddle = std::move(riddle);
            at(topic).before = before;
            asks             = true;
        }
    }
    if (asks) m_session.player().setPlaying(false);
    emit changed();
}

const Riddle* Predictions::open(Topic topic) const { return at(topic).riddle ? &*at(topic).riddle : nullptr; }

bool Predictions::isAnyOpen() const
{
    return std::ranges::any_of(kTopics, [this](Topic topic) { return open(topic) != nullptr; });
}

std::optional<Snapshot> Predictions::before(Topic topic, const Snapshot& now) const
{
    if (!open(topic)) return {};
    Snapshot shown  = now;
    shown.step      = at(topic).before;
    shown.showsStep = true;
    return shown;
}

std::optional<Snapshot> Predictions::before(const Snapshot& now) const
{
    for (const Topic topic : kTopics)
        if (open(topic)) return before(topic, now);
    return {};
}

void Predictions::keep(Topic topic, const ShownStep& step, std::optional<double> given)
{
    const Riddle& riddle = *at(topic).riddle;
    m_all.push_back({.at        = QDateTime::currentDateTime(),
                     .topic     = topic,
                     .scene     = m_session.now().scene->word,
                     .algorithm = QString::fromStdString(step.state.algorithm),
                     .grain     = utf8Text(wordOf(step.state.grain)),
                     .step      = step.state.step.value + 1,
                     .riddle    = riddle,
                     .given     = given,
                     .isRight   = given && riddle.accepts(*given)});
}

void Predictions::answer(Topic topic, double given)
{
    State& state = at(topic);
    if (!state.riddle) return;
    keep(topic, *m_step, given);
    state.riddle.reset();
    state.before.reset();
    state.last = m_all.size() - 1;
    emit changed();
    m_session.presentAgain();
}

const Predicted* Predictions::last(Topic topic) const { return at(topic).last ? &m_all[*at(topic).last] : nullptr; }

int Predictions::rightOf(Topic topic) const
{
    return static_cast<int>(
        std::ranges::count_if(m_all, [topic](const Predicted& one) { return one.topic == topic && one.isRight; }));
}

int Predictions::skippedOf(Topic topic) const
{
    return static_cast<int>(
        std::ranges::count_if(m_all, [topic](const Predicted& one) { return one.topic == topic && !one.given; }));
}

int Predictions::countOf(Topic topic) const
{
    return static_cast<int>(std::ranges::count(m_all, topic, &Predicted::topic));
}

QByteArray Predictions::table() const
{
    QString text =
        QStringLiteral("time,table,scene,algorithm,grain,step,question,answer,right answer,right,skipped\r\n");
    for (const Predicted& one : m_all) {
        const QStringList row{one.at.toString(Qt::ISODate),
                              titleOf(one.topic),
                              one.scene,
                              one.algorithm,
                              one.grain,
                              QString::number(one.step),
                              askText(one.riddle),
                              one.given ? answerText(one.riddle, *one.given) : QString(),
                              answerText(one.riddle, one.riddle.answer),
                              one.isRight ? "1" : "0",
                              one.given ? "0" : "1"};
        for (qsizetype i = 0; i < row.size(); ++i) text += (i > 0 ? QStringLiteral(",") : QString()) + cell(row[i]);
        text += "\r\n";
    }
    return QByteArrayLiteral("\xEF\xBB\xBF") + text.toUtf8();
}

std::optional<QString> Predictions::save(const QString& file) const
{
    QSaveFile out(file);
    if (out.open(QIODevice::WriteOnly) && out.write(table()) >= 0 && out.commit()) return {};
    return tr("%1 cannot be written: %2").arg(QDir::toNativeSeparators(file), said(out.errorString().toStdString()));
}

}  // namespace zscope::ui
