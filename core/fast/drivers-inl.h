// The two families of drivers, from the clearing of a stripe to its last pixel.
//
// Stream     triangles arrive one after another and are scan converted at once
// Sweep      triangles, or whole faces, are entered in an edge table first; then the stripe is swept line by line
// Promise    a stripe's pixels depend on nothing outside it
#if defined(ZSCOPE_DRIVERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_DRIVERS_INL_H
#undef ZSCOPE_DRIVERS_INL_H
#else
#define ZSCOPE_DRIVERS_INL_H
#endif

#include <type_traits>

#include "core/cull/occlusion.h"
#include "core/fast/lanes/ask_pyramid-inl.h"
#include "core/fast/lanes/enter_edges-inl.h"
#include "core/fast/lanes/fragment-inl.h"
#include "core/fast/lanes/half_space-inl.h"
#include "core/fast/lanes/intervals-inl.h"
#include "core/fast/lanes/least_key-inl.h"
#include "core/fast/lanes/pattern-inl.h"
#include "core/fast/lanes/shade-inl.h"
#include "core/fast/lanes/sweep-inl.h"
#include "core/fast/visit/front_to_back-inl.h"
#include "core/fast/visit/submitted-inl.h"
#include "core/frame/pipeline.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// What a pass over the triangles is for.
struct Pass {
    Keep          keep           = Keep::Nearest;
    ShadingMoment shading        = ShadingMoment::Never;
    Pyramid*      tiles          = nullptr;  // compared before their fragments; nullptr: no tile is
    bool          isAfterPrepass = false;    // only fragments with the depths that were left win
};

/// Turns each triangle of a batch into pixels as soon as it is set up, unless the pyramid says it is hidden.
template <class Scan>
struct ScanConvert {
    const Pass&      pass;
    const Stripe&    stripe;
    StripeScratch&   scratch;
    const Occlusion& occlusion;
    StageClock&      clock;
    const LaneRules& rules;

    DrawnTriangles operator()(TriangleList& triangles) const
    {
        if (triangles.isEmpty()) return {};
        const DrawnTriangles all = rules.hasExactDepths() ? drawBy(ExactRules(), triangles) : drawBy(rules, triangles);
        scratch.tally.add(Unit::TrianglesDrawn, all.drawn);
        clock.lap(Stage::Raster);
        return all;
    }

private:
    /// Pixels in a triangle's box from which a question about it may pay, where its node has been asked about: on
    /// average over a batch, and of one that is compact (measured, docs/performance.md).
    static constexpr std::uint64_t kWorthAsking = 32, kWorthAskingOne = 128;

    /// `depths`: the rules by which pixels are tested. By what a pass keeps and when it shades.
    template <class Rules>
    DrawnTriangles drawBy(const Rules& depths, TriangleList& triangles) const
    {
        const auto unshaded = [](std::uint32_t) { return UnshadedFragments(); };
        if (pass.keep == Keep::DepthOnly) return convert<Keep::DepthOnly>(triangles, unshaded, depths);
        if (pass.shading == ShadingMoment::Never) return convert<Keep::Nearest>(triangles, unshaded, depths);

        const Shading shading{*stripe.painter, stripe.visible, scratch.fragments, scratch.tally};
        if (shading.painter.operations == 0) return shadeBy<FreeFragmentsOf>(shading, triangles, depths);
        const DrawnTriangles all = shadeBy<QueuedFragmentsOf>(shading, triangles, depths);
        shading.flush();
        return all;
    }

    template <template <ShadingMoment> class FragmentsOf, class Rules>
    DrawnTriangles shadeBy(const Shading& shading, TriangleList& triangles, const Rules& depths) const
    {
        if (pass.shading == ShadingMoment::BeforeTest)
            return convert<Keep::Nearest>(triangles, FragmentsOf<ShadingMoment::BeforeTest>{shading}, depths);
        return convert<Keep::Nearest>(triangles, FragmentsOf<ShadingMoment::AfterTest>{shading}, depths);
    }

    /// fragmentsOf(rank): what becomes of a triangle's fragments besides their test (core/fast/lanes/fragments.h).
    template <Keep kKeep, class FragmentsOf, class Rules>
    DrawnTriangles convert(TriangleList& triangles, const FragmentsOf& fragmentsOf, const Rules& depths) const
    {
        // A large triangle may hide the next one; of small ones all are asked first, so that they can be drawn
        // together.
        const bool     asks       = asksTriangles(triangles);
        const bool     asksInTurn = asks && triangles.hasLarge();
        DrawnTriangles all;
        if (asks && !asksInTurn)
            for (std::size_t i = 0; i < triangles.count; ++i)
                if (isWorthAsking(triangles, i)) dropIfHidden(triangles, i, all);

        if (drawsWindows() && !needsEachAtOnce() && (!asksInTurn || asksOfAskedNodes() || pass.isAfterPrepass)) {
            drawTogether<kKeep>(triangles, asksInTurn, fragmentsOf, depths, all);
            all.drawn = static_cast<std::uint32_t>(triangles.count) - all.hidden;
            return all;
        }
        for (const std::uint32_t i : triangles.inTurn(true)) {
            // each may take long then
            if (asksInTurn && isWorthAsking(triangles, i)) dropIfHidden(triangles, i, all);
            if (triangles.isHidden(i)) continue;
            ++all.drawn;
            const ScreenTriangle triangle = triangles[i];
            if (!drawByWindows<kKeep>(triangles, i, fragmentsOf, depths)) draw<kKeep>(triangle, fragmentsOf, depths);
            if (!pass.tiles && occlusion.afterDrawing != AfterDrawing::MarkStale) keepTrue(occlusion, triangle, rules);
        }
        return all;
    }

    bool drawsWindows() const { return std::is_same_v<Scan, HalfSpace> && stripe.shortcuts.has(Shortcut::Windows); }

    /// What keeps a pyramid true wants to know of each triangle when it has been drawn.
    bool needsEachAtOnce() const
    {
        return occlusion.afterDrawing != AfterDrawing::Nothing && occlusion.afterDrawing != AfterDrawing::MarkStale;
    }

    /// First those that stand alone: they may hide each other and the others, which are drawn together.
    template <Keep kKeep, class FragmentsOf, class Rules>
    void drawTogether(TriangleList& triangles, bool asks, const FragmentsOf& fragmentsOf, const Rules& depths,
                      DrawnTriangles& all) const
    {
        for (const std::uint32_t i : triangles.inTurn(false)) {
            if (asks && isWorthAsking(triangles, i)) dropIfHidden(triangles, i, all);
            if (!triangles.isHidden(i)) draw<kKeep>(triangles[i], fragmentsOf, depths);
        }
        if (triangles.compactReach.isEmpty()) return;
        if (pass.tiles) dropHiddenInTiles(triangles, depths);
        for (std::size_t i = 0; asks && i < triangles.count; ++i)
            if (!triangles.isAlone(i) && isWorthAsking(triangles, i)) dropIfHidden(triangles, i, all);
        openCompact(triangles);
        testCompact<kKeep>(triangles, 0, triangles.count, fragmentsOf, depths);
    }

    /// The compact triangles among [first, end), to which tiles are open.
    template <Keep kKeep, class FragmentsOf, class Rules>
    void testCompact(TriangleList& triangles, std::size_t first, std::size_t end, const FragmentsOf& fragmentsOf,
                     const Rules& depths) const
    {
        WindowFinder(triangles, scratch.windows).add(first, end);
        scratch.tally.add(Unit::Windows, scratch.windows.windows());
        testTiny<kKeep>(triangles, first, end, scratch.samples, stripe.visible, depths, fragmentsOf);
        testWindows<kKeep>(triangles, scratch.windows, stripe.visible, depths, fragmentsOf);
    }

    /// Of the compact triangles those are dropped that all the tiles under their boxes hide. Of a batch all are asked
    /// about before any is drawn, so that a stale tile is brought up to date once; or none, where most of a batch is
    /// seldom hidden: a look at a tile takes as long as the pixels of some triangles.
    template <class Rules>
    void dropHiddenInTiles(TriangleList& triangles, const Rules& depths) const
    {
        const bool samples = stripe.shortcuts.has(Shortcut::SkippedQuestions);
        if (samples && !scratch.questions.isWorthIt()) return;
        std::size_t asked = 0, hidden = 0;
        for (std::size_t i = 0; i < triangles.count; ++i) {
            if (triangles.isAlone(i)) continue;
            ++asked;
            if (!areTilesHiding(triangles.box(i), depths.stored(triangles.nearest[i]))) continue;
            triangles.kind[i] |= TriangleList::kHidden;
            ++hidden;
        }
        scratch.questions.answered(2 * hidden > asked);
    }

    bool areTilesHiding(const PixelBox& box, float nearest) const
    {
        constexpr int kSide = 1 << Pyramid::kTileLevel;
        const int     left = box.x0 / kSide * kSide, top = stripe.firstRow + (box.y0 - stripe.firstRow) / kSide * kSide;
        for (int y = top; y < box.y1; y += kSide)
            for (int x = left; x < box.x1; x += kSide)
                if (!pass.tiles->askTile(x, y, nearest, Untold{}).hidden) return false;
        return true;
    }

    /// Opens what compact triangles may be drawn to, and lets the pyramid know: all of their reach where it has no more
    /// tiles than there are triangles, else what each of them meets.
    void openCompact(const TriangleList& triangles) const
    {
        const PixelBox& reach     = triangles.compactReach;
        Pyramid* const  marked    = markedStale();
        const bool      marks     = marked != nullptr;
        const bool      opensAll  = VisibilityBuffer::tilesIn(reach) <= triangles.count;
        const bool      marksAll  = marks && Pyramid::tilesIn(reach) <= triangles.count;
        const bool      marksEach = marks && !marksAll;
        if (opensAll) openTiles(stripe.visible, reach);
        if (marksAll) marked->touched(reach);
        if (opensAll && !marksEach) return;
        for (std::size_t i = 0; i < triangles.count; ++i) {
            if (triangles.isAlone(i) || triangles.isHidden(i)) continue;
            if (!opensAll) openTiles(stripe.visible, triangles.box(i));
            if (marksEach) marked->touched(triangles.box(i));
        }
    }

    /// The pyramid whose cells wait for a question once something has been drawn over them; or nullptr.
    Pyramid* markedStale() const
    {
        if (pass.tiles) return pass.tiles;
        return occlusion.afterDrawing == AfterDrawing::MarkStale ? occlusion.pyramid : nullptr;
    }

    /// False if the triangle is none of those that are drawn by windows.
    template <Keep kKeep, class FragmentsOf, class Rules>
    bool drawByWindows(TriangleList& triangles, std::size_t i, const FragmentsOf& fragmentsOf,
                       const Rules& depths) const
    {
        if (!drawsWindows() || triangles.isAlone(i)) return false;
        if (pass.tiles && areTilesHiding(triangles.box(i), depths.stored(triangles.nearest[i]))) return true;
        openTiles(stripe.visible, triangles.box(i));
        testCompact<kKeep>(triangles, i, i + 1, fragmentsOf, depths);
        if (Pyramid* marked = markedStale()) marked->touched(triangles.box(i));
        return true;
    }

    template <Keep kKeep, class FragmentsOf, class Rules>
    void draw(const ScreenTriangle& triangle, const FragmentsOf& fragmentsOf, const Rules& depths) const
    {
        const auto fragments = drawnAlone(fragmentsOf(triangle.rank()));
        if (triangle.patterned)
            fill<kKeep>(
                triangle,
                PatternedFragments(fragments, patternPlaneOf(stripe.scene.scene(), stripe.projection, triangle.id)),
                depths);
        else
            fill<kKeep>(triangle, fragments, depths);
    }

    template <Keep kKeep, class Fragments, class Rules>
    void fill(const ScreenTriangle& triangle, const Fragments& fragments, const Rules& depths) const
    {
        Pyramid* const waiting = markedStale();
        // Fragments that wait to be shaded look up who holds their pixel; late ones are shaded even if they are hidden.
        const bool allWait =
            Fragments::kMoment != ShadingMoment::Never && stripe.painter->operations >= Shading::kWorthWaiting;
        ShortcutSet shortcuts = stripe.shortcuts;
        if constexpr (Fragments::kMoment == ShadingMoment::BeforeTest) shortcuts.remove(Shortcut::StoredTiles);
        const TileUpkeep upkeep{waiting,
                                !allWait && shortcuts.has(Shortcut::TilePlanes)
                                    && (waiting || occlusion.afterDrawing == AfterDrawing::Nothing),
                                shortcuts};
        if constexpr (std::is_same_v<Scan, HalfSpace>) {
            if constexpr (kKeep == Keep::Nearest) {
                if (pass.tiles && !shortcuts.has(Shortcut::StoredTiles))
                    return HalfSpace::fillByTiles<kKeep>(triangle, *pass.tiles, Untold{}, fragments, stripe.visible,
                                                         depths);
            }
            HalfSpace::fill<kKeep>(triangle, fragments, upkeep, stripe.visible, depths);
        } else {
            stripe.visible.open(triangle.box);
            Scan::template fill<kKeep>(triangle, fragments, stripe.visible, depths);
            upkeep.touched(triangle.box);
        }
    }

    /// Nodes are asked about, and questions bring cells up to date. Of a small triangle of such a node a question costs
    /// more than the pixels that it could save.
    bool asksOfAskedNodes() const { return occlusion.asksNodes && occlusion.afterDrawing == AfterDrawing::MarkStale; }

    /// After a pre-pass the pixels that a question could save are only compared for equality, nearly for nothing.
    bool skipsQuestions() const
    {
        return (asksOfAskedNodes() || pass.isAfterPrepass) && stripe.shortcuts.has(Shortcut::SkippedQuestions);
    }

    /// Whether any of a batch is asked about; if so, isWorthAsking() says which.
    bool asksTriangles(const TriangleList& triangles) const
    {
        if (!occlusion.asksTriangles || !skipsQuestions()) return occlusion.asksTriangles;
        std::uint64_t pixels = 0;
        for (std::size_t i = 0; i < triangles.count; ++i) pixels += triangles.box(i).area();
        return pixels >= kWorthAsking * triangles.count;
    }

    bool isWorthAsking(const TriangleList& triangles, std::size_t i) const
    {
        if (!skipsQuestions()) return true;
        if (triangles.is(TriangleList::kCompact, i) && triangles.box(i).area() < kWorthAskingOne) return false;
        return !pass.isAfterPrepass || scratch.questions.isWorthIt();
    }

    void dropIfHidden(TriangleList& triangles, std::size_t i, DrawnTriangles& all) const
    {
        const bool hidden = isHidden(triangles, i);
        if (pass.isAfterPrepass) scratch.questions.answered(hidden);
        if (!hidden) return;
        triangles.kind[i] |= TriangleList::kHidden;
        ++all.hidden;
        all.hiddenPixels += triangles.box(i).area();
    }

    bool isHidden(const TriangleList& triangles, std::size_t i) const
    {
        const auto ask = [&](const auto& shape) {
            return askPyramid(*occlusion.pyramid, triangles.box(i), triangles.nearest[i], shape, rules);
        };
        scratch.tally.add(Unit::Questions);
        const PyramidQuery query =
            occlusion.asksByShape ? ask(TriangleCover(triangles[i], rules.notOwned())) : ask(WholeBox{});
        return query.hidden;
    }
};

/// First what the last frame saw, unasked; then everything else, against the pyramid over the first.
template <class Scan>
void drawTwoPasses(const Pass& pass, const Stripe& stripe, StripeScratch& scratch, const SceneTrees& trees,
                   const Occlusion& occlusion, StageClock& clock, const LaneRules& rules)
{
    using Convert = ScanConvert<Scan>;
    scratch.memory.begin(trees, occlusion.asksPixels && stripe.shortcuts.has(Shortcut::WholeNodes));
    const Occlusion blind{
        .pyramid = occlusion.pyramid, .asksPixels = occlusion.asksPixels, .afterDrawing = occlusion.afterDrawing};
    const Convert drawAll{pass, stripe, scratch, blind, clock, rules};
    FrontToBack(stripe, scratch, trees, blind, clock, drawAll, rules, &scratch.memory).drawRemembered();
    const Convert drawUnhidden{pass, stripe, scratch, occlusion, clock, rules};
    FrontToBack(stripe, scratch, trees, occlusion, clock, drawUnhidden, rules, &scratch.memory).visitScene();
    scratch.memory.finish();
}

/// The scene in the pipeline's order.
template <class Scan>
void drawPass(const Pipeline& pipeline, const Pass& pass, const Stripe& stripe, StripeScratch& scratch,
              const Occlusion& occlusion, StageClock& clock, const LaneRules& rules)
{
    const ScanConvert<Scan> convert{pass, stripe, scratch, occlusion, clock, rules};
    if (pipeline.order == Order::Submitted) {
        visitAsSubmitted(stripe, scratch, clock, convert, rules);
        return;
    }
    const TreeKind    kind  = pipeline.order == Order::Octree ? TreeKind::Octree : TreeKind::Bvh;
    const SceneTrees& trees = treesOf(stripe.scene, kind);
    clock.lap(Stage::Build);
    if (pipeline.coherence != Coherence::TwoPass) {
        FrontToBack(stripe, scratch, trees, occlusion, clock, convert, rules).visitScene();
        return;
    }
    drawTwoPasses<Scan>(pass, stripe, scratch, trees, occlusion, clock, rules);
}

inline AfterDrawing afterDrawing(const Pipeline& pipeline)
{
    switch (pipeline.upkeep) {
        case Upkeep::None:
        case Upkeep::AfterPrepass:
            return AfterDrawing::Nothing;
        case Upkeep::OnQuery:
            return AfterDrawing::MarkStale;
        case Upkeep::Pushed:
            return AfterDrawing::Push;
        case Upkeep::PushedFarthest:
            return AfterDrawing::PushFromFarthest;
        case Upkeep::Masked:
            return AfterDrawing::Cover;
    }
    return AfterDrawing::Nothing;
}

/// Whether the visibility buffer's own pixels may be asked, before set-up, where nodes and triangles are asked about:
/// only where each frame's pyramid is its own, whatever is hidden costs nothing, and what a batch may reach is known by
/// the definition's numbers.
inline bool mayAskPixels(const Pipeline& pipeline, ShadingMoment shading, const LaneRules& rules)
{
    return rules.hasExactDepths() && !rules.movesCorners() && !rules.dependsOnVisit()
           && pipeline.cull == Cull::NodesAndTriangles && pipeline.upkeep == Upkeep::OnQuery
           && pipeline.depth == DepthMoment::Deferred && pipeline.coherence != Coherence::LastPyramid
           && shading == ShadingMoment::Never;
}

/// Lanes read many tiles at once. A method that may ask pixels asks no other levels.
inline PyramidKind pyramidKind(const Pipeline& pipeline, bool mayAskPixels, ShortcutSet shortcuts)
{
    if (pipeline.upkeep == Upkeep::Masked) return PyramidKind::Masked;
    return mayAskPixels && shortcuts.has(Shortcut::TwoLevelPyramid) ? PyramidKind::Wide : PyramidKind::Deep;
}

template <class Scan>
void drawStream(const Pipeline& pipeline, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                const LaneRules& rules)
{
    const bool hasPrepass = pipeline.depth == DepthMoment::Prepass;
    const bool hasPyramid = pipeline.upkeep != Upkeep::None;
    const bool hasTiles   = pipeline.depth == DepthMoment::ZCull;
    const auto shading    = !stripe.painter                       ? ShadingMoment::Never
                            : pipeline.depth == DepthMoment::Late ? ShadingMoment::BeforeTest
                                                                  : ShadingMoment::AfterTest;

    scratch.questions = SampledQuestions();
    scratch.pyramid.readTilesBy(leastKeyOfTile);
    stripe.visible.emptyRows(stripe.firstRow, stripe.endRow);  // the last picture is forgotten
    if (stripe.painter && !stripe.painter->painted.data) clearColours(*stripe.painter, stripe.firstRow, stripe.endRow);
    const bool asksLast  = pipeline.coherence == Coherence::LastPyramid;
    const bool mayLook   = mayAskPixels(pipeline, shading, rules) && std::is_same_v<Scan, HalfSpace>;
    const bool continues = asksLast && scratch.pyramid.continues(stripe.visible, stripe.firstRow, stripe.endRow);
    if ((hasPyramid || hasTiles) && !continues)
        scratch.pyramid.reset(stripe.visible, stripe.firstRow, stripe.endRow,
                              pyramidKind(pipeline, mayLook, stripe.shortcuts));
    clock.lap(Stage::Clear);

    if (hasPrepass) {
        clock.countAllAs(Stage::Prepass);
        drawPass<Scan>(pipeline, Pass{.keep = Keep::DepthOnly}, stripe, scratch, Occlusion{}, clock, rules);
        clock.countAllAs(std::nullopt);
        if (hasPyramid) {
            scratch.pyramid.allTouched();
            clock.lap(Stage::Upkeep);
        }
    }

    if (asksLast && !continues) scratch.pyramid.complete();  // no frame before: empty cells hide nothing
    const Occlusion occlusion{.pyramid       = hasPyramid ? &scratch.pyramid : nullptr,
                              .asksNodes     = asksNodes(pipeline.cull),
                              .asksTriangles = asksTriangles(pipeline.cull),
                              .asksByShape   = pipeline.query == TriangleQuery::Triangle,
                              .asksPixels    = mayLook && stripe.shortcuts.has(Shortcut::HiddenSquares),
                              .afterDrawing  = asksLast ? AfterDrawing::Nothing : afterDrawing(pipeline)};
    const Pass pass{.shading = shading, .tiles = hasTiles ? &scratch.pyramid : nullptr, .isAfterPrepass = hasPrepass};
    drawPass<Scan>(pipeline, pass, stripe, scratch, occlusion, clock, rules);
    if (stripe.painter && stripe.painter->painted.data)
        colourUnopened(*stripe.painter, stripe.visible, stripe.firstRow, stripe.endRow);
    if (asksLast) {
        scratch.pyramid.reset(stripe.visible, stripe.firstRow, stripe.endRow);
        scratch.pyramid.complete();
        clock.lap(Stage::Upkeep);
    }
}

/// Enters the triangles of a batch, or one face after another, in the edge table.
struct EnterEdges {
    const Stripe& stripe;
    EdgeTable&    edges;
    TriangleList& waiting;  // that have come one by one, until there are enough
    StageClock&   clock;

    void operator()(const TriangleList& triangles) const
    {
        for (std::size_t i = 0; i < triangles.count; ++i) stripe.visible.open(triangles.box(i));
        EdgeEntry{edges}(triangles);
        clock.lap(Stage::Setup);
    }
    void operator()(const ScreenTriangle& triangle) const
    {
        if (waiting.count == kWaiting) finish();
        waiting.add(triangle);
    }
    void operator()(const ScreenFace& face, std::span<const ScreenSide> sides) const
    {
        stripe.visible.open(boxOf(sides));
        EdgeEntry{edges}(face, sides);
    }
    /// After the last one.
    void finish() const
    {
        (*this)(waiting);
        waiting.clear();
    }

private:
    static constexpr std::size_t kWaiting = 256;

    PixelBox boxOf(std::span<const ScreenSide> sides) const
    {
        double x0 = sides.front().xa, x1 = x0, y0 = sides.front().ya, y1 = y0;
        for (const ScreenSide& side : sides) {  // closed: every corner begins a side
            x0 = std::min(x0, side.xa), x1 = std::max(x1, side.xa);
            y0 = std::min(y0, side.ya), y1 = std::max(y1, side.ya);
        }
        const PixelBox region = stripe.region();
        return {std::max(region.x0, firstPixelCentreFrom(x0)), std::max(region.y0, firstPixelCentreFrom(y0)),
                std::min(region.x1, firstPixelCentreFrom(x1)), std::min(region.y1, firstPixelCentreFrom(y1))};
    }
};

inline void fillEdgeTable(const Pipeline& pipeline, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                          const LaneRules& rules)
{
    const EdgeTable::Sides sides =
        stripe.shortcuts.has(Shortcut::SharedSides) ? EdgeTable::Sides::OfWide : EdgeTable::Sides::All;
    scratch.edges.clear(stripe.firstRow, stripe.endRow, stripe.visible.width(), sides, stripe.memory);
    const EnterEdges enter{stripe, scratch.edges, scratch.faces.waiting, clock};
    scratch.faces.waiting.clear();
    if (drawsFaces(pipeline)) {
        visitFacesAsSubmitted(stripe, scratch, clock, enter, rules);
        enter.finish();
    } else {
        visitAsSubmitted(stripe, scratch, clock, enter, rules);
    }
    if (!stripe.progress.cancelled()) scratch.edges.fillBuckets();
}

template <class Resolve>
void drawSweep(const Pipeline& pipeline, const Stripe& stripe, StripeScratch& scratch, Resolve resolve,
               StageClock& clock, const LaneRules& rules)
{
    stripe.visible.emptyRows(stripe.firstRow, stripe.endRow);  // the last picture is forgotten
    clock.lap(Stage::Clear);
    fillEdgeTable(pipeline, stripe, scratch, clock, rules);
    if (stripe.progress.cancelled()) return;  // to sort the edges of millions of triangles takes seconds
    scratch.tally.add(Unit::Edges, scratch.edges.edgeCount());
    clock.lap(Stage::Setup);

    sweep(scratch.edges, scratch.active, scratch.polygons, resolve, stripe.progress, scratch.tally);
    clock.lap(Stage::Raster);
}

/// `depths`: the rules by which pixels are tested.
template <class Rules>
void drawSweepBy(const Rules& depths, const Pipeline& pipeline, const Stripe& stripe, StripeScratch& scratch,
                 StageClock& clock, const LaneRules& rules)
{
    const PatternFinder patterns{stripe.scene.scene(), stripe.projection};
    if (pipeline.scan == Scan::SweepZLine)
        drawSweep(pipeline, stripe, scratch, LineZBuffer(stripe.visible, patterns, depths), clock, rules);
    else
        drawSweep(pipeline, stripe, scratch, Intervals(stripe.visible, patterns, depths), clock, rules);
}

/// The one place where a pipeline's words become the types that draw.
inline void drawStripe(const Pipeline& pipeline, const LaneRules& rules, const Stripe& stripe, StripeScratch& scratch,
                       StageClock& clock)
{
    switch (pipeline.scan) {
        case Scan::HalfSpace:
            drawStream<HalfSpace>(pipeline, stripe, scratch, clock, rules);
            break;
        case Scan::EdgeWalk:
            drawStream<EdgeWalk>(pipeline, stripe, scratch, clock, rules);
            break;
        case Scan::SweepZLine:
        case Scan::SweepIntervals:
        case Scan::SweepPolygons:
            if (rules.hasExactDepths())
                drawSweepBy(ExactRules(), pipeline, stripe, scratch, clock, rules);
            else
                drawSweepBy(rules, pipeline, stripe, scratch, clock, rules);
            break;
    }
    stripe.visible.finishRows(stripe.firstRow, stripe.endRow);
    clock.lap(Stage::Clear);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_DRIVERS_INL_H
