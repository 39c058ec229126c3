// SPDX-License-Identifier: GPL-3.0-or-later
// Where the names of points go so that they cover neither each other, nor a
// point, nor the edge of the chart. No widgets.
//
// Order      names are placed in the order given: whoever matters most goes first. One that finds no place has none
// Places     right of the point, left of it, then rows above and below, up to kRows of them; a name that stands more
//            than a row away wants a line to its point
// Cost       names times places times names: meant for some dozens
#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace zscope::ui {

struct LabelPlace {
    QRectF rect;
    bool   isFar = false;  // wants a line to its point
};

/// `points`, `sizes` and `areas` are in pixels, of one length; `order` holds indices of those to be named. A name's
/// place is inside its point's area.
std::vector<std::optional<LabelPlace>> placeLabels(const std::vector<QPointF>& points, const std::vector<QSizeF>& sizes,
                                                   const std::vector<std::size_t>& order,
                                                   const std::vector<QRectF>& areas, double markRadius);

}  // namespace zscope::ui
