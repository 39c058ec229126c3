// Why a pixel shows what it shows, and what has become of a triangle: values, each event with the step at which it can
// be seen, and one sentence with live numbers that names the rule.
//
// Source     the events of the run itself; which triangles meet the pixel says the definition
//            (core/measure/pixel_covers.h)
// Order      triangles in the order in which the run met them; those that it never met follow, by their ids
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cull/cull_events.h"
#include "core/measure/pixel_covers.h"
#include "core/probe/grain.h"
#include "core/scan/pixel_events.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

/// A moment of a run: for each grain the first step whose state already holds what happened.
struct Moment {
    std::array<std::uint64_t, kGrains.size()> steps{};

    StepIndex   at(Grain grain) const { return {steps[static_cast<std::size_t>(grain)]}; }
    friend bool operator==(const Moment&, const Moment&) = default;
};

/// A node of the hierarchy by name: pathOf() in the tree over the instances, or in the mesh tree of one.
struct NodeName {
    std::optional<InstanceId> instance;  // nothing: the tree over the instances
    std::string               path;

    friend bool operator==(const NodeName&, const NodeName&) = default;
};
NodeName nameOf(const NodePlace& place);

/// What happened to a triangle, as far as it concerns a pixel.
enum class Happening {
    SetUp,           // it was set up; but for Drawn it ends there
    NodeOutside,     // left out with a node that lies outside the view
    NodeHidden,      // ... that the pyramid hides
    NodeSmall,       // ... that has too few pixels (an approximation)
    NodeEntered,     // a node that holds it was entered (of a triangle's own history only)
    NodeRecalled,    // its node was drawn unasked, because the last frame saw it (likewise)
    TriangleHidden,  // the pyramid hides it
    TrianglePassed,  // the pyramid was asked and does not hide it
    TileRejected,    // it cannot win in this tile
    Discarded,       // the pixel lies in a hole of its material
    Won,             // it passed the depth test, or has the depth that a pre-pass kept
    Lost,            // it failed the test
    Overtaken,       // somebody else took the pixel from it
    IntervalWon,     // an interval went to it as a whole
    IntervalLost,    // ... to another, without a test
};
std::string_view wordOf(Happening happening);

struct Event {
    Happening happening = Happening::SetUp;
    Moment    moment;
    Grain     grain      = Grain::Pixel;  // of the step that shows it best; always one that the method has
    SetUp     setUp      = SetUp::Drawn;  // of SetUp
    bool      isCut      = false;         // likewise: the near plane left a part of it
    bool      isMirrored = false;         // likewise: the triangle's instance is
    bool      isPrepass  = false;         // it belongs to a depth pre-pass
    int       pass       = 0;             // of two passes: 1, 2
    float     depth      = 0;             // its own, as the run stored or would have stored it
    // of a test: where the triangle is, if its material's relief was asked
    std::optional<float>         unmovedDepth;
    std::optional<TriangleId>    rival;           // who held the pixel, or took it
    float                        rivalDepth = 0;  // of Won and Lost: the buffer's value, also where there is no rival
    std::optional<NodeName>      node;
    std::optional<PyramidQuery>  query;  // what the pyramid was asked
    std::optional<TileTested>    tile;
    std::optional<PixelPosition> pixel;                           // of a triangle's own history: where it was tested
    std::optional<PixelBox>      interval;                        // the pixels between two neighbouring edges
    IntervalReason               reason = IntervalReason::Alone;  // of the interval
    std::string                  sentence;
};

/// What it came to.
enum class PixelFate {
    Winner,        // the picture shows it
    Overwritten,   // it held the pixel until somebody nearer, or as near with a lower id, came
    Farther,       // it lost the depth test
    LostTie,       // ... at equal depth, by its id
    IntervalLost,  // an interval went to another as a whole
    Hole,
    BeyondFar,  // it does not exist there, or is not kept
    TileRejected,
    TriangleHidden,
    NodeHidden,
    NodeOutside,
    NodeSmall,
    BatchOutside,
    BackFace,
    NearClip,
    NotFilled,     // it meets the pixel by the definition, but this method did not fill it there
    Blended,       // transparent, over what the picture shows
    BehindOpaque,  // transparent, but not nearer than what the picture shows
};
std::string_view wordOf(PixelFate fate);

/// One triangle at the pixel.
struct PixelCandidate {
    TriangleId triangle;
    TriangleId drawnAs;  // the same, or the first of its face where whole faces are drawn
    InstanceId instance;
    // by the definition; nothing: the run tested it, but it should not be there
    std::optional<Cover>       cover       = {};
    float                      depth       = 0;  // by the definition; 0 if there is no cover
    PixelFate                  fate        = PixelFate::NotFilled;
    std::optional<TriangleId>  rival       = {};  // who is in front of it, if it lost to somebody
    std::uint64_t              stepsBehind = 0;   // float32 steps between the two depths when it was decided; 0: a tie
    std::optional<NodeName>    node        = {};  // that held it, if a hierarchy was visited
    std::vector<Event>         events      = {};  // in the order in which they happened
    std::optional<std::size_t> decisive    = {};  // which of them decided; nothing: none did, the sentence says why
    float                      opacity     = 1;   // of its material
    std::string                opacityText = {};  // below 1: also what set it, as core/scene/opacity.h says it
    std::string                sentence    = {};  // what it came to, and why
};

struct PixelExplanation {
    PixelPosition pixel;
    std::string   algorithm = {};
    // of the algorithm: Moment counts the others too, but nobody can step by them
    std::vector<Grain>          grains     = {};
    std::int64_t                winner     = -1;  // id in the picture; -1 is background
    float                       depth      = 0;
    std::string                 sentence   = {};
    std::vector<PixelCandidate> candidates = {};  // in the order met
};

/// How many pixels of a triangle somebody else shows.
struct Taker {
    std::int64_t  id     = -1;  // -1: background
    std::uint64_t pixels = 0;

    friend bool operator==(const Taker&, const Taker&) = default;
};

/// Pixels of one triangle by what became of them.
struct TriangleTally {
    std::uint64_t covered = 0;             // by the definition
    std::uint64_t shown   = 0;             // the picture shows it, or its face
    std::uint64_t tested = 0, passed = 0;  // fragments; passed: at the time of the test
    std::uint64_t prepassTested = 0, prepassPassed = 0;
    std::uint64_t inHoles = 0, beyondFar = 0, backFacing = 0;  // by the definition
    std::uint64_t tileRejected = 0;                            // of tiles that it may cover; some it does not
    std::uint64_t intervalWon = 0, intervalLost = 0;
};

struct TriangleExplanation {
    TriangleId         triangle, drawnAs;
    InstanceId         instance;
    std::string        mesh, material;
    std::string        algorithm;
    std::vector<Grain> grains;
    bool               isTransparent = false;
    float              opacity       = 1;   // of its material
    std::string        opacityText   = {};  // below 1: also what set it, as core/scene/opacity.h says it
    TriangleTally      tally;
    std::vector<Taker> takers;           // of covered pixels it does not show, most first; at most kMostTakers
    std::uint64_t      otherTakers = 0;  // how many more there are
    // of the triangle as a whole; of its pixels only the first that it won and lost
    std::vector<Event> events;
    std::uint64_t      leftOut = 0;                     // events beyond kMostEvents
    PixelFate          fate    = PixelFate::NotFilled;  // Winner if it is seen anywhere; else what kept it from that
    std::string        sentence;

    static constexpr std::size_t kMostTakers = 16;
    static constexpr std::size_t kMostEvents = 256;
};

}  // namespace zscope
