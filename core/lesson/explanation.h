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
#include <utility>
#include <vector>

#include "core/cull/cull_events.h"
#include "core/measure/pixel_covers.h"
#include "core/probe/grain.h"
#include "core/probe/meaning.h"

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

/// What happened to a triangle, as far as it concerns a pixel: what an event of the run meant for it.
struct Event : Outcome, Meaning {
    Moment moment    = {};
    Grain  grain     = Grain::Pixel;  // of the step that shows it best; always one that the method has
    bool   isPrepass = false;         // it belongs to a depth pre-pass
    bool   isUsual   = false;         // nearly every triangle has one like it
    int    pass      = 0;             // of two passes: 1, 2

    std::optional<NodeName>      node  = {};
    std::optional<PixelPosition> pixel = {};  // of a triangle's own history: where it was tested
};

/// Fates that no event leads to, or the set-up.
namespace fates {
inline constexpr PixelFate kBatchOutside{"batch-outside", "in a batch outside the view", FateKind::LeftOut, 2};
inline constexpr PixelFate kBackFace{"back-face", "showing its back", FateKind::LeftOut, 3};
inline constexpr PixelFate kNearClip{"near-clip", "cut away at the near plane", FateKind::LeftOut, 4};
// transparent, over what the picture shows, or not nearer than that
inline constexpr PixelFate kBlended{"blended", "transparent, blended over it", FateKind::Blended};
inline constexpr PixelFate kBehindOpaque{"behind-opaque", "transparent, behind it", FateKind::NotBlended};
}  // namespace fates

/// One triangle at the pixel.
struct PixelCandidate {
    TriangleId triangle;
    TriangleId drawnAs;  // the same, or the first of its face where whole faces are drawn
    InstanceId instance;
    // by the definition; nothing: the run tested it, but it should not be there
    std::optional<Cover>       cover       = {};
    float                      depth       = 0;  // by the definition; 0 if there is no cover
    PixelFate                  fate        = fates::kNotFilled;
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
    std::uint64_t covered = 0;                                 // by the definition
    std::uint64_t shown   = 0;                                 // the picture shows it, or its face
    std::uint64_t inHoles = 0, beyondFar = 0, backFacing = 0;  // by the definition
    std::uint64_t won = 0;  // at the time of a test, one by one or as a whole; those of a pre-pass are not
    // by the names under which events count them; of a tile it may count pixels that the triangle does not cover
    std::vector<std::pair<std::string_view, std::uint64_t>> counted = {};

    std::uint64_t of(std::string_view name) const
    {
        for (const auto& [each, pixels] : counted)
            if (each == name) return pixels;
        return 0;
    }
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
    std::uint64_t      leftOut = 0;                  // events beyond kMostEvents
    PixelFate          fate    = fates::kNotFilled;  // kWinner if it is seen anywhere; else what kept it from that
    std::string        sentence;

    static constexpr std::size_t kMostTakers = 16;
    static constexpr std::size_t kMostEvents = 256;
};

}  // namespace zscope
