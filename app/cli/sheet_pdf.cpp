// The comparison sheet as one page of PDF: lines, letters and pictures as they are, not a picture of them.
#include "app/cli/compare_sheet.h"

#include <map>
#include <memory>

#include <cairo-ft.h>
#include <cairo-pdf.h>

#include "core/io/file_writer.h"

namespace zscope::cli {

const bool kHasPdf = true;

namespace {

constexpr double kPointsPerPixel = 72.0 / 96.0;

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count)
{
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

class PdfCanvas final : public SheetCanvas {
public:
    PdfCanvas(TextPainter& text, std::string& to) : m_text(text), m_to(to) {}
    ~PdfCanvas() override
    {
        for (const auto& [face, font] : m_fonts) cairo_font_face_destroy(font);
        if (m_context) cairo_destroy(m_context);
        if (m_surface) cairo_surface_destroy(m_surface);
    }
    PdfCanvas(const PdfCanvas&)            = delete;
    PdfCanvas& operator=(const PdfCanvas&) = delete;

    void begin(int width, int height) override
    {
        m_surface =
            cairo_pdf_surface_create_for_stream(append, &m_to, width * kPointsPerPixel, height * kPointsPerPixel);
        m_context = cairo_create(m_surface);
        cairo_scale(m_context, kPointsPerPixel, kPointsPerPixel);
    }
    void tellWhat(const SheetWords& words)
    {
        cairo_pdf_surface_set_metadata(m_surface, CAIRO_PDF_METADATA_TITLE, words.scene.c_str());
        cairo_pdf_surface_set_metadata(m_surface, CAIRO_PDF_METADATA_SUBJECT, words.command.c_str());
        cairo_pdf_surface_set_metadata(m_surface, CAIRO_PDF_METADATA_CREATOR, "ZScope " ZSCOPE_VERSION);
    }
    int  width(std::string_view utf8, int size) override { return m_text.width(utf8, size); }
    void fill(int x0, int y0, int x1, int y1, std::uint32_t colour) override
    {
        paintWith(colour);
        cairo_rectangle(m_context, x0, y0, x1 - x0, y1 - y0);
        cairo_fill(m_context);
    }
    void text(int x, int y, std::string_view utf8, int size, std::uint32_t colour) override
    {
        paintWith(colour);
        cairo_set_font_size(m_context, size);
        for (const TextPainter::Glyph& each : m_text.glyphs(utf8, size)) {
            cairo_set_font_face(m_context, fontOf(each.face));
            const cairo_glyph_t        glyph{each.index, static_cast<double>(x + each.x), static_cast<double>(y)};
            const cairo_text_cluster_t cluster{static_cast<int>(each.bytes.size()), 1};
            cairo_show_text_glyphs(m_context, each.bytes.data(), cluster.num_bytes, &glyph, 1, &cluster, 1,
                                   static_cast<cairo_text_cluster_flags_t>(0));
        }
    }
    void picture(int x, int y, int width, int height, const Grid<std::uint32_t>& pixels) override
    {
        // Cairo's RGB24 is 0x00RRGGBB in the machine's order, as ours but for the unused byte; it only reads.
        auto*            data  = reinterpret_cast<unsigned char*>(const_cast<std::uint32_t*>(pixels.values().data()));
        cairo_surface_t* image = cairo_image_surface_create_for_data(data, CAIRO_FORMAT_RGB24, pixels.width(),
                                                                     pixels.height(), 4 * pixels.width());
        cairo_save(m_context);
        cairo_translate(m_context, x, y);
        cairo_scale(m_context, static_cast<double>(width) / pixels.width(),
                    static_cast<double>(height) / pixels.height());
        cairo_set_source_surface(m_context, image, 0, 0);
        cairo_paint(m_context);
        cairo_restore(m_context);
        cairo_surface_flush(image);
        cairo_surface_destroy(image);  // the page has a reference, and copies the pixels when it is shown
    }
    /// Whether everything was drawn.
    bool end()
    {
        cairo_show_page(m_context);
        const bool isWhole = cairo_status(m_context) == CAIRO_STATUS_SUCCESS;
        cairo_surface_finish(m_surface);
        return isWhole && cairo_surface_status(m_surface) == CAIRO_STATUS_SUCCESS;
    }

private:
    void paintWith(std::uint32_t colour)
    {
        const auto part = [colour](int shift) { return static_cast<double>(colour >> shift & 0xFFu) / 255; };
        cairo_set_source_rgb(m_context, part(16), part(8), part(0));
    }
    cairo_font_face_t* fontOf(void* face)
    {
        cairo_font_face_t*& font = m_fonts[face];
        if (!font) font = cairo_ft_font_face_create_for_ft_face(static_cast<FT_Face>(face), 0);
        return font;
    }

    TextPainter&                        m_text;
    std::string&                        m_to;
    cairo_surface_t*                    m_surface = nullptr;
    cairo_t*                            m_context = nullptr;
    std::map<void*, cairo_font_face_t*> m_fonts;
};

}  // namespace

Result<Done> writePdfSheet(const std::string& path, const Comparison& comparison, const Scene& scene,
                           const SheetWords& words, TextPainter& text)
{
    std::string bytes;
    {
        PdfCanvas canvas(text, bytes);
        drawSheet(comparison, scene, words, canvas);
        canvas.tellWhat(words);
        if (!canvas.end()) return Error{Trouble::Output, "the page could not be composed", path};
    }
    return writeFile(path, bytes);
}

}  // namespace zscope::cli
