// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/layouts.h"

#include <array>
#include <cstring>

#include <QCoreApplication>

#include "ui/panels/registry.h"

namespace zscope::ui {
namespace {

constexpr std::array kLayouts{
    LayoutEntry{"teach", QT_TRANSLATE_NOOP("Layouts", "Teach"),
                QT_TRANSLATE_NOOP("Layouts", "Every structure that the algorithm uses, beside its picture"),
                "depth-test", 232, 410, 350},
    LayoutEntry{"compare", QT_TRANSLATE_NOOP("Layouts", "Compare"),
                QT_TRANSLATE_NOOP("Layouts", "Two algorithms held against each other, and why a pixel differs"),
                "compare", 232, 350, 350},
    LayoutEntry{"profile", QT_TRANSLATE_NOOP("Layouts", "Profile"),
                QT_TRANSLATE_NOOP("Layouts", "What ran and how long it took, and what was left out"), "hierarchy", 280,
                400, 350, 46},
};

constexpr std::array kComparePlaces{
    LayoutPlace{"pipeline", Qt::LeftDockWidgetArea},
    LayoutPlace{"compare", Qt::RightDockWidgetArea, nullptr, 60},
    LayoutPlace{"why", Qt::RightDockWidgetArea, nullptr, 40},
    LayoutPlace{"faults", Qt::LeftDockWidgetArea, "pipeline"},
    LayoutPlace{"marks", Qt::RightDockWidgetArea, "why"},
    LayoutPlace{"timeline", Qt::BottomDockWidgetArea},
};

constexpr std::array kProfilePlaces{
    LayoutPlace{"pipeline", Qt::LeftDockWidgetArea},
    LayoutPlace{"hierarchy", Qt::RightDockWidgetArea},
    LayoutPlace{"observer", Qt::RightDockWidgetArea, "hierarchy"},
    LayoutPlace{"pyramid", Qt::RightDockWidgetArea, "hierarchy"},
    LayoutPlace{"active-edges", Qt::RightDockWidgetArea},
    LayoutPlace{"measure", Qt::BottomDockWidgetArea},
};

}  // namespace

QString LayoutEntry::translatedTitle() const { return QCoreApplication::translate("Layouts", title); }
QString LayoutEntry::translatedTip() const { return QCoreApplication::translate("Layouts", tip); }

std::vector<LayoutPlace> LayoutEntry::places() const
{
    if (std::strcmp(word, "compare") == 0) return {kComparePlaces.begin(), kComparePlaces.end()};
    if (std::strcmp(word, "profile") == 0) return {kProfilePlaces.begin(), kProfilePlaces.end()};
    std::vector<LayoutPlace> all;
    for (const PanelEntry& panel : panels())
        if (panel.isInTeach) all.push_back({panel.word, panel.area, panel.tabbedWith, panel.share});
    return all;
}

std::span<const LayoutEntry> layoutEntries() { return kLayouts; }

const LayoutEntry& layoutEntry(const QString& word)
{
    for (const LayoutEntry& entry : kLayouts)
        if (word == entry.word) return entry;
    return kLayouts.front();
}

QSize firstSize(const QSize& room)
{
    constexpr QSize kLeast{1280, 800}, kMost{1920, 1200};
    return (room * 9 / 10).boundedTo(kMost).expandedTo(kLeast).boundedTo(room);
}

}  // namespace zscope::ui
