// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/verdicts.h"

#include <QCoreApplication>

namespace zscope::ui {

const QColor& colourOf(NodeVerdict verdict, const Theme& theme)
{
    switch (verdict) {
        case NodeVerdict::Entered:
            return theme.picked;
        case NodeVerdict::Drawn:
            return theme.entered;
        case NodeVerdict::Hidden:
            return theme.hidden;
        case NodeVerdict::Outside:
            return theme.outside;
        case NodeVerdict::Small:
            return theme.left;
        case NodeVerdict::Waiting:
            break;
    }
    return theme.softText;
}

QString shapeOf(NodeVerdict verdict)
{
    switch (verdict) {
        case NodeVerdict::Entered:
            return QStringLiteral("\u25C7");
        case NodeVerdict::Drawn:
            return QStringLiteral("\u25A0");
        case NodeVerdict::Hidden:
            return QStringLiteral("\u00D7");
        case NodeVerdict::Outside:
            return QStringLiteral("\u25CB");
        case NodeVerdict::Small:
            return QStringLiteral("\u25BF");
        case NodeVerdict::Waiting:
            break;
    }
    return QStringLiteral("\u2026");
}

QString nameOf(NodeVerdict verdict)
{
    switch (verdict) {
        case NodeVerdict::Entered:
            return QCoreApplication::translate("Verdicts", "entered");
        case NodeVerdict::Drawn:
            return QCoreApplication::translate("Verdicts", "drawn");
        case NodeVerdict::Hidden:
            return QCoreApplication::translate("Verdicts", "hidden");
        case NodeVerdict::Outside:
            return QCoreApplication::translate("Verdicts", "outside");
        case NodeVerdict::Small:
            return QCoreApplication::translate("Verdicts", "too small");
        case NodeVerdict::Waiting:
            break;
    }
    return QCoreApplication::translate("Verdicts", "waiting");
}

}  // namespace zscope::ui
