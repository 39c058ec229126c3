// SPDX-License-Identifier: GPL-3.0-or-later
// The command line that draws the picture on show, to the bit: the numbers in it read back as the same float64.
#pragma once

#include "ui/session/session.h"

namespace zscope::ui {

/// What commandOf() calls the camera of a view that no options can say to the bit; who writes the command keeps it with
/// that name.
inline constexpr const char* kCameraFile = "camera.json";

/// The words of the command, unquoted, from "zscope-cli" on; the output is left for the user to name.
QStringList commandOf(const Snapshot& shown, const DrawSettings& settings);
/// The same as one line that a shell takes apart again.
QString commandLineOf(const QStringList& words);

/// Writes a PNG with the command, the version, the scene's digest and the session in text chunks. An existing file is
/// replaced only if `replace`; the file is complete or absent. Returns the trouble as a sentence, or nothing.
std::optional<QString> savePicture(const QImage& image, const QString& file, const Session& session, bool replace);

}  // namespace zscope::ui
