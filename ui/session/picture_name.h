// SPDX-License-Identifier: GPL-3.0-or-later
// What saved pictures are called: a template with fields in braces, as the user keeps it in the settings.
//
// Fields     {scene} {algorithm} {grain} {step} {n}; {step} counts from 1 and is "end" of the finished picture
// Promise    the name that is made is free: {n} is the first number for which no such file is there, and a template
//            without {n} is refused, so no picture takes the place of another
#pragma once

#include <optional>

#include "ui/session/snapshot.h"

namespace zscope::ui {

inline constexpr const char* kPictureTemplate = "{scene}_{algorithm}_{n}";

/// Why pictures cannot be called so, as a sentence; nothing: they can.
std::optional<QString> whyNoPictureTemplate(const QString& pattern);

/// The first free name in the folder, without its suffix. A pattern that cannot be used counts as kPictureTemplate.
QString freePictureName(const Snapshot& shown, const QString& folder, const QString& pattern = kPictureTemplate,
                        const QString& suffix = "png");

}  // namespace zscope::ui
