// A line of our own text, for steps that show which statement made them.
//
// Use        as the last parameter of a function, SourceLine line = SourceLine::here(): the line of the call
// Why        std::source_location, whose purpose this is, is missing where clang 14 compiles
#pragma once

#include <string_view>

namespace zscope {

struct SourceLine {
    const char* file     = "";  // as the compiler was given it
    int         line     = 0;   // from 1; 0: of nothing
    const char* function = "";  // its name alone

    static constexpr SourceLine here(const char* file = __builtin_FILE(), int line = __builtin_LINE(),
                                     const char* function = __builtin_FUNCTION())
    {
        return {file, line, function};
    }

    /// From the root of the project: "core/method/zbuffer.cpp".
    std::string_view fileFromRoot() const
    {
        const std::string_view whole = file;
        const std::size_t      core  = whole.rfind("core/");
        return core == std::string_view::npos ? whole : whole.substr(core);
    }
};

}  // namespace zscope
