// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/label_places.h"

#include <algorithm>

namespace zscope::ui {
namespace {

constexpr int    kRows = 5;
constexpr double kGap  = 3;  // pixels between a mark and its name

/// Every place that the name of a point may take, the best first.
std::vector<LabelPlace> candidates(const QPointF& point, const QSizeF& size, double radius)
{
    const double            away = radius + kGap;
    std::vector<LabelPlace> all;
    const auto              add = [&](double left, double middle, bool isFar) {
        all.push_back({QRectF(QPointF(left, middle - size.height() / 2), size), isFar});
    };
    add(point.x() + away, point.y(), false);
    add(point.x() - away - size.width(), point.y(), false);
    for (int row = 1; row <= kRows; ++row) {
        for (const int side : {-1, 1}) {
            const double middle = point.y() + side * (radius + size.height() * (row - 0.4));
            for (const double part : {0.0, 0.5, 1.0}) add(point.x() - part * size.width(), middle, row > 1);
        }
    }
    return all;
}

}  // namespace

std::vector<std::optional<LabelPlace>> placeLabels(const std::vector<QPointF>& points, const std::vector<QSizeF>& sizes,
                                                   const std::vector<std::size_t>& order,
                                                   const std::vector<QRectF>& areas, double markRadius)
{
    std::vector<QRectF> taken;
    for (const QPointF& point : points)
        taken.emplace_back(point.x() - markRadius, point.y() - markRadius, 2 * markRadius, 2 * markRadius);
    std::vector<std::optional<LabelPlace>> places(points.size());
    for (const std::size_t i : order) {
        for (const LabelPlace& place : candidates(points[i], sizes[i], markRadius)) {
            if (!areas[i].contains(place.rect)) continue;
            if (std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(place.rect); })) continue;
            taken.push_back(place.rect);
            places[i] = place;
            break;
        }
    }
    return places;
}

}  // namespace zscope::ui
