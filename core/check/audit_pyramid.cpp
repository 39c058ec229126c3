#include <algorithm>
#include <array>

#include "core/check/audit.h"

namespace zscope::check {
namespace {

/// Cells [x0, x1) x [y0, y1) of the level below that a cell stands for. A last cell takes what a rounded-down half leaves.
struct Children {
    int x0, y0, x1, y1;
};

std::pair<int, int> childrenAlong(int at, int size, int below)
{
    const int first = std::min(2 * at, below - 1);
    return {first, at + 1 == size ? below : std::min(2 * at + 2, below)};
}

Children childrenOf(const Grid<double>& level, const Grid<double>& below, int x, int y)
{
    const auto [x0, x1] = childrenAlong(x, level.width(), below.width());
    const auto [y0, y1] = childrenAlong(y, level.height(), below.height());
    return {x0, y0, x1, y1};
}

/// The farthest of the children for each cell: what a right level holds at least as far.
Grid<double> farthestOf(const Grid<double>& level, const Grid<double>& below)
{
    Grid<double> right(level.width(), level.height());
    for (int y = 0; y < level.height(); ++y)
        for (int x = 0; x < level.width(); ++x) {
            const Children c        = childrenOf(level, below, x, y);
            double         farthest = below.at(c.x0, c.y0);
            for (int v = c.y0; v < c.y1; ++v)
                for (int u = c.x0; u < c.x1; ++u) farthest = std::min(farthest, below.at(u, v));
            right.at(x, y) = farthest;
        }
    return right;
}

/// Counts how many wrong cells each cause would have given the value that they have. Cells that are right for the cells
/// below them, which are wrong, have no cause of their own.
class Causes {
public:
    void count(const Grid<double>& level, const Grid<double>& below, const Grid<double>& right, int x, int y)
    {
        const double   value   = level.at(x, y);
        const Children c       = childrenOf(level, below, x, y);
        double         nearest = below.at(c.x0, c.y0);
        for (int v = c.y0; v < c.y1; ++v)
            for (int u = c.x0; u < c.x1; ++u) nearest = std::max(nearest, below.at(u, v));
        ++m_wrong;
        m_nearest += value == nearest;
        const bool isLastColumn = x + 1 == level.width() && below.width() % 2 == 1;
        const bool isLastRow    = y + 1 == level.height() && below.height() % 2 == 1;
        m_padded += isLastColumn || isLastRow;
        for (int v = 0; v < 2; ++v)
            for (int u = 0; u < 2; ++u)
                m_finer[static_cast<std::size_t>(2 * v + u)] +=
                    value == below.at(std::min(2 * x + u, below.width() - 1), std::min(2 * y + v, below.height() - 1));
        for (int v = -1; v <= 1; ++v)
            for (int u = -1; u <= 1; ++u) {
                const int sx = std::clamp(x + u, 0, level.width() - 1), sy = std::clamp(y + v, 0, level.height() - 1);
                m_shifted[static_cast<std::size_t>(3 * (v + 1) + u + 1)] += value == right.at(sx, sy);
            }
    }

    PyramidCause best() const
    {
        const auto explains = [this](std::uint64_t cells) { return cells * 20 >= m_wrong * 19; };
        if (explains(m_padded)) return PyramidCause::OddPadded;
        if (std::ranges::any_of(m_shifted, explains)) return PyramidCause::LevelShifted;
        if (std::ranges::any_of(m_finer, explains)) return PyramidCause::LevelTooFine;
        if (explains(m_nearest)) return PyramidCause::NearestInCells;
        return PyramidCause::Unknown;
    }

private:
    std::uint64_t                m_wrong = 0, m_nearest = 0, m_padded = 0;
    std::array<std::uint64_t, 4> m_finer{};    // the value of this one of the four cells below
    std::array<std::uint64_t, 9> m_shifted{};  // the right value of the neighbour there
};

}  // namespace

std::string_view wordOf(PyramidCause cause)
{
    constexpr std::array<std::string_view, 5> kWords{"nearest-in-cells", "odd-padded", "level-shifted",
                                                     "level-too-fine", "unknown"};
    return kWords[static_cast<std::size_t>(cause)];
}

bool isHalfOf(int size, int below) { return size == (below + 1) / 2 || size == std::max(1, below / 2); }

PyramidJudgement auditPyramid(const std::vector<Grid<double>>& levels)
{
    PyramidJudgement judgement;
    Causes           causes;
    // The farthest pixel below each cell, level by level, from the pixels themselves.
    Grid<double> truth = levels.empty() ? Grid<double>() : levels.front();
    for (std::size_t l = 1; l < levels.size(); ++l) {
        const Grid<double>& level = levels[l];
        const Grid<double>  right = farthestOf(level, truth), own = farthestOf(level, levels[l - 1]);
        for (int y = 0; y < level.height(); ++y)
            for (int x = 0; x < level.width(); ++x) {
                ++judgement.cells;
                if (level.at(x, y) <= right.at(x, y)) continue;  // else, and where it is NaN
                ++judgement.wrongCells;
                if (!(level.at(x, y) <= own.at(x, y))) causes.count(level, levels[l - 1], own, x, y);
                if (judgement.wrong.size() < PyramidJudgement::kMostWrongCells)
                    judgement.wrong.push_back({static_cast<int>(l), x, y, level.at(x, y), right.at(x, y)});
            }
        truth = right;
    }
    if (judgement.wrongCells > 0) judgement.cause = causes.best();
    return judgement;
}

}  // namespace zscope::check
