// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows, as one value. Panels are functions of it: they hold no truth of their own, and ask the
// session for changes.
//
// Threads    the parts are immutable once shared; the worker makes new ones, the window swaps them in
// Age        a generation is one combination of scene, camera, size and pipeline. Parts of different generations
//            can be side by side for a moment while the newest is being made; compare before relating them
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <QFlags>
#include <QImage>
#include <QPoint>
#include <QString>

#include "core/lesson/difference.h"
#include "core/lesson/layers.h"
#include "core/lesson/node_boxes.h"
#include "core/lesson/outside_view.h"
#include "core/lesson/pyramid_levels.h"
#include "core/lesson/replay.h"
#include "core/scene/load.h"
#include "ui/camera/camera_control.h"
#include "ui/session/look.h"
#include "ui/session/marks.h"
#include "ui/session/their_picture.h"

namespace zscope::ui {

struct LoadedScene {
    QString                              word;   // what opens it again: a path or builtin:...
    QString                              title;  // what a person calls it
    std::shared_ptr<const PreparedScene> prepared;
    NormalCube                           cube;
    std::uint64_t                        vertices = 0;  // of the meshes, instances not multiplied
    std::uint64_t                        polygons = 0;  // likewise

    const Scene& scene() const { return prepared->scene(); }
};

/// How the depths of a picture are spread, for the control of their range.
struct DepthSpread {
    static constexpr int kParts = 96;

    DepthRange                 whole;      // from its farthest to its nearest
    DepthRange                 used;       // what became the darkest and the lightest colour
    std::vector<std::uint64_t> histogram;  // of `whole`; empty: the layer is not that of depths
};

/// One finished frame at full speed.
struct DrawnFrame {
    std::uint64_t       generation = 0;
    Camera              camera;
    Pipeline            pipeline;
    Frame               frame;
    FrameReport         report;  // of the median of so many frames
    std::size_t         framesTimed = 1;
    Look                look;
    Grid<std::uint32_t> painted;  // the chosen layer; empty: the frame's own colours
    DepthSpread         spread;
    std::uint64_t       coveredPixels    = 0;
    std::uint64_t       visibleTriangles = 0;  // that own at least one pixel
    std::string         whyEmpty;              // one sentence of core; empty: the picture shows something
};

/// What is drawn over the picture, of what there is to draw.
struct Layers {
    bool line      = true;
    bool edges     = true;
    bool ghost     = true;  // what is still to come, pale
    bool triangle  = true;
    bool query     = true;   // what the pyramid was asked last, and the cell that was written last
    bool boxes     = false;  // of the hierarchy's nodes, by verdict
    bool pyramid   = false;  // the cells of the chosen level, with their values
    bool grid      = true;   // pixel grid and numbers in large pixels
    bool marks     = true;   // breakpoints
    bool magnifier = true;

    friend bool operator==(const Layers&, const Layers&) = default;
};

/// The state after one step, with its picture.
struct ShownStep {
    std::uint64_t          generation = 0;
    Camera                 camera;
    Pipeline               pipeline;
    StepState              state;
    std::vector<StageMark> stages;  // of the whole run, in steps of this grain
    Look                   look;
    Grid<std::uint32_t>    painted;  // the chosen layer; empty: the frame's own colours
    DepthSpread            spread;
    PyramidPicture         pyramid;       // no levels: the method keeps none, or none yet
    QImage                 ghosted;       // the step's picture, with what is still to come shown pale
    double                 replayMs = 0;  // what making it took

    std::uint64_t last() const { return state.count - 1; }
    bool          isLast() const { return state.step.value >= last(); }
};

/// A and B side by side: B is another way to draw the same view, or what another program drew.
struct Comparison {
    std::shared_ptr<const DrawnFrame> a, b;          // the finished pictures that were compared, or
    std::shared_ptr<const ShownStep>  stepA, stepB;  // those of two steps
    // of what another program drew, held against `a`: it has no figures, but pixels that count as equal
    std::shared_ptr<const TheirPicture> theirs;
    std::uint64_t                       rounding = 0;
    Difference                          difference;
    ErrorFigures                        figures;            // of B, with A as what is right, or the other way round
    bool                                isAJudged = false;  // the other way round: B claims to be exact, and A does not
    std::uint32_t                       tolerance = 0;
};

/// What is picked, selected and marked in a scene.
struct Selection {
    std::optional<QPoint>     picked;
    std::optional<NodeName>   node;
    std::optional<TriangleId> triangle;
    std::optional<int>        level;  // of the pyramid
    Marks                     marks;
};

enum class CompareShow { A, B, Wipe, Difference, Beside };
/// What of A's step B follows.
enum class Link { Number, Line, Stage, Pixel };
/// What the step of B has to do with that of A, where it is not plain.
struct LinkNote {
    enum class What {
        Nothing,
        PartOfRun,
        PartOfStage,
        NoLine,
        FirstOnLine,
        NeverOnLine,
        NoPixel,
        BackgroundInA,
        StillBackground,
        SameTriangle,
        NoChange,
        NeverShown
    };
    What what = What::Nothing;
    int  line = 0;
};
QString textOf(const LinkNote& note);  // translated; ui/session/linking.cpp

struct CompareState {
    std::optional<Pipeline>             other;   // B, or
    std::shared_ptr<const TheirPicture> theirs;  // B that another program drew. Neither: there is no comparison
    CompareShow                         show     = CompareShow::A;
    bool                                isHeld   = false;  // Shift is held: B is seen for as long
    bool                                isLinked = true;   // B is stepped with A
    Link                                link     = Link::Number;
    LinkNote                            linkNote;
    double                              wipe      = 0.5;  // of the picture's width: A to the left, B to the right
    std::uint32_t                       tolerance = 0;    // float32 steps
    std::shared_ptr<const DrawnFrame>   frame;            // of B; nullptr until one was drawn
    std::shared_ptr<const ShownStep>    step;             // of B
    std::shared_ptr<const Comparison>   result;           // nullptr until there is one

    bool        isOn() const { return other || theirs; }
    CompareShow seen() const { return !isOn() ? CompareShow::A : isHeld ? CompareShow::B : show; }
};

struct Snapshot {
    std::shared_ptr<const LoadedScene> scene;              // nullptr until one was loaded
    std::shared_ptr<const DrawnFrame>  frame;              // nullptr until one was drawn
    std::shared_ptr<const ShownStep>   step;               // nullptr until one was made
    bool                               showsStep = false;  // the picture is the step's, not the frame's
    Camera                             camera;             // the newest, perhaps not drawn yet
    ViewRequest                        view;               // what the camera was made from
    Pipeline                           pipeline;           // the chosen one, perhaps not drawn yet
    Look                               look;               // what the picture shows of each pixel
    Grain                              grain = Grain::Frame;
    std::optional<QPoint>              picked;
    std::optional<EdgeRow>             selectedEdge;
    std::optional<int>                 selectedLevel;  // of the pyramid; nothing: that of the last question or update
    std::optional<NodeName>            selectedNode;
    // goes before the picked pixel's, until another pixel is picked
    std::optional<TriangleId> selectedTriangle;
    VerdictSet                shownNodes = everyVerdict();  // whose boxes are shown, and rows in the tree
    Layers                    layers;
    CompareState              compare;
    Marks                     marks;
    QString                   busy;           // what the worker does; empty: nothing to wait for
    double                    progress = -1;  // in [0, 1], or -1: not known

    /// What another program drew, if it can lie over A's picture.
    const TheirPicture* theirsToShow() const
    {
        const TheirPicture* theirs = compare.theirs.get();
        if (!theirs || !frame || theirs->camera().width != frame->camera.width
            || theirs->camera().height != frame->camera.height)
            return nullptr;
        return theirs;
    }
    /// B's picture of the same moment as A's; nullptr while there is none.
    const VisibilityBuffer* visibleOfOther() const
    {
        if (const TheirPicture* theirs = theirsToShow()) return &theirs->frame->visible;
        if (!compare.other) return nullptr;
        if (showsStep && compare.isLinked) return compare.step ? &compare.step->state.frame.visible : nullptr;
        return compare.frame ? &compare.frame->frame.visible : nullptr;
    }
    const Grid<std::uint32_t>* coloursOfOther() const
    {
        if (const TheirPicture* theirs = theirsToShow()) return &theirs->painted;
        if (!compare.other) return nullptr;
        if (showsStep && compare.isLinked) {
            if (!compare.step) return nullptr;
            return compare.step->painted.width() > 0 ? &compare.step->painted : &compare.step->state.frame.colour;
        }
        if (!compare.frame) return nullptr;
        return compare.frame->painted.width() > 0 ? &compare.frame->painted : &compare.frame->frame.colour;
    }
    /// The visibility buffer of the picture on show; nullptr if there is none.
    const VisibilityBuffer* visible() const
    {
        if (compare.seen() == CompareShow::B)
            if (const VisibilityBuffer* other = visibleOfOther()) return other;
        if (showsStep && step) return &step->state.frame.visible;
        return frame ? &frame->frame.visible : nullptr;
    }
    /// What is on show: the shaded colours or the chosen layer; nullptr if there is no picture.
    const Grid<std::uint32_t>* colours() const
    {
        if (showsStep && step) return step->painted.width() > 0 ? &step->painted : &step->state.frame.colour;
        if (!frame) return nullptr;
        // Only a step counts tests: the last one is the finished picture, too.
        if (frame->look.layer->needsTests && step && step->generation == frame->generation && step->isLast()
            && step->look == frame->look)
            return &step->painted;
        return frame->painted.width() > 0 ? &frame->painted : &frame->frame.colour;
    }
    /// Of the picture on show; nullptr unless it shows depths.
    const DepthSpread* spread() const
    {
        const DepthSpread* of = showsStep && step ? &step->spread : frame ? &frame->spread : nullptr;
        return of && !of->histogram.empty() ? of : nullptr;
    }
    const Camera& pictureCamera() const
    {
        if (showsStep && step) return step->camera;
        return frame ? frame->camera : camera;
    }
    /// The step, if it belongs to the picture on show.
    const ShownStep* stepOfPicture() const
    {
        if (!step) return nullptr;
        return showsStep || (frame && frame->generation == step->generation) ? step.get() : nullptr;
    }
    const HierarchyState* hierarchy() const
    {
        const ShownStep* shown = stepOfPicture();
        return shown && shown->state.hierarchy ? &*shown->state.hierarchy : nullptr;
    }
    const SweepState* sweep() const
    {
        const ShownStep* shown = stepOfPicture();
        return shown && shown->state.sweep ? &*shown->state.sweep : nullptr;
    }
};

/// The level of the pyramid that is large and over the picture: the chosen one, else what the step is about; -1: there
/// is no pyramid.
int levelOnShow(const Snapshot& shown);
/// The node that holds the triangle at the picked pixel; nothing: there is none, or no hierarchy.
std::optional<NodeName> nodeOfPick(const Snapshot& shown);

enum class Change {
    Scene     = 1,
    Camera    = 2,
    Picture   = 4,   // another frame or step, or which of them is shown
    Pipeline  = 8,   // pipeline or grain
    Selection = 16,  // picked pixel, selected edge, level, node, triangle
    Busy      = 32,
    Layers    = 64,   // what is drawn over the picture, and which nodes
    Compare   = 128,  // B, what of it is seen, and the result
    Marks     = 256,  // bookmarks, breakpoints, what changes a pixel
};
Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

inline constexpr Changes kEverything{Change::Scene,    Change::Camera,    Change::Picture,
                                     Change::Pipeline, Change::Selection, Change::Busy,
                                     Change::Layers,   Change::Compare,   Change::Marks};

/// Whether the pixel lies where a wipe shows B.
bool isBeyondWipe(const Snapshot& shown, const QPoint& pixel);
/// B is of another scene or camera than those on show, so that it cannot be compared.
bool isStale(const Snapshot& shown);
/// What B is called: its algorithm, or the files that it was read from; empty: there is none.
QString nameOfOther(const CompareState& compare);
/// The same with B in the place of A, as while it is held.
Snapshot asOther(const Snapshot& shown);

/// What can be said of one pixel of the picture on show: beyond a wipe, of B's.
struct PixelFacts {
    QPoint                    pixel;
    std::optional<TriangleId> triangle;                   // nothing: background
    float                     depth = 0;                  // near/z
    double                    z     = 0;                  // view distance; 0 for background
    QString                   instance, group, material;  // names, empty where there is nothing to tell
    std::uint64_t             polygon = 0;                // of the mesh, as the file counts them from 0
    // of what another program drew: nothing of the above but the pixel and, if its ids are those of triangles, the
    // triangle
    std::optional<TheirPixel> theirs;
};
/// The id and the depth of a pixel that are written into it when it is large; empty: background.
QString                   numbersAt(const Snapshot& shown, const QPoint& pixel);
std::optional<PixelFacts> factsOf(const Snapshot& shown, const QPoint& pixel);

/// The triangle whose rows light up: the selected one, else that of the picked pixel.
std::optional<TriangleId> pickedTriangle(const Snapshot& shown);

}  // namespace zscope::ui
