// What a lesson shows of one step: values, copied out of the run, that no later step changes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/base/ids.h"
#include "core/base/stages.h"
#include "core/depth/pyramid.h"
#include "core/frame/renderer.h"
#include "core/hierarchy/tree.h"
#include "core/probe/grain.h"
#include "core/probe/source_line.h"
#include "core/scan/pixel_events.h"
#include "core/scene/mesh.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

/// One row of the active edge table as a lesson shows it.
struct EdgeRow {
    TriangleId                  polygon;
    double                      x          = 0;  // where the edge meets the line's centre, pixels
    std::int64_t                xSubpixels = 0;  // the same in 1/256 pixel, rounded down
    std::array<std::int64_t, 2> dx{0, 1};        // pixels per line, an exact reduced fraction, denominator > 0
    int                         firstLine = 0;   // inclusive
    int                         lastLine  = 0;   // inclusive

    friend bool operator==(const EdgeRow&, const EdgeRow&) = default;
};

/// A run of pixels [x0, x1) of one line that was given to a triangle's depth test.
struct SpanRow {
    int        x0 = 0;
    int        x1 = 0;
    TriangleId polygon;

    friend bool operator==(const SpanRow&, const SpanRow&) = default;
};

/// The sweep's structures for the line the run has reached.
struct SweepState {
    int                     y = -1;          // -1: no line reached yet
    std::vector<EdgeRow>    activeEdges;     // sorted by x
    std::vector<TriangleId> activePolygons;  // each once, ascending
    std::vector<SpanRow>    spans;           // in the order they were filled
    std::vector<EdgeRow>    entered;         // since the previous line
    std::vector<EdgeRow>    left;            // since the previous line
    std::vector<int>        edgesStarting;   // per line of the picture: how many edges its edge-table bucket holds
};

/// The pixels between two neighbouring active edges, as the interval method decided them.
struct IntervalState {
    int                       y = 0, x0 = 0, x1 = 0;  // [x0, x1)
    std::vector<TriangleId>   open;                   // polygons open there, ascending
    std::optional<TriangleId> winner;                 // of the whole; nothing: compared pixel by pixel
    IntervalReason            reason = IntervalReason::Alone;
};

/// One pixel's depth test.
struct PixelState {
    int                       x = 0;
    int                       y = 0;
    TriangleId                triangle;
    float                     depth = 0;
    bool                      won   = false;
    std::optional<TriangleId> rival;           // who owned the pixel before; nothing: background
    float                     rivalDepth = 0;  // 0 for background
    Keep                      keep       = Keep::Nearest;
    bool                      shaded     = false;  // its colour was computed with this test
    bool                      discarded  = false;  // it lies in a hole of its material
    std::optional<float>      unmovedDepth;        // of its triangle, where the material's relief changed it
};

/// A pixel whose transparent surfaces have just been blended.
struct BlendState {
    int           x = 0, y = 0;
    std::uint32_t surfaces = 0;           // blended over the opaque colour
    std::uint32_t before = 0, after = 0;  // the pixel's colour, 0xAARRGGBB
};

/// The triangle that is being drawn or has just been drawn.
struct TriangleState {
    TriangleId                           triangle;
    std::array<std::array<double, 2>, 3> corners{};  // snapped, pixels
    std::uint64_t                        pixelsWon = 0;
};

enum class NodeVerdict { Waiting, Outside, Hidden, Entered, Drawn, Small };

constexpr std::string_view wordOf(NodeVerdict verdict)
{
    constexpr std::array<std::string_view, 6> words{"waiting", "outside", "hidden", "entered", "drawn", "small"};
    return words[static_cast<std::size_t>(verdict)];
}

/// One node of the hierarchy that the run has come to know.
struct NodeRow {
    int         id      = 0;   // in the order in which the nodes became known
    int         parent  = -1;  // id of the node above, over both levels of the hierarchy; -1: the root
    int         depth   = 0;  // of the whole hierarchy: a mesh's root stands one below the node that holds its instance
    NodeVerdict verdict = NodeVerdict::Waiting;
    // methods of two passes: the one in which its triangles were drawn, or else in which it was judged
    int                       pass = 0;
    Bounds                    box;       // in the space of the tree: the world's, or the mesh's
    std::optional<InstanceId> instance;  // whose mesh tree it belongs to; nothing: the tree over the instances
    std::string               path;  // "0.3.6": the slots taken from the tree's root; from 8 on they straddle planes
};

/// The hierarchy as far as the run has come.
struct HierarchyState {
    std::vector<NodeRow>            nodes;
    std::optional<TreeKind>         tree;        // nothing: the method visits none
    int                             now  = -1;   // id of the node judged last, or recalled, or being asked about
    int                             pass = 0;    // methods of two passes: the one that the run is in
    std::optional<PyramidQuery>     query;       // what the pyramid was asked last
    std::string                     asked;       // "node" or "triangle"
    std::optional<TriangleId>       askedAbout;  // of a triangle
    std::optional<CellWrite>        update;      // the cell of the pyramid that was written last
    std::vector<CellWrite>          climb;   // the way up that it is the end of: each one level above the one before
    std::vector<std::array<int, 2>> levels;  // width and height of each level of the pyramid; empty: there is none
    // of each level that is stored, the finest (Pyramid::kTileLevel) first, as it
    std::vector<Grid<float>> cells;
    // stands: a stale cell is too far at worst; none before the frame is
    // cleared
};

/// Everything a lesson shows of one step; a value.
struct StepState {
    std::string                   algorithm;
    Grain                         grain = Grain::Frame;
    StepIndex                     step;
    std::uint64_t                 count  = 0;
    std::uint64_t                 events = 0;  // of every grain, up to this one: orders the states of one run
    std::string                   sentence;    // one sentence with live numbers and the rule applied
    Grain                         event  = Grain::Frame;  // grain of the event the run stopped at
    SourceLine                    method = {};            // the call in core/method that made the step
    SourceLine                    part   = {};            // the statement that reported it
    Stage                         stage  = Stage::Clear;  // the stage the run is in
    std::optional<SweepState>     sweep;                  // sweep methods only
    std::optional<HierarchyState> hierarchy;              // methods that visit a tree or ask a pyramid only
    std::optional<TriangleState>  triangle;               // stream methods, once a triangle was reached
    std::optional<PixelState>     pixel;                  // if the last event was a pixel
    std::optional<SpanRow>        span;                   // the last span filled
    std::optional<IntervalState>  interval;               // interval method only: the last interval of the line
    std::optional<TileTested>     tile;                   // if the last event was a tile
    std::optional<BlendState>     blend;                  // if the last event was a pixel blended
    Frame                         frame;                  // as the run left it, shaded
    Grid<std::uint32_t>           tests;  // per pixel: how many fragments have been offered to its depth test
};

}  // namespace zscope
