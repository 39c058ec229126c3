// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn over the picture: the current line, the active edges, the triangle and pixel of the step, the pick.
// overlayOf() decides what, in picture coordinates and without a widget; paintOverlay() only draws it.
//
// Picture    x to the right, y downwards, pixel (x, y) is the square [x, x+1) x [y, y+1)
#pragma once

#include <optional>
#include <vector>

#include <QLineF>
#include <QPolygonF>
#include <QRect>

#include "ui/session/snapshot.h"
#include "ui/theme/theme.h"
#include "ui/view/view_transform.h"

class QPainter;

namespace zscope::ui {

/// What of it the user wants to see.
struct Layers {
    bool line     = true;
    bool edges    = true;
    bool ghost    = true;  // what is still to come, pale
    bool triangle = true;
    bool grid     = true;  // pixel grid and numbers in large pixels
    bool magnifier = true;

    friend bool operator==(const Layers&, const Layers&) = default;
};

enum class EdgeKind { Active, Entered, Left, Picked, Selected };

struct OverlayEdge {
    QLineF   segment;
    EdgeKind kind = EdgeKind::Active;
};

struct Overlay {
    QSize                    picture;
    std::optional<int>       line;
    std::vector<OverlayEdge> edges;      // what matters most comes last
    std::optional<QPolygonF> triangle;
    std::optional<QRect>     span;       // the last run of pixels, one line high
    std::optional<QPoint>    pixel;      // of the step
    std::optional<QPoint>    pick;
};

Overlay overlayOf(const Snapshot& shown, const Layers& layers);

/// The part of an edge inside the picture; nothing if it misses it. The row's x belongs to the centre of line y.
std::optional<QLineF> segmentOf(const EdgeRow& edge, int y, const QSize& picture);

/// `scale` is device pixels per logical pixel: lines keep their width on any screen.
void paintOverlay(QPainter& painter, const Overlay& overlay, const ViewTransform& view, const Theme& theme,
                  double scale);

/// Whether two rows are the same edge, seen from different lines.
bool isSameEdge(const EdgeRow& a, const EdgeRow& b);

}  // namespace zscope::ui
