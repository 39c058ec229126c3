// zscope-cli grade: one program, or each submission of a class, run over scenes in a sandbox, and its files checked.
//
// Command     a line of the shell. {scene}, {camera}, {out} and {submission} in it become paths that need no quotes
// Starts in   an empty folder that it may write; without --submissions the folder in which grade runs, for reading only
// May read    the system's programs, the scene, its submission, and absolute paths that the command names
// Order       runs go on side by side; rows are sorted by submission, then as the scenes were named. The table shows no
//             times, so that the same class has the same table
// Journal     a file that is written after each run and gone on with. The row of a submission stays as long as its
//             files do; that of a program without --submissions as long as the files that the command names
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/json.h"
#include "app/cli/options.h"
#include "app/cli/sandbox/sandbox.h"

namespace zscope::cli {

/// In the words of the command line.
enum class GradeVerdict {
    Right,
    Rounding,
    Wrong,
    Crashed,
    Failed,
    TimedOut,
    TooMuchMemory,
    TooMuchOutput,
    WroteNothing,
    Unreadable
};
std::string_view            wordOf(GradeVerdict verdict);
std::optional<GradeVerdict> gradeVerdictOf(std::string_view word);
/// Right or different by rounding alone.
inline bool isGood(GradeVerdict verdict) { return verdict == GradeVerdict::Right || verdict == GradeVerdict::Rounding; }

struct GradeRow {
    std::string  submission, scene;
    GradeVerdict verdict = GradeVerdict::Right;
    double       seconds = 0;
    double       peakMiB = 0;
    std::string  detail;           // one or a few sentences, the same whenever the same happens
    Json         check = nullptr;  // the judgement as `check --json` has it
    std::string  digest;           // of the submission's files
};

struct GradeOptions {
    std::vector<std::string>   scenes;
    ViewOptions                view;
    std::string                program;
    std::optional<std::string> submissions, timeLimit, memoryLimit, threads;
    std::optional<std::string> journal, junit, gradescope;
    bool                       withoutSandbox = false;
    bool                       json           = false;
};

}  // namespace zscope::cli
