#include "core/depth/pyramid_told.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace zscope {

namespace {

int halved(int size) { return (size + 1) / 2; }

constexpr std::size_t kRoom = 16;  // floats that lanes may read behind the last

}  // namespace

void Pyramid::reset(const VisibilityBuffer& visible, int firstRow, int endRow, const FaultSet& faults, PyramidKind kind)
{
    m_kind              = kind;
    m_faults            = faults;
    m_visible           = &visible;
    m_firstRow          = firstRow;
    m_endRow            = endRow;
    m_width             = visible.width();
    m_isComplete        = false;
    constexpr int kTile = 1 << kTileLevel;
    static_assert(VisibilityBuffer::kTileWidth % kTile == 0 && VisibilityBuffer::kTileLines % kTile == 0,
                  "a tile is readable or not, as a whole");
    assert(firstRow % kTile == 0);
    int         width = (visible.width() + kTile - 1) / kTile, height = (endRow - firstRow + kTile - 1) / kTile;
    std::size_t count = 0;
    for (;; width = halved(width), height = halved(height)) {
        if (m_levels.size() == count) m_levels.emplace_back();
        m_levels[count].farthest.reset(width, height, visible.empty(), kRoom);
        m_levels[count].stale.reset(width, height, 0);
        ++count;
        if (isWide() || (width <= 1 && height <= 1)) break;
    }
    m_levels.resize(count);
    if (isWide()) {
        assert(faults.isEmpty());
        const auto blocks = [](int tiles) {
            return (tiles + (1 << (kBlockLevel - kTileLevel)) - 1) >> (kBlockLevel - kTileLevel);
        };
        m_blocks.reset(blocks(width), blocks(height), visible.empty(), kRoom);
    }
    m_readsPixels = kind != PyramidKind::Masked && faults.isEmpty();
    if (kind == PyramidKind::Masked) m_layers.reset(m_levels[0].farthest.width(), m_levels[0].farthest.height());
}

PyramidQuery Pyramid::ask(const PixelBox& box, float nearest) { return ask(box, nearest, WholeBox{}, Untold{}); }

void Pyramid::touched(const PixelBox& box)
{
    // Level by level, all cells of a level alike: which of them were stale already, nobody could predict. If all were,
    // so are their ancestors.
    const PixelBox tiles = tilesUnder(box);
    int            up    = 0;
    for (Level& level : m_levels) {
        std::uint8_t wereStale = 1;
        for (int y = tiles.y0 >> up; y <= (tiles.y1 - 1) >> up; ++y)
            for (int x = tiles.x0 >> up; x <= (tiles.x1 - 1) >> up; ++x)
                wereStale &= std::exchange(level.stale.at(x, y), std::uint8_t{1});
        if (wereStale) return;
        ++up;
    }
}

PixelBox Pyramid::tilesUnder(const PixelBox& box) const
{
    return {box.x0 >> kTileLevel, (box.y0 - m_firstRow) >> kTileLevel, ((box.x1 - 1) >> kTileLevel) + 1,
            ((box.y1 - 1 - m_firstRow) >> kTileLevel) + 1};
}

void Pyramid::restore(const Pyramid& kept)
{
    const VisibilityBuffer* visible = m_visible;
    *this                           = kept;
    m_visible                       = visible;
}

void Pyramid::allTouched()
{
    for (Level& level : m_levels) std::ranges::fill(level.stale.values(), std::uint8_t{1});
}

PixelBox Pyramid::tileAt(int x, int y) const
{
    const int left = x >> kTileLevel << kTileLevel, top = m_firstRow + ((y - m_firstRow) >> kTileLevel << kTileLevel);
    return {left, top, left + (1 << kTileLevel), top + (1 << kTileLevel)};
}

void Pyramid::complete()
{
    allTouched();
    refresh(levels() - 1, 0, 0, Untold{});  // reaches every cell below
    m_isComplete  = true;
    m_readsPixels = false;
}

bool Pyramid::continues(const VisibilityBuffer& visible, int firstRow, int endRow)
{
    m_visible = &visible;
    return m_isComplete && m_width == visible.width() && m_firstRow == firstRow && m_endRow == endRow;
}

/// The pixels of a cell that lie in the box.
PixelBox Pyramid::pixelsOf(int level, int x, int y, const PixelBox& box) const
{
    const int left = x << level, top = m_firstRow + (y << level), side = 1 << level;
    return {std::max(box.x0, left), std::max(box.y0, top), std::min(box.x1, left + side), std::min(box.y1, top + side)};
}

/// A fault on purpose: what shows through between the corners is not seen.
PyramidQuery Pyramid::askAtCorners(const PixelBox& box, float nearest) const
{
    PyramidQuery query{box, nearest, 0, std::numeric_limits<float>::infinity(), true, 4};
    for (const int y : {box.y0, box.y1 - 1})
        for (const int x : {box.x0, box.x1 - 1})
            query.value =
                std::min(query.value, m_visible->isReadable(x, y) ? m_visible->comparedAt(x, y) : m_visible->empty());
    query.hidden = isBehind(nearest, query.value);
    return query;
}

float Pyramid::farthestPixel(int tileX, int tileY) const
{
    constexpr int kTile = 1 << kTileLevel;
    const int     x0 = tileX << kTileLevel, x1 = std::min(x0 + kTile, m_visible->width());
    const int     y0 = m_firstRow + (tileY << kTileLevel), y1 = std::min(y0 + kTile, m_endRow);
    if (m_faults.has(Fault::OddPadded) && (x1 - x0 < kTile || y1 - y0 < kTile))
        return std::numeric_limits<float>::infinity();
    if (!m_visible->isReadable(x0, y0)) return m_visible->empty();
    if (const TilePlane* plane = m_visible->planeAt(x0, y0); plane && !m_faults.has(Fault::NearestInCells))
        return farthestOver(plane->depth, {x0, y0, x1, y1});
    if (x1 - x0 == kTile && m_leastKey && !m_faults.has(Fault::NearestInCells))
        return depthOf(
            std::max(m_leastKey(m_visible->row(y0) + x0, m_visible->stride(), y1 - y0), m_visible->background()));
    float all = m_visible->comparedAt(x0, y0);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) all = kept(all, m_visible->comparedAt(x, y));
    return all;
}

GridView<const float> Pyramid::stored(int level) const
{
    return m_levels[static_cast<std::size_t>(level - kTileLevel)].farthest.view();
}

template void Pyramid::push(const PixelBox& box, const Untold& told);
template void Pyramid::pushFrom(const PixelBox& box, PushOrder order, const Untold& told);
template bool Pyramid::showsAtOnce(const PixelBox& box, float nearest, const WholeBox& shape) const;
template bool Pyramid::showsAtOnce(const PixelBox& box, float nearest, const TriangleCover& shape) const;
template bool Pyramid::tileHides(int x, int y, const PixelBox& box, float nearest, const WholeBox& shape);
template bool Pyramid::tileHides(int x, int y, const PixelBox& box, float nearest, const TriangleCover& shape);
template bool Pyramid::cellsHide(PyramidQuery& query, const WholeBox& shape, const Untold& told);
template bool Pyramid::cellsHide(PyramidQuery& query, const TriangleCover& shape, const Untold& told);

std::size_t Pyramid::bytes() const
{
    std::size_t total = m_layers.bytes() + m_blocks.values().size_bytes() + m_changed.capacity() * sizeof(m_changed[0]);
    for (const Level& level : m_levels)
        total += level.farthest.values().size_bytes() + level.stale.values().size_bytes();
    return total;
}

}  // namespace zscope
