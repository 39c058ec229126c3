#include "core/io/png.h"

#include <algorithm>
#include <csetjmp>
#include <vector>

#include <png.h>

#include "core/io/file_writer.h"

namespace zscope {
namespace {

void writeBytes(png_structp png, png_bytep bytes, png_size_t count)
{
    // A failure sticks to the writer and is reported by commit(): no jump out of libpng is needed for it.
    static_cast<FileWriter*>(png_get_io_ptr(png))->write({reinterpret_cast<const char*>(bytes), count});
}

void nothingToFlush(png_structp) {}

void keepMessage(png_structp png, png_const_charp message)
{
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

bool isOpaque(GridView<const std::uint32_t> argb)
{
    for (int y = 0; y < argb.height; ++y)
        if (std::ranges::any_of(argb.row(y), [](std::uint32_t c) { return (c >> 24) != 0xFF; })) return false;
    return true;
}

std::vector<png_text> textChunks(std::span<const PngText> texts)
{
    std::vector<png_text> chunks;
    for (const PngText& text : texts) {
        png_text chunk{};
        chunk.compression = PNG_ITXT_COMPRESSION_NONE;
        chunk.key         = const_cast<char*>(text.keyword.c_str());  // libpng reads only
        chunk.text        = const_cast<char*>(text.text.c_str());
        chunk.itxt_length = text.text.size();
        chunk.lang        = const_cast<char*>("");
        chunk.lang_key    = const_cast<char*>("");
        chunks.push_back(chunk);
    }
    return chunks;
}

struct Encoder {
    GridView<const std::uint32_t> argb;
    bool                          alpha;
    std::vector<png_text>         chunks;
    std::vector<png_byte>         line;  // one row as the file holds it

    void packLine(int y)
    {
        std::size_t at = 0;
        for (const std::uint32_t c : argb.row(y)) {
            line[at++] = static_cast<png_byte>(c >> 16);
            line[at++] = static_cast<png_byte>(c >> 8);
            line[at++] = static_cast<png_byte>(c);
            if (alpha) line[at++] = static_cast<png_byte>(c >> 24);
        }
    }
};

/// Everything between the jump target and the jumps lives in `encoder`, outside this frame, so a jump skips no
/// destructor.
bool encode(png_structp png, png_infop info, Encoder& encoder)
{
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, static_cast<png_uint_32>(encoder.argb.width), static_cast<png_uint_32>(encoder.argb.height),
                 8, encoder.alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_text(png, info, encoder.chunks.data(), static_cast<int>(encoder.chunks.size()));
    png_write_info(png, info);
    for (int y = 0; y < encoder.argb.height; ++y) {
        encoder.packLine(y);
        png_write_row(png, encoder.line.data());
    }
    png_write_end(png, nullptr);
    return true;
}

}  // namespace

std::vector<PngText> reproducingTexts(const std::string& command, const std::string& sceneDigest)
{
    return {{kPngSoftware, "ZScope " ZSCOPE_VERSION}, {kPngCommand, command}, {kPngSceneDigest, sceneDigest}};
}

Result<Done> writePng(const std::string& path, GridView<const std::uint32_t> argb, std::span<const PngText> texts)
{
    assert(argb.width >= 1 && argb.height >= 1);
    Result<FileWriter> file = FileWriter::create(path);
    if (!file) return file.error();

    std::string message;
    png_structp png  = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keepMessage, ignoreWarning);
    png_infop   info = png ? png_create_info_struct(png) : nullptr;
    if (!info) {
        png_destroy_write_struct(&png, nullptr);
        return Error{Trouble::Limit, "there is no memory left to encode the picture", path};
    }
    png_set_write_fn(png, &*file, writeBytes, nothingToFlush);

    const bool alpha = !isOpaque(argb);
    Encoder    encoder{argb, alpha, textChunks(texts), {}};
    encoder.line.resize(static_cast<std::size_t>(argb.width) * (alpha ? 4 : 3));
    const bool encoded = encode(png, info, encoder);
    png_destroy_write_struct(&png, &info);
    if (!encoded) return Error{Trouble::Output, "the picture cannot be encoded: " + message, path};
    return file->commit();
}

}  // namespace zscope
