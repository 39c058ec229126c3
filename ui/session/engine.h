// SPDX-License-Identifier: GPL-3.0-or-later
// What the worker does for the session: loads, draws, replays. No threads and no signals in here, so that a test
// calls it directly.
//
// Threads    one thread at a time; the values it returns are shared and never written again
// Memory     frames that nobody shows any more are drawn over, so that a frame's time is not that of fresh pages
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/session/snapshot.h"

namespace zscope::ui {

/// Where to stand in a run, as the user said it: the number of steps may not be known yet.
struct StepWish {
    enum class From { Start, End, Fraction, Stage };

    Grain         grain    = Grain::Frame;  // of the steps to show
    From          from     = From::End;
    std::uint64_t offset   = 0;  // steps of `counted` from the start, or back from the end
    double        fraction = 1;  // of the run or of the stage, in [0, 1]
    // whose steps are meant; a run without it stands at the same part of the whole
    zscope::Stage stage     = zscope::Stage::Other;
    Grain         counted   = Grain::Frame;
    Grain         moveGrain = Grain::Frame;
    int           move      = 0;  // then so many steps of moveGrain
    int           after     = 0;  // then so many steps of grain

    bool isEnd() const { return from == From::End && offset == 0 && move == 0 && after == 0; }
};

class Engine {
public:
    Result<std::shared_ptr<const LoadedScene>> load(const QString& word, const LoadOptions& options) const;
    Result<std::shared_ptr<const DrawnFrame>>  draw(std::uint64_t generation, const DrawRequest& request,
                                                    const Look& look);
    Result<std::shared_ptr<const ShownStep>>   step(std::uint64_t generation, const DrawRequest& request,
                                                    const Look& look, const StepWish& wish);

private:
    /// The step of wish.grain that the wish means, in [0, count).
    Result<std::uint64_t> resolve(const StepWish& wish, std::uint64_t count);
    /// Up to so many frames more of the same, and the report of that whose time is the median.
    Result<FrameReport>         drawAgain(const DrawRequest& request, std::size_t most, DrawnFrame& drawn);
    std::shared_ptr<DrawnFrame> unusedFrame();

    Renderer                                 m_renderer;
    std::optional<Replay>                    m_replay;  // of generation m_replayOf
    std::uint64_t                            m_replayOf = 0;
    std::vector<std::shared_ptr<DrawnFrame>> m_frames;
    std::weak_ptr<const PreparedScene>       m_drawnScene;     // by the last drawing
    std::optional<Pipeline>                  m_drawnPipeline;  // likewise
    std::shared_ptr<const DrawnFrame>        m_latest;         // what is pale in the pictures of steps
};

/// The step's picture, with the pixels that only later steps will cover shown in a pale version of the finished one.
QImage ghosted(const ShownStep& step, const DrawnFrame& finished);
/// The same picture as it looks otherwise. `finished` is what is pale in the step's, or nullptr.
std::shared_ptr<const DrawnFrame> repainted(const DrawnFrame& frame, const Look& look);
std::shared_ptr<const ShownStep>  repainted(const ShownStep& step, const DrawnFrame* finished, const Look& look);

/// B held against A; both of one size.
std::shared_ptr<const Comparison> compared(std::shared_ptr<const DrawnFrame> a, std::shared_ptr<const DrawnFrame> b,
                                           std::uint32_t tolerance);
std::shared_ptr<const Comparison> compared(std::shared_ptr<const ShownStep> a, std::shared_ptr<const ShownStep> b,
                                           std::uint32_t tolerance);
/// What another program drew held against A, which has its camera.
std::shared_ptr<const Comparison> compared(std::shared_ptr<const DrawnFrame>   a,
                                           std::shared_ptr<const TheirPicture> theirs);
/// With the range of A's depths; nullptr: with its own.
std::shared_ptr<const TheirPicture> repainted(const TheirPicture& theirs, const Look& look, const DrawnFrame* a);

/// A view of the colours, valid while they live; not a copy.
QImage imageOf(const Grid<std::uint32_t>& colours);

}  // namespace zscope::ui
