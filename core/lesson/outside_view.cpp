#include "core/lesson/outside_view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/hierarchy/scene_trees.h"
#include "core/shade/colour_table.h"

namespace zscope {
namespace {

constexpr std::uint32_t kFrustumColour  = 0xFF1B2026;
constexpr std::uint32_t kSelectedColour = 0xFFE69F00;
constexpr double        kThin = 1.4, kThick = 3.5;  // pixels

Rgb rgbOf(std::uint32_t colour)
{
    const auto part = [colour](int shift) { return static_cast<float>((colour >> shift) & 0xFFu) / 255.0f; };
    return {part(16), part(8), part(0)};
}

/// `parts` of 256 from a towards b.
std::uint32_t mixed(std::uint32_t a, std::uint32_t b, int parts)
{
    std::uint32_t colour = 0xFF;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const int from = static_cast<int>((a >> shift) & 0xFFu), to = static_cast<int>((b >> shift) & 0xFFu);
        colour = colour << 8 | static_cast<std::uint32_t>(from + (to - from) * parts / 256);
    }
    return colour;
}

void addTriangle(Mesh& mesh, const std::array<dvec3, 3>& corners, MaterialId material)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const dvec3& corner : corners) mesh.positions.push_back(corner);
    const std::array<std::uint32_t, 3> outline{first, first + 1, first + 2};
    mesh.corners.insert(mesh.corners.end(), outline.begin(), outline.end());
    mesh.firstCorner.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    mesh.polygonMaterial.push_back(material);
    mesh.polygonGroup.push_back({});
    mesh.triangles.push_back(outline);
    mesh.trianglePolygon.push_back(PolygonId{static_cast<std::uint32_t>(mesh.triangles.size() - 1)});
    mesh.firstTriangle.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
}

Result<std::shared_ptr<const PreparedScene>> sceneOf(Mesh mesh, const Light& light)
{
    Scene parts;
    parts.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
    parts.instances.push_back({MeshId{0}, {}});
    parts.light = light;
    auto whole  = assemble(std::move(parts));
    if (!whole) return whole.error();
    return std::make_shared<const PreparedScene>(std::make_shared<const Scene>(std::move(whole).value()));
}

}  // namespace

std::uint32_t observerColourOf(NodeVerdict verdict)
{
    switch (verdict) {
        case NodeVerdict::Entered:
            return 0xFF0072B2;
        case NodeVerdict::Drawn:
            return 0xFF009E73;
        case NodeVerdict::Hidden:
            return 0xFFCC79A7;
        case NodeVerdict::Outside:
            return 0xFF98A2AE;
        case NodeVerdict::Small:
            return 0xFFD55E00;
        case NodeVerdict::Waiting:
            break;
    }
    return 0xFFD9B44A;
}

Result<std::shared_ptr<const OutsideView>> OutsideView::make(std::shared_ptr<const PreparedScene> scene,
                                                             const Camera& culling, const HierarchyState& hierarchy)
{
    auto made       = std::make_shared<OutsideView>();
    made->m_culling = culling;
    made->m_bounds  = scene->scene().bounds;
    made->m_bounds.include(culling.eye);

    Mesh mesh;
    mesh.name = "observed";
    mesh.materials.clear();
    for (const NodeVerdict verdict : {NodeVerdict::Waiting, NodeVerdict::Outside, NodeVerdict::Hidden,
                                      NodeVerdict::Entered, NodeVerdict::Drawn, NodeVerdict::Small}) {
        // Drawn triangles are pale blue, whatever their material; the others say by their colour why they are not in
        // the picture.
        const std::uint32_t colour = observerColourOf(verdict);
        mesh.materials.push_back({.name    = std::string(wordOf(verdict)),
                                  .diffuse = verdict == NodeVerdict::Drawn ? Rgb{0.66f, 0.75f, 0.88f}
                                                                           : rgbOf(mixed(colour, 0xFFFFFFFF, 96))});
    }
    if (hierarchy.tree)
        for (const NodeVerdict verdict :
             {NodeVerdict::Drawn, NodeVerdict::Hidden, NodeVerdict::Outside, NodeVerdict::Small, NodeVerdict::Waiting})
            made->addTriangles(*scene, hierarchy, *hierarchy.tree, verdict, mesh);
    auto painted = sceneOf(std::move(mesh), scene->scene().light);
    if (!painted) return painted.error();
    made->m_painted = *painted;
    made->addBoxes(scene->scene(), hierarchy.nodes);
    made->addFrustum(culling);
    return std::shared_ptr<const OutsideView>(std::move(made));
}

void OutsideView::addTriangles(const PreparedScene& prepared, const HierarchyState& hierarchy, TreeKind kind,
                               NodeVerdict verdict, Mesh& mesh)
{
    const Scene&      scene = prepared.scene();
    const SceneTrees& trees = treesOf(prepared, kind);
    const auto        addOf = [&](InstanceId instance, std::uint32_t triangle, int node) {
        if (m_nodeOfTriangle.size() >= kMostTriangles) {
            ++m_leftOut;
            return;
        }
        const Mesh&   from    = scene.meshOf(instance);
        const Affine& toWorld = scene.instances[instance.value].toWorld;
        const auto&   corners = from.triangles[triangle];
        addTriangle(mesh,
                           {toWorld(from.positions[corners[0]]), toWorld(from.positions[corners[1]]),
                     toWorld(from.positions[corners[2]])},
                           MaterialId{static_cast<std::uint32_t>(verdict)});
        m_nodeOfTriangle.push_back(node);
    };
    for (const NodeRow& row : hierarchy.nodes) {
        if (row.verdict != verdict) continue;
        const Tree&     tree = row.instance ? trees.mesh(scene.instances[row.instance->value].mesh) : trees.instances();
        const TreeNode* node = nodeAt(tree, row.path);
        if (!node) continue;
        // A drawn node has drawn its own; whoever was turned away takes everything below with it.
        if (verdict == NodeVerdict::Drawn && !node->isOpen.load(std::memory_order_acquire)) continue;
        const auto items = verdict == NodeVerdict::Drawn ? tree.ownItems(*node) : tree.allItems(*node);
        if (row.instance) {
            for (const std::uint32_t triangle : items) addOf(*row.instance, triangle, row.id);
        } else if (verdict != NodeVerdict::Drawn) {  // drawn instances have nodes of their own
            for (const std::uint32_t item : items) {
                const InstanceId instance{item};
                const auto       count = static_cast<std::uint32_t>(scene.meshOf(instance).triangles.size());
                for (std::uint32_t triangle = 0; triangle < count; ++triangle) addOf(instance, triangle, row.id);
            }
        }
    }
}

void OutsideView::addBoxes(const Scene& scene, const std::vector<NodeRow>& nodes)
{
    for (const NodeRow& row : nodes) {
        if (row.box.isEmpty()) continue;
        ++m_boxes[static_cast<std::size_t>(row.verdict)];
        if (m_lines.size() / kBoxEdges.size() >= kMostBoxes) {
            ++m_boxesLeftOut;
            continue;
        }
        const auto corners = cornersOf(row, scene);
        for (const auto& edge : kBoxEdges)
            m_lines.push_back({corners[static_cast<std::size_t>(edge[0])], corners[static_cast<std::size_t>(edge[1])],
                               row.id, row.verdict});
    }
}

void OutsideView::addFrustum(const Camera& camera)
{
    m_frustumFrom = m_lines.size();
    // As far as the scene reaches: the far plane may be anywhere.
    double reach = 0;
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner{i & 1 ? m_bounds.max.x : m_bounds.min.x, i & 2 ? m_bounds.max.y : m_bounds.min.y,
                           i & 4 ? m_bounds.max.z : m_bounds.min.z};
        reach = std::max(reach, glm::dot(corner - camera.eye, camera.forward));
    }
    const double farther = std::min(camera.far, std::max(reach, 4 * camera.near));
    const auto   at      = [&](double x, double y, double z) {
        const double tall = z / camera.focal, wide = tall * camera.width / camera.height;
        return camera.eye + camera.right * (x * wide) + camera.up * (y * tall) + camera.forward * z;
    };
    constexpr std::array<std::array<int, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t i = 0; i < signs.size(); ++i) {
        const auto& a = signs[i];
        const auto& b = signs[(i + 1) % signs.size()];
        for (const double z : {camera.near, farther})
            m_lines.push_back({at(a[0], a[1], z), at(b[0], b[1], z), kFrustum, NodeVerdict::Waiting});
        m_lines.push_back({camera.eye, at(a[0], a[1], farther), kFrustum, NodeVerdict::Waiting});
    }
}

std::size_t OutsideView::boxesOf(NodeVerdict verdict) const { return m_boxes[static_cast<std::size_t>(verdict)]; }

Camera OutsideView::firstView(int width, int height) const
{
    const dvec3  middle = (m_bounds.min + m_bounds.max) * 0.5;
    const double size   = std::max(glm::length(m_bounds.max - m_bounds.min), 1e-6);
    // From the side of the culling view, behind it and above, so that its frustum points into the picture.
    dvec3 side = m_culling.right - m_culling.forward * 0.8 + dvec3{0, 0.7, 0};
    if (glm::length(glm::cross(side, dvec3{0, 1, 0})) < 1e-6 * glm::length(side)) side = dvec3{1, 0.7, 1};
    ViewRequest view;
    view.eye          = middle + glm::normalize(side) * (0.85 * size);
    view.target       = middle;
    view.verticalFov  = 40;
    view.near         = 1e-3 * size;
    view.far          = 100 * size;
    view.width        = width;
    view.height       = height;
    const auto camera = makeCamera(view, m_bounds);
    return camera ? *camera : m_culling;
}

Result<ObserverPicture> OutsideView::draw(const Camera& from, const VerdictSet& boxes, int selected, int threads,
                                          const std::atomic<bool>* cancel) const
{
    const Pipeline zbuffer = findPreset("zbuffer")->pipeline;
    Renderer       renderer;
    Frame          solid, wires;
    if (const auto drawn = renderer.draw(
            {.scene = m_painted, .camera = from, .pipeline = zbuffer, .threads = threads, .cancel = cancel}, solid);
        !drawn)
        return drawn.error();

    Mesh                                       quads;
    std::vector<std::pair<int, std::uint32_t>> ofQuad;  // node, colour
    const double                               focalPixels = from.height * 0.5 * from.focal;
    const auto                                 isWanted    = [&](std::size_t i) {
        return i >= m_frustumFrom || m_lines[i].node == selected || boxes[static_cast<std::size_t>(m_lines[i].verdict)];
    };
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        if (!isWanted(i)) continue;
        const bool   isSelected = i < m_frustumFrom && m_lines[i].node == selected;
        dvec3        a = m_lines[i].a - from.eye, b = m_lines[i].b - from.eye;
        double       za = glm::dot(a, from.forward), zb = glm::dot(b, from.forward);
        const double least = from.near * 1.01;
        if (za < least && zb < least) continue;
        if (za < least) a += (b - a) * ((least - za) / (zb - za)), za = least;
        if (zb < least) b += (a - b) * ((least - zb) / (za - zb)), zb = least;
        // the same all along a line: at right angles to the plane of line and eye
        const dvec3  across = glm::cross(a, b);
        const double length = glm::length(across);
        if (!(length > 0)) continue;
        const double half  = (isSelected || i >= m_frustumFrom ? (isSelected ? kThick : 2.0) : kThin) / 2 / focalPixels;
        const dvec3  sideA = across * (half * za / length), sideB = across * (half * zb / length);
        const double ahead = isSelected ? 0.995 : 0.999;  // a little nearer than what the line lies on
        a *= ahead, b *= ahead;
        const dvec3 p = from.eye + a - sideA, q = from.eye + a + sideA, r = from.eye + b + sideB,
                    s = from.eye + b - sideB;
        addTriangle(quads, {p, q, r}, {});
        addTriangle(quads, {p, r, s}, {});
        const std::uint32_t colour = isSelected           ? kSelectedColour
                                     : i >= m_frustumFrom ? kFrustumColour
                                                          : observerColourOf(m_lines[i].verdict);
        ofQuad.emplace_back(m_lines[i].node, colour);
    }
    const auto lines = sceneOf(std::move(quads), {});
    if (!lines) return lines.error();
    if (const auto drawn = renderer.draw({.scene    = *lines,
                                          .camera   = from,
                                          .pipeline = zbuffer,
                                          .threads  = threads,
                                          .shade    = false,
                                          .cancel   = cancel},
                                         wires);
        !drawn)
        return drawn.error();

    constexpr int   kFaint = 176;  // of 256 towards what is in front
    ObserverPicture picture{std::move(solid.colour), Grid<int>(from.width, from.height, -1)};
    for (int y = 0; y < from.height; ++y) {
        for (int x = 0; x < from.width; ++x) {
            const std::int64_t triangle = solid.visible.idAt(x, y), quad = wires.visible.idAt(x, y);
            if (triangle >= 0) picture.nodes.at(x, y) = m_nodeOfTriangle[static_cast<std::size_t>(triangle)];
            if (quad < 0) continue;
            const auto& line    = ofQuad[static_cast<std::size_t>(quad) / 2];
            const bool  isAhead = wires.visible.depthAt(x, y) >= solid.visible.depthAt(x, y);
            if (isAhead) picture.nodes.at(x, y) = line.first;
            picture.colours.at(x, y) = isAhead ? line.second : mixed(line.second, picture.colours.at(x, y), kFaint);
        }
    }
    return picture;
}

}  // namespace zscope
