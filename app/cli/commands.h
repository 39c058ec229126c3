// The subcommands. Each lives in a file of its own, adds its options to the parser, and runs once they are read.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "app/cli/session.h"

namespace zscope::cli {

struct Command {
    CLI::App*                     parser;  // owned by the parent parser
    std::function<Exit(Session&)> run;
};

Command addRender(CLI::App& parent);
Command addInfo(CLI::App& parent);
Command addExport(CLI::App& parent);
Command addVerify(CLI::App& parent);
Command addCheck(CLI::App& parent);
Command addGrade(CLI::App& parent);
Command addAudit(CLI::App& parent);
Command addStep(CLI::App& parent);
Command addExplain(CLI::App& parent);
Command addLesson(CLI::App& parent);
Command addCompare(CLI::App& parent);
Command addBench(CLI::App& parent);
Command addMerge(CLI::App& parent);
Command addList(CLI::App& parent);

}  // namespace zscope::cli
