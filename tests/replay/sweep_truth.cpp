#include "tests/replay/sweep_truth.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace zscope::tests {

namespace {

Wide floorOf(Wide value, Wide by)
{
    const Wide quotient = value / by;
    return value % by < 0 ? quotient - 1 : quotient;
}

constexpr std::int64_t kGuard = std::int64_t{1} << 24;

bool reachesBeyondGuard(const definition::Part& part)
{
    return std::ranges::any_of(
        part.corners(), [](const definition::Corner& c) { return std::abs(c.xs) > kGuard || std::abs(c.ys) > kGuard; });
}

/// First i with 256 i + 128 >= s.
std::int64_t firstCentreFrom(std::int64_t s) { return static_cast<std::int64_t>(-floorOf(-(Wide{s} - 128), 256)); }

Wide greatestCommonDivisor(Wide a, Wide b)
{
    if (a < 0) a = -a;
    while (b != 0) {
        const Wide rest = a % b;
        a               = b;
        b               = rest;
    }
    return a;
}

}  // namespace

double TrueEdge::pixels() const
{
    return (static_cast<double>(xFloor) + static_cast<double>(over) / static_cast<double>(height)) / 256;
}

bool TrueEdge::isNotRightOf(const TrueEdge& other) const
{
    if (xFloor != other.xFloor) return xFloor < other.xFloor;
    return over * other.height <= other.over * height;  // heights below 2^62: fits
}

SweepTruth::SweepTruth(const Scene& scene, const Camera& camera, FaceCulling faceCulling) : m_camera(camera)
{
    const definition::View        view(camera, faceCulling);
    std::vector<definition::Part> parts;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const auto count = static_cast<std::uint32_t>(scene.meshOf(InstanceId{i}).triangles.size());
        for (std::uint32_t t = 0; t < count; ++t) {
            definition::partsOf(scene, InstanceId{i}, t, view, parts);
            for (const definition::Part& part : parts) {
                const auto& [a, b, c] = part.corners();
                const Box box{std::max<std::int64_t>(0, firstCentreFrom(std::min({a.xs, b.xs, c.xs}))),
                              std::min<std::int64_t>(camera.width, firstCentreFrom(std::max({a.xs, b.xs, c.xs}))),
                              std::max<std::int64_t>(0, firstCentreFrom(std::min({a.ys, b.ys, c.ys}))),
                              std::min<std::int64_t>(camera.height, firstCentreFrom(std::max({a.ys, b.ys, c.ys})))};
                if (box.x0 < box.x1 && box.y0 < box.y1) m_parts.push_back({scene.firstTriangle[i] + t, part, box});
            }
        }
    }
}

std::vector<TrueEdge> SweepTruth::activeOn(int y) const
{
    const Wide            centre = Wide{256} * y + 128;
    std::vector<TrueEdge> active;
    for (const Member& member : m_parts) {
        for (std::size_t side = 0; side < 3; ++side) {
            const definition::Corner* top    = &member.part.corners()[side];
            const definition::Corner* bottom = &member.part.corners()[(side + 1) % 3];
            if (bottom->ys < top->ys) std::swap(top, bottom);
            if (!(top->ys <= centre && centre < bottom->ys)) continue;
            const Wide dx = Wide{bottom->xs} - top->xs, dy = Wide{bottom->ys} - top->ys;
            const Wide run    = dx * (centre - top->ys);
            const Wide common = greatestCommonDivisor(dx, dy);
            TrueEdge   edge{.polygon = member.polygon};
            edge.xFloor        = static_cast<std::int64_t>(top->xs + floorOf(run, dy));
            edge.over          = run - floorOf(run, dy) * dy;
            edge.height        = dy;
            edge.dxNumerator   = static_cast<std::int64_t>(dx / common);
            edge.dxDenominator = static_cast<std::int64_t>(dy / common);
            edge.firstLine     = static_cast<int>(std::max<std::int64_t>(0, firstCentreFrom(top->ys)));
            edge.lastLine = static_cast<int>(std::min<std::int64_t>(m_camera.height, firstCentreFrom(bottom->ys)) - 1);
            edge.isWide   = reachesBeyondGuard(member.part);
            active.push_back(edge);
        }
    }
    return active;
}

CoverOfLine SweepTruth::coverOf(int y) const
{
    CoverOfLine cover;
    for (const Member& member : m_parts) {
        if (y < member.box.y0 || y >= member.box.y1) continue;
        for (auto x = static_cast<int>(member.box.x0); x < member.box.x1; ++x)
            if (member.part.covers(x, y)) ++cover[member.polygon][x];
    }
    return cover;
}

}  // namespace zscope::tests
