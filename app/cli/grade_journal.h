// The journal of a grading: JSON that holds what was asked for and the rows so far, so that a long run is gone on with.
//
// Whole       the file is written anew after each run, complete or not at all
// Same        a journal fits if command, scenes, cameras, limits and the program's version are the same
// Errors      Input: no journal, or that of another grading; Output
#pragma once

#include <string>
#include <vector>

#include "app/cli/grade.h"
#include "app/cli/json.h"

namespace zscope::cli {

/// As `grade --json` has it.
Json jsonOf(const GradeRow& row);

class GradeJournal {
public:
    /// `head` is what was asked for. Reads the file if it is there; an empty path keeps nothing.
    static Result<GradeJournal> open(std::string path, Json head);

    const GradeRow* find(const std::string& submission, const std::string& scene, const std::string& digest) const;
    std::size_t     size() const { return m_rows.size(); }
    Result<Done>    add(const GradeRow& row);

private:
    std::string           m_path;
    Json                  m_head;
    std::vector<GradeRow> m_rows;
};

/// 16 hex digits of the names and contents of a file, or of all files in a folder. Errors: Input.
Result<std::string> digestOfFiles(const std::string& path);

}  // namespace zscope::cli
