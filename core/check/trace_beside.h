// A row of a trace beside the state of our run that it was held against, field by field, as a table shows it.
//
// Fields     those of the row that are judged, in its order; the parts of lists and objects stand below them. Edges and
//            spans stand beside those of ours that they were held against; what the row lacks has a place as well
// Texts      words of the row and numbers: the same in every language
// Agrees     with the sentence of that row: it has one if and only if a field differs
// Cost       the first row: a run that counts steps. Each row: a run from the last checkpoint (core/lesson/replay.h)
// Errors     those of Replay
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/check/trace.h"

namespace zscope::check {

enum class Likeness { Same, Rounding, Differs };  // the better first

struct FieldBeside {
    int         depth = 0;     // of its place in the row: 0 a field of the row, 1 a part of that
    std::string name;          // a word of the row, or "polygon 38" of a part of a list
    std::string ours, theirs;  // empty: there is none, or its parts follow
    Likeness    likeness = Likeness::Same;

    friend bool operator==(const FieldBeside&, const FieldBeside&) = default;
};

class TraceBeside {
public:
    /// `request` and `halfStep` as judgeTrace() was given them.
    TraceBeside(std::shared_ptr<const Trace> trace, std::shared_ptr<const TraceAnswer> answer,
                const DrawRequest& request, double halfStep);
    ~TraceBeside();

    Result<std::vector<FieldBeside>> row(std::size_t row);

private:
    struct Kept;
    std::unique_ptr<Kept> m_kept;
};

}  // namespace zscope::check
