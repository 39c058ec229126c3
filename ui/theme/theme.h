// SPDX-License-Identifier: GPL-3.0-or-later
// Every colour of the window, for a light and a dark ground. One accent for "now"; entered, left and picked have one
// colour each, and wherever they appear a shape beside it.
//
// Ask        themeOf(widget.palette()): the palette is the one owner of the choice, no variable beside it
// Source     Okabe and Ito, Color Universal Design: colours told apart by every kind of colour vision
#pragma once

#include <array>
#include <cstdint>

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>

namespace zscope::ui {

/// The one spacing step, in logical pixels; everything is a multiple of it.
inline constexpr int kStep = 8;

struct Theme {
    bool                  dark;
    QColor                ground;  // between the cards
    QColor                card;
    QColor                canvas;  // around the picture
    QColor                border;
    QColor                text;
    QColor                softText;  // what is less important
    QColor                button;    // the one button that matters
    QColor                buttonText;
    QColor                now;      // the line, edge or pixel of this step
    QColor                nowTint;  // the same behind text
    QColor                entered;
    QColor                left;
    QColor                picked;
    QColor                pickedTint;
    QColor                idle;      // active edges that are neither of these
    QColor                idleText;  // letters on it
    QColor                hidden;    // nodes that the pyramid hides
    QColor                outside;   // nodes that do not reach the view
    QColor                error;     // used for nothing else
    QColor                errorTint;
    std::array<QColor, 5> polygons;  // intervals of a line, by polygon

    const QColor& ofPolygon(std::uint32_t id) const { return polygons[(id * 2654435761u >> 16) % polygons.size()]; }
};

const Theme& themeOf(const QPalette& palette);

enum class Appearance { System, Light, Dark };

/// The palette for an appearance; System is decided by the lightness of `system`, the palette Qt started with.
QPalette paletteOf(Appearance appearance, const QPalette& system);
/// The style sheet of the whole application.
QString styleSheetOf(const Theme& theme);
/// The application's font, so many pixels high.
QFont fontOfHeight(int pixels);

}  // namespace zscope::ui
