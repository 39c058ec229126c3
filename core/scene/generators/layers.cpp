// builtin:layers: quads one behind the other, each covering the whole picture of the default view: over-render at its
// plainest. Loaded from the front, only the first is ever seen; from the back, every one is drawn over by the next.

#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"

namespace zscope::generated {

namespace {

Result<Scene> make(const Arguments& arguments)
{
    const std::int64_t count     = arguments.whole("count");
    const bool         frontLast = arguments.word("order") == "back";
    const double       layers    = static_cast<double>(count);
    const double       bytes     = meshBytes(4 * layers, layers, 4 * layers, 2 * layers);
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("so many layers", bytes, arguments.memoryLimit);

    auto quads       = std::make_shared<Mesh>();
    quads->name      = "layers";
    quads->materials = {};
    for (std::uint64_t i = 0; i < 35; ++i)  // every colour of the series
        quads->materials.push_back({"layer colour " + std::to_string(i), palette::colourOf(i), 1});
    for (std::int64_t i = 0; i < count; ++i) {
        // Between 10 and 20 in front of the eye; wide enough for a picture four times as wide as high.
        const std::int64_t place    = frontLast ? count - 1 - i : i;
        const double       distance = 10 + 10 * (static_cast<double>(place) / layers);
        const double       half     = 2 * distance;
        const auto         first    = static_cast<std::uint32_t>(quads->positions.size());
        for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
            quads->positions.push_back({x, y, -distance});
        quads->addPolygon(std::array{first, first + 1, first + 2, first + 3},
                          MaterialId{static_cast<std::uint32_t>(place % 35)});
    }

    Scene scene;
    scene.meshes.push_back(quads);
    scene.instances.push_back({MeshId{0}, Affine{}});
    ViewRequest view;
    view.eye    = dvec3{0, 0, 0};
    view.target = dvec3{0, 0, -1};
    view.near   = 1;
    view.far    = 100;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> layers()
{
    return {{"layers",
             "Quads that cover the picture, one behind the other",
             {{"count", WholeNumber{100, 1, 1'000'000}}, {"order", OneOf{{"front", "back"}}}},
             make}};
}

}  // namespace zscope::generated
