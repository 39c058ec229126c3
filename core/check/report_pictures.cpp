#include "core/check/report_pictures.h"

#include <algorithm>
#include <cmath>

#include "core/lesson/colour_maps.h"
#include "core/lesson/layers.h"

namespace zscope::check {
namespace {

constexpr std::uint32_t kNoSurface = 0xFF000000;  // of a number below 0 that is not the background

std::uint32_t colourOf(std::int64_t id) { return id < 0 ? kNoSurface : colourOfId(static_cast<std::uint32_t>(id) + 1); }

/// Which part of the reference's depths, in the numbers of the file, lies farther than a value.
class DepthRanks {
public:
    DepthRanks(const CheckAnswer& answer)
        : m_truth(*answer.truth), m_scale(m_truth.camera, answer.shown.meaning),
          m_growsFarther(answer.shown.meaning != DepthMeaning::NearOverZ
                         && answer.shown.meaning != DepthMeaning::WindowReversed)
    {
        constexpr std::uint64_t kMany = 1 << 16;  // pixels that are looked at
        const int               step  = 1 + static_cast<int>(std::sqrt(static_cast<double>(m_truth.covered / kMany)));
        for (int y = 0; y < m_truth.camera.height; y += step)
            for (int x = 0; x < m_truth.camera.width; x += step)
                if (m_truth.picture.ids.at(x, y) >= 0) m_values.push_back(reference(x, y));
        std::ranges::sort(m_values);
    }

    /// Of a pixel that the reference covers.
    double reference(int x, int y) const { return m_scale.of(m_truth.picture.depth.at(x, y), x, y).value; }

    std::uint32_t colourOf(double value) const
    {
        if (m_values.empty() || std::isnan(value)) return cividis(0.5);
        const auto below = std::ranges::lower_bound(m_values, value) - m_values.begin();
        const auto upTo  = std::ranges::upper_bound(m_values, value) - m_values.begin();
        const auto part  = static_cast<double>(below + upTo) / 2 / static_cast<double>(m_values.size());
        return cividis(m_growsFarther ? 1 - part : part);
    }

private:
    const Truth&        m_truth;
    DepthScale          m_scale;
    bool                m_growsFarther;
    std::vector<double> m_values;  // ascending
};

std::uint32_t colourOf(Verdict verdict, bool isCovered)
{
    if (verdict.isWrong()) return kMistakeColours[static_cast<std::size_t>(verdict.mistake())];
    if (verdict.isRounding()) return kRoundingColour;
    return isCovered ? kRightColour : kEmptyColour;
}

/// The worse, the more.
int badnessOf(Verdict verdict, bool isCovered)
{
    if (verdict.isWrong()) return 10 - static_cast<int>(verdict.mistake());
    return verdict.isRounding() ? 2 : isCovered ? 1 : 0;
}

class Painter {
public:
    Painter(const CheckAnswer& answer, const PictureWindow& window, int scale)
        : m_answer(answer), m_window(window), m_scale(scale)
    {}

    /// colourAt(x, y) of the pixel in the middle of each block.
    template <class Colour>
    Grid<std::uint32_t> paint(const Colour& colourAt) const
    {
        return eachBlock(
            [&](int x0, int y0, int x1, int y1) { return colourAt((x0 + x1 - 1) / 2, (y0 + y1 - 1) / 2); });
    }

    Grid<std::uint32_t> map() const
    {
        return eachBlock([&](int x0, int y0, int x1, int y1) {
            int           worst  = -1;
            std::uint32_t colour = kEmptyColour;
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) {
                    const Verdict verdict   = m_answer.verdicts.at(x, y);
                    const bool    isCovered = m_answer.truth->picture.ids.at(x, y) >= 0;
                    const int     badness   = badnessOf(verdict, isCovered);
                    if (badness <= worst) continue;
                    worst  = badness;
                    colour = colourOf(verdict, isCovered);
                }
            return colour;
        });
    }

private:
    template <class Colour>
    Grid<std::uint32_t> eachBlock(const Colour& colourOfBlock) const
    {
        const auto          blocks = [this](int pixels) { return (pixels + m_scale - 1) / m_scale; };
        Grid<std::uint32_t> picture(blocks(m_window.x1 - m_window.x0), blocks(m_window.y1 - m_window.y0));
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const int x0 = m_window.x0 + x * m_scale, y0 = m_window.y0 + y * m_scale;
                picture.at(x, y) =
                    colourOfBlock(x0, y0, std::min(x0 + m_scale, m_window.x1), std::min(y0 + m_scale, m_window.y1));
            }
        return picture;
    }

    const CheckAnswer& m_answer;
    PictureWindow      m_window;
    int                m_scale;
};

ReportPictures picturesOf(const CheckAnswer& answer, const PictureWindow& window, int scale)
{
    const Truth&   truth = *answer.truth;
    const Shown&   shown = answer.shown;
    const Painter  painter(answer, window, scale);
    ReportPictures pictures{scale, {}, painter.map()};
    if (shown.ids)
        pictures.pairs.push_back({"Surfaces", painter.paint([&](int x, int y) {
                                      const std::int64_t id = truth.picture.ids.at(x, y);
                                      if (id < 0) return kEmptyColour;
                                      return colourOf(shown.kind == IdKind::Faces ? truth.faces.faceOf(id) : id);
                                  }),
                                  painter.paint([&](int x, int y) {
                                      return shown.covered.at(x, y) == 0 ? kEmptyColour : colourOf(shown.ids->at(x, y));
                                  })});
    if (shown.depth) {
        const DepthRanks ranks(answer);
        pictures.pairs.push_back(
            {"Depths", painter.paint([&](int x, int y) {
                 return truth.picture.ids.at(x, y) < 0 ? kEmptyColour : ranks.colourOf(ranks.reference(x, y));
             }),
             painter.paint([&](int x, int y) {
                 return shown.covered.at(x, y) == 0 ? kEmptyColour : ranks.colourOf(shown.depth->at(x, y));
             })});
    }
    if (pictures.pairs.empty())
        pictures.pairs.push_back({"Coverage", painter.paint([&](int x, int y) {
                                      return truth.picture.ids.at(x, y) < 0 ? kEmptyColour : kRoundingColour;
                                  }),
                                  painter.paint([&](int x, int y) {
                                      return shown.covered.at(x, y) == 0 ? kEmptyColour : kRoundingColour;
                                  })});
    return pictures;
}

}  // namespace

PictureWindow windowAround(PixelPosition pixel, int radius, int width, int height)
{
    return {std::max(pixel.x - radius, 0), std::max(pixel.y - radius, 0), std::min(pixel.x + radius + 1, width),
            std::min(pixel.y + radius + 1, height)};
}

ReportPictures reportPictures(const CheckAnswer& answer)
{
    const int width = answer.verdicts.width(), height = answer.verdicts.height();
    return picturesOf(answer, {0, 0, width, height}, (std::max(width, height) - 1) / kMostReportSide + 1);
}

ReportPictures reportPictures(const CheckAnswer& answer, const PictureWindow& window)
{
    return picturesOf(answer, window, 1);
}

}  // namespace zscope::check
