// Text tables: columns as wide as their widest cell, words to the left, numbers to the right.
#pragma once

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
    std::string text() const;

private:
    std::vector<Column>                   m_columns;
    std::vector<std::vector<std::string>> m_rows;
};

}  // namespace zscope::cli
