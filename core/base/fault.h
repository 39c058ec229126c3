// Mistakes that published renderers and students make, to be switched on and looked at. An exact frame has none.
//
// Promise    a fault makes wrong pictures, never wrong memory accesses
// Growing    an enumerator here, its sentences in core/frame/faults.h, and one rule that consults it
#pragma once

#include <cstdint>

namespace zscope {

enum class Fault {
    None,                // in no set
    FirstLineRounded,    // scan: the first line of a triangle is rounded instead of rounded up
    HorizontalByX,       // scan: a side counts as horizontal if its x extent is nothing
    XTruncated,          // scan: a span begins and ends at the truncated x
    NoTopLeft,           // scan: a point on an edge belongs to both neighbours
    EdgesUnsorted,       // sweep: active edges stay in the order they came
    OneTestPerInterval,  // intervals: whoever is nearest at the left end gets the whole interval
    NearestInCells,      // pyramid: a cell holds the nearest of its children
    CornersOnly,         // pyramid: a query looks at the corners of its rectangle
    EmptyIsHidden,       // pyramid: a rectangle truncated to nothing counts as hidden
    OddPadded,           // pyramid: the last row and column of an odd level are padding
    EqualIsHidden,       // pyramid: what is as near as the cell counts as hidden
    NearRejected,        // clip: a triangle with any corner before the near plane is dropped
    CrossingDropped,     // clip: a triangle that crosses the border of the picture is dropped
    FarFirst,            // order: the farthest child is visited first, and who came first keeps a tie
    LinearZ,             // depth: the distance is interpolated linearly over the pixels
    HalfPixel,           // coverage: pixels are sampled in their upper left corners
    BehindTheEye,        // clip: corners behind the eye are divided by their distance, and nothing is cut
    ConcaveFanned,       // set-up: every face is a fan from its first corner
    WindingFlipped,      // set-up: front faces are taken for back faces
    BoxShort,            // scan: the last column and the last line of a triangle's box are left out
    NotCleared,          // depth: the buffer still holds what the frame before has left
    EqualPassLess,       // depth: after a pre-pass a fragment must be nearer than the depth that it left
    EdgeDrift,           // scan: an edge moves by whole subpixels from line to line
    LevelTooFine,        // pyramid: a query looks at the corners of its rectangle one level too fine
    LevelShifted,        // pyramid: a query looks up the cells of one level at the coordinates of the next
    PainterOrder,        // depth: what comes later in the file is drawn over, without a test
    FarthestWins,        // depth: a fragment wins if it is farther than what is there
};

/// Faults that a pipeline has at once. Ranges over its faults in the order of the enumerators.
class FaultSet {
public:
    constexpr FaultSet() = default;
    constexpr FaultSet(Fault fault) { add(fault); }  // of one fault; of Fault::None the empty set

    constexpr bool isEmpty() const { return m_bits == 0; }
    constexpr bool has(Fault fault) const { return (m_bits & bitOf(fault)) != 0; }
    constexpr void add(Fault fault) { m_bits |= bitOf(fault); }
    constexpr void remove(Fault fault) { m_bits &= ~bitOf(fault); }

    friend constexpr bool operator==(const FaultSet&, const FaultSet&) = default;

    class Iterator {
    public:
        constexpr explicit Iterator(std::uint64_t bits) : m_bits(bits) {}
        constexpr Fault operator*() const
        {
            int place = 0;
            while ((m_bits >> place & 1) == 0) ++place;
            return static_cast<Fault>(place + 1);
        }
        constexpr Iterator& operator++()
        {
            m_bits &= m_bits - 1;
            return *this;
        }
        friend constexpr bool operator==(const Iterator&, const Iterator&) = default;

    private:
        std::uint64_t m_bits;  // of the faults that are still to come
    };
    constexpr Iterator begin() const { return Iterator(m_bits); }
    constexpr Iterator end() const { return Iterator(0); }

private:
    static constexpr std::uint64_t bitOf(Fault fault)
    {
        return fault == Fault::None ? 0 : std::uint64_t{1} << (static_cast<int>(fault) - 1);
    }

    std::uint64_t m_bits = 0;
};

}  // namespace zscope
