#include "app/cli/table.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstdlib>
#include <numeric>
#include <string_view>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace zscope::cli {
namespace {

constexpr std::string_view kGap = "  ";  // between columns

/// The pieces that a line may be broken between, each with the space, comma or ampersand that ends it.
std::vector<std::string_view> partsOf(std::string_view text)
{
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(" ,&"), text.size() - 1) + 1;
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return parts;
}

std::string_view withoutSpace(std::string_view part) { return part.substr(0, part.find_last_not_of(' ') + 1); }

std::vector<std::string> wrapped(std::string_view text, std::size_t width)
{
    if (text.size() <= width) return {std::string(text)};
    std::vector<std::string> lines(1);
    for (const std::string_view part : partsOf(text)) {
        if (!lines.back().empty() && lines.back().size() + withoutSpace(part).size() > width) lines.emplace_back();
        lines.back() += part;
    }
    for (std::string& line : lines) line = withoutSpace(line);
    return lines;
}

}  // namespace

void Table::row(std::vector<std::string> cells)
{
    assert(cells.size() == m_columns.size());
    m_rows.push_back(std::move(cells));
}

/// The largest width that every cell of words may have for the table to be `width` wide, column by column.
std::vector<std::size_t> Table::widthsWithin(std::size_t width) const
{
    std::vector<std::size_t> natural, least;
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
        natural.push_back(m_columns[c].title.size());
        least.push_back(m_columns[c].title.size());
        for (const auto& row : m_rows) {
            natural[c] = std::max(natural[c], row[c].size());
            for (const std::string_view part : partsOf(row[c]))
                least[c] = std::max(least[c], withoutSpace(part).size());
        }
        if (m_columns[c].align == Align::Right) least[c] = natural[c];
    }
    const std::size_t gaps = kGap.size() * (m_columns.size() - 1);
    for (std::size_t most = std::ranges::max(natural);; --most) {
        std::vector<std::size_t> widths;
        for (std::size_t c = 0; c < m_columns.size(); ++c)
            widths.push_back(std::max(std::min(natural[c], most), least[c]));
        if (most == 0 || std::accumulate(widths.begin(), widths.end(), gaps) <= width) return widths;
    }
}

std::string Table::text(std::size_t width) const
{
    const std::vector<std::size_t> widths = widthsWithin(width);
    std::string                    text;
    const auto                     addRow = [&](const auto& cellOf) {
        std::vector<std::vector<std::string>> cells;
        std::size_t                           lines = 1;
        for (std::size_t c = 0; c < m_columns.size(); ++c) {
            cells.push_back(wrapped(cellOf(c), widths[c]));
            lines = std::max(lines, cells.back().size());
        }
        for (std::size_t l = 0; l < lines; ++l) {
            std::string line;
            for (std::size_t c = 0; c < m_columns.size(); ++c) {
                const std::string cell = l < cells[c].size() ? cells[c][l] : "";
                if (c > 0) line += kGap;
                line += m_columns[c].align == Align::Left ? fmt::format("{:<{}}", cell, widths[c])
                                                                              : fmt::format("{:>{}}", cell, widths[c]);
            }
            text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
        }
    };
    addRow([&](std::size_t c) { return m_columns[c].title; });
    for (const auto& row : m_rows) addRow([&](std::size_t c) { return row[c]; });
    return text;
}

std::string ms(double value) { return fmt::format("{:.3f}", value); }

std::size_t outputWidth()
{
    constexpr std::size_t kUnknown = 100;
    winsize               window{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0) return window.ws_col;
    const char* const      said    = std::getenv("COLUMNS");
    const std::string_view columns = said ? said : "";
    std::size_t            width   = 0;
    const auto [end, why]          = std::from_chars(columns.data(), columns.data() + columns.size(), width);
    return why == std::errc{} && end == columns.data() + columns.size() && width > 0 ? width : kUnknown;
}

}  // namespace zscope::cli
