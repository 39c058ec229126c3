// SPDX-License-Identifier: GPL-3.0-or-later
// The one owner of what the window is about: scene, camera, pipeline, grain, step, picked pixel. Panels read its
// snapshot and ask it for changes; everything long happens on its worker. No widgets.
//
// Requests   return at once; the answer comes with changed(). The newest request wins
// Kept       camera and step over a change of algorithm; camera, algorithm and step over a reload; everything when
//            a file cannot be loaded
// Threads    to be used from one thread; destroying it in the middle of anything cancels the work and waits for it
#pragma once

#include <functional>
#include <map>

#include <QObject>
#include <QTimer>

#include "ui/session/engine.h"
#include "ui/session/player.h"
#include "ui/session/worker.h"

namespace zscope::ui {

class Course;
class Examiner;
class Predictions;
class Tracer;

/// What stays the same for the whole run of the program; from the command line.
struct DrawSettings {
    int           threads     = 0;  // 0: one per core
    Simd          simd        = Simd::Auto;
    FaceCulling   faceCulling = FaceCulling::None;
    std::uint64_t memoryLimit = 0;
};

class Session final : public QObject {
    Q_OBJECT

public:
    explicit Session(const DrawSettings& settings = {}, QObject* parent = nullptr);
    ~Session() override;

    const Snapshot&     now() const { return m_now; }
    const DrawSettings& settings() const { return m_settings; }

    // Scene
    /// Chooses the view of a scene that has been loaded.
    using ViewOf = std::function<ViewRequest(const Scene&)>;
    /// One that is known to the bit.
    static ViewOf seenBy(const Camera& camera, FaceCulling culling);

    /// A path or builtin:NAME. Without `viewOf` the scene's own first view in the picture's present size, else one
    /// framed from its bounds.
    void open(const QString& word, const ViewOf& viewOf = {});
    void reload();
    /// Stops what is being loaded, drawn or replayed.
    void cancelWork();

    // Camera
    void useView(const ViewRequest& view);
    /// Lets `move` change the camera; the session keeps picture size, field of view, near and far.
    void          moveCamera(const std::function<void(CameraControl&)>& move);
    CameraControl control() const;
    void          resetCamera();
    void          normaliseModel();
    void          setPictureSize(int width, int height);

    // Algorithm
    void setPipeline(const Pipeline& pipeline);
    void setFaceCulling(FaceCulling culling);
    void setLayer(const Layer& layer);
    void setDepthRange(const DepthRange& range);

    // Steps
    void setGrain(Grain grain);
    void goToStep(std::uint64_t step);
    /// The step to show when the scene that is being loaded is there; after open().
    void startAt(std::uint64_t step) { m_firstStep = step; }
    /// What is picked, selected and marked in the scene that is being loaded, once it is there; after open().
    void startWith(const Selection& selection) { m_firstSelection = selection; }
    void goToStart() { goToStep(0); }
    void goToEnd();
    /// A step of another grain, which becomes the one that is stepped by; nothing happens if the algorithm has none
    /// such.
    void goToStepOf(Grain grain, std::uint64_t step);
    void stepBy(int steps);
    /// To the next (+1) or an earlier (-1) step of the next coarser grain that the algorithm has.
    void stepCoarser(int steps);

    // Selection
    void pick(const std::optional<QPoint>& pixel);
    void nudgePick(const QPoint& by);
    void selectEdge(const std::optional<EdgeRow>& edge);
    void selectLevel(const std::optional<int>& level);
    void selectNode(const std::optional<NodeName>& node);
    void selectTriangle(const std::optional<TriangleId>& triangle);

    /// Which nodes have their boxes shown and stand in the tree.
    void showNodes(const VerdictSet& verdicts);
    void setLayers(const Layers& layers);

    // Comparison
    /// B; nothing ends the comparison.
    void compareWith(const std::optional<Pipeline>& other);
    /// B that another program drew, or the same judged further.
    void compareWithTheirs(const std::shared_ptr<const TheirPicture>& theirs);
    void swapCompared();
    void showCompared(CompareShow show);
    /// B is seen while it is held.
    void holdOther(bool held);
    void setWipe(double part);
    void setTolerance(std::uint32_t steps);
    void linkSteps(bool linked);
    void linkBy(Link link);

    // Marks
    void setMarks(const Marks& marks);
    /// Of the step on show.
    void toggleBookmark();
    void nameBookmark(std::size_t index, const QString& name);
    void removeBookmark(std::size_t index);
    void goToBookmark(std::size_t index);
    /// Among those of this pipeline and grain.
    void goToNextBookmark(Direction direction);
    void toggleBreakpoint(const Breakpoint& breakpoint);
    void removeBreakpoint(std::size_t index);
    /// To the next step that meets a breakpoint, or the one before.
    void runTo(Direction direction);
    enum class PixelJump { First, Next, Previous };
    /// To a step that changes the picked pixel.
    void goToPixelChange(PixelJump jump);

    bool         isIdle() const;
    Player&      player() { return m_player; }
    Course&      course() { return *m_course; }
    Examiner&    examiner() const { return *m_examiner; }
    Tracer&      tracer() const { return *m_tracer; }
    Predictions& predictions() { return *m_predictions; }
    /// What is shown of the picture's step has changed without it: panels look again.
    void presentAgain() { emit changed(Change::Picture); }
    /// What draws the picture that is wanted now.
    DrawRequest request() const;
    /// Number of steps at the current grain and the step that is wanted; nothing while they are not known.
    struct Position {
        std::uint64_t step, count;
    };
    std::optional<Position> position() const;

signals:
    void changed(zscope::ui::Changes what);
    /// One sentence a person can act on, with file and line where they are known.
    /// `again` says it in the language of the moment, where it can be said anew.
    void failed(const QString& sentence, const std::function<QString()>& again = {});
    /// What came of a search, and the like: good to know for a moment.
    void noticed(const QString& sentence);
    /// The pixel that is picked already: nothing changes, but it is asked about once more.
    void pickedAgain();

private:
    void draw();
    void step();
    void repaint();  // if anything on show looks otherwise than it should
    void drawOther();
    void stepOther();
    void compareTheirs();  // with A's finished picture
    struct SearchAnswer {
        std::optional<std::uint64_t>        step;  // to go to
        QString                             notice;
        std::shared_ptr<const PixelHistory> history;
    };
    void search(std::function<Result<SearchAnswer>(const DrawRequest&)> find);
    void compareAgain();  // with another tolerance, or after B was drawn
    void otherChanged();
    void startOver();  // something the picture depends on has changed
    void applyView(const ViewRequest& view);
    void adoptGrain();  // after a change of algorithm
    void sceneLoaded(const std::shared_ptr<const LoadedScene>& scene, const ViewOf& viewOf, bool keepsCamera);
    void frameDrawn(const std::shared_ptr<const DrawnFrame>& frame);
    void stepMade(const std::shared_ptr<const ShownStep>& step, std::uint64_t wish);
    void troubled(const Error& error);
    void setBusy(const QString& what, double progress = -1);
    void load(const QString& word, const ViewOf& viewOf, bool keepsCamera);
    void wishFor(const StepWish& wish);
    bool isSettled() const { return m_settledWish == m_wishNumber; }
    /// Runs in this thread what a job of the worker hands back, unless the session is gone by then.
    template <class Answer>
    void deliver(Answer answer)
    {
        m_worker->deliver(std::move(answer));
    }

    DrawSettings                 m_settings;
    Snapshot                     m_now;
    std::optional<CameraControl> m_control;  // once the user has moved the camera
    ViewRequest                  m_home;     // what reset goes back to
    std::uint64_t                m_generation = 0;
    StepWish                     m_wish;
    std::uint64_t                m_wishNumber  = 0;
    std::uint64_t                m_settledWish = ~std::uint64_t{0};  // the wish that m_now.step answers
    std::optional<std::uint64_t> m_firstStep;
    std::optional<Selection>     m_firstSelection;
    std::optional<Grain>         m_preferredGrain;  // what the user chose, also while an algorithm lacks it
    Player                       m_player{*this};
    QTimer                       m_rest;         // the finished picture's tables are made when the camera rests
    std::shared_ptr<Engine>      m_engine;       // used by jobs of the worker only
    std::shared_ptr<Engine>      m_otherEngine;  // likewise, for B
    std::unique_ptr<Worker>      m_worker;       // stops before anything that it works with goes
    std::unique_ptr<Predictions> m_predictions;  // hears of a step before any panel does
    std::unique_ptr<Course>      m_course;       // go first: they ask the session
    std::unique_ptr<Examiner>    m_examiner;
    std::unique_ptr<Tracer>      m_tracer;
};

}  // namespace zscope::ui

Q_DECLARE_METATYPE(zscope::ui::Changes)
