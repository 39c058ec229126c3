// SPDX-License-Identifier: GPL-3.0-or-later
// A window in the layout Profile, and the controls of its measure panel by their words.
#pragma once

#include <optional>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>

#include "tests/ui/desk.h"
#include "ui/charts/speed_error_chart.h"
#include "ui/panels/measure/measure_panel.h"

namespace zscope::ui {

struct MeasuringDesk : Desk {
    explicit MeasuringDesk(std::string_view algorithm = "zbuffer", const QSize& size = {1280, 800})
        : Desk(algorithm, size)
    {
        window.useLayout("profile");
        QTest::qWait(0);
    }
    MeasurePanel&    panel() { return static_cast<MeasurePanel&>(window.dock("measure")->panel()); }
    Measurer&        measurer() { return panel().measurer(); }
    SpeedErrorChart& chart() { return *panel().findChild<SpeedErrorChart*>(); }
    QTableView*      table(const QString& name)
    {
        for (auto* table : panel().findChildren<QTableView*>())
            if (table->accessibleName() == name) return table;
        return nullptr;
    }
    QTableView*  runs() { return table("Runs of this view"); }
    QPushButton* button(const QString& text)
    {
        for (auto* button : panel().findChildren<QPushButton*>())
            if (button->text() == text) return button;
        return nullptr;
    }
    void choose(MeasurePanel::What what, int frames)
    {
        for (auto* box : panel().findChildren<QComboBox*>())
            if (box->accessibleName() == "What to time") box->setCurrentIndex(static_cast<int>(what));
        panel().findChild<QSpinBox*>()->setValue(frames);
    }
    void dress(const QString& appearance) { window.findChild<QAction*>("appearance." + appearance)->trigger(); }
    void press(const QString& text) { QTest::mouseClick(button(text), Qt::LeftButton); }
    bool measures()
    {
        return QTest::qWaitFor([this] { return !measurer().isRunning(); }, kLong);
    }
    bool measure(MeasurePanel::What what, int frames = 2)
    {
        choose(what, frames);
        press("Measure");
        return measurer().isRunning() && measures();
    }
    QString said()
    {
        QString all;
        for (const auto* label : panel().findChildren<QLabel*>()) all += label->text() + ' ';
        return all;
    }
    std::optional<std::size_t> pointNamed(const QString& name)
    {
        for (std::size_t i = 0; i < chart().points().size(); ++i)
            if (chart().points()[i].name == name) return i;
        return {};
    }
};

}  // namespace zscope::ui
