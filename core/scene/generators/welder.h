// Gives equal points one vertex. Points are put on a grid of 2^-24 units first, so that the rims of neighbouring
// patches, which rounding may tell apart, are one and a surface has no cracks.
//
// Range      |coordinate| < 2^38 units
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "core/scene/mesh.h"

namespace zscope {

class Welder {
public:
    static constexpr double kBytesPerVertex = 80;  // of its own tables, beside the mesh

    explicit Welder(Mesh& mesh) : m_mesh(mesh) {}

    /// The vertex of the mesh at `p`, made if it is new.
    std::uint32_t vertexAt(const dvec3& p)
    {
        const auto onGrid = [](double x) { return static_cast<std::int64_t>(std::floor(x * 0x1p24 + 0.5)); };
        const Key  key{onGrid(p.x), onGrid(p.y), onGrid(p.z)};
        const auto [known, isNew] = m_numbers.try_emplace(key, static_cast<std::uint32_t>(m_mesh.positions.size()));
        const auto coordinate     = [&key](std::size_t k) { return static_cast<double>(key[k]) * 0x1p-24; };
        if (isNew) m_mesh.positions.push_back({coordinate(0), coordinate(1), coordinate(2)});
        return known->second;
    }

private:
    using Key = std::array<std::int64_t, 3>;
    struct Hash {
        std::size_t operator()(const Key& key) const
        {
            std::uint64_t mixed = 0;
            for (std::int64_t part : key) mixed = (mixed ^ static_cast<std::uint64_t>(part)) * 0x9E37'79B9'7F4A'7C15ull;
            return static_cast<std::size_t>(mixed ^ (mixed >> 32));
        }
    };

    Mesh&                                        m_mesh;
    std::unordered_map<Key, std::uint32_t, Hash> m_numbers;
};

}  // namespace zscope
