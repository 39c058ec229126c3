#include "core/io/npy_read.h"

#include <charconv>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/io/bytes.h"

namespace zscope {
namespace {

struct Header {
    NpyNumbers                 numbers;
    ByteOrder                  order     = ByteOrder::Little;
    bool                       isFortran = false;
    std::vector<std::uint64_t> shape;
    std::size_t                dataStart = 0;
};

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

/// What stands behind 'key': in the header's dictionary, up to its end.
std::optional<std::string_view> behindKey(std::string_view dictionary, std::string_view key)
{
    for (const char quote : {'\'', '"'}) {
        const std::string word = quote + std::string(key) + quote;
        const std::size_t at   = dictionary.find(word);
        if (at == std::string_view::npos) continue;
        const std::string_view rest = trimmed(dictionary.substr(at + word.size()));
        if (rest.starts_with(':')) return trimmed(rest.substr(1));
    }
    return std::nullopt;
}

/// '<f4'
bool readDescription(std::string_view text, Header& header)
{
    if (text.empty() || (text[0] != '\'' && text[0] != '"')) return false;
    const std::size_t end = text.find(text[0], 1);
    if (end != 4) return false;
    const char order = text[1], kind = text[2], size = text[3];
    if (order != '<' && order != '>' && order != '|' && order != '=') return false;
    if (kind != 'f' && kind != 'i' && kind != 'u') return false;
    if (size != '1' && size != '2' && size != '4' && size != '8') return false;
    header.numbers = {kind, static_cast<std::size_t>(size - '0')};
    header.order   = order == '>' ? ByteOrder::Big : ByteOrder::Little;
    return kind != 'f' || size != '1';
}

/// (480, 640)
bool readShape(std::string_view text, std::vector<std::uint64_t>& shape)
{
    const std::size_t end = text.find(')');
    if (!text.starts_with('(') || end == std::string_view::npos) return false;
    text = text.substr(1, end - 1);
    while (!(text = trimmed(text)).empty()) {
        std::uint64_t side    = 0;
        const auto [next, ec] = std::from_chars(text.data(), text.data() + text.size(), side);
        if (ec != std::errc{} || shape.size() == 8) return false;
        shape.push_back(side);
        text.remove_prefix(static_cast<std::size_t>(next - text.data()));
        if (text.starts_with('L')) text.remove_prefix(1);
        text = trimmed(text);
        if (text.starts_with(','))
            text.remove_prefix(1);
        else if (!text.empty())
            return false;
    }
    return true;
}

Result<Header> headerOf(std::string_view bytes, const std::string& file)
{
    const auto refused = [&file](std::string sentence) { return Error{Trouble::Input, std::move(sentence), file}; };
    if (!bytes.starts_with("\x93NUMPY") || bytes.size() < 10) return refused("this is no NumPy array");
    const int version = static_cast<unsigned char>(bytes[6]);
    if (version < 1 || version > 3) return refused(fmt::format("NumPy's format {} is not known", version));
    const std::size_t fixed = version == 1 ? 10 : 12;
    if (bytes.size() < fixed) return refused("the NumPy array ends in its header");
    const std::size_t length = version == 1 ? numberAt<std::uint16_t>(bytes, 8, ByteOrder::Little)
                                            : numberAt<std::uint32_t>(bytes, 8, ByteOrder::Little);
    if (length > bytes.size() - fixed) return refused("the NumPy array ends in its header");

    Header                 header;
    const std::string_view dictionary = bytes.substr(fixed, length);
    const auto             descr = behindKey(dictionary, "descr"), fortran = behindKey(dictionary, "fortran_order"),
               shape = behindKey(dictionary, "shape");
    if (!descr || !fortran || !shape || !readShape(*shape, header.shape)
        || (!fortran->starts_with("True") && !fortran->starts_with("False")))
        return refused("the NumPy array's header cannot be read");
    if (!readDescription(*descr, header))
        return refused("the NumPy array holds neither floats nor integers of 8 to 64 bits");
    header.isFortran = fortran->starts_with("True");
    header.dataStart = fixed + length;
    return header;
}

std::string textOf(const std::vector<std::uint64_t>& shape)
{
    std::string text;
    for (const std::uint64_t side : shape) text += (text.empty() ? "" : ", ") + std::to_string(side);
    return "(" + text + ")";
}

double realAt(std::string_view bytes, std::size_t at, const Header& header)
{
    switch (header.numbers.bytes) {
        case 2:
            return halfOf(numberAt<std::uint16_t>(bytes, at, header.order));
        case 4:
            return numberAt<float>(bytes, at, header.order);
        default:
            return numberAt<double>(bytes, at, header.order);
    }
}

std::uint64_t unsignedAt(std::string_view bytes, std::size_t at, const Header& header)
{
    switch (header.numbers.bytes) {
        case 1:
            return numberAt<std::uint8_t>(bytes, at, header.order);
        case 2:
            return numberAt<std::uint16_t>(bytes, at, header.order);
        case 4:
            return numberAt<std::uint32_t>(bytes, at, header.order);
        default:
            return numberAt<std::uint64_t>(bytes, at, header.order);
    }
}

std::int64_t signedOf(std::uint64_t bits, std::size_t bytes)
{
    const int unused = static_cast<int>(64 - 8 * bytes);
    return static_cast<std::int64_t>(bits << unused) >> unused;
}

}  // namespace

Result<NpyGrid> npyGridOf(std::string_view bytes, const std::string& file, int width, int height)
{
    const Result<Header> header = headerOf(bytes, file);
    if (!header) return header.error();
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    if (header->shape != std::vector<std::uint64_t>{rows, columns})
        return Error{Trouble::Input,
                     fmt::format("the array's shape is {}, and the camera's picture is ({}, {})", textOf(header->shape),
                                 height, width),
                     file};
    const std::size_t size = header->numbers.bytes, wanted = rows * columns * size;
    const std::size_t held = bytes.size() - header->dataStart;
    if (held != wanted)
        return Error{Trouble::Input, fmt::format("the array holds {} bytes, and its header says {}", held, wanted),
                     file};

    NpyGrid    grid{.numbers = header->numbers, .reals = {}, .wholes = {}};
    const bool isFloat = grid.numbers.kind == 'f', isUnsigned = grid.numbers.kind == 'u';
    if (isFloat || isUnsigned) grid.reals.reset(width, height);
    if (!isFloat) grid.wholes.reset(width, height);
    constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x) {
            const std::size_t to = y * columns + x, from = header->isFortran ? x * rows + y : to;
            const std::size_t at = header->dataStart + from * size;
            if (isFloat) {
                grid.reals.values()[to] = realAt(bytes, at, *header);
                continue;
            }
            const std::uint64_t bits = unsignedAt(bytes, at, *header);
            grid.wholes.values()[to] =
                isUnsigned ? static_cast<std::int64_t>(std::min(bits, kMost)) : signedOf(bits, size);
            if (isUnsigned) grid.reals.values()[to] = static_cast<double>(bits);
        }
    return grid;
}

}  // namespace zscope
