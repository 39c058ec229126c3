// builtin:reliefs: surfaces whose fragments lie farther than their triangles say, so that what is nearest is known only
// when a fragment has been looked at. Behind the faces of a brick wall and of a floor with bowls, nearer than their
// deepest fragments, stand solid sheets, that of the wall in pieces of which some lie wholly behind bricks; louvres
// cross the wall; the floor passes under the eye, so that it is cut at the near plane; a box with both holes and
// louvres is placed askew; a pane of glass stands in the joints.
//
// Size       `size` is the cell of the patterns, `depth` how far back they reach; the sheets are 8 wide

#include <array>
#include <optional>

#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"
#include "core/scene/generators/sheets.h"

namespace zscope::generated {

namespace {

MaterialId addMaterial(Mesh& mesh, const std::string& name, std::uint64_t colour, std::optional<Relief> relief,
                       std::optional<Cutout> cutout = {})
{
    mesh.materials.push_back({.name = name, .diffuse = palette::colourOf(colour), .cutout = cutout, .relief = relief});
    return MaterialId{static_cast<std::uint32_t>(mesh.materials.size() - 1)};
}

Result<Scene> make(const Arguments& arguments)
{
    const double size = arguments.real("size"), depth = arguments.real("depth");
    auto         sheets = std::make_shared<Mesh>();
    auto         box    = std::make_shared<Mesh>();
    sheets->name        = "sheets";
    box->name           = "box";
    sheets->materials = box->materials = {};

    const MaterialId solid   = addMaterial(*sheets, "solid", 0, std::nullopt);
    const MaterialId mortar  = addMaterial(*sheets, "mortar", 7, std::nullopt);
    const MaterialId bricks  = addMaterial(*sheets, "bricks", 5, Relief{ReliefPattern::Bricks, size, depth});
    const MaterialId louvres = addMaterial(*sheets, "louvres", 9, Relief{ReliefPattern::Louvres, size, depth});
    const MaterialId bowls   = addMaterial(*sheets, "bowls", 14, Relief{ReliefPattern::Bowls, 2 * size, depth});
    const MaterialId pane    = addMaterial(*sheets, "glass", 11, std::nullopt);
    sheets->materials[pane.value].opacity = 0.4f;

    const double half = depth / 2;
    addQuad(*sheets, {{{-4, -1, -6}, {4, -1, -6}, {4, 5, -6}, {-4, 5, -6}}}, solid);
    addQuad(*sheets, {{{-4, -1, -3}, {4, -1, -4}, {4, 3, -4}, {-4, 3, -3}}}, bricks);
    addQuadInPieces(*sheets, {{{-4, -1, -3 - half}, {4, -1, -4 - half}, {4, 3, -4 - half}, {-4, 3, -3 - half}}}, 24,
                    mortar);
    addQuad(*sheets, {{{-4, -1, -4}, {4, -1, -3}, {4, 3, -3}, {-4, 3, -4}}}, louvres);
    addQuad(*sheets, {{{-4, -1, 6}, {4, -1, 6}, {4, -1, -6}, {-4, -1, -6}}}, bowls);
    const double ground = -1 - depth / 8;
    addQuad(*sheets, {{{-4, ground, 6}, {4, ground, 6}, {4, ground, -6}, {-4, ground, -6}}}, mortar);
    addQuad(*sheets, {{{-4, -1, -3 - half / 2}, {4, -1, -4 - half / 2}, {4, 3, -4 - half / 2}, {-4, 3, -3 - half / 2}}},
            pane);
    addBox(*box, addMaterial(*box, "slats with holes", 20, Relief{ReliefPattern::Louvres, size, depth},
                             Cutout{CutoutPattern::Holes, size}));

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

std::vector<Generator> reliefs()
{
    return {{"reliefs",
             "Bricks, louvres and bowls: surfaces whose fragments change their depth",
             {{"size", RealNumber{0.5, 1e-3, 100}}, {"depth", RealNumber{0.4, 1e-6, 1e6}}},
             make}};
}

}  // namespace zscope::generated
