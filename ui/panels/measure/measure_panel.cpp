// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/measure/measure_panel.h"

#include <algorithm>

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableView>

#include "core/io/file_writer.h"
#include "core/io/read_file.h"
#include "core/measure/approximate_switches.h"
#include "ui/charts/speed_error_chart.h"
#include "ui/panels/measure/runs_model.h"
#include "ui/panels/measure/runs_record.h"
#include "ui/panels/measure/stages_model.h"
#include "ui/parts/choice_box.h"
#include "ui/parts/row_delegate.h"
#include "ui/parts/scrolling.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kWideFrom   = 860;  // logical pixels of the panel
constexpr int kRowHeight  = 18;
constexpr int kMostFrames = 10'000;

QTableView* plainTable(QAbstractItemModel* model)
{
    auto* table = new QTableView;
    table->setModel(model);
    table->setItemDelegate(new RowDelegate(table));
    table->setFrameShape(QFrame::NoFrame);
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);
    table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // as high as there is room, else scrolled
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(kRowHeight);
    table->verticalHeader()->setMinimumSectionSize(kRowHeight);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setMinimumSectionSize(30);
    table->setProperty("ownsArrows", true);
    QFont small = table->font();
    small.setPointSizeF(small.pointSizeF() * 0.9);
    table->setFont(small);
    table->horizontalHeader()->setFont(small);
    return table;
}

QLabel* wordsLabel(const char* style)
{
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(style));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    return label;
}

}  // namespace

MeasurePanel::MeasurePanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_runs(new RunsModel(this)), m_sorted(new SortedRuns(*m_runs, this)),
      m_stages(new StagesModel(this)), m_counters(new CountersModel(this)), m_body(new QWidget)
{
    m_hint = wordsLabel("hint");
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setMargin(2 * kStep);

    auto* inside = new ScrolledPart;
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(kStep);
    layout->addWidget(makeControls());
    layout->addWidget(m_cases);
    layout->addWidget(m_hint);
    m_columns = new QBoxLayout(QBoxLayout::TopToBottom, m_body);
    m_columns->setContentsMargins(0, 0, 0, 0);
    m_columns->setSpacing(2 * kStep);
    m_columns->addWidget(makeRuns(), 29);
    m_columns->addWidget(makeDetails(), 42);  // at 1280 both costs of a frame are written out
    m_columns->addWidget(makeChart(), 29);
    layout->addWidget(m_body, 1);
    layout->addStretch(0);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolling(inside));
    connectAll();
    spoken(*this, [this] { say(); });
    arrange();
}

MeasurePanel::~MeasurePanel() = default;

// Widgets -----------------------------------------------------------------------------------------------------------

QWidget* MeasurePanel::makeControls()
{
    m_what     = new ChoiceBox;
    m_frames   = new QSpinBox;
    m_checks   = new QCheckBox;
    m_start    = new QPushButton;
    m_stop     = new QPushButton;
    m_save     = new QPushButton;
    m_open     = new QPushButton;
    m_cases    = new ChoiceBox;
    m_progress = new QProgressBar;
    m_doing    = new QLabel;
    for (int i = 0; i < 3; ++i) m_what->addItem(QString(), i);
    m_what->setCurrentIndex(static_cast<int>(What::Presets));
    m_frames->setRange(1, kMostFrames);
    m_frames->setValue(30);
    m_frames->setAlignment(Qt::AlignRight);
    m_frames->setMaximumWidth(110);
    m_checks->setChecked(true);
    m_checks->setFocusPolicy(Qt::TabFocus);
    m_start->setObjectName("strong");
    for (QPushButton* button : {m_start, m_stop, m_save, m_open}) button->setFocusPolicy(Qt::TabFocus);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_doing->setObjectName("soft");
    m_doing->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);

    auto* first = new QHBoxLayout;
    first->setSpacing(kStep);
    first->addWidget(m_what, 1);
    first->addWidget(m_frames);
    auto* second = new QHBoxLayout;
    second->setSpacing(kStep);
    second->addWidget(m_checks);
    second->addStretch(1);
    second->addWidget(m_start);
    second->addWidget(m_stop);
    auto* third = new QHBoxLayout;
    third->setSpacing(kStep);
    third->addWidget(m_doing, 2);
    third->addWidget(m_progress, 1);
    third->addWidget(m_save);
    third->addWidget(m_open);
    auto* controls = new QWidget;
    m_controls     = new QBoxLayout(QBoxLayout::TopToBottom, controls);
    m_controls->setContentsMargins(0, 0, 0, 0);
    m_controls->setSpacing(kStep);
    m_controls->addLayout(first, 2);
    m_controls->addLayout(second);
    m_controls->addLayout(third, 3);
    m_cases->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_cases->hide();
    return controls;
}

QWidget* MeasurePanel::makeRuns()
{
    m_runTable = plainTable(m_sorted);
    m_runTable->setSortingEnabled(true);
    m_runTable->sortByColumn(RunsModel::Median, Qt::AscendingOrder);
    m_runTable->horizontalHeader()->setSortIndicatorShown(false);  // the header's text says it, and covers nothing
    m_runTable->setProperty("ownsEnter", true);                    // it loads
    m_runTable->horizontalHeader()->setStretchLastSection(false);
    m_about    = wordsLabel("soft");
    auto* part = new QWidget;
    auto* in   = new QVBoxLayout(part);
    in->setContentsMargins(0, 0, 0, 0);
    in->setSpacing(4);
    in->addWidget(m_runTable, 1);
    in->addWidget(m_about);
    return part;
}

QWidget* MeasurePanel::makeDetails()
{
    m_stageTable   = plainTable(m_stages);
    m_counterTable = plainTable(m_counters);
    m_counterTable->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_counterTable->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    auto* part = new QWidget;
    auto* in   = new QVBoxLayout(part);
    in->setContentsMargins(0, 0, 0, 0);
    in->setSpacing(4);
    in->addWidget(m_stageTable, 68);
    in->addWidget(m_counterTable, 32);
    return part;
}

QWidget* MeasurePanel::makeChart()
{
    m_chart = new SpeedErrorChart;
    m_chart->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    m_measure = new ChoiceBox;
    m_measure->addItem(QString(), static_cast<int>(ErrorMeasure::WrongPixels));
    m_measure->addItem(QString(), static_cast<int>(ErrorMeasure::DepthDistance));
    m_measure->setObjectName("compact");
    m_said      = wordsLabel("soft");
    QFont small = m_said->font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    m_said->setFont(small);
    auto* row = new QHBoxLayout;
    row->setSpacing(kStep);
    row->addWidget(m_said, 1);
    row->addWidget(m_measure, 0, Qt::AlignTop);
    auto* part = new QWidget;
    auto* in   = new QVBoxLayout(part);
    in->setContentsMargins(0, 0, 0, 0);
    in->setSpacing(4);
    in->addLayout(row);
    in->addWidget(m_chart, 1);
    return part;
}

void MeasurePanel::connectAll()
{
    connect(m_start, &QPushButton::clicked, this, &MeasurePanel::start);
    connect(m_stop, &QPushButton::clicked, &m_measurer, &Measurer::stop);
    connect(m_save, &QPushButton::clicked, this, &MeasurePanel::askWhere);
    connect(m_open, &QPushButton::clicked, this, &MeasurePanel::askForRecord);
    connect(m_cases, &QComboBox::activated, this, &MeasurePanel::chooseCase);
    connect(&m_measurer, &Measurer::progressed, this, &MeasurePanel::showProgress);
    connect(&m_measurer, &Measurer::ended, this, [this] {
        showProgress();
        showRuns();
    });
    connect(&m_measurer, &Measurer::found, this, [this](const MeasuredView& view) {
        if (view == m_view && !m_case) showRuns();
    });
    connect(&m_measurer, &Measurer::failed, this, [this](const QString& sentence) {
        m_trouble = sentence;
        showProgress();
    });
    connect(m_runTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &MeasurePanel::showRun);
    connect(m_runTable, &QTableView::activated, this, [this] {
        if (const auto run = selected()) load(*run);
    });
    connect(m_chart, &SpeedErrorChart::walked, this, [this](std::size_t point) { select(m_runOfPoint[point]); });
    connect(m_chart, &SpeedErrorChart::chosen, this, [this](std::size_t point) { load(m_runOfPoint[point]); });
    connect(m_measure, &QComboBox::currentIndexChanged, this, &MeasurePanel::showChart);
}

void MeasurePanel::say()
{
    m_what->setAccessibleName(tr("What to time"));
    m_what->setItemText(static_cast<int>(What::This), tr("this algorithm"));
    m_what->setItemText(static_cast<int>(What::Presets), tr("every preset"));
    m_what->setItemText(static_cast<int>(What::Switches), tr("each approximation"));
    m_what->setItemData(static_cast<int>(What::This),
                        tr("The choices that the window draws with now, faults and approximations too"),
                        Qt::ToolTipRole);
    m_what->setItemData(static_cast<int>(What::Presets), tr("All algorithms that have a name"), Qt::ToolTipRole);
    m_what->setItemData(static_cast<int>(What::Switches),
                        tr("This algorithm made exact, then with one exactness given up at a time"), Qt::ToolTipRole);
    m_frames->setAccessibleName(tr("Timed frames of every run"));
    m_frames->setToolTip(tr("Timed frames of every run, after a few to warm up"));
    m_frames->setSuffix(tr(" frames"));
    m_checks->setText(tr("check"));
    m_checks->setToolTip(
        tr("Hold the first picture of every run against the brute-force reference. Without that no error is known, and "
           "nothing is in the chart"));
    m_checks->setAccessibleName(tr("Check every picture against the reference"));
    m_start->setText(tr("Measure"));
    m_stop->setText(tr("Stop"));
    m_save->setText(tr("Save…"));
    m_open->setText(tr("Open…"));
    m_open->setToolTip(
        tr("Opens a record: what 'zscope-cli bench --experiment' measured, or what was saved here. A click on a point "
           "loads its run, scene and camera too"));
    m_cases->setAccessibleName(tr("Whose runs are shown"));
    m_cases->setToolTip(tr("The view in the window, or a case of the record that was opened"));
    fillCases();
    m_progress->setAccessibleName(tr("How far the runs are"));
    m_runTable->setAccessibleName(tr("Runs of this view"));
    m_stageTable->setAccessibleName(tr("Stages of the selected run"));
    m_counterTable->setAccessibleName(tr("Counters of the selected run"));
    m_measure->setAccessibleName(tr("Which error the chart shows"));
    m_measure->setItemText(0, tr("wrong pixels"));
    m_measure->setItemText(1, tr("depth error"));
    m_runs->headerDataChanged(Qt::Horizontal, 0, RunsModel::kColumns - 1);
    showProgress();
    showRuns();
}

// The snapshot ------------------------------------------------------------------------------------------------------

void MeasurePanel::present(const Snapshot&, Changes what)
{
    if (what & (Change::Scene | Change::Camera | Change::Pipeline)) {
        if (const auto view = viewOf(session()); view != m_view) {
            m_view = view;
            m_trouble.clear();
            showRuns();
        }
    }
    if (what & Change::Pipeline) showLoaded();
    if (what & (Change::Scene | Change::Pipeline)) showProgress();
}

void MeasurePanel::start()
{
    m_trouble.clear();
    std::vector<BenchAlgorithm> algorithms;
    const Pipeline&             now = session().now().pipeline;
    switch (static_cast<What>(m_what->currentData().toInt())) {
        case What::This:
            algorithms = {{zscope::nameOf(now), now, claimOf(now)}};
            break;
        case What::Presets:
            algorithms = presetsToTime();
            break;
        case What::Switches:
            algorithms = approximateSwitches(now);
            break;
    }
    m_measurer.start(session(), std::move(algorithms), m_frames->value(), m_checks->isChecked());
    showProgress();
}

void MeasurePanel::showProgress()
{
    const bool isRunning = m_measurer.isRunning(), hasScene = session().now().scene != nullptr;
    for (QWidget* choice :
         {static_cast<QWidget*>(m_what), static_cast<QWidget*>(m_frames), static_cast<QWidget*>(m_checks)})
        choice->setEnabled(!isRunning);
    m_start->setEnabled(!isRunning && hasScene);
    m_start->setToolTip(!hasScene   ? tr("Open a scene first")
                        : isRunning ? tr("Runs are being timed already")
                                    : tr("Checks, times and counts what is chosen, in the background; leave the window "
                                         "alone meanwhile, it takes time from the runs"));
    m_stop->setEnabled(isRunning);
    m_stop->setToolTip(isRunning ? tr("Stops; what is finished stays") : tr("Nothing is being timed"));
    m_progress->setVisible(isRunning);
    m_progress->setValue(static_cast<int>(1000 * m_measurer.progress()));
    m_doing->setText(isRunning ? m_measurer.doing().isEmpty() ? tr("Drawing the reference")
                                                              : tr("Timing %1").arg(m_measurer.doing())
                               : m_trouble);
    m_doing->setToolTip(m_doing->text());
}

void MeasurePanel::showRuns()
{
    const std::vector<Run>& runs = shownRuns();
    std::optional<Pipeline> kept;
    if (const auto run = selected()) kept = m_runs->runs()[*run].pipeline;
    m_runs->setPalette(palette());
    m_runs->present(runs);
    fitColumns();
    m_body->setVisible(!runs.empty());
    m_hint->setVisible(runs.empty());
    m_hint->setText(!m_view ? tr("Open a scene, then measure how long algorithms take on it.")
                            : tr("Nothing has been timed on this view yet. Choose what to time, and press Measure: "
                                 "every run is checked first, then timed, then explained by counters."));
    m_save->setEnabled(!runs.empty());
    m_save->setToolTip(runs.empty() ? tr("There are no runs to save yet: press Measure")
                                    : tr("Saves the runs as a record, which 'zscope --report' reads, or as CSV"));
    showChart();
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].pipeline == kept) select(i);
    if (!selected() && !runs.empty()) m_runTable->setCurrentIndex(m_sorted->index(0, 0));
    showRun();
    showLoaded();
    emit summaryChanged(runs.empty() ? QString() : counted(runs.size(), tr("1 run"), tr("%1 runs")));
}

void MeasurePanel::fitColumns()
{
    m_stageTable->horizontalHeader()->setStretchLastSection(false);
    for (QTableView* table : {m_runTable, m_stageTable})
        for (int column = 0; column < table->model()->columnCount(); ++column) table->resizeColumnToContents(column);
    if (m_isWide) {
        m_stageTable->setColumnWidth(StagesModel::Cost, 60);  // and what is left; the tool tip has it all
        m_stageTable->horizontalHeader()->setStretchLastSection(true);
    }
    // the tool tip has it all
    const int choices = m_runTable->fontMetrics().horizontalAdvance(QStringLiteral("depth-format=fixed")) + 8;
    if (m_isWide && m_runTable->columnWidth(RunsModel::Choices) > choices)
        m_runTable->setColumnWidth(RunsModel::Choices, choices);
}

std::optional<std::size_t> MeasurePanel::selected() const
{
    const QModelIndex at = m_sorted->mapToSource(m_runTable->currentIndex());
    return at.isValid() ? std::optional(static_cast<std::size_t>(at.row())) : std::nullopt;
}

std::optional<std::size_t> MeasurePanel::pointOf(std::size_t run) const
{
    const auto at = std::ranges::find(m_runOfPoint, run);
    return at == m_runOfPoint.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - m_runOfPoint.begin()));
}

void MeasurePanel::showRun()
{
    const auto run = selected();
    m_stages->present(run ? std::optional(m_runs->runs()[*run]) : std::nullopt);
    m_counters->present(run ? std::optional(m_runs->runs()[*run]) : std::nullopt);
    fitColumns();
    m_about->setText(run ? sentenceOf(m_runs->runs()[*run]) : QString());
    m_chart->setCurrent(run ? pointOf(*run) : std::nullopt);
}

void MeasurePanel::showChart()
{
    const auto                   measure = static_cast<ErrorMeasure>(m_measure->currentData().toInt());
    std::vector<SpeedErrorPoint> points;
    m_runOfPoint.clear();
    for (std::size_t i = 0; i < m_runs->runs().size(); ++i) {
        const BenchRow& row = m_runs->runs()[i].row;
        if (!row.figures || !(row.q1Ms > 0)) continue;
        m_runOfPoint.push_back(i);
        points.push_back({QString::fromStdString(row.algorithm), row.medianMs, row.q1Ms, row.q3Ms,
                          errorOf(row, measure), markOf(row)});
    }
    m_said->setText(sentenceOf(points, measure));
    m_chart->setPoints(std::move(points), measure);
    if (const auto run = selected()) m_chart->setCurrent(pointOf(*run));
    showLoaded();
}

void MeasurePanel::showLoaded()
{
    std::optional<std::size_t> loaded;
    const RecordCase*          seen = m_case ? &m_record->cases[*m_case] : nullptr;
    if (seen && m_view != MeasuredView{seen->sceneDigest, seen->camera, seen->faceCulling})
        return m_chart->setLoaded({});
    for (std::size_t point = 0; point < m_runOfPoint.size(); ++point)
        if (m_runs->runs()[m_runOfPoint[point]].pipeline == session().now().pipeline) loaded = point;
    m_chart->setLoaded(loaded);
}

void MeasurePanel::select(std::size_t run)
{
    const QModelIndex at = m_sorted->mapFromSource(m_runs->index(static_cast<int>(run), 0));
    m_runTable->setCurrentIndex(at);
    m_runTable->scrollTo(at);
}

void MeasurePanel::load(std::size_t run)
{
    const Run& chosen = m_runs->runs()[run];
    if (!pipelineNamed(chosen.row.algorithm)) {
        m_trouble =
            tr("%1 is another program: it cannot be loaded here.").arg(QString::fromStdString(chosen.row.algorithm));
        return showProgress();
    }
    session().setPipeline(chosen.pipeline);
    if (!m_case) return;
    const RecordCase& seen = m_record->cases[*m_case];
    if (seen.word.empty() || m_view == MeasuredView{seen.sceneDigest, seen.camera, seen.faceCulling}) return;
    session().setFaceCulling(seen.faceCulling);
    session().open(QString::fromStdString(seen.word), Session::seenBy(seen.camera, seen.faceCulling));
}

// Files -------------------------------------------------------------------------------------------------------------

const std::vector<Run>& MeasurePanel::shownRuns() const { return m_case ? m_recorded : m_measurer.runsOf(m_view); }

std::optional<QString> MeasurePanel::saveTo(const QString& file) const
{
    std::vector<BenchRow> rows;
    for (const Run& run : m_runs->runs()) rows.push_back(run.row);
    const bool  isTable = file.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive);
    std::string text;
    if (isTable)
        text = benchToCsv(rows);
    else if (m_case)
        text = recordToJson(*m_record);
    else if (m_view && session().now().scene)
        text = recordToJson(recordOf(session(), *m_view, rows));
    if (const auto done = writeFile(QFile::encodeName(file).toStdString(), text); !done) return said(done.error());
    return {};
}

std::optional<QString> MeasurePanel::openRecord(const QString& file)
{
    const std::string name = QFile::encodeName(file).toStdString();
    const auto        text = readRegularFile(name, kMaxRecordFile);
    if (!text) return said(text.error());
    auto record = recordFromJson(*text, name);
    if (!record) return said(record.error());
    if (record->cases.empty()) return tr("%1 has no case that was measured yet.").arg(QDir::toNativeSeparators(file));
    for (const RecordCase& each : record->cases)
        if (const auto rows = rowsOf(each); !rows) return said(rows.error());
    m_record = *std::move(record);
    fillCases();
    m_cases->setCurrentIndex(1);
    chooseCase(1);
    return {};
}

void MeasurePanel::askForRecord()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Open a record"), QString(), tr("Records (*.json)"));
    if (file.isEmpty()) return;
    m_trouble = openRecord(file).value_or(QString());
    showProgress();
}

void MeasurePanel::fillCases()
{
    const int at = m_cases->currentIndex();
    m_cases->clear();
    m_cases->addItem(tr("The view in the window"));
    if (m_record)
        for (const RecordCase& each : m_record->cases) {
            // the language that is spoken
            const std::string& part = tr("en") == QStringLiteral("zh_CN") ? each.part.chinese : each.part.english;
            m_cases->addItem(
                QStringLiteral("%1: %2").arg(QString::fromStdString(part), QString::fromStdString(each.scene)));
        }
    m_cases->setCurrentIndex(at);
    m_cases->setVisible(m_record.has_value());
}

void MeasurePanel::chooseCase(int at)
{
    m_case = at > 0 ? std::optional(static_cast<std::size_t>(at - 1)) : std::nullopt;
    m_recorded.clear();
    if (m_case) {
        auto rows = rowsOf(m_record->cases[*m_case]);  // has been read before
        if (rows)
            for (BenchRow& row : *rows) {
                const Pipeline pipeline = pipelineNamed(row.algorithm).value_or(Pipeline{});
                m_recorded.push_back({pipeline, std::move(row)});
            }
    }
    showRuns();
}

void MeasurePanel::askWhere()
{
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save the runs of this view"), QStringLiteral("runs.json"),
                                     tr("Records (*.json);;CSV, the table (*.csv)"));
    if (file.isEmpty()) return;
    m_trouble = saveTo(file).value_or(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
    showProgress();
}

// Size and looks ----------------------------------------------------------------------------------------------------

void MeasurePanel::arrange()
{
    const bool isWide = width() >= kWideFrom;
    if (isWide == m_isWide && m_isArranged) return;
    m_isArranged = true;
    m_isWide     = isWide;
    m_columns->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_controls->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_runTable->setMinimumHeight((isWide ? 4 : 8) * kRowHeight);
    m_stageTable->setMinimumHeight((isWide ? 5 : 9) * kRowHeight);
    m_counterTable->setMinimumHeight((isWide ? 3 : 6) * kRowHeight);
    m_chart->setMinimumHeight(isWide ? 140 : 280);
    fitColumns();
}

void MeasurePanel::resizeEvent(QResizeEvent* event)
{
    Panel::resizeEvent(event);
    arrange();
}

void MeasurePanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_isArranged) m_runs->setPalette(palette());
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
