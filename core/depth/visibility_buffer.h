// The picture before it has colours: per pixel the depth of the winner and which triangle it is.
//
// Keys       a pixel's depth and triangle are one number (core/depth/pixel_key.h), the larger of two is the winner's
// Depth      n/z as float32 (or as DepthEncoding says), larger is nearer. Background holds a value just below
//            everything that may be kept, which makes the far test free; depthAt() reports it as 0
// Rows       padded to kRowPadding values, so that a vector may be loaded at any pixel of the picture; and an odd
//            number of rows to an even one. What is written there is read by nobody
// Emptying   costs what was drawn, not what there is: tiles of kTileWidth x kTileLines pixels know whether they were
//            drawn to. emptyRows() only forgets them; open() empties a tile when something is about to be drawn there,
//            while it is in the cache; finishRows() empties those that nothing was drawn to
// Planes     a tile whose pixels all show one triangle may be kept as that triangle's plane (setPlane()). Its keys are
//            not written before something else is drawn to it or storePlanes() writes what is left; until then row()
//            says nothing of its pixels, and what is told of single pixels is computed
// Stacked    a picture whose encoding lies above the last one's (core/base/depth_format.h) need not have its tiles
//            emptied: keys below the background's stand for it. Who reads row() has to know; keyAt() and what is told
//            of single pixels do
// Promise    the winner is the maximum of (depth, -id) over all samples offered, in whatever order they come
// Source     docs/correctness.md, Depth and the winner. Planes: Hasselgren, Akenine-Moller: Efficient Depth Buffer
//            Compression, Graphics Hardware 2006
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/depth_format.h"
#include "core/base/grid.h"
#include "core/base/large_pages.h"
#include "core/depth/pixel_key.h"
#include "core/depth/tile_plane.h"
#include "core/geometry/pixel_box.h"

namespace zscope {

/// Pixels past the end of a row that may be read and written as they were: one widest vector.
inline constexpr int kRowPadding = 16;

class VisibilityBuffer {
public:
    static constexpr int kTileWidth = 64, kTileLines = 8;

    /// When a tile is first drawn to, its pixels in `colours` get the colour of background; a tile that is kept as a
    /// plane gets none. For methods that store a colour where a fragment wins. Holds until the next resize().
    void colourOpened(GridView<std::uint32_t> colours, std::uint32_t background)
    {
        m_colours          = colours;
        m_backgroundColour = background;
    }

    /// Begins a picture. The contents are undefined until clearRows() has run over all rows, or emptyRows() and
    /// finishRows().
    void resize(int width, int height, const DepthEncoding& encoding);

    /// By which the next picture, `plain` but for its scale, need not be emptied for, wherever that can be.
    DepthEncoding encodingAbove(const DepthEncoding& plain) const { return plain.above(m_encoding); }

    // The rows [first, end) are whole lines of tiles, or end with the picture. Threads may work on different ones.
    void clearRows(int first, int end)
    {
        emptyRows(first, end);
        finishRows(first, end);
    }
    /// All pixels are background from now on, but only those of open tiles may be read or written.
    void emptyRows(int first, int end);
    /// Makes the tiles under the box ready to be drawn to; it lies in the picture. `store` writes the keys of planes,
    /// as keyAt() has them: called with the pixels of a tile and its plane.
    template <class Store>
    void open(const PixelBox& box, const Store& store)
    {
        if (box.isEmpty()) return;
        for (int y = box.y0 / kTileLines; y <= (box.y1 - 1) / kTileLines; ++y)
            for (int x = box.x0 / kTileWidth; x <= (box.x1 - 1) / kTileWidth; ++x) openTile(x, y, store);
    }
    void open(const PixelBox& box)
    {
        open(box, [this](const PixelBox& tile, const TilePlane& plane) { storePixels(tile, plane); });
    }
    /// True if the box, which lies in one tile, holds all of its pixels in the picture.
    bool isWholeTile(const PixelBox& box) const
    {
        return box.x0 % kTileWidth == 0 && box.y0 % kTileLines == 0 && (box.x1 % kTileWidth == 0 || box.x1 == m_width)
               && (box.y1 % kTileLines == 0 || box.y1 == m_height);
    }
    /// All pixels may be read, but those of planes.
    void finishRows(int first, int end);
    /// Those, too: no tile is kept as a plane any longer. `store` as in open().
    template <class Store>
    void storePlanes(int first, int end, const Store& store)
    {
        for (int y = first / kTileLines; y * kTileLines < end; ++y)
            for (int x = 0; x < m_tiles.width(); ++x)
                if (m_tiles.at(x, y) == Tile::Plane) openTile(x, y, store);
    }
    /// At most so many tiles are met by a box.
    static std::size_t tilesIn(const PixelBox& box)
    {
        return static_cast<std::size_t>(((box.x1 - box.x0) / kTileWidth + 2) * ((box.y1 - box.y0) / kTileLines + 2));
    }
    /// First column of the tiles that hold column x, first line of those that hold line y.
    static int leftOfTile(int x) { return x / kTileWidth * kTileWidth; }
    static int topOfTile(int y) { return y / kTileLines * kTileLines; }
    int        tileColumns() const { return m_tiles.width(); }
    int        tileRows() const { return m_tiles.height(); }
    /// False if nothing was drawn to the tile of the pixel, which is background then.
    bool isOpen(int x, int y) const { return m_tiles.at(x / kTileWidth, y / kTileLines) >= Tile::Drawn; }
    /// True if pixels of its tile may be drawn to.
    bool isDrawn(int x, int y) const { return m_tiles.at(x / kTileWidth, y / kTileLines) == Tile::Drawn; }
    /// What the tile of the pixel is kept as; nullptr if it is kept as pixels.
    const TilePlane* planeAt(int x, int y) const
    {
        x /= kTileWidth, y /= kTileLines;
        return m_tiles.at(x, y) == Tile::Plane ? &m_planes.at(x, y) : nullptr;
    }
    /// All pixels of the tile that holds (x, y) show this triangle, nearer than the background; what it held is
    /// forgotten.
    void setPlane(int x, int y, const TilePlane& plane)
    {
        x /= kTileWidth, y /= kTileLines;
        m_tiles.at(x, y)  = Tile::Plane;
        m_planes.at(x, y) = plane;
    }
    /// False if the pixel is background, but must not be read before finishRows().
    bool isReadable(int x, int y) const { return m_tiles.at(x / kTileWidth, y / kTileLines) != Tile::Stale; }

    int   width() const { return m_width; }
    int   height() const { return m_height; }
    float empty() const { return m_encoding.empty; }
    /// Whatever key is not larger is background.
    PixelKey background() const { return keyOf(m_encoding.empty, 0); }

    /// Keys from a pixel to the one below it.
    std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(m_stride); }

    // Of pixels that may be read and are not kept as planes.
    PixelKey*       row(int y) { return m_keys.data()->keys + offset(y); }
    const PixelKey* row(int y) const { return m_keys.data()->keys + offset(y); }

    /// Of any pixel that may be read.
    PixelKey keyAt(int x, int y) const
    {
        const TilePlane* plane = planeAt(x, y);
        return plane ? plane->keyAt(x, y) : std::max(row(y)[x], background());
    }
    /// 0 is background, else triangle id + 1.
    std::uint32_t rankAt(int x, int y) const { return rankOf(keyAt(x, y)); }
    /// Depth as the encoding stores it, and as it would at scale 1.
    float comparedAt(int x, int y) const { return depthOf(keyAt(x, y)); }
    float storedAt(int x, int y) const { return m_encoding.atScaleOne(comparedAt(x, y)); }
    /// Depth as it is reported: near/z, 0 for background.
    float depthAt(int x, int y) const { return rankAt(x, y) == 0 ? 0.0f : m_encoding.depthOf(comparedAt(x, y)); }
    /// Triangle id, or -1 for background.
    std::int64_t idAt(int x, int y) const { return static_cast<std::int64_t>(rankAt(x, y)) - 1; }

    std::size_t bytes() const { return m_keys.capacity() * sizeof(m_keys[0]) + m_planes.values().size_bytes(); }

private:
    enum class Tile : std::uint8_t {
        Stale,  // background, but memory holds something else
        Empty,  // all background: no key is larger
        Drawn,  // drawn to since emptyRows()
        Plane,  // the same, and kept as a plane: memory holds something else
    };

    template <class Store>
    void openTile(int x, int y, const Store& store)
    {
        Tile& tile = m_tiles.at(x, y);
        if (tile == Tile::Stale) clearTile(x, y);
        if (tile < Tile::Drawn && m_colours.data) clearColours(x, y);
        if (tile == Tile::Plane) store(pixelsOf(x, y), m_planes.at(x, y));
        tile = Tile::Drawn;
    }
    void clearTile(int x, int y);
    void clearColours(int x, int y);
    void storePixels(const PixelBox& tile, const TilePlane& plane);

    PixelBox pixelsOf(int x, int y) const
    {
        const int left = x * kTileWidth, top = y * kTileLines;
        return {left, top, std::min(left + kTileWidth, m_width), std::min(top + kTileLines, m_height)};
    }

    /// A cache line: rows begin on one, so that no aligned vector crosses a border. Its keys have no values at first:
    /// the thread that empties a tile is the first to touch its memory.
    struct alignas(64) CacheLine {
        CacheLine() {}  // "= default" would let a vector fill it with zeros
        PixelKey keys[64 / sizeof(PixelKey)];
    };

    std::size_t offset(int y) const { return static_cast<std::size_t>(y) * m_stride; }

    int                                           m_width  = 0;
    int                                           m_height = 0;
    std::size_t                                   m_stride = 0;  // >= m_width + kRowPadding
    DepthEncoding                                 m_encoding;
    Grid<Tile>                                    m_tiles;
    Grid<TilePlane>                               m_planes;   // of tiles that are kept as one
    GridView<std::uint32_t>                       m_colours;  // see colourOpened()
    std::uint32_t                                 m_backgroundColour = 0;
    std::vector<CacheLine, LargePages<CacheLine>> m_keys;  // m_stride * m_height of them, rounded up to even rows
};

/// The reported picture, as the files ids.npy and depth.npy hold it.
struct Picture {
    Grid<std::int64_t> ids;    // -1 is background
    Grid<float>        depth;  // 0 is background

    friend bool operator==(const Picture&, const Picture&) = default;
};
Picture pictureOf(const VisibilityBuffer& visible);

}  // namespace zscope
