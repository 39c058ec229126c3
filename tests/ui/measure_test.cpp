// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring as a person does it: press, see runs come, take one apart, click a point, stop, close in the middle.
// Nothing here depends on how long anything takes.
#include <limits>
#include <set>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTableView>

#include "core/measure/approximate_switches.h"
#include "core/scene/camera_path.h"
#include "tests/ui/measuring_desk.h"
#include "tests/ui/ui_test.h"
#include "ui/charts/speed_error_chart.h"
#include "ui/panels/measure/measure_panel.h"
#include "ui/panels/measure/runs_model.h"
#include "ui/panels/measure/stages_model.h"
#include "ui/text/numbers.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

const Pipeline& pipelineOf(std::string_view name) { return findPreset(name)->pipeline; }

BenchRow rowWith(Claim claim, std::uint64_t wrong)
{
    BenchRow row;
    row.algorithm   = "zbuffer";
    row.claim       = claim;
    row.wrongPixels = wrong;
    row.figures.emplace();
    row.figures->pixels  = 100;
    row.figures->covered = 90;
    row.figures->holes   = wrong;
    row.q1Ms = row.medianMs = row.q3Ms = row.bestMs = 1;
    return row;
}

}  // namespace

class MeasureTest final : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QCoreApplication::processEvents(); }

    void everyPresetBecomesARowThatIsRightAndAPointInTheBandOfZero()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.said().contains("Nothing has been timed on this view yet"));
        QVERIFY(desk.measure(MeasurePanel::What::Presets, 3));
        QCOMPARE(desk.runs()->model()->rowCount(), static_cast<int>(presetsToTime().size()));
        QCOMPARE(desk.chart().points().size(), presetsToTime().size());
        QSet<QString> names;
        for (const Run& run : desk.measurer().runsOf(viewOf(desk.session))) {
            names << QString::fromStdString(run.row.algorithm);
            QCOMPARE(run.row.wrongPixels.value_or(1), std::uint64_t{0});
            QVERIFY(run.row.q1Ms <= run.row.medianMs && run.row.medianMs <= run.row.q3Ms);
        }
        QCOMPARE(names.size(), static_cast<qsizetype>(presetsToTime().size()));
        const SpeedErrorChart& chart   = desk.chart();
        const double           bandTop = chart.yAxis->coordToPixel(chart.errorScale().bandTop);
        for (std::size_t i = 0; i < chart.points().size(); ++i) QVERIFY(chart.placeOf(i).y() > bandTop);
        QVERIFY(chart.accessibleDescription().contains("The fastest without error is"));
        QVERIFY(chart.accessibleDescription().contains("No error buys more speed"));
    }
    void namesInTheChartStayInsideTheAxesAndApartFromEachOther()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.measure(MeasurePanel::What::Presets));
        for (const QSize& size : {QSize(1280, 800), QSize(1920, 1080)}) {
            desk.window.resize(size);
            QTest::qWait(50);
            const auto&  labels = desk.chart().labels();
            const QRectF inside = desk.chart().axisRect()->rect();
            int          placed = 0;
            for (std::size_t i = 0; i < labels.size(); ++i) {
                if (!labels[i]) continue;
                ++placed;
                QVERIFY(inside.contains(labels[i]->rect));
                // none has an error
                QVERIFY(labels[i]->rect.top() >= desk.chart().yAxis->coordToPixel(desk.chart().errorScale().bandTop));
                for (std::size_t j = 0; j < i; ++j) QVERIFY(!labels[j] || !labels[j]->rect.intersects(labels[i]->rect));
            }
            QVERIFY(placed >= 3);
        }
    }
    void clickingAPointLoadsItsPipelineAndSelectsItsRow()
    {
        MeasuringDesk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.measure(MeasurePanel::What::Switches));
        Pipeline wanted           = pipelineOf("zbuffer");
        wanted.approximation.near = NearPlane::Drop;
        const QString name        = QString::fromStdString(zscope::nameOf(wanted));
        const auto    point       = desk.pointNamed(name);
        QVERIFY(point);
        // Others may stand on the same spot: click where this one is the nearest, else it is the first of those.
        QTest::mouseClick(&desk.chart(), Qt::LeftButton, {}, desk.chart().placeOf(*point).toPoint());
        QVERIFY(desk.chart().current());
        const QString reached = desk.chart().points()[*desk.chart().current()].name;
        QCOMPARE(QString::fromStdString(zscope::nameOf(desk.session.now().pipeline)), reached);
        const auto* sorted = static_cast<QSortFilterProxyModel*>(desk.runs()->model());
        const int   row    = sorted->mapToSource(desk.runs()->currentIndex()).row();
        QCOMPARE(QString::fromStdString(
                     desk.measurer().runsOf(viewOf(desk.session))[static_cast<std::size_t>(row)].row.algorithm),
                 reached);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().frame->pipeline == desk.session.now().pipeline);
    }
    void arrowKeysWalkThePointsAndEnterLoads()
    {
        MeasuringDesk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.measure(MeasurePanel::What::Presets));
        SpeedErrorChart& chart = desk.chart();
        chart.setFocus();
        QTest::keyClick(&chart, Qt::Key_Home);
        QVERIFY(chart.current());
        std::set<std::size_t> seen{*chart.current()};
        double                ms = chart.points()[*chart.current()].ms;
        for (std::size_t i = 1; i < chart.points().size(); ++i) {
            QTest::keyClick(&chart, Qt::Key_Right);
            QVERIFY(chart.points()[*chart.current()].ms >= ms);
            ms = chart.points()[*chart.current()].ms;
            seen.insert(*chart.current());
        }
        QCOMPARE(seen.size(), chart.points().size());
        QTest::keyClick(&chart, Qt::Key_Left);
        const QString name = chart.points()[*chart.current()].name;
        QVERIFY(chart.accessibleDescription().contains(name + ","));
        QTest::keyClick(&chart, Qt::Key_Return);
        QCOMPARE(QString::fromStdString(zscope::nameOf(desk.session.now().pipeline)), name);
        QVERIFY(desk.settles());
    }
    void aFaultAndAnApproximationStandAboveTheBandWithTheirFigures()
    {
        MeasuringDesk desk("edge-walk");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(desk.measure(MeasurePanel::What::This));
        Pipeline faulty = pipelineOf("edge-walk");
        faulty.fault    = Fault::XTruncated;
        desk.session.setPipeline(faulty);
        QVERIFY(desk.settles());
        QVERIFY(desk.measure(MeasurePanel::What::This));
        const SpeedErrorChart& chart = desk.chart();
        QCOMPARE(chart.points().size(), std::size_t{2});
        const auto wrong = desk.pointNamed(QString::fromStdString(zscope::nameOf(faulty))),
                   right = desk.pointNamed("edge-walk");
        QVERIFY(wrong && right);
        const double bandTop = chart.yAxis->coordToPixel(chart.errorScale().bandTop);
        QVERIFY(chart.placeOf(*wrong).y() < bandTop);
        QVERIFY(chart.placeOf(*right).y() > bandTop);
        QVERIFY(chart.points()[*wrong].error >= 1);
        QCOMPARE(chart.points()[*wrong].mark, RunMark::Approximate);
        for (const Run& run : desk.measurer().runsOf(viewOf(desk.session)))
            if (run.pipeline == faulty)
                QCOMPARE(static_cast<double>(run.row.figures->wrongPixels()), chart.points()[*wrong].error);
    }
    void aWrongExactRunIsStruckOutAndCalledWrong()
    {
        RunsModel model;
        model.present({{pipelineOf("zbuffer"), rowWith(Claim::Exact, 3)},
                       {pipelineOf("zbuffer"), rowWith(Claim::Exact, 0)},
                       {pipelineOf("zbuffer"), rowWith(Claim::Approximate, 3)}});
        const auto isStruck = [&](int row, RunsModel::Column column) {
            return model.index(row, column).data(Qt::FontRole).value<QFont>().strikeOut();
        };
        QVERIFY(isStruck(0, RunsModel::Median) && isStruck(0, RunsModel::Best));
        QVERIFY(!isStruck(0, RunsModel::Wrong));
        QVERIFY(!isStruck(1, RunsModel::Median) && !isStruck(2, RunsModel::Median));
        QVERIFY(sentenceOf(model.runs()[0]).contains("Its time is no result"));
        QVERIFY(!sentenceOf(model.runs()[2]).contains("no result"));
        QVERIFY(model.index(0, RunsModel::Algorithm).data().toString()
                != model.index(1, RunsModel::Algorithm).data().toString());
        QCOMPARE(markOf(model.runs()[0].row), RunMark::Broken);
        const std::vector<SpeedErrorPoint> points{{"a", 1, 1, 1, 3, RunMark::Broken},
                                                  {"b", 2, 2, 2, 0, RunMark::Exact}};
        QCOMPARE(worthChoosing(points), std::vector<std::size_t>{1});
        QVERIFY(sentenceOf(points, ErrorMeasure::WrongPixels).contains("1 is wrong although it promised to be exact"));
    }
    void theSelectedRunIsTakenApart()
    {
        MeasuringDesk desk("hzb-octree");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(desk.measure(MeasurePanel::What::This));
        const auto* stages = desk.table("Stages of the selected run")->model();
        const auto* counts = desk.table("Counters of the selected run")->model();
        QVERIFY(stages->rowCount() >= 4);
        QVERIFY(counts->rowCount() >= 10);
        double shares = 0;
        bool   nodes  = false;
        for (int row = 0; row + 1 < stages->rowCount(); ++row) {
            shares += stages->index(row, StagesModel::Share).data().toString().toDouble();
            nodes |= stages->index(row, StagesModel::Cost).data().toString().contains("/ node");
        }
        QVERIFY(std::abs(shares - 100) < 1);
        QVERIFY(nodes);
        QCOMPARE(stages->index(stages->rowCount() - 1, StagesModel::Name).data().toString(), QString("frame"));
        QVERIFY(desk.said().contains("the reference's, to the bit"));
        QTest::qWait(50);
        QTableView* table = desk.table("Stages of the selected run");
        QFont       bold  = table->font();
        bold.setBold(true);  // the frame's
        QVERIFY(table->columnWidth(StagesModel::Cost)
                >= QFontMetrics(bold).horizontalAdvance("999 / triangle \u00B7 99.9 / pixel"));
    }
    void stoppingInTheMiddleKeepsWhatIsFinishedAndTheWindowGoesOn()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:teapot"));
        desk.choose(MeasurePanel::What::Presets, 2000);
        desk.press("Measure");
        QVERIFY(QTest::qWaitFor([&] { return desk.runs()->model()->rowCount() >= 1; }, Desk::kLong));
        desk.session.moveCamera([](CameraControl& camera) { camera.orbit(0.2, 0.1); });  // nothing waits for the runs
        QVERIFY(desk.settles());
        QCOMPARE(desk.runs()->model()->rowCount(), 0);  // of another view
        desk.session.resetCamera();
        QVERIFY(desk.settles());
        QVERIFY(desk.measurer().isRunning());
        desk.press("Stop");
        QVERIFY(!desk.measurer().isRunning());
        QVERIFY(desk.button("Measure")->isEnabled());
        const int kept = desk.runs()->model()->rowCount();
        QVERIFY(kept >= 1 && kept < static_cast<int>(presetsToTime().size()));
        QVERIFY(desk.measure(MeasurePanel::What::This, 1));
        QVERIFY(desk.runs()->model()->rowCount() >= kept);
    }
    void aKeyStartsAndAKeyStopsInWhateverLayout()
    {
        Desk  desk("zbuffer");
        auto* start = desk.window.findChild<QAction*>("measure.start");
        auto* stop  = desk.window.findChild<QAction*>("measure.stop");
        QVERIFY(start && stop);
        QVERIFY(!start->isEnabled() && !stop->isEnabled());  // nothing to measure yet
        desk.window.useLayout("teach");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(start->isEnabled() && !stop->isEnabled());
        auto& panel = static_cast<MeasurePanel&>(desk.window.dock("measure")->panel());
        panel.findChild<QSpinBox*>()->setValue(10'000);
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.press(Qt::Key_F8);
        QVERIFY(panel.isVisible());
        QTRY_VERIFY2(panel.height() > desk.window.height() * 3 / 10, "a strip shows no runs");
        QVERIFY(panel.measurer().isRunning());
        QVERIFY(!start->isEnabled() && stop->isEnabled());
        desk.press(Qt::Key_F8, Qt::ShiftModifier);
        QVERIFY(!panel.measurer().isRunning());
        QVERIFY(start->isEnabled() && !stop->isEnabled());
    }
    void closingInTheMiddleEndsTheRuns()
    {
        for (const int wait : {0, 5, 40}) {
            MeasuringDesk desk;
            QVERIFY(desk.open("builtin:teapot"));
            desk.choose(MeasurePanel::What::Presets, 10'000);
            desk.press("Measure");
            QTest::qWait(wait);
            QVERIFY(desk.measurer().isRunning());
            desk.window.close();
        }
    }
    void anotherSceneOrSizeHasAListOfItsOwnAndTheOldOneComesBack()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.measure(MeasurePanel::What::This));
        QCOMPARE(desk.runs()->model()->rowCount(), 1);
        QVERIFY(desk.open("builtin:teapot"));
        QCOMPARE(desk.runs()->model()->rowCount(), 0);
        QVERIFY(desk.open("builtin:cubes", {200, 100}));
        QCOMPARE(desk.runs()->model()->rowCount(), 0);
        QVERIFY(desk.open("builtin:cubes"));
        QCOMPARE(desk.runs()->model()->rowCount(), 1);
        QVERIFY(desk.measure(MeasurePanel::What::This));  // the same again: the newer takes its place
        QCOMPARE(desk.runs()->model()->rowCount(), 1);
    }
    void aHeaderSortsByNumbers()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.measure(MeasurePanel::What::Presets));
        const auto values = [&] {
            std::vector<double> all;
            for (int row = 0; row < desk.runs()->model()->rowCount(); ++row)
                all.push_back(desk.runs()->model()->index(row, RunsModel::Best).data(RunsModel::kSortRole).toDouble());
            return all;
        };
        auto* header = desk.runs()->horizontalHeader();
        desk.runs()->scrollTo(desk.runs()->model()->index(0, RunsModel::Best));
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {},
                          QPoint(header->sectionViewportPosition(RunsModel::Best) + 8, header->height() / 2));
        QCOMPARE(header->sortIndicatorSection(), static_cast<int>(RunsModel::Best));
        const bool rises  = header->sortIndicatorOrder() == Qt::AscendingOrder;
        auto       sorted = values();
        QVERIFY(rises ? std::ranges::is_sorted(sorted) : std::ranges::is_sorted(sorted, std::greater<>()));
    }
    void modelsKeepTheRulesOfModels()
    {
        RunsModel             runs;
        QSortFilterProxyModel sorted;
        StagesModel           stages;
        CountersModel         counters;
        sorted.setSourceModel(&runs);
        std::vector<std::unique_ptr<QAbstractItemModelTester>> testers;
        for (QAbstractItemModel* model :
             {static_cast<QAbstractItemModel*>(&runs), static_cast<QAbstractItemModel*>(&sorted),
              static_cast<QAbstractItemModel*>(&stages), static_cast<QAbstractItemModel*>(&counters)})
            testers.push_back(std::make_unique<QAbstractItemModelTester>(
                model, QAbstractItemModelTester::FailureReportingMode::Fatal));
        BenchRow row                                              = rowWith(Claim::Exact, 0);
        row.counters                                              = {{"nodes_visited", 12}, {"edges", 0}};
        row.stageQuartiles[static_cast<std::size_t>(Stage::Cull)] = {1, 2, 3};
        const Run run{pipelineOf("hzb-octree"), row};
        runs.present({run, run});
        stages.present(run);
        counters.present(run);
        QCOMPARE(stages.rowCount(), 2);
        QCOMPARE(counters.rowCount(), 1);
        sorted.sort(RunsModel::Median, Qt::DescendingOrder);
        runs.present({run});
        runs.setPalette(QPalette());
        stages.present({});
        counters.present({});
        runs.present({});
    }
    void whatIsSavedIsWhatIsShown()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.measure(MeasurePanel::What::This));
        const QString json = desk.folder.filePath(QStringLiteral("结果.json")), csv = desk.folder.filePath("runs.CSV");
        QVERIFY(!desk.panel().saveTo(json));
        QVERIFY(!desk.panel().saveTo(csv));
        QFile file(json);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject record = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(record["record"].toInt(), 1);
        QCOMPARE(record["cases"].toArray().size(), 1);
        QCOMPARE(record["cases"].toArray()[0].toObject()["word"].toString(), QString("builtin:cubes"));
        const QJsonArray rows = record["cases"].toArray()[0].toObject()["rows"].toArray();
        QCOMPARE(rows.size(), 1);
        QCOMPARE(rows[0].toObject()["algorithm"].toString(), QString("zbuffer"));
        QVERIFY(rows[0].toObject().contains("stage_quartiles"));
        QFile table(csv);
        QVERIFY(table.open(QIODevice::ReadOnly));
        QVERIFY(table.readLine().startsWith("scene,algorithm,threads"));
        QVERIFY(desk.panel().saveTo("/no/such/folder/runs.json"));
    }
    void aRecordThatIsOpenedShowsItsRunsAndAClickLoadsOneWithItsView()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        QVERIFY(desk.measure(MeasurePanel::What::This));
        const QString file = desk.folder.filePath("r.json");
        QVERIFY(!desk.panel().saveTo(file));
        const Camera seen = desk.session.now().camera;
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.setPipeline(findPreset("scanline")->pipeline);
        QVERIFY(desk.settles());
        auto* table = desk.runs();
        QCOMPARE(table->model()->rowCount(), 0);  // nothing has been timed on the teapot
        QVERIFY(!desk.panel().openRecord(file));
        QCOMPARE(table->model()->rowCount(), 1);
        QTest::qWait(50);
        if (const QString where = qEnvironmentVariable("ZSCOPE_PICTURES"); !where.isEmpty())
            desk.window.grab().save(where + "/record.png");
        table->setCurrentIndex(table->model()->index(0, 0));
        emit table->activated(table->currentIndex());
        QVERIFY(desk.settles());
        QCOMPARE(desk.session.now().pipeline, findPreset("zbuffer")->pipeline);
        QCOMPARE(desk.session.now().scene->word, QString("builtin:cubes"));
        QVERIFY(desk.session.now().camera == seen);
        QVERIFY(desk.panel().openRecord(desk.folder.filePath("nowhere.json")));
        QCOMPARE(table->model()->rowCount(), 1);  // what cannot be opened changes nothing
    }
    void whatCannotBePressedSaysWhy()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        for (const char* word : {"measure", "compare", "why"})
            for (const auto* button : desk.window.dock(word)->findChildren<QPushButton*>()) {
                if (button->isHidden()
                    || !(button->text() == "Save…" || button->text() == "Stop" || button->text() == "Swap"
                         || button->text() == "Go there"))
                    continue;
                QVERIFY(!button->isEnabled());
                QVERIFY2(QRegularExpression("^(There|Nothing|Choose)").match(button->toolTip()).hasMatch(),
                         qPrintable(button->text() + ": " + button->toolTip()));
            }
        for (const char* name :
             {"compare.to-and-fro", "compare.wipe", "compare.difference", "compare.swap", "compare.end"}) {
            const auto* action = desk.window.findChild<QAction*>(name);
            QVERIFY(!action->isEnabled());
            QVERIFY2(action->toolTip().startsWith("There is no B"), name);
            for (const QObject* at : action->associatedObjects())
                if (const auto* menu = qobject_cast<const QMenu*>(at)) QVERIFY(menu->toolTipsVisible());
        }
        desk.session.compareWith(findPreset("scanline")->pipeline);
        QVERIFY(desk.settles());
        QVERIFY(!desk.window.findChild<QAction*>("compare.wipe")->toolTip().startsWith("There is no B"));
        desk.window.findChild<QAction*>("tool.camera")->trigger();
        QVERIFY(desk.window.findChild<QAction*>("compare.wipe")->toolTip().contains("Inspect"));
    }
    void keyFramesAreRecordedWithTheMenuAndSavedAsAPath()
    {
        MeasuringDesk desk;
        QVERIFY(desk.open("builtin:cubes"));
        const Camera first = desk.session.now().camera;
        desk.window.findChild<QAction*>("path.add")->trigger();
        Camera second = first;
        second.eye += dvec3(0.5, 0, 0);
        ViewRequest view;
        view.width = second.width, view.height = second.height, view.exact = second;
        desk.session.useView(view);
        QVERIFY(desk.settles());
        desk.window.findChild<QAction*>("path.add-cut")->trigger();
        const QString file = desk.folder.filePath("path.json");
        QVERIFY(!desk.window.saveCameraPath(file));
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const auto path = cameraPathFromJson(written.readAll().toStdString(), "path.json");
        QVERIFY2(path, path ? "" : path.error().sentence.c_str());
        QCOMPARE(path->keys.size(), std::size_t{2});
        QCOMPARE(path->cuts(), std::vector<int>{30});
        QVERIFY(path->keys[1].eye == second.eye);
        desk.window.findChild<QAction*>("path.forget")->trigger();
        QVERIFY(desk.window.cameraPath().keys.empty());
    }
    void withoutACheckThereAreRowsAndNoPoints()
    {
        RunsModel model;
        BenchRow  row = rowWith(Claim::Exact, 0);
        row.figures.reset();
        row.wrongPixels.reset();
        model.present({{pipelineOf("zbuffer"), row}});
        QCOMPARE(model.index(0, RunsModel::Wrong).data().toString(), QStringLiteral("\u2013"));
        QCOMPARE(markOf(row), RunMark::Unchecked);
        QVERIFY(sentenceOf(model.runs()[0]).contains("was not checked"));
    }
    void scalesHoldWhatTheyAreMadeForAndZeroHasItsBand()
    {
        for (const std::vector<double>& errors : {std::vector<double>{},
                                                  {0},
                                                  {0, 3, 40'000},
                                                  {2e-7, 0, 0.03},
                                                  {0, 5, std::numeric_limits<double>::infinity()}}) {
            const bool       whole = errors.empty() || errors.back() != 0.03;
            const ErrorScale scale = errorScaleOf(errors, whole);
            QVERIFY(scale.bottom < scale.zero && scale.zero < scale.bandTop && scale.bandTop < scale.floor
                    && scale.floor < scale.top);
            for (const double error : errors) {
                const double place = scale.placeOf(error);
                QVERIFY(place > scale.bottom && place < scale.top);
                QCOMPARE(place < scale.bandTop, error == 0);
            }
            QVERIFY(scale.ticks.size() >= 2);
        }
        for (const std::vector<double>& ms : {std::vector<double>{}, {3.3}, {0.57, 0.61}, {0.01, 900}, {7, 7}}) {
            const TimeScale scale = timeScaleOf(ms);
            QVERIFY(scale.low > 0 && scale.low < scale.high);
            for (const double each : ms) QVERIFY(scale.low < each && each < scale.high);
            QVERIFY(scale.ticks.size() >= 2 && scale.ticks.size() <= 12);
            QVERIFY(std::ranges::is_sorted(scale.ticks));
            for (const double tick : scale.ticks) QVERIFY(tick >= scale.low && tick <= scale.high);
        }
    }
    void namesOfPointsOnOneSpotStandApartOrAreLeftOut()
    {
        const QRectF                   area(0, 0, 200, 120);
        const std::vector<QPointF>     points(12, QPointF(100, 60));
        const std::vector<QSizeF>      sizes(12, QSizeF(80, 14));
        const std::vector<std::size_t> order{3, 0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11};
        const auto                     places = placeLabels(points, sizes, order, std::vector<QRectF>(12, area), 5);
        QVERIFY(places[3] && !places[3]->isFar);
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!places[i]) continue;
            QVERIFY(area.contains(places[i]->rect));
            QVERIFY(!places[i]->rect.intersects(QRectF(95, 55, 10, 10)));
            for (std::size_t j = 0; j < i; ++j) QVERIFY(!places[j] || !places[j]->rect.intersects(places[i]->rect));
        }
        QVERIFY(std::ranges::count_if(places, [](const auto& place) { return place.has_value(); }) >= 6);
        QVERIFY(std::ranges::any_of(places, [](const auto& place) { return !place; }));
    }
    void everythingIsSaidInChineseToo()
    {
        MeasuringDesk desk("edge-walk");
        QVERIFY(desk.open("builtin:teapot"));
        QVERIFY(desk.measure(MeasurePanel::What::Switches));
        desk.window.speak(Language::Chinese);
        QCoreApplication::processEvents();
        const QRegularExpression english("[a-z]{3,} [a-z]{2,} [a-z]{2,}");  // names of algorithms stay
        QStringList              texts{desk.chart().accessibleName(), desk.chart().accessibleDescription(),
                          desk.chart().xAxis->label(), desk.chart().yAxis->label()};
        for (const auto* label : desk.panel().findChildren<QLabel*>()) texts << label->text();
        for (const auto* view : desk.panel().findChildren<QTableView*>())
            for (int column = 0; column < view->model()->columnCount(); ++column) {
                texts << view->model()->headerData(column, Qt::Horizontal).toString()
                      << view->model()->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
                for (int row = 0; row < view->model()->rowCount(); ++row)
                    texts << view->model()->index(row, column).data(Qt::ToolTipRole).toString();
            }
        for (const QString& text : texts) QVERIFY2(!english.match(text).hasMatch(), qPrintable(text));
        QVERIFY(desk.chart().xAxis->label().contains(QStringLiteral("毫秒")));
        desk.window.speak(Language::English);
    }
    void itIsPhotographed()
    {
        if (qEnvironmentVariable("ZSCOPE_PICTURES").isEmpty()) QSKIP("nobody asked for pictures");
        for (const QSize& size : {QSize(1280, 800), QSize(1920, 1080)}) {
            MeasuringDesk desk("edge-walk", size);
            const QString at = QStringLiteral("-%1").arg(size.width());
            QVERIFY(desk.open("builtin:teapot", {640, 360}));
            desk.photograph("measure-empty" + at);
            QVERIFY(desk.measure(MeasurePanel::What::Presets, 10));
            QVERIFY(desk.measure(MeasurePanel::What::Switches, 10));
            desk.session.setPipeline(pipelineOf("scanline"));
            QVERIFY(desk.settles());
            desk.photograph("measure" + at);
            desk.window.speak(Language::Chinese);
            desk.photograph("measure-chinese" + at);
            desk.window.speak(Language::English);
            desk.dress("dark");
            desk.photograph("measure-dark" + at);
            desk.window.speak(Language::Chinese);
            desk.photograph("measure-chinese-dark" + at);
            desk.window.speak(Language::English);
            desk.dress("light");
            desk.window.useLayout("teach");
            desk.window.dock("measure")->setWanted(true);
            desk.photograph("measure-narrow" + at);
        }
    }
};

ZSCOPE_UI_TEST(MeasureTest, "measure_test", Window)
#include "measure_test.moc"
