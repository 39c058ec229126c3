// The preset `auto`: which method draws the next frame, from what earlier frames of the same scene cost.
//
// First      a frame of which nothing is known takes the z-buffer if few triangles can be in view, else the
//            hierarchical z-buffer over an octree. This depends on scene and camera only; stepping and counting stop
//            here
// Trials     then every candidate draws kWarmUp frames that are not timed (trees are built, memories filled) and kTimed
//            that are; the shortest counts, for any one of them may have been held up. Those within kClose of the
//            fastest then take turns, kTurns times: a machine has other work, for a frame or for a second, and who
//            draws by turns meets the same of it. One that cannot pay is left out: a method without a hierarchy whose
//            least conceivable time is kHopeless times the best known, a sweep with more than a few triangles in view
// Kept       the fastest draws until its time has drifted by kDrift for kDriftFrames frames in a row, or for
//            kKeptFrames; then the others are tried again, but not before it has drawn kBudget times as long as that
//            cost last time, so that trials take about one part in kBudget of all time at most
// Measured   not asked of the clock here: the caller says what a frame cost, so that tests can make it up
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/frame/pipeline.h"
#include "core/geometry/prepared_scene.h"
#include "core/scene/view.h"

namespace zscope {

/// What is known of a scene before anything has been drawn.
struct SceneNumbers {
    // of instances whose boxes reach the view; of many instances a sample is looked at
    std::uint64_t trianglesInView = 0;
    std::uint64_t pixels          = 0;  // of the picture
    int           threads         = 1;
};
SceneNumbers numbersOf(const PreparedScene& scene, const Camera& camera, int threads);

/// What a frame took, in ms. The parts need not add up.
struct FrameCost {
    double whole    = 0;  // but for what is made once and kept
    double geometry = 0;  // transform and set-up of what was not left out
    double culling  = 0;  // finding out what can be left out, and keeping what is asked true
    double raster   = 0;
};

/// The preset's choices with what the pipeline that it draws for says of shading, blending, approximations and faults.
Pipeline chosenInstead(const Pipeline& measured, const Preset& preset);

class AutoChoice {
public:
    static constexpr std::uint64_t kFewTriangles   = 300'000;  // in view: below, no tree is expected to pay
    static constexpr std::uint64_t kSweepTriangles = 2'000;    // in view: above, a sweep cannot win
    // per triangle in view and thread: no method without a tree is faster
    static constexpr double kLeastNs  = 10;
    static constexpr double kHopeless = 4;                 // times the best
    static constexpr int    kWarmUp = 1, kTimed = 2;       // frames of a trial
    static constexpr int    kTurns = 8, kTimedInTurn = 1;  // of those that are close; every turn warms up
    static constexpr double kClose       = 1.6;
    static constexpr double kDrift       = 1.5;
    static constexpr int    kDriftFrames = 3;
    static constexpr int    kKeptFrames  = 300;
    static constexpr double kBudget      = 100;
    static constexpr int    kCandidates  = 5;  // presets that may be tried
    /// Frames after which a choice is made, whatever they cost.
    static constexpr int kMostTrialFrames = kCandidates * (kWarmUp + kTimed + kTurns * (kWarmUp + kTimedInTurn));

    explicit AutoChoice(const SceneNumbers& numbers);

    /// The choice that depends on nothing but scene and camera.
    static const Preset& firstPreset(const SceneNumbers& numbers);

    /// What draws the next frame, whether to learn its time, and why: one sentence.
    const Preset&      preset() const { return *m_candidates[m_now].preset; }
    bool               isTrial() const { return m_isTrial; }
    const std::string& why() const { return m_why; }

    /// preset() has drawn a frame.
    void drawn(const FrameCost& cost);

private:
    struct Candidate {
        const Preset* preset  = nullptr;
        FrameCost     cost    = {};     // of its shortest frame when it was tried last; nothing: never
        bool          isKnown = false;  // in the trials at hand
    };

    void             drawnInTrial(const FrameCost& cost);
    void             drawnAsKept(const FrameCost& cost);
    void             beginTrials();
    void             nextTrial();
    void             tryCloseOnesInTurn();
    void             keepTheBest();
    bool             canPay(const Candidate& candidate) const;
    double           leastMs(const Candidate& candidate) const;
    double           costOfTrials(double keptMs) const;
    const Candidate& best() const;  // of those known; at least one is
    std::string      whyKept() const;

    SceneNumbers             m_numbers;
    std::vector<Candidate>   m_candidates;
    std::size_t              m_now        = 0;  // draws the next frame
    bool                     m_isTrial    = true;
    bool                     m_takesTurns = false;  // trials: those at hand are of the ones close to the fastest
    std::string              m_why;
    std::vector<std::size_t> m_waiting;     // trials: candidates still to come, by turns
    int                      m_frames = 0;  // drawn in the trial at hand, or since the best was kept

    double                           m_keptMs  = 0;  // drawn since the best was kept
    int                              m_drifted = 0;  // frames in a row
    std::array<double, kDriftFrames> m_latestMs{};   // of the best
};

}  // namespace zscope
