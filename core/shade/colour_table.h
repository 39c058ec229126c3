// The colour of every triangle: flat shading by one directional light, the same from every eye.
//
// Shading    material (or instance) colour times 0.25 + 0.75 * w^1.5, w = 0.5 + 0.5 * cosine of normal and light, so
//            that the far side of an open surface is darker, not black, and no colour depends on the camera
// Colours    0xAARRGGBB, opaque, index = rank: [0] is the background
// Size       four bytes per triangle of the scene, made once and shared; above kMaxEntries triangles there is no
//            table and colours are computed run by run
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/large_pages.h"
#include "core/scene/scene.h"

namespace zscope {

inline constexpr std::uint32_t kBackgroundColour = 0xFFF3F5F8;

/// The shaded colour of one triangle.
std::uint32_t colourOf(const Scene& scene, InstanceId instance, std::uint32_t meshTriangle);

class ColourTable {
public:
    static constexpr std::uint64_t kMaxEntries = 16'000'000;

    explicit ColourTable(const Scene& scene);

    bool                 isComplete() const { return !m_colours.empty(); }
    const std::uint32_t* data() const { return m_colours.data(); }
    std::uint64_t        bytes() const { return m_colours.capacity() * sizeof(std::uint32_t); }

private:
    std::vector<std::uint32_t, LargePages<std::uint32_t>> m_colours;  // by rank, or empty
};

}  // namespace zscope
