// Draws a frame: scene and camera in, visibility buffer and colours out.
//
// Promise    the picture depends on scene, camera, face culling and the pipeline's approximations only: never on
//            threads, lanes or order (but what cells=one-level leaves out depends on where the stripes begin). No
//            allocation per frame of the fast text once the sizes have settled
// Threads    draw() is called from one thread at a time and uses OpenMP inside: the picture is cut into stripes
//            of whole lines, and each stripe is drawn from start to finish by one thread
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/shortcut.h"
#include "core/base/simd.h"
#include "core/base/stages.h"
#include "core/base/tally.h"
#include "core/depth/visibility_buffer.h"
#include "core/frame/frame_work.h"
#include "core/frame/pipeline.h"
#include "core/geometry/prepared_scene.h"
#include "core/scene/view.h"

namespace zscope {

/// What to draw and how. A value: it may be copied to another thread; the scene is shared.
struct DrawRequest {
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;
    FaceCulling                          faceCulling = FaceCulling::None;
    Pipeline                             pipeline;
    int                                  threads     = 0;  // 0: one per core
    Simd                                 simd        = Simd::Auto;
    ShortcutSet                          shortcuts   = ShortcutSet::all();  // none: the plain text draws
    bool                                 shade       = true;
    std::uint64_t                        memoryLimit = 0;  // bytes; 0: three quarters of the machine's memory
    const std::atomic<bool>*             cancel      = nullptr;
};

/// What a frame leaves behind. Reuse one object for many frames.
struct Frame {
    // its pixels are written if the request did not ask for shading; else some tiles may be kept as planes
    VisibilityBuffer    visible;
    Grid<std::uint32_t> colour;   // 0xAARRGGBB, opaque; empty if the request did not ask for shading
    Grid<std::uint8_t>  painted;  // the renderer's own: which tiles of `colour` the last frame painted
};

struct FrameReport {
    Pipeline                pipeline;   // that drew: of a measured one, the one that was chosen
    ShortcutSet             shortcuts;  // that were chosen
    double                  frameMs = 0;
    std::vector<StageTime>  stages;  // all of kStages, in order; their ms add up to frameMs
    std::vector<NamedCount> bytes;   // of every structure of the frame
    Tally                   tally;   // what this very run did, in its own units
    int                     threads = 1;
    Simd                    simd    = Simd::Scalar;

    // Of a pipeline that is measured (the preset `auto`); else empty.
    std::string_view chosen;           // the preset that drew this frame
    std::string      why;              // one sentence
    bool             isTrial = false;  // it was drawn to learn how long that takes
};

class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Errors: Usage (invalid pipeline, unavailable SIMD target), Limit (memory), Cancelled.
    Result<FrameReport> draw(const DrawRequest& request, Frame& frame);

    /// The work of the textbook method on the same frame, counted in a run of its own: plain text, one thread. Of a
    /// method with coherence: of the frame that draw() drew last, if it drew this request by plain text with one
    /// thread; else of a frame that follows one of the same request.
    Result<FrameWork> count(const DrawRequest& request);

private:
    Result<FrameReport> drawComposed(const DrawRequest& request, Frame& frame);
    Result<FrameReport> drawMeasured(const DrawRequest& request, Frame& frame);

    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;  // scratch memory, reused frame after frame
};

}  // namespace zscope
