// Text tables: words to the left, numbers to the right, columns as wide as their widest cell unless the table has a
// width to fit.
//
// Fitting    the widest columns of words are made narrower, and their cells take several lines, broken after spaces and
//            commas. A word is never broken: a table of long words may stay wider than it should
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "core/base/grouped.h"

namespace zscope::cli {

class Table {
public:
    enum class Align { Left, Right };
    struct Column {
        std::string title;
        Align       align = Align::Right;
    };
    explicit Table(std::vector<Column> columns) : m_columns(std::move(columns)) {}

    /// One cell per column.
    void        row(std::vector<std::string> cells);
    std::string text(std::size_t width = std::numeric_limits<std::size_t>::max()) const;

private:
    std::vector<std::size_t> widthsWithin(std::size_t width) const;

    std::vector<Column>                   m_columns;
    std::vector<std::vector<std::string>> m_rows;
};

/// Milliseconds in a cell: "1.234".
std::string ms(double value);

/// The columns of the terminal that standard output goes to, else those that the variable COLUMNS says, else 100.
std::size_t outputWidth();

}  // namespace zscope::cli
