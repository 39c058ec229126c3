// Text tables: columns as wide as their widest cell, words to the left, numbers to the right.
#pragma once

#include <string>
#include <vector>

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

/// "12 345 678": digits in groups of three.
std::string grouped(unsigned long long value);

}  // namespace zscope::cli
