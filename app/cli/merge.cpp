// zscope-cli merge: the records of an experiment's shards, joined to one.
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "core/io/file_writer.h"
#include "core/io/read_file.h"
#include "core/measure/record.h"

namespace zscope::cli {
namespace {

struct MergeOptions {
    std::vector<std::string> files;
    std::string              output;
};

Result<Exit> merge(const MergeOptions& options, Session& session)
{
    // A record may be joined into itself: it is read as a whole before anything is written.
    if (const auto checked = checkOutputs({{"-o", options.output}}, {}); !checked) return checked.error();
    std::vector<NamedRecord> records;
    for (const std::string& file : options.files) {
        const auto text = readRegularFile(file, kMaxRecordFile);
        if (!text) return text.error();
        Result<Record> record = recordFromJson(*text, file);
        if (!record) return record.error();
        records.push_back({file, *std::move(record)});
    }
    const Result<Record> all = joined(records);
    if (!all) return all.error();
    if (const auto written = writeFile(options.output, recordToJson(*all)); !written) return written.error();
    session.print(fmt::format("{}: {} of {} cases\n", options.output, all->cases.size(), all->head.caseCount));
    return Exit::Done;
}

}  // namespace

Command addMerge(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("merge", "Join the records of an experiment's shards");
    auto      options = std::make_shared<MergeOptions>();
    parser->add_option("RECORD", options->files, "Records that 'bench --experiment --json' wrote")
        ->type_name("FILE.json...")
        ->required();
    parser->add_option("-o", options->output, "The joined record")->type_name("FILE.json")->required();
    return {parser, [options](Session& session) {
                const Result<Exit> exit = merge(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
