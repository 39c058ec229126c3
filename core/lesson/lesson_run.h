// Brings a page of a lesson to its step, and finds out what the right answer is there.
//
// Promise    the answer to a question about a fact is what the renderer's state says; a question without a right
//            answer, or with two, is an error of the lesson with file and line
// Cost       some serial runs of the frame: lessons have small pictures
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/lesson/lesson.h"
#include "core/lesson/replay.h"

namespace zscope {

/// What is right, read from the state.
struct LessonAnswer {
    std::optional<double>      number    = {};  // of a number
    double                     tolerance = 0;
    std::optional<std::size_t> choice    = {};  // of a choice: which of them
    Grid<std::uint8_t>         pixels    = {};  // of a pixel: 1 where an answer is right

    bool accepts(double value) const;
    bool acceptsPixel(PixelPosition pixel) const;
};

struct PageRun {
    Grain                       grain = Grain::Frame;
    StepIndex                   step;
    std::optional<LessonAnswer> answer = {};  // if the page has a question
};

/// The view of the page in its scene.
ViewRequest viewOfPage(const LessonPage& page, const Scene& scene);
/// `request` draws the page's scene with its view and its pipeline. `file` is named in errors.
Result<PageRun> runPage(const LessonPage& page, const std::string& file, const DrawRequest& request);
/// The step that the stop means. Errors: Input, that the run never comes to it.
Result<StepIndex> stepOf(const LessonStop& stop, const std::string& file, const DrawRequest& request);

}  // namespace zscope
