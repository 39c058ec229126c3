#include "core/lesson/lesson_sections.h"

#include <algorithm>

namespace zscope {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r\n";
    const auto                 first  = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<LessonSection> sectionsOf(std::string_view text)
{
    std::vector<LessonSection> sections;
    int                        line = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t      end = std::min(text.find('\n', at), text.size());
        const std::string_view one = text.substr(at, end - at);
        ++line;
        at = std::min(end + 1, text.size());
        if (one.starts_with("=== "))
            sections.push_back({trimmed(one.substr(4)), text.substr(at, 0), line});
        else if (!sections.empty())
            sections.back().body = {sections.back().body.data(), text.data() + at};
    }
    return sections;
}

}  // namespace zscope
