#include "core/geometry/batches.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace zscope {

namespace {

/// Where the vertices of the current batch stand: a small hash table, so that its cost does not depend on the mesh.
class VertexPlaces {
public:
    void clear() { m_vertices.fill(kNone); }

    /// The vertex's place, or nothing if the batch does not have it.
    const std::uint16_t* find(std::uint32_t vertex) const
    {
        const std::size_t slot = slotOf(vertex);
        return m_vertices[slot] == vertex ? &m_places[slot] : nullptr;
    }
    void add(std::uint32_t vertex, std::uint16_t place)
    {
        const std::size_t slot = slotOf(vertex);
        m_vertices[slot]       = vertex;
        m_places[slot]         = place;
    }

private:
    static constexpr std::size_t   kSlots = 4 * kBatchVertices;  // a power of two, never more than a quarter full
    static constexpr std::uint32_t kNone  = std::numeric_limits<std::uint32_t>::max();  // no mesh has that many vertices

    /// The slot that holds the vertex, or the free one where it would be put.
    std::size_t slotOf(std::uint32_t vertex) const
    {
        std::size_t slot = (vertex * 2654435761u >> 16) % kSlots;
        while (m_vertices[slot] != kNone && m_vertices[slot] != vertex) slot = (slot + 1) % kSlots;
        return slot;
    }

    std::array<std::uint32_t, kSlots> m_vertices{};
    std::array<std::uint16_t, kSlots> m_places{};
};

/// Fills one batch after another.
class BatchBuilder {
public:
    BatchBuilder(const Mesh& mesh, MeshBatches& out) : m_mesh(mesh), m_out(out) { m_places.clear(); }

    void add(std::uint32_t triangle)
    {
        const auto& corners = m_mesh.triangles[triangle];
        if (!fits(corners)) close();
        BatchTriangle local;
        for (std::size_t i = 0; i < 3; ++i) local.corner[i] = placeOf(corners[i]);
        m_out.triangles.push_back(local);
        m_out.meshTriangle.push_back(triangle);
        ++m_batch.triangleCount;
    }

    void close()
    {
        if (m_batch.triangleCount > 0) {
            m_out.batches.push_back(m_batch);
            m_out.bounds.include(m_batch.bounds.min);
            m_out.bounds.include(m_batch.bounds.max);
        }
        m_places.clear();
        m_batch               = {};
        m_batch.firstVertex   = static_cast<std::uint32_t>(m_out.x.size());
        m_batch.firstTriangle = static_cast<std::uint32_t>(m_out.triangles.size());
    }

private:
    bool fits(const std::array<std::uint32_t, 3>& corners) const
    {
        std::size_t added = 0;
        for (const std::uint32_t vertex : corners) added += m_places.find(vertex) == nullptr;
        return m_batch.triangleCount < kBatchTriangles && m_batch.vertexCount + added <= kBatchVertices;
    }

    std::uint16_t placeOf(std::uint32_t vertex)
    {
        if (const std::uint16_t* place = m_places.find(vertex)) return *place;
        const auto place = static_cast<std::uint16_t>(m_batch.vertexCount++);
        m_places.add(vertex, place);
        const dvec3& p = m_mesh.positions[vertex];
        m_out.x.push_back(p.x);
        m_out.y.push_back(p.y);
        m_out.z.push_back(p.z);
        m_batch.bounds.include(p);
        return place;
    }

    const Mesh&  m_mesh;
    MeshBatches& m_out;
    VertexPlaces m_places;
    Batch        m_batch;
};

}  // namespace

std::uint64_t MeshBatches::bytes() const
{
    return batches.capacity() * sizeof(Batch) + (x.capacity() + y.capacity() + z.capacity()) * sizeof(double) +
           triangles.capacity() * sizeof(BatchTriangle) + meshTriangle.capacity() * sizeof(std::uint32_t) + patterned.capacity();
}

Surfaces surfaceOf(const Mesh& mesh, std::uint32_t triangle)
{
    return mesh.materialOf(mesh.trianglePolygon[triangle]).opacity < 1 ? Surfaces::Transparent : Surfaces::Opaque;
}

MeshBatches makeBatches(const Mesh& mesh, std::span<const std::uint32_t> triangles, Surfaces wanted)
{
    MeshBatches  out;
    BatchBuilder builder(mesh, out);
    out.triangles.reserve(triangles.size());
    out.meshTriangle.reserve(triangles.size());
    for (const std::uint32_t t : triangles)
        if (surfaceOf(mesh, t) == wanted) builder.add(t);
    builder.close();
    if (std::ranges::any_of(mesh.materials, &Material::isPatterned))
        for (const std::uint32_t t : out.meshTriangle) out.patterned.push_back(mesh.isPatterned(t));
    // Lanes read whole vectors: let the last batch be read past its end.
    for (std::vector<double>* axis : {&out.x, &out.y, &out.z}) axis->resize(axis->size() + kBatchPadding);
    return out;
}

MeshBatches makeBatches(const Mesh& mesh, Surfaces wanted)
{
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return makeBatches(mesh, all, wanted);
}

}  // namespace zscope
