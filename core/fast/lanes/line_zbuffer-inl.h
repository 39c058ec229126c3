// Resolves a line of the sweep with a one-line z-buffer: the line of the visibility buffer that is being drawn.
//
// Idea       each active polygon covers the pixels between the edges on this line that open it and those that close it;
//            offer them to the depth test
// Cost       the pixels of all active polygons on the line, hidden ones included
#if defined(ZSCOPE_LINE_ZBUFFER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_LINE_ZBUFFER_INL_H
#undef ZSCOPE_LINE_ZBUFFER_INL_H
#else
#define ZSCOPE_LINE_ZBUFFER_INL_H
#endif

#include <span>

#include "core/fast/lanes/depth_test-inl.h"
#include "core/fast/lanes/pattern-inl.h"
#include "core/sweep/line_spans.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Where the holes and reliefs of polygons come from.
struct PatternFinder {
    const Scene&      scene;
    const Projection& projection;

    PatternedFragments<UnshadedFragments> fragmentsOf(const SweepPolygon& polygon) const
    {
        return {UnshadedFragments(), patternPlaneOf(scene, projection, polygon.id)};
    }
};

/// Tests the pixels [x0, x1) of line y, by the patterns of the polygon, if it has any.
template <class Rules>
void testPolygonSpan(const SweepPolygon& polygon, int y, int x0, int x1, VisibilityBuffer& visible,
                     const PatternFinder& patterns, const Rules& rules)
{
    if (polygon.patterned)
        testSpan(polygon.depth, polygon.rank(), y, x0, x1, visible, rules, patterns.fragmentsOf(polygon));
    else
        testSpan(polygon.depth, polygon.rank(), y, x0, x1, visible, rules);
}

template <class Rules>
class LineZBuffer {
public:
    LineZBuffer(VisibilityBuffer& visible, const PatternFinder& patterns, const Rules& rules)
        : m_visible(visible), m_patterns(patterns), m_rules(rules)
    {}

    void line(int y, std::span<const ActiveEdge> active, ActivePolygons& polygons)
    {
        forEachSpan(active, polygons, m_visible.width(), [&](std::uint32_t polygon, int x0, int x1) HWY_ATTR {
            testPolygonSpan(polygons[polygon], y, x0, x1, m_visible, m_patterns, m_rules);
        });
    }

private:
    VisibilityBuffer& m_visible;
    PatternFinder     m_patterns;
    const Rules&      m_rules;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_LINE_ZBUFFER_INL_H
