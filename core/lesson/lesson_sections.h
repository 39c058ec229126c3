// A lesson file is cut into sections by lines that begin with "=== ": `=== page`, `=== text en`, and so on. What stands
// before the first such line belongs to no section.
#pragma once

#include <string_view>
#include <vector>

namespace zscope {

struct LessonSection {
    std::string_view word, body;
    int              line = 0;  // of the word; the body begins on the next
};

/// Without the blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

/// Views into `text`, which must outlive them.
std::vector<LessonSection> sectionsOf(std::string_view text);

}  // namespace zscope
