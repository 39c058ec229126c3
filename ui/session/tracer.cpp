// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/tracer.h"

#include <algorithm>
#include <utility>

#include <QFileInfo>

#include "core/check/truth.h"
#include "ui/session/session.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {
namespace {

constexpr int kSubpixelBits = 8;

FaceCulling otherThan(FaceCulling culling)
{
    return culling == FaceCulling::None ? FaceCulling::Back : FaceCulling::None;
}

/// What a new trace is held against where `shown` is the algorithm on show.
Result<Pipeline> pipelineFor(const check::Trace& trace, const Pipeline& shown)
{
    const bool isNamed = trace.algorithm && *trace.algorithm != nameOf(shown);
    if (!isNamed && check::hasTablesOf(trace, shown)) return shown;
    return check::traceAlgorithm(trace, {});
}

}  // namespace

struct Tracer::Question {
    std::uint64_t                      number = 0;
    QString                            file;
    bool                               isNew = true;  // the window is brought to where the two can be stepped
    std::shared_ptr<const LoadedScene> scene;
    DrawRequest                        request;
};

std::optional<std::size_t> TheirTrace::reachedBy(std::uint64_t events) const
{
    const auto after =
        std::ranges::upper_bound(order, events, {}, [this](std::size_t row) { return answer->rows[row].events; });
    if (after == order.begin()) return {};
    return *(after - 1);
}

std::optional<std::size_t> TheirTrace::differenceFrom(std::optional<std::size_t> row, Direction direction) const
{
    const auto count     = static_cast<std::ptrdiff_t>(answer->rows.size());
    const bool isForward = direction == Direction::Forward;
    for (std::ptrdiff_t at = row         ? static_cast<std::ptrdiff_t>(*row) + (isForward ? 1 : -1)
                             : isForward ? 0
                                         : -1;
         at >= 0 && at < count; at += isForward ? 1 : -1)
        if (answer->rows[static_cast<std::size_t>(at)].isWrong()) return static_cast<std::size_t>(at);
    return {};
}

Tracer::Tracer(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_worker(std::make_unique<Worker>())
{
    connect(&session, &Session::changed, this, [this](Changes what) {
        if ((what & Change::Scene) && !m_later.isEmpty()) {
            const QString file = std::exchange(m_later, {});
            if (m_session.now().scene->word == m_laterScene)  // once the scene has its view
                QTimer::singleShot(0, this, [this, file] { ask(file, false); });
        }
        if (what & (Change::Scene | Change::Camera | Change::Pipeline | Change::Picture)) follow();
    });
}

Tracer::~Tracer() = default;

void Tracer::open(const QString& file) { ask(file, true); }

void Tracer::openWith(const QString& file, const QString& sceneWord)
{
    m_later      = file;
    m_laterScene = sceneWord;
}

void Tracer::judgeAgain()
{
    if (m_trace) ask(m_trace->file, false);
}

void Tracer::close()
{
    m_trace.reset();
    m_row.reset();
    m_fieldsOf.reset();
    cancel();
}

void Tracer::cancel()
{
    ++m_number;
    m_isJudging = false;
    m_worker->cancel();
    emit changed();
    askForFields();
}

void Tracer::goBack()
{
    if (!m_trace || !m_session.now().scene) return;
    const auto viewOf = Session::seenBy(m_trace->camera, m_trace->answer->faceCulling);
    m_session.setPipeline(m_trace->pipeline);
    m_session.setFaceCulling(m_trace->answer->faceCulling);
    if (m_session.now().scene->scene().digest != m_trace->scene)
        m_session.open(m_trace->sceneWord, viewOf);
    else if (m_session.now().camera != m_trace->camera)
        m_session.useView(viewOf(m_session.now().scene->scene()));
}

bool Tracer::isOld() const
{
    const Snapshot& now = m_session.now();
    return m_trace
           && (!now.scene || now.scene->scene().digest != m_trace->scene || now.camera != m_trace->camera
               || now.pipeline != m_trace->pipeline
               || m_session.settings().faceCulling != m_trace->answer->faceCulling);
}

// Judging -----------------------------------------------------------------------------------------------------------

void Tracer::ask(const QString& file, bool isNew)
{
    const Snapshot& now = m_session.now();
    if (!now.scene) {
        const auto  say = [] { return tr("Open the scene first that your trace is of."); };
        return emit m_session.failed(say(), say);
    }
    const Question question{++m_number, file, isNew, now.scene, m_session.request()};
    m_isJudging = true;
    emit changed();
    m_worker->post(Worker::Slot::Load, [this, question](const std::atomic<bool>& cancel) {
        const auto mine = [this, number = question.number](auto answer) {
            m_worker->deliver([this, number, answer = std::move(answer)] {
                if (number == m_number) answer();
            });
        };
        const auto fail = [&](const Error& error) {
            mine([this, error] {
                m_isJudging = false;
                emit changed();
                askForFields();  // reading has swept it away
                if (error.kind != Trouble::Cancelled)
                    emit m_session.failed(said(error), [error] { return said(error); });
            });
        };
        auto read = check::readTrace(question.file.toStdString());
        if (!read) return fail(read.error());
        const auto  trace   = std::make_shared<const check::Trace>(*std::move(read));
        DrawRequest request = question.request;
        request.cancel      = &cancel;
        if (question.isNew) {
            const auto pipeline = pipelineFor(*trace, request.pipeline);
            if (!pipeline) return fail(pipeline.error());
            request.pipeline = *pipeline;
        }
        const double halfStep = check::halfStepOf(kSubpixelBits);
        auto         answer   = check::judgeTrace(*trace, request, halfStep);
        if (!answer) return fail(answer.error());
        if (question.isNew && !answer->isRight()) {
            request.faceCulling = otherThan(request.faceCulling);
            auto other          = check::judgeTrace(*trace, request, halfStep);
            if (!other) return fail(other.error());
            if (other->isRight() || *other->firstWrong > *answer->firstWrong) answer = std::move(other);
            request.faceCulling = answer->faceCulling;
        }

        auto theirs       = std::make_shared<TheirTrace>();
        theirs->file      = question.file;
        theirs->title     = QFileInfo(question.file).fileName();
        theirs->trace     = trace;
        theirs->answer    = std::make_shared<const check::TraceAnswer>(std::move(answer).value());
        theirs->scene     = question.scene->scene().digest;
        theirs->sceneWord = question.scene->word;
        theirs->camera    = request.camera;
        theirs->pipeline  = request.pipeline;
        for (std::size_t row = 0; row < theirs->answer->rows.size(); ++row)
            if (theirs->answer->rows[row].grain) theirs->order.push_back(row);
        std::ranges::stable_sort(theirs->order, {}, [&](std::size_t row) { return theirs->answer->rows[row].events; });
        theirs->beside = std::make_shared<check::TraceBeside>(trace, theirs->answer, request, halfStep);
        mine([this, theirs, question] { judged(theirs, question); });
    });
}

void Tracer::judged(const std::shared_ptr<const TheirTrace>& trace, const Question& question)
{
    m_isJudging = false;
    m_trace     = trace;
    m_wanted.reset();
    m_events.reset();
    show({});
    // A user who has opened another scene or view in the meantime keeps it.
    const bool isThere = m_session.now().camera == question.request.camera && m_session.now().scene == question.scene;
    if (question.isNew && isThere) {
        m_session.setPipeline(trace->pipeline);
        m_session.setFaceCulling(trace->answer->faceCulling);
    }
    follow();
    if (!question.isNew) return;
    goToFirstDifference();
    emit opened();
}

// Rows --------------------------------------------------------------------------------------------------------------

void Tracer::follow()
{
    if (!m_trace) return;
    const ShownStep* step = m_session.now().stepOfPicture();
    if (isOld() || !step || step->camera != m_trace->camera || step->pipeline != m_trace->pipeline)
        return emit changed();
    const std::uint64_t events = step->state.events;
    if (m_events == events) return;
    m_events = events;
    const bool isThere =
        m_wanted && m_trace->answer->rows[*m_wanted].grain && m_trace->answer->rows[*m_wanted].events == events;
    show(isThere ? m_wanted : m_trace->reachedBy(events));
}

void Tracer::goToRow(std::size_t row)
{
    if (!m_trace || row >= m_trace->answer->rows.size()) return;
    m_wanted = row;
    show(row);
    const check::JudgedRow& judged = m_trace->answer->rows[row];
    if (judged.grain && !isOld()) m_session.goToStepOf(*judged.grain, judged.step.value);
}

void Tracer::goToNextRow(Direction direction)
{
    if (!m_trace) return;
    if (direction == Direction::Back) {
        if (m_row && *m_row > 0) goToRow(*m_row - 1);
    } else {
        goToRow(m_row ? *m_row + 1 : 0);
    }
}

void Tracer::goToFirstDifference()
{
    if (m_trace && m_trace->answer->firstWrong) goToRow(*m_trace->answer->firstWrong);
}

void Tracer::goToNextDifference(Direction direction)
{
    if (!m_trace) return;
    if (const auto row = m_trace->differenceFrom(m_row, direction)) goToRow(*row);
}

void Tracer::show(std::optional<std::size_t> row)
{
    m_row = row;
    if (!row) m_fieldsOf.reset();
    emit changed();
    askForFields();
}

void Tracer::askForFields()
{
    if (!m_trace || !m_row || m_fieldsOf == m_row) return;
    m_worker->post(Worker::Slot::Step, [this, row = *m_row, of = m_trace](const std::atomic<bool>&) {
        auto fields = of->beside->row(row);
        m_worker->deliver([this, fields = std::move(fields), row, of] {
            if (m_trace != of || m_row != row) return;
            if (!fields) {
                if (fields.error().kind == Trouble::Cancelled) return;
                return emit m_session.failed(said(fields.error()), [error = fields.error()] { return said(error); });
            }
            m_fields   = *fields;
            m_fieldsOf = row;
            emit changed();
        });
    });
}

}  // namespace zscope::ui
