#include "core/geometry/batches.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <meshoptimizer.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace zscope {

namespace {

/// Numbers of 16 bits by keys of 32, at most `most` of them: a small hash table, so that its cost does not depend on
/// the mesh.
template <std::size_t most>
class SmallTable {
public:
    void clear() { m_keys.fill(kNone); }

    /// The key's number, or nothing if it has none.
    const std::uint16_t* find(std::uint32_t key) const
    {
        const std::size_t slot = slotOf(key);
        return m_keys[slot] == key ? &m_numbers[slot] : nullptr;
    }
    /// In place of the one that it may have.
    void put(std::uint32_t key, std::uint16_t number)
    {
        const std::size_t slot = slotOf(key);
        m_keys[slot]           = key;
        m_numbers[slot]        = number;
    }

private:
    static constexpr std::size_t   kSlots = std::bit_ceil(2 * most);  // a power of two, never more than half full
    static constexpr std::uint32_t kNone  = std::numeric_limits<std::uint32_t>::max();  // never a key

    /// The slot that holds the key, or the free one where it would be put.
    std::size_t slotOf(std::uint32_t key) const
    {
        std::size_t slot = (key * 2654435761u >> 16) % kSlots;
        while (m_keys[slot] != kNone && m_keys[slot] != key) slot = (slot + 1) % kSlots;
        return slot;
    }

    std::array<std::uint32_t, kSlots> m_keys{};
    std::array<std::uint16_t, kSlots> m_numbers{};
};

/// Fills one batch after another.
class BatchBuilder {
public:
    BatchBuilder(const Mesh& mesh, BatchSize size, MeshBatches& out) : m_mesh(mesh), m_size(size), m_out(out)
    {
        m_places.clear();
    }

    void add(std::uint32_t triangle)
    {
        const auto& corners = m_mesh.triangles[triangle];
        if (!fits(corners)) close();
        for (std::size_t i = 0; i < 3; ++i) m_out.corners[i].push_back(placeOf(corners[i]));
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
        m_batch.firstTriangle = static_cast<std::uint32_t>(m_out.meshTriangle.size());
    }

private:
    bool fits(const std::array<std::uint32_t, 3>& corners) const
    {
        std::size_t added = 0;
        for (const std::uint32_t vertex : corners) added += m_places.find(vertex) == nullptr;
        return m_batch.triangleCount < m_size.triangles && m_batch.vertexCount + added <= m_size.vertices;
    }

    std::uint16_t placeOf(std::uint32_t vertex)
    {
        if (const std::uint16_t* place = m_places.find(vertex)) return *place;
        const auto place = static_cast<std::uint16_t>(m_batch.vertexCount++);
        m_places.put(vertex, place);
        const dvec3& p = m_mesh.positions[vertex];
        m_out.x.push_back(p.x);
        m_out.y.push_back(p.y);
        m_out.z.push_back(p.z);
        m_batch.bounds.include(p);
        return place;
    }

    const Mesh&  m_mesh;
    BatchSize    m_size;
    MeshBatches& m_out;
    // Of the batch at hand, by vertex: no mesh has as many as a key could name.
    // Twice the room: at most a quarter full, nearly every search ends where it begins.
    SmallTable<2 * kBatchVertices> m_places;
    Batch                          m_batch;
};

std::vector<std::uint32_t> inLoadOrder(const Mesh& mesh)
{
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/// The triangles along a space-filling curve through their centres.
std::vector<std::uint32_t> neighboursTogether(const Mesh& mesh)
{
    std::vector<glm::vec3> centres;
    centres.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        centres.emplace_back(mesh.positions[a] / 3.0 + mesh.positions[b] / 3.0 + mesh.positions[c] / 3.0);
    std::vector<std::uint32_t> placeOf(centres.size()), order(centres.size());
    meshopt_spatialSortRemap(placeOf.data(), &centres[0].x, centres.size(), sizeof(centres[0]));
    for (std::uint32_t t = 0; t < placeOf.size(); ++t) order[placeOf[t]] = t;
    return order;
}

/// Divides triangles by that key in which they differ most, until what is left is a patch: where their normals leave a
/// gap, as the walls of houses do, and else in the middle. What a gap leaves over of a patch waits, and is divided by
/// itself, so that few patches face two ways.
class PatchOrder {
public:
    PatchOrder(const Mesh& mesh, std::span<const std::uint32_t> triangles)
    {
        Bounds box;
        for (const std::uint32_t t : triangles)
            for (const std::uint32_t corner : mesh.triangles[t]) box.include(mesh.positions[corner]);
        const dvec3  size    = box.max - box.min;
        const double longest = std::max({size.x, size.y, size.z});
        m_items.reserve(triangles.size());
        for (const std::uint32_t t : triangles) {
            const auto& [a, b, c] = mesh.triangles[t];
            const dvec3 along     = mesh.positions[b] - mesh.positions[a],
                        across    = glm::cross(along, mesh.positions[c] - mesh.positions[a]);
            const double area     = glm::length(across);
            const dvec3  centre   = mesh.positions[a] / 3.0 + mesh.positions[b] / 3.0 + mesh.positions[c] / 3.0;
            Item         item{t, {}};
            for (int i = 0; i < 3; ++i) {
                item.keys[static_cast<std::size_t>(i)]     = keyOf((centre[i] - box.min[i]) / longest);
                item.keys[static_cast<std::size_t>(i) + 3] = keyOf(across[i] / area);
            }
            m_items.push_back(item);
        }
    }

    std::vector<std::uint32_t> find()
    {
        m_order.reserve(m_items.size());
        divide(m_items, true);
        std::vector<Item> left = std::move(m_left);
        divide(left, false);
        return std::move(m_order);
    }

private:
    static constexpr std::size_t kKeys = 6;
    struct Item {
        std::uint32_t            triangle;
        std::array<float, kKeys> keys;  // of the centre, as parts of the longest side of all; of the normal
    };

    /// Of a ratio from -1 to 1; 0 where there was nothing to divide by, and of numbers that have run over: what is
    /// sorted needs an order.
    static float keyOf(double ratio) { return std::abs(ratio) <= 1.01 ? static_cast<float>(ratio) : 0; }

    /// Two normals that differ by more than this in one coordinate, and none between.
    static constexpr float kGap = 0.5f;

    void divide(std::span<Item> items, bool atGaps)
    {
        if (atGaps && items.size() < kPatchTriangles) {
            m_left.insert(m_left.end(), items.begin(), items.end());
            return;
        }
        if (items.size() <= kPatchTriangles) {
            std::ranges::sort(items, {}, &Item::triangle);
            for (const Item& item : items) m_order.push_back(item.triangle);
            return;
        }
        std::size_t widest = 0;
        float       width  = -1;
        for (std::size_t k = 0; k < kKeys; ++k) {
            const auto [least, most] = std::ranges::minmax(items, {}, [k](const Item& item) { return item.keys[k]; });
            if (most.keys[k] - least.keys[k] > width) widest = k, width = most.keys[k] - least.keys[k];
        }
        const auto        place   = [widest](const Item& item) { return std::pair(item.keys[widest], item.triangle); };
        const std::size_t gap     = atGaps && widest >= kKeys / 2 && width > kGap ? widestGap(items, widest, place) : 0;
        const std::size_t patches = (items.size() + kPatchTriangles - 1) / kPatchTriangles,
                          middle  = gap > 0 ? gap : patches / 2 * kPatchTriangles;
        if (gap == 0) std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(middle), {}, place);
        divide(items.first(middle), atGaps);
        divide(items.subspan(middle), atGaps);
    }

    /// Sorts by a key; how many lie before the widest gap, 0 if there is none.
    template <class Place>
    static std::size_t widestGap(std::span<Item> items, std::size_t key, const Place& place)
    {
        std::ranges::sort(items, {}, place);
        std::size_t before = 0;
        float       widest = kGap;
        for (std::size_t i = 1; i < items.size(); ++i)
            if (const float gap = items[i].keys[key] - items[i - 1].keys[key]; gap > widest) before = i, widest = gap;
        return before;
    }

    std::vector<Item>          m_items, m_left;
    std::vector<std::uint32_t> m_order;
};

/// What fill(builder) adds, about so many `triangles`, without what is known of their normals.
template <class Fill>
MeshBatches built(const Mesh& mesh, BatchSize size, std::size_t triangles, const Fill& fill)
{
    MeshBatches  out;
    BatchBuilder builder(mesh, size, out);
    for (MeshBatches::Column<std::uint16_t>& corner : out.corners) corner.reserve(triangles + kBatchPadding);
    out.meshTriangle.reserve(triangles + kBatchPadding);
    fill(builder);
    builder.close();
    if (std::ranges::any_of(mesh.materials, &Material::isPatterned))
        for (const std::uint32_t t : out.meshTriangle) out.patterned.push_back(mesh.isPatterned(t));
    // Lanes read whole vectors: let the last batch be read past its end.
    const auto pad = [](auto& column) { column.resize(column.size() + kBatchPadding); };
    pad(out.x), pad(out.y), pad(out.z), pad(out.meshTriangle);
    for (MeshBatches::Column<std::uint16_t>& corner : out.corners) pad(corner);
    return out;
}

/// Those of the triangles that are wanted, in the order given.
MeshBatches cut(const Mesh& mesh, std::span<const std::uint32_t> triangles, Surfaces wanted, BatchSize size = {})
{
    return built(mesh, size, triangles.size(), [&](BatchBuilder& builder) {
        for (const std::uint32_t t : triangles)
            if (surfaceOf(mesh, t) == wanted) builder.add(t);
    });
}

/// One in `step` of the batches, each of them in patches.
MeshBatches inPatchesEach(const Mesh& mesh, const MeshBatches& batches, std::size_t step)
{
    return built(mesh, {}, batches.triangleCount() / step, [&](BatchBuilder& builder) {
        for (std::size_t b = 0; b < batches.batches.size(); b += step) {
            const Batch& batch = batches.batches[b];
            for (const std::uint32_t t :
                 inPatches(mesh, batches.meshTriangles().subspan(batch.firstTriangle, batch.triangleCount)))
                builder.add(t);
            builder.close();
        }
    });
}

/// Fills in what is known of the batches' normals, and of their patches if those are wanted.
class ConeBuilder {
    using Triangle = std::array<dvec3, 3>;

public:
    explicit ConeBuilder(MeshBatches& mesh) : m_mesh(mesh) {}

    void run(bool withPatches)
    {
        for (Batch& batch : m_mesh.batches) {
            m_triangles.clear();
            for (std::uint32_t t = batch.firstTriangle; t < batch.firstTriangle + batch.triangleCount; ++t)
                m_triangles.push_back({corner(batch, 0, t), corner(batch, 1, t), corner(batch, 2, t)});
            batch.cone = normalConeOf(m_triangles, 0.5 * batch.bounds.min + 0.5 * batch.bounds.max);
            if (withPatches) addPatches(batch);
        }
    }

private:
    dvec3 corner(const Batch& batch, std::size_t k, std::uint32_t t) const
    {
        const std::size_t v = batch.firstVertex + m_mesh.corners[k][t];
        return {m_mesh.x[v], m_mesh.y[v], m_mesh.z[v]};
    }

    void addPatches(Batch& batch)
    {
        batch.firstBlock = static_cast<std::uint32_t>(m_mesh.patches.size());
        m_mesh.patches.resize(m_mesh.patches.size()
                              + (batch.patchCount() + PatchBlock::kPatches - 1) / PatchBlock::kPatches);
        for (std::uint32_t patch = 0; patch < batch.patchCount(); ++patch) {
            const std::uint32_t first = patch * kPatchTriangles,
                                count = std::min(batch.triangleCount - first, kPatchTriangles);
            PatchBlock&       block   = m_mesh.patches[batch.firstBlock + patch / PatchBlock::kPatches];
            const std::size_t lane    = patch % PatchBlock::kPatches;
            place(std::span(m_triangles).subspan(first, count), block, lane);
            for (std::uint32_t t = batch.firstTriangle + first; t < batch.firstTriangle + first + count; ++t)
                for (const MeshBatches::Column<std::uint16_t>& corner : m_mesh.corners)
                    block.vertexGroups[lane] |= std::uint64_t{1} << corner[t] / kVertexGroup;
        }
    }

    static void place(std::span<const Triangle> patch, PatchBlock& block, std::size_t lane)
    {
        Bounds box;
        for (const Triangle& triangle : patch)
            for (const dvec3& corner : triangle) box.include(corner);
        const dvec3 centre = 0.5 * box.min + 0.5 * box.max;
        double      most   = 0;
        for (const Triangle& triangle : patch)
            for (const dvec3& corner : triangle) most = std::max(most, glm::dot(corner - centre, corner - centre));
        const NormalCone cone = normalConeOf(patch, centre);
        for (int i = 0; i < 3; ++i) {
            const auto k        = static_cast<std::size_t>(i);
            block.axis[k][lane] = cone.axis[i], block.apex[k][lane] = cone.apex[i], block.centre[k][lane] = centre[i];
        }
        block.cosine[lane] = cone.cosine, block.sine[lane] = cone.sine, block.altitude[lane] = cone.altitude;
        block.radius[lane] = box.min == box.max ? 0 : ballRadius(most);
    }

    MeshBatches&          m_mesh;
    std::vector<Triangle> m_triangles;  // of the batch at hand
};

MeshBatches withCones(MeshBatches mesh, bool withPatches)
{
    ConeBuilder(mesh).run(withPatches);
    return mesh;
}

/// Finds the triangles beyond the sides of a batch's triangles: a side waits in a hash table until one comes that runs
/// the other way.
class SideBuilder {
public:
    explicit SideBuilder(MeshBatches& mesh) : m_mesh(mesh)
    {
        for (MeshBatches::Column<std::uint16_t>& column : mesh.beyond)
            column.assign(mesh.corners[0].size(), MeshBatches::kNobody);
    }

    void run()
    {
        for (const Batch& batch : m_mesh.batches) {
            m_waiting.clear();
            for (std::uint32_t t = 0; t < batch.triangleCount; ++t)
                for (std::uint32_t k = 0; k < 3; ++k) add(batch.firstTriangle, t, k);
        }
    }

private:
    static_assert(kBatchVertices < 0xFFFF && 4 * kBatchTriangles <= 0xFFFF);

    void add(std::uint32_t first, std::uint32_t t, std::uint32_t k)
    {
        const std::uint32_t from = m_mesh.corners[k][first + t], to = m_mesh.corners[(k + 1) % 3][first + t];
        if (from == to) return;
        if (const std::uint16_t* opposite = m_waiting.find(to << 16 | from)) {
            const std::uint16_t there  = *opposite / 4;
            std::uint16_t&      beyond = m_mesh.beyond[*opposite % 4][first + there];
            if (beyond == MeshBatches::kNobody) {  // else a third triangle has this side
                beyond                      = static_cast<std::uint16_t>(t);
                m_mesh.beyond[k][first + t] = there;
                return;
            }
        }
        m_waiting.put(from << 16 | to, static_cast<std::uint16_t>(4 * t + k));
    }

    MeshBatches&                    m_mesh;
    SmallTable<3 * kBatchTriangles> m_waiting;  // by from corner, to corner: 4 * triangle + side
};

MeshBatches withSides(MeshBatches mesh)
{
    SideBuilder(mesh).run();
    return mesh;
}

/// The share of all directions from which everything in a cone is seen from behind.
double shareBehind(double sine, double altitude) { return altitude > 0 ? (1 - sine) / 2 : 0; }

/// Whether, on average over all directions, a tenth of the triangles or more lie in patches that face away and batches
/// that do not.
bool dropsMoreByPatches(const MeshBatches& mesh)
{
    double byBatches = 0, byPatches = 0;
    for (const Batch& batch : mesh.batches) {
        byBatches += batch.triangleCount * shareBehind(batch.cone.sine, batch.cone.altitude);
        for (const PatchBlock& block : mesh.patchesOf(batch))
            for (std::size_t lane = 0; lane < PatchBlock::kPatches; ++lane)
                byPatches += kPatchTriangles * shareBehind(block.sine[lane], block.altitude[lane]);
    }
    return byPatches - byBatches > 0.1 * static_cast<double>(mesh.triangleCount());
}

}  // namespace

std::uint64_t MeshBatches::bytes() const
{
    return batches.capacity() * sizeof(Batch) + patches.capacity() * sizeof(PatchBlock)
           + (x.capacity() + y.capacity() + z.capacity()) * sizeof(double)
           + 3 * (corners[0].capacity() + beyond[0].capacity()) * sizeof(std::uint16_t)
           + meshTriangle.capacity() * sizeof(std::uint32_t) + patterned.capacity();
}

Surfaces surfaceOf(const Mesh& mesh, std::uint32_t triangle)
{
    return mesh.materialOf(mesh.trianglePolygon[triangle]).opacity < 1 ? Surfaces::Transparent : Surfaces::Opaque;
}

MeshBatches makeBatches(const Mesh& mesh, std::span<const std::uint32_t> triangles, Surfaces wanted, BatchSize size)
{
    return withCones(cut(mesh, triangles, wanted, size), true);
}

std::vector<std::uint32_t> inPatches(const Mesh& mesh, std::span<const std::uint32_t> triangles)
{
    return PatchOrder(mesh, triangles).find();
}

MeshBatches makeBatches(const Mesh& mesh, Surfaces wanted)
{
    MeshBatches loaded = cut(mesh, inLoadOrder(mesh), wanted);
    if (wanted != Surfaces::Opaque) return withCones(std::move(loaded), false);
    if (loaded.batches.size() < 2) return withSides(withCones(std::move(loaded), false));
    MeshBatches sorted = cut(mesh, neighboursTogether(mesh), wanted);
    return withSides(
        withCones(4 * sorted.vertexCount() <= 3 * loaded.vertexCount() ? std::move(sorted) : std::move(loaded), false));
}

MeshBatches patchedBatches(const Mesh& mesh, const MeshBatches& whole)
{
    constexpr std::size_t kTried = 16;  // one batch in so many tells whether it is worth while
    if (whole.batches.size() < 2 || !dropsMoreByPatches(withCones(inPatchesEach(mesh, whole, kTried), true))) return {};
    return withSides(withCones(inPatchesEach(mesh, whole, 1), true));
}

}  // namespace zscope
