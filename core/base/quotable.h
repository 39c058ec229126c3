// Text of a file, fit for a message: what a terminal would obey is not handed on to it, and what cannot be seen is
// named.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/utf8.h"

namespace zscope {

/// A character by its code: "U+00A0".
inline std::string codeOf(char32_t code)
{
    char text[16];
    std::snprintf(text, sizeof text, "U+%04X", static_cast<unsigned>(code));
    return text;
}

/// Whether a terminal obeys the character: control characters but for the tab.
inline bool isControl(char32_t code) { return (code < 0x20 && code != '\t') || (code >= 0x7F && code < 0xA0); }

/// Whether the character shows as nothing, or as a blank that is none: no-break and zero-width spaces, marks of
/// direction, the byte order mark.
inline bool isInvisible(char32_t code)
{
    constexpr std::pair<char32_t, char32_t> kRanges[] = {
        {0xA0, 0xA0},     {0xAD, 0xAD},     {0x34F, 0x34F},   {0x61C, 0x61C},   {0x115F, 0x1160},  {0x1680, 0x1680},
        {0x17B4, 0x17B5}, {0x180B, 0x180E}, {0x2000, 0x200F}, {0x2028, 0x202F}, {0x205F, 0x206F},  {0x3000, 0x3000},
        {0x3164, 0x3164}, {0xFEFF, 0xFEFF}, {0xFFA0, 0xFFA0}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F}};
    return std::ranges::any_of(kRanges,
                               [code](const auto& range) { return code >= range.first && code <= range.second; });
}

/// The text with control characters written as "<U+0001>", so that two different texts stay different.
inline std::string printable(std::string_view text)
{
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        const auto        character = firstCharacter(text.substr(at));
        const std::size_t bytes     = character ? character->bytes : 1;
        if (character && isControl(character->code))
            shown += '<' + codeOf(character->code) + '>';
        else
            shown += text.substr(at, bytes);
        at += bytes;
    }
    return shown;
}

/// The text with control characters, tabs and invisible characters written as "<U+00A0>" and bytes that are no UTF-8 as
/// "<0xA0>", shortened to so many bytes of it, at a whole character.
inline std::string quotable(std::string_view text, std::size_t longest = 40)
{
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        const auto        character = firstCharacter(text.substr(at));
        const std::size_t bytes     = character ? character->bytes : 1;
        if (at + bytes > longest) return shown + "...";
        char hex[8];
        if (!character) {
            std::snprintf(hex, sizeof hex, "<0x%02X>", static_cast<unsigned>(static_cast<unsigned char>(text[at])));
            shown += hex;
        } else if (character->code == '\t' || isControl(character->code) || isInvisible(character->code)) {
            shown += '<' + codeOf(character->code) + '>';
        } else {
            shown += text.substr(at, bytes);
        }
        at += bytes;
    }
    return shown;
}

}  // namespace zscope
