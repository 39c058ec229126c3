#include "tests/agreement/visit_listener.h"

#include <map>
#include <set>
#include <utility>

#include "core/cull/cull_events.h"
#include "core/frame/observed_run.h"
#include "core/probe/recorders.h"
#include "core/scan/pixel_events.h"

namespace zscope::tests {

namespace {

class VisitRecorder {
public:
    using Events = Wants<NodeJudged, NodeOpened>;

    void observe(const NodeJudged& e) { m_when[keyOf(e.place, e.place.node)] = m_count++; }
    void observe(const NodeOpened& e) { m_opened.push_back({e.place, {e.children.begin(), e.children.end()}, {}}); }

    std::vector<OpenedNode> finish()
    {
        for (OpenedNode& opened : m_opened)
            for (const TreeNode* child : opened.children)
                opened.judgedWhen.push_back(m_when.at(keyOf(opened.place, *child)));
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

class AskedRecorder {
public:
    using Events = Wants<PyramidAsked, TriangleReached>;

    void observe(const PyramidAsked& e)
    {
        if (e.node) return;
        m_asked.insert(e.triangle.value);
        m_all.asked.push_back(e.query.box);
    }
    void observe(const TriangleReached& e)
    {
        if (!m_asked.contains(e.triangle.id.value)) m_all.unasked.push_back(e.triangle.box);
    }

    AskedTriangles finish() { return std::move(m_all); }

private:
    std::set<std::uint32_t> m_asked;
    AskedTriangles          m_all;
};

template <class Recorder>
auto recorded(const DrawRequest& request)
{
    DrawRequest unshaded = request;
    unshaded.shade       = false;
    Frame          frame;
    plain::Scratch scratch;
    Recorder       recorder;
    Listening      listening(recorder);
    drawObserved(unshaded, frame, scratch, listening);
    return recorder.finish();
}

}  // namespace

std::vector<OpenedNode> visitOf(const DrawRequest& request) { return recorded<VisitRecorder>(request); }

AskedTriangles askedBy(const DrawRequest& request) { return recorded<AskedRecorder>(request); }

}  // namespace zscope::tests
