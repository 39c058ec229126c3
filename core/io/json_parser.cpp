// The grammar of RFC 8259, read once from front to back. Where the next character does not fit, strange() and the
// functions around it find the mistakes that people make often, and tell them by their names.
#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/base/memory.h"
#include "core/base/quotable.h"
#include "core/base/utf8.h"
#include "core/io/decimal.h"
#include "core/io/json_document.h"
#include "core/io/text_encoding.h"

namespace zscope {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$'; }

class JsonParser {
public:
    JsonParser(std::string_view text, const std::string& file, std::uint64_t limit, int firstLine)
        : m_text(text), m_file(file), m_limit(limit), m_line(firstLine)
    {}

    Result<JsonValue> read()
    {
        JsonValue root;
        skipBlanks();
        if (readValue(root)) {
            skipBlanks();
            if (atEnd()) return root;
            if (next() == ',')
                stray("nothing may follow the end of the document, no comma either");
            else
                strange("nothing may follow the end of the document");
        }
        return *std::move(m_error);
    }

private:
    /// A place in the text, for an error.
    struct Place {
        std::size_t at = 0, lineStart = 0;
        int         line = 0;
    };
    struct Container {
        char bracket = '{';
        int  line    = 0;
    };

    // All return false when there is an error.

    bool readValue(JsonValue& value)
    {
        m_bytes += 2 * sizeof(JsonValue::Member);  // vectors may hold twice what is in use while they grow
        if (!fits()) return false;
        value.line = m_line;
        if (atEnd()) return unclosed();
        switch (next()) {
            case '{':
                return readObject(value);
            case '[':
                return readArray(value);
            case '"':
                return readText(value.value.emplace<std::string>());
            case ']':
            case '}':
                if (m_comma && wasJust(*m_comma))
                    return wrongAt(*m_comma, fmt::format("no comma may stand before '{}'", next()));
                [[fallthrough]];
            case ',':
                return stray(fmt::format("a value is missing before '{}'", next()));
            default:
                return readWord(value);
        }
    }

    bool readObject(JsonValue& value)
    {
        if (!open()) return false;
        auto& members = value.value.emplace<JsonValue::Object>();
        skipBlanks();
        if (!takes('}')) {
            do {
                skipBlanks();
                JsonMember& member = members.emplace_back();
                if (!readKey(member.first)) return false;
                skipBlanks();
                if (!takes(':'))
                    return strange(fmt::format("a colon is missing after the key '{}'", quotable(member.first, 60)));
                skipBlanks();
                if (!readValue(member.second)) return false;
                skipBlanks();
            } while (takesComma());
            if (!takes('}')) return expectedEnd(']');
        }
        m_open.pop_back();
        return keysDiffer(members);
    }

    bool readArray(JsonValue& value)
    {
        if (!open()) return false;
        auto& values = value.value.emplace<JsonValue::Array>();
        skipBlanks();
        if (!takes(']')) {
            do {
                skipBlanks();
                if (!readValue(values.emplace_back())) return false;
                skipBlanks();
            } while (takesComma());
            if (!takes(']')) return expectedEnd('}');
        }
        m_open.pop_back();
        return true;
    }

    bool readKey(std::string& key)
    {
        if (!atEnd() && next() == '"') return readText(key);
        if (atEnd()) return unclosed();
        if (next() == '}' && m_comma && wasJust(*m_comma)) return wrongAt(*m_comma, "no comma may stand before '}'");
        if (isLetter(next())) return stray(fmt::format("the key '{}' needs double quotes", quotable(word(), 60)));
        const bool isDecimalComma =
            isDigit(next()) && m_comma && m_comma->at + 1 == m_at && m_at >= 2 && isDigit(m_text[m_at - 2]);
        if (isDecimalComma) return wrongAt(*m_comma, "a decimal has a point, not a comma");
        return strange("a key in double quotes must stand here");
    }

    bool readText(std::string& text)
    {
        const Place begin = here();
        for (++m_at;;) {
            const std::size_t plain = m_at;
            while (!atEnd() && next() != '"' && next() != '\\' && static_cast<unsigned char>(next()) - 0x20u < 0x60u)
                ++m_at;
            text += m_text.substr(plain, m_at - plain);
            if (atEnd() || next() == '\n' || next() == '\r')
                return wrongAt(begin, "the text that begins here has no closing double quote on its line");
            if (takes('"')) break;
            if (next() == '\\') {
                if (!readEscape(text)) return false;
                continue;
            }
            const auto character = firstCharacter(m_text.substr(m_at));
            if (!character)
                return stray(fmt::format("the byte 0x{:02X} is no UTF-8: save the file as UTF-8",
                                         static_cast<unsigned char>(next())));
            if (character->code < 0x20)
                return stray(fmt::format("inside of a text, {} is written \\u{:04x}", codeOf(character->code),
                                         static_cast<unsigned>(character->code)));
            text += m_text.substr(m_at, character->bytes);
            m_at += character->bytes;
        }
        m_bytes += text.size();
        return fits();
    }

    bool readEscape(std::string& text)
    {
        constexpr std::string_view kWritten = "\"\\/bfnrt", kMeant = "\"\\/\b\f\n\r\t";
        const char                 kind = m_at + 1 < m_text.size() ? m_text[m_at + 1] : '\0';
        if (const std::size_t found = kWritten.find(kind); found != std::string_view::npos) {
            text += kMeant[found];
            m_at += 2;
            return true;
        }
        if (kind != 'u') return stray("a backslash inside of a text is written twice");
        auto code = readUnit(m_at);
        if (!code) return stray("\\u needs four hexadecimal digits");
        const bool isFirst = *code >= 0xD800 && *code < 0xDC00;
        if (isFirst) {
            const auto second = readUnit(m_at + 6);
            code              = second && *second >= 0xDC00 && *second < 0xE000
                                    ? 0x10000 + ((*code - 0xD800) << 10) + (*second - 0xDC00)
                                    : 0xDC00;
        }
        if (*code >= 0xDC00 && *code < 0xE000) return stray("half of a surrogate pair is no character");
        m_at += isFirst ? 12 : 6;
        addUtf8(text, *code);
        return true;
    }

    /// The number in `\uXXXX` at this place.
    std::optional<char32_t> readUnit(std::size_t at) const
    {
        const std::string_view digits = at + 6 <= m_text.size() ? m_text.substr(at + 2, 4) : std::string_view{};
        unsigned               code   = 0;
        const auto             end    = digits.data() + digits.size();
        if (digits.empty() || m_text.substr(at, 2) != "\\u" || std::from_chars(digits.data(), end, code, 16).ptr != end
            || digits[0] == '-')
            return std::nullopt;
        return code;
    }

    static void addUtf8(std::string& text, char32_t code)
    {
        const auto add = [&text](char32_t byte) { text += static_cast<char>(byte); };
        if (code < 0x80) return add(code);
        if (code < 0x800) {
            add(0xC0 | code >> 6);
        } else if (code < 0x10000) {
            add(0xE0 | code >> 12);
            add(0x80 | (code >> 6 & 0x3F));
        } else {
            add(0xF0 | code >> 18);
            add(0x80 | (code >> 12 & 0x3F));
            add(0x80 | (code >> 6 & 0x3F));
        }
        add(0x80 | (code & 0x3F));
    }

    /// true, false, null or a number.
    bool readWord(JsonValue& value)
    {
        const std::string_view written = word();
        if (written == "true" || written == "false") {
            value.value = written == "true";
        } else if (written != "null") {
            return isNumber(written) ? readNumber(value, written) : noValue(written);
        }
        m_at += written.size();
        return true;
    }

    bool noValue(std::string_view written)
    {
        if (written.empty()) return strange("a value must stand here");
        std::string small(written.substr(written.find_first_not_of("+-") == 1 ? 1 : 0));
        for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const bool isLikeNumber =
            !isLetter(small.empty() ? '+' : small.front()) || small == "nan" || small == "inf" || small == "infinity";
        return stray(isLikeNumber ? fmt::format("'{}' is no number of JSON", quotable(written, 60))
                                  : fmt::format("'{}' is no value of JSON: a text stands in double quotes",
                                                quotable(written, 60)));
    }

    bool readNumber(JsonValue& value, std::string_view written)
    {
        const char* const end   = written.data() + written.size();
        std::int64_t      whole = 0;
        std::uint64_t     large = 0;
        double            real  = 0;
        m_at += written.size();
        const auto isAll = [end](const std::from_chars_result& read) {
            return read.ec == std::errc{} && read.ptr == end;
        };
        if (isAll(std::from_chars(written.data(), end, whole))) {
            value.value = whole;
        } else if (isAll(std::from_chars(written.data(), end, large))) {
            value.value = large;
        } else if (std::from_chars(written.data(), end, real).ec == std::errc{}) {
            value.value = real;
        } else if (roundsToZero(written)) {
            value.value = written.front() == '-' ? -0.0 : 0.0;
        } else {
            m_error =
                Error{Trouble::Input, fmt::format("the number {} is beyond the largest float64", quotable(written, 60)),
                      m_file, m_line};
            return false;
        }
        return true;
    }

    static bool isNumber(std::string_view text)
    {
        const auto digits = [&text] {
            const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
            text.remove_prefix(count);
            return count;
        };
        const auto takes = [&text](std::string_view any) {
            const bool is = !text.empty() && any.find(text.front()) != std::string_view::npos;
            if (is) text.remove_prefix(1);
            return is;
        };
        takes("-");
        if (!takes("0") && digits() == 0) return false;
        if (takes(".") && digits() == 0) return false;
        if (takes("eE")) {
            takes("+-");
            if (digits() == 0) return false;
        }
        return text.empty();
    }

    // What follows, and where.

    bool atEnd() const { return m_at == m_text.size(); }
    char next() const { return m_text[m_at]; }
    bool takes(char c)
    {
        const bool is = !atEnd() && next() == c;
        m_at += is;
        return is;
    }
    bool takesComma()
    {
        const Place place = here();
        if (!takes(',')) return false;
        m_comma = place;
        return true;
    }
    /// Whether nothing but blanks stands between a comma and this place.
    bool wasJust(const Place& comma) const
    {
        return m_text.substr(comma.at + 1, m_at - comma.at - 1).find_first_not_of(" \t\r\n") == std::string_view::npos;
    }
    void skipBlanks()
    {
        for (; !atEnd() && (next() == ' ' || next() == '\t' || next() == '\r' || next() == '\n'); ++m_at)
            if (next() == '\n') {
                ++m_line;
                m_lineStart = m_at + 1;
            }
    }
    /// What could be a word or a number, to its end.
    std::string_view word() const
    {
        std::size_t end = m_at;
        while (end < m_text.size()
               && (isLetter(m_text[end]) || isDigit(m_text[end]) || m_text[end] == '+' || m_text[end] == '-'
                   || m_text[end] == '.' || (m_text[end] == '#' && end > m_at && m_text[end - 1] == '.')))  // 1.#IND
            ++end;
        return m_text.substr(m_at, end - m_at);
    }
    Place here() const { return {m_at, m_lineStart, m_line}; }

    // What is wrong.

    bool wrongAt(const Place& place, std::string_view what)
    {
        int column = 1;
        for (std::size_t at = place.lineStart; at < place.at; ++column) {
            const auto character = firstCharacter(m_text.substr(at));
            at += character ? character->bytes : 1;
        }
        m_error =
            Error{Trouble::Input, fmt::format("this is not JSON at column {}: {}", column, what), m_file, place.line};
        return false;
    }
    bool stray(std::string_view what) { return wrongAt(here(), what); }

    bool unclosed()
    {
        if (m_open.empty()) return stray("the text ends before a value");
        return stray(fmt::format("the text ends before the '{}' of line {} is closed", m_open.back().bracket,
                                 m_open.back().line));
    }

    /// The next character fits nowhere, or not here, which is then what is said.
    bool strange(std::string_view otherwise)
    {
        if (atEnd()) return unclosed();
        if (next() == '/' || next() == '#') return stray("JSON has no comments");
        if (next() == '\'' || next() == '`') return stray("a text stands in double quotes, not in single ones");
        const auto character = firstCharacter(m_text.substr(m_at));
        if (!character)
            return stray(fmt::format("the byte 0x{:02X} is no UTF-8: save the file as UTF-8",
                                     static_cast<unsigned char>(next())));
        constexpr std::u32string_view kQuotes =
            U"\u2018\u2019\u201A\u201B\u201C\u201D\u201E\u201F\u00AB\u00BB\u300C\u300D\uFF02\uFF07";
        if (kQuotes.find(character->code) != std::u32string_view::npos)
            return stray("a text stands in straight double quotes, not in curly ones");
        if (isControl(character->code) || isInvisible(character->code))
            return stray(fmt::format("the character {} is no blank of JSON", codeOf(character->code)));
        return stray(otherwise);
    }

    /// After a value of an object or a list, where neither a comma nor its end follows.
    bool expectedEnd(char otherBracket)
    {
        if (!atEnd() && next() == otherBracket)
            return stray(fmt::format("'{}' does not close the '{}' of line {}", otherBracket, m_open.back().bracket,
                                     m_open.back().line));
        return strange("a comma is missing before this place");
    }

    bool open()
    {
        if (m_open.size() >= static_cast<std::size_t>(kMaxJsonDepth)) {
            m_error = Error{Trouble::Input, fmt::format("values are nested deeper than {} levels", kMaxJsonDepth),
                            m_file, m_line};
            return false;
        }
        m_open.push_back({next(), m_line});
        ++m_at;
        return true;
    }

    bool fits()
    {
        if (m_bytes <= m_limit) return true;
        m_error =
            Error{Trouble::Limit, fmt::format("the file holds more values than {} MiB of memory can", m_limit >> 20),
                  m_file, m_line};
        return false;
    }

    /// Sorted copies of the names find two equal ones in n log n, however many there are.
    bool keysDiffer(const JsonValue::Object& members)
    {
        std::vector<std::pair<std::string_view, int>> keys;
        keys.reserve(members.size());
        for (const JsonMember& member : members) keys.emplace_back(member.first, member.second.line);
        std::ranges::sort(keys);
        const auto twice = std::ranges::adjacent_find(keys, {}, &std::pair<std::string_view, int>::first);
        if (twice == keys.end()) return true;
        m_error =
            Error{Trouble::Input, fmt::format("the key '{}' is given twice in one object", quotable(twice->first, 60)),
                  m_file, std::next(twice)->second};
        return false;
    }

    std::string_view       m_text;
    const std::string&     m_file;
    std::uint64_t          m_limit, m_bytes = 0;
    std::size_t            m_at = 0, m_lineStart = 0;
    int                    m_line;
    std::optional<Place>   m_comma;  // the last one
    std::vector<Container> m_open;   // around the next value, outermost first
    std::optional<Error>   m_error;
};

}  // namespace

Result<JsonValue> parseJson(std::string_view text, const std::string& file, std::uint64_t memoryLimit, int firstLine)
{
    if (auto trouble = encodingTrouble(text)) return Error{Trouble::Input, *std::move(trouble), file};
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        return Error{Trouble::Input, "this is not JSON: it holds a zero byte", file,
                     static_cast<int>(
                         firstLine + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n'))};
    return JsonParser(withoutMark(text), file, effectiveMemoryLimit(memoryLimit), firstLine).read();
}

}  // namespace zscope
