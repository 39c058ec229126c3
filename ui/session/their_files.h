// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the files that were dropped or chosen another program drew, and what each of them holds.
//
// By ending  .pfm depth; .zdump all of it; .bmp and .ppm a picture; .png a picture, or depth if it is grey with 16 bits
// .npy       floats are depth, signed integers ids; unsigned ones are read as both, and judged as what fits better
// Names      "ids" at the begin or the end of a name goes before all that: ids.npy, frame-ids.png
// Cost       the first bytes of each file; of a dump all of it
#pragma once

#include <optional>
#include <string>

#include <QSize>
#include <QStringList>

#include "core/base/result.h"

namespace zscope::ui {

struct TheirFiles {
    std::optional<std::string> depth, ids, picture, dump;
    std::optional<std::string> numbers;              // depth or ids
    std::optional<QSize>       size;                 // of the first whose beginning says so
    bool                       hasMatrices = false;  // the dump brings its own camera

    friend bool operator==(const TheirFiles&, const TheirFiles&) = default;
};

/// By its ending: a file that is drawn, not a scene or a session.
bool isDrawn(const QString& file);
/// What a file dialog offers: "*.npy *.zdump ...".
QString drawnPatterns();
/// By its ending: the steps of another program, as JSON lines.
bool    isTrace(const QString& file);
QString tracePatterns();

/// Errors: Input, where two files hold the same, or a dump cannot be read.
Result<TheirFiles> theirFilesOf(const QStringList& files);

/// The session that a picture of the window carries; nothing if it carries none.
std::optional<std::string> sessionInPicture(const QString& file);

}  // namespace zscope::ui
