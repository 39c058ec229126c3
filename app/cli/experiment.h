// bench --experiment: measures what an experiment's file asks for, case by case, into a record that outlives an
// interruption.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/cli/bench_scenes.h"
#include "app/cli/session.h"
#include "core/base/result.h"
#include "core/measure/bench.h"

namespace zscope::cli {

/// "i/n": every n-th case, beginning with the i-th.
struct Shard {
    std::size_t index = 1, count = 1;

    bool has(std::size_t caseIndex) const { return caseIndex % count == index - 1; }
};
Result<Shard> shardOf(const std::string& word);

struct ExperimentOptions {
    std::string                file;
    Shard                      shard       = {};
    std::uint64_t              memoryLimit = 0;  // bytes; 0: the default
    std::optional<std::string> json, csv = {};   // the record, which is gone on with if it is there; a view of it
};

/// `request` along the path, in pictures as large as its camera says. Errors: as benchPath(); Input where the path does
/// not fit the scene.
Result<std::vector<BenchRow>> alongPath(const BenchRequest& request, const NamedPath& path);

/// CheckFailed: a picture was wrong that its algorithm says is not.
Result<Exit> runExperiment(const ExperimentOptions& options, Session& session);

}  // namespace zscope::cli
