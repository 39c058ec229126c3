// The pictures of a report: the reference and another program's picture in the same colours, and a map of where they
// differ.
//
// Surface    one colour per id; the ids are what the file numbers, triangles or faces
// Depth      by rank: lighter is nearer, and equal steps of colour hold equally many pixels of the reference, whatever
//            the numbers of the file mean
// Coverage   of a plain picture, which shows nothing else
// Size       of the camera, or smaller by a whole number so that no side is longer than kMostReportSide. A pixel of the
//            map then stands for a block, and shows the worst that lies in it
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/check/check.h"

namespace zscope::check {

inline constexpr int kMostReportSide = 1600;  // pixels

struct ReportPair {
    std::string_view    title;  // "Surfaces", "Depths" or "Coverage"
    Grid<std::uint32_t> reference, found;
};

struct ReportPictures {
    int                     scale = 1;  // pixels of the camera per pixel of a picture, along each side
    std::vector<ReportPair> pairs;
    Grid<std::uint32_t>     map;
};
ReportPictures reportPictures(const CheckAnswer& answer);

/// 0xAARRGGBB, opaque.
inline constexpr std::uint32_t kEmptyColour = 0xFFFFFFFF, kRightColour = 0xFFD9DCE1, kRoundingColour = 0xFF8A8F99;
/// By mistake: told apart by every kind of colour vision.
inline constexpr std::array<std::uint32_t, 4> kMistakeColours{0xFF0072B2, 0xFFE69F00, 0xFFB00020, 0xFF8E4FA8};

/// The part of a picture around a pixel, at its full size: at most 2 * radius + 1 wide and high, inside the picture.
struct PictureWindow {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // [x0, x1) x [y0, y1)
};
PictureWindow windowAround(PixelPosition pixel, int radius, int width, int height);
/// The same pictures of that part alone.
ReportPictures reportPictures(const CheckAnswer& answer, const PictureWindow& window);

}  // namespace zscope::check
