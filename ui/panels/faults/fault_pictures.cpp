// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/faults/fault_pictures.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/frame/renderer.h"
#include "core/lesson/difference.h"

namespace zscope::ui {
namespace {

QRgb pale(std::uint32_t colour)
{
    const auto part = [](int value) { return 255 - (255 - value) * 2 / 5; };
    return qRgb(part(qRed(colour)), part(qGreen(colour)), part(qBlue(colour)));
}

/// Smaller by a whole factor: a block with any wrong pixel is wrong, so that single pixels are seen.
QImage pictureOf(const Grid<std::uint32_t>& colours, const Grid<PixelDifference>& kinds)
{
    const int factor = std::max(1, (colours.width() + kFaultPictureWidth - 1) / kFaultPictureWidth);
    QImage    image((colours.width() + factor - 1) / factor, (colours.height() + factor - 1) / factor,
                    QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        auto* out = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            bool isWrong = false;
            for (int v = y * factor; v < std::min((y + 1) * factor, colours.height()) && !isWrong; ++v)
                for (int u = x * factor; u < std::min((x + 1) * factor, colours.width()) && !isWrong; ++u)
                    isWrong = kinds.at(u, v) != PixelDifference::None;
            out[x] = isWrong ? QRgb{kWrongColour} : pale(colours.at(x * factor, y * factor));
        }
    }
    return image;
}

/// Draws and keeps the picture; nothing if this cannot be drawn.
std::optional<Frame> drawn(const DrawRequest& request)
{
    Renderer renderer;
    Frame    frame;
    if (!renderer.draw(request, frame)) return {};
    return frame;
}

}  // namespace

void drawFaults(const DrawRequest& asked, const std::atomic<bool>& cancel,
                const std::function<void(FaultPicture)>& made)
{
    DrawRequest request = asked;
    request.cancel      = &cancel;
    std::optional<std::pair<Pipeline, Frame>> right;  // the last one, which often serves the next fault, too
    for (const FaultEntry& entry : faults()) {
        if (cancel) return;
        FaultPicture one;
        one.fault          = entry.fault;
        one.pipeline       = asked.pipeline;
        one.pipeline.fault = {};
        Pipeline with      = one.pipeline;
        with.fault         = entry.fault;
        one.isOfChosen =
            asked.pipeline.chooser != Chooser::Measured && entry.canHappen(one.pipeline) && !explainInvalid(with);
        if (!one.isOfChosen) one.pipeline = findPreset(entry.preset)->pipeline;
        if (!right || right->first != one.pipeline) {
            request.pipeline = one.pipeline;
            auto frame       = drawn(request);
            if (!frame) continue;
            right.emplace(one.pipeline, std::move(*frame));
        }
        one.pipeline.fault = entry.fault;
        request.pipeline   = one.pipeline;
        const auto spoilt  = drawn(request);
        if (!spoilt || cancel) continue;
        const Difference difference = differenceOf(right->second.visible, spoilt->visible, 0);
        one.wrongPixels             = difference.differing();
        one.pixels                  = difference.kinds.values().size();
        one.picture                 = pictureOf(spoilt->colour, difference.kinds);
        made(std::move(one));
    }
}

}  // namespace zscope::ui
