// Text in pictures, without Qt: glyphs by FreeType, fonts found by Fontconfig, the way a desktop finds them. Both come
// with every Debian desktop and with Qt; a build without them has no TextPainter (kHasText) and makes sheets of
// pictures only.
//
// Script     any that an installed font has: each character from the first font of the system's order that holds it
// Promise    the same fonts installed give the same pixels; without shaping, so right for Latin, Greek, Cyrillic and
//            CJK
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/base/result.h"

namespace zscope::cli {

extern const bool kHasText;

class TextPainter {
public:
    /// Errors: Output, if no font is installed or this build knows none.
    static Result<TextPainter> open();
    ~TextPainter();
    TextPainter(TextPainter&&) noexcept;
    TextPainter& operator=(TextPainter&&) noexcept;

    /// Pixels that a line of text takes at a size (of the em, in pixels).
    int width(std::string_view utf8, int size);
    /// Draws it from x on; y is the base line. What lies outside the picture is left out. Colour 0xAARRGGBB, taken as
    /// opaque.
    void draw(GridView<std::uint32_t> picture, int x, int y, std::string_view utf8, int size, std::uint32_t colour);

    /// One character where draw() would put it.
    struct Glyph {
        void*            face  = nullptr;  // FreeType's, alive as long as the painter
        unsigned long    index = 0;        // in that face
        int              x     = 0;        // from the beginning of the text, pixels
        std::string_view bytes = {};       // of the text
    };
    std::vector<Glyph> glyphs(std::string_view utf8, int size);

private:
    struct Fonts;
    explicit TextPainter(std::unique_ptr<Fonts> fonts);
    std::unique_ptr<Fonts> m_fonts;
};

}  // namespace zscope::cli
