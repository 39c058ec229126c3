// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn over the picture: the current line, the active edges, the triangle and pixel of the step, the pick.
// overlayOf() decides what, in picture coordinates and without a widget; paintOverlay() only draws it.
//
// Picture    x to the right, y downwards, pixel (x, y) is the square [x, x+1) x [y, y+1)
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include <QLineF>
#include <QPolygonF>
#include <QRect>

#include "ui/session/snapshot.h"
#include "ui/theme/theme.h"
#include "ui/view/view_transform.h"

class QPainter;

namespace zscope::ui {

enum class EdgeKind { Active, Entered, Left, Picked, Selected };

struct OverlayEdge {
    QLineF   segment;
    EdgeKind kind = EdgeKind::Active;
};

struct OverlayBox {
    std::vector<QLineF> lines;  // of a box, or of several that look the same
    NodeVerdict         verdict                   = NodeVerdict::Waiting;
    enum class Kind { Plain, Now, Selected } kind = Kind::Plain;
};

/// Breakpoints that have a place in the picture.
struct OverlayMarks {
    std::vector<int>                 lines;
    std::vector<QPoint>              pixels;
    std::vector<std::vector<QLineF>> outlines;  // of triangles, and of nodes that the visit has come to know

    bool isEmpty() const { return lines.empty() && pixels.empty() && outlines.empty(); }
};

struct Overlay {
    // of the hierarchy, the upper ones; beyond that the picture would be nothing else
    static constexpr std::size_t kMostBoxes = 400;

    QSize                    picture;
    std::optional<int>       line;
    std::vector<OverlayEdge> edges;  // what matters most comes last
    std::optional<QPolygonF> triangle;
    std::optional<QRect>     span;   // the last run of pixels, one line high
    std::optional<QPoint>    pixel;  // of the step
    std::optional<QPoint>    pick;

    // of the nodes: one entry per verdict, then the one of this step, the selected one last
    std::vector<OverlayBox> boxes;
    std::size_t             boxesShown = 0, boxesWanted = 0;

    OverlayMarks marks;

    // Of the pyramid. The levels outlive the overlay: both are of one step
    std::shared_ptr<const ShownStep> step;             // holds the level
    const PyramidLevel*              cells = nullptr;  // whose grid and values are over the picture
    float                            empty = 0;        // what background holds
    std::optional<QRect>             asked;            // what the pyramid was asked about
    std::optional<QRect>             written;          // the cell that was written last, in pixels
};

Overlay overlayOf(const Snapshot& shown, const Layers& layers);

/// A depth in a cell so narrow that few digits fit: ".4201", or a dash for background.
QString cellText(float value, float empty);

/// The part of an edge inside the picture; nothing if it misses it. The row's x belongs to the centre of line y.
std::optional<QLineF> segmentOf(const EdgeRow& edge, int y, const QSize& picture);

/// `scale` is device pixels per logical pixel: lines keep their width on any screen.
void paintOverlay(QPainter& painter, const Overlay& overlay, const ViewTransform& view, const Theme& theme,
                  double scale);

/// Whether two rows are the same edge, seen from different lines.
bool isSameEdge(const EdgeRow& a, const EdgeRow& b);

/// Edges by their names, for lines that thousands of them cross.
class EdgeNames {
public:
    explicit EdgeNames(std::span<const EdgeRow> edges);
    bool holds(const EdgeRow& edge) const;

private:
    using Name = std::tuple<std::uint32_t, std::int64_t, std::int64_t, int, int>;
    static Name nameOf(const EdgeRow& edge)
    {
        return {edge.polygon.value, edge.dx[0], edge.dx[1], edge.firstLine, edge.lastLine};
    }

    std::vector<Name> m_names;  // ascending
};

}  // namespace zscope::ui
