// Two pictures of one view, pixel by pixel: where they differ, how, and by how much.
//
// A, B       A is what B is held against
// Steps      float32 steps between the two depths (core/measure/error_figures.h), so that the tolerance means the same
//            near and far
// Promise    the same pictures give the same difference; counts add up to the pixels
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/grid.h"
#include "core/depth/visibility_buffer.h"
#include "core/measure/error_figures.h"

namespace zscope {

enum class PixelDifference : std::uint8_t {
    None,         // the same triangle, depths within the tolerance
    DepthNearer,  // the same triangle, B nearer by more than the tolerance
    DepthFarther,
    Surface,  // another triangle
    Hole,     // A shows a triangle, B background
    Spill,    // the other way round
};
inline constexpr std::size_t kPixelDifferences = 6;

struct Difference {
    Grid<PixelDifference>                        kinds;
    std::array<std::uint64_t, kPixelDifferences> counts{};  // by kind
    Grid<std::uint32_t>                          heat;      // 0xAARRGGBB: white where nothing differs
    // a pixel of the worst kind, with most steps; nothing: none differs
    std::optional<std::array<int, 2>> worst;
    std::uint32_t                     mostSteps = 0;  // at pixels of the same triangle

    std::uint64_t differing() const { return kinds.values().size() - counts[0]; }
};

/// Both pictures have the same size. `tolerance` in float32 steps.
Difference differenceOf(const VisibilityBuffer& a, const VisibilityBuffer& b, std::uint32_t tolerance);

/// What is wrong, whatever the depths: used for nothing else.
inline constexpr std::uint32_t kWrongColour = 0xFFB00020;

}  // namespace zscope
