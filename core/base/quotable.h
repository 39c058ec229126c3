// Text of a file, fit for a message: what a terminal would obey is not handed on to it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace zscope {

/// Control bytes, the ends of lines among them, as "?".
inline std::string printable(std::string_view text)
{
    std::string shown(text);
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return shown;
}

/// The same, shortened to so many bytes at a whole UTF-8 character.
inline std::string quotable(std::string_view text, std::size_t longest = 40)
{
    std::string quoted = printable(text.substr(0, longest));
    if (text.size() <= longest) return quoted;
    while (!quoted.empty() && (static_cast<unsigned char>(quoted.back()) & 0xC0) == 0x80) quoted.pop_back();
    if (!quoted.empty() && static_cast<unsigned char>(quoted.back()) >= 0xC0) quoted.pop_back();
    return quoted + "...";
}

}  // namespace zscope
