// Every pixel of a foreign picture held against the reference: right, wrong, or different by rounding alone.
//
// Coverage   is read from ids, else from depth, else from the picture
// Surface    is judged where there are ids; two triangles of one face that is not convex are the same
// Depth      is judged where the ids agree, or where both are covered and there are no ids
// Rounding   a careful renderer could have drawn it (core/check/exact_triangle.h): the triangle that the reference
//            shows may miss the sample, or the one that the file shows may reach it; or both cover it and their depths
//            tie. Without ids any triangle that may reach the sample, at the file's depth, explains it
// Tie        depths at most two float32 steps apart, or closer than what displacement may change of both
// Cost       ids: some triangles per differing pixel. Without ids: every triangle once, against the differing pixels
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/check/conventions.h"

namespace zscope::check {

enum class Mistake : std::uint8_t { Hole, Spill, WrongSurface, WrongDepth };
inline constexpr std::array kMistakes{Mistake::Hole, Mistake::Spill, Mistake::WrongSurface, Mistake::WrongDepth};
/// "hole", "spill", "wrong_surface", "wrong_depth".
std::string_view wordOf(Mistake mistake);

/// What is to be judged, in the reference's rows and numbers.
struct Shown {
    bool                              isEmpty = false;  // background alone: every covered pixel is a hole
    Grid<std::uint8_t>                covered;
    std::optional<Grid<std::int64_t>> ids;  // triangles or faces as `kind` says, from 0; -1: background
    IdKind                            kind = IdKind::Triangles;
    std::optional<Grid<double>>       depth;  // as the file has it
    DepthMeaning                      meaning = DepthMeaning::NearOverZ;
    DepthResolution                   resolution;
};
Shown shownBy(const Foreign& files, const Reading& reading);

struct Verdict {
    std::uint8_t code = 0;  // 0: as the reference has it; 1 + mistake: wrong; 5 + mistake: rounding

    static Verdict wrong(Mistake m) { return {static_cast<std::uint8_t>(1 + static_cast<int>(m))}; }
    static Verdict rounding(Mistake m) { return {static_cast<std::uint8_t>(5 + static_cast<int>(m))}; }
    bool           isSame() const { return code == 0; }
    bool           isWrong() const { return code >= 1 && code <= 4; }
    bool           isRounding() const { return code >= 5; }
    Mistake        mistake() const { return static_cast<Mistake>((code - 1) % 4); }
};

/// Pixels, by mistake.
struct MistakeCounts {
    std::array<std::uint64_t, 4> pixels{};

    std::uint64_t  of(Mistake m) const { return pixels[static_cast<std::size_t>(m)]; }
    std::uint64_t& of(Mistake m) { return pixels[static_cast<std::size_t>(m)]; }
    std::uint64_t  total() const { return pixels[0] + pixels[1] + pixels[2] + pixels[3]; }
};

struct Judgement {
    Grid<Verdict> verdicts;
    MistakeCounts wrong, rounding;
    std::uint64_t onEdges = 0;  // of the roundings of coverage and surface: the sample lies exactly on a snapped edge
    std::uint64_t ties    = 0;  // of those of surface: both depths are equal, up to two float32 steps
};

Judgement judge(const Shown& shown, const Truth& truth);

/// Pixels that show a triangle whose back the viewer sees, and that no rounding turns over.
std::uint64_t backFacesIn(const Shown& shown, const Truth& truth);

}  // namespace zscope::check
