// The picture before it has colours: per pixel the depth of the winner and which triangle it is.
//
// Depth      n/z as float32 (or as DepthEncoding says), larger is nearer. Background holds a value just below
//            everything that may be kept, which makes the far test free; depthAt() reports it as 0
// Rank       triangle id + 1; 0 is background. On equal depth the lower rank wins, so background never does
// Rows       padded to kRowPadding values, so that a vector may be loaded at any pixel of the picture
// Promise    the winner is the maximum of (depth, -id) over all samples offered, in whatever order they come
// Source     docs/correctness.md, Depth and the winner
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/depth_format.h"
#include "core/base/grid.h"

namespace zscope {

/// Pixels past the end of a row that may be read and written as they were: one widest vector.
inline constexpr int kRowPadding = 16;

class VisibilityBuffer {
public:
    /// Sets the size; the contents are undefined until clearRows() has run over all rows.
    void resize(int width, int height, const DepthEncoding& encoding);
    /// Empties the rows [first, end). Rows are independent: threads may clear different ones.
    void clearRows(int first, int end);

    int   width() const { return m_width; }
    int   height() const { return m_height; }
    float empty() const { return m_encoding.empty; }

    float*               depthRow(int y) { return m_depth.data() + offset(y); }
    const float*         depthRow(int y) const { return m_depth.data() + offset(y); }
    std::uint32_t*       rankRow(int y) { return m_rank.data() + offset(y); }
    const std::uint32_t* rankRow(int y) const { return m_rank.data() + offset(y); }

    /// Depth as it is reported: near/z, 0 for background.
    float depthAt(int x, int y) const { return rankRow(y)[x] == 0 ? 0.0f : m_encoding.depthOf(depthRow(y)[x]); }
    /// Triangle id, or -1 for background.
    std::int64_t idAt(int x, int y) const { return static_cast<std::int64_t>(rankRow(y)[x]) - 1; }

    std::size_t bytes() const { return m_depth.capacity() * sizeof(float) + m_rank.capacity() * sizeof(std::uint32_t); }

private:
    std::size_t offset(int y) const { return static_cast<std::size_t>(y) * m_stride; }

    int                        m_width  = 0;
    int                        m_height = 0;
    std::size_t                m_stride = 0;  // >= m_width + kRowPadding
    DepthEncoding              m_encoding;
    std::vector<float>         m_depth;       // m_stride * m_height
    std::vector<std::uint32_t> m_rank;        // likewise
};

/// The reported picture, as the files ids.npy and depth.npy hold it.
struct Picture {
    Grid<std::int64_t> ids;    // -1 is background
    Grid<float>        depth;  // 0 is background

    friend bool operator==(const Picture&, const Picture&) = default;
};
Picture pictureOf(const VisibilityBuffer& visible);

}  // namespace zscope
