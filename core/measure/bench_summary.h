// What bench() and benchPath() have in common: how a picture is held against the truth, and how frames become a row.
#pragma once

#include <cstdint>
#include <vector>

#include "core/measure/bench.h"
#include "core/measure/reference.h"

namespace zscope {

/// Pixels whose id or depth bits differ.
std::uint64_t differingPixels(const Picture& reference, const Picture& test);

/// What the reference says of one view, at all pixels or at some, and how a picture stands to it.
class ViewTruth {
public:
    struct Judgement {
        std::uint64_t wrong = 0;  // as BenchRow::wrongPixels
        ErrorFigures  figures;
    };

    /// `seed` chooses the pixels where `samples` asks for some. Errors: Limit, Cancelled.
    Result<Done> find(const BenchRequest& request, const Camera& camera, std::uint64_t seed);
    /// Errors: Cancelled.
    Result<Judgement> judge(const BenchRequest& request, const BenchAlgorithm& algorithm, const Picture& picture) const;

private:
    std::uint64_t        differing(const Picture& picture) const;
    Result<ErrorFigures> figuresOf(const BenchRequest& request, bool byFace, const Picture& picture,
                                   std::uint64_t differing) const;

    Camera                     m_camera;
    bool                       m_isSampled = false;
    Picture                    m_picture;
    std::vector<PixelPosition> m_points;
    std::vector<SampleTruth>   m_samples;
};

/// Fills the timing part of a row from its timed frames, of which there is at least one.
void summarise(std::vector<FrameReport> reports, BenchRow& row);

/// The request for one frame of a run.
DrawRequest drawRequestOf(const BenchRequest& request, std::shared_ptr<const PreparedScene> scene,
                          const BenchAlgorithm& algorithm, int threads, Simd simd, bool shade);

/// Whether shaded pictures are timed, ids and depth alone, or one after the other.
std::vector<bool> shadingsOf(BenchPictures pictures);

}  // namespace zscope
