// Warnings about one import, kept to a number that a person can read.
//
// Limit      the first kMaxWarnings stay; the rest is counted, and the last entry then says "and N more"
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/result.h"

namespace zscope::obj {

inline constexpr std::size_t kMaxWarnings = 100;

class WarningList {
public:
    bool isFull() const { return m_kept.size() >= kMaxWarnings; }

    /// `sentence` is a function, so that nothing is spelled out that nobody will read.
    template <class Sentence>
    void add(const std::string& file, int line, const Sentence& sentence)
    {
        ++m_count;
        if (!isFull()) m_kept.push_back({file, line, sentence()});
    }
    /// Says another sentence for one of kept().
    void          replace(std::size_t at, std::string sentence) { m_kept[at].sentence = std::move(sentence); }
    std::uint64_t count() const { return m_count; }
    const std::vector<Warning>& kept() const { return m_kept; }

    /// Those kept, then `summaries`, then what was left out.
    std::vector<Warning> finish(const std::string& file, std::vector<Warning> summaries) &&
    {
        const std::uint64_t more = m_count - m_kept.size();
        for (Warning& summary : summaries) m_kept.push_back(std::move(summary));
        if (more > 0) m_kept.push_back({file, 0, fmt::format("and {} more warnings", more)});
        return std::move(m_kept);
    }

private:
    std::vector<Warning> m_kept;
    std::uint64_t        m_count = 0;
};

}  // namespace zscope::obj
