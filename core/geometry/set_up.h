// From a batch's vertices to the list of triangles that reach the pixels of a region.
//
// Plain      triangles wholly in front of the near plane and inside the guard band: corners by index (set_up-inl.h does
//            several of them side by side)
// Careful    the others: each from its positions, cut at the near plane, every corner checked
// Promise    parts keep the triangle's id
#pragma once

#include "core/geometry/geometry_events.h"
#include "core/geometry/near_clip.h"
#include "core/geometry/screen_vertices.h"
#include "core/geometry/triangle_list.h"

namespace zscope {

/// What set-up needs to know of the mesh instance it is working on.
struct BatchPlace {
    const MeshBatches& mesh;
    const Batch&       batch;
    const Affine*      toWorld;                // nullptr: the identity
    std::uint32_t      firstTriangle;          // id of the instance's triangle 0
    PatchBits          patches = kAllPatches;  // those that are drawn

    bool       isMirrored() const { return toWorld && toWorld->isMirrored(); }
    TriangleId idOf(std::uint32_t triangle) const { return {firstTriangle + mesh.meshTriangle[triangle]}; }
};

/// Takes the reports of set-up and drops them.
struct NoReport {
    static constexpr bool isHeard() { return false; }
    template <class Event>
    void operator()(const Event&) const
    {}
};

/// One triangle whose corners are plain.
template <class Rules>
[[gnu::always_inline]] inline void setUpOne(const BatchPlace& place, std::uint32_t t, const ScreenVertices& vertices,
                                            const Facing& facing, const PixelBox& region, const Rules& rules,
                                            TriangleList& out)
{
    const auto&    corners = place.mesh.corners;
    ScreenTriangle made;
    const SetUp    fate = setUpTriangle(vertices.corner(corners[0][t]), vertices.corner(corners[1][t]),
                                        vertices.corner(corners[2][t]), place.idOf(t), false, facing, region, rules, made);
    if (fate == SetUp::Drawn) {
        made.patterned = place.mesh.isPatterned(t);
        out.add(made);
    }
}

/// `view` must lie at or beyond the near plane.
template <class Rules>
ScreenCorner screenOf(const dvec3& view, const Projection& projection, const Rules& rules)
{
    return rules.usesFloat32Vertices() ? projection.toScreen<float>(view, rules.snapsPerPixel())
                                       : projection.toScreen(view, rules.snapsPerPixel());
}

inline bool isInRange(const ScreenCorner& corner)
{
    return std::abs(corner.xs) < kSnapLimit && std::abs(corner.ys) < kSnapLimit;
}

/// One part of a clipped triangle; decides by itself whether it needs the wide path.
template <class Rules>
SetUp setUpPart(const std::array<dvec3, 3>& view, TriangleId id, const Projection& projection, const Facing& facing,
                const PixelBox& region, const Rules& rules, ScreenTriangle& out)
{
    std::array<ScreenCorner, 3> corner;
    bool                        wide = false;
    for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = screenOf(view[i], projection, rules);
        if (!isInRange(corner[i])) return SetUp::OutOfRange;
        wide = wide || std::max(std::abs(corner[i].xs), std::abs(corner[i].ys)) > kGuardBand;
    }
    return setUpTriangle(corner[0], corner[1], corner[2], id, wide, facing, region, rules, out);
}

/// From the model to view space.
template <class Rules>
dvec3 viewOf(const dvec3& model, const Affine* toWorld, const Projection& projection, const Rules& rules)
{
    if (rules.usesFloat32Vertices()) return projection.toView<float>(toWorld ? toWorld->in<float>(model) : model);
    return projection.toView<double>(toWorld ? toWorld->in<double>(model) : model);
}

/// Sets up what the near plane leaves of one triangle, and reports its fate; the parts are drawn as `drawnAs`.
template <class Rules, class Report = NoReport>
SetUp setUpClipped(const std::array<dvec3, 3>& view, TriangleId id, TriangleId drawnAs, bool patterned,
                   const Projection& projection, const Facing& facing, const PixelBox& region, const Rules& rules,
                   TriangleList& out, const Report& report = {})
{
    ClippedTriangle kept = clipNear(view, projection.near);
    if (kept.isCut && rules.dropsAtNear()) kept.count = 0;
    SetUp fate = SetUp::ClippedAway;
    bool  wide = false;
    for (std::size_t p = 0; p < kept.parts(); ++p) {
        ScreenTriangle made;
        const SetUp    partFate = setUpPart(kept.part(p), drawnAs, projection, facing, region, rules, made);
        if (partFate == SetUp::Drawn) {
            wide           = wide || made.wide;
            made.patterned = patterned;
            out.add(made);
        }
        if (fate != SetUp::Drawn) fate = partFate;
    }
    report(TriangleSetUp{id, fate, kept.isCut, wide});
    return fate;
}

/// One triangle of a batch from its positions, whatever its corners are.
template <class Rules>
void setUpCarefully(const BatchPlace& place, std::uint32_t t, const Projection& projection, const Facing& facing,
                    const PixelBox& region, const Rules& rules, TriangleList& out)
{
    const MeshBatches&   mesh = place.mesh;
    std::array<dvec3, 3> view;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t v = place.batch.firstVertex + mesh.corners[i][t];
        const dvec3       model{mesh.x[v], mesh.y[v], mesh.z[v]};
        view[i] = viewOf(model, place.toWorld, projection, rules);
    }
    setUpClipped(view, place.idOf(t), place.idOf(t), mesh.isPatterned(t), projection, facing, region, rules, out);
}

}  // namespace zscope
