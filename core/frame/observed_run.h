// A frame drawn by plain text, with one thread over one stripe, for an observer: what a lesson steps through, what
// is counted, explained and audited.
//
// Measured   what chooses by measuring is drawn by its first choice: see repeatable()
// Coherence  a method that takes something over from the frame before has that frame drawn first, unobserved, unless
//            the caller has it
// Promise    a run that is not stopped leaves the very picture that Renderer::draw() makes
#pragma once

#include "core/frame/renderer.h"
#include "core/plain/scratch.h"
#include "core/probe/observer.h"

namespace zscope {

/// What a method with coherence takes over.
enum class FrameBefore {
    Drawn,      // from a frame of the same request, which is drawn for it
    InScratch,  // what the scratch holds
};

/// `frame` and `scratch` stay as the run left them, finished or not. The request must be one that planFrame() accepts.
/// Throws what `observer` throws, and std::bad_alloc.
void drawObserved(const DrawRequest& request, Frame& frame, plain::Scratch& scratch, Observer& observer,
                  FrameBefore before = FrameBefore::Drawn);

/// A method that is in no registry, to be watched in place of the pipeline's. It throws what drawObserved() throws.
struct ObservedMethod {
    void (*draw)(const DrawRequest& request, Frame& frame, plain::Scratch& scratch, Observer& observer);
};
/// The same by `method`, or by the pipeline's if that is nullptr.
inline void drawObserved(const ObservedMethod* method, const DrawRequest& request, Frame& frame,
                         plain::Scratch& scratch, Observer& observer)
{
    method ? method->draw(request, frame, scratch, observer) : drawObserved(request, frame, scratch, observer);
}

/// Every pixel's colour, from the ids as they stand.
void shadePicture(const DrawRequest& request, Frame& frame);

}  // namespace zscope
