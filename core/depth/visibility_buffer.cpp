#include "core/depth/visibility_buffer.h"

#include <algorithm>

namespace zscope {

void VisibilityBuffer::resize(int width, int height, const DepthEncoding& encoding)
{
    m_width  = width;
    m_height = height;
    m_stride = static_cast<std::size_t>((width + 2 * kRowPadding - 1) / kRowPadding * kRowPadding);
    m_encoding = encoding;
    m_depth.resize(m_stride * static_cast<std::size_t>(height));
    m_rank.resize(m_depth.size());
}

void VisibilityBuffer::clearRows(int first, int end)
{
    std::fill(m_depth.data() + offset(first), m_depth.data() + offset(end), empty());
    std::fill(m_rank.data() + offset(first), m_rank.data() + offset(end), 0u);
}

Picture pictureOf(const VisibilityBuffer& visible)
{
    Picture picture{Grid<std::int64_t>(visible.width(), visible.height()), Grid<float>(visible.width(), visible.height())};
    for (int y = 0; y < visible.height(); ++y) {
        for (int x = 0; x < visible.width(); ++x) {
            picture.ids.at(x, y)   = visible.idAt(x, y);
            picture.depth.at(x, y) = visible.depthAt(x, y);
        }
    }
    return picture;
}

}  // namespace zscope
