// SPDX-License-Identifier: GPL-3.0-or-later
// Core's words (UTF-8) as the window's.
#pragma once

#include <string_view>

#include <QString>

namespace zscope::ui {

inline QString utf8Text(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

}  // namespace zscope::ui
