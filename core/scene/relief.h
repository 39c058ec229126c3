// A relief: fragments of every face of a material lie farther from the eye than the face itself, as the joints of a
// wall, the slats of a blind or dents do. It is a fragment stage that changes depth.
//
// Place      as a cut-out's pattern (core/scene/cutout.h): in the mesh's own space, on the surface
// Direction  only away from the eye, so that whatever is known to bound the face from the near side bounds the relief
//            too
// Source     docs/correctness.md, Reliefs
#pragma once

#include <array>
#include <string_view>

namespace zscope {

enum class ReliefPattern { Bricks, Louvres, Bowls };

inline constexpr std::array<std::string_view, 3> kReliefWords{"bricks", "louvres", "bowls"};  // in the enum's order

struct Relief {
    ReliefPattern pattern = ReliefPattern::Bricks;
    double        size    = 1;  // of one cell, in units of the mesh; > 0
    double        depth   = 1;  // of its deepest fragments, along the view, in units of the scene; > 0

    friend bool operator==(const Relief&, const Relief&) = default;
};

}  // namespace zscope
