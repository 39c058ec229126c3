#include "app/cli/sheet_text.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

namespace zscope::cli {

const bool kHasText = true;

namespace {

/// The next character, and where the one after it begins; what is no UTF-8 becomes the replacement character.
char32_t nextOf(std::string_view text, std::size_t& at)
{
    constexpr char32_t kReplacement = 0xFFFD;
    const auto         byte         = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned     first        = byte(at++);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 && first < 0xF8 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : 0;
    if (more == 0 || first >= 0xF8 || at + static_cast<std::size_t>(more) > text.size()) return kReplacement;
    char32_t character = first & (0x3Fu >> more);
    for (int i = 0; i < more; ++i) {
        if ((byte(at) & 0xC0) != 0x80) return kReplacement;
        character = character << 6 | (byte(at++) & 0x3Fu);
    }
    return character;
}

}  // namespace

/// The system's fonts in its order, opened when a character wants them.
struct TextPainter::Fonts {
    struct Font {
        std::string      file;
        int              index    = 0;
        const FcCharSet* has      = nullptr;  // of `order`
        FT_Face          face     = nullptr;  // nullptr: not opened
        bool             isBroken = false;
    };

    FT_Library                      library = nullptr;
    FcConfig*                       config  = nullptr;
    FcFontSet*                      order   = nullptr;
    std::vector<Font>               fonts;
    std::map<char32_t, std::size_t> known;  // which font a character has

    ~Fonts()
    {
        for (const Font& font : fonts)
            if (font.face) FT_Done_Face(font.face);
        if (order) FcFontSetDestroy(order);
        if (config) FcConfigDestroy(config);
        if (library) FT_Done_FreeType(library);
    }

    bool open(Font& font) const
    {
        if (!font.face && !font.isBroken)
            font.isBroken = FT_New_Face(library, font.file.c_str(), font.index, &font.face) != 0;
        if (font.isBroken) font.face = nullptr;
        return font.face != nullptr;
    }

    FT_Face faceFor(char32_t character)
    {
        if (const auto found = known.find(character); found != known.end()) return fonts[found->second].face;
        std::size_t chosen = 0;
        for (std::size_t i = 0; i < fonts.size(); ++i) {
            if (!FcCharSetHasChar(fonts[i].has, character) || !open(fonts[i])) continue;
            chosen = i;
            break;
        }
        known[character] = chosen;
        return fonts[chosen].face;
    }

    /// Calls visit(glyph, x) for each character; gives back where the text ends.
    template <class Visit>
    int walk(std::string_view text, int size, const Visit& visit)
    {
        int x = 0;
        for (std::size_t at = 0; at < text.size();) {
            const char32_t character = nextOf(text, at);
            const FT_Face  face      = faceFor(character);
            FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
            if (FT_Load_Char(face, character, FT_LOAD_RENDER) != 0) continue;
            visit(*face->glyph, x);
            x += static_cast<int>(face->glyph->advance.x >> 6);
        }
        return x;
    }
};

TextPainter::TextPainter(std::unique_ptr<Fonts> fonts) : m_fonts(std::move(fonts)) {}
TextPainter::~TextPainter()                                 = default;
TextPainter::TextPainter(TextPainter&&) noexcept            = default;
TextPainter& TextPainter::operator=(TextPainter&&) noexcept = default;

Result<TextPainter> TextPainter::open()
{
    auto fonts    = std::make_unique<Fonts>();
    fonts->config = FcInitLoadConfigAndFonts();
    if (FT_Init_FreeType(&fonts->library) != 0 || !fonts->config)
        return Error{Trouble::Output, "FreeType or Fontconfig cannot be started"};
    FcPattern* wanted = FcNameParse(reinterpret_cast<const FcChar8*>("sans-serif"));
    FcConfigSubstitute(fonts->config, wanted, FcMatchPattern);
    FcDefaultSubstitute(wanted);
    FcResult result = FcResultMatch;
    fonts->order    = FcFontSort(fonts->config, wanted, FcTrue, nullptr, &result);
    FcPatternDestroy(wanted);
    for (int i = 0; fonts->order && i < fonts->order->nfont; ++i) {
        FcChar8*   file  = nullptr;
        FcCharSet* has   = nullptr;
        int        index = 0;
        if (FcPatternGetString(fonts->order->fonts[i], FC_FILE, 0, &file) != FcResultMatch) continue;
        if (FcPatternGetCharSet(fonts->order->fonts[i], FC_CHARSET, 0, &has) != FcResultMatch) continue;
        FcPatternGetInteger(fonts->order->fonts[i], FC_INDEX, 0, &index);
        fonts->fonts.push_back({reinterpret_cast<const char*>(file), index, has, nullptr, false});
    }
    while (!fonts->fonts.empty() && !fonts->open(fonts->fonts.front())) fonts->fonts.erase(fonts->fonts.begin());
    if (fonts->fonts.empty())
        return Error{Trouble::Output, "no font is installed to write the sheet with (fonts-dejavu-core has one)"};
    return TextPainter(std::move(fonts));
}

int TextPainter::width(std::string_view utf8, int size)
{
    return m_fonts->walk(utf8, size, [](const FT_GlyphSlotRec&, int) {});
}

void TextPainter::draw(GridView<std::uint32_t> picture, int x, int y, std::string_view utf8, int size,
                       std::uint32_t colour)
{
    m_fonts->walk(utf8, size, [&](const FT_GlyphSlotRec& glyph, int at) {
        const FT_Bitmap& bitmap = glyph.bitmap;
        if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return;
        for (int j = 0; j < static_cast<int>(bitmap.rows); ++j)
            for (int i = 0; i < static_cast<int>(bitmap.width); ++i) {
                const int px = x + at + glyph.bitmap_left + i, py = y - glyph.bitmap_top + j;
                if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
                const unsigned cover = bitmap.buffer[j * bitmap.pitch + i];
                std::uint32_t& under = picture.at(px, py);
                std::uint32_t  mixed = 0xFF000000u;
                for (const int shift : {16, 8, 0}) {
                    const unsigned below = under >> shift & 0xFFu, above = colour >> shift & 0xFFu;
                    mixed |= (below * (255 - cover) + above * cover + 127) / 255 << shift;
                }
                under = mixed;
            }
    });
}

std::vector<TextPainter::Glyph> TextPainter::glyphs(std::string_view utf8, int size)
{
    std::vector<Glyph> all;
    int                x = 0;
    for (std::size_t at = 0; at < utf8.size();) {
        const std::size_t begin     = at;
        const char32_t    character = nextOf(utf8, at);
        const FT_Face     face      = m_fonts->faceFor(character);
        FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
        const FT_UInt index = FT_Get_Char_Index(face, character);
        if (FT_Load_Glyph(face, index, FT_LOAD_DEFAULT) != 0) continue;
        all.push_back({face, index, x, utf8.substr(begin, at - begin)});
        x += static_cast<int>(face->glyph->advance.x >> 6);
    }
    return all;
}

}  // namespace zscope::cli
