// SPDX-License-Identifier: GPL-3.0-or-later
// Work and time, and speed against error: times algorithms on the view that
// is shown, lists the runs, takes one apart stage by stage, and draws them as a chart whose points load a run.
//
// Layout     wide: runs, stages and chart side by side; narrow: one below the other, scrolled
// Runs       belong to the Measurer, view by view; the panel shows those of the view in the window, or of a case of a
//            record that was opened from a file. To load a run of a record opens its scene from where it was seen
#pragma once

#include <optional>

#include "core/measure/record.h"
#include "ui/charts/speed_error_points.h"
#include "ui/panels/measure/measurer.h"
#include "ui/panels/panel.h"

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableView;

namespace zscope::ui {

class CountersModel;
class RunsModel;
class SortedRuns;
class SpeedErrorChart;
class StagesModel;

class MeasurePanel final : public Panel {
    Q_OBJECT

public:
    enum class What { This, Presets, Switches };

    explicit MeasurePanel(Session& session, QWidget* parent = nullptr);
    ~MeasurePanel() override;

    void present(const Snapshot& shown, Changes what) override;

    Measurer& measurer() { return m_measurer; }
    /// Times what the panel's choices say on the view that is shown, as its button does.
    void start();
    /// The runs shown: a record (core/measure/record.h), or CSV if the name ends so. The trouble as a sentence, or
    /// nothing.
    std::optional<QString> saveTo(const QString& file) const;
    /// Shows the runs of a record, beginning with its first case. The trouble as a sentence, or nothing.
    std::optional<QString> openRecord(const QString& file);
    void                   askForRecord();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeControls();
    QWidget* makeRuns();
    QWidget* makeDetails();
    QWidget* makeChart();
    void     connectAll();
    void     say();
    void     fitColumns();

    void                    askWhere();
    void                    fillCases();
    void                    chooseCase(int at);
    const std::vector<Run>& shownRuns() const;
    void                    showProgress();
    void                    showRuns();  // of the view in the window
    void                    showRun();   // the selected one, taken apart
    void                    showChart();
    void                    showLoaded();  // which run is what the window draws
    void                    select(std::size_t run);
    void                    load(std::size_t run);
    void                    arrange();

    std::optional<std::size_t> selected() const;  // of the model's runs
    std::optional<std::size_t> pointOf(std::size_t run) const;

    Measurer                    m_measurer;
    std::optional<Record>       m_record;    // opened from a file
    std::optional<std::size_t>  m_case;      // of it, that is shown; nothing: the view in the window
    std::vector<Run>            m_recorded;  // of that case
    std::optional<MeasuredView> m_view;
    std::vector<std::size_t>    m_runOfPoint;
    bool                        m_isWide = false, m_isArranged = false;

    RunsModel*       m_runs;
    SortedRuns*      m_sorted;
    StagesModel*     m_stages;
    CountersModel*   m_counters;
    SpeedErrorChart* m_chart;
    QTableView *     m_runTable, *m_stageTable, *m_counterTable;
    QComboBox *      m_what, *m_measure, *m_cases;
    QSpinBox*        m_frames;
    QCheckBox*       m_checks;
    QPushButton *    m_start, *m_stop, *m_save, *m_open;
    QProgressBar*    m_progress;
    QLabel *         m_doing, *m_hint, *m_about, *m_said;
    QWidget*         m_body;
    QBoxLayout *     m_columns, *m_controls;
    QString          m_trouble;
};

}  // namespace zscope::ui
