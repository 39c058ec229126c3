// A batch in patches: its triangles in runs of kPatchTriangles, which are asked about before anything is done about
// their triangles. The cone of normals of a whole batch is mostly too wide, and its box reaches too far; of its patches
// those that face away or have no pixel to show are left out, and vertices that only they use likewise.
//
// Layout     structure of arrays, so that lanes ask several patches at once; of patches that there are not the altitude
//            is 0
// Groups     vertices stand in the order in which triangles use them first, so that a patch's lie in few groups of
//            kVertexGroup
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace zscope {

inline constexpr std::uint32_t kPatchTriangles = 32;
inline constexpr std::size_t   kVertexGroup    = 16;

/// kPatches patches of one batch, one after another. In the units of the model.
struct alignas(64) PatchBlock {
    static constexpr std::size_t kPatches = 8;
    using Column                          = std::array<double, kPatches>;

    std::array<Column, 3>               axis{}, apex{};  // as of NormalCone, like the next
    Column                              cosine{}, sine{}, altitude{};
    std::array<Column, 3>               centre{};  // of a sphere that holds its corners
    Column                              radius{};
    std::array<std::uint64_t, kPatches> vertexGroups{};  // bit i: some of the batch's vertices from kVertexGroup i on
};

/// Bit i: the batch's triangles from kPatchTriangles i on.
using PatchBits                        = std::uint32_t;
inline constexpr PatchBits kAllPatches = ~PatchBits{0};

/// Bits next to each other that are set.
struct BitRun {
    std::uint32_t first, count;
};
/// The lowest run of `bits`, not 0, which loses it.
template <class Bits>
[[gnu::always_inline]] inline BitRun takeRun(Bits& bits)
{
    const int first = std::countr_zero(bits), count = std::countr_one(static_cast<Bits>(bits >> first));
    bits &= bits + (Bits{1} << first);  // carries through the run
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)};
}

}  // namespace zscope
