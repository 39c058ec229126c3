#define HWY_COMPILE_ONLY_SCALAR

#include "tests/agreement/hidden_listener.h"

#include <map>
#include <utility>

#include "core/frame/serial_run-inl.h"

namespace zscope::tests {

namespace {

class CulledRecorder {
public:
    CulledRecorder(const Scene& scene, Culled& culled) : m_scene(scene), m_culled(culled)
    {
        m_culled.byNode.assign(scene.triangleCount(), false);
        m_culled.byTriangle.assign(scene.triangleCount(), false);
        m_reached.assign(scene.triangleCount(), false);
    }

    void observe(const NodeJudged& e)
    {
        if (e.verdict == Verdict::Entered) return;
        ++(e.verdict == Verdict::Hidden ? m_culled.nodesHidden : m_culled.nodesOutside);
        for (const std::uint32_t item : e.place.tree.allItems(e.place.node)) {
            const std::uint32_t first = m_scene.firstTriangle[e.place.isInstanceTree ? item : e.place.instance.value];
            const std::uint32_t begin = e.place.isInstanceTree ? first : first + item;
            const std::uint32_t end   = e.place.isInstanceTree ? m_scene.firstTriangle[item + 1] : begin + 1;
            for (std::uint32_t id = begin; id < end; ++id) m_culled.byNode[id] = true;
            if (e.verdict == Verdict::Hidden) m_culled.hiddenByNode += end - begin;
        }
    }
    void observe(const TriangleHidden& e)
    {
        ++m_culled.trianglesHidden;
        if (!m_reached[e.triangle.value]) m_culled.byTriangle[e.triangle.value] = true;
    }
    /// Another part of it is drawn, so the triangle is not culled.
    void observe(const TriangleReached& e)
    {
        m_reached[e.triangle.id.value]           = true;
        m_culled.byTriangle[e.triangle.id.value] = false;
    }
    /// A pre-pass draws everything; only what comes after it counts.
    void observe(const StageStarted& e)
    {
        if (e.stage == Stage::Raster) m_reached.assign(m_reached.size(), false);
    }

private:
    const Scene&      m_scene;
    Culled&           m_culled;
    std::vector<bool> m_reached;
};
static_assert(observes<CulledRecorder, NodeJudged> && observes<CulledRecorder, TriangleHidden> &&
              observes<CulledRecorder, TriangleReached> && observes<CulledRecorder, StageStarted>);

class VisitRecorder {
public:
    void observe(const NodeJudged& e) { m_when[keyOf(e.place, e.place.node)] = m_count++; }
    void observe(const NodeOpened& e)
    {
        m_opened.push_back({e.place, {e.children.begin(), e.children.end()}, {}});
    }

    std::vector<OpenedNode> finish()
    {
        for (OpenedNode& opened : m_opened)
            for (const TreeNode* child : opened.children) opened.judgedWhen.push_back(m_when.at(keyOf(opened.place, *child)));
        return std::move(m_opened);
    }

private:
    using Key = std::pair<std::int64_t, const TreeNode*>;
    static Key keyOf(const NodePlace& place, const TreeNode& node)
    {
        return {place.isInstanceTree ? -1 : static_cast<std::int64_t>(place.instance.value), &node};
    }

    std::uint64_t                m_count = 0;
    std::map<Key, std::uint64_t> m_when;
    std::vector<OpenedNode>      m_opened;
};
static_assert(observes<VisitRecorder, NodeJudged> && observes<VisitRecorder, NodeOpened>);

template <class Recorder>
void run(DrawRequest request, Recorder& recorder)
{
    request.shade = false;
    Frame         frame;
    StripeScratch scratch;
    HWY_STATIC_DISPATCH(runSerially)(request, frame, scratch, Listening(recorder));
}

}  // namespace

Culled culledBy(const DrawRequest& request)
{
    Culled         culled;
    CulledRecorder recorder(request.scene->scene(), culled);
    run(request, recorder);
    return culled;
}

std::vector<OpenedNode> visitOf(const DrawRequest& request)
{
    VisitRecorder recorder;
    run(request, recorder);
    return recorder.finish();
}

}  // namespace zscope::tests
