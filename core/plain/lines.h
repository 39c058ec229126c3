// The lines of the stripe, from top to bottom: for (const int y : LinesOf(work)) ...
//
// Replay     lines that a replayed run has swept before are left out
#pragma once

#include <iterator>

#include "core/plain/work.h"

namespace zscope::plain {

class LinesOf {
public:
    explicit LinesOf(Work& work) : m_work(work) {}

    class Iterator {
    public:
        Iterator(Work& work, int line) : m_work(work), m_line(line) { skip(); }
        int       operator*() const { return m_line; }
        Iterator& operator++()
        {
            ++m_line;
            skip();
            return *this;
        }
        bool operator==(std::default_sentinel_t) const
        {
            return m_line >= m_work.stripe.endRow || m_work.isCancelled();
        }

    private:
        void skip()
        {
            while (m_line < m_work.stripe.endRow && m_work.leavesOut(Checkpoint::Piece)) ++m_line;
        }

        Work& m_work;
        int   m_line;
    };
    Iterator                begin() { return {m_work, m_work.stripe.firstRow}; }
    std::default_sentinel_t end() const { return {}; }

private:
    Work& m_work;
};

}  // namespace zscope::plain
