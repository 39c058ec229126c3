// How the bytes of a text file spell its characters. Everything that is read as text is UTF-8, or at least ASCII with
// bytes of another code page in its names.
//
// Mark       a byte order mark of UTF-8 at the start of a file is passed over
// Refused    UTF-16 and UTF-32, with a mark or where zero bytes lie as they do there, with the same sentence in every
//            kind of file
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace zscope {

inline constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// What keeps the bytes from being read as text, as a sentence; nothing if they may be.
std::optional<std::string> encodingTrouble(std::string_view bytes);

/// The text after a byte order mark, or all of it.
inline std::string_view withoutMark(std::string_view bytes)
{
    return bytes.starts_with(kUtf8Mark) ? bytes.substr(kUtf8Mark.size()) : bytes;
}

}  // namespace zscope
