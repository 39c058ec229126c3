// Reads a lesson from its file: sections that begin with a line "=== WORD", some of them JSON and some Markdown.
//
// Form       === lesson     JSON: the title
//            === page       JSON: scene, view, algorithm, stop, ...; begins a page
//            === en, zh     Markdown: the page's text
//            === question   JSON: the page's question
//            What stands before the first section is a remark. Every key is described in docs/lessons.md
// Text       UTF-8, a byte order mark at its start aside
// Inherited  scene, size, algorithm with its choices, and fault stay as on the page before; the view, too, if the scene
//            does
// Promise    every error is one sentence with file and line; nothing is guessed, an unknown key is an error
#pragma once

#include <cstdint>
#include <string>

#include "core/lesson/lesson.h"

namespace zscope {

inline constexpr std::uint64_t kMaxLessonBytes = 1 << 20;

/// `file` is named in errors and kept in the lesson; scenes given by a relative path are looked for beside it.
Result<Lesson> parseLesson(const std::string& text, const std::string& file);
/// The same from a regular file of at most kMaxLessonBytes.
Result<Lesson> readLesson(const std::string& file);

}  // namespace zscope
