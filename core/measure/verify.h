// Draws a scene by several algorithms, thread counts and vector targets and holds every picture against the
// reference: the library part of `zscope-cli verify`.
//
// Promise    the reference is made once; every row compares all pixels, or the same sampled pixels
// Frames     every row draws two, with a renderer of its own: a first one, and one that may use what the first left
//            behind. Of a method with coherence it draws four more: the same again after one that looks the other way,
//            a cut, and after one a quarter of the picture to the side. A picture that differs from the first is judged
//            too, and the worst of them is the row's
// Culling    a stream method that skips more than batches outside the view is audited as well, once: its verdicts
//            against the triangles that the reference shows (core/measure/cull_audit.h)
// Colours    of a scene with transparent surfaces are judged too, by the shading cost of each row's pipeline, unless
//            pixels are sampled. Of a method that draws whole faces they are held against those that follow from its
//            own ids and depths
// Cost       one brute-force picture (or its samples), two frames per row, one serial frame per audit
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/measure/error_figures.h"
#include "core/measure/reference.h"
#include "core/measure/reference_colours.h"

namespace zscope {

struct VerifyRequest {
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;
    FaceCulling                          faceCulling = FaceCulling::None;
    std::vector<Preset>                  algorithms;         // drawn in this order
    std::vector<int>                     threads     = {0};  // each algorithm with each; 0: one per core
    std::vector<Simd>                    simd        = {Simd::Auto};
    ShortcutSet                          shortcuts   = ShortcutSet::all();
    std::optional<std::uint64_t>         samples     = {};  // random pixels instead of all
    std::uint64_t                        sampleSeed  = 1;
    std::uint64_t                        memoryLimit = 0;  // bytes a frame may take; 0: as DrawRequest
    Progress                             progress    = {};
};

struct VerifyRow {
    std::string  algorithm;
    Claim        claim   = Claim::Exact;
    int          threads = 1;  // as used
    Simd         simd    = Simd::Scalar;
    ErrorFigures figures;  // by face for a method that draws whole faces (core/measure/face_figures.h)
    /// Of the audit, or those that the picture itself betrays (ErrorFigures::falseCulls) if they are more or nothing
    /// was audited: threads cull by stripes of their own, and the audited run has one.
    std::uint64_t falseCulls = 0;
    /// Where something is transparent and every pixel is compared: how the shaded picture differs.
    std::optional<ColourFigures> colours = {};

    /// An exact method without any difference, or one that covers exactly what it should by face; both with the right
    /// colours. An approximate one is not judged, it publishes its figures.
    bool passed() const
    {
        if (claim == Claim::Approximate) return true;
        if (colours && colours->wrong > 0) return false;
        if (claim == Claim::ExactByFace) return figures.wrongCoverage() == 0;
        return figures.isExact() && falseCulls == 0;
    }
};

/// Errors: what the renderer refuses, Limit, Cancelled.
Result<std::vector<VerifyRow>> verify(const VerifyRequest& request);

/// `count` pixels of the picture, each chosen alike, repeats possible; the same for the same seed everywhere.
std::vector<PixelPosition> randomPixels(const Camera& camera, std::uint64_t count, std::uint64_t seed);

}  // namespace zscope
