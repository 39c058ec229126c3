#include "core/frame/plain_stripe.h"

#include <glm/geometric.hpp>

#include "core/frame/frame_events.h"
#include "core/frame/methods.h"
#include "core/method/hierarchical.h"
#include "core/method/intervals.h"
#include "core/method/prepass.h"
#include "core/method/scanline.h"
#include "core/method/transparency.h"
#include "core/method/two_pass.h"
#include "core/method/zbuffer.h"
#include "core/plain/questions.h"
#include "core/plain/set_up_batch.h"
#include "core/shade/painter.h"

namespace zscope {

namespace plain {

namespace {

void enterTriangles(Call work)
{
    for (const ScreenTriangle& triangle : work->scratch.triangles) work->scratch.edges.add(triangle, work->rules);
    work->clock.lap(Stage::Setup);
}

}  // namespace

Parts plainParts()
{
    return {.mayBeSeen   = [](Call, const BatchPlace&) { return true; },
            .setUp       = setUpBatch,
            .draw        = drawEachTriangle,
            .judge       = judgeNode,
            .push        = pushOnStack,
            .pop         = popFromStack,
            .enterEdges  = enterTriangles,
            .resolveLine = resolveByDepth};
}

}  // namespace plain

namespace {

using namespace plain;

/// Reports that a stage has begun, and when it is finished.
class InStage {
public:
    InStage(Call work, Stage stage) : m_work(*work), m_stage(stage) { work->tell(StageStarted{stage}); }
    /// `says`: what the stage came to, in words of the method's own, with the number of what it made.
    void finish(StageFinished::Says* says = nullptr, std::uint64_t made = 0, SourceLine call = SourceLine::here()) const
    {
        m_work.call = call;
        m_work.tell(StageFinished{m_stage, says, made}, call);
    }

private:
    Work& m_work;
    Stage m_stage;
};

AfterDrawing afterDrawing(Upkeep upkeep)
{
    switch (upkeep) {
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

Pass passOf(const Pipeline& pipeline)
{
    const bool asksLast = pipeline.coherence == Coherence::LastPyramid;
    return {.keep          = Keep::Nearest,
            .shading       = !shadesFragments(pipeline.depth)      ? ShadingMoment::Never
                             : pipeline.depth == DepthMoment::Late ? ShadingMoment::BeforeTest
                                                                   : ShadingMoment::AfterTest,
            .walksEdges    = pipeline.scan == Scan::EdgeWalk,
            .testsTiles    = pipeline.depth == DepthMoment::ZCull,
            .asksNodes     = asksNodes(pipeline.cull),
            .asksTriangles = asksTriangles(pipeline.cull),
            .asksByShape   = pipeline.query == TriangleQuery::Triangle,
            .afterDrawing  = asksLast ? AfterDrawing::Nothing : afterDrawing(pipeline.upkeep)};
}

/// The scene in the pipeline's order.
void drawScene(const Pipeline& pipeline, const Pass& pass, Work& work)
{
    const Parts parts = plainParts();
    if (pipeline.order == Order::Submitted) return zbuffer(work, parts, pass);
    const TreeKind    kind  = pipeline.order == Order::Octree ? TreeKind::Octree : TreeKind::Bvh;
    const SceneTrees& trees = treesOf(work.stripe.scene, kind);
    work.clock.lap(Stage::Build);
    work.scratch.nodes.clear();
    TreeVisit visit(work, trees);
    if (pipeline.coherence == Coherence::TwoPass && pass.keep != Keep::DepthOnly)
        twoPass(work, parts, pass, visit);
    else
        hierarchical(work, parts, pass, visit);
    work.clock.lap(Stage::Cull);
}

void clear(Work& work)
{
    work.stripe.visible.clearRows(work.stripe.firstRow, work.stripe.endRow);
    work.stripe.visible.open(work.stripe.region());
    if (work.stripe.painter) clearColours(*work.stripe.painter, work.stripe.firstRow, work.stripe.endRow);
}

/// A fault: the depths of the frame before. Its eye stood farther left and farther back, by a sixteenth of the way to
/// the scene's centre. It reports no events.
void leaveDepthsOfFrameBefore(const Pass& pass, Work& work)
{
    const Stripe& now    = work.stripe;
    const Bounds& bounds = now.scene.scene().bounds;
    Projection    before = now.projection;
    const double  step   = glm::distance(0.5 * (bounds.min + bounds.max), before.eye) / 16;
    before.eye -= step * before.right + step * before.forward;
    const Stripe stripe{now.scene,  before,       now.culling, now.visible, now.firstRow,
                        now.endRow, now.progress, nullptr,     now.memory};
    Tally        tally;
    Work         last{stripe, work.rules, work.scratch, work.clock, tally};
    Pass         depth;
    depth.keep       = Keep::DepthOnly;
    depth.walksEdges = pass.walksEdges;
    work.clock.countAllAs(Stage::Clear);
    zbuffer(last, plainParts(), depth);
    work.clock.countAllAs(std::nullopt);
}

/// `fill`: enters the scene in the edge table. `resolveLine`: the part of that name.
void sweepLines(Work& work, void (*fill)(Work&, const Parts&), void (*resolveLine)(Call, int))
{
    clear(work);
    work.clock.lap(Stage::Clear);
    Parts parts       = plainParts();
    parts.resolveLine = resolveLine;

    const InStage settingUp(work, Stage::Setup);
    if (!work.observer || !work.observer->isOnTheWay()) fill(work, parts);  // else the table is still full
    if (work.isCancelled()) return;  // to sort the edges of millions of triangles takes seconds
    work.tally.add(Unit::Edges, work.scratch.edges.edgeCount());
    if (!work.leavesOut(Checkpoint::AllSetUp)) work.tell(EdgeTableReady{work.scratch.edges});
    work.clock.lap(Stage::Setup);
    settingUp.finish(sentenceOfEdgeTable, work.scratch.edges.edgeCount());

    const InStage sweeping(work, Stage::Raster);
    scanline(work, parts);
    work.clock.lap(Stage::Raster);
    sweeping.finish();
}

}  // namespace

void drawTriangles(const Pipeline& pipeline, Work& work)
{
    const Stripe& stripe     = work.stripe;
    Pyramid&      pyramid    = work.scratch.pyramid;
    const bool    hasPyramid = pipeline.upkeep != Upkeep::None;
    const bool    asksLast   = pipeline.coherence == Coherence::LastPyramid;
    const bool    continues  = asksLast && pyramid.continues(stripe.visible, stripe.firstRow, stripe.endRow);
    const Pass    pass       = passOf(pipeline);

    const InStage clearing(work, Stage::Clear);
    clear(work);
    if (work.rules.keepsLastDepths()) leaveDepthsOfFrameBefore(pass, work);
    if ((hasPyramid || pass.testsTiles) && !continues)
        pyramid.reset(stripe.visible, stripe.firstRow, stripe.endRow, pipeline.fault,
                      pipeline.upkeep == Upkeep::Masked ? PyramidKind::Masked : PyramidKind::Deep);
    if (asksLast && !continues) pyramid.complete();  // there is no frame before: empty cells hide nothing
    work.clock.lap(Stage::Clear);
    clearing.finish();

    const auto draw = [&](const Pass& which) {
        const bool    isPrepass = which.keep == Keep::DepthOnly;
        const Stage   stage     = isPrepass ? Stage::Prepass : Stage::Raster;
        const InStage drawing(work, stage);
        if (isPrepass) work.clock.countAllAs(stage);
        drawScene(pipeline, which, work);
        work.clock.countAllAs(std::nullopt);
        drawing.finish();
    };
    if (pipeline.depth == DepthMoment::Prepass)
        drawAfterPrepass(work, pass, hasPyramid, draw);
    else
        draw(pass);
    if (asksLast) {
        pyramid.reset(stripe.visible, stripe.firstRow, stripe.endRow, pipeline.fault);
        pyramid.complete();
        work.clock.lap(Stage::Upkeep);
    }
}

void drawLinesByDepth(const Pipeline&, Work& work) { sweepLines(work, fillEdgeTable, resolveByDepth); }
void drawLinesByIntervals(const Pipeline&, Work& work) { sweepLines(work, fillEdgeTable, resolveByIntervals); }
void drawFacesByIntervals(const Pipeline&, Work& work)
{
    const auto fill = [](Work& into, const Parts&) { fillEdgeTableWithFaces(into); };
    sweepLines(work, fill, resolveByIntervals);
}

void drawByWhole(const Pipeline& pipeline, Work& work)
{
    const InStage clearing(work, Stage::Clear);
    clear(work);
    work.clock.lap(Stage::Clear);
    clearing.finish();

    const InStage drawing(work, Stage::Raster);
    methodOf(pipeline).whole(work, plainParts());
    work.clock.lap(Stage::Raster);
    drawing.finish();
}

void drawPlainly(const Pipeline& pipeline, Work& work) { methodOf(pipeline).draw(pipeline, work); }

void blendPlainly(const TransparentSurfaces& surfaces, const ColourTable& colours, BlendOrder order, Work& work,
                  GridView<std::uint32_t> colour)
{
    work.clock.countAllAs(Stage::Shade);
    blendTransparent(work, plainParts(), surfaces, colours, order, colour);
    work.clock.lap(Stage::Shade);
    work.clock.countAllAs(std::nullopt);
}

}  // namespace zscope
