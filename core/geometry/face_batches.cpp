#include "core/geometry/face_batches.h"

#include <algorithm>
#include <memory>

#include <glm/geometric.hpp>

namespace zscope {

namespace {

FacePlane planeOf(const Mesh& mesh, PolygonId polygon)
{
    const std::span<const std::uint32_t> corners = mesh.polygon(polygon);
    const dvec3&                         origin  = mesh.positions[corners[0]];
    dvec3                                normal{0}, sum{0};
    dvec3                                previous = mesh.positions[corners.back()] - origin;
    for (const std::uint32_t vertex : corners) {
        const dvec3 corner = mesh.positions[vertex] - origin;
        normal += glm::cross(previous, corner);
        sum += corner;
        previous = corner;
    }
    return {normal, origin + sum / static_cast<double>(corners.size())};
}

/// Fills one batch after another, a face at a time.
class FaceBatchBuilder {
public:
    FaceBatchBuilder(const Mesh& mesh, FaceBatches& out)
        : m_mesh(mesh), m_out(out), m_places(mesh.positions.size(), kNone)
    {}

    void add(PolygonId polygon)
    {
        const std::uint32_t first = m_mesh.firstTriangle[polygon.value], end = m_mesh.firstTriangle[polygon.value + 1];
        if (!fits(first, end)) close();
        Face face{.firstSide     = static_cast<std::uint32_t>(m_out.sides.size()),
                  .firstEar      = static_cast<std::uint32_t>(m_out.ears.size()),
                  .firstTriangle = first,
                  .patterned     = m_mesh.materialOf(polygon).isPatterned(),
                  .isMended      = m_mesh.isMended(polygon)};
        for (std::uint32_t t = first; t < end; ++t) {
            const auto& [a, b, c] = m_mesh.triangles[t];
            m_out.ears.push_back({placeOf(a), placeOf(b), placeOf(c)});
            m_out.points.meshTriangle.push_back(t);
        }
        if (end - first > 1) {
            face.plane = static_cast<std::uint32_t>(m_out.planes.size());
            m_out.planes.push_back(planeOf(m_mesh, polygon));
            addSides(face.firstEar);
        }
        m_out.faces.push_back(face);
        ++m_batch.faceCount;
        m_points.triangleCount += end - first;
    }

    void close()
    {
        if (m_batch.faceCount > 0) {
            m_out.batches.push_back(m_batch);
            m_out.points.batches.push_back(m_points);
            m_out.points.bounds.include(m_points.bounds.min);
            m_out.points.bounds.include(m_points.bounds.max);
        }
        for (const std::uint32_t vertex : m_vertices) m_places[vertex] = kNone;
        m_vertices.clear();
        m_batch                = {.firstFace = static_cast<std::uint32_t>(m_out.faces.size())};
        m_points               = {};
        m_points.firstVertex   = static_cast<std::uint32_t>(m_out.points.x.size());
        m_points.firstTriangle = static_cast<std::uint32_t>(m_out.points.meshTriangle.size());
    }

private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    /// One side of an ear: between two places, the lower first, and which way the ear runs along it.
    struct Link {
        std::uint32_t low, high;
        int           turns;  // 1: from low to high
    };

    bool fits(std::uint32_t first, std::uint32_t end) const
    {
        if (m_batch.faceCount == 0) return true;
        if (m_points.triangleCount + (end - first) > BatchSize().triangles) return false;
        std::size_t fresh = 0;  // at most; a vertex of several ears is counted several times
        for (std::uint32_t t = first; t < end; ++t)
            for (const std::uint32_t vertex : m_mesh.triangles[t]) fresh += m_places[vertex] == kNone;
        if (end - first > 1) fresh = std::min<std::size_t>(fresh, end - first + 2);
        return m_points.vertexCount + fresh <= BatchSize().vertices;
    }

    std::uint32_t placeOf(std::uint32_t vertex)
    {
        if (m_places[vertex] != kNone) return m_places[vertex];
        m_vertices.push_back(vertex);
        const dvec3& p = m_mesh.positions[vertex];
        m_out.points.x.push_back(p.x);
        m_out.points.y.push_back(p.y);
        m_out.points.z.push_back(p.z);
        m_points.bounds.include(p);
        return m_places[vertex] = m_points.vertexCount++;
    }

    /// The sides of the ears from `firstEar` on that do not cancel.
    void addSides(std::uint32_t firstEar)
    {
        m_links.clear();
        for (const FaceEar& ear : std::span(m_out.ears).subspan(firstEar))
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t from = ear[i], to = ear[(i + 1) % 3];
                if (from != to) m_links.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
            }
        std::ranges::sort(
            m_links, [](const Link& a, const Link& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
        for (std::size_t i = 0; i < m_links.size();) {
            const Link link  = m_links[i];
            int        turns = 0;
            for (; i < m_links.size() && m_links[i].low == link.low && m_links[i].high == link.high; ++i)
                turns += m_links[i].turns;
            for (; turns > 0; --turns) m_out.sides.push_back({link.low, link.high});
            for (; turns < 0; ++turns) m_out.sides.push_back({link.high, link.low});
        }
    }

    const Mesh&                m_mesh;
    FaceBatches&               m_out;
    std::vector<std::uint32_t> m_places;    // of each vertex of the mesh in the batch at hand, or kNone
    std::vector<std::uint32_t> m_vertices;  // those that have one
    std::vector<Link>          m_links;
    FaceBatch                  m_batch;
    Batch                      m_points;
};

}  // namespace

FaceBatches makeFaceBatches(const Mesh& mesh)
{
    FaceBatches      out;
    FaceBatchBuilder builder(mesh, out);
    for (std::uint32_t p = 0; p < mesh.polygonCount(); ++p) {
        const PolygonId polygon{p};
        if (mesh.materialOf(polygon).opacity >= 1 && mesh.firstTriangle[p] < mesh.firstTriangle[p + 1])
            builder.add(polygon);
    }
    builder.close();
    out.faces.push_back({.firstSide = static_cast<std::uint32_t>(out.sides.size()),
                         .firstEar  = static_cast<std::uint32_t>(out.ears.size())});
    for (MeshBatches::Column<double>* axis : {&out.points.x, &out.points.y, &out.points.z})
        axis->resize(axis->size() + kBatchPadding);
    return out;
}

std::uint64_t FaceBatches::bytes() const
{
    return points.bytes() + batches.capacity() * sizeof(FaceBatch) + faces.capacity() * sizeof(Face)
           + sides.capacity() * sizeof(FaceSide) + ears.capacity() * sizeof(FaceEar)
           + planes.capacity() * sizeof(FacePlane);
}

SceneFaces::SceneFaces(const Scene& scene)
{
    m_meshes.reserve(scene.meshes.size());
    for (const auto& mesh : scene.meshes) m_meshes.push_back(makeFaceBatches(*mesh));
}

std::uint64_t SceneFaces::bytes() const
{
    std::uint64_t total = 0;
    for (const FaceBatches& mesh : m_meshes) total += mesh.bytes();
    return total;
}

const SceneFaces& facesOf(const PreparedScene& scene)
{
    return scene.derived().get<SceneFaces>([&scene] { return std::make_unique<SceneFaces>(scene.scene()); });
}

}  // namespace zscope
