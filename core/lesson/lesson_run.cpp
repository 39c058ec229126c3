#include "core/lesson/lesson_run.h"

#include <algorithm>
#include <cmath>
#include <new>

#include <fmt/format.h>

#include "core/frame/frame_plan.h"
#include "core/frame/observed_run.h"
#include "core/lesson/lesson_facts.h"
#include "core/probe/recorders.h"

namespace zscope {

namespace {

template <class Wanted>
bool holds(const std::optional<Wanted>& wanted, const std::optional<Wanted>& said)
{
    return !wanted || said == wanted;
}
template <class Wanted>
bool holdsInWords(const std::optional<Wanted>& wanted, std::string_view said)
{
    return !wanted || said == wordOf(*wanted);
}

bool holds(const LessonStop& stop, const About& about)
{
    const bool pixel = !stop.pixel
                       || (about.pixels && about.pixels->x0 <= stop.pixel->x && stop.pixel->x < about.pixels->x1
                           && about.pixels->y0 <= stop.pixel->y && stop.pixel->y < about.pixels->y1);
    return pixel && holds(stop.line, about.line) && holds(stop.triangle, about.triangle)
           && (!stop.node || (about.node && nameOf(*about.node) == *stop.node)) && holds(stop.stage, about.stage)
           && holdsInWords(stop.verdict, about.verdict) && holds(stop.hidden, about.hidden)
           && holds(stop.update, about.level) && holdsInWords(stop.interval, about.interval)
           && holds(stop.won, about.won);
}

/// Ends the run at the event that the stop means.
class StopRecorder {
public:
    explicit StopRecorder(const LessonStop& stop) : m_stop(stop) {}

    void hear(const Heard& heard)
    {
        if (!heard.isStepOf(m_stop.grain)) return;
        const StepIndex now{m_seen++};
        if (!holds(m_stop, heard.about()) || ++m_met < m_stop.nth) return;
        m_found = now;
        throw RunStopped{};
    }
    std::optional<StepIndex> found() const { return m_found; }
    std::uint64_t            met() const { return m_met; }

private:
    const LessonStop&        m_stop;
    std::uint64_t            m_seen = 0, m_met = 0;
    std::optional<StepIndex> m_found;
};

Error wrong(const std::string& file, int line, std::string sentence)
{
    return {Trouble::Input, std::move(sentence), file, line};
}
/// An error of the renderer, said of a place in the lesson.
Error at(const std::string& file, int line, const Error& error)
{
    return error.kind == Trouble::Cancelled ? error : Error{error.kind, error.sentence, file, line};
}

/// Where the question looks.
Result<StepState> stateOf(const LessonQuestion& question, Replay& replay, Grain grain, StepIndex stop)
{
    if (question.at == LessonQuestion::At::Stop) return replay.at(grain, stop);
    const auto count = replay.count(grain);
    if (!count) return count.error();
    if (question.at == LessonQuestion::At::End) return replay.at(grain, {*count - 1});
    if (stop.value + 1 >= *count) return Error{Trouble::Input, "there is no next step: the page stops at the last one"};
    return replay.at(grain, {stop.value + 1});
}

std::optional<Error> choose(const LessonQuestion& question, const std::optional<FactValue>& value,
                            const std::string& file, LessonAnswer& answer)
{
    for (std::size_t i = 0; i < question.choices.size(); ++i) {
        const LessonChoice& choice = question.choices[i];
        if (value ? !choice.when->holds(*value) : !choice.isRight) continue;
        if (answer.choice)
            return wrong(file, question.fileLine,
                         fmt::format("two choices of this question are right: {} and {}", *answer.choice + 1, i + 1));
        answer.choice = i;
    }
    if (answer.choice) return std::nullopt;
    const std::string found = std::holds_alternative<std::string>(*value) ? std::get<std::string>(*value)
                                                                          : fmt::format("{}", std::get<double>(*value));
    return wrong(file, question.fileLine,
                 fmt::format("no choice of this question is right: the renderer's '{}' is {}", question.fact, found));
}

Result<LessonAnswer> answerOf(const LessonPage& page, const std::string& file, Replay& replay, StepIndex stop)
{
    const LessonQuestion&    question = *page.question;
    LessonAnswer             answer{.tolerance = question.tolerance};
    std::optional<FactValue> value;
    if (!question.fact.empty()) {
        const auto state = stateOf(question, replay, page.stop.grain, stop);
        if (!state) return at(file, question.fileLine, state.error());
        const FactSource source{*state, replay.request(), page.pick};
        if (question.kind == LessonQuestion::Kind::Pixel) {
            const auto values = pixelFactOf(question.fact, source);
            if (!values) return at(file, question.fileLine, values.error());
            answer.pixels     = Grid<std::uint8_t>(values->width(), values->height(), 0);
            std::size_t right = 0;
            for (int y = 0; y < values->height(); ++y)
                for (int x = 0; x < values->width(); ++x)
                    right += answer.pixels.at(x, y) = question.accepted->holds(values->at(x, y));
            if (right == 0) return wrong(file, question.fileLine, "no pixel of the picture is a right answer");
            if (2 * right > static_cast<std::size_t>(values->width()) * static_cast<std::size_t>(values->height()))
                return wrong(file, question.fileLine,
                             "more than half of all pixels are right answers: nobody needs to know anything");
            return answer;
        }
        const auto read = factOf(question.fact, source);
        if (!read) return at(file, question.fileLine, read.error());
        value = *read;
    }
    if (question.kind == LessonQuestion::Kind::Choice) {
        if (auto error = choose(question, value, file, answer)) return *error;
        return answer;
    }
    if (value && !std::holds_alternative<double>(*value))
        return wrong(file, question.fileLine,
                     fmt::format("'{}' is a word, not a number: ask for it by choices", question.fact));
    answer.number = value ? std::get<double>(*value) : *question.answer;
    if (question.answer && !answer.accepts(*question.answer))
        return wrong(file, question.fileLine,
                     fmt::format("the file says {}, but the renderer's '{}' is {}", *question.answer, question.fact,
                                 *answer.number));
    return answer;
}

}  // namespace

bool LessonAnswer::accepts(double value) const { return number && std::abs(value - *number) <= tolerance; }

bool LessonAnswer::acceptsPixel(PixelPosition pixel) const
{
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < pixels.width() && pixel.y < pixels.height()
           && pixels.at(pixel.x, pixel.y) != 0;
}

ViewRequest viewOfPage(const LessonPage& page, const Scene& scene)
{
    if (page.hasView || scene.views.empty()) return page.view;
    ViewRequest view = scene.views.front().view;
    view.width       = page.view.width;
    view.height      = page.view.height;
    if (view.exact) view.exact->width = view.width, view.exact->height = view.height;
    return view;
}

Result<StepIndex> stepOf(const LessonStop& stop, const std::string& file, const DrawRequest& asked)
try {
    const DrawRequest request = repeatable(asked);
    if (stop.isEnd() || stop.step) {
        Replay     replay(request);
        const auto count = replay.count(stop.grain);
        if (!count) return at(file, stop.fileLine, count.error());
        if (!stop.step) return StepIndex{*count - 1};
        if (*stop.step < *count) return StepIndex{*stop.step};
        return wrong(file, stop.fileLine,
                     fmt::format("there is no step {}: the last of grain '{}' is {}", *stop.step, wordOf(stop.grain),
                                 *count - 1));
    }
    if (const auto plan = planFrame(request); !plan) return at(file, stop.fileLine, plan.error());
    Frame          frame;
    plain::Scratch scratch;
    StopRecorder   recorder(stop);
    try {
        Listening listening(recorder);
        drawObserved(request, frame, scratch, listening);
    } catch (const RunStopped&) {}
    if (request.cancel && request.cancel->load()) return Error{Trouble::Cancelled, "the lesson was cancelled"};
    if (recorder.found()) return *recorder.found();
    return wrong(file, stop.fileLine,
                 recorder.met() == 0
                     ? std::string("the run never comes to this stop")
                     : fmt::format("the run comes to this stop {} times, not {}", recorder.met(), stop.nth));
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "there is not enough memory to run this frame"};
}

Result<PageRun> runPage(const LessonPage& page, const std::string& file, const DrawRequest& request)
{
    const auto step = stepOf(page.stop, file, request);
    if (!step) return step.error();
    PageRun run{.grain = page.stop.grain, .step = *step};
    if (!page.question) return run;
    Replay replay(request);
    auto   answer = answerOf(page, file, replay, *step);
    if (!answer) return answer.error();
    run.answer = *std::move(answer);
    return run;
}

}  // namespace zscope
