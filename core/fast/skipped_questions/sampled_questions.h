// Whether questions of one kind are worth asking, by how those before them were answered.
//
// Nodes      with small triangles: a question takes as long as the look at all pixels under the triangles, which comes
//            later anyway (core/fast/hidden_squares/hidden_squares.h). It pays where nodes are often hidden: then it
//            spares a whole node, not one triangle
// Patches    of large triangles: a question takes as long as the set-up of some, and pays where patches are often
//            hidden
// Sampled    one in kSampled of those that are left out is asked all the same, so that the answers come to know what
//            lies farther back
// Promise    decides no pixel: what nobody asked about is drawn
// Cost       four numbers; deterministic for a given order of questions
#pragma once

#include <cstdint>

namespace zscope {

class SampledQuestions {
public:
    /// Answers that are waited for before any question is left out.
    static constexpr std::uint32_t kFirst = 32;
    /// Fewer hidden ones than one in so many are seldom (measured, docs/performance.md).
    static constexpr std::uint32_t kSeldom  = 6;
    static constexpr std::uint32_t kSampled = 8;

    /// `first`: answers that are waited for.
    explicit SampledQuestions(std::uint32_t first) : m_first(first) {}
    SampledQuestions() : SampledQuestions(kFirst) {}

    /// Whether the next question is to be asked.
    bool isWorthIt()
    {
        const bool areSeldomHidden = m_answers >= m_first && kSeldom * m_hidden < m_answers;
        return !areSeldomHidden || ++m_leftOut % kSampled == 0;
    }
    void answered(bool hidden) { ++m_answers, m_hidden += hidden; }

private:
    std::uint32_t m_first, m_answers = 0, m_hidden = 0, m_leftOut = 0;
};

}  // namespace zscope
