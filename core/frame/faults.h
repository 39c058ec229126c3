// The fault gallery: defects that published renderers have, each with what causes it and what cures it.
//
// Use        `--fault WORD`, or a pipeline's `fault`: a set, in a composition in which each of them can happen
// Promise    the exact text is the same text: a fault is one rule answered wrongly (core/geometry/rules.h,
//            core/depth/pyramid.h)
// Figures    what a fault costs is counted by `verify` against the reference: wrong pixels, all of them. FarFirst costs
//            work done in vain besides (missed culls)
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/frame/pipeline.h"

namespace zscope {

struct FaultEntry {
    Fault            fault;
    std::string_view word;
    std::string_view title;
    std::string_view cause;   // one sentence
    std::string_view cure;    // one sentence
    std::string_view place;   // what it can happen in
    std::string_view preset;  // one in which it can
    bool (*canHappen)(const Pipeline&);
};

/// All but Fault::None.
std::span<const FaultEntry> faults();
const FaultEntry*           findFault(std::string_view word);  // nullptr: no fault has this word
/// Of "word" or "word+word"; nothing if one of them is no fault's.
std::optional<FaultSet> findFaults(std::string_view words);
/// The same in reverse; "" of the empty set.
std::string wordsOf(const FaultSet& faults);
/// Not of Fault::None.
const FaultEntry& entryOf(Fault fault);

}  // namespace zscope
