#include "core/io/png.h"

#include <algorithm>
#include <deque>
#include <new>
#include <string_view>

#include <omp.h>
#include <zlib.h>

#include "core/io/file_writer.h"

namespace zscope {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kLevel    = 6;    // of zlib
constexpr int kRawBits  = -15;  // a window of 32 KiB, and neither zlib's header nor its checksum around the bytes
constexpr int kMemLevel = 8;    // zlib's own default

bool isOpaque(GridView<const std::uint32_t> argb)
{
    for (int y = 0; y < argb.height; ++y) {
        std::uint32_t common = ~0u;  // bits that are set in every colour of the row: without a branch per pixel
        for (const std::uint32_t c : argb.row(y)) common &= c;
        if (common >> 24 != 0xFF) return false;
    }
    return true;
}

/// What is subtracted from a byte before compression: nothing, or the byte above it. The numbers are PNG's.
enum class Filter : std::uint8_t { None = 0, Up = 2 };

/// Rows of at most so many bytes are not filtered. Pictures here are flat areas, text and lines: zlib finds the rows
/// above in its window as long as several of them fit, and compresses better than behind any filter.
constexpr std::size_t kPlainRowBytes = 8192;

/// One thread's work: rows of pixels in, compressed bytes out.
class StripEncoder {
public:
    StripEncoder(GridView<const std::uint32_t> argb, bool alpha, int rows)
        : m_argb(argb), m_bytesPerPixel(alpha ? 4 : 3),
          m_rowBytes(m_bytesPerPixel * static_cast<std::size_t>(argb.width)), m_row(m_rowBytes), m_above(m_rowBytes),
          m_strip((1 + m_rowBytes) * static_cast<std::size_t>(rows))
    {
        if (deflateInit2(&m_stream, kLevel, Z_DEFLATED, kRawBits, kMemLevel, Z_DEFAULT_STRATEGY) != Z_OK)
            throw std::bad_alloc();
        constexpr std::size_t kFlush = 16;  // deflateBound() does not count the end of a strip
        m_compressed.resize(deflateBound(&m_stream, m_strip.size()) + kFlush);
    }
    ~StripEncoder() { deflateEnd(&m_stream); }
    StripEncoder(const StripEncoder&)            = delete;
    StripEncoder& operator=(const StripEncoder&) = delete;

    /// Rows [first, end).
    void encode(int first, int end)
    {
        std::fill(m_above.begin(), m_above.end(), std::uint8_t{0});
        if (first > 0) pack(first - 1, m_above);
        std::uint8_t* to = m_strip.data();
        for (int y = first; y < end; ++y) to = addRow(y, to);
        const auto size = static_cast<std::size_t>(to - m_strip.data());
        m_checksum      = adler32_z(adler32(0, nullptr, 0), m_strip.data(), size);
        m_size          = size;

        deflateReset(&m_stream);
        m_stream.next_in   = m_strip.data();
        m_stream.avail_in  = static_cast<uInt>(size);
        m_stream.next_out  = m_compressed.data();
        m_stream.avail_out = static_cast<uInt>(m_compressed.size());
        deflate(&m_stream, end == m_argb.height ? Z_FINISH : Z_SYNC_FLUSH);
        assert(m_stream.avail_in == 0 && m_stream.avail_out > 0);
    }

    // Of the last strip.
    std::size_t      size() const { return m_size; }          // before compression
    uLong            checksum() const { return m_checksum; }  // Adler-32, of the same bytes
    std::string_view compressed() const
    {
        return {reinterpret_cast<const char*>(m_compressed.data()), m_compressed.size() - m_stream.avail_out};
    }

private:
    /// Row y in the order of the file.
    void pack(int y, Bytes& row) const
    {
        const std::size_t step = m_bytesPerPixel;
        std::uint8_t*     to   = row.data();
        for (const std::uint32_t c : m_argb.row(y)) {
            to[0] = static_cast<std::uint8_t>(c >> 16);
            to[1] = static_cast<std::uint8_t>(c >> 8);
            to[2] = static_cast<std::uint8_t>(c);
            if (step == 4) to[3] = static_cast<std::uint8_t>(c >> 24);
            to += step;
        }
    }

    /// Row y as its filter leaves it, written to `to`; its end.
    std::uint8_t* addRow(int y, std::uint8_t* to)
    {
        pack(y, m_row);
        const Filter filter = m_rowBytes <= kPlainRowBytes ? Filter::None : Filter::Up;
        *to++               = static_cast<std::uint8_t>(filter);
        if (filter == Filter::None)
            std::ranges::copy(m_row, to);
        else
            std::ranges::transform(m_row, m_above, to,
                                   [](int byte, int above) { return static_cast<std::uint8_t>(byte - above); });
        m_row.swap(m_above);
        return to + m_rowBytes;
    }

    GridView<const std::uint32_t> m_argb;
    std::size_t                   m_bytesPerPixel;  // 3 or 4
    std::size_t                   m_rowBytes;
    Bytes                         m_row, m_above;  // packed
    Bytes                         m_strip;         // filtered rows, each behind the number of its filter
    Bytes                         m_compressed;
    z_stream                      m_stream{};
    std::size_t                   m_size     = 0;
    uLong                         m_checksum = 0;
};

/// Bytes that a file holds in network order, most significant first.
std::string bigEndian(std::uint32_t value)
{
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
            static_cast<char>(value)};
}

template <class Sink>
void writeChunk(Sink& file, std::string_view type, std::string_view contents)
{
    const auto crc = [](uLong before, std::string_view bytes) {
        if (bytes.empty()) return before;  // zlib begins anew where there is no buffer
        return crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    };
    file.write(bigEndian(static_cast<std::uint32_t>(contents.size())));
    file.write(type);
    file.write(contents);
    file.write(bigEndian(static_cast<std::uint32_t>(crc(crc(0, type), contents))));
}

/// A file in memory.
struct ByteSink {
    std::string bytes;

    void           write(std::string_view more) { bytes += more; }
    constexpr bool failed() const { return false; }
};

/// Everything before the pixels.
template <class Sink>
void writeHead(Sink& file, GridView<const std::uint32_t> argb, bool alpha, std::span<const PngText> texts)
{
    constexpr std::string_view kOpaqueKind("\x08\x02\x00\x00\x00", 5);  // 8 bits, red green blue; not interlaced
    constexpr std::string_view kAlphaKind("\x08\x06\x00\x00\x00", 5);   // the same and alpha
    constexpr std::string_view kPlainText("\0\0\0\0\0", 5);             // no compression, no language
    file.write("\x89PNG\r\n\x1a\n");
    writeChunk(file, "IHDR",
               bigEndian(static_cast<std::uint32_t>(argb.width)) + bigEndian(static_cast<std::uint32_t>(argb.height))
                   + std::string(alpha ? kAlphaKind : kOpaqueKind));
    for (const PngText& text : texts) writeChunk(file, "iTXt", text.keyword + std::string(kPlainText) + text.text);
}

/// The pixels: one zlib stream, whose parts threads make side by side and write one after another.
template <class Sink>
void writePixels(Sink& file, GridView<const std::uint32_t> argb, bool alpha, const PngWork& work)
{
    constexpr std::string_view kZlibHead = "\x78\x9c";  // deflate, a window of 32 KiB, the default level
    const std::size_t          rowBytes  = 1 + static_cast<std::size_t>(argb.width) * (alpha ? 4 : 3);
    const int                  rows =
        static_cast<int>(std::clamp<std::size_t>(kPngStripBytes / rowBytes, 1, static_cast<std::size_t>(argb.height)));
    const int strips  = (argb.height - 1) / rows + 1;
    const int threads = std::min(strips, work.threads > 0 ? work.threads : omp_get_num_procs());

    std::deque<StripEncoder> encoders;
    for (int i = 0; i < threads; ++i) encoders.emplace_back(argb, alpha, rows);
    std::atomic<bool> stop     = false;
    uLong             checksum = adler32(0, nullptr, 0);
    writeChunk(file, "IDAT", kZlibHead);
#pragma omp parallel for ordered schedule(dynamic, 1) num_threads(threads)
    for (int i = 0; i < strips; ++i) {
        StripEncoder& encoder = encoders[static_cast<std::size_t>(omp_get_thread_num())];
        if (!stop) encoder.encode(i * rows, std::min((i + 1) * rows, argb.height));
#pragma omp ordered
        if (!stop) {
            checksum = adler32_combine(checksum, encoder.checksum(), static_cast<z_off_t>(encoder.size()));
            writeChunk(file, "IDAT", encoder.compressed());
            stop = file.failed() || (work.cancel && work.cancel->load(std::memory_order_relaxed));
        }
    }
    writeChunk(file, "IDAT", bigEndian(static_cast<std::uint32_t>(checksum)));
}

}  // namespace

std::vector<PngText> reproducingTexts(const std::string& command, const std::string& sceneDigest)
{
    return {{kPngSoftware, "ZScope " ZSCOPE_VERSION}, {kPngCommand, command}, {kPngSceneDigest, sceneDigest}};
}

namespace {

/// `path` is named where there is no memory left.
template <class Sink>
Result<Done> encode(Sink& sink, GridView<const std::uint32_t> argb, std::span<const PngText> texts, const PngWork& work,
                    const std::string& path)
{
    assert(argb.width >= 1 && argb.height >= 1);
    const bool alpha = !isOpaque(argb);
    writeHead(sink, argb, alpha, texts);
    try {
        writePixels(sink, argb, alpha, work);
    } catch (const std::bad_alloc&) {
        return Error{Trouble::Limit, "there is no memory left to encode the picture", path};
    }
    if (work.cancel && work.cancel->load(std::memory_order_relaxed))
        return Error{Trouble::Cancelled, "writing was cancelled"};
    writeChunk(sink, "IEND", {});
    return Done{};
}

}  // namespace

Result<Done> writePng(const std::string& path, GridView<const std::uint32_t> argb, std::span<const PngText> texts,
                      const PngWork& work)
{
    Result<FileWriter> file = FileWriter::create(path);
    if (!file) return file.error();
    if (const auto done = encode(*file, argb, texts, work, path); !done) return done.error();
    return file->commit();
}

Result<std::string> pngOf(GridView<const std::uint32_t> argb, std::span<const PngText> texts, const PngWork& work)
{
    ByteSink sink;
    if (const auto done = encode(sink, argb, texts, work, {}); !done) return done.error();
    return std::move(sink.bytes);
}

}  // namespace zscope
