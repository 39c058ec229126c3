// What every part is handed, in one piece; and how a part reports what it does.
//
// Borrows    everything: the stripe and its rules belong to the frame, the memory to the thread
// Lines      a method's call of a part passes a Call, made from the Work by the call itself, so that Work knows the
//            method's line; tell() adds the line of the part's statement
#pragma once

#include "core/base/stage_clock.h"
#include "core/base/tally.h"
#include "core/geometry/rules.h"
#include "core/plain/scratch.h"
#include "core/plain/stripe.h"
#include "core/probe/observer.h"
#include "core/probe/source_line.h"

namespace zscope::plain {

struct Work {
    const Stripe&      stripe;
    const ChosenRules& rules;
    Scratch&           scratch;
    StageClock&        clock;
    Tally&             tally;
    Observer*          observer = nullptr;  // nullptr: the run is not observed

    SourceLine call = SourceLine::here();  // of the part at work, in the method

    template <class Event>
    void tell(const Event& event, SourceLine part = SourceLine::here()) const
    {
        if (observer) observer->hear({kEventKind<Event>, &event, call, part});
    }
    bool isCancelled() const { return stripe.progress.cancelled(); }
    bool leavesOut(Checkpoint at) const { return observer && observer->leavesOut(at); }
};

/// A method's call of a part.
class Call {
public:
    Call(Work& work, SourceLine line = SourceLine::here()) : m_work(work) { work.call = line; }
    Work* operator->() const { return &m_work; }
    Work& operator*() const { return m_work; }

private:
    Work& m_work;
};

}  // namespace zscope::plain
