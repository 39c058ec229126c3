// SPDX-License-Identifier: GPL-3.0-or-later
// B that another program drew: its files as they were judged, and as a picture beside A's.
//
// Painted    as the layer on show, if the files hold what that shows; else as what they hold: the picture itself, ids,
//            depth. Depths have A's range, so that equal depths have equal colours
// Judged     against the reference, whatever A is. What differs from A is found apart (core/lesson/difference.h): where
//            A is right the verdict decides, rounding counts as equal; where A is wrong, what both show is compared
// Rows       of the reference; numbers are the file's own
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <QPoint>
#include <QString>

#include "core/check/check.h"
#include "core/lesson/difference.h"
#include "ui/session/look.h"
#include "ui/session/their_files.h"

namespace zscope::ui {

struct TheirPicture {
    QString                                    title;  // the names of the files
    std::string                                scene;  // digest of the one that it was judged by
    QString                                    sceneWord;
    std::shared_ptr<const check::CheckAnswer>  answer;
    bool                                       isDiagnosed = false;  // causes were looked for
    std::shared_ptr<const Frame>               frame;                // depth and ids that the files hold
    std::shared_ptr<const Grid<std::uint32_t>> picture;              // colours that a file holds, or nullptr
    Look                                       look;
    Grid<std::uint32_t>                        painted;

    const Camera& camera() const { return answer->camera; }
    bool          hasIds() const { return answer->shown.ids.has_value(); }
    bool          hasDepth() const { return answer->shown.depth.has_value(); }
};

/// The layer in which A and B can be compared: the one on show, or another.
const Layer& layerFor(const check::CheckAnswer& answer, const Layer& onShow);
void         paint(TheirPicture& theirs, const Look& look);
/// Its frame and colours made from the answer. Errors: those of reading the picture once more.
Result<Done> fill(TheirPicture& theirs, const TheirFiles& files);

/// A pixel: what the reference and the files have there, in the files' numbers. Nothing: background, or not in a file.
struct TheirPixel {
    check::Verdict              verdict;
    bool                        isCovered = false, isExpected = false;  // by the files, by the reference
    std::optional<std::int64_t> id, expectedId;
    std::optional<double>       depth, expectedDepth;
};
/// Inside the picture.
TheirPixel theirPixel(const TheirPicture& theirs, const QPoint& pixel);

struct TheirDifference {
    Difference    difference;    // A is what B is held against
    std::uint64_t rounding = 0;  // pixels that count as equal
};
/// `byFaces`: A knows faces, not triangles. Both of one size.
TheirDifference differenceOf(const VisibilityBuffer& a, bool byFaces, const TheirPicture& theirs);

}  // namespace zscope::ui
