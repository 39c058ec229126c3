#include "core/scene/obj/statement_stream.h"

#include <utility>

#include "core/base/quotable.h"

namespace zscope::obj {

StatementStream::StatementStream(LineReader& lines, std::function<bool()> keepGoing)
    : m_lines(lines), m_keepGoing(std::move(keepGoing))
{}

StatementStream::int_type StatementStream::underflow()
{
    try {
        if (nextStandIn()) {
            m_handedOver += '\n';
            setg(m_handedOver.data(), m_handedOver.data(), m_handedOver.data() + m_handedOver.size());
            return traits_type::to_int_type(m_handedOver.front());
        }
    } catch (...) {
        m_failure = std::current_exception();
    }
    m_halted = true;
    setg(nullptr, nullptr, nullptr);
    return traits_type::eof();
}

/// Reads on to the next statement that tinyobjloader is to see.
bool StatementStream::nextStandIn()
{
    while (!m_halted) {
        if (++m_sinceAsked >= kStatementsPerQuestion) {
            m_sinceAsked = 0;
            if (!m_keepGoing()) return false;
        }
        if (!m_lines.next()) return false;
        std::string_view       rest = m_lines.text();
        const std::string_view word = takeWord(rest);
        m_current                   = {rest, m_lines.number(), m_lines.isJoined()};
        if (standIn(word)) return true;
    }
    return false;
}

/// Puts into m_handedOver what tinyobjloader gets for the current statement; false if that is nothing.
bool StatementStream::standIn(std::string_view word)
{
    if (word == "v") {
        m_handedOver = "v ";
    } else if (word == "f") {
        m_handedOver = "f 1";
    } else if (word == "g" || word == "o" || word == "usemtl") {
        m_handedOver = std::string(word) + " -";
    } else if (word == "mtllib") {
        m_handedOver = "mtllib " + std::to_string(++m_libraries);
    } else {
        if (word != "vn" && word != "vt" && word != "s") skip(word);
        return false;
    }
    return true;
}

void StatementStream::skip(std::string_view word)
{
    ++m_skippedCount;
    std::string kind = quotable(word);
    if (!m_skipped.contains(kind) && m_skipped.size() >= kMaxSkippedKinds) kind.clear();  // "" gathers the others
    Skipped& entry = m_skipped[kind];
    if (entry.count++ == 0) entry.firstLine = m_current.line;
}

}  // namespace zscope::obj
