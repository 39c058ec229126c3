// What culling left out of a frame and what it let through, judged against the finished depth of the same frame.
//
// False cull   a triangle that owns a pixel of the true picture and was left out by a test: with a batch or a node
//              outside the view, with a node called hidden or dropped as too small, or called hidden itself. 0 for
//              every method called conservative. What geometry drops (no area, behind the near plane) is no cull, and
//              neither is a triangle that is left out in one place and drawn in another
// Missed cull  a node that was entered, or a triangle that was drawn, although a perfect test of the same box and
//              nearest depth against the finished depth would have hidden it. A node that reaches before the near plane
//              has no such bounds and is never missed; one that covers no pixel centre always is
// How          the frame runs again, by plain text, with an observer that looks at every verdict; the perfect
//              test reads the pixels, not the pyramid that it judges
// Cost         a serial run, plus per node and triangle drawn its pixels up to the first that does not hide it; a byte
//              and an id per visible triangle
#pragma once

#include <cstdint>
#include <span>

#include "core/base/result.h"
#include "core/frame/renderer.h"

namespace zscope {

/// Triangles that own a pixel of the true picture and were left out, by what left them out.
struct FalseCulls {
    std::uint64_t byBatch = 0, byNodeOutside = 0, byNodeHidden = 0, byNodeSmall = 0, byTriangle = 0;

    std::uint64_t total() const { return byBatch + byNodeOutside + byNodeHidden + byNodeSmall + byTriangle; }
};

struct CullAudit {
    std::uint64_t nodesOutside = 0, nodesHidden = 0, nodesEntered = 0;
    std::uint64_t trianglesHidden = 0, trianglesDrawn = 0;  // one by one, after their nodes; drawn: any part was

    FalseCulls    falseCulls;
    std::uint64_t missedNodes = 0, missedTriangles = 0;  // of those entered, of those drawn
};

/// Only stream methods rasterise triangle by triangle; a sweep has nothing to audit.
bool canAuditCulls(const Pipeline& pipeline);

/// `finished`: the request's own picture. `visible`: the ids at pixels of the true one, in any order, repeats and
/// background (-1) allowed. Errors: what the renderer refuses, Limit, Cancelled.
Result<CullAudit> auditCulls(const DrawRequest& request, const VisibilityBuffer& finished,
                             std::span<const std::int64_t> visible);

}  // namespace zscope
