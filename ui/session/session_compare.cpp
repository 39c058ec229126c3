// SPDX-License-Identifier: GPL-3.0-or-later
// The session's second half of a comparison: B is drawn and stepped after A, and held against it.
#include "ui/session/session.h"

#include <algorithm>

#include "ui/session/linking.h"

namespace zscope::ui {

void Session::compareWith(const std::optional<Pipeline>& other)
{
    if (other == m_now.compare.other && !m_now.compare.theirs) return;
    m_now.compare.other  = other;
    m_now.compare.theirs = nullptr;
    m_now.compare.frame  = nullptr;
    m_now.compare.step   = nullptr;
    m_now.compare.result = nullptr;
    if (!other) m_now.compare.show = CompareShow::A, m_now.compare.isHeld = false;
    emit changed(Change::Compare | Change::Picture);
    otherChanged();
}

void Session::compareWithTheirs(const std::shared_ptr<const TheirPicture>& theirs)
{
    CompareState& compare = m_now.compare;
    compare.other.reset();
    compare.frame  = nullptr;
    compare.step   = nullptr;
    compare.result = nullptr;
    compare.theirs = theirs;
    emit changed(Change::Compare | Change::Picture);
    compareTheirs();
    repaint();
}

void Session::compareTheirs()
{
    CompareState& compare = m_now.compare;
    if (!compare.theirs || !m_now.frame || m_now.frame->generation != m_generation) return;
    if (isStale(m_now)) {
        if (!compare.result) return;
        compare.result = nullptr;
        return emit changed(Change::Compare | Change::Picture);
    }
    if (compare.result && compare.result->a == m_now.frame && compare.result->theirs == compare.theirs) return;
    m_worker->post(Worker::Slot::StepOther, [this, a = m_now.frame, theirs = compare.theirs](const std::atomic<bool>&) {
        auto result = compared(a, theirs);
        deliver([this, result = std::move(result), a, theirs] {
            if (m_now.compare.theirs == theirs && m_now.frame == a) {
                m_now.compare.result = result;
                emit changed(Change::Compare | Change::Picture);
            }
            repaint();  // posting this has swept it away
        });
    });
}

void Session::otherChanged()
{
    // after the drawing
    if (!m_now.compare.other || !m_now.scene || !m_now.frame || m_now.frame->generation != m_generation) return;
    drawOther();
    if (!isSettled() && !m_rest.isActive())
        step();  // posting the drawing has swept it away
    else if (m_now.showsStep)
        stepOther();
}

void Session::drawOther()
{
    setBusy(tr("Drawing B"));
    DrawRequest other = request();
    other.pipeline    = *m_now.compare.other;
    m_worker->post(Worker::Slot::DrawOther,
                   [this, other, generation = m_generation, look = m_now.look, a = m_now.frame,
                    tolerance = m_now.compare.tolerance](const std::atomic<bool>& cancel) mutable {
                       other.cancel                            = &cancel;
                       auto                              drawn = m_otherEngine->draw(generation, other, look);
                       std::shared_ptr<const Comparison> result;
                       if (drawn) result = compared(a, *drawn, tolerance);
                       deliver([this, drawn = std::move(drawn), result, pipeline = other.pipeline] {
                           if (!drawn) return troubled(drawn.error());
                           if (m_now.compare.other != pipeline) return;  // another B by now
                           m_now.compare.frame = *drawn;
                           if (!m_now.showsStep || !m_now.compare.isLinked) m_now.compare.result = result;
                           emit changed(Change::Compare | Change::Picture);
                           if (result->tolerance != m_now.compare.tolerance) compareAgain();
                       });
                   });
}

void Session::stepOther()
{
    if (!m_now.compare.isLinked || !m_now.showsStep) return compareAgain();
    setBusy(tr("Replaying B"));
    DrawRequest other = request();
    other.pipeline    = *m_now.compare.other;
    m_worker->post(
        Worker::Slot::StepOther,
        [this, other, generation = m_generation, look = m_now.look, a = m_now.step, link = m_now.compare.link,
         picked = m_now.picked, tolerance = m_now.compare.tolerance](const std::atomic<bool>& cancel) mutable {
            other.cancel      = &cancel;
            const auto linked = linkedTo(*a, link, picked, other);
            if (!linked) return deliver([this, error = linked.error()] { troubled(error); });
            auto                              made = m_otherEngine->step(generation, other, look, linked->wish);
            std::shared_ptr<const Comparison> result;
            if (made) result = compared(a, *made, tolerance);
            deliver([this, made = std::move(made), result, pipeline = other.pipeline, note = linked->note] {
                if (!made) return troubled(made.error());
                if (m_now.compare.other != pipeline) return;
                m_now.compare.step     = *made;
                m_now.compare.linkNote = note;
                m_now.compare.result   = result;
                emit changed(Change::Compare | Change::Picture);
            });
        });
}

void Session::compareAgain()
{
    const CompareState& compare = m_now.compare;
    const bool          steps   = m_now.showsStep && compare.isLinked;
    if (!compare.other || (steps ? !compare.step || !m_now.step : !compare.frame || !m_now.frame)) return;
    if (!steps && compare.frame->generation != m_now.frame->generation) return;
    if (compare.result && compare.result->tolerance == compare.tolerance
        && (steps ? compare.result->stepA == m_now.step : compare.result->a == m_now.frame))
        return;
    m_worker->post(Worker::Slot::StepOther,
                   [this, steps, a = m_now.frame, b = compare.frame, stepA = m_now.step, stepB = compare.step,
                    tolerance = compare.tolerance](const std::atomic<bool>&) {
                       auto result = steps ? compared(stepA, stepB, tolerance) : compared(a, b, tolerance);
                       deliver([this, result = std::move(result), b, stepB, steps] {
                           if (steps ? m_now.compare.step != stepB : m_now.compare.frame != b) return;
                           m_now.compare.result = result;
                           emit changed(Change::Compare | Change::Picture);
                       });
                   });
}

void Session::swapCompared()
{
    if (!m_now.compare.other) return;
    const Pipeline b = *m_now.compare.other;
    compareWith(m_now.pipeline);
    setPipeline(b);
}

void Session::showCompared(CompareShow show)
{
    if (!m_now.compare.isOn() || show == m_now.compare.show) return;
    m_now.compare.show = show;
    emit changed(Change::Compare | Change::Picture);
}

void Session::holdOther(bool held)
{
    if (held == m_now.compare.isHeld || (held && !m_now.compare.isOn())) return;
    m_now.compare.isHeld = held;
    emit changed(Change::Compare | Change::Picture);
}

void Session::setWipe(double part)
{
    m_now.compare.wipe = std::clamp(part, 0.0, 1.0);
    emit changed(Change::Compare);
}

void Session::setTolerance(std::uint32_t steps)
{
    if (steps == m_now.compare.tolerance) return;
    m_now.compare.tolerance = steps;
    emit changed(Change::Compare);
    compareAgain();
}

void Session::linkBy(Link link)
{
    if (link == m_now.compare.link) return;
    m_now.compare.link = link;
    emit changed(Change::Compare);
    if (m_now.compare.isLinked && m_now.showsStep && m_now.compare.other) stepOther();
}

void Session::linkSteps(bool linked)
{
    if (linked == m_now.compare.isLinked) return;
    m_now.compare.isLinked = linked;
    emit changed(Change::Compare | Change::Picture);
    if (linked && m_now.showsStep && m_now.compare.other)
        stepOther();
    else
        compareAgain();
}

}  // namespace zscope::ui
