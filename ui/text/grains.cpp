// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/grains.h"

#include <QCoreApplication>

#include "ui/text/phrase_book.h"

namespace zscope::ui {

QString nameOf(Grain grain)
{
    switch (grain) {
        case Grain::Frame:
            return QCoreApplication::translate("Grain", "frame");
        case Grain::Stage:
            return QCoreApplication::translate("Grain", "stage");
        case Grain::Node:
            return QCoreApplication::translate("Grain", "node");
        case Grain::Triangle:
            return QCoreApplication::translate("Grain", "triangle");
        case Grain::Query:
            return QCoreApplication::translate("Grain", "query");
        case Grain::Line:
            return QCoreApplication::translate("Grain", "line");
        case Grain::Interval:
            return QCoreApplication::translate("Grain", "interval");
        case Grain::Span:
            return QCoreApplication::translate("Grain", "span");
        case Grain::Update:
            return QCoreApplication::translate("Grain", "update");
        case Grain::Pixel:
            return QCoreApplication::translate("Grain", "pixel");
    }
    return {};
}

QString nameOf(Stage stage) { return said(wordOf(stage)); }

}  // namespace zscope::ui
