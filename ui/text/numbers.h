// SPDX-License-Identifier: GPL-3.0-or-later
// How numbers are written in the window: grouped by thousands, a real minus sign, a fixed number of decimals, so
// that a column of them lines up.
//
// Locale     that of the user; where it has no grouping (the C locale) the English one
#pragma once

#include <array>
#include <cstdint>

#include <QString>

namespace zscope::ui {

QString grouped(std::uint64_t value);
/// `one` for 1, otherwise `many` with the grouped number for %1: both are whole translated phrases.
QString counted(std::uint64_t value, const QString& one, const QString& many);
QString groupedSigned(std::int64_t value);
/// `decimals` digits after the point, grouped before it.
QString decimal(double value, int decimals);
/// The same with a sign in front of everything but zero.
QString signedDecimal(double value, int decimals);
/// So many significant digits, with a power of ten where it is short; the sign of infinity.
QString significant(double value, int digits);
/// "13/64", "−15/128"; a whole number without its denominator of 1.
QString fraction(const std::array<std::int64_t, 2>& value);
/// Two decimals below 100 ms, none above; with the unit.
QString milliseconds(double ms);
/// A depth in (0, 1] with as many digits as tell neighbours apart: 6 significant ones.
QString depthText(float depth);

}  // namespace zscope::ui
