#include "core/scene/obj/names.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "core/base/quotable.h"
#include "core/scene/obj/line_reader.h"

namespace zscope::obj {

namespace {

constexpr std::size_t kMostCuts = 7;

/// FNV-1a.
std::uint64_t numberOf(std::string_view text)
{
    std::uint64_t number = 0xCBF29CE484222325u;
    for (const char c : text) number = (number ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return number;
}

}  // namespace

std::string printableName(std::string_view text)
{
    const std::string_view written = withoutBlanks(text);
    std::string            name    = printable(written);
    if (name.size() <= kMaxNameBytes) return name;
    const std::string mark = fmt::format("...{:016x}", numberOf(written));
    std::size_t       end  = kMaxNameBytes - mark.size();
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;  // at a whole character
    return name.substr(0, end) + mark;
}

std::string joinedNameSentence(std::string_view word)
{
    return fmt::format("{}: the backslash at the end of the line joins the next line to the name", word);
}

std::vector<NameReading> readingsOf(std::string_view name)
{
    std::vector<NameReading> cuts;
    for (std::size_t at = name.find('#'); at != std::string_view::npos && cuts.size() < kMostCuts;
         at             = name.find('#', at + 1)) {
        if (at == 0 || !isBlank(name[at - 1])) continue;
        const std::string_view shorter = withoutBlanks(name.substr(0, at));
        if (!shorter.empty()) cuts.push_back({shorter, false, at + 1 == name.size() || isBlank(name[at + 1])});
    }
    cuts.push_back({name});
    std::ranges::reverse(cuts);
    return cuts;
}

}  // namespace zscope::obj
