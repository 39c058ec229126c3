// An OBJ file as tinyobjloader is allowed to see it: one line at a time, with nothing in it that it reads wrongly.
//
// tinyobjloader tells the kinds of statements apart and calls back, in file order; what stands in a statement is read
// from current(), because its own numbers are rounded twice, its indices unchecked and its names cut. It therefore gets
// a stand-in for each:
//   v   "v "     f   "f 1"     mtllib   "mtllib N", N counting     g, o, usemtl   with "-" for a name
// Skipped    vn, vt, s: nothing here depends on them. Every other statement is counted by kind and left out
// Promise    the statement handed over last is current() until the next is asked for; after halt() the file ends
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <streambuf>
#include <string>
#include <string_view>

#include "core/scene/obj/line_reader.h"

namespace zscope::obj {

/// So many kinds of unknown statements are told apart; the rest is counted together.
inline constexpr std::size_t kMaxSkippedKinds = 16;

struct Statement {
    std::string_view arguments;  // what follows the first word, a comment included
    int              line     = 0;
    bool             isJoined = false;  // of more lines than one
};

class StatementStream : public std::streambuf {
public:
    struct Skipped {
        std::uint64_t count     = 0;
        int           firstLine = 0;
    };
    /// `keepGoing` is asked every kStatementsPerQuestion statements; false ends the file there.
    StatementStream(LineReader& lines, std::function<bool()> keepGoing);

    const Statement& current() const { return m_current; }
    void             halt() { m_halted = true; }

    const std::map<std::string, Skipped>& skipped() const { return m_skipped; }
    std::uint64_t                         skippedCount() const { return m_skippedCount; }
    /// What was thrown while reading, which an istream would have swallowed. The file ended there.
    std::exception_ptr failure() const { return m_failure; }

protected:
    int_type underflow() override;

private:
    static constexpr std::uint32_t kStatementsPerQuestion = 1024;

    bool nextStandIn();
    bool standIn(std::string_view word);
    void skip(std::string_view word);

    LineReader&                    m_lines;
    std::function<bool()>          m_keepGoing;
    Statement                      m_current;
    std::string                    m_handedOver;
    std::map<std::string, Skipped> m_skipped;
    std::uint64_t                  m_skippedCount = 0;
    std::uint64_t                  m_libraries    = 0;
    std::uint32_t                  m_sinceAsked   = 0;
    bool                           m_halted       = false;
    std::exception_ptr             m_failure;
};

}  // namespace zscope::obj
