// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "ui/predict/predictions.h"
#include "ui/session/course.h"
#include "ui/session/examiner.h"
#include "ui/session/tracer.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {
namespace {

constexpr std::chrono::milliseconds kRest{120};
constexpr std::chrono::milliseconds kProgressEvery{40};

/// In the layer on show; depths in the range that A's have.
bool isPaintedFor(const TheirPicture& theirs, const Look& look, const DrawnFrame* a)
{
    if (theirs.look.layer != look.layer) return false;
    const bool hasRange = a && a->look == look && !a->spread.histogram.empty();
    return !hasRange || theirs.look.range == a->spread.used;
}

bool has(const std::vector<Grain>& grains, Grain grain) { return std::ranges::find(grains, grain) != grains.end(); }

}  // namespace

Session::Session(const DrawSettings& settings, QObject* parent)
    : QObject(parent), m_settings(settings), m_engine(std::make_shared<Engine>()),
      m_otherEngine(std::make_shared<Engine>()), m_worker(std::make_unique<Worker>())
{
    m_now.pipeline = findPreset(kDefaultPreset)->pipeline;
    m_now.grain    = ownGrainOf(m_now.pipeline);
    m_wish.grain = m_wish.counted = m_now.grain;

    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, &Session::step);
    connect(m_worker.get(), &Worker::idle, this, [this] {
        if (isIdle()) setBusy({});
    });
    m_predictions = std::make_unique<Predictions>(*this);
    m_course      = std::make_unique<Course>(*this);
    m_examiner    = std::make_unique<Examiner>(*this);
    m_tracer      = std::make_unique<Tracer>(*this);
}

Session::~Session() = default;

bool Session::isIdle() const { return !m_worker->isBusy() && !m_rest.isActive(); }

// Scene -------------------------------------------------------------------------------------------------------------

Session::ViewOf Session::seenBy(const Camera& camera, FaceCulling culling)
{
    return [camera, culling](const Scene&) {
        ViewRequest view;
        view.width       = camera.width;
        view.height      = camera.height;
        view.exact       = camera;
        view.faceCulling = culling;
        return view;
    };
}

void Session::open(const QString& word, const ViewOf& viewOf)
{
    m_firstStep.reset();
    m_firstSelection.reset();
    load(word, viewOf, false);
}

void Session::reload()
{
    if (m_now.scene) load(m_now.scene->word, {}, true);
}

void Session::load(const QString& word, const ViewOf& viewOf, bool keepsCamera)
{
    m_rest.stop();
    setBusy(tr("Loading"), 0);
    m_worker->post(Worker::Slot::Load, [this, word, viewOf, keepsCamera](const std::atomic<bool>& cancel) {
        auto        told = std::chrono::steady_clock::now();
        LoadOptions options{.memoryLimit = m_settings.memoryLimit};
        options.progress.cancel = &cancel;
        options.progress.report = [&](double fraction, std::string_view what) {
            const auto time = std::chrono::steady_clock::now();
            if (time - told < kProgressEvery) return;
            told = time;
            deliver([this, fraction, text = std::string(what)] {
                if (m_worker->isBusy()) setBusy(tr("Loading: %1").arg(said(text)), fraction);
            });
        };
        auto loaded = m_engine->load(word, options);
        deliver([this, loaded = std::move(loaded), viewOf, keepsCamera] {
            if (loaded) return sceneLoaded(*loaded, viewOf, keepsCamera);
            troubled(loaded.error());
            if (m_now.scene && (!m_now.frame || m_now.frame->generation != m_generation))
                draw();
            else if (!isSettled())
                step();  // the load has swept away what was waiting
        });
    });
}

void Session::cancelWork()
{
    m_rest.stop();
    const bool isDrawing =
        m_worker->isBusy() && m_now.scene && (!m_now.frame || m_now.frame->generation != m_generation);
    m_worker->cancel();
    if (isDrawing)
        emit noticed(tr("The drawing was cancelled. It begins again with the next step, or with another algorithm."));
}

void Session::sceneLoaded(const std::shared_ptr<const LoadedScene>& scene, const ViewOf& viewOf, bool keepsCamera)
{
    m_now.scene = scene;
    // of another scene, or of this one as it was: should the drawing be cancelled, nothing is shown under a name that
    // is not its own
    m_now.frame.reset();
    m_now.step.reset();
    m_now.showsStep     = false;
    m_now.compare.frame = nullptr;
    m_now.compare.step  = nullptr;
    m_now.compare.result.reset();
    m_now.marks.history.reset();
    m_now.selectedEdge.reset();
    m_now.selectedNode.reset();
    m_now.selectedTriangle.reset();
    if (!keepsCamera) {
        m_now.picked.reset();
        m_now.marks = {};
        m_control.reset();
        ViewRequest home;
        if (viewOf)
            home = viewOf(scene->scene());
        else if (!scene->scene().views.empty())
            home = scene->scene().views.front().view;
        if (!viewOf) {
            home.width  = m_now.view.width;
            home.height = m_now.view.height;
            if (home.exact) home.exact->width = home.width, home.exact->height = home.height;
        }
        m_home = home;
        if (home.faceCulling) m_settings.faceCulling = *home.faceCulling;
        m_wish = {.grain = m_now.grain, .counted = m_now.grain};
        if (m_firstStep)
            m_wish = {
                .grain = m_now.grain, .from = StepWish::From::Start, .offset = *m_firstStep, .counted = m_now.grain};
        m_firstStep.reset();
        if (m_firstSelection) {
            m_now.picked           = m_firstSelection->picked;
            m_now.selectedNode     = m_firstSelection->node;
            m_now.selectedTriangle = m_firstSelection->triangle;
            m_now.selectedLevel    = m_firstSelection->level;
            m_now.marks            = m_firstSelection->marks;
            m_firstSelection.reset();
        }
        ++m_wishNumber;
    }
    emit changed(Change::Scene | Change::Selection | Change::Pipeline | Change::Marks);
    applyView(keepsCamera ? m_now.view : m_home);
}

// Camera ------------------------------------------------------------------------------------------------------------

void Session::useView(const ViewRequest& view)
{
    m_home = view;
    m_control.reset();
    applyView(view);
}

void Session::applyView(const ViewRequest& view)
{
    const auto camera = makeCamera(view, m_now.scene ? m_now.scene->scene().bounds : Bounds{});
    if (!camera) {
        troubled(camera.error());
        if (!m_now.frame || m_now.frame->camera != m_now.camera) startOver();
        return;
    }
    m_now.view   = view;
    m_now.camera = *camera;
    emit changed(Change::Camera);
    startOver();
}

CameraControl Session::control() const
{
    if (m_control) return *m_control;
    return CameraControl::of(m_now.camera, m_now.scene ? m_now.scene->scene().bounds : Bounds{});
}

void Session::moveCamera(const std::function<void(CameraControl&)>& move)
{
    if (!m_now.scene) return;
    CameraControl moved = control();
    move(moved);
    ViewRequest base = m_now.view;
    if (base.exact) {  // ten numbers given: keep what a request can say of them
        base.verticalFov = 2 * std::atan(1 / base.exact->focal) * 180 / std::numbers::pi;
        base.near        = base.exact->near;
        base.far         = base.exact->far;
        base.width       = base.exact->width;
        base.height      = base.exact->height;
    }
    m_control = moved;
    applyView(moved.view(base));
}

void Session::resetCamera()
{
    m_home.width  = m_now.view.width;
    m_home.height = m_now.view.height;
    m_control.reset();
    applyView(m_home);
}

void Session::normaliseModel()
{
    if (!m_now.scene) return;
    moveCamera([this](CameraControl& control) { control = facing(m_now.scene->cube, m_now.camera.focal); });
}

void Session::setPictureSize(int width, int height)
{
    ViewRequest view = m_now.view;
    view.width       = width;
    view.height      = height;
    if (view.exact) view.exact->width = width, view.exact->height = height;
    if (!m_now.scene) {
        m_now.view = view;
        return;
    }
    applyView(view);
}

// Algorithm ---------------------------------------------------------------------------------------------------------

void Session::setPipeline(const Pipeline& pipeline)
{
    if (pipeline == m_now.pipeline) return;
    m_now.pipeline = pipeline;
    adoptGrain();
    emit changed(Change::Pipeline);
    startOver();
}

void Session::setFaceCulling(FaceCulling culling)
{
    if (culling == m_settings.faceCulling) return;
    m_settings.faceCulling = culling;
    emit changed(Change::Pipeline);
    startOver();
}

void Session::setLayer(const Layer& layer)
{
    if (&layer == m_now.look.layer) return;
    m_now.look.layer = &layer;
    emit changed(Change::Pipeline);
    repaint();
}

void Session::setDepthRange(const DepthRange& range)
{
    if (range == m_now.look.range) return;
    m_now.look.range = range;
    emit changed(Change::Pipeline);
    repaint();
}

void Session::repaint()
{
    const auto looks = [this](const auto& shown) { return !shown || shown->look == m_now.look; };
    if (looks(m_now.frame) && looks(m_now.step) && looks(m_now.compare.frame) && looks(m_now.compare.step)
        && (!m_now.compare.theirs || isPaintedFor(*m_now.compare.theirs, m_now.look, m_now.frame.get())))
        return;
    m_worker->post(Worker::Slot::Repaint,
                   [this, look = m_now.look, frame = m_now.frame, step = m_now.step, other = m_now.compare.frame,
                    otherStep = m_now.compare.step, theirs = m_now.compare.theirs](const std::atomic<bool>&) {
                       const auto ofFrame = [&](const auto& from) {
                           return from && from->look != look ? repainted(*from, look) : from;
                       };
                       const auto ofStep = [&](const auto& from, const auto& finished) {
                           return from && from->look != look ? repainted(*from, finished.get(), look) : from;
                       };
                       auto newFrame = ofFrame(frame), newOther = ofFrame(other);
                       auto newStep = ofStep(step, newFrame), newOtherStep = ofStep(otherStep, newOther);
                       auto newTheirs = theirs;
                       if (theirs && !isPaintedFor(*theirs, look, newFrame.get()))
                           newTheirs = repainted(*theirs, look, newFrame.get());
                       deliver([=, this] {
                           // Whatever has been made anew since then is painted on its own account.
                           if (m_now.frame == frame) m_now.frame = newFrame;
                           if (m_now.step == step) m_now.step = newStep;
                           if (m_now.compare.frame == other) m_now.compare.frame = newOther;
                           if (m_now.compare.step == otherStep) m_now.compare.step = newOtherStep;
                           if (m_now.compare.theirs == theirs) m_now.compare.theirs = newTheirs;
                           emit changed(Change::Picture);
                           compareAgain();
                           compareTheirs();
                           repaint();
                       });
                   });
}

void Session::adoptGrain()
{
    const std::vector<Grain> grains  = grainsOf(m_now.pipeline);
    const Grain              wanted  = m_preferredGrain.value_or(ownGrainOf(m_now.pipeline));
    const Grain              adopted = has(grains, wanted)                       ? wanted
                                       : has(grains, ownGrainOf(m_now.pipeline)) ? ownGrainOf(m_now.pipeline)
                                                                                 : grains.back();
    if (adopted == m_now.grain) return;
    StepWish wish{.grain = adopted, .counted = adopted};
    // steps of another kind: keep the place in the run
    if (const auto at = position(); at && at->step + 1 < at->count) {
        wish.from     = StepWish::From::Fraction;
        wish.fraction = static_cast<double>(at->step) / static_cast<double>(at->count - 1);
    }
    m_now.grain = adopted;
    m_wish      = wish;
    ++m_wishNumber;
}

// Steps -------------------------------------------------------------------------------------------------------------

void Session::setGrain(Grain grain)
{
    if (grain == m_now.grain || !has(grainsOf(m_now.pipeline), grain)) return;
    m_preferredGrain = grain;
    StepWish wish{.grain = grain, .counted = grain};
    if (const auto at = position(); at && at->step + 1 < at->count)
        wish = {.grain = grain, .from = StepWish::From::Start, .offset = at->step, .counted = m_now.grain};
    m_now.grain = grain;
    emit changed(Change::Pipeline);
    wishFor(wish);
}

std::optional<Session::Position> Session::position() const
{
    const ShownStep* step = m_now.step.get();
    if (!step || step->state.grain != m_now.grain || step->pipeline != m_now.pipeline) return {};
    const std::uint64_t count = step->state.count;
    if (isSettled()) return Position{step->state.step.value, count};
    if (m_wish.counted != m_now.grain || m_wish.move != 0 || m_wish.from == StepWish::From::Fraction) return {};
    const std::uint64_t offset = std::min(m_wish.offset, count - 1);
    return Position{m_wish.from == StepWish::From::Start ? offset : count - 1 - offset, count};
}

void Session::goToStep(std::uint64_t step)
{
    wishFor({.grain = m_now.grain, .from = StepWish::From::Start, .offset = step, .counted = m_now.grain});
}

void Session::goToEnd() { wishFor({.grain = m_now.grain, .counted = m_now.grain}); }

void Session::goToStepOf(Grain grain, std::uint64_t step)
{
    if (!has(grainsOf(m_now.pipeline), grain)) return;
    m_preferredGrain = grain;
    m_now.grain      = grain;
    emit changed(Change::Pipeline);
    goToStep(step);
}

void Session::stepBy(int steps)
{
    if (const auto at = position()) {
        const auto last = static_cast<std::int64_t>(at->count) - 1;
        const auto to   = std::clamp<std::int64_t>(static_cast<std::int64_t>(at->step) + steps, 0, last);
        if (to == last) return goToEnd();
        return goToStep(static_cast<std::uint64_t>(to));
    }
    StepWish wish = m_wish;  // where that is, is not known yet: go on from there
    wish.after += steps;
    wishFor(wish);
}

void Session::stepCoarser(int steps)
{
    const std::vector<Grain> grains = grainsOf(m_now.pipeline);
    const auto               here   = std::ranges::find(grains, m_now.grain);
    if (here == grains.begin() || here == grains.end()) return stepBy(steps);
    const Grain coarser = *(here - 1);
    StepWish    wish    = m_wish;
    if (const auto at = position())
        wish = {.grain = m_now.grain, .from = StepWish::From::Start, .offset = at->step, .counted = m_now.grain};
    wish.moveGrain = coarser;
    wish.move += steps;
    wishFor(wish);
}

void Session::wishFor(const StepWish& wish)
{
    m_wish = wish;
    ++m_wishNumber;
    if (wish.isEnd() && m_now.frame && m_now.frame->generation == m_generation && m_now.showsStep) {
        m_now.showsStep = false;  // the finished picture is at hand
        emit changed(Change::Picture);
    }
    step();
}

// Work --------------------------------------------------------------------------------------------------------------

DrawRequest Session::request() const
{
    return {.scene       = m_now.scene->prepared,
            .camera      = m_now.camera,
            .faceCulling = m_settings.faceCulling,
            .pipeline    = m_now.pipeline,
            .threads     = m_settings.threads,
            .simd        = m_settings.simd,
            .memoryLimit = m_settings.memoryLimit};
}

void Session::startOver()
{
    if (!m_now.scene) return;
    ++m_generation;
    m_settledWish = ~std::uint64_t{0};
    draw();
}

void Session::draw()
{
    m_rest.stop();
    setBusy(tr("Drawing"));
    m_worker->post(Worker::Slot::Draw, [this, request = request(), generation = m_generation,
                                        look = m_now.look](const std::atomic<bool>& cancel) mutable {
        request.cancel = &cancel;
        auto drawn     = m_engine->draw(generation, request, look);
        deliver([this, drawn = std::move(drawn)] {
            if (drawn)
                frameDrawn(*drawn);
            else
                troubled(drawn.error());
        });
    });
}

void Session::step()
{
    if (!m_now.scene) return;
    if (!m_now.frame || m_now.frame->generation != m_generation) {  // after the drawing, which may have been cancelled
        if (!m_worker->isBusy()) draw();
        return;
    }
    setBusy(tr("Replaying"));
    m_worker->post(Worker::Slot::Step,
                   [this, request = request(), generation = m_generation, wish = m_wish, number = m_wishNumber,
                    look = m_now.look](const std::atomic<bool>& cancel) mutable {
                       request.cancel = &cancel;
                       auto made      = m_engine->step(generation, request, look, wish);
                       deliver([this, made = std::move(made), number] {
                           if (made)
                               stepMade(*made, number);
                           else
                               troubled(made.error());
                       });
                   });
}

void Session::frameDrawn(const std::shared_ptr<const DrawnFrame>& frame)
{
    m_now.frame      = frame;
    const bool atEnd = m_wish.isEnd();
    if (atEnd || !m_now.step) m_now.showsStep = false;
    emit changed(Change::Picture);
    repaint();                                      // if the look has changed while it was drawn
    if (frame->generation != m_generation) return;  // a newer one is on its way
    if (m_now.compare.other) drawOther();
    compareTheirs();
    if (atEnd)
        m_rest.start();
    else
        step();
}

void Session::stepMade(const std::shared_ptr<const ShownStep>& step, std::uint64_t wish)
{
    if (step->state.grain != m_now.grain || step->pipeline != m_now.pipeline) return;  // of another algorithm by now
    m_now.step = step;
    if (wish == m_wishNumber && step->generation == m_generation) {
        m_settledWish       = wish;
        const bool wasExact = m_wish.from == StepWish::From::Start && m_wish.counted == m_now.grain && m_wish.move == 0
                              && m_wish.after == 0;
        if (step->isLast() && !(wasExact && m_wish.offset > step->last()))
            m_wish = {.grain = m_now.grain, .counted = m_now.grain};
        else if (!wasExact)  // from now on it is a number
            m_wish = {.grain   = m_now.grain,
                      .from    = StepWish::From::Start,
                      .offset  = step->state.step.value,
                      .counted = m_now.grain};
    }
    const bool isOver = m_wish.isEnd() || (isSettled() && step->isLast());
    m_now.showsStep   = !(isOver && m_now.frame && m_now.frame->generation == m_generation);
    emit changed(Change::Picture);
    repaint();
    if (m_now.compare.other && step->generation == m_generation) stepOther();
    compareTheirs();
}

void Session::troubled(const Error& error)
{
    if (error.kind == Trouble::Cancelled) return;
    emit failed(said(error), [error] { return said(error); });
}

void Session::setBusy(const QString& what, double progress)
{
    if (what == m_now.busy && progress == m_now.progress) return;
    m_now.busy     = what;
    m_now.progress = progress;
    emit changed(Change::Busy);
}

// Selection ---------------------------------------------------------------------------------------------------------

void Session::pick(const std::optional<QPoint>& pixel)
{
    if (pixel == m_now.picked) return pixel ? emit pickedAgain() : void();
    m_now.picked = pixel;
    m_now.selectedTriangle.reset();
    if (m_now.hierarchy()) m_now.selectedNode = nodeOfPick(m_now);
    emit changed(Change::Selection);
    if (m_now.compare.other && m_now.compare.link == Link::Pixel && m_now.compare.isLinked && m_now.showsStep
        && isSettled())
        stepOther();
}

void Session::nudgePick(const QPoint& by)
{
    const Camera& camera = m_now.pictureCamera();
    const QPoint  from   = m_now.picked.value_or(QPoint(camera.width / 2, camera.height / 2));
    const QPoint  to     = m_now.picked ? from + by : from;
    pick(QPoint(std::clamp(to.x(), 0, camera.width - 1), std::clamp(to.y(), 0, camera.height - 1)));
}

void Session::selectLevel(const std::optional<int>& level)
{
    if (level == m_now.selectedLevel) return;
    m_now.selectedLevel = level;
    emit changed(Change::Selection);
}

void Session::selectNode(const std::optional<NodeName>& node)
{
    if (node == m_now.selectedNode) return;
    m_now.selectedNode = node;
    emit changed(Change::Selection);
}

void Session::selectTriangle(const std::optional<TriangleId>& triangle)
{
    if (triangle == m_now.selectedTriangle) return;
    m_now.selectedTriangle = triangle;
    emit changed(Change::Selection);
}

void Session::showNodes(const VerdictSet& verdicts)
{
    if (verdicts == m_now.shownNodes) return;
    m_now.shownNodes = verdicts;
    emit changed(Change::Layers);
}

void Session::setLayers(const Layers& layers)
{
    if (layers == m_now.layers) return;
    m_now.layers = layers;
    emit changed(Change::Layers);
}

void Session::selectEdge(const std::optional<EdgeRow>& edge)
{
    if (edge == m_now.selectedEdge) return;
    m_now.selectedEdge = edge;
    emit changed(Change::Selection);
}

}  // namespace zscope::ui
