#include "core/frame/faults.h"

#include <algorithm>
#include <array>

#include "core/frame/methods.h"

namespace zscope {

namespace {

bool walksTriangles(const Pipeline& p) { return p.scan == Scan::EdgeWalk; }
bool steps(const Pipeline& p) { return p.scan == Scan::EdgeWalk || p.scan == Scan::SweepZLine; }
bool testsHalfSpaces(const Pipeline& p) { return p.scan == Scan::HalfSpace; }
bool findsIntervals(const Pipeline& p) { return p.scan == Scan::SweepIntervals || p.scan == Scan::SweepPolygons; }
bool asksThePyramid(const Pipeline& p) { return asksNodes(p.cull) || asksTriangles(p.cull); }
bool asksForNodes(const Pipeline& p) { return asksNodes(p.cull); }
bool setsUpTriangles(const Pipeline&) { return true; }
bool isComposed(const Pipeline& p) { return !methodOf(p).whole; }
bool drawsTriangles(const Pipeline& p) { return isComposed(p) && !drawsFaces(p); }
bool testsEveryPixel(const Pipeline& p) { return isComposed(p) && !findsIntervals(p); }
bool goesByLines(const Pipeline& p) { return methodOf(p).stepsAlongLines; }
bool draws(const Pipeline&) { return true; }
bool drawsInTurn(const Pipeline& p) { return p.chooser == Chooser::Composed && drawsBatchByBatch(p); }
bool boundsByBoxes(const Pipeline& p) { return p.chooser == Chooser::Composed && testsHalfSpaces(p); }
bool hasPrepass(const Pipeline& p) { return p.depth == DepthMoment::Prepass; }
bool drawsAsSubmitted(const Pipeline& p)
{
    return p.chooser == Chooser::Composed && p.order == Order::Submitted && drawsTriangles(p);
}
bool drawsInFileOrder(const Pipeline& p)
{
    const bool testsOnce = p.depth != DepthMoment::Prepass && p.depth != DepthMoment::ZCull;
    return drawsAsSubmitted(p) && drawsInTurn(p) && p.cull == Cull::Frustum && testsOnce;
}
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
    FaultEntry{Fault::LinearZ, "linear-z", "Distance interpolated linearly",
               "The distance of the corners is interpolated over the screen, although the middle of a side on the "
               "screen is not its middle in space, so large triangles that reach far are taken to lie too far away.",
               "Interpolate near/z: on the screen it is linear, and the distance is not.",
               "methods that test every pixel of a triangle", "zbuffer", testsEveryPixel},
    FaultEntry{Fault::HalfPixel, "half-pixel", "Pixel centres at whole numbers",
               "A pixel is sampled where its number says, in its upper left corner and not in its centre, so the whole "
               "picture moves right and down by half a pixel.",
               "Pixel x has its centre at x + 1/2; add the half in one place.", kTriangles, "zbuffer", draws},
    FaultEntry{Fault::BehindTheEye, "behind-the-eye", "Division before near clipping",
               "Corners behind the eye are divided by their negative distance, which mirrors them to the other side "
               "of the picture, so a triangle that passes the eye covers pixels where it is not.",
               "Cut triangles at the near plane first; then every distance is positive.", "methods that draw triangles",
               "zbuffer", drawsTriangles},
    FaultEntry{Fault::ConcaveFanned, "concave-fanned", "Concave face cut as a fan",
               "Every face is cut into triangles from its first corner, so a concave one covers what lies outside its "
               "outline.",
               "A fan serves convex faces only; cut ears off the others.", "methods that draw triangles as submitted",
               "zbuffer", drawsAsSubmitted},
    FaultEntry{Fault::WindingFlipped, "winding-flipped", "Front and back faces exchanged",
               "The y axis of the screen runs down, which turns every triangle round; the signs are read as if it ran "
               "up, so the faces that the viewer sees are left out and those behind them are drawn.",
               "Take the sign of the area on the screen as it is there, or negate y before.", kTriangles, "zbuffer",
               draws},
    FaultEntry{Fault::BoxShort, "box-short", "Bounding box one pixel short",
               "The last column and the last line of a triangle's box are taken for its end, which the loop does not "
               "reach, so cracks open along right and lower edges.",
               "Let the end lie one behind the last pixel, or compare with <=.", "half-space scans", "zbuffer",
               boundsByBoxes},
    FaultEntry{Fault::NotCleared, "not-cleared", "Depth buffer not cleared",
               "The depth buffer still holds the frame before, whose eye stood a little farther left and farther back, "
               "so near things leave holes where they were.",
               "Set every depth to the farthest before each frame, whenever the colours are cleared.",
               "methods with a z-buffer", "zbuffer", drawsInTurn},
    FaultEntry{Fault::EqualPassLess, "equal-pass-less", "Pass after a pre-pass compares with \"less\"",
               "After a pre-pass every visible fragment has exactly the depth that is stored, and a test that wants "
               "a nearer one lets none pass, so nothing is drawn.",
               "Compare with \"equal\" or \"less or equal\" after a pre-pass.", "methods with a pre-pass",
               "zbuffer-prepass", hasPrepass},
    FaultEntry{Fault::EdgeDrift, "edge-drift", "Edge steps in whole subpixels",
               "The slope of an edge is rounded down to whole subpixels per line, and the error is added on every "
               "line, so long edges drift to the left.",
               "Carry the remainder of the division along from line to line, as Bresenham's method does.",
               "edge walks and sweeps", "edge-walk", goesByLines},
    FaultEntry{Fault::LevelTooFine, "level-too-fine", "Pyramid level one too fine",
               "A query looks at four cells of a level on which they do not cover its rectangle, so what shows through "
               "between them is lost.",
               "Take the finest level on which at most two by two cells hold the whole rectangle.", kQueries,
               "hzb-octree", asksThePyramid},
    FaultEntry{Fault::LevelShifted, "level-shifted", "Pyramid levels counted from two numbers",
               "Levels are counted from 0 in one place and from 1 in another, so a query looks up the cells of one "
               "level at the coordinates of the next, which are cells of another part of the picture.",
               "Count levels from 0, the picture, everywhere: on level n a pixel's cell is at x / 2^n, y / 2^n.",
               kQueries, "hzb-octree", asksThePyramid},
    FaultEntry{Fault::PainterOrder, "painter-order", "Drawn over in the order of the file",
               "There is no depth test: a triangle is drawn over all that comes before it in the file, however near "
               "that is.",
               "Keep a depth for every pixel and let a fragment win only if it is nearer.",
               "z-buffer methods that draw as submitted, in one pass and without a pyramid", "zbuffer",
               drawsInFileOrder},
    FaultEntry{
        Fault::FarthestWins, "farthest-wins", "Depth test reversed",
        "The comparison is the wrong way round: a fragment wins if it is farther than what is there, so things are "
        "seen that lie behind others.",
        "Let the nearer fragment win: with near/z the larger number is nearer, with z the smaller one.",
        "z-buffer methods that draw as submitted, in one pass and without a pyramid", "zbuffer", drawsInFileOrder},
};

}  // namespace

std::span<const FaultEntry> faults() { return kFaults; }

const FaultEntry* findFault(std::string_view word)
{
    const auto found = std::ranges::find(kFaults, word, &FaultEntry::word);
    return found == kFaults.end() ? nullptr : &*found;
}

std::optional<FaultSet> findFaults(std::string_view words)
{
    FaultSet all;
    for (;;) {
        const std::size_t       plus  = words.find('+');
        const FaultEntry* const entry = findFault(words.substr(0, plus));
        if (!entry) return std::nullopt;
        all.add(entry->fault);
        if (plus == std::string_view::npos) return all;
        words.remove_prefix(plus + 1);
    }
}

std::string wordsOf(const FaultSet& faults)
{
    std::string words;
    for (const Fault fault : faults) {
        if (!words.empty()) words += '+';
        words += entryOf(fault).word;
    }
    return words;
}

const FaultEntry& entryOf(Fault fault) { return *std::ranges::find(kFaults, fault, &FaultEntry::fault); }

}  // namespace zscope
