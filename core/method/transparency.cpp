#include "core/method/transparency.h"

#include <algorithm>

#include "core/method/scanline.h"
#include "core/plain/batches_in_view.h"
#include "core/plain/lines.h"
#include "core/shade/colour_table.h"
#include "core/sweep/blend_events.h"

namespace zscope::plain {

namespace {

/// Of one part of a line: what its memory may hold. A part with more is halved.
constexpr std::int64_t kMostFragments = std::int64_t{1} << 22;

/// The transparent triangles of the batch, each with its colour and opacity.
void enterWithColours(Work& work, const ColourTable& colours)
{
    const Scene& scene = work.stripe.scene.scene();
    for (const ScreenTriangle& triangle : work.scratch.triangles) {
        work.scratch.edges.add(triangle, work.rules);
        const InstanceId    instance     = scene.instanceOf(triangle.id);
        const std::uint32_t meshTriangle = triangle.id.value - scene.firstTriangle[instance.value];
        const Mesh&         mesh         = scene.meshOf(instance);
        Polygon&            polygon      = work.scratch.edges.polygons().back();
        polygon.colour =
            colours.isComplete() ? colours.data()[triangle.id.value + 1] : colourOf(scene, instance, meshTriangle);
        polygon.opacity = mesh.materialOf(mesh.trianglePolygon[meshTriangle]).opacity;
        polygon.front   = triangle.counterClockwise != scene.instances[instance.value].toWorld.isMirrored();
    }
    work.clock.lap(Stage::Setup);
}

class BlendedLine {
public:
    BlendedLine(Work& work, BlendOrder order, GridView<std::uint32_t> colour, int y)
        : m_work(work), m_polygons(work.scratch.edges.polygons()), m_order(order), m_colour(colour), m_y(y),
          m_spans(spansOf(work))
    {}

    /// The pixels [x0, x1) of the line.
    void blend(int x0, int x1)
    {
        std::int64_t count = 0;
        for (const LineSpan& span : m_spans) count += std::max(0, std::min(span.x1, x1) - std::max(span.x0, x0));
        if (count == 0) return;
        if (count > kMostFragments && x1 - x0 > 1) {
            const int middle = x0 + (x1 - x0) / 2;
            blend(x0, middle);
            return blend(middle, x1);
        }
        auto& fragments = m_work.scratch.fragments;
        collect(x0, x1);
        m_work.tally.add(Unit::Transparent, static_cast<std::uint64_t>(count));
        m_work.tell(
            FragmentsJudged{static_cast<std::uint64_t>(count), static_cast<std::uint64_t>(count) - fragments.size()});
        std::ranges::sort(fragments, [this](const BlendFragment& a, const BlendFragment& b) {
            return a.x != b.x ? a.x < b.x : comesBefore(a, b);
        });
        for (auto first = fragments.begin(); first != fragments.end();) {
            const auto end =
                std::find_if(first, fragments.end(), [&](const auto& other) { return other.x != first->x; });
            blendPixel({first, end});
            first = end;
        }
    }

private:
    /// Those between two columns that are nearer than the opaque depth.
    void collect(int x0, int x1)
    {
        auto& fragments = m_work.scratch.fragments;
        fragments.clear();
        for (const LineSpan& span : m_spans) {
            const Polygon&    polygon = m_polygons[span.polygon];
            const DepthPlane& plane   = polygon.depth;
            const double      line    = plane.b * (m_y + 0.5) + plane.c;
            for (int x = std::max(span.x0, x0); x < std::min(span.x1, x1); ++x) {
                const double z =
                    std::min(std::max(plane.a * (x + 0.5) + line, double{plane.farthest}), double{plane.nearest});
                const float depth = m_work.rules.stored(z);
                if (depth > m_work.stripe.visible.comparedAt(x, m_y))
                    fragments.push_back({x, depth, span.polygon, polygon.id.value + 1});
            }
        }
    }

    bool comesBefore(const BlendFragment& a, const BlendFragment& b) const
    {
        if (m_order == BlendOrder::Sorted) return a.depth != b.depth ? a.depth < b.depth : a.rank > b.rank;
        const bool aFront = m_polygons[a.polygon].front, bFront = m_polygons[b.polygon].front;
        return aFront != bFront ? bFront : a.rank < b.rank;
    }

    void blendPixel(std::span<const BlendFragment> fragments)
    {
        const int           x      = fragments.front().x;
        const std::uint32_t before = m_colour.at(x, m_y);
        float               red = channel(before, 16), green = channel(before, 8), blue = channel(before, 0);
        for (const BlendFragment& fragment : fragments) {
            const Polygon& source = m_polygons[fragment.polygon];
            red += (channel(source.colour, 16) - red) * source.opacity;
            green += (channel(source.colour, 8) - green) * source.opacity;
            blue += (channel(source.colour, 0) - blue) * source.opacity;
        }
        const std::uint32_t after = 0xFF000000u | rounded(red) << 16 | rounded(green) << 8 | rounded(blue);
        m_colour.at(x, m_y)       = after;
        m_work.tally.add(Unit::PixelsBlended);
        m_work.tell(PixelBlended{x, m_y, static_cast<std::uint32_t>(fragments.size()), before, after, m_order});
    }

    static float channel(std::uint32_t colour, int shift) { return static_cast<float>(colour >> shift & 0xFFu); }
    static std::uint32_t rounded(float channel) { return static_cast<std::uint32_t>(channel + 0.5f); }

    Work&                     m_work;
    std::span<const Polygon>  m_polygons;
    BlendOrder                m_order;
    GridView<std::uint32_t>   m_colour;
    int                       m_y;
    std::span<const LineSpan> m_spans;
};

}  // namespace

void blendTransparent(Work& work, const Parts& parts, const TransparentSurfaces& surfaces, const ColourTable& colours,
                      BlendOrder order, GridView<std::uint32_t> colour)
{
    EdgeTable&   edges  = work.scratch.edges;
    ActiveEdges& active = work.scratch.active;
    Tally        ofSweep;  // only the blending is reported and counted, not the sweep beneath it
    // It has no observer: it reports nothing, and a replayed run leaves no line or batch of it out.
    Work quiet{work.stripe, work.rules, work.scratch, work.clock, ofSweep};
    edges.clear(work.stripe.firstRow, work.stripe.endRow, work.stripe.memory);
    for (const BatchPlace& batch : BatchesInView(quiet, &surfaces)) {
        parts.setUp(quiet, batch);
        enterWithColours(quiet, colours);
    }
    edges.fillBuckets();
    active.begin(edges);
    for (const int y : LinesOf(quiet)) {
        active.retireBefore(y, quiet);
        active.admit(edges, y, quiet);
        active.sortByX(quiet);
        BlendedLine(work, order, colour, y).blend(0, work.stripe.visible.width());
        active.advance();
    }
}

}  // namespace zscope::plain
