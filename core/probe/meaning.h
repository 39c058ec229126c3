// What an event means for the triangles that it concerns and for the pixels that they could have won: enough to explain
// a pixel, or a triangle, without knowing the event's type.
//
// Use        an event that means something has a member `void mean(Meanings& to) const`, which names whom it concerns,
//            where, and what it comes to. Numbers and sentences are made by a callable, for what is asked about
// Polygons   what is drawn: triangles, or whole faces under the id of their first triangle
// Decisions  of a polygon's events at a pixel the last test decides, or else the last that ended its way; the one that
//            took the pixel from it comes before both
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/ids.h"
#include "core/geometry/pixel_box.h"
#include "core/probe/telling.h"
#include "core/probe/values.h"

namespace zscope {

struct NodePlace;  // core/cull/cull_events.h

/// What an event does to a polygon.
enum class Effect {
    Passes,     // nothing yet: its way goes on
    Ends,       // its way ends before it is compared at any of the pixels
    IsAbsent,   // a test finds that there is nothing of it at the pixel
    Wins,       // a test: it has the pixel for the time being
    Loses,      // a test: it does not get the pixel
    Overtaken,  // another's test takes from it the pixel that it had
};
constexpr bool isTest(Effect effect) { return effect >= Effect::IsAbsent; }

/// Kinds of fates, in the order in which a summary counts them.
enum class FateKind {
    Seen,
    Overtaken,  // it held the pixel for a while
    Behind,     // something nearer, or as near, was preferred
    Absent,     // there is nothing of it at the pixel
    NotKept,    // its depth may not be kept
    Hidden,     // it was found hidden together with other things or other pixels
    LeftOut,    // it was not looked at
    NotFilled,
    Blended,
    NotBlended,
};

/// What may become of a polygon, at a pixel or everywhere. Two are the same if their words are.
struct PixelFate {
    std::string_view word;       // "node-hidden"; outlives every run, as a literal does, like the next
    std::string_view countedAs;  // in a summary, after a number: "hidden with a node"
    FateKind         kind;
    int              place = 100;  // among those of its kind, in a summary
    // its event, where it turned up last, says why the polygon is seen nowhere
    bool isReason = false;

    friend constexpr bool operator==(const PixelFate& a, const PixelFate& b) { return a.word == b.word; }
};
constexpr std::string_view wordOf(const PixelFate& fate) { return fate.word; }

/// Fates that need no event of their own; the others stand beside the events that lead to them.
namespace fates {
inline constexpr PixelFate kWinner{"winner", "is seen", FateKind::Seen};
inline constexpr PixelFate kOverwritten{"overwritten", "held the pixel for a while", FateKind::Overtaken};
inline constexpr PixelFate kNotFilled{"not-filled", "not filled there", FateKind::NotFilled};
}  // namespace fates

/// What is known of a meaning before anybody asks for its numbers.
struct Outcome {
    std::string_view word;  // "node-hidden"; outlives every run, as a literal does
    Effect           effect = Effect::Passes;
    // of the polygon as a whole; else the history of a polygon notes only the first of a word
    bool isOfAll = false;
    // under which names the pixels are counted in the history of a polygon: "tested", "passed"
    std::array<std::string_view, 2> countedAs = {};
};

/// The rest, for one polygon at one pixel.
struct Meaning {
    float                     depth = 0;  // its own, as it is or would be stored; of a question: the nearest it may be
    std::optional<float>      unmovedDepth = {};  // of a test, where its material's relief was asked: its own before
    std::optional<TriangleId> rival        = {};  // what held the pixel, or took it
    std::optional<float>      rivalDepth   = {};  // of a comparison: also where there is no rival
    PixelFate                 fate         = fates::kNotFilled;  // what it comes to if this decides
    std::optional<int>        level        = {};                 // of the pyramid, if it was asked
    std::optional<PixelBox>   pixels       = {};  // that it speaks of, if they are others than those it concerns
    Values                    values       = {};  // of its kind of event only
    std::string               sentence     = {};  // what happened to it, with the rule
};

/// Takes what an event means.
class Meanings {
public:
    using Make   = std::function<Meaning(TriangleId polygon, PixelPosition at)>;
    using Remark = std::function<std::string()>;

    virtual ~Meanings() = default;

    /// False: nothing that is said of these pixels is heard.
    virtual bool asksAbout(const PixelBox& pixels) const = 0;
    /// Of one polygon at these pixels.
    virtual void of(TriangleId polygon, const PixelBox& pixels, const Outcome& outcome, const Make& make) = 0;
    /// Of everything below a node, at these pixels; nullptr: everywhere.
    virtual void below(const NodePlace& node, const Outcome& outcome, const Make& make,
                       const PixelBox* pixels = nullptr) = 0;
    /// Of the pixels themselves: said behind what a test decides there. Without a capital and without a stop.
    virtual void remark(const PixelBox& pixels, const Remark& make) = 0;

    virtual const Telling& telling() const = 0;
};

}  // namespace zscope
