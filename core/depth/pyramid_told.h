// The pyramid's questions and its upkeep, cell by cell: one text for plain methods, which report each cell, and for the
// shortcuts, which report none.
//
// Told       called with a CellWrite right after the cell holds its new value; it may throw to end the run there
// Untold     pyramid.cpp instantiates this once for it. It looks at more pixels before cells: the same answers, but
//            fewer cells are brought up to date
#pragma once

#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>

#include "core/depth/pyramid.h"

namespace zscope {

/// The quick answers: what is stored says yes, or a pixel says no. Inlined where it is asked; what they leave undecided
/// is not.
template <class Shape, class Told>
[[gnu::always_inline]] inline PyramidQuery Pyramid::ask(const PixelBox& box, float nearest, const Shape& shape,
                                                        const Told& told)
{
    if (m_faults.has(Fault::CornersOnly)) return askAtCorners(box, nearest);
    const int    y0 = box.y0 - m_firstRow, y1 = box.y1 - 1 - m_firstRow, x0 = box.x0, x1 = box.x1 - 1;
    const auto   longest = static_cast<unsigned>(std::max(x1 - x0, y1 - y0)) + 1;
    PyramidQuery query{
        box, nearest, static_cast<int>(std::bit_width(longest)) - 1, std::numeric_limits<float>::infinity(), true, 0};
    int& level = query.level;
    if ((x1 >> level) - (x0 >> level) > 1 || (y1 >> level) - (y0 >> level) > 1) ++level;
    level = std::clamp(level, kTileLevel, levels() - 1);
    if (m_faults.has(Fault::LevelTooFine) || m_faults.has(Fault::LevelShifted)) return askElsewhere(query, told);

    const Grid<float>& farthest = at(level).farthest;
    for (int y = y0 >> level; y <= y1 >> level; ++y) {
        for (int x = x0 >> level; x <= x1 >> level; ++x) {
            if (!shape.overlaps(pixelsOf(level, x, y, box))) continue;
            query.value = std::min(query.value, farthest.at(x, y));
            ++query.cells;
        }
    }
    if (query.cells == 0)
        query.value = 0;
    else if (!isBehind(nearest, query.value))
        query.hidden = !shows<std::is_same_v<Told, Untold>>(box, nearest, shape) && cellsHide(query, shape, told);
    return query;
}

/// True if the pixel in the middle of the box, or one in its corners if they are looked at, is enough to know that
/// something could be seen.
template <bool kLooksAtCorners, class Shape>
bool Pyramid::shows(const PixelBox& box, float nearest, const Shape& shape) const
{
    if (!m_readsPixels) return false;
    const auto showsAt = [&](int x, int y) {
        return shape.covers(x, y) && (!m_visible->isReadable(x, y) || !isBehind(nearest, m_visible->comparedAt(x, y)));
    };
    if (showsAt((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)) return true;
    const int right = box.x1 - 1, bottom = box.y1 - 1;
    return kLooksAtCorners
           && (showsAt(box.x0, box.y0) || showsAt(right, box.y0) || showsAt(box.x0, bottom) || showsAt(right, bottom));
}

/// Cell by cell, each brought up to date if it must be. The query's value becomes what they hold then.
template <class Shape, class Told>
bool Pyramid::cellsHide(PyramidQuery& query, const Shape& shape, const Told& told)
{
    const PixelBox& box   = query.box;
    const int       level = query.level, y0 = box.y0 - m_firstRow, y1 = box.y1 - 1 - m_firstRow;
    bool            hidden = true;
    m_cellsRead            = 0;
    query.value            = std::numeric_limits<float>::infinity();
    for (int y = y0 >> level; y <= y1 >> level; ++y) {
        for (int x = box.x0 >> level; x <= (box.x1 - 1) >> level; ++x) {
            if (!shape.overlaps(pixelsOf(level, x, y, box))) continue;
            hidden      = hidden && cellHides(level, x, y, box, query.nearest, shape, told);
            query.value = std::min(query.value, at(level).farthest.at(x, y));
        }
    }
    query.cells = m_cellsRead;
    return hidden;
}

template <class Told>
void Pyramid::drawnTiles(int x, int y, std::span<const float> farthest, const Told& told)
{
    Level&    tiles  = at(kTileLevel);
    const int line   = (y - m_firstRow) >> kTileLevel;
    int       column = x >> kTileLevel;
    for (const float now : farthest) {
        tiles.stale.at(column, line) = 0;  // its ancestors stay what they are
        float&      value            = tiles.farthest.at(column, line);
        const float before           = value;
        if (now != before) {
            value = now;
            markStaleFrom(kTileLevel + 1, column, line);
            told(CellWrite{kTileLevel, column, line, before, now});
        }
        ++column;
    }
}

template <class Told>
TileAnswer Pyramid::askTile(int left, int top, float nearest, const Told& told)
{
    const int   x = left >> kTileLevel, y = (top - m_firstRow) >> kTileLevel;
    const float asItWas = at(kTileLevel).farthest.at(x, y);
    if (isBehind(nearest, asItWas)) return {asItWas, true};
    const float farthest = refresh(kTileLevel, x, y, told);
    return {farthest, isBehind(nearest, farthest)};
}

/// Of a cell that the shape overlaps.
template <class Shape, class Told>
bool Pyramid::cellHides(int level, int x, int y, const PixelBox& box, float nearest, const Shape& shape,
                        const Told& told)
{
    ++m_cellsRead;
    if (isBehind(nearest, at(level).farthest.at(x, y))) return true;
    const PixelBox within = pixelsOf(level, x, y, box);
    const bool     isFew =
        level == kTileLevel && m_readsPixels && (within.x1 - within.x0) * (within.y1 - within.y0) <= kFewPixels;
    if (!isFew && at(level).stale.at(x, y) && isBehind(nearest, refresh(level, x, y, told))) return true;

    // Undecided: something in the cell is as far or farther. Is it inside the shape?
    if (level == kTileLevel && m_isComplete) return false;                   // its pixels are another frame's now
    if (level == kTileLevel && m_kind == PyramidKind::Masked) return false;  // its pixels are nobody's to read
    if (level == kTileLevel) return pixelsHide(within, nearest, shape);
    const int below = level - 1;
    const int x0 = std::max(2 * x, box.x0 >> below), x1 = std::min(2 * x + 1, (box.x1 - 1) >> below);
    const int y0 = std::max(2 * y, (box.y0 - m_firstRow) >> below),
              y1 = std::min(2 * y + 1, (box.y1 - 1 - m_firstRow) >> below);
    for (int childY = y0; childY <= y1; ++childY)
        for (int childX = x0; childX <= x1; ++childX)
            if (shape.overlaps(pixelsOf(below, childX, childY, box))
                && !cellHides(below, childX, childY, box, nearest, shape, told))
                return false;
    return true;
}

template <class Shape>
bool Pyramid::showsAtOnce(const PixelBox& box, float nearest, const Shape& shape) const
{
    return shows<true>(box, nearest, shape);
}

template <class Shape>
bool Pyramid::tileHides(int x, int y, const PixelBox& box, float nearest, const Shape& shape)
{
    const PixelBox within = pixelsOf(kTileLevel, x, y, box);
    if (!shape.overlaps(within)) return true;
    const int pixels = (within.x1 - within.x0) * (within.y1 - within.y0);
    if (pixels > kFewPixels && m_levels[0].stale.at(x, y) && nearest < refresh(kTileLevel, x, y, Untold{})) return true;
    // one of them is as far as what is stored now
    if (std::is_same_v<Shape, WholeBox> && pixels == 1 << 2 * kTileLevel) return false;
    return pixelsHide(within, nearest, shape);
}

template <class Shape>
bool Pyramid::pixelsHide(const PixelBox& box, float nearest, const Shape& shape) const
{
    if (!m_visible->isReadable(box.x0, box.y0)) return false;  // nothing is drawn here
    if (const TilePlane* plane = m_visible->planeAt(box.x0, box.y0))
        return isBehind(nearest, farthestOver(plane->depth, box));
    for (int y = box.y0; y < box.y1; ++y) {
        const PixelKey* row = m_visible->row(y);
        for (int x = box.x0; x < box.x1; ++x)
            if (!isBehind(nearest, depthOf(row[x])) && shape.covers(x, y)) return false;
    }
    return true;
}

/// Brings a stale cell, and what it is computed from, up to date.
template <class Told>
float Pyramid::refresh(int level, int x, int y, const Told& told)
{
    Level&        here  = at(level);
    std::uint8_t& stale = here.stale.at(x, y);
    float&        value = here.farthest.at(x, y);
    if (!stale) return value;
    const float before = value;
    value = level == kTileLevel ? farthestPixel(x, y) : farthestChild(level, x, y, [&](int childX, int childY) {
        const Level& below = at(level - 1);
        return below.stale.at(childX, childY) ? refresh(level - 1, childX, childY, told)
                                              : below.farthest.at(childX, childY);
    });
    stale = 0;
    told(CellWrite{level, x, y, before, value});
    return value;
}

template <class Told>
PyramidQuery Pyramid::askOneLevel(const PixelBox& box, float nearest, const Told& told)
{
    const auto   longest = static_cast<unsigned>(std::max(box.x1 - box.x0, box.y1 - box.y0));
    PyramidQuery query{
        box, nearest, static_cast<int>(std::bit_width(longest)) - 1, std::numeric_limits<float>::infinity(), false, 0};
    query.level  = std::clamp(query.level, kTileLevel, levels() - 1);
    const int x0 = box.x0 >> query.level, x1 = (box.x1 - 1) >> query.level;
    const int y0 = (box.y0 - m_firstRow) >> query.level, y1 = (box.y1 - 1 - m_firstRow) >> query.level;
    for (int y = y0; y <= y1; y += std::max(1, y1 - y0))
        for (int x = x0; x <= x1; x += std::max(1, x1 - x0)) {
            query.value = std::min(query.value, refresh(query.level, x, y, told));
            ++query.cells;
        }
    query.hidden = isBehind(nearest, query.value);
    return query;
}

/// Faults on purpose: the cells under the corners of the box, of a level on which they do not cover it; or cells at the
/// coordinates of the next level, which are other cells. What they hold decides.
template <class Told>
PyramidQuery Pyramid::askElsewhere(PyramidQuery query, const Told& told)
{
    if (m_faults.has(Fault::LevelTooFine)) query.level = std::max(query.level - 1, kTileLevel);
    const int shift = query.level + (m_faults.has(Fault::LevelShifted) ? 1 : 0);
    for (const int y : {query.box.y0 - m_firstRow, query.box.y1 - 1 - m_firstRow})
        for (const int x : {query.box.x0, query.box.x1 - 1}) {
            query.value = std::min(query.value, refresh(query.level, x >> shift, y >> shift, told));
            ++query.cells;
        }
    query.hidden = isBehind(query.nearest, query.value);
    return query;
}

/// The pixels of a tile, which lie in `pixels`, that the shape covers: bit 8 y + x.
template <class Shape>
std::uint64_t Pyramid::maskOf(const PixelBox& pixels, const Shape& shape) const
{
    constexpr int kTile = 1 << kTileLevel;
    std::uint64_t mask  = 0;
    for (int y = pixels.y0; y < pixels.y1; ++y)
        for (int x = pixels.x0; x < pixels.x1; ++x)
            mask |= std::uint64_t{shape.covers(x, y)} << (kTile * ((y - m_firstRow) % kTile) + x % kTile);
    return mask;
}

template <class Shape, class FarthestOver, class Told>
void Pyramid::cover(const PixelBox& box, const Shape& shape, const FarthestOver& farthestOver, const Told& told)
{
    const PixelBox tiles = tilesUnder(box), region{0, m_firstRow, m_visible->width(), m_endRow};
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x) {
            const PixelBox touched = pixelsOf(kTileLevel, x, y, box);
            if (!shape.overlaps(touched)) continue;
            float&     value = at(kTileLevel).farthest.at(x, y);
            const auto reference =
                m_layers.cover(x, y, maskOf(touched, shape), maskOf(pixelsOf(kTileLevel, x, y, region), WholeBox{}),
                               farthestOver(touched), value);
            if (!reference) continue;
            const float before = value;
            value              = *reference;
            markStaleFrom(kTileLevel + 1, x, y);
            told(CellWrite{kTileLevel, x, y, before, value});
        }
}

/// Whether the tile changed.
template <class Told>
bool Pyramid::pushTile(int x, int y, const Told& told)
{
    float&      value  = at(kTileLevel).farthest.at(x, y);
    const float before = value;
    value              = farthestPixel(x, y);
    told(CellWrite{kTileLevel, x, y, before, value});
    return value != before;
}

/// From a tile that has changed upwards, to the first ancestor that does not.
template <class Told>
void Pyramid::pushUp(int tileX, int tileY, const Told& told)
{
    for (int level = kTileLevel + 1, up = 1; level < levels(); ++level, ++up) {
        const int   x = tileX >> up, y = tileY >> up;
        float&      value  = at(level).farthest.at(x, y);
        const float before = value;
        const auto& below  = at(level - 1).farthest;
        value = farthestChild(level, x, y, [&](int childX, int childY) { return below.at(childX, childY); });
        told(CellWrite{level, x, y, before, value});
        if (value == before) return;
    }
}

template <class Told>
void Pyramid::push(const PixelBox& box, const Told& told)
{
    const PixelBox tiles = tilesUnder(box);
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x)
            if (pushTile(x, y, told)) pushUp(x, y, told);
}

template <class Told>
void Pyramid::pushFrom(const PixelBox& box, PushOrder order, const Told& told)
{
    const PixelBox tiles = tilesUnder(box);
    m_changed.clear();
    const int width = tiles.x1 - tiles.x0, height = tiles.y1 - tiles.y0;
    for (int row = 0; row < height; ++row) {
        const int y = order.fromBottom ? tiles.y1 - 1 - row : tiles.y0 + row;
        for (int column = 0; column < width; ++column) {
            const int x = order.fromRight ? tiles.x1 - 1 - column : tiles.x0 + column;
            if (pushTile(x, y, told)) m_changed.push_back({x, y});
        }
    }
    for (const auto& [x, y] : m_changed) pushUp(x, y, told);
}

/// Of the children of a cell above the tiles; `valueOf(childX, childY)` is what a child holds.
template <class ValueOf>
float Pyramid::farthestChild(int level, int x, int y, const ValueOf& valueOf)
{
    const Level& below = at(level - 1);
    const int endX = std::min(2 * x + 2, below.farthest.width()), endY = std::min(2 * y + 2, below.farthest.height());
    if (m_faults.has(Fault::OddPadded) && (endX - 2 * x < 2 || endY - 2 * y < 2))
        return std::numeric_limits<float>::infinity();
    float all = valueOf(2 * x, 2 * y);
    for (int childY = 2 * y; childY < endY; ++childY)
        for (int childX = 2 * x; childX < endX; ++childX) all = kept(all, valueOf(childX, childY));
    return all;
}

}  // namespace zscope
