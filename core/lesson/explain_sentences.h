// What the events of an explanation came to, in one sentence: live numbers, and the rule by its name. The events bring
// their own sentences, but for the set-up of a triangle.
#pragma once

#include "core/frame/pipeline.h"
#include "core/geometry/geometry_events.h"
#include "core/lesson/explanation.h"

namespace zscope {

inline constexpr std::string_view kSetUpWord = "set-up";
std::string_view                  wordOf(SetUp setUp);  // "drawn"

/// What set-up made of a triangle that is drawn as `polygon`: "triangle 12". `isMirrored`: its instance is.
std::string sentenceOf(const TriangleSetUp& setUp, const std::string& polygon, bool isMirrored);
/// What it came to at the pixel; `isShaded`: colours were asked for, without which nothing is blended.
std::string sentenceOf(const PixelCandidate& candidate, const PixelExplanation& pixel, const Pipeline& pipeline,
                       bool isShaded);
std::string sentenceOf(const PixelExplanation& explanation, const Pipeline& pipeline);
std::string sentenceOf(const TriangleExplanation& explanation, const Pipeline& pipeline);

}  // namespace zscope
