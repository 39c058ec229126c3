// A build without FreeType or Fontconfig.
#include "app/cli/sheet_text.h"

namespace zscope::cli {

const bool kHasText = false;

struct TextPainter::Fonts {};

TextPainter::TextPainter(std::unique_ptr<Fonts> fonts) : m_fonts(std::move(fonts)) {}
TextPainter::~TextPainter()                                 = default;
TextPainter::TextPainter(TextPainter&&) noexcept            = default;
TextPainter& TextPainter::operator=(TextPainter&&) noexcept = default;

Result<TextPainter> TextPainter::open()
{
    return Error{Trouble::Output, "this build draws no text: FreeType or Fontconfig was not found when it was made"};
}

std::vector<TextPainter::Glyph> TextPainter::glyphs(std::string_view, int) { return {}; }

int  TextPainter::width(std::string_view, int) { return 0; }
void TextPainter::draw(GridView<std::uint32_t>, int, int, std::string_view, int, std::uint32_t) {}

}  // namespace zscope::cli
