#include "app/cli/table.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace zscope::cli {

void Table::row(std::vector<std::string> cells)
{
    assert(cells.size() == m_columns.size());
    m_rows.push_back(std::move(cells));
}

std::string Table::text() const
{
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
        std::size_t width = m_columns[c].title.size();
        for (const auto& row : m_rows) width = std::max(width, row[c].size());
        widths.push_back(width);
    }
    std::string text;
    const auto  line = [&](const auto& cellOf) {
        std::string cells;
        for (std::size_t c = 0; c < m_columns.size(); ++c) {
            if (c > 0) cells += "  ";
            cells += m_columns[c].align == Align::Left ? fmt::format("{:<{}}", cellOf(c), widths[c])
                                                        : fmt::format("{:>{}}", cellOf(c), widths[c]);
        }
        text += cells.substr(0, cells.find_last_not_of(' ') + 1) + '\n';
    };
    line([&](std::size_t c) { return m_columns[c].title; });
    for (const auto& row : m_rows) line([&](std::size_t c) { return row[c]; });
    return text;
}

}  // namespace zscope::cli
