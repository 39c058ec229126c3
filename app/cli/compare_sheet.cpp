#include "app/cli/compare_sheet.h"

#include <algorithm>
#include <array>

namespace zscope::cli {
namespace {

/// The picture at the size given, each pixel the mean of what it stands for; never enlarged.
void paste(GridView<std::uint32_t> on, int left, int top, const Grid<std::uint32_t>& picture, int width, int height)
{
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto range = [](int at, int to, int from) {
                const int first = static_cast<int>(std::int64_t{at} * from / to);
                return std::pair(first, std::max(first + 1, static_cast<int>(std::int64_t{at + 1} * from / to)));
            };
            const auto [x0, x1] = range(x, width, picture.width());
            const auto [y0, y1] = range(y, height, picture.height());
            std::array<std::uint64_t, 3> sums{};
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u)
                    for (std::size_t i = 0; i < 3; ++i) sums[i] += picture.at(u, v) >> (16 - 8 * i) & 0xFFu;
            const auto    count = static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
            std::uint32_t mean  = 0xFF;
            for (const std::uint64_t sum : sums)
                mean = mean << 8 | static_cast<std::uint32_t>((sum + count / 2) / count);
            on.at(left + x, top + y) = mean;
        }
}

class RasterCanvas final : public SheetCanvas {
public:
    explicit RasterCanvas(TextPainter* text) : m_text(text) {}

    void begin(int width, int height) override { m_sheet.reset(width, height, 0xFFFFFFFFu); }
    int  width(std::string_view utf8, int size) override { return m_text ? m_text->width(utf8, size) : 0; }
    void text(int x, int y, std::string_view utf8, int size, std::uint32_t colour) override
    {
        if (m_text) m_text->draw(m_sheet.view(), x, y, utf8, size, colour);
    }
    void fill(int x0, int y0, int x1, int y1, std::uint32_t colour) override
    {
        for (int y = std::max(y0, 0); y < std::min(y1, m_sheet.height()); ++y)
            for (int x = std::max(x0, 0); x < std::min(x1, m_sheet.width()); ++x) m_sheet.at(x, y) = colour;
    }
    void picture(int x, int y, int width, int height, const Grid<std::uint32_t>& pixels) override
    {
        paste(m_sheet.view(), x, y, pixels, width, height);
    }

    Grid<std::uint32_t> take() { return std::move(m_sheet); }

private:
    TextPainter*        m_text;
    Grid<std::uint32_t> m_sheet;
};

}  // namespace

Grid<std::uint32_t> composeSheet(const Comparison& comparison, const Scene& scene, const SheetWords& words,
                                 TextPainter* text)
{
    RasterCanvas canvas(text);
    drawSheet(comparison, scene, words, canvas);
    return canvas.take();
}

}  // namespace zscope::cli
