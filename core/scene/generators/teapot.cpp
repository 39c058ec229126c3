// builtin:teapot: Newell's teapot from its control points, every patch cut into tessellation x tessellation quads.
//
// Patches    ten are given and turned or mirrored into 32: rim, body, lid and bottom four times, handle and spout twice
// Axes       y is up; the pot stands on y = 0 and its spout points along +x
// Poles      where a patch closes to a point (lid knob, bottom) the quads become triangles
// Source     M. Newell, 1975; control points as in the published data set, F. Crow: The Origins of the Teapot, IEEE
//            CG&A 7(1), 1987; the bottom was added by J. Blinn
#include <array>
#include <memory>

#include "core/scene/generators/registry.h"
#include "core/scene/generators/welder.h"

namespace zscope::generated {

namespace {

using ControlPoint = std::array<double, 3>;         // x towards the spout, y to the side, z up
using Patch        = std::array<ControlPoint, 16>;  // rows of four

/// How a given patch stands for several: turned four times about the axis, or mirrored once to the other side.
enum class Symmetry { FourTurns, Mirror };

/// Rows run along the profile or the tube, columns around it; (column direction) x (row direction) points outwards.
struct GivenPatch {
    std::string_view group;
    Symmetry         symmetry;
    Patch            points;
};

/// A point of a profile: its distance from the axis, its height, and how far the tangents of a quarter turn reach.
struct ProfilePoint {
    double radius, height, reach;
};

/// A quarter of the surface that a profile sweeps when it turns about the axis.
constexpr Patch revolved(const std::array<ProfilePoint, 4>& profile)
{
    Patch points{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [radius, height, reach] = profile[i];
        points[4 * i]                      = {radius, 0, height};
        points[4 * i + 1]                  = {radius, -reach, height};
        points[4 * i + 2]                  = {reach, -radius, height};
        points[4 * i + 3]                  = {0, -radius, height};
    }
    return points;
}

/// Half of a tube beside the plane y = 0, from one line of that plane out to `side` and back to the other line.
using PlaneLine = std::array<std::array<double, 2>, 4>;  // {x, height} four times
constexpr Patch halfTube(const PlaneLine& from, const PlaneLine& to, const std::array<double, 4>& side)
{
    Patch points{};
    for (std::size_t i = 0; i < 4; ++i) {
        points[4 * i]     = {from[i][0], 0, from[i][1]};
        points[4 * i + 1] = {from[i][0], -side[i], from[i][1]};
        points[4 * i + 2] = {to[i][0], -side[i], to[i][1]};
        points[4 * i + 3] = {to[i][0], 0, to[i][1]};
    }
    return points;
}

constexpr std::array<GivenPatch, 10> kPatches{{
    {"rim", Symmetry::FourTurns,
     revolved({{{1.4, 2.4, 0.784}, {1.3375, 2.53125, 0.749}, {1.4375, 2.53125, 0.805}, {1.5, 2.4, 0.84}}})},
    {"body", Symmetry::FourTurns,
     revolved({{{1.5, 2.4, 0.84}, {1.75, 1.875, 0.98}, {2.0, 1.35, 1.12}, {2.0, 0.9, 1.12}}})},
    {"body", Symmetry::FourTurns,
     revolved({{{2.0, 0.9, 1.12}, {2.0, 0.45, 1.12}, {1.5, 0.225, 0.84}, {1.5, 0.15, 0.84}}})},
    {"lid", Symmetry::FourTurns,
     revolved({{{0.0, 3.15, 0.0}, {0.8, 3.15, 0.45}, {0.0, 2.85, 0.0}, {0.2, 2.7, 0.112}}})},
    {"lid", Symmetry::FourTurns,
     revolved({{{0.2, 2.7, 0.112}, {0.4, 2.55, 0.224}, {1.3, 2.55, 0.728}, {1.3, 2.4, 0.728}}})},
    {"handle", Symmetry::Mirror,
     halfTube({{{-1.6, 2.025}, {-2.3, 2.025}, {-2.7, 2.025}, {-2.7, 1.8}}},
              {{{-1.5, 2.25}, {-2.5, 2.25}, {-3.0, 2.25}, {-3.0, 1.8}}}, {0.3, 0.3, 0.3, 0.3})},
    {"handle", Symmetry::Mirror,
     halfTube({{{-2.7, 1.8}, {-2.7, 1.575}, {-2.5, 1.125}, {-2.0, 0.9}}},
              {{{-3.0, 1.8}, {-3.0, 1.35}, {-2.65, 0.9375}, {-1.9, 0.6}}}, {0.3, 0.3, 0.3, 0.3})},
    {"spout", Symmetry::Mirror,
     halfTube({{{1.7, 1.425}, {2.6, 1.425}, {2.3, 2.1}, {2.7, 2.4}}},
              {{{1.7, 0.6}, {3.1, 0.825}, {2.4, 2.025}, {3.3, 2.4}}}, {0.66, 0.66, 0.25, 0.25})},
    {"spout", Symmetry::Mirror,
     halfTube({{{2.7, 2.4}, {2.8, 2.475}, {2.9, 2.475}, {2.8, 2.4}}},
              {{{3.3, 2.4}, {3.525, 2.49375}, {3.45, 2.5125}, {3.2, 2.4}}}, {0.25, 0.25, 0.15, 0.15})},
    {"bottom", Symmetry::FourTurns,
     revolved({{{1.5, 0.15, 0.84}, {1.5, 0.075, 0.84}, {1.425, 0.0, 0.798}, {0.0, 0.0, 0.0}}})},
}};

/// Bernstein's weights of a cubic at t.
std::array<double, 4> weights(double t)
{
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

ControlPoint pointAt(const Patch& patch, double u, double v)
{
    const auto   wu = weights(u), wv = weights(v);
    ControlPoint p{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 3; ++k) p[k] += wu[i] * wv[j] * patch[4 * i + j][k];
    return p;
}

/// Copy number `turn` of a patch's point.
ControlPoint placed(const ControlPoint& p, Symmetry symmetry, int turn)
{
    if (symmetry == Symmetry::Mirror) return {p[0], turn == 0 ? p[1] : -p[1], p[2]};
    switch (turn) {
        case 0:
            return p;
        case 1:
            return {p[1], -p[0], p[2]};
        case 2:
            return {-p[0], -p[1], p[2]};
        default:
            return {-p[1], p[0], p[2]};
    }
}

/// From the axes of the control points to those of the scene: y up.
dvec3 upright(const ControlPoint& p) { return {p[0], p[2], 0.0 - p[1]}; }

/// One copy of one patch as cells x cells polygons; four corners, or three beside a pole.
void addPatch(Mesh& mesh, Welder& welder, const GivenPatch& given, int turn, std::uint32_t cells, GroupId group)
{
    const std::uint32_t        side = cells + 1;
    std::vector<std::uint32_t> grid(std::size_t{side} * side);
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j)
            grid[std::size_t{i} * side + j] = welder.vertexAt(
                upright(placed(pointAt(given.points, static_cast<double>(i) / cells, static_cast<double>(j) / cells),
                               given.symmetry, turn)));

    const bool mirrored = given.symmetry == Symmetry::Mirror && turn == 1;
    for (std::uint32_t i = 0; i < cells; ++i)
        for (std::uint32_t j = 0; j < cells; ++j) {
            const std::size_t            at = std::size_t{i} * side + j;
            std::array<std::uint32_t, 4> quad{grid[at], grid[at + 1], grid[at + side + 1], grid[at + side]};
            if (mirrored) std::swap(quad[1], quad[3]);
            std::array<std::uint32_t, 4> outline{};
            std::size_t                  corners = 0;
            for (std::size_t c = 0; c < 4; ++c)
                if (quad[c] != quad[(c + 1) % 4]) outline[corners++] = quad[c];
            if (corners >= 3) mesh.addPolygon(std::span(outline).first(corners), MaterialId{0}, group);
        }
}

Result<Scene> make(const Arguments& arguments)
{
    const auto cells = static_cast<std::uint32_t>(arguments.whole("tessellation"));
    // 32 patches; per quad a vertex, its place in the welder and two triangles.
    const double quads = 32.0 * cells * cells;
    const double bytes = meshBytes(quads, quads, 4 * quads, 2 * quads) + Welder::kBytesPerVertex * quads;
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("the teapot at this tessellation", bytes, arguments.memoryLimit);

    auto teapot                  = std::make_shared<Mesh>();
    teapot->name                 = "teapot";
    teapot->materials[0].name    = "glaze";
    teapot->materials[0].diffuse = {0.45f, 0.60f, 0.80f};
    Welder      welder(*teapot);
    std::size_t done = 0;
    for (const GivenPatch& given : kPatches) {
        if (teapot->groups.back() != given.group) teapot->groups.emplace_back(given.group);
        const GroupId group{static_cast<std::uint32_t>(teapot->groups.size() - 1)};
        const int     copies = given.symmetry == Symmetry::FourTurns ? 4 : 2;
        for (int turn = 0; turn < copies; ++turn) addPatch(*teapot, welder, given, turn, cells, group);
        arguments.progress.at(static_cast<double>(++done) / kPatches.size(), "patches");
        if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the teapot was not wanted any more"};
    }

    Scene scene;
    scene.meshes.push_back(teapot);
    scene.instances.push_back({MeshId{0}, Affine{}});
    ViewRequest view;
    view.eye         = dvec3{2.6, 4.6, 9.6};
    view.target      = dvec3{0.15, 1.35, 0};
    view.verticalFov = 30;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> teapot()
{
    return {
        {"teapot", "Newell's teapot, its patches cut into quads", {{"tessellation", WholeNumber{10, 1, 1000}}}, make}};
}

}  // namespace zscope::generated
