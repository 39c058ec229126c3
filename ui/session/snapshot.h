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

#include <QFlags>
#include <QImage>
#include <QPoint>
#include <QString>

#include "core/lesson/layers.h"
#include "core/lesson/node_boxes.h"
#include "core/lesson/observer.h"
#include "core/lesson/pyramid_levels.h"
#include "core/lesson/replay.h"
#include "core/scene/load.h"
#include "ui/camera/camera_control.h"

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

/// One finished frame at full speed.
struct DrawnFrame {
    std::uint64_t generation = 0;
    Camera        camera;
    Pipeline      pipeline;
    Frame         frame;
    FrameReport   report;
    Grid<std::uint32_t> painted;  // the chosen layer; empty: the frame's own colours
    std::uint64_t coveredPixels    = 0;
    std::uint64_t visibleTriangles = 0;  // that own at least one pixel
};

/// What is drawn over the picture, of what there is to draw.
struct Layers {
    bool line     = true;
    bool edges    = true;
    bool ghost    = true;  // what is still to come, pale
    bool triangle = true;
    bool query    = true;  // what the pyramid was asked last, and the cell that was written last
    bool boxes    = false; // of the hierarchy's nodes, by verdict
    bool pyramid  = false; // the cells of the chosen level, with their values
    bool grid     = true;  // pixel grid and numbers in large pixels
    bool magnifier = true;

    friend bool operator==(const Layers&, const Layers&) = default;
};

/// The state after one step, with its picture.
struct ShownStep {
    std::uint64_t generation = 0;
    Camera        camera;
    Pipeline      pipeline;
    StepState     state;
    Grid<std::uint32_t> painted;  // the chosen layer; empty: the frame's own colours
    PyramidPicture pyramid;     // no levels: the method keeps none, or none yet
    QImage        ghosted;      // the step's picture, with what is still to come shown pale
    double        replayMs = 0; // what making it took

    std::uint64_t last() const { return state.count - 1; }
    bool          isLast() const { return state.step.value >= last(); }
};

struct Snapshot {
    std::shared_ptr<const LoadedScene> scene;      // nullptr until one was loaded
    std::shared_ptr<const DrawnFrame>  frame;      // nullptr until one was drawn
    std::shared_ptr<const ShownStep>   step;       // nullptr until one was made
    bool                               showsStep = false;  // the picture is the step's, not the frame's
    Camera                             camera;     // the newest, perhaps not drawn yet
    ViewRequest                        view;       // what the camera was made from
    Pipeline                           pipeline;   // the chosen one, perhaps not drawn yet
    const Layer*                       layer = &zscope::layers().front();  // what the picture shows of each pixel
    Grain                              grain = Grain::Frame;
    std::optional<QPoint>              picked;
    std::optional<EdgeRow>             selectedEdge;
    std::optional<int>                 selectedLevel;  // of the pyramid; nothing: that of the last question or update
    std::optional<NodeName>            selectedNode;
    VerdictSet                         shownNodes = everyVerdict();  // whose boxes are shown, and rows in the tree
    Layers                             layers;
    QString                            busy;       // what the worker does; empty: nothing to wait for
    double                             progress = -1;  // in [0, 1], or -1: not known

    /// The visibility buffer of the picture on show; nullptr if there is none.
    const VisibilityBuffer* visible() const
    {
        if (showsStep && step) return &step->state.frame.visible;
        return frame ? &frame->frame.visible : nullptr;
    }
    /// What is on show: the shaded colours or the chosen layer; nullptr if there is no picture.
    const Grid<std::uint32_t>* colours() const
    {
        if (showsStep && step) return step->painted.width() > 0 ? &step->painted : &step->state.frame.colour;
        if (!frame) return nullptr;
        return frame->painted.width() > 0 ? &frame->painted : &frame->frame.colour;
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

/// The level of the pyramid that is large and over the picture: the chosen one, else what the step is about; -1: there is
/// no pyramid.
int levelOnShow(const Snapshot& shown);
/// The node that holds the triangle at the picked pixel; nothing: there is none, or no hierarchy.
std::optional<NodeName> nodeOfPick(const Snapshot& shown);

enum class Change {
    Scene     = 1,
    Camera    = 2,
    Picture   = 4,   // another frame or step, or which of them is shown
    Pipeline  = 8,   // pipeline or grain
    Selection = 16,  // picked pixel, selected edge, level, node
    Busy      = 32,
    Layers    = 64,  // what is drawn over the picture, and which nodes
};
Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

inline constexpr Changes kEverything{Change::Scene, Change::Camera, Change::Picture,
                                     Change::Pipeline, Change::Selection, Change::Busy, Change::Layers};

/// What can be said of one pixel of the picture on show.
struct PixelFacts {
    QPoint                    pixel;
    std::optional<TriangleId> triangle;   // nothing: background
    float                     depth = 0;  // near/z
    double                    z     = 0;  // view distance; 0 for background
    QString                   instance, group, material;  // names, empty where there is nothing to tell
    std::uint64_t             polygon = 0;  // of the mesh, as the file counts them from 0
};
std::optional<PixelFacts> factsOf(const Snapshot& shown, const QPoint& pixel);

/// The triangle of the picked pixel, whose rows light up.
std::optional<TriangleId> pickedTriangle(const Snapshot& shown);

}  // namespace zscope::ui
