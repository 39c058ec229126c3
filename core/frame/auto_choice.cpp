#include "core/frame/auto_choice.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include <fmt/format.h>

#include "core/geometry/projection.h"
#include "core/geometry/stripe_volume.h"

namespace zscope {

namespace {

constexpr std::array<std::string_view, AutoChoice::kCandidates> kCandidateNames{"zbuffer", "hzb-octree", "hzb-bvh",
                                                                                "two-pass", "scanline"};

bool visitsTree(const Preset& preset) { return preset.pipeline.order != Order::Submitted; }

}  // namespace

SceneNumbers numbersOf(const PreparedScene& scene, const Camera& camera, int threads)
{
    constexpr std::size_t kSampled  = 4096;
    const auto&           instances = scene.scene().instances;
    const Projection      projection(camera);
    const StripeVolume    view(projection, camera.width, 0, camera.height);
    const std::size_t     step = std::max<std::size_t>(1, instances.size() / kSampled);
    SceneNumbers numbers{.pixels = static_cast<std::uint64_t>(camera.width) * static_cast<std::uint64_t>(camera.height),
                         .threads = threads};
    for (std::size_t i = 0; i < instances.size(); i += step) {
        const MeshBatches& mesh = scene.batchesOf(instances[i].mesh);
        if (!view.misses(PlacedView(projection, instances[i].toWorld)(mesh.bounds)))
            numbers.trianglesInView += step * mesh.triangleCount();
    }
    return numbers;
}

Pipeline chosenInstead(const Pipeline& measured, const Preset& preset)
{
    Pipeline pipeline      = preset.pipeline;
    pipeline.cost          = measured.cost;
    pipeline.transparency  = measured.transparency;
    pipeline.approximation = measured.approximation;
    pipeline.fault         = measured.fault;
    return pipeline;
}

const Preset& AutoChoice::firstPreset(const SceneNumbers& numbers)
{
    return *findPreset(numbers.trianglesInView <= kFewTriangles ? "zbuffer" : "hzb-octree");
}

AutoChoice::AutoChoice(const SceneNumbers& numbers) : m_numbers(numbers)
{
    const Preset& first = firstPreset(numbers);
    for (const std::string_view name : kCandidateNames) {
        m_candidates.push_back({.preset = findPreset(name)});
        assert(m_candidates.back().preset);
        if (name == first.name)
            m_now = m_candidates.size() - 1;
        else
            m_waiting.push_back(m_candidates.size() - 1);
    }
    const bool few = numbers.trianglesInView <= kFewTriangles;
    m_why =
        fmt::format("auto begins with {}: {} triangles may be in view, and {} {} a tree {} expected to pay.",
                    first.name, numbers.trianglesInView, few ? "up to" : "above", kFewTriangles, few ? "is not" : "is");
}

void AutoChoice::drawn(const FrameCost& cost)
{
    ++m_frames;
    if (m_isTrial)
        drawnInTrial(cost);
    else
        drawnAsKept(cost);
}

void AutoChoice::drawnInTrial(const FrameCost& cost)
{
    Candidate&   now      = m_candidates[m_now];
    const bool   anyKnown = std::ranges::any_of(m_candidates, &Candidate::isKnown);
    const double bestMs   = anyKnown ? best().cost.whole : std::numeric_limits<double>::infinity();
    const bool   isTimed  = m_frames > kWarmUp;
    // Whoever visits no tree has no warming up that could make up for this; what is made once is not part of the cost.
    const bool isHopeless = cost.whole > kHopeless * bestMs && !visitsTree(*now.preset);
    if (isTimed || isHopeless) {
        if (!now.isKnown || cost.whole < now.cost.whole) now.cost = cost;
        now.isKnown = true;
    }
    if (isHopeless || m_frames == kWarmUp + (m_takesTurns ? kTimedInTurn : kTimed)) nextTrial();
}

void AutoChoice::drawnAsKept(const FrameCost& cost)
{
    const double usual = m_candidates[m_now].cost.whole;
    m_keptMs += cost.whole;
    m_latestMs[static_cast<std::size_t>(m_frames % kDriftFrames)] = cost.whole;
    const bool isOther = cost.whole > kDrift * usual || cost.whole * kDrift < usual;
    m_drifted          = isOther ? m_drifted + 1 : 0;
    if (m_drifted < kDriftFrames && m_frames < kKeptFrames) return;
    const double now = *std::ranges::min_element(m_latestMs);
    if (m_keptMs < kBudget * costOfTrials(now)) return;

    m_candidates[m_now].cost       = cost;  // known from the frames just drawn
    m_candidates[m_now].cost.whole = now;
    beginTrials();
}

/// Of all but the one that has been drawing.
void AutoChoice::beginTrials()
{
    for (std::size_t i = 0; i < m_candidates.size(); ++i) {
        m_candidates[i].isKnown = i == m_now;
        if (i != m_now) m_waiting.push_back(i);
    }
    m_isTrial    = true;
    m_takesTurns = false;
    nextTrial();
}

void AutoChoice::tryCloseOnesInTurn()
{
    m_takesTurns = true;
    std::vector<std::size_t> close;
    for (std::size_t i = 0; i < m_candidates.size(); ++i)
        if (m_candidates[i].isKnown && m_candidates[i].cost.whole <= kClose * best().cost.whole) close.push_back(i);
    if (close.size() == 1) return;  // nobody is close to the fastest
    for (int turn = 0; turn < kTurns; ++turn) m_waiting.insert(m_waiting.end(), close.begin(), close.end());
}

void AutoChoice::nextTrial()
{
    if (m_waiting.empty() && !m_takesTurns) tryCloseOnesInTurn();
    while (!m_waiting.empty()) {
        m_now = m_waiting.front();
        m_waiting.erase(m_waiting.begin());
        if (!canPay(m_candidates[m_now])) continue;
        m_frames = 0;
        m_why    = fmt::format("auto tries {}: the best so far is {}, which takes {:.2f} ms a frame.", preset().name,
                               best().preset->name, best().cost.whole);
        return;
    }
    if (!m_takesTurns) return nextTrial();
    keepTheBest();
}

void AutoChoice::keepTheBest()
{
    m_now     = static_cast<std::size_t>(&best() - m_candidates.data());
    m_isTrial = false;
    m_frames  = 0;
    m_keptMs  = 0;
    m_drifted = 0;
    m_latestMs.fill(best().cost.whole);
    m_why = whyKept();
}

const AutoChoice::Candidate& AutoChoice::best() const
{
    const Candidate* best = nullptr;
    for (const Candidate& candidate : m_candidates)
        if (candidate.isKnown && (!best || candidate.cost.whole < best->cost.whole)) best = &candidate;
    assert(best);
    return *best;
}

/// No frame of it could be shorter.
double AutoChoice::leastMs(const Candidate& candidate) const
{
    if (visitsTree(*candidate.preset)) return 0;
    return kLeastNs * 1e-6 * static_cast<double>(m_numbers.trianglesInView) / m_numbers.threads;
}

bool AutoChoice::canPay(const Candidate& candidate) const
{
    const bool sweeps = drawsLineByLine(candidate.preset->pipeline);
    if (sweeps && m_numbers.trianglesInView > kSweepTriangles) return false;
    return leastMs(candidate) <= kHopeless * best().cost.whole;
}

/// What trying the others will take longer than drawing the same frames in `keptMs` each. What was never tried is taken
/// for hopeless, and what has become slower or faster since for as much so as the one kept.
double AutoChoice::costOfTrials(double keptMs) const
{
    const double usual = m_candidates[m_now].cost.whole;
    double       extra = 0;
    for (std::size_t i = 0; i < m_candidates.size(); ++i) {
        if (i == m_now || !canPay(m_candidates[i])) continue;
        const double ms         = m_candidates[i].cost.whole;
        const double ratio      = ms > 0 && usual > 0 ? ms / usual : kHopeless;
        const bool   isHopeless = ratio > kHopeless && !visitsTree(*m_candidates[i].preset);
        const int    whole      = kWarmUp + kTimed;
        const int    frames     = isHopeless ? 1 : ratio > kClose ? whole : whole + kTurns * (kWarmUp + kTimedInTurn);
        extra += std::max(0.0, ratio - 1) * keptMs * frames;
    }
    return extra;
}

std::string AutoChoice::whyKept() const
{
    const Candidate& kept  = m_candidates[m_now];
    const Candidate* plain = nullptr;  // draws all that may be in view
    const Candidate* culls = nullptr;  // the fastest that visits a tree
    std::string      others;
    for (const Candidate& candidate : m_candidates) {
        if (!candidate.isKnown) continue;
        if (!visitsTree(*candidate.preset) && !drawsLineByLine(candidate.preset->pipeline)) plain = &candidate;
        if (visitsTree(*candidate.preset) && (!culls || candidate.cost.whole < culls->cost.whole)) culls = &candidate;
        if (&candidate != &kept)
            others += fmt::format("{} {} {:.2f} ms", others.empty() ? ";" : ",", candidate.preset->name,
                                  candidate.cost.whole);
    }
    std::string share;  // of the time for triangles that culling saves
    if (plain && culls && plain->cost.geometry > 0)
        share = fmt::format(", for {:.0f} % of the time for triangles saved",
                            100 * std::max(0.0, 1 - culls->cost.geometry / plain->cost.geometry));
    const double nsPerPixel = m_numbers.pixels > 0 ? 1e6 * kept.cost.raster / static_cast<double>(m_numbers.pixels) : 0;
    const std::string culling =
        &kept == culls ? fmt::format("culling takes {:.2f} ms{}", kept.cost.culling, share)
        : culls ? fmt::format("culling by {} would take {:.2f} ms{}", culls->preset->name, culls->cost.culling, share)
                : "nothing else was tried";
    return fmt::format(
        "auto keeps {}, the fastest with {:.2f} ms a frame: {}, and a pixel of the picture takes {:.1f} ns{}.",
        kept.preset->name, kept.cost.whole, culling, nsPerPixel, others);
}

}  // namespace zscope
