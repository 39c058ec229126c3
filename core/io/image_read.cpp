#include "core/io/image_read.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "core/io/bytes.h"
#include "core/io/png_read.h"

namespace zscope {
namespace {

Error refused(std::string sentence, const std::string& file) { return {Trouble::Input, std::move(sentence), file}; }

Error otherSize(std::int64_t width, std::int64_t height, const std::string& file, int wantedWidth, int wantedHeight)
{
    return refused(fmt::format("the picture has {}x{} pixels, and the camera's has {}x{}", width, height, wantedWidth,
                               wantedHeight),
                   file);
}

/// The words of a PPM or PFM header: separated by blanks, comments left out.
class HeaderWords {
public:
    explicit HeaderWords(std::string_view bytes) : m_bytes(bytes) {}

    /// Empty at the end.
    std::string_view next()
    {
        while (m_at < m_bytes.size() && (isBlank(m_bytes[m_at]) || m_bytes[m_at] == '#')) {
            if (m_bytes[m_at] == '#')
                while (m_at < m_bytes.size() && m_bytes[m_at] != '\n') ++m_at;
            else
                ++m_at;
        }
        const std::size_t start = m_at;
        while (m_at < m_bytes.size() && !isBlank(m_bytes[m_at])) ++m_at;
        return m_bytes.substr(start, m_at - start);
    }
    /// A whole number from 0 on; -1 if the next word is none.
    std::int64_t number()
    {
        const std::string_view word  = next();
        std::int64_t           value = 0;
        const auto [end, ec]         = std::from_chars(word.data(), word.data() + word.size(), value);
        return ec == std::errc{} && !word.empty() && end == word.data() + word.size() && value >= 0 ? value : -1;
    }
    /// What stands behind the one blank after the header.
    std::string_view rest() const { return m_at < m_bytes.size() ? m_bytes.substr(m_at + 1) : std::string_view(); }

private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

    std::string_view m_bytes;
    std::size_t      m_at = 0;
};

Result<Grid<std::uint32_t>> ppmOf(std::string_view bytes, const std::string& file, int width, int height)
{
    HeaderWords        words(bytes);
    const bool         isText = words.next() == "P3";
    const std::int64_t w = words.number(), h = words.number(), most = words.number();
    if (w < 0 || h < 0 || most < 1 || most > 65535) return refused("the PPM's header cannot be read", file);
    if (w != width || h != height) return otherSize(w, h, file, width, height);

    Grid<std::uint32_t>    colours(width, height);
    const std::string_view data         = words.rest();
    const std::size_t      bytesPerPart = most > 255 ? 2 : 1;
    if (!isText && data.size() < colours.values().size() * 3 * bytesPerPart)
        return refused("the PPM ends before its last pixel", file);
    std::size_t at = 0;
    for (std::uint32_t& colour : colours.values())
        for (int part = 0; part < 3; ++part, at += bytesPerPart) {
            const std::int64_t value = isText              ? words.number()
                                       : bytesPerPart == 1 ? numberAt<std::uint8_t>(data, at, ByteOrder::Big)
                                                           : numberAt<std::uint16_t>(data, at, ByteOrder::Big);
            if (value < 0 || value > most)
                return refused("the PPM ends before its last pixel, or has a wrong one", file);
            colour = colour << 8 | static_cast<std::uint32_t>((value * 255 + most / 2) / most);
        }
    return colours;
}

Result<Grid<std::uint32_t>> bmpOf(std::string_view bytes, const std::string& file, int width, int height)
{
    constexpr std::size_t kHeaders = 54;
    if (bytes.size() < kHeaders) return refused("the BMP ends in its header", file);
    const auto         u32   = [&](std::size_t at) { return numberAt<std::uint32_t>(bytes, at, ByteOrder::Little); };
    const auto         u16   = [&](std::size_t at) { return numberAt<std::uint16_t>(bytes, at, ByteOrder::Little); };
    const std::size_t  start = u32(10), infoSize = u32(14);
    const std::int64_t w = static_cast<std::int32_t>(u32(18)), signedHeight = static_cast<std::int32_t>(u32(22));
    const std::size_t  bits = u16(28), compression = u32(30);
    if (infoSize < 40) return refused("the BMP's header cannot be read", file);
    const bool masksAreUsual = compression == 3 && bits == 32;  // 32 bits with masks: BGRA, as everyone writes it
    if ((compression != 0 && !masksAreUsual) || (bits != 8 && bits != 24 && bits != 32))
        return refused("of BMP only uncompressed 8, 24 and 32 bits can be read", file);
    if (w != width || std::abs(signedHeight) != height)
        return otherSize(w, std::abs(signedHeight), file, width, height);

    const std::size_t step = bits / 8, rowBytes = (static_cast<std::size_t>(width) * step + 3) / 4 * 4;
    if (start > bytes.size() || bytes.size() - start < rowBytes * static_cast<std::size_t>(height))
        return refused("the BMP ends before its last pixel", file);
    const std::size_t palette = 14 + infoSize;
    if (bits == 8 && palette + 256 * 4 > start) return refused("of BMP with 8 bits all 256 colours are needed", file);
    Grid<std::uint32_t> colours(width, height);
    for (int y = 0; y < height; ++y) {
        const int         line = signedHeight > 0 ? height - 1 - y : y;
        const std::size_t row  = start + static_cast<std::size_t>(line) * rowBytes;
        for (int x = 0; x < width; ++x) {
            std::size_t at = row + static_cast<std::size_t>(x) * step;
            if (bits == 8) at = palette + 4u * numberAt<std::uint8_t>(bytes, at, ByteOrder::Little);
            const auto part = [&](std::size_t i) -> std::uint32_t { return static_cast<unsigned char>(bytes[at + i]); };
            colours.at(x, y) = part(2) << 16 | part(1) << 8 | part(0);
        }
    }
    return colours;
}

}  // namespace

Result<Grid<std::uint32_t>> coloursOf(std::string_view bytes, const std::string& file, int width, int height)
{
    if (bytes.starts_with("\x89PNG")) {
        Grid<std::uint32_t> colours;
        const PngRead       read = readPng8(bytes, width, height, colours);
        if (read.isOtherSize()) return otherSize(read.width, read.height, file, width, height);
        if (!read.trouble.empty()) return refused("the PNG cannot be read: " + read.trouble, file);
        return colours;
    }
    if (bytes.starts_with("BM")) return bmpOf(bytes, file, width, height);
    if (bytes.starts_with("P3") || bytes.starts_with("P6")) return ppmOf(bytes, file, width, height);
    return refused("this is no PNG, BMP or PPM", file);
}

Result<Grid<std::uint16_t>> grey16Of(std::string_view bytes, const std::string& file, int width, int height)
{
    Grid<std::uint16_t> grey;
    const PngRead       read = readPngGrey16(bytes, width, height, grey);
    if (read.isOtherSize()) return otherSize(read.width, read.height, file, width, height);
    if (!read.trouble.empty()) return refused("the PNG cannot be read: " + read.trouble, file);
    return grey;
}

Result<Grid<float>> pfmOf(std::string_view bytes, const std::string& file, int width, int height)
{
    HeaderWords            words(bytes);
    const std::string_view kind = words.next();
    if (kind != "Pf" && kind != "PF") return refused("this is no PFM", file);
    const std::int64_t w = words.number(), h = words.number();
    const std::string  scaleWord(words.next());
    const double       scale = std::strtod(scaleWord.c_str(), nullptr);
    if (w < 0 || h < 0 || !(std::abs(scale) > 0)) return refused("the PFM's header cannot be read", file);
    if (w != width || h != height) return otherSize(w, h, file, width, height);
    const std::size_t      step = kind == "PF" ? 12 : 4;
    const std::string_view data = words.rest();
    if (data.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * step)
        return refused("the PFM does not hold as many numbers as its header says", file);
    const ByteOrder order = scale < 0 ? ByteOrder::Little : ByteOrder::Big;
    Grid<float>     values(width, height);
    std::size_t     at = 0;
    for (int y = height - 1; y >= 0; --y)  // the bottom line comes first
        for (int x = 0; x < width; ++x, at += step) values.at(x, y) = numberAt<float>(data, at, order);
    return values;
}

std::optional<std::string> pngTextOf(std::string_view bytes, std::string_view keyword)
{
    return readPngText(bytes, keyword);
}

}  // namespace zscope
