// SPDX-License-Identifier: GPL-3.0-or-later
// What the user has marked in a run: places to come back to, things to stop at, and when a pixel changes.
//
// Steps      counted from 0 within a grain of a pipeline: a bookmark names all three, and going to it brings all three
//            back
// Promise    breakpoints hold for every pipeline and grain; the search finds them anew
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <QPoint>
#include <QString>

#include "core/lesson/pixel_changes.h"

namespace zscope::ui {

struct Bookmark {
    QString       name;
    Pipeline      pipeline;
    Grain         grain = Grain::Frame;
    std::uint64_t step  = 0;

    friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// All steps that change one pixel; of one generation and grain.
struct PixelHistory {
    std::uint64_t            generation = 0;
    Grain                    grain      = Grain::Frame;
    QPoint                   pixel;
    std::vector<PixelChange> changes;
};

struct Marks {
    std::vector<Bookmark>               bookmarks;
    std::vector<Breakpoint>             breakpoints;
    std::shared_ptr<const PixelHistory> history;  // of the last pixel that was asked about; nullptr: none
};

struct Snapshot;

/// What a breakpoint of a kind would be about, by what is picked and selected; nothing if there is no such thing.
std::optional<Breakpoint> breakpointHere(const Snapshot& shown, Breakpoint::On on);
/// What F9 means: what was selected last in the order triangle, pixel, node, else the line of the step.
std::optional<Breakpoint> breakpointHere(const Snapshot& shown);
/// The line that a step works on.
std::optional<int> lineOf(const StepState& state);

/// "line 240", "pixel (980, 478)", "node 0.3.6", "triangle 8,841".
QString textOf(const Breakpoint& breakpoint);

}  // namespace zscope::ui
