#include "core/scene/obj/line_reader.h"

#include <cstring>
#include <limits>

#include "core/base/utf8.h"
#include "core/io/text_encoding.h"

namespace zscope::obj {

namespace {

/// First byte `wanted` in [from, to), or `to`.
std::size_t find(std::string_view bytes, char wanted, std::size_t from, std::size_t to)
{
    if (from >= to) return to;
    const void* at = std::memchr(bytes.data() + from, wanted, to - from);
    return at ? static_cast<std::size_t>(static_cast<const char*>(at) - bytes.data()) : to;
}

bool hasComment(std::string_view line)
{
    for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
        if (at == 0 || isBlank(line[at - 1])) return true;
    return false;
}

/// Where the backslash is that joins the next line to this one, or npos.
std::size_t joiningBackslash(std::string_view line)
{
    std::size_t end = line.size();
    while (end > 0 && isBlank(line[end - 1])) --end;
    if (end == 0 || line[end - 1] != '\\' || hasComment(line)) return std::string_view::npos;
    const bool mayBeHalf = end > 1 && static_cast<unsigned char>(line[end - 2]) >= 0x80 && !isUtf8(line);
    return mayBeHalf ? std::string_view::npos : end - 1;
}

}  // namespace

std::string_view LineReader::takeLine()
{
    const std::size_t begin = m_position;
    if (m_nextFeed <= begin && !(m_nextFeed == begin && begin < m_bytes.size() && m_bytes[begin] == '\n'))
        m_nextFeed = find(m_bytes, '\n', begin, m_bytes.size());
    const std::size_t end = find(m_bytes, '\r', begin, m_nextFeed);
    m_position            = end + 1 == m_nextFeed && end < m_nextFeed ? m_nextFeed + 1 : end + 1;
    if (m_position > m_bytes.size()) m_position = m_bytes.size();
    if (m_lines < std::numeric_limits<int>::max()) ++m_lines;
    std::string_view line = m_bytes.substr(begin, end - begin);
    while (line.starts_with(kUtf8Mark)) line.remove_prefix(kUtf8Mark.size());  // an empty file leaves only its mark
    return line;
}

bool LineReader::next()
{
    while (m_position < m_bytes.size()) {
        std::string_view line = takeLine();
        m_number              = m_lines;
        m_isJoined            = false;
        for (std::size_t end = joiningBackslash(line); end != std::string_view::npos; end = joiningBackslash(line)) {
            if (!m_isJoined) m_joined.clear();
            m_joined += line.substr(0, end);
            if (m_joined.size() > kMaxLineBytes) break;
            m_isJoined = true;
            m_joined += ' ';
            line = m_position < m_bytes.size() ? takeLine() : std::string_view{};
        }
        m_tooLong = line.size() + (m_isJoined ? m_joined.size() : 0) > kMaxLineBytes;
        if (m_tooLong) return false;
        if (m_isJoined) m_joined += line;
        m_text = withoutBlanks(m_isJoined ? std::string_view(m_joined) : line);
        if (!m_text.empty() && m_text.front() != '#') return true;
    }
    return false;
}

}  // namespace zscope::obj
