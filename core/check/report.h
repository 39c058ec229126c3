// A judgement as a page that a student hands in and a teacher reads: the sentence, counts, pictures, the first wrong
// pixel with everything that covers it, likely causes, conventions; of a trace that was judged with it the rows that
// differ.
//
// Page       one HTML file that needs nothing but itself and runs nothing: pictures are in it, and two buttons without
//            a script choose English or Chinese (core/io/phrase_book.h). It prints as it is shown
// Safe       every text that comes from a file, its name included, stands in the page as text (core/io/markup.h)
// Promise    the same judgement gives the same page, byte for byte
// Errors     Output, Limit
#pragma once

#include <string>

#include "core/check/check.h"

namespace zscope::check {

inline constexpr const char* kReportFile = "report.html";

/// A trace that was judged with the picture: both, or neither.
struct ReportedTrace {
    const TraceAnswer* answer = nullptr;
    const Trace*       trace  = nullptr;
};

/// `command` judges the same files again; it may be empty.
Result<std::string> reportPage(const CheckAnswer& answer, const std::string& command, const ReportedTrace& trace = {});
/// Writes it into a folder, which is made if it is not there; gives back the page's path.
Result<std::string> writeReport(const CheckAnswer& answer, const std::string& command, const std::string& folder,
                                const ReportedTrace& trace = {});

/// The folder is there, or is made. Errors: Output.
Result<Done> makeFolder(const std::string& folder);

}  // namespace zscope::check
