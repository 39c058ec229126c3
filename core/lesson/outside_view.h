// The observer: the hierarchy of one step seen from outside, while the view that culls stays where it was. What was
// drawn, hidden or outside is painted by verdict, with the boxes of the nodes and the frustum of the culling view over
// it.
//
// Drawing    by the ordinary renderer: the triangles are a scene of their own, made once per step; lines are thin quads
//            that face the observer, a scene made for each of his views; the nearer depth is seen, and lines behind
//            something shine through faintly
// Limits     kMostTriangles and kMostBoxes; what is left out is counted, not drawn as if it were not there
// Threads    make() and draw() from one thread at a time; values are shared afterwards
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/frame/renderer.h"
#include "core/lesson/node_boxes.h"
#include "core/lesson/step_state.h"

namespace zscope {

/// A verdict per kind of thing that can be shown; index by NodeVerdict.
using VerdictSet = std::array<bool, 6>;
constexpr VerdictSet everyVerdict() { return {true, true, true, true, true, true}; }

struct ObserverPicture {
    Grid<std::uint32_t> colours;
    Grid<int>           nodes;  // the row of the node whose box or triangle is seen; -1: nothing, or the frustum
};

class OutsideView {
public:
    static constexpr std::uint64_t kMostTriangles = 400'000;
    static constexpr std::size_t   kMostBoxes     = 3'000;
    /// Row of the node that stands for the frustum in nodeOfLine; never seen from outside.
    static constexpr int kFrustum = -1;

    /// `culling` is the camera whose view was culled.
    static Result<std::shared_ptr<const OutsideView>> make(std::shared_ptr<const PreparedScene> scene,
                                                           const Camera& culling, const HierarchyState& hierarchy);

    /// `boxes`: whose boxes are drawn; `selected`: a row whose box is drawn thick, or -1.
    Result<ObserverPicture> draw(const Camera& from, const VerdictSet& boxes, int selected, int threads,
                                 const std::atomic<bool>* cancel = nullptr) const;

    /// A camera from which the whole scene, the frustum's beginning and the eye are in view.
    Camera        firstView(int width, int height) const;
    const Bounds& bounds() const { return m_bounds; }

    std::uint64_t trianglesShown() const { return m_nodeOfTriangle.size(); }
    std::uint64_t trianglesLeftOut() const { return m_leftOut; }
    std::size_t   boxesOf(NodeVerdict verdict) const;
    std::size_t   boxesLeftOut() const { return m_boxesLeftOut; }

private:
    struct Line {
        dvec3       a, b;
        int         node;
        NodeVerdict verdict;
    };

    void addTriangles(const PreparedScene& scene, const HierarchyState& hierarchy, TreeKind kind, NodeVerdict verdict,
                      Mesh& mesh);
    void addBoxes(const Scene& scene, const std::vector<NodeRow>& nodes);
    void addFrustum(const Camera& culling);

    std::shared_ptr<const PreparedScene> m_painted;  // the triangles, by verdict
    std::vector<int>                     m_nodeOfTriangle;
    std::vector<Line>                    m_lines;  // the frustum's last
    std::size_t                          m_frustumFrom  = 0;
    std::uint64_t                        m_leftOut      = 0;
    std::size_t                          m_boxesLeftOut = 0;
    std::array<std::size_t, 6>           m_boxes{};
    Bounds                               m_bounds;  // of scene and eye
    Camera                               m_culling;
};

/// The colour of a verdict in the observer's picture, 0xAARRGGBB.
std::uint32_t observerColourOf(NodeVerdict verdict);

}  // namespace zscope
