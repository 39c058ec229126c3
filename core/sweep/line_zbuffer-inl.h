// Resolves a line of the sweep with a one-line z-buffer: the line of the visibility buffer that is being drawn.
//
// Idea       each active polygon covers the pixels between its two edges on this line; offer them to the depth test
// Cost       the pixels of all active polygons on the line, hidden ones included
#if defined(ZSCOPE_LINE_ZBUFFER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_LINE_ZBUFFER_INL_H
#undef ZSCOPE_LINE_ZBUFFER_INL_H
#else
#define ZSCOPE_LINE_ZBUFFER_INL_H
#endif

#include <limits>
#include <span>
#include <vector>

#include "core/scan/depth_test-inl.h"
#include "core/sweep/sweep_events.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

class LineZBuffer {
public:
    /// `openAt` is scratch memory, one entry per part, reused from band to band.
    LineZBuffer(VisibilityBuffer& visible, std::vector<int>& openAt, std::size_t parts) : m_visible(visible), m_openAt(openAt)
    {
        m_openAt.assign(parts, kClosed);
    }

    template <class Probe>
    void line(int y, std::span<const ActiveEdge> active, std::span<const ScreenTriangle> parts, const Probe& probe)
    {
        m_visible.clearRows(y, y + 1);
        for (const ActiveEdge& edge : active) {
            const int pixel = edge.firstPixel();
            int&      open  = m_openAt[edge.part()];
            if (open == kClosed) {
                open = pixel;
                continue;
            }
            const ScreenTriangle& part = parts[edge.part()];
            fillSpan(part, y, std::max(open, part.box.x0), std::min(pixel, part.box.x1), m_visible, probe);
            open = kClosed;
        }
    }

private:
    static constexpr int kClosed = std::numeric_limits<int>::min();

    VisibilityBuffer& m_visible;
    std::vector<int>& m_openAt;  // per part: the first pixel of the span that has begun, or kClosed
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_LINE_ZBUFFER_INL_H
