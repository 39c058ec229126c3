#include "core/measure/cull_audit.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/cull/cull_events.h"
#include "core/cull/node_reach.h"
#include "core/frame/frame_events.h"
#include "core/frame/frame_plan.h"
#include "core/frame/observed_run.h"
#include "core/geometry/geometry_events.h"
#include "core/probe/recorders.h"
#include "core/scan/pixel_events.h"

namespace zscope {

namespace {

/// The triangles of the true picture, and what has become of each in the run so far.
class VisibleTriangles {
public:
    enum class Fate : std::uint8_t { Unseen, NodeOutside, NodeHidden, NodeSmall, TriangleHidden, Dropped, Drawn };

    explicit VisibleTriangles(std::span<const std::int64_t> ids)
    {
        for (const std::int64_t id : ids)
            if (id >= 0) m_ids.push_back(static_cast<std::uint32_t>(id));
        std::ranges::sort(m_ids);
        m_ids.erase(std::unique(m_ids.begin(), m_ids.end()), m_ids.end());
        m_fates.resize(m_ids.size(), Fate::Unseen);
    }

    /// What was drawn once stays drawn; else the last word counts.
    void say(std::uint32_t id, Fate fate) { sayOfAll(id, id, fate); }
    /// Of the ids [first, last].
    void sayOfAll(std::uint32_t first, std::uint32_t last, Fate fate)
    {
        for (auto at = std::ranges::lower_bound(m_ids, first); at != m_ids.end() && *at <= last; ++at) {
            Fate& known = m_fates[static_cast<std::size_t>(at - m_ids.begin())];
            if (known != Fate::Drawn) known = fate;
        }
    }
    bool anyWithin(std::uint32_t first, std::uint32_t last) const
    {
        const auto at = std::ranges::lower_bound(m_ids, first);
        return at != m_ids.end() && *at <= last;
    }

    FalseCulls falseCulls() const
    {
        const auto with = [this](Fate fate) { return static_cast<std::uint64_t>(std::ranges::count(m_fates, fate)); };
        return {.byBatch       = with(Fate::Unseen),
                .byNodeOutside = with(Fate::NodeOutside),
                .byNodeHidden  = with(Fate::NodeHidden),
                .byNodeSmall   = with(Fate::NodeSmall),
                .byTriangle    = with(Fate::TriangleHidden)};
    }

private:
    std::vector<std::uint32_t> m_ids;    // ascending, each once
    std::vector<Fate>          m_fates;  // of each
};

class CullJudge {
public:
    using Events = Wants<NodeJudged, TriangleSetUp, TriangleHidden, TriangleReached, StageStarted>;

    CullJudge(const DrawRequest& request, const VisibilityBuffer& finished, std::span<const std::int64_t> visible)
        : m_scene(request.scene->scene()), m_finished(finished),
          m_projection(request.camera, 1,
                       displacementOf(request.pipeline.approximation, request.camera, *request.scene)),
          m_encoding(request.pipeline.approximation.format, request.camera.near, request.camera.far), m_visible(visible)
    {}

    /// A pre-pass culls nothing and colours nothing: what comes after it counts.
    void observe(const StageStarted& e) { m_inPrepass = e.stage == Stage::Prepass; }

    void observe(const NodeJudged& e)
    {
        if (m_inPrepass) return;
        switch (e.verdict) {
            case Verdict::Outside:
                ++m_audit.nodesOutside;
                sayBelow(e.place, VisibleTriangles::Fate::NodeOutside);
                break;
            case Verdict::Hidden:
                ++m_audit.nodesHidden;
                sayBelow(e.place, VisibleTriangles::Fate::NodeHidden);
                break;
            case Verdict::Small:
                sayBelow(e.place, VisibleTriangles::Fate::NodeSmall);
                break;
            case Verdict::Entered:
                ++m_audit.nodesEntered;
                m_audit.missedNodes += isBehind(e.place);
                break;
        }
    }

    void observe(const TriangleSetUp& e)
    {
        if (m_inPrepass || e.fate == SetUp::Drawn) return;  // those drawn are heard of again
        m_visible.say(e.triangle.value,
                      e.fate == SetUp::Outside ? VisibleTriangles::Fate::Unseen : VisibleTriangles::Fate::Dropped);
    }
    /// The parts of a triangle come one after another: it is hidden if all are, and missed if all that are drawn are
    /// behind.
    void observe(const TriangleHidden& e)
    {
        if (m_inPrepass) return;
        beginPart(e.triangle);
        m_visible.say(e.triangle.value, VisibleTriangles::Fate::TriangleHidden);
    }
    void observe(const TriangleReached& e)
    {
        if (m_inPrepass) return;
        beginPart(e.triangle.id);
        m_visible.say(e.triangle.id.value, VisibleTriangles::Fate::Drawn);
        m_allBehind = m_allBehind && isBehind(e.triangle.box, e.triangle.depth.nearest);
        m_anyDrawn  = true;
    }

    CullAudit finish()
    {
        endTriangle();
        m_audit.falseCulls = m_visible.falseCulls();
        return m_audit;
    }

private:
    void beginPart(TriangleId triangle)
    {
        if (m_hasTriangle && m_triangle == triangle) return;
        endTriangle();
        m_triangle    = triangle;
        m_hasTriangle = true;
    }
    void endTriangle()
    {
        if (m_hasTriangle) {
            ++(m_anyDrawn ? m_audit.trianglesDrawn : m_audit.trianglesHidden);
            m_audit.missedTriangles += m_anyDrawn && m_allBehind;
        }
        m_hasTriangle = m_anyDrawn = false;
        m_allBehind                = true;
    }

    void sayBelow(const NodePlace& place, VisibleTriangles::Fate fate)
    {
        const auto& starts = m_scene.firstTriangle;
        const auto  items  = place.tree.allItems(place.node);
        if (place.isInstanceTree) {
            for (const std::uint32_t instance : items)
                if (starts[instance] < starts[instance + 1])
                    m_visible.sayOfAll(starts[instance], starts[instance + 1] - 1, fate);
            return;
        }
        const std::uint32_t first = starts[place.instance.value];
        if (!m_visible.anyWithin(first, starts[place.instance.value + 1] - 1)) return;
        for (const std::uint32_t triangle : items) m_visible.say(first + triangle, fate);
    }

    bool isBehind(const NodePlace& place) const
    {
        const Affine     world;
        const Affine&    toWorld = place.isInstanceTree ? world : m_scene.instances[place.instance.value].toWorld;
        const PlacedView view(m_projection, toWorld, place.isInstanceTree ? m_projection.displacement.instances : 0);
        const NodeReach  reach =
            reachOf(view(place.node.bounds), m_projection, {0, 0, m_finished.width(), m_finished.height()});
        return !reach.crossesNear && isBehind(reach.pixels, reach.nearest);
    }
    /// The perfect test: every pixel of the box is nearer than anything in it.
    bool isBehind(const PixelBox& box, double nearest) const
    {
        const float stored = m_encoding.stored(nearest);
        for (int y = box.y0; y < box.y1; ++y) {
            for (int x = box.x0; x < box.x1; ++x)
                if (!(stored < m_finished.storedAt(x, y))) return false;
        }
        return true;
    }

    const Scene&            m_scene;
    const VisibilityBuffer& m_finished;
    Projection              m_projection;
    DepthEncoding           m_encoding;
    VisibleTriangles        m_visible;
    CullAudit               m_audit;
    bool                    m_inPrepass   = false;
    bool                    m_hasTriangle = false;  // m_triangle is the one at hand
    bool                    m_anyDrawn    = false;  // one of its parts was
    bool                    m_allBehind   = true;   // all of its parts that were drawn
    TriangleId              m_triangle;
};

}  // namespace

bool canAuditCulls(const Pipeline& pipeline) { return familyOf(pipeline) == "stream"; }

Result<CullAudit> auditCulls(const DrawRequest& request, const VisibilityBuffer& finished,
                             std::span<const std::int64_t> visible)
{
    assert(canAuditCulls(request.pipeline));
    assert(finished.width() == request.camera.width && finished.height() == request.camera.height);
    const Result<FramePlan> plan = planFrame(request);
    if (!plan) return plan.error();
    try {
        Frame          frame;
        plain::Scratch scratch;
        CullJudge      judge(request, finished, visible);
        DrawRequest    unshaded = request;
        unshaded.shade          = false;
        Listening listening(judge);
        drawObserved(unshaded, frame, scratch, listening);
        if (request.cancel && request.cancel->load()) return Error{Trouble::Cancelled, "the audit was cancelled"};
        return judge.finish();
    } catch (const std::bad_alloc&) {
        return Error{Trouble::Limit, "there is not enough memory to audit this frame"};
    }
}

}  // namespace zscope
