// Why a picture is empty: each triangle counts by the first reason in the order of kReasons that keeps it out, and one
// sentence gives the counts.
//
// Empty      no pixel shows a triangle, and no transparent surface has changed a colour
// Source     the fates of core/measure/definition.h, so the reasons are facts about the picture of docs/correctness.md
// Cost       of a picture that shows something: the look for its first pixel. Of an empty one: instances that lie
//            wholly behind the eye or beside the picture count as a whole, by their boxes; about 0.5 us per triangle of
//            the others
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/frame/renderer.h"

namespace zscope {

/// Of a frame that was shaded.
bool isEmpty(const Frame& frame);

/// Nothing if the frame shows something, or if the request was cancelled. The warning stands at the statement that made
/// everything transparent, where that is the reason.
std::optional<Warning> whyEmpty(const DrawRequest& request, const Frame& frame);

/// The same before anything is drawn, by the definition; a transparent surface in view is taken to be seen unless its
/// opacity is 0. The sentence names `camera` if that is not empty.
std::optional<Warning> whyEmpty(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                const std::string& cameraName = {}, const Progress& progress = {});

}  // namespace zscope
