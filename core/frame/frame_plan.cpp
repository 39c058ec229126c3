#include "core/frame/frame_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <omp.h>

#include "core/base/memory.h"
#include "core/base/thread_count.h"
#include "core/frame/auto_choice.h"
#include "core/frame/methods.h"
#include "core/frame/shortcuts.h"
#include "core/geometry/face_batches.h"

namespace zscope {

namespace {

/// What the picture's buffers take. Scratch memory depends on what is in view; running out of it is caught while
/// drawing.
std::uint64_t estimatedBytes(const DrawRequest& request)
{
    const auto pixels = static_cast<std::uint64_t>(request.camera.width + 2 * kRowPadding)
                        * static_cast<std::uint64_t>(request.camera.height);
    return pixels * (sizeof(float) + sizeof(std::uint32_t) + (request.shade ? sizeof(std::uint32_t) : 0));
}

}  // namespace

Result<FramePlan> planFrame(const DrawRequest& request)
{
    if (const auto invalid = explainInvalid(request.pipeline)) return Error{Trouble::Usage, *invalid};
    if (request.threads < 0 || request.threads > kMaxThreads)
        return Error{Trouble::Usage, "the number of threads must lie between 1 and " + std::to_string(kMaxThreads)};
    const Simd simd  = resolved(request.simd);
    const auto entry = std::ranges::find(simdTargets(), simd, &SimdEntry::target);
    if (!entry->available)
        return Error{Trouble::Usage, "this machine or build has no '" + std::string(entry->word) + "' kernels"};

    const std::uint64_t limit  = effectiveMemoryLimit(request.memoryLimit);
    const std::uint64_t needed = estimatedBytes(request);
    if (needed > limit) {
        return Error{Trouble::Limit, "a picture of " + std::to_string(request.camera.width) + "x"
                                         + std::to_string(request.camera.height) + " needs "
                                         + std::to_string(needed >> 20) + " MiB, more than the limit of "
                                         + std::to_string(limit >> 20) + " MiB"};
    }
    // What the last frame's pyramid hides would depend on where the borders between the stripes stood, and so would
    // what a fault spoils: a sweep that begins in the middle of the picture does not make the mistake of the lines
    // before it.
    const bool isOneStripe = request.pipeline.coherence == Coherence::LastPyramid || !request.pipeline.fault.isEmpty();
    const int  wanted      = isOneStripe ? 1 : request.threads > 0 ? request.threads : omp_get_num_procs();
    return FramePlan{std::clamp(wanted, 1, std::max(1, request.camera.height)), simd};
}

DrawRequest repeatable(const DrawRequest& request)
{
    if (request.pipeline.chooser != Chooser::Measured) return request;
    const SceneNumbers numbers = numbersOf(*request.scene, request.camera, 1);
    DrawRequest        first   = request;
    first.pipeline             = chosenInstead(request.pipeline, AutoChoice::firstPreset(numbers));
    return first;
}

namespace {

StageReason reasonForPrepass(DepthMoment moment)
{
    switch (moment) {
        case DepthMoment::Prepass:
            return {true, "depth alone first, for every triangle in view"};
        case DepthMoment::Deferred:
            return {false, "depth is decided before anything is shaded, in one pass"};
        case DepthMoment::Late:
            return {false, "each fragment is shaded, then tested, in one pass"};
        case DepthMoment::Early:
            return {false, "each fragment is tested, then shaded, in one pass"};
        case DepthMoment::ZCull:
            return {false, "tiles, then each of their fragments, are tested in one pass"};
    }
    return {false, ""};
}

StageReason reasonForUpkeep(const Pipeline& pipeline)
{
    if (pipeline.coherence == Coherence::LastPyramid)
        return {true, "the whole pyramid, when the frame is over, for the next one"};
    if (pipeline.coherence == Coherence::TwoPass)
        return {true,
                "all cells made stale after the first pass; then recomputed when a query meets them: counted with cull "
                "and raster"};
    switch (pipeline.upkeep) {
        case Upkeep::None:
            return pipeline.depth == DepthMoment::ZCull
                       ? StageReason{true, "stale tiles, when one is read: counted with raster"}
                       : StageReason{false, "there is no pyramid to keep"};
        case Upkeep::Pushed:
        case Upkeep::PushedFarthest:
            return {true, "after each triangle, upwards as far as cells change: counted with raster"};
        case Upkeep::Masked:
            return {true,
                    "two layers per tile after each triangle, cells above them when a query meets them: counted with "
                    "raster and cull"};
        default:
            return {true, "stale cells, when a query meets them: counted with cull and raster"};
    }
}

/// How many opaque triangles of the scene have holes, and how many a relief.
struct PatternedTriangles {
    std::uint64_t cutOut = 0, moved = 0;

    bool any() const { return cutOut + moved != 0; }
};

PatternedTriangles patternedTrianglesOf(const Mesh& mesh)
{
    PatternedTriangles all;
    if (std::ranges::none_of(mesh.materials, &Material::isPatterned)) return all;
    for (const PolygonId face : mesh.trianglePolygon) {
        const Material& material = mesh.materialOf(face);
        if (material.opacity < 1) continue;
        all.cutOut += material.cutout.has_value();
        all.moved += material.relief.has_value();
    }
    return all;
}

PatternedTriangles patternedTrianglesOf(const PreparedScene& scene)
{
    const auto counted = [&scene] {
        std::vector<PatternedTriangles> ofMesh;
        for (const auto& mesh : scene.scene().meshes) ofMesh.push_back(patternedTrianglesOf(*mesh));
        auto all = std::make_unique<PatternedTriangles>();
        for (const Instance& instance : scene.scene().instances) {
            all->cutOut += ofMesh[instance.mesh.value].cutOut;
            all->moved += ofMesh[instance.mesh.value].moved;
        }
        return all;
    };
    return scene.derived().get<PatternedTriangles>(counted);
}

std::string aboutPatterns(const PreparedScene& scene, DepthMoment moment)
{
    const PatternedTriangles all       = patternedTrianglesOf(scene);
    const auto               triangles = [](std::uint64_t count) {
        return std::to_string(count) + (count == 1 ? " triangle" : " triangles");
    };
    if (!all.any()) return "; no fragment can be discarded or moved";
    std::string about;
    if (all.cutOut > 0)
        about += "; " + triangles(all.cutOut) + " can be discarded: " + (all.cutOut == 1 ? "its" : "their")
                 + " depth is written late";
    if (all.moved == 0) return about;
    about += "; the fragments of " + triangles(all.moved) + " are moved away from the eye: ";
    return about
           + (moment == DepthMoment::Late ? "each is shaded, moved and tested once"
                                          : "an early test, a tile or the pyramid can only say no for where the "
                                            "triangle is; what passes is moved and tested again");
}

/// No depth, and nothing that a plane of depths is computed from, comes near the ends of float64, whatever the scale:
/// none loses bits.
bool isFarFromLimits(const Camera& camera, const Bounds& bounds)
{
    const auto isModest = [](double value) { return std::abs(value) < 0x1p100; };
    const auto isSize   = [&](double value) { return value > 0x1p-100 && isModest(value); };
    const auto isPlace  = [&](const dvec3& p) { return isModest(p.x) && isModest(p.y) && isModest(p.z); };
    return isSize(camera.near) && isSize(camera.focal) && isPlace(camera.eye) && isPlace(bounds.min)
           && isPlace(bounds.max);
}

StageReason reasonForShade(const DrawRequest& request)
{
    if (!request.shade) return {false, "no colours were asked for"};
    if (shadesFragments(request.pipeline.depth)) {
        return toBeBlended(request) ? StageReason{true,
                                                  "opaque fragments were shaded one by one, counted with raster; "
                                                  "transparent surfaces over them"}
                                    : StageReason{false, "shaded with each fragment: counted with raster"};
    }
    return {true, toBeBlended(request) ? "each pixel once, from its triangle; then transparent surfaces over it"
                                       : "each pixel once, from its triangle; nothing is transparent"};
}

}  // namespace

StageReason reasonFor(Stage stage, const DrawRequest& request)
{
    const Pipeline& pipeline = request.pipeline;
    const auto&     clauses  = methodOf(pipeline).stages;
    switch (stage) {
        case Stage::Clear:
            return {true, std::string(clauses.clear)};
        case Stage::Transform:
            return {true, "every batch that may reach the picture"};
        case Stage::Cull:
            return {true, asksNodes(pipeline.cull) ? "nodes against the frustum and the pyramid"
                                                   : "boxes against the frustum"};
        case Stage::Setup:
            return {true, std::string(clauses.setUp)};
        case Stage::Prepass:
            return reasonForPrepass(pipeline.depth);
        case Stage::Build:
            if (drawsFaces(pipeline)) return {true, "whole faces, cut into batches on the first frame and kept"};
            if (drawsPatchedBatches(request)) return {true, "batches patch by patch, made on the first frame and kept"};
            return pipeline.order != Order::Submitted
                       ? StageReason{true, "the hierarchy's nodes, when first entered; kept between frames"}
                       : StageReason{false, "no hierarchy is visited"};
        case Stage::Raster:
            return {true, std::string(clauses.raster) + aboutPatterns(*request.scene, pipeline.depth)};
        case Stage::Upkeep:
            return reasonForUpkeep(pipeline);
        case Stage::Shade:
            return reasonForShade(request);
        case Stage::Other:
            return {true,
                    "sizing buffers, starting threads, waiting for the slowest; on a first frame also the colours"};
    }
    return {false, ""};
}

bool drawsPatchedBatches(const DrawRequest& request)
{
    const Pipeline& pipeline = request.pipeline;
    if (isPlain(request) || !request.shortcuts.has(Shortcut::PatchedBatches) || pipeline.order != Order::Submitted
        || request.faceCulling != FaceCulling::Back || LaneRules(pipeline.approximation, request.camera).movesCorners())
        return false;
    return !drawsFaces(pipeline) || facesOf(*request.scene).someAreTriangles();
}

bool isPlain(const DrawRequest& request)
{
    return !request.shortcuts.has(Shortcut::Lanes) || resolved(request.simd) == Simd::Scalar
           || !whyPlain(request.pipeline).empty();
}

DepthEncoding encodingOf(const DrawRequest& request, const VisibilityBuffer& visible)
{
    const Camera&       camera = request.camera;
    const DepthEncoding plain(request.pipeline.approximation.format, camera.near, camera.far);
    if (isPlain(request) || !request.shortcuts.has(Shortcut::StackedDepths)) return plain;
    // Faces and reliefs know depths of one scale only, a pyramid that is kept for the next frame holds those of this
    // one, and what is blended is compared with what memory holds.
    const bool isOne = drawsFaces(request.pipeline) || patternedTrianglesOf(*request.scene).any()
                       || request.pipeline.coherence == Coherence::LastPyramid || toBeBlended(request);
    const LaneRules rules(request.pipeline.approximation, camera);
    if (isOne || !rules.hasExactDepths() || rules.usesFloat32Vertices()) return plain;
    return plain.empty >= std::numeric_limits<float>::min() && isFarFromLimits(camera, request.scene->scene().bounds)
               ? visible.encodingAbove(plain)
               : plain;
}

Projection projectionOf(const DrawRequest& request, const ChosenRules& rules, double depthScale)
{
    const Camera& camera = request.camera;
    Projection projection(camera, depthScale, displacementOf(request.pipeline.approximation, camera, *request.scene));
    // All text samples pixels in their centres: to sample them elsewhere is to move the picture.
    projection.centreX += 0.5 - rules.sampleOffset();
    projection.centreY += 0.5 - rules.sampleOffset();
    return projection;
}

const TransparentSurfaces* toBeBlended(const DrawRequest& request)
{
    if (!request.shade) return nullptr;
    const TransparentSurfaces& surfaces = transparentSurfacesOf(*request.scene);
    return surfaces.isEmpty() ? nullptr : &surfaces;
}

ChosenRules rulesOfBlending(const DrawRequest& request)
{
    Approximation approximation = request.pipeline.approximation;
    if (approximation.snap == SnapBits::Twelve) approximation.snap = SnapBits::Eight;  // a sweep counts in 1/256 pixel
    return {approximation, FaultSet{}, request.camera};
}

const ColourTable& coloursOf(const PreparedScene& scene)
{
    return scene.derived().get<ColourTable>([&scene] { return std::make_unique<ColourTable>(scene.scene()); });
}

}  // namespace zscope
