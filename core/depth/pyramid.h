// Hierarchical z-buffer: level 0 is the depth buffer; a cell of level n + 1 holds the FARTHEST depth of its 2 x 2
// children, so "everything behind this cell is hidden" can be read from one number.
//
// Region     the lines [firstRow, endRow) of one stripe, full width; cell (x, y) of level n covers the pixels
//            [x 2^n, (x+1) 2^n) x [firstRow + y 2^n, ...); pixels outside the region do not exist and take no part
// Levels     1 and 2 are not stored: a cell of them is at most 16 pixels, which are read instead. From kTileLevel up
//            each level is half the one below, rounded up, to a single cell
// Question   first what is stored, which may say yes; then the pixel in the middle of the box, at full speed those in
//            its corners, too, each of which may say no and mostly one does of what can be seen; then cell by cell
// Upkeep     touched() marks the tiles under a box and their ancestors as stale, and stops where they already are; a
//            stale cell is recomputed when a query meets it and neither its old value nor those pixels could answer. A
//            tile all of whose pixels were seen by who drew takes its value from there (drawnTile()). Or push(): the
//            tiles are recomputed at once, and from each of them its ancestors, up to the first that does not change.
//            Or, if the pyramid is masked, cover(): tiles know two depths and a mask, and no pixel is ever read
// Wide       a pyramid of two levels, tiles and blocks of 8 x 8 tiles: lanes read a line of tiles at once
//            (wide_pyramid-inl.h). Only tiles become stale; what is stored of a block is whatever it was when a
//            question last looked
// Promise    a cell is never nearer than the true farthest depth of its pixels: depths only grow, so an old value is
//            too far at worst. hides() may say no of a hidden box, never yes of one that could win a pixel
// Frozen     complete() brings every cell up to date and ends the upkeep: from then on the cells alone answer, whatever
//            becomes of the pixels. For methods that ask about the frame before
// Cost       query: at most 2 x 2 cells of one level and a few pixels, more only where undecided; touched(): constant
//            for small boxes; push(): 64 pixels per tile and 4 cells per level that changes
// Source     Greene, Kass, Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993; docs/correctness.md, rules 1 to 3
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/fault.h"
#include "core/base/grid.h"
#include "core/depth/masked_layers.h"
#include "core/depth/triangle_cover.h"
#include "core/depth/visibility_buffer.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

/// What a query asked and found.
struct PyramidQuery {
    PixelBox box;
    float    nearest = 0;  // the nearest depth anything inside the box could have
    int      level   = 0;  // where it began: floor(log2(longer side)), or one more if that takes three cells a side
    // the farthest depth found on that level, in the cells that were asked, as they stand; 0 if none was
    float value  = 0;
    bool  hidden = false;
    int   cells  = 0;  // read to decide
};

/// A cell that has been computed anew; its value may be the same again.
struct CellWrite {
    int   level, x, y;
    float before, after;
};

/// Who is told of every cell written; at full speed nobody.
struct Untold {
    constexpr void operator()(const CellWrite&) const noexcept {}
};

/// From which side of a box its tiles are taken.
struct PushOrder {
    bool fromRight = false, fromBottom = false;
};

/// What a single tile answered.
struct TileAnswer {
    float farthest = 0;  // its farthest depth, as it stands
    bool  hidden   = false;
};

/// Which levels a pyramid has, and how it is kept true.
enum class PyramidKind {
    Deep,    // each level is half the one below, up to a single cell
    Masked,  // the same; takes cover(), and no pixel is read
    // tiles and blocks of them: for methods at full speed that ask, tell by touched() and drawnTile(), and break no
    // rule
    Wide,
};

/// A key with the farthest depth of those in `lines` lines of a tile's width each, `stride` keys from one to the next;
/// whose it is means nothing.
using LeastKey = PixelKey (*)(const PixelKey* first, std::ptrdiff_t stride, int lines);

class Pyramid {
public:
    static constexpr int kTileLevel = 3;  // tiles of 8 x 8 pixels
    /// So few pixels of a stale tile are read rather than all of it brought up to date.
    static constexpr int kFewPixels = 16;

    static constexpr int kBlockLevel = 6;  // of wide ones only: blocks of 64 x 64 pixels

    /// Begins a frame: the region has just been cleared, so every cell is empty and none is stale.
    /// `faults`: which rules of the pyramid are broken on purpose, if any; the promise above is gone then.
    void reset(const VisibilityBuffer& visible, int firstRow, int endRow, const FaultSet& faults = {},
               PyramidKind kind = PyramidKind::Deep);
    void reset(const VisibilityBuffer& visible, int firstRow, int endRow, PyramidKind kind)
    {
        reset(visible, firstRow, endRow, {}, kind);
    }

    /// From now on whole tiles are read so, side by side, and not pixel by pixel: whoever draws knows how wide the
    /// lanes are.
    void readTilesBy(LeastKey leastKey) { m_leastKey = leastKey; }

    /// Depths inside `box`, which lies in the region, may have grown.
    void touched(const PixelBox& box);
    /// The tile that holds (x, y) has been drawn to, and `farthest` is the farthest that its pixels hold now: who drew
    /// has seen them.
    template <class Told>
    void drawnTile(int x, int y, float farthest, const Told& told)
    {
        drawnTiles(x, y, std::span(&farthest, 1), told);
    }
    /// The same, and nobody is told. The cells above are stale then, whether the depth changed or not: that costs less
    /// than to ask.
    void drawnTile(int x, int y, float farthest)
    {
        const int column = x >> kTileLevel, line = (y - m_firstRow) >> kTileLevel;
        m_levels[0].farthest.at(column, line) = farthest;
        m_levels[0].stale.at(column, line)    = 0;
        markStaleFrom(kTileLevel + 1, column, line);
    }
    /// The same of as many tiles side by side as there are depths; the first holds (x, y).
    template <class Told>
    void drawnTiles(int x, int y, std::span<const float> farthest, const Told& told);
    /// True if nothing at depth `nearest` or farther could win a pixel of the tile that holds (x, y), by what is stored
    /// as it stands.
    bool hidesTile(int x, int y, float nearest) const
    {
        return isBehind(nearest, m_levels[0].farthest.at(x >> kTileLevel, (y - m_firstRow) >> kTileLevel));
    }
    /// What is stored of the tile that holds (x, y) and, behind it, of those to its right, as it stands.
    const float* storedTiles(int x, int y) const
    {
        return &m_levels[0].farthest.at(x >> kTileLevel, (y - m_firstRow) >> kTileLevel);
    }
    /// False if a rule is broken: what is wrong then is wrong with pixels that are read.
    bool takesTiles() const { return m_faults.isEmpty(); }
    /// The same as touched(), and every cell is brought up to date: after each tile its ancestors, as far as they
    /// change.
    template <class Told>
    void push(const PixelBox& box, const Told& told);
    /// The same, but all tiles first, so that the first way up from a group of tiles finds what the others would bring.
    template <class Told>
    void pushFrom(const PixelBox& box, PushOrder order, const Told& told);
    /// A triangle has been drawn over the pixels of `box` that `shape` covers; farthestOver(PixelBox) is a depth that
    /// it is not beyond in there. For a masked pyramid, in place of the others.
    template <class Shape, class FarthestOver, class Told>
    void cover(const PixelBox& box, const Shape& shape, const FarthestOver& farthestOver, const Told& told);
    /// All depths may have grown.
    void allTouched();
    /// The frame is over and will be asked about when its pixels are gone.
    void complete();
    /// Whether it is complete() and of a picture of this shape; if so, `visible` is the picture that is being drawn
    /// now.
    bool continues(const VisibilityBuffer& visible, int firstRow, int endRow);

    /// Becomes what `kept` was, over the picture that this one was reset over: one of the same shape.
    void restore(const Pyramid& kept);

    /// True if nothing at depth `nearest` or farther, inside `box` (not empty, inside the region), could win a pixel.
    bool         hides(const PixelBox& box, float nearest) { return ask(box, nearest).hidden; }
    PyramidQuery ask(const PixelBox& box, float nearest);
    /// The same of a shape inside the box (TriangleCover): only cells that it overlaps are asked, and of pixels those
    /// that it covers. told(CellWrite) is called right after each cell that is written on the way. Defined in
    /// pyramid_told.h.
    template <class Shape, class Told>
    PyramidQuery ask(const PixelBox& box, float nearest, const Shape& shape, const Told& told);

    // Of wide ones, for who asks them.
    bool                  isWide() const { return m_kind == PyramidKind::Wide; }
    int                   firstRow() const { return m_firstRow; }
    GridView<const float> tiles() const { return m_levels[0].farthest.view(); }
    /// A block may hold any depth that none of its pixels is beyond. 15 floats behind the last of a grid may be read.
    GridView<float> blocks() { return m_blocks.view(); }
    /// True if one of a few pixels of the box and of the shape shows that something at depth `nearest` could be seen.
    template <class Shape>
    bool showsAtOnce(const PixelBox& box, float nearest, const Shape& shape) const;
    /// True if nothing at that depth could be seen in the pixels that the box has of a tile, whose stored depth does
    /// not say so.
    template <class Shape>
    bool tileHides(int x, int y, const PixelBox& box, float nearest, const Shape& shape);

    /// A cruder answer from one level: no descent, and only the cells under the corners of the box, which may be too
    /// few.
    template <class Told>
    PyramidQuery askOneLevel(const PixelBox& box, float nearest, const Told& told);

    /// The same of a single tile, named by its first pixel: its farthest depth decides, brought up to date if it must
    /// be, and no pixel is asked.
    template <class Told>
    TileAnswer askTile(int left, int top, float nearest, const Told& told);
    /// The pixels of the tile that holds (x, y), those outside the region included.
    PixelBox tileAt(int x, int y) const;

    /// At most so many tiles are met by a box.
    static std::size_t tilesIn(const PixelBox& box)
    {
        const auto side = [](int length) { return static_cast<std::size_t>((length >> kTileLevel) + 2); };
        return side(box.x1 - box.x0) * side(box.y1 - box.y0);
    }

    int levels() const { return kTileLevel + static_cast<int>(m_levels.size()); }
    /// Stored values of a level from kTileLevel up, stale ones as they are.
    GridView<const float> stored(int level) const;

    std::size_t bytes() const;

private:
    struct Level {
        Grid<float>        farthest;
        Grid<std::uint8_t> stale;
    };

    PyramidQuery askAtCorners(const PixelBox& box, float nearest) const;
    template <class Told>
    PyramidQuery askElsewhere(PyramidQuery query, const Told& told);
    template <bool kLooksAtCorners, class Shape>
    bool shows(const PixelBox& box, float nearest, const Shape& shape) const;
    template <class Shape, class Told>
    bool cellsHide(PyramidQuery& query, const Shape& shape, const Told& told);
    bool isBehind(float nearest, float value) const
    {
        return nearest < value || (m_faults.has(Fault::EqualIsHidden) && nearest == value);
    }
    float kept(float a, float b) const { return m_faults.has(Fault::NearestInCells) == (a < b) ? b : a; }

    Level&   at(int level) { return m_levels[static_cast<std::size_t>(level - kTileLevel)]; }
    PixelBox pixelsOf(int level, int x, int y, const PixelBox& box) const;
    template <class Shape, class Told>
    bool cellHides(int level, int x, int y, const PixelBox& box, float nearest, const Shape& shape, const Told& told);
    template <class Shape>
    bool pixelsHide(const PixelBox& box, float nearest, const Shape& shape) const;
    template <class Told>
    float refresh(int level, int x, int y, const Told& told);
    template <class Shape>
    std::uint64_t maskOf(const PixelBox& pixels, const Shape& shape) const;
    /// The ancestors of a tile from a level upwards.
    void markStaleFrom(int level, int tileX, int tileY)
    {
        for (int up = level - kTileLevel; level < levels(); ++level, ++up) {
            std::uint8_t& stale = at(level).stale.at(tileX >> up, tileY >> up);
            if (stale) return;  // then all its ancestors are
            stale = 1;
        }
    }
    template <class Told>
    bool pushTile(int x, int y, const Told& told);
    template <class Told>
    void     pushUp(int tileX, int tileY, const Told& told);
    PixelBox tilesUnder(const PixelBox& box) const;
    template <class ValueOf>
    float farthestChild(int level, int x, int y, const ValueOf& valueOf);
    float farthestPixel(int tileX, int tileY) const;

    const VisibilityBuffer* m_visible    = nullptr;
    LeastKey                m_leastKey   = nullptr;  // or nullptr: pixel by pixel
    int                     m_firstRow   = 0;
    int                     m_endRow     = 0;
    int                     m_width      = 0;
    bool                    m_isComplete = false;
    // a question may look at the picture: it is this frame's, and no rule is broken
    bool                            m_readsPixels = false;
    std::vector<Level>              m_levels;         // from kTileLevel up
    std::vector<std::array<int, 2>> m_changed;        // tiles that the triangle at hand has changed
    int                             m_cellsRead = 0;  // by the query at hand
    FaultSet                        m_faults;
    PyramidKind                     m_kind = PyramidKind::Deep;
    MaskedLayers                    m_layers;  // of the tiles, if masked
    Grid<float>                     m_blocks;  // if wide
};

extern template void Pyramid::push(const PixelBox& box, const Untold& told);
extern template void Pyramid::pushFrom(const PixelBox& box, PushOrder order, const Untold& told);
extern template bool Pyramid::showsAtOnce(const PixelBox& box, float nearest, const WholeBox& shape) const;
extern template bool Pyramid::showsAtOnce(const PixelBox& box, float nearest, const TriangleCover& shape) const;
extern template bool Pyramid::tileHides(int x, int y, const PixelBox& box, float nearest, const WholeBox& shape);
extern template bool Pyramid::tileHides(int x, int y, const PixelBox& box, float nearest, const TriangleCover& shape);
extern template bool Pyramid::cellsHide(PyramidQuery& query, const WholeBox& shape, const Untold& told);
extern template bool Pyramid::cellsHide(PyramidQuery& query, const TriangleCover& shape, const Untold& told);

}  // namespace zscope
