#include "core/depth/visibility_buffer.h"

#include <algorithm>

namespace zscope {

void VisibilityBuffer::resize(int width, int height, const DepthEncoding& encoding)
{
    const bool isSameSize = width == m_width && height == m_height;
    // Whose tiles must be emptied, though the last picture's lie above others.
    const bool emptiesMore = m_encoding.isBounded && !encoding.isBounded;
    const bool isSame      = isSameSize && encoding.empty == m_encoding.empty && !emptiesMore,
               isAbove     = isSameSize && encoding.isAbove(m_encoding);
    m_encoding             = encoding;
    m_colours              = {};
    if (isSame) return;
    if (isAbove) {  // what was drawn lies below the background now; what planes lie over may be anything
        for (Tile& tile : m_tiles.values())
            if (tile >= Tile::Drawn) tile = tile == Tile::Plane ? Tile::Stale : Tile::Empty;
        return;
    }
    m_width = m_height = 0;  // what follows may run out of memory
    m_stride           = static_cast<std::size_t>((width + 2 * kRowPadding - 1) / kRowPadding * kRowPadding);
    m_keys.resize(m_stride * static_cast<std::size_t>((height + 1) / 2 * 2) * sizeof(PixelKey) / sizeof(CacheLine));
    m_tiles.reset((width + kTileWidth - 1) / kTileWidth, (height + kTileLines - 1) / kTileLines, Tile::Stale);
    m_planes.reset(m_tiles.width(), m_tiles.height(), {});
    m_width  = width;
    m_height = height;
}

void VisibilityBuffer::emptyRows(int first, int end)
{
    for (int y = first / kTileLines; y * kTileLines < end; ++y)
        for (Tile& tile : m_tiles.view().row(y))
            if (tile >= Tile::Drawn) tile = Tile::Stale;
}

void VisibilityBuffer::finishRows(int first, int end)
{
    for (int y = first / kTileLines; y * kTileLines < end; ++y)
        for (int x = 0; x < m_tiles.width(); ++x) {
            Tile& tile = m_tiles.at(x, y);
            if (tile != Tile::Stale) continue;
            clearTile(x, y);
            tile = Tile::Empty;
        }
}

void VisibilityBuffer::clearTile(int x, int y)
{
    const int left = x * kTileWidth, width = std::min(kTileWidth, static_cast<int>(m_stride) - left);
    for (int line = y * kTileLines; line < std::min((y + 1) * kTileLines, m_height); ++line)
        std::fill_n(row(line) + left, width, background());
}

void VisibilityBuffer::clearColours(int x, int y)
{
    const PixelBox tile = pixelsOf(x, y);
    for (int line = tile.y0; line < tile.y1; ++line)
        std::fill_n(m_colours.row(line).data() + tile.x0, tile.x1 - tile.x0, m_backgroundColour);
}

void VisibilityBuffer::storePixels(const PixelBox& tile, const TilePlane& plane)
{
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) row(y)[x] = plane.keyAt(x, y);
}

Picture pictureOf(const VisibilityBuffer& visible)
{
    Picture picture{Grid<std::int64_t>(visible.width(), visible.height()),
                    Grid<float>(visible.width(), visible.height())};
    for (int y = 0; y < visible.height(); ++y) {
        for (int x = 0; x < visible.width(); ++x) {
            picture.ids.at(x, y)   = visible.idAt(x, y);
            picture.depth.at(x, y) = visible.depthAt(x, y);
        }
    }
    return picture;
}

}  // namespace zscope
