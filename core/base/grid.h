// A rectangle of values in row-major order, and a borrowed view of one.
//
// Convention  (x, y) with y = 0 the top row, as in every picture of ZScope
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/large_pages.h"

namespace zscope {

/// Borrows width x height values; `stride` values lie between the starts of two rows.
template <class T>
struct GridView {
    T*          data   = nullptr;
    int         width  = 0;
    int         height = 0;
    std::size_t stride = 0;

    T&           at(int x, int y) const { return row(y)[static_cast<std::size_t>(x)]; }
    std::span<T> row(int y) const
    {
        assert(y >= 0 && y < height);
        return {data + static_cast<std::size_t>(y) * stride, static_cast<std::size_t>(width)};
    }
    operator GridView<const T>() const { return {data, width, height, stride}; }
};

/// Owns width x height values without padding. A large grid lies in large pages: entering small ones into the page
/// table takes longer than filling them.
template <class T>
class Grid {
public:
    Grid() = default;
    Grid(int width, int height, T value = {}) { reset(width, height, value); }

    /// `room`: so many values behind the last may be read, too.
    void reset(int width, int height, T value = {}, std::size_t room = 0)
    {
        assert(width >= 0 && height >= 0);
        m_width  = width;
        m_height = height;
        m_values.assign(count() + room, value);
    }

    int                width() const { return m_width; }
    int                height() const { return m_height; }
    T&                 at(int x, int y) { return view().at(x, y); }
    const T&           at(int x, int y) const { return view().at(x, y); }
    GridView<T>        view() { return {m_values.data(), m_width, m_height, static_cast<std::size_t>(m_width)}; }
    GridView<const T>  view() const { return {m_values.data(), m_width, m_height, static_cast<std::size_t>(m_width)}; }
    std::span<T>       values() { return std::span(m_values).first(count()); }
    std::span<const T> values() const { return std::span(m_values).first(count()); }

    friend bool operator==(const Grid&, const Grid&) = default;

private:
    std::size_t count() const { return static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height); }

    int                           m_width  = 0;
    int                           m_height = 0;
    std::vector<T, LargePages<T>> m_values;  // m_width * m_height of them, and room
};

}  // namespace zscope
