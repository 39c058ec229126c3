// What an experiment measured: one JSON file that grows case by case, can be gone on with after an interruption, and
// can be joined with those of other machines of the same kind.
//
// Form       {"record":1,"experiment":{title, question, baseline, digest},
//            "program":{version, compiler},"machine":{processor, cores},"case_count":N,
//            "cases":[{"index","part","scene","x","scene_digest","path_digest","word","camera","cull","width","height",
//            "rows":[...]}...]}, cases by rising index; rows as benchToJson() writes them
// Comparable only records of one experiment, program and kind of machine; a case that is in two of them must have been
//            measured on the same scene, along the same camera path
// Errors     one sentence that names the file and what differs
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/measure/bench.h"
#include "core/measure/experiment.h"

namespace zscope {

inline constexpr std::uint64_t kMaxRecordFile = std::uint64_t{1} << 30;  // bytes

/// What must be the same for times to be compared.
struct RecordHead {
    ExperimentText title, question;
    std::string    baseline, digest;   // as Experiment
    std::string    version, compiler;  // of this program
    std::string    processor;          // as the system calls it
    unsigned       cores     = 1;
    std::size_t    caseCount = 0;  // of the whole experiment
};
/// Of the program that runs and the machine it runs on.
RecordHead recordHeadFor(const Experiment& experiment);
/// As the system calls it.
std::string processorName();
/// A sentence that says what differs; empty: times may be compared.
std::string whyNotComparable(const RecordHead& a, const RecordHead& b);

struct RecordCase {
    std::size_t    index = 0;
    ExperimentText part, x;  // x: what `place` means
    std::string    scene, sceneDigest;
    // of the scene on the axis of a growth curve; its number in the part where it has none
    double      place = 0;
    int         width = 0, height = 0;
    std::string pathDigest  = {};  // of the camera path; empty: one view
    std::string word        = {};  // that loads the scene; empty: a record of before there was one
    Camera      camera      = {};  // of the view, or of the path's first frame
    FaceCulling faceCulling = FaceCulling::None;
    std::string rows;  // JSON, an array
};

struct Record {
    RecordHead              head;
    std::vector<RecordCase> cases;  // indices rise

    const RecordCase* find(std::size_t index) const;  // nullptr: it has not been measured
    void              add(RecordCase measured);       // in its place; it is not there yet
};

std::string    recordToJson(const Record& record);
Result<Record> recordFromJson(const std::string& text, const std::string& file);

struct NamedRecord {
    std::string file;
    Record      record;
};
/// All cases of all records, of which there is at least one; a case that two have is taken from the first.
Result<Record> joined(std::span<const NamedRecord> records);

/// The pipeline that nameOf() called so; nothing if there is none of this name.
std::optional<Pipeline> pipelineNamed(std::string_view name);

/// Its rows, called by its scene. Error: Input: they are none.
Result<std::vector<BenchRow>> rowsOf(const RecordCase& measured);

}  // namespace zscope
