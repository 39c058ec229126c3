#include "core/measure/reference.h"

#include <array>
#include <atomic>
#include <new>

#include "core/measure/reference_walk.h"

namespace zscope {

using namespace definition;

namespace {

/// Calls visit(x, y) for every pixel that the part covers.
template <class Visit>
void forEachCovered(const Part& part, const Visit& visit)
{
    const definition::PixelBox& box = part.box();
    const auto& [p, q, r]           = part.sides();
    const auto rowIsOutside         = [&box](const Side& side, int y) {  // the edge function is linear: its ends decide
        return side.at(box.x0, y) < 0 && side.at(box.x1, y) < 0;
    };
    for (int y = box.y0; y <= box.y1; ++y) {
        if (rowIsOutside(p, y) || rowIsOutside(q, y) || rowIsOutside(r, y)) continue;
        Wide atP = p.at(box.x0, y), atQ = q.at(box.x0, y), atR = r.at(box.x0, y);
        for (int x = box.x0; x <= box.x1; ++x) {
            if (atP >= 0 && atQ >= 0 && atR >= 0 && !part.isHole(x, y)) visit(x, y);
            atP += p.perPixel();
            atQ += q.perPixel();
            atR += r.perPixel();
        }
    }
}

}  // namespace

Result<Picture> referencePicture(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                 const Progress& progress)
try {
    const View   view(camera, faceCulling);
    Grid<Winner> winners(camera.width, camera.height, 0);
    const auto   drawn = forEachTriangle(scene, view, progress, everyInstance,
                                         [&](std::uint32_t id, Fate, const std::vector<Part>& parts) {
                                           for (const Part& part : parts) {
                                               forEachCovered(part, [&](int x, int y) {
                                                   const float depth = part.depth(x, y);
                                                   if (depth >= view.farDepth)
                                                       offer(winners.at(x, y), winnerOf(depth, id));
                                               });
                                           }
                                       });
    if (!drawn) return drawn.error();

    Picture picture{.ids   = Grid<std::int64_t>(camera.width, camera.height),
                    .depth = Grid<float>(camera.width, camera.height)};
    for (std::size_t i = 0; i < winners.values().size(); ++i) {
        const SampleTruth truth   = truthOf(winners.values()[i]);
        picture.ids.values()[i]   = truth.id;
        picture.depth.values()[i] = truth.depth;
    }
    return picture;
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "the reference picture does not fit into memory"};
}

Result<TriangleFates> referenceFates(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                     const Progress& progress)
{
    std::array<std::atomic<std::uint64_t>, 6> counts{};
    const auto                                count = [&](std::uint32_t, Fate fate, const std::vector<Part>&) {
        ++counts[static_cast<std::size_t>(fate)];
    };
    const auto done = forEachTriangle(scene, View(camera, faceCulling), progress, everyInstance, count);
    if (!done) return done.error();
    const auto of = [&counts](Fate fate) { return counts[static_cast<std::size_t>(fate)].load(); };
    return TriangleFates{.drawn       = of(Fate::Drawn),
                         .culled      = of(Fate::Culled),
                         .degenerate  = of(Fate::Degenerate),
                         .outOfRange  = of(Fate::OutOfRange),
                         .behindNear  = of(Fate::BehindNear),
                         .transparent = of(Fate::Transparent)};
}

}  // namespace zscope
