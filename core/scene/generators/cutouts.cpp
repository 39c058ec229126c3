// builtin:cutouts: sheets with holes one behind the other, so that a fragment that is nearest may not exist. A fence of
// stripes and a net of holes stand before a solid wall and through each other; a floor of checkers passes under the
// eye, so that it is cut at the near plane; a box with holes is placed askew.
//
// Size       `size` is the cell of the patterns; the sheets are 8 wide. Small cells are below a pixel and alias

#include <array>
#include <optional>

#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"
#include "core/scene/generators/sheets.h"

namespace zscope::generated {

namespace {

MaterialId addMaterial(Mesh& mesh, std::uint64_t colour, std::optional<Cutout> cutout)
{
    mesh.materials.push_back({.name    = "cut-out " + std::to_string(mesh.materials.size()),
                              .diffuse = palette::colourOf(colour),
                              .cutout  = cutout});
    return MaterialId{static_cast<std::uint32_t>(mesh.materials.size() - 1)};
}

Result<Scene> make(const Arguments& arguments)
{
    const double size   = arguments.real("size");
    auto         sheets = std::make_shared<Mesh>();
    auto         box    = std::make_shared<Mesh>();
    sheets->name        = "sheets";
    box->name           = "box";
    sheets->materials = box->materials = {};

    const MaterialId solid  = addMaterial(*sheets, 0, std::nullopt);
    const MaterialId net    = addMaterial(*sheets, 5, Cutout{CutoutPattern::Holes, size});
    const MaterialId fence  = addMaterial(*sheets, 9, Cutout{CutoutPattern::Stripes, size});
    const MaterialId checks = addMaterial(*sheets, 14, Cutout{CutoutPattern::Checker, 2 * size});
    addQuad(*sheets, {{{-4, -1, -6}, {4, -1, -6}, {4, 5, -6}, {-4, 5, -6}}}, solid);
    addQuad(*sheets, {{{-4, -1, -3}, {4, -1, -4}, {4, 3, -4}, {-4, 3, -3}}}, net);
    addQuad(*sheets, {{{-4, -1, -4}, {4, -1, -3}, {4, 3, -3}, {-4, 3, -4}}}, fence);
    addQuad(*sheets, {{{-4, -1, 6}, {4, -1, 6}, {4, -1, -6}, {-4, -1, -6}}}, checks);
    addQuad(*sheets, {{{-4, -1.5, 6}, {4, -1.5, 6}, {4, -1.5, -6}, {-4, -1.5, -6}}}, solid);
    addBox(*box, addMaterial(*box, 20, Cutout{CutoutPattern::Holes, size}));

    Affine askew;  // turned about y by atan(3/4), half as large, to the right of the view
    askew.rows = {{{0.4, 0, 0.3, 1.2}, {0, 0.5, 0, -0.3}, {-0.3, 0, 0.4, -1.5}}};
    Scene scene;
    scene.meshes = {sheets, box};
    scene.instances.push_back({MeshId{0}, Affine{}});
    scene.instances.push_back({MeshId{1}, askew});
    ViewRequest view;
    view.eye    = dvec3{0, 0.5, 2};
    view.target = dvec3{0, 0.25, -1};
    view.near   = 0.5;
    view.far    = 100;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> cutouts()
{
    return {{"cutouts",
             "Sheets with holes, through each other and before a wall",
             {{"size", RealNumber{0.5, 1e-3, 100}}},
             make}};
}

}  // namespace zscope::generated
