// SPDX-License-Identifier: GPL-3.0-or-later
// The session's bookmarks and breakpoints, and the searches through a run:
// for the next breakpoint, for what changes a pixel.
#include "ui/session/session.h"

#include <algorithm>

#include "ui/text/numbers.h"

namespace zscope::ui {

std::optional<int> lineOf(const StepState& state)
{
    if (state.pixel) return state.pixel->y;
    if (state.blend) return state.blend->y;
    if (state.sweep && state.sweep->y >= 0) return state.sweep->y;
    return {};
}

std::optional<Breakpoint> breakpointHere(const Snapshot& shown, Breakpoint::On on)
{
    Breakpoint at{.on = on};
    switch (on) {
        case Breakpoint::On::Line: {
            const ShownStep* step = shown.stepOfPicture();
            const auto       line = shown.picked ? std::optional(shown.picked->y())
                                    : step       ? lineOf(step->state)
                                                 : std::nullopt;
            if (!line) return {};
            at.line = *line;
            return at;
        }
        case Breakpoint::On::Pixel:
            if (!shown.picked) return {};
            at.pixel = {shown.picked->x(), shown.picked->y()};
            return at;
        case Breakpoint::On::Node:
            if (!shown.selectedNode) return {};
            at.node = *shown.selectedNode;
            return at;
        case Breakpoint::On::Triangle:
            if (const auto triangle = pickedTriangle(shown)) {
                at.triangle = *triangle;
                return at;
            }
            return {};
    }
    return {};
}

std::optional<Breakpoint> breakpointHere(const Snapshot& shown)
{
    if (shown.selectedTriangle) return breakpointHere(shown, Breakpoint::On::Triangle);
    for (const auto on : {Breakpoint::On::Pixel, Breakpoint::On::Node, Breakpoint::On::Line})
        if (auto at = breakpointHere(shown, on)) return at;
    return {};
}

QString textOf(const Breakpoint& breakpoint)
{
    switch (breakpoint.on) {
        case Breakpoint::On::Line:
            return Session::tr("line %1").arg(grouped(static_cast<std::uint64_t>(breakpoint.line)));
        case Breakpoint::On::Pixel:
            return Session::tr("pixel (%1, %2)").arg(breakpoint.pixel.x).arg(breakpoint.pixel.y);
        case Breakpoint::On::Node: {
            const QString path = QString::fromStdString(breakpoint.node.path);
            return breakpoint.node.instance
                       ? Session::tr("node %1 of instance %2").arg(path, grouped(breakpoint.node.instance->value))
                       : Session::tr("node %1").arg(path);
        }
        case Breakpoint::On::Triangle:
            return Session::tr("triangle %1").arg(grouped(breakpoint.triangle.value));
    }
    return {};
}

// Bookmarks ---------------------------------------------------------------------------------------------------------

void Session::setMarks(const Marks& marks)
{
    m_now.marks = marks;
    emit changed(Change::Marks);
}

void Session::toggleBookmark()
{
    const auto at = position();
    if (!at) return;
    auto&      marks = m_now.marks.bookmarks;
    const auto here  = std::ranges::find_if(marks, [&](const Bookmark& b) {
        return b.pipeline == m_now.pipeline && b.grain == m_now.grain && b.step == at->step;
    });
    if (here != marks.end()) {
        marks.erase(here);
    } else {
        int        number = 1;
        const auto taken  = [&](const QString& name) { return std::ranges::count(marks, name, &Bookmark::name) > 0; };
        while (taken(tr("Bookmark %1").arg(number))) ++number;
        marks.push_back({tr("Bookmark %1").arg(number), m_now.pipeline, m_now.grain, at->step});
    }
    emit changed(Change::Marks);
}

void Session::nameBookmark(std::size_t index, const QString& name)
{
    if (index >= m_now.marks.bookmarks.size() || name.trimmed().isEmpty()) return;
    m_now.marks.bookmarks[index].name = name.trimmed();
    emit changed(Change::Marks);
}

void Session::removeBookmark(std::size_t index)
{
    if (index >= m_now.marks.bookmarks.size()) return;
    m_now.marks.bookmarks.erase(m_now.marks.bookmarks.begin() + static_cast<std::ptrdiff_t>(index));
    emit changed(Change::Marks);
}

void Session::goToBookmark(std::size_t index)
{
    if (index >= m_now.marks.bookmarks.size()) return;
    const Bookmark mark = m_now.marks.bookmarks[index];  // a copy: whoever hears of the change may edit them
    setPipeline(mark.pipeline);
    goToStepOf(mark.grain, mark.step);
}

void Session::goToNextBookmark(Direction direction)
{
    const auto at = position();
    if (!at) return;
    std::optional<std::uint64_t> to;
    for (const Bookmark& mark : m_now.marks.bookmarks) {
        if (mark.pipeline != m_now.pipeline || mark.grain != m_now.grain) continue;
        const bool ahead = direction == Direction::Forward ? mark.step > at->step : mark.step < at->step;
        if (ahead && (!to || (direction == Direction::Forward ? mark.step < *to : mark.step > *to))) to = mark.step;
    }
    if (to)
        goToStep(*to);
    else
        emit noticed(tr("There is no bookmark that way for this algorithm and grain."));
}

// Breakpoints -------------------------------------------------------------------------------------------------------

void Session::toggleBreakpoint(const Breakpoint& breakpoint)
{
    auto&      all  = m_now.marks.breakpoints;
    const auto here = std::ranges::find(all, breakpoint);
    if (here != all.end())
        all.erase(here);
    else
        all.push_back(breakpoint);
    emit changed(Change::Marks);
}

void Session::removeBreakpoint(std::size_t index)
{
    if (index >= m_now.marks.breakpoints.size()) return;
    m_now.marks.breakpoints.erase(m_now.marks.breakpoints.begin() + static_cast<std::ptrdiff_t>(index));
    emit changed(Change::Marks);
}

void Session::runTo(Direction direction)
{
    if (!m_now.scene) return;
    const std::vector<Breakpoint> breakpoints = m_now.marks.breakpoints;
    if (breakpoints.empty())
        return emit noticed(
            tr("There is no breakpoint yet: pick a pixel, or select a node or a triangle, and press F9."));
    std::optional<StepIndex> from;
    if (const auto at = position())
        from = StepIndex{at->step};
    else if (m_wish.isEnd() && direction == Direction::Forward)
        return emit noticed(tr("The run is at its end."));
    search([=, grain = m_now.grain](const DrawRequest& request) -> Result<SearchAnswer> {
        const auto stop = nextStop(request, grain, from, breakpoints, direction);
        if (!stop) return stop.error();
        if (!*stop)
            return SearchAnswer{{},
                                direction == Direction::Forward ? tr("No breakpoint is met from here to the end.")
                                                                : tr("No breakpoint is met from the start to here."),
                                {}};
        return SearchAnswer{(*stop)->step.value,
                            tr("Stopped at the breakpoint on %1").arg(textOf(breakpoints[(*stop)->breakpoint])),
                            {}};
    });
}

void Session::goToPixelChange(PixelJump jump)
{
    if (!m_now.scene) return;
    if (!m_now.picked) return emit noticed(tr("Pick a pixel first: then the steps that change it can be found."));
    const QPoint                 pixel = *m_now.picked;
    std::optional<std::uint64_t> from;
    if (const auto at = position()) from = at->step;
    search([=, grain = m_now.grain, generation = m_generation](const DrawRequest& request) -> Result<SearchAnswer> {
        auto changes = changesOfPixel(request, grain, {pixel.x(), pixel.y()});
        if (!changes) return changes.error();
        auto history =
            std::make_shared<PixelHistory>(PixelHistory{generation, grain, pixel, std::move(changes).value()});
        SearchAnswer answer{{}, {}, history};
        const auto&  all = history->changes;
        if (all.empty()) {
            answer.notice = tr("No step changes pixel (%1, %2): it shows the background from the start.")
                                .arg(pixel.x())
                                .arg(pixel.y());
            return answer;
        }
        switch (jump) {
            case PixelJump::First:
                answer.step = all.front().step.value;
                break;
            case PixelJump::Next:
                for (const PixelChange& change : all)
                    if (!answer.step && from && change.step.value > *from) answer.step = change.step.value;
                break;
            case PixelJump::Previous:
                for (const PixelChange& change : all)
                    if (!from || change.step.value < *from) answer.step = change.step.value;
                break;
        }
        if (!answer.step) {
            answer.notice = tr("No step that way changes pixel (%1, %2).").arg(pixel.x()).arg(pixel.y());
            return answer;
        }
        const auto number = std::ranges::find(all, StepIndex{*answer.step}, &PixelChange::step) - all.begin() + 1;
        answer.notice =
            tr("Change %1 of %2 of pixel (%3, %4)").arg(number).arg(all.size()).arg(pixel.x()).arg(pixel.y());
        return answer;
    });
}

void Session::search(std::function<Result<SearchAnswer>(const DrawRequest&)> find)
{
    if (!m_now.frame || m_now.frame->generation != m_generation) return;  // there is no run to look through yet
    m_player.setPlaying(false);
    setBusy(tr("Searching"));
    m_worker->post(Worker::Slot::Search, [this, find = std::move(find), request = request(), generation = m_generation,
                                          grain = m_now.grain](const std::atomic<bool>& cancel) mutable {
        request.cancel = &cancel;
        auto found     = find(request);
        deliver([this, found = std::move(found), generation, grain] {
            if (generation != m_generation || grain != m_now.grain) return;
            if (!found) return troubled(found.error());
            if (found->history) {
                m_now.marks.history = found->history;
                emit changed(Change::Marks);
            }
            emit noticed(found->notice);
            if (found->step) return goToStep(*found->step);
            repaint();  // the search has swept away what was waiting
            if (m_now.compare.other && m_now.showsStep) stepOther();
            compareTheirs();
        });
    });
}

}  // namespace zscope::ui
