// Whether nodes whose triangles are small are worth a question each, by how the questions before them were answered.
//
// Idea       a question about a node takes as long as a look at all pixels under its triangles, which comes later anyway where they are so small
//            (core/depth/hidden_squares.h). It pays where nodes are often hidden: all of a node is spared then, not one triangle after another
// Sampled    one in kSampled of those that are left out is asked all the same, so that the answers come to know what lies farther back
// Promise    decides no pixel: a node that nobody asked about is drawn
// Cost       three numbers; deterministic for a given order of nodes
#pragma once

#include <cstdint>

namespace zscope {

class DenseQuestions {
public:
    /// Answers that are waited for before any question is left out.
    static constexpr std::uint32_t kFirst = 32;
    /// Fewer hidden ones than one in so many are seldom (measured, docs/performance.md).
    static constexpr std::uint32_t kSeldom  = 6;
    static constexpr std::uint32_t kSampled = 8;

    /// Whether the next node is to be asked about.
    bool isWorthIt()
    {
        const bool areSeldomHidden = m_answers >= kFirst && kSeldom * m_hidden < m_answers;
        return !areSeldomHidden || ++m_leftOut % kSampled == 0;
    }
    void answered(bool hidden) { ++m_answers, m_hidden += hidden; }

private:
    std::uint32_t m_answers = 0, m_hidden = 0, m_leftOut = 0;
};

}  // namespace zscope
