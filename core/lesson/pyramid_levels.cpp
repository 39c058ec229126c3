#include "core/lesson/pyramid_levels.h"

#include <algorithm>

#include "core/lesson/colour_maps.h"

namespace zscope {
namespace {

void findLagging(PyramidLevel& level, const Grid<float>& truth)
{
    level.lags.reset(level.width(), level.height(), 0);
    for (std::size_t i = 0; i < level.farthest.values().size(); ++i) {
        const bool lags        = level.farthest.values()[i] < truth.values()[i];
        level.lags.values()[i] = lags;
        level.lagging += lags;
    }
}

void colour(PyramidLevel& level, const PyramidPicture& picture)
{
    const auto far = static_cast<double>(picture.farthest), extent = static_cast<double>(picture.nearest) - far;
    level.colours.reset(level.width(), level.height(), kEmptyCell);
    for (std::size_t i = 0; i < level.farthest.values().size(); ++i) {
        const float value = level.farthest.values()[i];
        if (value <= picture.empty) continue;
        level.colours.values()[i] = cividis(extent > 0 ? 0.12 + 0.88 * (static_cast<double>(value) - far) / extent : 1);
    }
}

}  // namespace

Grid<float> farthestOfFour(const Grid<float>& below)
{
    Grid<float> above((below.width() + 1) / 2, (below.height() + 1) / 2);
    for (int y = 0; y < above.height(); ++y) {
        for (int x = 0; x < above.width(); ++x) {
            float value = below.at(2 * x, 2 * y);
            if (2 * x + 1 < below.width()) value = std::min(value, below.at(2 * x + 1, 2 * y));
            if (2 * y + 1 < below.height()) value = std::min(value, below.at(2 * x, 2 * y + 1));
            if (2 * x + 1 < below.width() && 2 * y + 1 < below.height())
                value = std::min(value, below.at(2 * x + 1, 2 * y + 1));
            above.at(x, y) = value;
        }
    }
    return above;
}

Grid<float> storedDepths(const VisibilityBuffer& visible)
{
    Grid<float> depths(visible.width(), visible.height());
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x) depths.at(x, y) = visible.storedAt(x, y);
    return depths;
}

PyramidPicture pyramidOf(const StepState& state)
{
    PyramidPicture picture;
    if (!state.hierarchy || state.hierarchy->cells.empty()) return picture;
    const VisibilityBuffer& visible = state.frame.visible;
    const auto&             cells   = state.hierarchy->cells;
    picture.empty                   = visible.empty();

    Grid<float> pixels = storedDepths(visible);
    bool        any    = false;
    for (const float depth : pixels.values()) {
        if (depth <= picture.empty) continue;
        picture.farthest = any ? std::min(picture.farthest, depth) : depth;
        picture.nearest  = any ? std::max(picture.nearest, depth) : depth;
        any              = true;
    }

    Grid<float> truth = std::move(pixels);
    for (int level = 0; level < Pyramid::kTileLevel + static_cast<int>(cells.size()); ++level) {
        if (level > 0) truth = farthestOfFour(truth);
        PyramidLevel& made = picture.levels.emplace_back();
        made.level         = level;
        made.isStored      = level >= Pyramid::kTileLevel;
        made.farthest      = made.isStored ? cells[static_cast<std::size_t>(level - Pyramid::kTileLevel)] : truth;
        if (made.isStored) findLagging(made, truth);
        colour(made, picture);
    }
    return picture;
}

PixelBox cellsUnder(const PixelBox& pixels, int level)
{
    return {pixels.x0 >> level, pixels.y0 >> level, ((pixels.x1 - 1) >> level) + 1, ((pixels.y1 - 1) >> level) + 1};
}

}  // namespace zscope
