// builtin:million: one mesh of a million triangles, waving sheets one behind the other, each of which fills the
// picture: with the usual sixteen sheets at least sixteen triangles lie behind one another at every pixel.
//
// Faces      `sheets` sheets of 2 r x r cells, two triangles each, with r the largest that keeps within `faces`; a
//            million is met
// Order      the sheets follow one another in seeded disorder, so that the order as submitted neither helps nor harms

#include <array>
#include <cmath>
#include <utility>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/random.h"
#include "core/scene/generators/registry.h"

namespace zscope::generated {

namespace {

/// Three waves across a sheet, together between -highest and highest.
class Waves {
public:
    Waves(Random& random, double highest) : m_amplitude(highest / 3)
    {
        for (Wave& wave : m_waves) wave = {random.between(-0.35, 0.35), random.between(-0.35, 0.35), random.unit()};
    }
    double at(double x, double y) const
    {
        double height = 0;
        for (const Wave& wave : m_waves)
            height += m_amplitude * pointOnCircle(wave.perX * x + wave.perY * y + wave.start)[1];
        return height;
    }

private:
    struct Wave {
        double perX, perY, start;  // in turns
    };
    std::array<Wave, 3> m_waves;
    double              m_amplitude;
};

Result<Scene> make(const Arguments& arguments)
{
    const double faces = static_cast<double>(arguments.whole("faces"));
    const double bytes = meshBytes(0.6 * faces, faces, 3 * faces, faces);
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("so many faces", bytes, arguments.memoryLimit);
    const auto sheetCount = static_cast<std::uint32_t>(arguments.whole("sheets"));
    const auto rows       = static_cast<std::uint32_t>(std::sqrt(faces / (4.0 * sheetCount)));
    const auto columns    = 2 * rows;

    Random                     random(static_cast<std::uint64_t>(arguments.whole("seed")));
    std::vector<std::uint32_t> order(sheetCount);
    for (std::uint32_t i = 0; i < sheetCount; ++i) order[i] = i;
    for (std::uint32_t i = sheetCount - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);

    auto sheets  = std::make_shared<Mesh>();
    sheets->name = "million";
    sheets->materials.clear();
    for (std::uint32_t i = 0; i < sheetCount; ++i)
        sheets->materials.push_back({"sheet " + std::to_string(i), palette::colourOf(i)});
    for (std::uint32_t made = 0; made < sheetCount; ++made) {
        const std::uint32_t sheet    = order[made];
        const double        distance = 10 + 4.0 * sheet;  // its waves stay clear of the next one's
        const double        halfX = 1.0 * distance, halfY = 0.55 * distance;
        const Waves         waves(random, arguments.real("height"));
        const auto          first = static_cast<std::uint32_t>(sheets->positions.size());
        for (std::uint32_t j = 0; j <= rows; ++j)
            for (std::uint32_t i = 0; i <= columns; ++i) {
                const double x = halfX * (2.0 * i / columns - 1), y = halfY * (2.0 * j / rows - 1);
                sheets->positions.push_back({x, y, waves.at(x, y) - distance});
            }
        const auto at = [&](std::uint32_t i, std::uint32_t j) { return first + j * (columns + 1) + i; };
        for (std::uint32_t j = 0; j < rows; ++j)
            for (std::uint32_t i = 0; i < columns; ++i) {
                sheets->addPolygon(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, MaterialId{sheet});
                sheets->addPolygon(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)}, MaterialId{sheet});
            }
        arguments.progress.at((made + 1.0) / sheetCount, "sheets");
        if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the sheets were not wanted any more"};
    }

    Scene scene;
    scene.meshes.push_back(sheets);
    scene.instances.push_back({MeshId{0}, Affine{}});
    ViewRequest view;
    view.eye    = dvec3{0, 0, 0};
    view.target = dvec3{0, 0, -1};
    view.near   = 1;
    view.far    = 200;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> million()
{
    return {{"million",
             "One mesh of a million faces in waving sheets, sixteen deep at every pixel",
             {{"faces", WholeNumber{1'000'000, 1000, 50'000'000}},
              {"seed", WholeNumber{1, 0, 1'000'000'000}},
              {"sheets", WholeNumber{16, 1, 64}},
              {"height", RealNumber{1.5, 0, 1.5}}},
             make}};
}

}  // namespace zscope::generated
