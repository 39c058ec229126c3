#include "core/io/png_read.h"

#include <csetjmp>
#include <cstring>
#include <vector>

#include <png.h>

namespace zscope {
namespace {

struct Source {
    std::string_view bytes;
    std::size_t      at = 0;
};

void readBytes(png_structp png, png_bytep to, std::size_t count)
{
    auto& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (count > source.bytes.size() - source.at) png_error(png, "it ends too early");
    std::memcpy(to, source.bytes.data() + source.at, count);
    source.at += count;
}

void remember(png_structp png, png_const_charp message)
{
    auto& trouble = *static_cast<std::string*>(png_get_error_ptr(png));
    if (trouble.empty()) trouble = message;
    png_longjmp(png, 1);
}
void ignore(png_structp, png_const_charp) {}

enum class Want { Colours8, Grey16 };

/// What a jump out of libpng must not lose is held by the caller: this function owns nothing.
bool readRows(png_structp png, png_infop info, Want want, PngRead& read, int width, int height,
              std::vector<png_byte>& rows, std::size_t& rowBytes)
{
    if (setjmp(png_jmpbuf(png))) return false;
    png_read_info(png, info);
    read.width   = png_get_image_width(png, info);
    read.height  = png_get_image_height(png, info);
    read.differs = read.width != static_cast<png_uint_32>(width) || read.height != static_cast<png_uint_32>(height);
    if (read.differs) return false;
    const int kind = png_get_color_type(png, info), bits = png_get_bit_depth(png, info);
    if (want == Want::Grey16) {
        if (bits != 16 || (kind != PNG_COLOR_TYPE_GRAY && kind != PNG_COLOR_TYPE_GRAY_ALPHA))
            png_error(png, "depth needs one grey channel of 16 bits");
        png_set_swap(png);
    } else {
        png_set_expand(png);
        png_set_strip_16(png);
        png_set_gray_to_rgb(png);
    }
    png_set_strip_alpha(png);
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    rowBytes = png_get_rowbytes(png, info);
    rows.resize(rowBytes * read.height);
    for (int pass = 0; pass < passes; ++pass)
        for (png_uint_32 y = 0; y < read.height; ++y) png_read_row(png, rows.data() + y * rowBytes, nullptr);
    png_read_end(png, nullptr);
    return true;
}

/// The same rule: what a jump must not lose is the caller's.
void readTextBeforePixels(png_structp png, png_infop info, std::string_view keyword, std::string& text, bool& isThere)
{
    if (setjmp(png_jmpbuf(png))) return;
    png_read_info(png, info);
    png_textp texts = nullptr;
    const int count = png_get_text(png, info, &texts, nullptr);
    for (int i = 0; i < count && !isThere; ++i) {
        if (keyword != texts[i].key) continue;
        const bool isLong = texts[i].compression >= PNG_ITXT_COMPRESSION_NONE;
        text.assign(texts[i].text, isLong ? texts[i].itxt_length : texts[i].text_length);
        isThere = true;
    }
}

bool beginsAsPng(std::string_view bytes)
{
    return bytes.size() >= 8 && png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0;
}

PngRead readAll(std::string_view bytes, Want want, int width, int height, std::vector<png_byte>& rows,
                std::size_t& rowBytes)
{
    PngRead read;
    if (!beginsAsPng(bytes)) {
        read.trouble = "it does not begin as PNG";
        return read;
    }
    Source      source{bytes, 0};
    png_structp png  = png_create_read_struct(PNG_LIBPNG_VER_STRING, &read.trouble, remember, ignore);
    png_infop   info = png ? png_create_info_struct(png) : nullptr;
    if (!info) {
        png_destroy_read_struct(&png, nullptr, nullptr);
        read.trouble = "there is not enough memory";
        return read;
    }
    png_set_read_fn(png, &source, readBytes);
    png_set_user_limits(png, 1u << 24, 1u << 24);  // larger ones have another size than any camera
    if (!readRows(png, info, want, read, width, height, rows, rowBytes) && !read.differs && read.trouble.empty())
        read.trouble = "it is damaged";
    png_destroy_read_struct(&png, &info, nullptr);
    return read;
}

}  // namespace

PngRead readPng8(std::string_view bytes, int width, int height, Grid<std::uint32_t>& colours)
{
    std::vector<png_byte> rows;
    std::size_t           rowBytes = 0;
    PngRead               read     = readAll(bytes, Want::Colours8, width, height, rows, rowBytes);
    if (read.differs || !read.trouble.empty()) return read;
    colours.reset(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const png_byte* p = rows.data() + static_cast<std::size_t>(y) * rowBytes + static_cast<std::size_t>(x) * 3;
            colours.at(x, y)  = static_cast<std::uint32_t>(p[0] << 16 | p[1] << 8 | p[2]);
        }
    return read;
}

PngRead readPngGrey16(std::string_view bytes, int width, int height, Grid<std::uint16_t>& grey)
{
    std::vector<png_byte> rows;
    std::size_t           rowBytes = 0;
    PngRead               read     = readAll(bytes, Want::Grey16, width, height, rows, rowBytes);
    if (read.differs || !read.trouble.empty()) return read;
    grey.reset(width, height);
    for (int y = 0; y < height; ++y)
        std::memcpy(grey.view().row(y).data(), rows.data() + static_cast<std::size_t>(y) * rowBytes,
                    grey.view().row(y).size_bytes());
    return read;
}

std::optional<std::string> readPngText(std::string_view bytes, std::string_view keyword)
{
    if (!beginsAsPng(bytes)) return std::nullopt;
    Source      source{bytes, 0};
    std::string trouble, text;
    bool        isThere = false;
    png_structp png     = png_create_read_struct(PNG_LIBPNG_VER_STRING, &trouble, remember, ignore);
    png_infop   info    = png ? png_create_info_struct(png) : nullptr;
    if (info) {
        png_set_read_fn(png, &source, readBytes);
        png_set_user_limits(png, 1u << 24, 1u << 24);
        readTextBeforePixels(png, info, keyword, text, isThere);
    }
    png_destroy_read_struct(&png, info ? &info : nullptr, nullptr);
    if (!isThere) return std::nullopt;
    return text;
}

}  // namespace zscope
