// Resolves a line of the sweep by blending: all transparent fragments of the line that are nearer than the opaque depth
// are listed pixel by pixel, put in order, and laid "over" the colour that is there.
//
// Order      Sorted: from far to near by (depth, -id), which is right wherever surfaces cross. BackThenFront: back
//            faces first, then front faces, each as submitted; right for one convex body, wrong where bodies overlap or
//            are hollow: what renderers do that keep no list
// Over       per channel c += (source - c) * opacity, float32, from the opaque colour; rounded once at the end
// Memory     of the fragments of a part of one line: a line with more than kMostFragments is cut into halves until each
//            has fewer, or is one pixel
// Source     Porter, Duff: Compositing Digital Images, SIGGRAPH 1984; Carpenter: The A-buffer, SIGGRAPH 1984
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/base/blend_order.h"
#include "core/base/grid.h"
#include "core/base/tally.h"
#include "core/depth/visibility_buffer.h"
#include "core/sweep/blend_scratch.h"
#include "core/sweep/line_spans.h"

namespace zscope {

template <class Rules>
class BlendLine {
public:
    /// `visible` holds the opaque picture; `colour` has its size and holds its colours.
    BlendLine(const VisibilityBuffer& visible, GridView<std::uint32_t> colour, BlendOrder order, BlendScratch& scratch,
              const Rules& rules, Tally& tally)
        : m_visible(visible), m_colour(colour), m_order(order), m_scratch(scratch), m_rules(rules), m_tally(tally)
    {}

    void line(int y, std::span<const ActiveEdge> active, ActivePolygons& polygons)
    {
        m_scratch.spans.clear();
        forEachSpan(active, polygons, m_visible.width(), [this](std::uint32_t part, int x0, int x1) {
            m_scratch.spans.push_back({part, x0, x1});
        });
        if (!m_scratch.spans.empty()) blendBetween(y, 0, m_visible.width(), polygons);
    }

private:
    static constexpr std::int64_t kMostFragments = std::int64_t{1} << 22;

    void blendBetween(int y, int x0, int x1, const ActivePolygons& polygons)
    {
        std::int64_t count = 0;
        for (const BlendScratch::Span& span : m_scratch.spans)
            count += std::max(0, std::min(span.x1, x1) - std::max(span.x0, x0));
        if (count > kMostFragments && x1 - x0 > 1) {
            const int middle = x0 + (x1 - x0) / 2;
            blendBetween(y, x0, middle, polygons);
            blendBetween(y, middle, x1, polygons);
            return;
        }
        m_tally.add(Unit::Transparent, static_cast<std::uint64_t>(count));
        collect(y, x0, x1, polygons);
        for (std::size_t column = 0; column + 1 < m_scratch.columns.size(); ++column) {
            const std::size_t first = m_scratch.columns[column], end = m_scratch.columns[column + 1];
            if (first == end) continue;
            const auto pixel = std::span(m_scratch.fragments).subspan(first, end - first);
            std::ranges::sort(pixel, [this](const auto& a, const auto& b) { return comesBefore(a, b); });
            blendPixel(y, pixel);
        }
    }

    /// The fragments of the line between two columns that are nearer than the opaque depth, column by column.
    void collect(int y, int x0, int x1, const ActivePolygons& polygons)
    {
        const PixelKey* opaque = m_visible.row(y);
        m_scratch.found.clear();
        m_scratch.columns.assign(static_cast<std::size_t>(x1 - x0) + 1, 0);
        for (const BlendScratch::Span& span : m_scratch.spans) {
            const SweepPolygon& polygon = polygons[span.part];
            const DepthPlane&   plane   = polygon.depth;
            const double        line    = plane.b * (y + 0.5) + plane.c;
            for (int x = std::max(span.x0, x0); x < std::min(span.x1, x1); ++x) {
                const double z =
                    std::min(std::max(plane.a * (x + 0.5) + line, double{plane.farthest}), double{plane.nearest});
                const float depth = m_rules.stored(z);
                if (!(depth > depthOf(opaque[x]))) continue;
                m_scratch.found.push_back({x, depth, span.part, polygon.rank()});
                ++m_scratch.columns[static_cast<std::size_t>(x - x0)];
            }
        }
        // Counts become the ends of the columns, and from the back each fragment goes to the last free place of its
        // own: what is left are the columns' beginnings.
        for (std::size_t i = 1; i < m_scratch.columns.size(); ++i) m_scratch.columns[i] += m_scratch.columns[i - 1];
        m_scratch.fragments.resize(m_scratch.found.size());
        for (std::size_t i = m_scratch.found.size(); i-- > 0;)
            m_scratch.fragments[--m_scratch.columns[static_cast<std::size_t>(m_scratch.found[i].x - x0)]] =
                m_scratch.found[i];
    }

    bool comesBefore(const BlendScratch::Fragment& a, const BlendScratch::Fragment& b) const
    {
        if (m_order == BlendOrder::Sorted) return a.depth != b.depth ? a.depth < b.depth : a.rank > b.rank;
        const bool aFront = m_scratch.paints[a.part].front, bFront = m_scratch.paints[b.part].front;
        return aFront != bFront ? bFront : a.rank < b.rank;
    }

    void blendPixel(int y, std::span<const BlendScratch::Fragment> fragments)
    {
        m_tally.add(Unit::PixelsBlended);
        const int           x      = fragments.front().x;
        const std::uint32_t before = m_colour.at(x, y);
        float               red = channel(before, 16), green = channel(before, 8), blue = channel(before, 0);
        for (const BlendScratch::Fragment& fragment : fragments) {
            const Paint& paint = m_scratch.paints[fragment.part];
            red += (channel(paint.colour, 16) - red) * paint.opacity;
            green += (channel(paint.colour, 8) - green) * paint.opacity;
            blue += (channel(paint.colour, 0) - blue) * paint.opacity;
        }
        m_colour.at(x, y) = 0xFF000000u | rounded(red) << 16 | rounded(green) << 8 | rounded(blue);
    }

    static float channel(std::uint32_t colour, int shift) { return static_cast<float>(colour >> shift & 0xFFu); }
    static std::uint32_t rounded(float channel) { return static_cast<std::uint32_t>(channel + 0.5f); }

    const VisibilityBuffer& m_visible;
    GridView<std::uint32_t> m_colour;
    BlendOrder              m_order;
    BlendScratch&           m_scratch;
    const Rules&            m_rules;
    Tally&                  m_tally;
};

}  // namespace zscope
