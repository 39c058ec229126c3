// The lines of an OBJ or MTL file as statements: joined where a backslash says so, comments and blank lines left out.
//
// Ends       LF, CR LF and a lone CR all end a line; a byte order mark (UTF-8) at the start of a line is passed over,
//            since files are joined by appending one to the other
// Blanks     space, tab, vertical tab, form feed
// Joining    a backslash that ends a line, blanks after it aside, joins the next one, with a blank in between; not
//            behind a '#' that follows a blank, and not where it may be the second byte of a character: in Shift-JIS,
//            GBK and Big5, names may end in 0x5C
// Comments   a line that begins with '#'. A '#' further on stays, as it may belong to a name: each statement decides
// Promise    one pass, no copy but of joined lines; a statement is at most kMaxLineBytes long
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace zscope::obj {

/// Longest statement that is read, joined lines together: room for a face of two million corners.
inline constexpr std::size_t kMaxLineBytes = std::size_t{64} << 20;

class LineReader {
public:
    explicit LineReader(std::string_view bytes) : m_bytes(bytes) {}

    /// Moves to the next statement that is not blank. False at the end, or when one is too long.
    bool next();

    std::string_view text() const { return m_text; }          // without blanks at either end; valid until next()
    int              number() const { return m_number; }      // of the line where the statement starts, from 1
    bool             isJoined() const { return m_isJoined; }  // of more lines than one
    bool             tooLong() const { return m_tooLong; }
    std::size_t      position() const { return m_position; }  // bytes passed

private:
    std::string_view takeLine();

    std::string_view m_bytes;
    std::size_t      m_position = 0;
    std::size_t      m_nextFeed = 0;  // position of the next LF at or after m_position, or the end; 0: not known
    int              m_lines    = 0;  // taken
    int              m_number   = 0;
    bool             m_tooLong  = false;
    bool             m_isJoined = false;
    std::string_view m_text;
    std::string      m_joined;
};

inline bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Takes the next word off the front of `rest`; empty when there is none.
inline std::string_view takeWord(std::string_view& rest)
{
    std::size_t begin = 0;
    while (begin < rest.size() && isBlank(rest[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest.size() && !isBlank(rest[end])) ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

inline std::string_view withoutBlanks(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

}  // namespace zscope::obj
