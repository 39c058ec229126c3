// A build without Cairo.
#include "app/cli/compare_sheet.h"

namespace zscope::cli {

const bool kHasPdf = false;

Result<Done> writePdfSheet(const std::string& path, const Comparison&, const Scene&, const SheetWords&, TextPainter&)
{
    return Error{Trouble::Output, "this build writes no PDF: Cairo (libcairo2-dev) was not found when it was made",
                 path};
}

}  // namespace zscope::cli
