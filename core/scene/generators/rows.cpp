// builtin:rows: one model in rows behind rows, as dense as it can stand without touching: what is in front hides almost
// all that is behind it.
//
// Memory     one mesh and about 130 bytes per instance

#include <algorithm>

#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"

namespace zscope::generated {

namespace {

Result<Scene> make(const Arguments& arguments)
{
    const std::int64_t nx = arguments.whole("nx"), ny = arguments.whole("ny"), nz = arguments.whole("nz");
    const double       count = static_cast<double>(nx) * static_cast<double>(ny) * static_cast<double>(nz);
    const double       bytes = count * (sizeof(Instance) + sizeof(std::uint32_t));
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("so many rows", bytes, arguments.memoryLimit);
    const Result<Scene> model = generate(arguments.word("model"), arguments.memoryLimit, arguments.progress);
    if (!model) return model.error();

    Scene scene;
    scene.meshes        = {model->meshes[0]};
    const Bounds bounds = model->meshes[0]->bounds();
    const dvec3  size = bounds.max - bounds.min, middle = 0.5 * (bounds.min + bounds.max);
    const dvec3  step = 1.05 * size;
    scene.instances.reserve(static_cast<std::size_t>(nx * ny * nz));
    std::uint64_t number = 0;
    for (std::int64_t z = nz - 1; z >= 0; --z)  // the farthest row first: the order as submitted is the worst
        for (std::int64_t y = 0; y < ny; ++y)
            for (std::int64_t x = 0; x < nx; ++x) {
                const dvec3 at{step.x * (static_cast<double>(x) - 0.5 * static_cast<double>(nx - 1)),
                               step.y * (static_cast<double>(y) - 0.5 * static_cast<double>(ny - 1)),
                               -step.z * static_cast<double>(z)};
                scene.instances.push_back({MeshId{0}, Affine::translation(at - middle), palette::colourOf(number++)});
            }
    if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the rows were not wanted any more"};

    // Before the first row, so near that it fills the picture, and a little aside, so that no gap is seen through.
    const double wide = step.x * static_cast<double>(nx), high = step.y * static_cast<double>(ny);
    const double away = std::min(0.6 * wide, 1.05 * high);
    ViewRequest  view;
    view.eye    = dvec3{0.13 * wide, 0.11 * high, away + size.z};
    view.target = dvec3{0, 0, 0};
    view.near   = 0.01 * away;
    view.far    = 4 * (away + step.z * static_cast<double>(nz));
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> rows()
{
    return {{"rows",
             "One model in rows behind rows",
             {{"model", OneOf{{"soccer-ball", "teapot", "cube"}}},
              {"nx", WholeNumber{10, 1, 1000}},
              {"ny", WholeNumber{5, 1, 1000}},
              {"nz", WholeNumber{20, 1, 1000}}},
             make}};
}

}  // namespace zscope::generated
