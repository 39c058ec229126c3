// How a picture is cut into stripes of whole lines, one per thread, so that all threads finish together.
//
// Idea       the borders move after every frame: the time a stripe took is spread evenly over its lines, and the next
//            borders give every stripe the same share of it
// Noise      a thread that was held up once says nothing of its lines: a border moves only to a side where two frames
//            in a row want it, half as far as the one that wants less
// Grid       borders lie on multiples of kStripeGrid lines, so that blocks and tiles of the picture belong to one
//            stripe
// Promise    stripes cover every line exactly once, in order; the picture does not depend on the borders
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace zscope {

inline constexpr int kStripeGrid = 8;

class StripeBorders {
public:
    struct Lines {
        int first, end;  // [first, end), possibly empty
    };

    /// Keeps the borders of the last frame if it had the same shape, else cuts evenly.
    void prepare(int height, int stripes)
    {
        if (height == m_height && stripes == count()) return;
        m_height = height;
        m_borders.resize(static_cast<std::size_t>(stripes) + 1);
        for (int i = 0; i <= stripes; ++i)
            m_borders[static_cast<std::size_t>(i)] = static_cast<int>(static_cast<long long>(height) * i / stripes);
        m_wanted.clear();
    }

    int   count() const { return static_cast<int>(m_borders.size()) - 1; }
    Lines stripe(int i) const { return {border(i), border(i + 1)}; }

    /// `ms` is what each stripe took.
    void rebalance(std::span<const double> ms)
    {
        double total = 0;
        for (const double one : ms) total += one;
        if (total <= 0 || ms.size() < 2) return;
        const double     share  = total / static_cast<double>(ms.size());
        std::vector<int> wanted = m_borders;
        double           done   = 0;  // time of the stripes before `from`
        std::size_t      from   = 0;
        for (std::size_t i = 1; i < ms.size(); ++i) {
            const double end = share * static_cast<double>(i);
            while (from + 1 < ms.size() && done + ms[from] < end) done += ms[from++];
            const Lines  lines = stripe(static_cast<int>(from));
            const double part  = ms[from] > 0 ? std::clamp((end - done) / ms[from], 0.0, 1.0) : 0;
            wanted[i]          = static_cast<int>(lines.first + part * (lines.end - lines.first) + 0.5);
        }
        if (m_wanted.empty()) m_wanted = wanted;  // of the first frame, nobody knows better
        for (std::size_t i = 1; i < ms.size(); ++i) {
            const auto [least, most] = std::minmax(m_wanted[i], wanted[i]);
            const int agreed         = std::clamp(m_borders[i], least, most);
            m_borders[i]             = std::max(m_borders[i - 1], m_borders[i] + (agreed - m_borders[i]) / 2);
        }
        m_wanted = std::move(wanted);
    }

private:
    /// On the grid, but for the last.
    int border(int i) const
    {
        if (i == count()) return m_height;
        return std::min(m_borders[static_cast<std::size_t>(i)] + kStripeGrid / 2, m_height) / kStripeGrid * kStripeGrid;
    }

    int              m_height = -1;
    std::vector<int> m_borders;  // stripes + 1 entries, ascending, from 0 to m_height, on the grid or not
    std::vector<int> m_wanted;   // by the last frame; empty: there was none
};

}  // namespace zscope
