// Where a command's outputs go, checked before anything is drawn: each has a name whose ending fits, none is another's,
// none is what is read, and each can be created.
//
// Twice      with the files that a command line names, before any is read; then with those that scenes have led to
//            (Scene::files)
// Endings    no ending is always right; letters may be large or small
// Same       names that lead to one file, links followed, whether or not it is there yet. A device or a pipe may be
//            named more than once: nothing in it can be lost
// Errors     Usage, with the options that are concerned; Output for a file that cannot be created
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace zscope::cli {

struct Output {
    std::string_view           option;  // as it is written on the command line
    std::optional<std::string> path;    // nothing: not asked for

    std::vector<std::string_view> endings = {};  // that its name may have, as endingOf() gives them; empty: any
};

/// ".png" of "picture.PNG"; empty if there is none.
std::string endingOf(const std::string& path);

/// `inputs` are files that are read; scenes that are generated and empty names are none.
Result<Done> checkOutputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs);

}  // namespace zscope::cli
