// Text as it may stand in HTML and XML, between tags and between quotes: whatever a file is called, it stays text.
//
// Control    characters that XML does not have become blanks; so do bytes that are no UTF-8
#pragma once

#include <string>
#include <string_view>

namespace zscope {

std::string markupText(std::string_view text);

/// Bytes as letters, for data: addresses. RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace zscope
