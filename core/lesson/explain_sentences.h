// One sentence per event of an explanation, and one for what it came to: live numbers, and the rule by its name.
#pragma once

#include "core/frame/pipeline.h"
#include "core/lesson/explanation.h"

namespace zscope {

/// What happened to the triangle (or face) drawn as `who`.
std::string sentenceOf(const Event& event, TriangleId who, const Pipeline& pipeline, float background);
/// What it came to at the pixel; `isShaded`: colours were asked for, without which nothing is blended.
std::string sentenceOf(const PixelCandidate& candidate, const PixelExplanation& pixel, const Pipeline& pipeline,
                       bool isShaded);
std::string sentenceOf(const PixelExplanation& explanation, const Pipeline& pipeline);
std::string sentenceOf(const TriangleExplanation& explanation, const Pipeline& pipeline);

/// Why an interval was compared pixel by pixel, without a capital and without a stop.
std::string sentenceOf(IntervalReason reason);

/// Values of float32 between two depths of any sign; 0 if they are equal.
std::uint64_t float32StepsBetween(float a, float b);

}  // namespace zscope
