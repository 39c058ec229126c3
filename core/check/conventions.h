// The conventions of foreign files: what depths mean, which row comes first, what ids number, which faces are drawn.
// What is not given is found by trying all combinations. The best one agrees with the reference at most pixels; of
// equal ones the plainest is taken, which comes first in every list. Readings that agree nearly as well are given back
// too: judging them (core/check/judge.h) tells which one leaves the fewest pixels wrong.
//
// Background  the value that stands on most pixels that the reference leaves empty; if it also stands on more than half
//             of the covered ones, or nothing is empty, 0, 1, -1, infinity, NaN and the file's largest value are tried
// Empty file  one that holds background alone has no conventions
// Agreement   of a pixel: both empty, or both covered, with more for the right id and for a depth within its tolerance.
//             A depth beyond it counts a little, the more the closer it is, so that a file without one right depth is
//             read rightly as well. The same for ids: a triangle that may cover its pixel counts, seen or not
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/check/foreign.h"
#include "core/check/truth.h"

namespace zscope::check {

enum class IdKind { Triangles, Faces };
/// "top-down", "bottom-up"; "triangles", "faces".
std::string_view wordOf(Rows rows);
std::string_view wordOf(IdKind kind);

/// What is given, or what was found.
struct Conventions {
    std::optional<DepthMeaning> depth;
    std::optional<Rows>         rows;
    std::optional<IdKind>       ids;
    std::optional<int>          idsFrom;  // 0 or 1
    std::optional<FaceCulling>  cull;

    friend bool operator==(const Conventions&, const Conventions&) = default;
};

/// The files with their conventions.
struct Reading {
    Conventions                  conventions;
    std::shared_ptr<const Truth> truth;  // with the camera and the culling that fit best
    // in what the empty pixels hold; nothing: no pixel of the file is empty
    std::optional<double>       depthBackground;
    std::optional<std::int64_t> idBackground;
    std::uint32_t               pictureBackground = 0;
    std::int64_t                agreement         = 0;
    bool                        isDepthEmpty = false, areIdsEmpty = false, isPictureEmpty = false;
};

/// Whether a depth is the background's; NaN is equal to NaN.
bool isBackground(double depth, const std::optional<double>& background);

/// The reading that agrees best and those within a fiftieth of it, the plainest first. `truths`: one or more cameras,
/// each with back faces drawn and with them culled, or with what is given alone; the plainest first. Not empty.
std::vector<Reading> readingsOf(const Foreign& files, const Conventions& given,
                                const std::vector<std::shared_ptr<const Truth>>& truths);

}  // namespace zscope::check
