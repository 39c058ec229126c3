#include "core/io/text_encoding.h"

#include <algorithm>
#include <cstddef>

namespace zscope {

namespace {

/// So many bytes at the start show how the others lie.
constexpr std::size_t kSample = 256;

enum class Encoding { Utf8, Utf16, Utf32 };

/// From where the zero bytes are. ASCII has one in each two bytes of UTF-16, always the same one, and three in each
/// four of UTF-32. A quarter of the characters is enough, since names and texts may be Chinese, of which some have a
/// zero byte on the other side. No character is all zeros.
Encoding encodingOf(std::string_view bytes)
{
    using namespace std::string_view_literals;
    if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) return Encoding::Utf32;
    if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) return Encoding::Utf16;
    const std::size_t pairs = std::min(bytes.size(), kSample) / 2;
    std::size_t       first = 0, second = 0, both = 0, fours = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        const bool isFirst = bytes[2 * i] == 0, isSecond = bytes[2 * i + 1] == 0;
        first += isFirst && !isSecond;
        second += isSecond && !isFirst;
        both += isFirst && isSecond;
        fours += i % 2 == 1 && (isFirst && isSecond) != (bytes[2 * i - 2] == 0 && bytes[2 * i - 1] == 0);
    }
    if (pairs < 2) return Encoding::Utf8;
    if (both == 0 && std::max(first, second) * 4 >= pairs && std::max(first, second) >= 2 * std::min(first, second))
        return std::max(first, second) >= 2 ? Encoding::Utf16 : Encoding::Utf8;
    return both == pairs / 2 && fours == both && first + second == pairs - both ? Encoding::Utf32 : Encoding::Utf8;
}

}  // namespace

std::optional<std::string> encodingTrouble(std::string_view bytes)
{
    switch (encodingOf(bytes)) {
        case Encoding::Utf8:
            return std::nullopt;
        case Encoding::Utf16:
            return "the text is UTF-16; save it as UTF-8 or plain ASCII";
        case Encoding::Utf32:
            return "the text is UTF-32; save it as UTF-8 or plain ASCII";
    }
    return std::nullopt;
}

}  // namespace zscope
