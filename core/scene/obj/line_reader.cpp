#include "core/scene/obj/line_reader.h"

#include <cstring>
#include <limits>

namespace zscope::obj {

namespace {

/// First byte `wanted` in [from, to), or `to`.
std::size_t find(std::string_view bytes, char wanted, std::size_t from, std::size_t to)
{
    if (from >= to) return to;
    const void* at = std::memchr(bytes.data() + from, wanted, to - from);
    return at ? static_cast<std::size_t>(static_cast<const char*>(at) - bytes.data()) : to;
}

/// Where the comment of a line starts, or its length.
std::size_t commentStart(std::string_view line)
{
    for (std::size_t at = find(line, '#', 0, line.size()); at < line.size(); at = find(line, '#', at + 1, line.size()))
        if (at == 0 || isBlank(line[at - 1])) return at;
    return line.size();
}

}  // namespace

std::optional<std::string> encodingTrouble(std::string_view bytes)
{
    const auto startsWith = [&](std::string_view mark) { return bytes.substr(0, mark.size()) == mark; };
    const bool isMarked   = startsWith("\xFF\xFE") || startsWith("\xFE\xFF");
    const bool isUnmarked = bytes.size() >= 4
                            && ((bytes[0] == 0 && bytes[2] == 0 && bytes[1] != 0 && bytes[3] != 0)
                                || (bytes[1] == 0 && bytes[3] == 0 && bytes[0] != 0 && bytes[2] != 0));
    if (!isMarked && !isUnmarked) return std::nullopt;
    return "the text is UTF-16; save it as UTF-8 or plain ASCII";
}

LineReader::LineReader(std::string_view bytes) : m_bytes(bytes)
{
    if (m_bytes.substr(0, 3) == "\xEF\xBB\xBF") m_position = 3;
}

std::string_view LineReader::takeLine()
{
    const std::size_t begin = m_position;
    if (m_nextFeed <= begin && !(m_nextFeed == begin && begin < m_bytes.size() && m_bytes[begin] == '\n'))
        m_nextFeed = find(m_bytes, '\n', begin, m_bytes.size());
    const std::size_t end = find(m_bytes, '\r', begin, m_nextFeed);
    m_position            = end + 1 == m_nextFeed && end < m_nextFeed ? m_nextFeed + 1 : end + 1;
    if (m_position > m_bytes.size()) m_position = m_bytes.size();
    if (m_lines < std::numeric_limits<int>::max()) ++m_lines;
    return m_bytes.substr(begin, end - begin);
}

bool LineReader::next()
{
    while (m_position < m_bytes.size()) {
        std::string_view line   = takeLine();
        bool             joined = false;
        m_number                = m_lines;
        while (true) {
            if (line.size() + (joined ? m_joined.size() : 0) > kMaxLineBytes) {
                m_tooLong = true;
                return false;
            }
            const std::size_t comment   = commentStart(line);
            const bool        continues = comment == line.size() && !line.empty() && line.back() == '\\';
            line                        = line.substr(0, continues ? line.size() - 1 : comment);
            if (continues && !joined) {
                m_joined.clear();
                joined = true;
            }
            if (joined) m_joined += line;
            if (!continues || m_position >= m_bytes.size()) break;
            m_joined += ' ';
            line = takeLine();
        }
        m_text = withoutBlanks(joined ? std::string_view(m_joined) : line);
        if (!m_text.empty()) return true;
    }
    return false;
}

}  // namespace zscope::obj
