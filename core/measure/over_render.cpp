#include "core/measure/over_render.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace zscope {

namespace {

std::uint64_t counted(const FrameWork& work, std::string_view name)
{
    const auto found = std::ranges::find(work.counters, name, &NamedCount::name);
    return found == work.counters.end() ? 0 : found->value;
}

}  // namespace

OverRender overRenderOf(const FrameWork& work, const VisibilityBuffer& visible)
{
    OverRender figures;
    figures.trianglesRasterised = counted(work, "triangles_drawn") + counted(work, "prepass_triangles_drawn");
    figures.fragmentsTested     = counted(work, "pixels_tested") + counted(work, "prepass_pixels_tested");

    std::vector<std::uint32_t> ranks;  // of covered pixels, then each once
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (const std::uint32_t rank = visible.rankAt(x, y); rank != 0) ranks.push_back(rank);
    figures.pixelsCovered = ranks.size();
    std::ranges::sort(ranks);
    figures.trianglesVisible = static_cast<std::uint64_t>(std::unique(ranks.begin(), ranks.end()) - ranks.begin());
    return figures;
}

}  // namespace zscope
