// What a run tells the sentences of its events.
#pragma once

#include "core/frame/renderer.h"
#include "core/lesson/recorders.h"
#include "core/probe/telling.h"

namespace zscope {

class RunTelling final : public Telling {
public:
    /// `frame` and `triangle` belong to the run and outlive this.
    RunTelling(const DrawRequest& request, const Frame& frame, const TriangleRecorder& triangle)
        : m_drawsFaces(zscope::drawsFaces(request.pipeline)), m_triangles(request.scene->scene().triangleCount()),
          m_frame(frame), m_triangle(triangle)
    {}

    bool          drawsFaces() const override { return m_drawsFaces; }
    std::uint64_t triangles() const override { return m_triangles; }
    std::uint64_t coveredPixels() const override
    {
        const VisibilityBuffer& visible = m_frame.visible;
        std::uint64_t           covered = 0;
        for (int y = 0; y < visible.height(); ++y)
            for (int x = 0; x < visible.width(); ++x) covered += visible.rankAt(x, y) != 0;
        return covered;
    }
    std::uint64_t pixelsWon() const override
    {
        const auto triangle = m_triangle.state();
        return triangle ? triangle->pixelsWon : 0;
    }
    float background() const override { return m_frame.visible.empty(); }

private:
    bool                    m_drawsFaces;
    std::uint64_t           m_triangles;
    const Frame&            m_frame;
    const TriangleRecorder& m_triangle;
};

}  // namespace zscope
