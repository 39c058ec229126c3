// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/engine.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include <QFileInfo>

#include "core/measure/empty_picture.h"

namespace zscope::ui {
namespace {

/// A first frame spends its time on fresh pages and on what is made once. Where it took less than so many ms, it is
/// drawn again for a time worth telling: of another scene or pipeline so many times, or until that took so many ms; of
/// another size once.
constexpr double      kWorthRepeating = 250;
constexpr std::size_t kFramesToTell   = 9;
constexpr double      kMsToTell       = 80;

constexpr std::size_t kFramesKept = 3;  // one shown, one in the queue of the window, one being drawn

/// Counts covered pixels and the triangles that own one.
void takeStock(DrawnFrame& drawn, std::uint64_t triangles)
{
    std::vector<bool>       seen(triangles + 1, false);  // by rank
    const VisibilityBuffer& visible = drawn.frame.visible;
    for (int y = 0; y < visible.height(); ++y) {
        for (int x = 0; x < visible.width(); ++x) {
            const std::uint32_t rank = visible.rankAt(x, y);
            if (rank == 0) continue;
            ++drawn.coveredPixels;
            if (seen[rank]) continue;
            seen[rank] = true;
            ++drawn.visibleTriangles;
        }
    }
}

/// Nothing for the shaded picture: the frame holds it. Nor for tests that nobody has counted.
Grid<std::uint32_t> paintedBy(const Look& look, const Frame& frame, const Grid<std::uint32_t>* tests)
{
    if (look.isShaded() || (look.layer->needsTests && !tests)) return {};
    return look.layer->paint({.frame = frame, .tests = tests, .range = look.range});
}

DepthSpread spreadOf(const Look& look, const VisibilityBuffer& visible)
{
    if (look.layer->word != "depth") return {};
    return {fixedRange({.isAutomatic = true, .isLogarithmic = look.range.isLogarithmic}, visible),
            fixedRange(look.range, visible), depthHistogram(visible, look.range, DepthSpread::kParts)};
}

void paint(DrawnFrame& drawn, const Look& look)
{
    drawn.look    = look;
    drawn.painted = paintedBy(look, drawn.frame, nullptr);
    drawn.spread  = spreadOf(look, drawn.frame.visible);
}

void paint(ShownStep& shown, const Look& look)
{
    shown.look    = look;
    shown.painted = paintedBy(look, shown.state.frame, &shown.state.tests);
    shown.spread  = spreadOf(look, shown.state.frame.visible);
}

QRgb mixed(QRgb a, QRgb b, int parts)  // parts of 256 of b
{
    const auto part = [parts](int from, int to) { return from + ((to - from) * parts) / 256; };
    return qRgb(part(qRed(a), qRed(b)), part(qGreen(a), qGreen(b)), part(qBlue(a), qBlue(b)));
}

}  // namespace

Result<std::shared_ptr<const LoadedScene>> Engine::load(const QString& word, const LoadOptions& options) const
{
    auto scene = loadScene(word.toStdString(), options);
    if (!scene) return scene.error();

    auto loaded   = std::make_shared<LoadedScene>();
    loaded->word  = word;
    loaded->title = word.startsWith(QLatin1String("builtin:")) ? word.mid(8) : QFileInfo(word).fileName();
    loaded->cube  = normalCubeOf(*scene);
    for (const auto& mesh : scene->meshes) {
        loaded->vertices += mesh->positions.size();
        loaded->polygons += mesh->polygonCount();
    }
    loaded->prepared = std::make_shared<PreparedScene>(std::make_shared<const Scene>(std::move(scene).value()));
    return std::shared_ptr<const LoadedScene>(std::move(loaded));
}

Result<std::shared_ptr<const DrawnFrame>> Engine::draw(std::uint64_t generation, const DrawRequest& request,
                                                       const Look& look)
{
    std::shared_ptr<DrawnFrame> drawn     = unusedFrame();
    const bool                  isNewCase = m_drawnScene.lock() != request.scene || m_drawnPipeline != request.pipeline;
    const bool                  isNewSize =
        drawn->frame.visible.width() != request.camera.width || drawn->frame.visible.height() != request.camera.height;
    m_drawnScene    = request.scene;
    m_drawnPipeline = request.pipeline;
    auto report     = m_renderer.draw(request, drawn->frame);
    if (!report) return report.error();
    drawn->framesTimed = 1;
    if ((isNewCase || isNewSize) && report->frameMs < kWorthRepeating)
        report = drawAgain(request, isNewCase ? kFramesToTell : 1, *drawn);
    if (!report) return report.error();

    drawn->generation = generation;
    drawn->camera     = request.camera;
    drawn->pipeline   = request.pipeline;
    drawn->report     = std::move(report).value();
    paint(*drawn, look);
    drawn->coveredPixels    = 0;
    drawn->visibleTriangles = 0;
    takeStock(*drawn, request.scene->scene().triangleCount());
    drawn->whyEmpty.clear();
    if (drawn->coveredPixels == 0)
        if (auto why = whyEmpty(request, drawn->frame)) drawn->whyEmpty = std::move(why->sentence);
    m_latest = drawn;
    return std::shared_ptr<const DrawnFrame>(std::move(drawn));
}

Result<FrameReport> Engine::drawAgain(const DrawRequest& request, std::size_t most, DrawnFrame& drawn)
{
    std::vector<FrameReport> reports;
    double                   ms = 0;
    while (reports.empty() || (reports.size() < most && ms < kMsToTell)) {
        auto report = m_renderer.draw(request, drawn.frame);
        if (!report) return report;
        ms += report->frameMs;
        reports.push_back(std::move(report).value());
    }
    drawn.framesTimed = reports.size();
    // of an even number the lower one: a frame that was drawn
    const auto median = reports.begin() + static_cast<std::ptrdiff_t>((reports.size() - 1) / 2);
    std::ranges::nth_element(reports, median, {}, &FrameReport::frameMs);
    return std::move(*median);
}

std::shared_ptr<DrawnFrame> Engine::unusedFrame()
{
    const auto unused = std::ranges::find_if(m_frames, [](const auto& frame) { return frame.use_count() == 1; });
    if (unused != m_frames.end()) {
        std::atomic_thread_fence(std::memory_order_acquire);  // after the last reader let go
        return *unused;
    }
    auto frame = std::make_shared<DrawnFrame>();
    if (m_frames.size() < kFramesKept) m_frames.push_back(frame);
    return frame;
}

Result<std::shared_ptr<const ShownStep>> Engine::step(std::uint64_t generation, const DrawRequest& request,
                                                      const Look& look, const StepWish& wish)
{
    const auto begin = std::chrono::steady_clock::now();
    if (!m_replay || m_replayOf != generation) {
        m_replay.emplace(request);
        m_replayOf = generation;
    }
    const auto count = m_replay->count(wish.grain);
    if (!count) return count.error();
    const auto at = resolve(wish, *count);
    if (!at) return at.error();
    auto state = m_replay->at(wish.grain, StepIndex{*at});
    if (!state) return state.error();

    auto shown        = std::make_shared<ShownStep>();
    shown->generation = generation;
    shown->camera     = request.camera;
    shown->pipeline   = request.pipeline;
    shown->state      = std::move(state).value();
    if (auto stages = m_replay->stages(wish.grain)) shown->stages = std::move(stages).value();
    paint(*shown, look);
    shown->pyramid = pyramidOf(shown->state);
    if (m_latest && m_latest->generation == generation) shown->ghosted = ghosted(*shown, *m_latest);
    shown->replayMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return std::shared_ptr<const ShownStep>(std::move(shown));
}

Result<std::uint64_t> Engine::resolve(const StepWish& wish, std::uint64_t count)
{
    const auto limited = [](std::int64_t step, std::uint64_t of) {
        return static_cast<std::uint64_t>(std::clamp<std::int64_t>(step, 0, static_cast<std::int64_t>(of) - 1));
    };
    const bool byPart  = wish.from == StepWish::From::Fraction || wish.from == StepWish::From::Stage;
    const auto counted = byPart ? Result<std::uint64_t>(count) : m_replay->count(wish.counted);
    if (!counted) return counted.error();
    const auto offset = static_cast<std::int64_t>(wish.offset);

    std::uint64_t at    = 0;
    Grain         grain = wish.counted;
    switch (wish.from) {
        case StepWish::From::Start:
            at = limited(offset, *counted);
            break;
        case StepWish::From::End:
            at = limited(static_cast<std::int64_t>(*counted) - 1 - offset, *counted);
            break;
        case StepWish::From::Fraction:
            at    = limited(std::llround(wish.fraction * static_cast<double>(count - 1)), count);
            grain = wish.grain;
            break;
        case StepWish::From::Stage: {
            const auto stages = m_replay->stages(wish.grain);
            if (!stages) return stages.error();
            const auto    in   = std::ranges::find(*stages, wish.stage, &StageMark::stage);
            std::uint64_t from = 0, end = count;
            if (in != stages->end()) {
                from = in->first;
                end  = in + 1 != stages->end() ? (in + 1)->first : count;
            }
            at =
                limited(static_cast<std::int64_t>(from) + std::llround(wish.fraction * static_cast<double>(end - from)),
                        in != stages->end() ? end : count);
            grain = wish.grain;
            break;
        }
    }
    if (wish.move != 0) {
        const auto all  = m_replay->count(wish.moveGrain);
        const auto done = m_replay->eventsBy(wish.moveGrain, grain, StepIndex{at});
        if (!all) return all.error();
        if (!done) return done.error();
        auto target = static_cast<std::int64_t>(*done) - 1 + wish.move;
        if (wish.move < 0 && *done > 0) {  // between two coarse events, the first step back goes to the earlier one
            const auto there = m_replay->eventsBy(grain, wish.moveGrain, StepIndex{*done - 1});
            if (!there) return there.error();
            if (*there - 1 < at) ++target;
        }
        at    = limited(target, *all);
        grain = wish.moveGrain;
    }
    if (grain != wish.grain) {
        const auto done = m_replay->eventsBy(wish.grain, grain, StepIndex{at});
        if (!done) return done.error();
        at = limited(static_cast<std::int64_t>(*done) - 1, count);
    }
    return limited(static_cast<std::int64_t>(at) + wish.after, count);
}

std::shared_ptr<const DrawnFrame> repainted(const DrawnFrame& frame, const Look& look)
{
    auto other = std::make_shared<DrawnFrame>(frame);
    paint(*other, look);
    return other;
}

std::shared_ptr<const ShownStep> repainted(const ShownStep& step, const DrawnFrame* finished, const Look& look)
{
    auto other = std::make_shared<ShownStep>(step);
    paint(*other, look);
    other->ghosted = finished && finished->generation == step.generation ? ghosted(*other, *finished) : QImage();
    return other;
}

QImage ghosted(const ShownStep& step, const DrawnFrame& finished)
{
    constexpr int kPale = 205;  // of 256 towards the background

    const auto& visible  = step.state.frame.visible;
    const auto& colours  = step.painted.width() > 0 ? step.painted : step.state.frame.colour;
    const auto& complete = finished.painted.width() > 0 ? finished.painted : finished.frame.colour;
    QImage      image(visible.width(), visible.height(), QImage::Format_RGB32);
    for (int y = 0; y < visible.height(); ++y) {
        const auto here  = colours.view().row(y);
        const auto there = complete.view().row(y);
        auto*      out   = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < visible.width(); ++x) {
            const auto at = static_cast<std::size_t>(x);
            out[x]        = visible.rankAt(x, y) == 0 && finished.frame.visible.rankAt(x, y) != 0
                                ? mixed(there[at], here[at], kPale)
                                : here[at];
        }
    }
    return image;
}

namespace {

bool claimsToBeRight(const Pipeline& pipeline) { return pipeline.fault.isEmpty() && claimOf(pipeline) == Claim::Exact; }

template <class Shown>  // DrawnFrame or ShownStep
void compareInto(Comparison& result, const Shown& shownA, const VisibilityBuffer& a, const Shown& shownB,
                 const VisibilityBuffer& b, std::uint32_t tolerance)
{
    result.tolerance  = tolerance;
    result.difference = differenceOf(a, b, tolerance);
    result.isAJudged  = claimsToBeRight(shownB.pipeline) && !claimsToBeRight(shownA.pipeline);
    result.figures    = result.isAJudged ? compare(pictureOf(b), pictureOf(a)) : compare(pictureOf(a), pictureOf(b));
}

}  // namespace

std::shared_ptr<const Comparison> compared(std::shared_ptr<const DrawnFrame> a, std::shared_ptr<const DrawnFrame> b,
                                           std::uint32_t tolerance)
{
    auto result = std::make_shared<Comparison>();
    compareInto(*result, *a, a->frame.visible, *b, b->frame.visible, tolerance);
    result->a = std::move(a);
    result->b = std::move(b);
    return result;
}

std::shared_ptr<const Comparison> compared(std::shared_ptr<const ShownStep> a, std::shared_ptr<const ShownStep> b,
                                           std::uint32_t tolerance)
{
    auto result = std::make_shared<Comparison>();
    compareInto(*result, *a, a->state.frame.visible, *b, b->state.frame.visible, tolerance);
    result->stepA = std::move(a);
    result->stepB = std::move(b);
    return result;
}

std::shared_ptr<const Comparison> compared(std::shared_ptr<const DrawnFrame>   a,
                                           std::shared_ptr<const TheirPicture> theirs)
{
    auto result        = std::make_shared<Comparison>();
    auto found         = differenceOf(a->frame.visible, drawsFaces(a->pipeline), *theirs);
    result->difference = std::move(found.difference);
    result->rounding   = found.rounding;
    result->a          = std::move(a);
    result->theirs     = std::move(theirs);
    return result;
}

std::shared_ptr<const TheirPicture> repainted(const TheirPicture& theirs, const Look& look, const DrawnFrame* a)
{
    auto other = std::make_shared<TheirPicture>(theirs);
    Look used  = look;
    if (a) used.range = fixedRange(look.range, a->frame.visible);
    paint(*other, used);
    return other;
}

QImage imageOf(const Grid<std::uint32_t>& colours)
{
    if (colours.width() == 0) return {};
    return {reinterpret_cast<const uchar*>(colours.values().data()), colours.width(), colours.height(),
            colours.width() * static_cast<qsizetype>(sizeof(QRgb)), QImage::Format_RGB32};
}

}  // namespace zscope::ui
