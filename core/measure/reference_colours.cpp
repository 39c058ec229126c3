#include "core/measure/reference_colours.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <vector>

#include "core/measure/definition.h"
#include "core/shade/colour_table.h"

namespace zscope {

using namespace definition;

namespace {

struct Fragment {
    std::uint32_t pixel;  // y * width + x
    float         depth;
    std::uint32_t id;
};

/// All transparent fragments that the opaque picture does not hide, pixel by pixel, farthest first.
Result<std::vector<Fragment>> transparentFragments(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                                   const Picture& opaque, const Progress& progress)
{
    const View            view(camera, faceCulling);
    std::vector<Fragment> all;
    std::vector<Part>     parts;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        if (progress.cancelled()) return Error{Trouble::Cancelled, "the reference was cancelled"};
        const InstanceId instance{i};
        const Mesh&      mesh = scene.meshOf(instance);
        if (std::ranges::none_of(mesh.materials, [](const Material& m) { return m.opacity < 1; })) continue;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (!transparentPartsOf(scene, instance, t, view, parts)) continue;
            for (const Part& part : parts) {
                for (int y = part.box().y0; y <= part.box().y1; ++y) {
                    for (int x = part.box().x0; x <= part.box().x1; ++x) {
                        if (!part.covers(x, y)) continue;
                        const float depth = part.depth(x, y);
                        if (depth < view.farDepth || depth <= opaque.depth.at(x, y)) continue;
                        all.push_back(
                            {static_cast<std::uint32_t>(y * camera.width + x), depth, scene.firstTriangle[i] + t});
                    }
                }
            }
        }
    }
    std::ranges::sort(all, [](const Fragment& a, const Fragment& b) {
        if (a.pixel != b.pixel) return a.pixel < b.pixel;
        return a.depth != b.depth ? a.depth < b.depth : a.id > b.id;
    });
    return all;
}

/// The colour of a triangle.
std::uint32_t paint(const Scene& scene, std::uint32_t id)
{
    const InstanceId instance = scene.instanceOf(TriangleId{id});
    return colourOf(scene, instance, id - scene.firstTriangle[instance.value]);
}

/// What the fragment shader makes of it at pixel (x, y): docs/correctness.md, Shading.
std::uint32_t shaded(std::uint32_t colour, std::uint32_t id, int x, int y, int operations)
{
    if (operations == 0) return colour;
    std::uint32_t chain =
        (static_cast<std::uint32_t>(x) + (static_cast<std::uint32_t>(y) << 16)) ^ ((id + 1) * 0x9E3779B1u);
    for (int done = 0; done < operations; done += 5) {
        chain += chain << 10;
        chain ^= chain >> 6;
        chain += 0x7F4A7C15u;
    }
    return colour ^ chain >> 31;
}

float opacityOf(const Scene& scene, std::uint32_t id)
{
    const InstanceId instance = scene.instanceOf(TriangleId{id});
    const Mesh&      mesh     = scene.meshOf(instance);
    return mesh.materialOf(mesh.trianglePolygon[id - scene.firstTriangle[instance.value]]).opacity;
}

/// `over` laid on the three channels, 0 to 255 each.
void lay(std::uint32_t over, float opacity, std::array<float, 3>& channels)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const auto source = static_cast<float>(over >> (16 - 8 * i) & 0xFFu);
        channels[i]       = channels[i] + (source - channels[i]) * opacity;
    }
}

}  // namespace

Result<Grid<std::uint32_t>> referenceColours(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                             const Picture& opaque, ShadingCost cost, const Progress& progress)
try {
    Grid<std::uint32_t> colours(camera.width, camera.height, kBackgroundColour);
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            if (opaque.ids.at(x, y) < 0) continue;
            const auto id    = static_cast<std::uint32_t>(opaque.ids.at(x, y));
            colours.at(x, y) = shaded(paint(scene, id), id, x, y, operationsOf(cost));
        }
    }

    const auto fragments = transparentFragments(scene, camera, faceCulling, opaque, progress);
    if (!fragments) return fragments.error();
    for (std::size_t i = 0; i < fragments->size();) {
        const std::uint32_t  pixel = (*fragments)[i].pixel;
        std::array<float, 3> channels{};
        lay(colours.values()[pixel], 1, channels);
        for (; i < fragments->size() && (*fragments)[i].pixel == pixel; ++i)
            lay(paint(scene, (*fragments)[i].id), opacityOf(scene, (*fragments)[i].id), channels);
        std::uint32_t packed = 0xFF;
        for (const float channel : channels) packed = packed << 8 | static_cast<std::uint32_t>(channel + 0.5f);
        colours.values()[pixel] = packed;
    }
    return colours;
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "the reference colours do not fit into memory"};
}

ColourFigures compareColours(const Grid<std::uint32_t>& reference, const Grid<std::uint32_t>& test)
{
    ColourFigures figures;
    for (std::size_t i = 0; i < reference.values().size(); ++i) {
        const std::uint32_t a = reference.values()[i], b = test.values()[i];
        if (a == b) continue;
        ++figures.wrong;
        for (const int shift : {0, 8, 16})
            figures.maxChannel = std::max(figures.maxChannel, std::abs(static_cast<int>(a >> shift & 0xFFu)
                                                                       - static_cast<int>(b >> shift & 0xFFu)));
    }
    return figures;
}

}  // namespace zscope
