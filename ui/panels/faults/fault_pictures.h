// SPDX-License-Identifier: GPL-3.0-or-later
// What every fault of the gallery does to the view on show: the spoilt picture, and how many pixels are wrong.
//
// Method     each is drawn twice, with the fault and without: in the chosen composition if the fault can happen there,
//            else in the one that the gallery names
// Threads    runs on a worker; no widgets
#pragma once

#include <atomic>
#include <functional>

#include <QImage>

#include "core/frame/faults.h"
#include "ui/session/snapshot.h"

namespace zscope::ui {

struct FaultPicture {
    Fault         fault = Fault::None;
    Pipeline      pipeline;         // with the fault
    std::uint64_t wrongPixels = 0;  // another surface or another depth than without it
    std::uint64_t pixels      = 0;  // of the picture
    // pale, with what is wrong in the colour of errors; no wider than kFaultPictureWidth
    QImage picture;

    bool isOfChosen = false;  // drawn in the chosen composition
};
inline constexpr int kFaultPictureWidth = 480;

/// Hands out one after another, in the order of faults(), until `cancel`. Errors end it; faults that cannot be drawn in
/// this scene are left out.
void drawFaults(const DrawRequest& request, const std::atomic<bool>& cancel,
                const std::function<void(FaultPicture)>& made);

}  // namespace zscope::ui
