#include "core/geometry/batches.h"

#include <limits>

namespace zscope {

namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

/// Fills one batch after another; `m_place` remembers where a mesh vertex stands in the current batch.
class BatchBuilder {
public:
    BatchBuilder(const Mesh& mesh, MeshBatches& out) : m_mesh(mesh), m_out(out), m_place(mesh.positions.size(), kUnused) {}

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
        for (const std::uint32_t vertex : m_used) m_place[vertex] = kUnused;
        m_used.clear();
        m_batch               = {};
        m_batch.firstVertex   = static_cast<std::uint32_t>(m_out.x.size());
        m_batch.firstTriangle = static_cast<std::uint32_t>(m_out.triangles.size());
    }

private:
    bool fits(const std::array<std::uint32_t, 3>& corners) const
    {
        std::size_t added = 0;
        for (const std::uint32_t vertex : corners) added += m_place[vertex] == kUnused;
        return m_batch.triangleCount < kBatchTriangles && m_batch.vertexCount + added <= kBatchVertices;
    }

    std::uint16_t placeOf(std::uint32_t vertex)
    {
        if (m_place[vertex] == kUnused) {
            m_place[vertex] = m_batch.vertexCount++;
            m_used.push_back(vertex);
            const dvec3& p = m_mesh.positions[vertex];
            m_out.x.push_back(p.x);
            m_out.y.push_back(p.y);
            m_out.z.push_back(p.z);
            m_batch.bounds.include(p);
        }
        return static_cast<std::uint16_t>(m_place[vertex]);
    }

    const Mesh&                m_mesh;
    MeshBatches&               m_out;
    std::vector<std::uint32_t> m_place;  // per mesh vertex: its place in the current batch, or kUnused
    std::vector<std::uint32_t> m_used;   // mesh vertices of the current batch
    Batch                      m_batch;
};

}  // namespace

std::uint64_t MeshBatches::bytes() const
{
    return batches.capacity() * sizeof(Batch) + (x.capacity() + y.capacity() + z.capacity()) * sizeof(double) +
           triangles.capacity() * sizeof(BatchTriangle) + meshTriangle.capacity() * sizeof(std::uint32_t);
}

MeshBatches makeBatches(const Mesh& mesh)
{
    MeshBatches  out;
    BatchBuilder builder(mesh, out);
    out.triangles.reserve(mesh.triangles.size());
    out.meshTriangle.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.materialOf(mesh.trianglePolygon[t]).opacity < 1) continue;
        builder.add(t);
    }
    builder.close();
    // Lanes read whole vectors: let the last batch be read past its end.
    for (std::vector<double>* axis : {&out.x, &out.y, &out.z}) axis->resize(axis->size() + kBatchPadding);
    return out;
}

}  // namespace zscope
