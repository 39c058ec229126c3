// The picture before it has colours: per pixel the depth of the winner and which triangle it is.
//
// Keys       a pixel's depth and triangle are one number (core/depth/pixel_key.h), the larger of two is the winner's
// Depth      n/z as float32 (or as DepthEncoding says), larger is nearer. Background holds a value just below
//            everything that may be kept, which makes the far test free; depthAt() reports it as 0
// Rows       padded to kRowPadding values, so that a vector may be loaded at any pixel of the picture; and an odd number of
//            rows to an even one. What is written there is read by nobody
// Emptying   costs what was drawn, not what there is: tiles of kTileWidth x kTileLines pixels know whether they were drawn
//            to. emptyRows() only forgets them; open() empties a tile when something is about to be drawn there, while it is
//            in the cache; finishRows() empties those that nothing was drawn to. Who draws over all of a tile may leave the
//            emptying out (openToDrawOver()) and say whose it is (setSoleRank()), which holds until something else opens it
// Promise    the winner is the maximum of (depth, -id) over all samples offered, in whatever order they come
// Source     docs/correctness.md, Depth and the winner
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/depth_format.h"
#include "core/base/grid.h"
#include "core/depth/pixel_key.h"
#include "core/geometry/pixel_box.h"

namespace zscope {

/// Pixels past the end of a row that may be read and written as they were: one widest vector.
inline constexpr int kRowPadding = 16;

class VisibilityBuffer {
public:
    static constexpr int kTileWidth = 64, kTileLines = 8;

    /// Sets the size; the contents are undefined until clearRows() has run over all rows, or emptyRows() and finishRows().
    void resize(int width, int height, const DepthEncoding& encoding);

    // The rows [first, end) are whole lines of tiles, or end with the picture. Threads may work on different ones.
    void clearRows(int first, int end)
    {
        emptyRows(first, end);
        finishRows(first, end);
    }
    /// All pixels are background from now on, but only those of open tiles may be read or written.
    void emptyRows(int first, int end);
    /// Makes the tiles under the box ready to be drawn to; it lies in the picture.
    void open(const PixelBox& box)
    {
        if (box.isEmpty()) return;
        for (int y = box.y0 / kTileLines; y <= (box.y1 - 1) / kTileLines; ++y)
            for (int x = box.x0 / kTileWidth; x <= (box.x1 - 1) / kTileWidth; ++x) openTile(x, y);
    }
    /// Makes one tile ready for who is about to draw over all of its pixels in the picture. If true, nothing was drawn to it since
    /// emptyRows() and what it holds must not be read.
    bool openToDrawOver(const PixelBox& tile)
    {
        Tile&      at       = m_tiles.at(tile.x0 / kTileWidth, tile.y0 / kTileLines);
        const bool wasDrawn = at >= Tile::Drawn;
        at                  = Tile::Drawn;
        return !wasDrawn;
    }
    /// True if the box, which lies in one tile, holds all of its pixels in the picture.
    bool isWholeTile(const PixelBox& box) const
    {
        return box.x0 % kTileWidth == 0 && box.y0 % kTileLines == 0 && (box.x1 % kTileWidth == 0 || box.x1 == m_width) &&
               (box.y1 % kTileLines == 0 || box.y1 == m_height);
    }
    /// All pixels may be read.
    void finishRows(int first, int end);
    int tileColumns() const { return m_tiles.width(); }
    int tileRows() const { return m_tiles.height(); }
    /// False if nothing was drawn to the tile of the pixel, which is background then.
    bool isOpen(int x, int y) const { return m_tiles.at(x / kTileWidth, y / kTileLines) >= Tile::Drawn; }
    /// If all pixels of the tile are known to show one triangle, its rank; else 0.
    std::uint32_t soleRank(int x, int y) const
    {
        return m_tiles.at(x / kTileWidth, y / kTileLines) == Tile::Sole ? m_soleRanks.at(x / kTileWidth, y / kTileLines) : 0;
    }
    /// Tells that of the tile that holds (x, y), which is open.
    void setSoleRank(int x, int y, std::uint32_t rank)
    {
        m_tiles.at(x / kTileWidth, y / kTileLines)     = Tile::Sole;
        m_soleRanks.at(x / kTileWidth, y / kTileLines) = rank;
    }
    /// False if the pixel is background, but must not be read before finishRows().
    bool isReadable(int x, int y) const { return m_tiles.at(x / kTileWidth, y / kTileLines) != Tile::Stale; }

    int   width() const { return m_width; }
    int   height() const { return m_height; }
    float empty() const { return m_encoding.empty; }

    /// Keys from a pixel to the one below it.
    std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(m_stride); }

    PixelKey*       row(int y) { return m_keys.data()->keys + offset(y); }
    const PixelKey* row(int y) const { return m_keys.data()->keys + offset(y); }

    /// 0 is background, else triangle id + 1.
    std::uint32_t rankAt(int x, int y) const { return rankOf(row(y)[x]); }
    /// Depth as the encoding stores it.
    float storedAt(int x, int y) const { return depthOf(row(y)[x]); }
    /// Depth as it is reported: near/z, 0 for background.
    float depthAt(int x, int y) const { return rankAt(x, y) == 0 ? 0.0f : m_encoding.depthOf(storedAt(x, y)); }
    /// Triangle id, or -1 for background.
    std::int64_t idAt(int x, int y) const { return static_cast<std::int64_t>(rankAt(x, y)) - 1; }

    std::size_t bytes() const { return m_keys.capacity() * sizeof(m_keys[0]); }

private:
    enum class Tile : std::uint8_t {
        Stale,  // background, but memory holds something else
        Empty,  // all background
        Drawn,  // drawn to since emptyRows()
        Sole,   // the same, all of it by one triangle
    };

    void openTile(int x, int y)
    {
        Tile& tile = m_tiles.at(x, y);
        if (tile == Tile::Stale) clearTile(x, y);
        tile = Tile::Drawn;
    }
    void clearTile(int x, int y);

    /// A cache line: rows begin on one, so that no aligned vector crosses a border.
    struct alignas(64) CacheLine {
        PixelKey keys[64 / sizeof(PixelKey)];
    };

    std::size_t offset(int y) const { return static_cast<std::size_t>(y) * m_stride; }

    int                    m_width  = 0;
    int                    m_height = 0;
    std::size_t            m_stride = 0;  // >= m_width + kRowPadding
    DepthEncoding          m_encoding;
    Grid<Tile>             m_tiles;
    Grid<std::uint32_t>    m_soleRanks;  // of tiles that are Sole
    std::vector<CacheLine> m_keys;  // m_stride * m_height of them, rounded up to even rows
};

/// The reported picture, as the files ids.npy and depth.npy hold it.
struct Picture {
    Grid<std::int64_t> ids;    // -1 is background
    Grid<float>        depth;  // 0 is background

    friend bool operator==(const Picture&, const Picture&) = default;
};
Picture pictureOf(const VisibilityBuffer& visible);

}  // namespace zscope
