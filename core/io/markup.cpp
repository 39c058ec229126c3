#include "core/io/markup.h"

#include <cstdint>

#include "core/base/quotable.h"

namespace zscope {

std::string markupText(std::string_view text)
{
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const auto             character = firstCharacter(text.substr(at));
        const std::string_view bytes     = text.substr(at, character ? character->bytes : 1);
        at += bytes.size();
        if (!character || isControl(character->code) || character->code == 0xFFFE || character->code == 0xFFFF)
            result += ' ';
        else if (bytes == "&")
            result += "&amp;";
        else if (bytes == "<")
            result += "&lt;";
        else if (bytes == ">")
            result += "&gt;";
        else if (bytes == "\"")
            result += "&quot;";
        else if (bytes == "'")
            result += "&#39;";
        else
            result += bytes;
    }
    return result;
}

std::string base64(std::string_view bytes)
{
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string                letters;
    letters.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::string_view three = bytes.substr(at, 3);
        std::uint32_t          bits  = 0;
        for (std::size_t i = 0; i < 3; ++i)
            bits = bits << 8 | (i < three.size() ? static_cast<unsigned char>(three[i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i) letters += i <= three.size() ? kLetters[bits >> (18 - 6 * i) & 63u] : '=';
    }
    return letters;
}

}  // namespace zscope
