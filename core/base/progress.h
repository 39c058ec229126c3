// How long work tells how far it is, and learns that nobody wants it any more.
//
// Threads    report() is called from the thread that does the work; cancel may be set from any thread
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace zscope {

struct Progress {
    /// fraction in [0, 1]; `what` names the stage in a word or two. May be empty.
    std::function<void(double fraction, std::string_view what)> report = {};
    /// Set to true by the owner to ask the work to stop soon. nullptr: cannot be cancelled.
    const std::atomic<bool>* cancel = nullptr;

    void at(double fraction, std::string_view what) const
    {
        if (report) report(fraction, what);
    }
    bool cancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }
};

}  // namespace zscope
