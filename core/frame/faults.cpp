#include "core/frame/faults.h"

#include <algorithm>
#include <array>

namespace zscope {

namespace {

bool walksTriangles(const Pipeline& p) { return p.scan == Scan::EdgeWalk; }
bool steps(const Pipeline& p) { return p.scan == Scan::EdgeWalk || p.scan == Scan::SweepZLine; }
bool testsHalfSpaces(const Pipeline& p) { return p.scan == Scan::HalfSpace; }
bool findsIntervals(const Pipeline& p) { return p.scan == Scan::SweepIntervals || p.scan == Scan::SweepPolygons; }
bool asksThePyramid(const Pipeline& p) { return asksNodes(p.cull) || asksTriangles(p.cull); }
bool asksForNodes(const Pipeline& p) { return asksNodes(p.cull); }
bool setsUpTriangles(const Pipeline&) { return true; }
bool visitsOctree(const Pipeline& p) { return p.order == Order::Octree; }

constexpr std::string_view kSpans     = "edge walks and sweeps with a one-line z-buffer";
constexpr std::string_view kQueries   = "methods that ask the pyramid";
constexpr std::string_view kTriangles = "all methods";

constexpr std::array kFaults{
    FaultEntry{
        Fault::FirstLineRounded, "first-line-rounded", "First line by rounding instead of ceiling",
        "The first line of a triangle is its rounded top plus one, which skips a line whenever the top lies in the "
        "lower half of a pixel.",
        "Start at the first line whose centre lies at or below the top corner: a ceiling, as the definition has it.",
        kSpans, "edge-walk", steps},
    FaultEntry{Fault::HorizontalByX, "horizontal-by-x", "\"Horizontal\" decided by the x extent",
               "A side that begins and ends in the same pixel column is taken for horizontal and skipped, so steep "
               "sides leave their lines empty.",
               "A side is horizontal if its y extent is nothing; only such a side crosses no line.", "edge walks",
               "edge-walk", walksTriangles},
    FaultEntry{Fault::XTruncated, "x-truncated", "Truncated x",
               "A span runs between the truncated crossings instead of the first centres right of them, so every edge "
               "moves left by up to a pixel.",
               "Take the first pixel whose centre is not left of the crossing: a ceiling of x - 1/2.", kSpans,
               "scanline", steps},
    FaultEntry{Fault::NoTopLeft, "no-top-left", "No top-left rule",
               "A pixel centre exactly on an edge counts as inside for both neighbours, so silhouettes grow and shared "
               "edges are drawn twice.",
               "A point on an edge belongs to left and top edges only.", "half-space scans", "zbuffer",
               testsHalfSpaces},
    FaultEntry{Fault::EdgesUnsorted, "edges-unsorted", "Active edges unsorted",
               "Edges stay in the order in which they entered, so a triangle's right edge may come first and its span "
               "is empty or negative.",
               "Sort the active edge table by x on every line; it is nearly sorted already.", "sweeps", "scanline",
               drawsLineByLine},
    FaultEntry{Fault::OneTestPerInterval, "one-test-per-interval", "One depth test per interval",
               "Whoever is nearest at the left end of an interval gets all of it, although polygons may cross inside.",
               "Compare at both ends, and pixel by pixel where nobody leads at both.", "interval scanline", "interval",
               findsIntervals},
    FaultEntry{Fault::NearestInCells, "nearest-in-cells", "Pyramid with min and max swapped",
               "A cell holds the nearest of its children instead of the farthest, so one near pixel hides everything "
               "around it.",
               "A cell may hide only what lies behind all of its pixels: keep the farthest.", kQueries, "hzb-octree",
               asksThePyramid},
    FaultEntry{Fault::CornersOnly, "corners-only", "Query that tests only the corners",
               "A query looks at the four corner pixels of its rectangle; what shows through between them is lost.",
               "Every pixel of the rectangle must be answered for, by as few cells as cover it.", kQueries,
               "hzb-octree", asksThePyramid},
    FaultEntry{
        Fault::EmptyIsHidden, "empty-is-hidden", "Query that answers \"hidden\" for an empty rectangle",
        "The rectangle of a node is truncated on both sides, and one that vanishes counts as hidden, although it "
        "covers pixel centres.",
        "Round the rectangle outward before pixel centres are selected; only one without any centre may be skipped.",
        "methods that ask the pyramid about nodes", "hzb-octree", asksForNodes},
    FaultEntry{Fault::OddPadded, "odd-padded", "Odd sizes padded with zero",
               "Where a level has an odd size, the last row and column are taken from padding, whose zero means "
               "infinitely near, so the border hides everything.",
               "A cell is the minimum over the pixels that exist; padding takes no part.", kQueries, "hzb-octree",
               asksThePyramid},
    FaultEntry{Fault::EqualIsHidden, "equal-is-hidden", "Node test with equality culled",
               "What is exactly as near as the farthest stored depth counts as hidden; after a pre-pass that is every "
               "flat thing that is seen.",
               "Cull only what is strictly behind: with equality it may be the winner, or win by its lower id.",
               kQueries, "hzb-simple", asksThePyramid},
    FaultEntry{Fault::NearRejected, "near-rejected", "Whole-triangle near rejection",
               "A triangle with any corner before the near plane is dropped, so the floor under the eye disappears.",
               "Cut it at the plane; one or two parts remain.", kTriangles, "zbuffer", setsUpTriangles},
    FaultEntry{Fault::CrossingDropped, "crossing-dropped", "Frustum-crossing triangles dropped",
               "Only triangles wholly inside the picture are drawn, so its border is eaten away.",
               "Coverage needs no clipping at the sides: limit the box of pixels, and keep the triangle.", kTriangles,
               "zbuffer", setsUpTriangles},
    FaultEntry{Fault::FarFirst, "far-first", "Octree children visited far first",
               "The farthest child is drawn first, and the first comer keeps a tie (depth is compared strictly), so "
               "that the visit decides who "
               "is seen where faces coincide, and nothing hides anything yet when the pyramid is asked.",
               "Let the lower id win a tie, whoever came first, so that no order can change the picture; and begin "
               "with the octant of the eye.",
               "methods that visit an octree", "hzb-octree", visitsOctree},
};

}  // namespace

std::span<const FaultEntry> faults() { return kFaults; }

const FaultEntry* findFault(std::string_view word)
{
    const auto found = std::ranges::find(kFaults, word, &FaultEntry::word);
    return found == kFaults.end() ? nullptr : &*found;
}

const FaultEntry& entryOf(Fault fault) { return *std::ranges::find(kFaults, fault, &FaultEntry::fault); }

}  // namespace zscope
