// A cut-out: a pattern of holes in every face of a material, as leaves, fences and nets have. A fragment in a hole does
// not exist: it is cut out before the depth test knows of a winner.
//
// Place      the pattern lies in the mesh's own space: on the two axes that the triangle faces least, so that it stays
//            on the surface whatever the instance, the camera and the near plane do
// Source     docs/correctness.md, Cut-outs
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace zscope {

enum class CutoutPattern { Checker, Stripes, Holes };

inline constexpr std::array<std::string_view, 3> kCutoutWords{"checker", "stripes", "holes"};  // in the enum's order

struct Cutout {
    CutoutPattern pattern = CutoutPattern::Checker;
    double        size    = 1;  // of one cell, in units of the mesh; > 0

    friend bool operator==(const Cutout&, const Cutout&) = default;
};

}  // namespace zscope
