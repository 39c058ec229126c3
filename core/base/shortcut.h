// What makes the fast text fast, one by one. None changes a bit of the picture.
//
// Growing    an enumerator here, its row in core/frame/shortcuts.cpp, and the place that asks for it
#pragma once

#include <cstdint>

namespace zscope {

enum class Shortcut : std::uint8_t {
    Lanes,             // vertices, set-up, edges and depth tests side by side
    Windows,           // compact triangles of a batch together
    LargeTriangles,    // which tiles a triangle has pixels of first, then tile after tile without a branch
    WideTiles,         // tiles of triangles beyond the guard band
    TilePlanes,        // a tile that one triangle covers is kept as a plane
    StackedDepths,     // pictures above each other, so that the last one need not be cleared
    SharedSides,       // one edge where two triangles meet
    PatchedBatches,    // batches in the order of patches
    FacingCones,       // batches and patches that face away
    PatchReach,        // patches that reach no pixel of the stripe
    StoredTiles,       // tiles whose stored depth hides the triangle
    TwoLevelPyramid,   // a pyramid whose questions read many tiles at once
    HiddenSquares,     // squares whose pixels are all nearer than the batch
    NodeBalls,         // a node reaches no farther than a ball around it
    SkippedQuestions,  // questions that seldom say "hidden"
    NearestNode,       // from within a tree the nearest of all nodes that wait
    WholeNodes,        // small nodes are drawn with everything below them
    NearestTriangle,   // large triangles of a batch, the nearest first
};
inline constexpr int kShortcutCount = static_cast<int>(Shortcut::NearestTriangle) + 1;

/// Ranges over its shortcuts in the order of the enumerators.
class ShortcutSet {
public:
    constexpr ShortcutSet() = default;  // none

    static constexpr ShortcutSet all()
    {
        ShortcutSet every;
        every.m_bits = (std::uint32_t{1} << kShortcutCount) - 1;
        return every;
    }

    constexpr bool isEmpty() const { return m_bits == 0; }
    constexpr bool isAll() const { return *this == all(); }
    constexpr bool has(Shortcut shortcut) const { return (m_bits & bitOf(shortcut)) != 0; }
    constexpr void add(Shortcut shortcut) { m_bits |= bitOf(shortcut); }
    constexpr void remove(Shortcut shortcut) { m_bits &= ~bitOf(shortcut); }

    friend constexpr bool operator==(const ShortcutSet&, const ShortcutSet&) = default;

private:
    static constexpr std::uint32_t bitOf(Shortcut shortcut) { return std::uint32_t{1} << static_cast<int>(shortcut); }

    std::uint32_t m_bits = 0;
};

}  // namespace zscope
