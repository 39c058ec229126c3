// Names of materials, groups and objects, as OBJ and MTL files write them: to the end of the line, blanks inside
// included. A '#' belongs to the name ("Gloss Grey #1"). Where it could begin a comment as well ("red # as a brick"),
// the reading that names something known is taken.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace zscope::obj {

/// A longer name is cut to this length, and a number computed from all of its bytes tells it from others.
inline constexpr std::size_t kMaxNameBytes = 1024;

/// A name as it is kept: no blanks at its ends, control characters as "<U+0001>", at most kMaxNameBytes. Names that
/// differ stay different.
std::string printableName(std::string_view text);

/// What is said where the name after `word` goes on in the next line.
std::string joinedNameSentence(std::string_view word);

struct NameReading {
    std::string_view name;
    bool             isWhole   = true;
    bool             isComment = false;  // a blank follows the '#', so that what is left out reads as a comment
};

/// The name as a whole, and then cut before each '#' that follows a blank, the longest first. Of many, the shortest
/// few. Views into `name`.
std::vector<NameReading> readingsOf(std::string_view name);

}  // namespace zscope::obj
