// UTF-8, one character at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace zscope {

struct Utf8Character {
    char32_t    code  = 0;
    std::size_t bytes = 1;
};

/// The character at the start of `text`, which is not empty; nothing if its bytes are no UTF-8 (RFC 3629: the shortest
/// form, no surrogates, at most U+10FFFF).
inline std::optional<Utf8Character> firstCharacter(std::string_view text)
{
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto lead = byte(0);
    if (lead < 0x80) return Utf8Character{lead, 1};
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return std::nullopt;
    char32_t code = lead & (0xFFu >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return std::nullopt;
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    constexpr char32_t kLeast[] = {0x80, 0x800, 0x10000};
    if (code < kLeast[bytes - 2] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return std::nullopt;
    return Utf8Character{code, bytes};
}

inline bool isUtf8(std::string_view text)
{
    while (!text.empty()) {
        const auto character = firstCharacter(text);
        if (!character) return false;
        text.remove_prefix(character->bytes);
    }
    return true;
}

}  // namespace zscope
