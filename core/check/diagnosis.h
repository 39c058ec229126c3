// Which mistakes explain the wrong pixels of a foreign picture, and where those lie that nothing explains.
//
// Explains   a wrong pixel is explained by a mistake if ZScope's picture with that mistake is wrong there in the same
//            way: the same kind, the same id where there are ids, and a depth that is closer to the file's than a
//            quarter of what the file is off
// Adds       pixels that the mistake would spoil, beyond rounding, and that the file has right
// Pairs      where no mistake explains enough, the three that explain most are tried two at a time. A pair counts if it
//            explains better than each of its two
// Order      by explained / (wrong + adds), the best first; equal ones as causeEntries() has them
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/check/causes.h"

namespace zscope::check {

struct Cause {
    std::string      name;
    std::string      title;
    double           explains  = 0;  // share of the wrong pixels
    std::uint64_t    explained = 0;  // of them
    std::uint64_t    adds      = 0;
    std::uint64_t    addsDepth = 0;  // of them: only the depth would be wrong
    std::string_view lesson;         // empty: none teaches it
    Pipeline         pipeline;       // that was drawn: with this mistake, and with no other
};

/// A place where wrong pixels gather: their share there, and that of all covered pixels.
struct Cluster {
    std::string_view where;
    double           share = 0, usual = 0;
};

/// The picture of a pipeline with mistakes. Kept by the caller.
using SpoiltSource = std::function<Result<const SpoiltPicture*>(const Pipeline& pipeline)>;

/// Those of which explained / (wrong + adds) is a fifth or more: a mistake that would spoil far more than is wrong is
/// no cause. For this, depths that a mistake adds count only if the files have wrong depths: a program may err in
/// coverage and find its depths rightly. Errors: those of the source.
Result<std::vector<Cause>> causesOf(const Shown& shown, const Judgement& judgement, const Truth& truth,
                                    const SpoiltSource& spoilt);

/// Places that hold half of the wrong pixels or more, and twice their usual share; the most telling first.
std::vector<Cluster> clustersOf(const Judgement& judgement, const Truth& truth);

}  // namespace zscope::check
