// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/numbers.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>

namespace zscope::ui {
namespace {

constexpr QChar kMinus{0x2212};

QLocale displayLocale()
{
    const QLocale locale;
    return locale.language() == QLocale::C ? QLocale(QLocale::English, QLocale::UnitedStates) : locale;
}

QString withRealMinus(QString text) { return text.replace(QLatin1Char('-'), kMinus); }

}  // namespace

QString grouped(std::uint64_t value) { return displayLocale().toString(static_cast<qulonglong>(value)); }

QString counted(std::uint64_t value, const QString& one, const QString& many)
{
    return value == 1 ? one : many.arg(grouped(value));
}

QString groupedSigned(std::int64_t value)
{
    return withRealMinus(displayLocale().toString(static_cast<qlonglong>(value)));
}

QString decimal(double value, int decimals) { return withRealMinus(displayLocale().toString(value, 'f', decimals)); }

QString signedDecimal(double value, int decimals)
{
    return value > 0 ? QLatin1Char('+') + decimal(value, decimals) : decimal(value, decimals);
}

QString significant(double value, int digits)
{
    if (std::isinf(value)) return QStringLiteral("\u221E");
    return withRealMinus(displayLocale().toString(value, 'g', digits));
}

QString fraction(const std::array<std::int64_t, 2>& value)
{
    const QString numerator = withRealMinus(QString::number(value[0]));
    return value[1] == 1 ? numerator : numerator + QLatin1Char('/') + QString::number(value[1]);
}

QString milliseconds(double ms)
{
    return QCoreApplication::translate("Numbers", "%1 ms").arg(decimal(ms, ms < 100 ? 2 : 0));
}

QString depthText(float depth) { return displayLocale().toString(static_cast<double>(depth), 'g', 6); }

}  // namespace zscope::ui
