#include "core/measure/face_figures.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include "core/measure/reference_walk.h"

namespace zscope {

using namespace definition;

namespace {

/// A face that covers a point.
struct Cover {
    std::size_t   point;
    std::uint32_t face;        // id of its first triangle
    float         depth;       // of the triangle that covers it; of several the nearest
    bool          kept;        // not beyond the far plane
    int           layers = 1;  // triangles that do
};

/// Twice the snapped area as the viewer sees it: below 0 is counter-clockwise.
Wide doubleAreaOf(const Part& part)
{
    const auto& [a, b, c] = part.corners();
    return (Wide{b.xs} - a.xs) * (Wide{c.ys} - a.ys) - (Wide{b.ys} - a.ys) * (Wide{c.xs} - a.xs);
}

/// What the definition says of whole faces, for a few points of the picture.
class FaceTruth {
public:
    FaceTruth(const Scene& scene, const Camera& camera, FaceCulling culling)
        : m_scene(scene), m_culling(culling), m_view(camera, FaceCulling::None)
    {}

    float farDepth() const { return m_view.farDepth; }
    bool  isMended(std::uint32_t face) const
    {
        const InstanceId instance = m_scene.instanceOf(TriangleId{face});
        const Mesh&      mesh     = m_scene.meshOf(instance);
        return mesh.isMended(mesh.trianglePolygon[face - m_scene.firstTriangle[instance.value]]);
    }

    /// The faces that cover each point, grouped by point, in ascending order of both.
    Result<std::vector<Cover>> covers(std::span<const PixelPosition> points, const Progress& progress) const
    {
        const PointsByRow  rows(points, m_view.camera.height);
        std::vector<Cover> all;
        const auto         collect = [&](std::uint32_t id, Fate, const std::vector<Part>& parts) {
            for (const Part& part : parts)
                rows.within(part.box(), [&](std::uint32_t point) {
                    const PixelPosition p = points[point];
                    if (!part.covers(p.x, p.y)) return;
                    const std::uint32_t face = m_scene.firstOfFace(TriangleId{id}).value;
                    if (m_culling == FaceCulling::Back && !isMended(face) && part.isBack()) return;
                    const float depth = part.depth(p.x, p.y);
#pragma omp critical(zscope_face_covers)
                    all.push_back({point, face, depth, depth >= m_view.farDepth});
                });
        };
        const auto done = forEachTriangle(m_scene, m_view, progress, everyInstance, collect);
        if (!done) return done.error();
        return withoutHoles(std::move(all));
    }

    /// No pixel of the face is farther than this: its farthest corner, or how far back a relief moves that.
    float farthestOf(std::uint32_t face) const
    {
        const auto known = m_farthest.find(face);
        if (known != m_farthest.end()) return known->second;
        float farthest = 1;
        forEachPart(face, [&](const Part& part) { farthest = std::min(farthest, part.farthestDepth()); });
        return m_farthest[face] = farthest;
    }

private:
    /// One entry per point and face; mended faces by the even-odd rule.
    std::vector<Cover> withoutHoles(std::vector<Cover> all) const
    {
        std::ranges::sort(all, [](const Cover& a, const Cover& b) {
            return a.point != b.point ? a.point < b.point : a.face != b.face ? a.face < b.face : a.depth > b.depth;
        });
        std::vector<Cover> merged;
        for (const Cover& cover : all) {
            if (!merged.empty() && merged.back().point == cover.point && merged.back().face == cover.face)
                ++merged.back().layers;
            else
                merged.push_back(cover);
        }
        std::erase_if(merged, [this](const Cover& c) {
            return isMended(c.face) && (c.layers % 2 == 0 || isCulledWhole(c.face));
        });
        return merged;
    }

    /// A mended face has one side: that of its whole area.
    bool isCulledWhole(std::uint32_t face) const
    {
        if (m_culling != FaceCulling::Back) return false;
        Wide area = 0;
        forEachPart(face, [&](const Part& part) { area += doubleAreaOf(part); });
        const InstanceId instance = m_scene.instanceOf(TriangleId{face});
        return isMirrored(m_scene.instances[instance.value].toWorld) ? area < 0 : area > 0;
    }

    template <class Visit>
    void forEachPart(std::uint32_t face, const Visit& visit) const
    {
        const InstanceId    instance = m_scene.instanceOf(TriangleId{face});
        const Mesh&         mesh     = m_scene.meshOf(instance);
        const std::uint32_t first    = face - m_scene.firstTriangle[instance.value];
        const std::uint32_t end      = mesh.firstTriangle[mesh.trianglePolygon[first].value + 1];
        std::vector<Part>   parts;
        for (std::uint32_t t = first; t < end; ++t) {
            partsOf(m_scene, instance, t, m_view, parts);
            for (const Part& part : parts) visit(part);
        }
    }

    const Scene&                           m_scene;
    FaceCulling                            m_culling;
    View                                   m_view;  // of both sides
    mutable std::map<std::uint32_t, float> m_farthest;
};

enum class Verdict { Right, OfDepth, Hole, Spill };

/// Judges what the test shows, and puts into the pair what the definition shows by face.
Verdict judge(PixelPair& pixel, std::span<const Cover> covers, const FaceTruth& truth)
{
    pixel.referenceId    = -1;
    pixel.referenceDepth = 0;
    for (const Cover& cover : covers) {  // ascending by face: of equal depths the first stays
        if (!cover.kept || (pixel.referenceId >= 0 && cover.depth <= pixel.referenceDepth)) continue;
        pixel.referenceId    = cover.face;
        pixel.referenceDepth = cover.depth;
    }
    const auto isShown = [&pixel](const Cover& cover) { return pixel.testId == std::int64_t{cover.face}; };
    if (pixel.testId >= 0 && std::ranges::none_of(covers, isShown)) return Verdict::Spill;
    for (const Cover& cover : covers) {
        const float farthest = truth.farthestOf(cover.face);
        if (!isShown(cover) && farthest >= truth.farDepth() && (pixel.testId < 0 || farthest > pixel.testDepth))
            return Verdict::Hole;
    }
    return pixel.testId == pixel.referenceId ? Verdict::Right : Verdict::OfDepth;
}

/// Ids of triangles become those of their faces; background stays.
class FaceIds {
public:
    explicit FaceIds(const Scene& scene) : m_scene(scene) {}

    std::int64_t operator()(std::int64_t id)
    {
        if (id == m_last) return m_lastFace;
        m_last = id;
        return m_lastFace =
                   id < 0 ? id : std::int64_t{m_scene.firstOfFace(TriangleId{static_cast<std::uint32_t>(id)}).value};
    }

private:
    const Scene& m_scene;
    std::int64_t m_last = -1, m_lastFace = -1;  // neighbouring pixels mostly show the same
};

}  // namespace

Result<ErrorFigures> compareByFace(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                   std::vector<PixelPair> pixels, std::span<const PixelPosition> points,
                                   std::span<const std::int64_t> testIds, const Progress& progress)
{
    assert(pixels.size() == points.size());
    FaceIds faceOf(scene);
    for (PixelPair& p : pixels) {
        p.referenceId = faceOf(p.referenceId);
        p.testId      = faceOf(p.testId);
    }
    std::vector<std::int64_t> shown(testIds.begin(), testIds.end());
    for (std::int64_t& id : shown) id = faceOf(id);

    const FaceTruth            truth(scene, camera, faceCulling);
    std::vector<std::size_t>   doubtful;  // indices of pixels
    std::vector<PixelPosition> places;
    const auto                 isMended = [&truth](std::int64_t id) {
        return id >= 0 && truth.isMended(static_cast<std::uint32_t>(id));
    };
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PixelPair& p = pixels[i];
        if (p.referenceId == p.testId && !isMended(p.testId)) continue;
        doubtful.push_back(i);
        places.push_back(points[i]);
    }
    const auto covers = truth.covers(places, progress);
    if (!covers) return covers.error();

    std::uint64_t          holes = 0, spills = 0, nearTies = 0, real = 0;
    std::set<std::int64_t> missing;  // winners of pixels that are holes
    for (std::size_t i = 0; i < doubtful.size(); ++i) {
        PixelPair&    p       = pixels[doubtful[i]];
        const auto    first   = std::ranges::lower_bound(*covers, i, {}, &Cover::point);
        const auto    end     = std::ranges::upper_bound(*covers, i, {}, &Cover::point);
        const Verdict verdict = judge(p, std::span(first, end), truth);
        holes += verdict == Verdict::Hole;
        spills += verdict == Verdict::Spill;
        if (verdict == Verdict::Hole) missing.insert(p.referenceId);
        if (verdict != Verdict::OfDepth) continue;
        const bool bothShow = p.referenceId >= 0 && p.testId >= 0;
        ++(bothShow && stepsBetween(p.referenceDepth, p.testDepth) <= kNearTieSteps ? nearTies : real);
    }

    ErrorFigures figures     = compare(pixels, shown);
    figures.holes            = holes;
    figures.spills           = spills;
    figures.nearTies         = nearTies;
    figures.realWrongSurface = real;
    figures.falseCulls       = 0;
    std::ranges::sort(shown);
    for (const std::int64_t face : missing) figures.falseCulls += !std::ranges::binary_search(shown, face);
    return figures;
}

Result<ErrorFigures> compareByFace(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                   const Picture& reference, const Picture& test, const Progress& progress)
{
    std::vector<PixelPair>     pixels;
    std::vector<PixelPosition> points;
    for (int y = 0; y < test.ids.height(); ++y)
        for (int x = 0; x < test.ids.width(); ++x) {
            pixels.push_back({.referenceId    = reference.ids.at(x, y),
                              .testId         = test.ids.at(x, y),
                              .referenceDepth = reference.depth.at(x, y),
                              .testDepth      = test.depth.at(x, y)});
            points.push_back({x, y});
        }
    return compareByFace(scene, camera, faceCulling, std::move(pixels), points, test.ids.values(), progress);
}

}  // namespace zscope
