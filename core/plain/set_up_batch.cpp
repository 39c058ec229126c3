#include "core/plain/set_up_batch.h"

#include <algorithm>
#include <array>

#include "core/geometry/facing.h"
#include "core/geometry/geometry_events.h"
#include "core/geometry/set_up.h"

namespace zscope::plain {

namespace {

void transform(Work& work, const BatchPlace& place)
{
    std::vector<dvec3>& view = work.scratch.view;
    view.clear();
    for (std::size_t v = place.batch.firstVertex; v < place.batch.firstVertex + place.batch.vertexCount; ++v)
        view.push_back(viewOf({place.mesh.x[v], place.mesh.y[v], place.mesh.z[v]}, place.toWorld,
                              work.stripe.projection, work.rules));
}

/// A fault: triangle `t` of the mesh's batches, if it is the nth of its face, as the nth of a fan from the face's first
/// corner. `corner`: what it is by the definition, and stays where the face has no such fan.
std::array<dvec3, 3> cornersOfFan(const Work& work, const BatchPlace& place, std::uint32_t t,
                                  const std::array<dvec3, 3>& corner)
{
    const Scene&                         scene   = work.stripe.scene.scene();
    const Mesh&                          mesh    = scene.meshOf(scene.instanceOf(place.idOf(t)));
    const std::uint32_t                  own     = place.mesh.meshTriangle[t];
    const PolygonId                      face    = mesh.trianglePolygon[own];
    const std::span<const std::uint32_t> outline = mesh.polygon(face);
    const std::uint32_t                  nth     = own - mesh.firstTriangle[face.value];
    if (nth + 2 >= outline.size()) return corner;
    const auto seen = [&](std::size_t i) {
        return viewOf(mesh.positions[outline[i]], place.toWorld, work.stripe.projection, work.rules);
    };
    return {seen(0), seen(nth + 1), seen(nth + 2)};
}

/// Triangle `t` of the mesh's batches. Its fate is the best of its parts'.
void setUpTriangle(Work& work, const BatchPlace& place, std::uint32_t t, const Facing& facing)
{
    const auto&          corners = place.mesh.corners;
    const auto&          view    = work.scratch.view;
    std::array<dvec3, 3> corner{view[corners[0][t]], view[corners[1][t]], view[corners[2][t]]};
    if (work.rules.fansFaces()) corner = cornersOfFan(work, place, t, corner);  // a fault
    const double    near = work.stripe.projection.near;
    ClippedTriangle kept = work.rules.dividesBehindTheEye() ? unclipped(corner, near)  // a fault
                                                            : clipNear(corner, near);
    if (kept.isCut && work.rules.dropsAtNear()) kept.count = 0;  // an approximation, and a fault

    SetUp fate = SetUp::ClippedAway;
    bool  wide = false;
    for (std::size_t p = 0; p < kept.parts(); ++p) {
        ScreenTriangle part;
        const SetUp    partFate = setUpPart(kept.part(p), place.idOf(t), work.stripe.projection, facing,
                                            work.stripe.region(), work.rules, part);
        if (partFate == SetUp::Drawn) {
            wide           = wide || part.wide;
            part.patterned = place.mesh.isPatterned(t);
            work.scratch.triangles.push_back(part);
        }
        if (fate != SetUp::Drawn) fate = partFate;
    }
    work.tell(TriangleSetUp{place.idOf(t), fate, kept.isCut, wide, work.rules.takesFrontsForBacks()});
}

}  // namespace

void setUpBatch(Call work, const BatchPlace& place)
{
    transform(*work, place);
    const Scene& scene = work->stripe.scene.scene();
    if (place.batch.triangleCount > 0)
        work->tell(BatchTransformed{scene.instanceOf(place.idOf(place.batch.firstTriangle)), place.batch.vertexCount});
    work->tally.add(Unit::Batches);
    work->tally.add(Unit::Vertices, place.batch.vertexCount);
    work->tally.add(Unit::TrianglesSetUp, place.batch.triangleCount);
    work->clock.lap(Stage::Transform);

    const Facing facing = work->rules.facing({work->stripe.culling, place.isMirrored()});  // a fault: the other side
    work->scratch.triangles.clear();
    for (std::uint32_t t = 0; t < place.batch.triangleCount; ++t)
        setUpTriangle(*work, place, place.batch.firstTriangle + t, facing);
    if (work->rules.visitsFarFirst())
        std::ranges::reverse(work->scratch.triangles);  // a fault: of a node the last first
    work->clock.lap(Stage::Setup);
}

}  // namespace zscope::plain
