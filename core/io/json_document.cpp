#include "core/io/json_document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/memory.h"
#include "core/base/quotable.h"

namespace zscope {

namespace {

std::string shown(std::string_view text) { return quotable(text, 60); }

/// Where the parser is in the text: it reads through CountingIterator, which tells this.
struct ReadPosition {
    int  line        = 1;
    bool justNewline = false;  // the last character handed out was a newline
};

class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type        = char;
    using difference_type   = std::ptrdiff_t;
    using pointer           = const char*;
    using reference         = const char&;

    CountingIterator(const char* at, ReadPosition* position) : m_at(at), m_position(position) {}

    const char&       operator*() const { return *m_at; }
    CountingIterator& operator++()
    {
        m_position->justNewline = *m_at == '\n';
        if (m_position->justNewline) ++m_position->line;
        ++m_at;
        return *this;
    }
    CountingIterator operator++(int)
    {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.m_at == b.m_at; }
    friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return !(a == b); }

private:
    const char*   m_at;
    ReadPosition* m_position;
};

/// Listens to the parser and builds the document; stops it by returning false with `trouble` set.
class Builder {
public:
    using number_integer_t  = nlohmann::json::number_integer_t;
    using number_unsigned_t = nlohmann::json::number_unsigned_t;
    using number_float_t    = nlohmann::json::number_float_t;
    using string_t          = nlohmann::json::string_t;
    using binary_t          = nlohmann::json::binary_t;

    Builder(const ReadPosition& position, const std::string& file, std::uint64_t limit)
        : m_position(position), m_file(file), m_limit(limit)
    {}

    JsonValue            root;
    std::optional<Error> trouble;

    bool null() { return add({}, m_position.line); }
    bool boolean(bool value) { return add(value, m_position.line); }
    // The parser must read one character past a number to know its end: a newline there is the next line's.
    int  lineOfNumber() const { return m_position.line - (m_position.justNewline ? 1 : 0); }
    bool number_integer(number_integer_t value) { return add(std::int64_t{value}, lineOfNumber()); }
    bool number_unsigned(number_unsigned_t value)
    {
        if (value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
            return add(static_cast<std::int64_t>(value), lineOfNumber());
        return add(std::uint64_t{value}, lineOfNumber());
    }
    bool number_float(number_float_t value, const string_t&) { return add(value, lineOfNumber()); }
    bool string(string_t& value)
    {
        m_bytes += value.size();
        return add(std::move(value), m_position.line);
    }
    bool binary(binary_t&) { return stop("binary values are not JSON"); }
    bool start_object(std::size_t) { return open(JsonValue::Object{}); }
    bool start_array(std::size_t) { return open(JsonValue::Array{}); }
    bool end_object()
    {
        // Sorted copies of the names find two equal ones in n log n, however many there are.
        const auto&                   members = std::get<JsonValue::Object>(m_open.back()->value);
        std::vector<std::string_view> names;
        names.reserve(members.size());
        for (const auto& member : members) names.push_back(member.first);
        std::ranges::sort(names);
        const auto twice = std::ranges::adjacent_find(names);
        if (twice != names.end()) return stop(fmt::format("the key '{}' is given twice in one object", shown(*twice)));
        return close();
    }
    bool end_array() { return close(); }
    bool key(string_t& name)
    {
        m_bytes += name.size();
        m_key = std::move(name);
        return true;
    }
    template <class Exception>
    bool parse_error(std::size_t, const std::string& lastToken, const Exception& trouble_)
    {
        if (trouble_.id == 406)
            return stop(fmt::format("the number {} is beyond the largest float64", shown(lastToken)));
        return stop("this is not JSON: " + clauseOf(trouble_.what()));
    }

private:
    bool add(decltype(JsonValue::value) value, int line)
    {
        m_bytes += 2 * sizeof(JsonValue::Member);  // vectors may hold twice what is in use while they grow
        if (m_bytes > m_limit)
            return stop(Trouble::Limit,
                        fmt::format("the file holds more values than {} MiB of memory can", m_limit >> 20));
        JsonValue* place = &root;
        if (!m_open.empty()) {
            if (auto* array = std::get_if<JsonValue::Array>(&m_open.back()->value))
                place = &array->emplace_back();
            else
                place = &std::get<JsonValue::Object>(m_open.back()->value)
                             .emplace_back(JsonMember{std::move(m_key), JsonValue{}})
                             .second;
        }
        place->value = std::move(value);
        place->line  = line;
        m_last       = place;
        return true;
    }
    bool open(decltype(JsonValue::value) container)
    {
        if (m_open.size() >= static_cast<std::size_t>(kMaxJsonDepth))
            return stop(fmt::format("values are nested deeper than {} levels", kMaxJsonDepth));
        if (!add(std::move(container), m_position.line)) return false;
        m_open.push_back(m_last);  // stays valid: its owner grows only after it is closed
        return true;
    }
    bool close()
    {
        m_open.pop_back();
        return true;
    }
    bool stop(std::string sentence) { return stop(Trouble::Input, std::move(sentence)); }
    bool stop(Trouble kind, std::string sentence)
    {
        if (!trouble) trouble = Error{kind, std::move(sentence), m_file, m_position.line};
        return false;
    }
    /// The parser's message without its own error number and position.
    static std::string clauseOf(std::string message)
    {
        if (const auto colon = message.find(": "); message.starts_with("[json.") && colon != std::string::npos)
            message.erase(0, colon + 2);
        if (const auto colon = message.find(": "); message.starts_with("parse error") && colon != std::string::npos)
            message.erase(0, colon + 2);
        if (message.size() > 200) message.resize(200);
        return message;
    }

    const ReadPosition&     m_position;
    const std::string&      m_file;
    std::uint64_t           m_limit;
    std::uint64_t           m_bytes = 0;
    std::vector<JsonValue*> m_open;  // the containers around the next value, outermost first
    JsonValue*              m_last = nullptr;
    std::string             m_key;
};

Error inputError(const JsonValue& value, const std::string& file, std::string sentence)
{
    return {Trouble::Input, std::move(sentence), file, value.line};
}

}  // namespace

Result<JsonValue> parseJson(std::string_view text, const std::string& file, std::uint64_t memoryLimit, int firstLine)
{
    ReadPosition position{.line = firstLine};
    Builder      builder(position, file, effectiveMemoryLimit(memoryLimit));
    const char*  begin = text.data();
    // The parser would take it for the end.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        return Error{Trouble::Input, "this is not JSON: it holds a zero byte", file,
                     static_cast<int>(firstLine + std::count(begin, begin + zero, '\n'))};
    const bool read = nlohmann::json::sax_parse(CountingIterator(begin, &position),
                                                CountingIterator(begin + text.size(), &position), &builder);
    if (builder.trouble) return *std::move(builder.trouble);
    if (!read) return Error{Trouble::Input, "this is not JSON", file, position.line};
    return std::move(builder.root);
}

Result<double> realFromText(std::string_view text)
{
    const auto wrong = [text] {
        return Error{Trouble::Input,
                     fmt::format("'{}' is not a number: write a decimal, a C hex float, or inf", shown(text))};
    };
    std::string_view digits   = text;
    const bool       negative = digits.starts_with('-');
    if (negative || digits.starts_with('+')) digits.remove_prefix(1);
    if (digits == "inf") {
        const double infinity = std::numeric_limits<double>::infinity();
        return negative ? -infinity : infinity;
    }
    const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
    if (hex) digits.remove_prefix(2);
    const auto isDigit = [hex](char c) {
        return (c >= '0' && c <= '9') || c == '.' || (hex && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')));
    };
    if (digits.empty() || !isDigit(digits.front())) return wrong();  // no second sign, no "nan"

    double     value = 0;
    const auto end   = digits.data() + digits.size();
    const auto answer =
        std::from_chars(digits.data(), end, value, hex ? std::chars_format::hex : std::chars_format::general);
    if (answer.ec == std::errc::result_out_of_range)
        return Error{Trouble::Input, fmt::format("the number '{}' is beyond the range of float64", shown(text))};
    if (answer.ec != std::errc{} || answer.ptr != end) return wrong();
    return negative ? -value : value;
}

Result<double> realOf(const JsonValue& value, const std::string& file, std::string_view what)
{
    if (const auto* real = std::get_if<double>(&value.value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value.value)) return static_cast<double>(*whole);
    if (const auto* large = std::get_if<std::uint64_t>(&value.value)) return static_cast<double>(*large);
    if (const auto* text = value.text()) {
        Result<double> real = realFromText(*text);
        if (!real) return inputError(value, file, fmt::format("'{}': {}", what, real.error().sentence));
        return real;
    }
    return inputError(value, file, fmt::format("'{}' must be a number", what));
}

Result<std::int64_t> wholeOf(const JsonValue& value, const std::string& file, std::string_view what, std::int64_t min,
                             std::int64_t max)
{
    const auto* whole = std::get_if<std::int64_t>(&value.value);
    if (!whole || *whole < min || *whole > max)
        return inputError(value, file, fmt::format("'{}' must be a whole number from {} to {}", what, min, max));
    return *whole;
}

std::string quoted(std::string_view text)
{
    return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace zscope
