// SPDX-License-Identifier: GPL-3.0-or-later
// A record becomes one page that needs nothing but itself, in both languages, and charts beside it.
#include <cmath>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "core/io/file_writer.h"
#include "core/measure/record.h"
#include "tests/ui/ui_test.h"
#include "ui/report/report.h"
#include "ui/report/report_charts.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

BenchRow row(const std::string& algorithm, double ms, std::uint64_t wrong, Claim claim)
{
    BenchRow made;
    made.algorithm   = algorithm;
    made.claim       = claim;
    made.simd        = Simd::Scalar;
    made.pixels      = 100;
    made.wrongPixels = wrong;
    made.figures.emplace();
    made.figures->holes = wrong;
    made.bestMs = made.q1Ms = made.medianMs = made.q3Ms = ms;
    made.roundMs                                        = {ms, ms, ms};
    made.stageMs[1] = ms / 4, made.stageMs[6] = 3 * ms / 4;
    return made;
}

/// Two cases along an axis, one exact baseline, one approximate run, one that is wrong though it should not be.
std::string smallRecord()
{
    const auto experiment = experimentFromJson(
        R"({"title":{"en":"A question","zh_CN":"一个问题"},"question":{"en":"Which?","zh_CN":"哪个？"},"baseline":"zbuffer",
            "parts":[
           {"title":{"en":"Part <one>","zh_CN":"第一部分"},"x":{"en":"triangles","zh_CN":"三角形"},"scenes":["a","b"],
               "algorithms":["zbuffer"]}]})",
        "e.json");
    Series series;
    series.frames.resize(6);
    for (std::size_t i = 0; i < series.frames.size(); ++i)
        series.frames[i].ms = 1 + static_cast<double>(i), series.frames[i].covered = 50,
        series.frames[i].wrongPixels = i == 3 ? 9 : 0;
    series.lags = {{3, 1}};
    Record record{recordHeadFor(*experiment), {}};
    for (std::size_t i = 0; i < 2; ++i) {
        const double ms = i == 0 ? 1 : 100;
        std::vector rows{row("zbuffer", ms, 0, Claim::Exact), row("zbuffer+snap=4-bits", ms / 2, 7, Claim::Approximate),
                         row("scanline", 2 * ms, 3, Claim::Exact)};
        if (i == 1) rows[1].series = series;
        record.add({.index       = i,
                    .part        = experiment->parts[0].title,
                    .x           = experiment->parts[0].x,
                    .scene       = i == 0 ? "small" : "large",
                    .sceneDigest = "d",
                    .place       = i == 0 ? 10.0 : 1000.0,
                    .width       = 10,
                    .height      = 10,
                    .rows        = benchToJson(rows)});
    }
    return recordToJson(record);
}

QString contents(const QString& file)
{
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? QString::fromUtf8(opened.readAll()) : QString();
}

}  // namespace

class ReportTest final : public QObject {
    Q_OBJECT

private slots:
    void aRecordBecomesAPageThatNeedsNothingButItself()
    {
        QTemporaryDir folder;
        const QString record = folder.filePath("r.json");
        QVERIFY(writeFile(record.toStdString(), smallRecord()));
        const auto page = writeReport(record.toStdString(), folder.filePath("out").toStdString());
        QVERIFY2(page, page ? "" : page.error().sentence.c_str());
        const QString html = contents(QString::fromStdString(*page));
        QVERIFY(html.contains("A question") && html.contains("一个问题"));
        QVERIFY(html.contains("Part &lt;one&gt;") && html.contains("第一部分"));
        QVERIFY(html.contains("median ms") && html.contains("中位数"));
        QVERIFY2(!html.contains(QRegularExpression("(src|href)=\"(?!data:)")), "the page asks for another file");
        QVERIFY(!html.contains("<script"));
    }

    void theTimeOfAWrongPictureIsStruckOut()
    {
        QTemporaryDir folder;
        const QString record = folder.filePath("r.json");
        QVERIFY(writeFile(record.toStdString(), smallRecord()));
        QVERIFY(writeReport(record.toStdString(), folder.filePath("out").toStdString()));
        const QString html = contents(folder.filePath("out/index.html"));
        QVERIFY(html.contains("<s>200.000</s>") && html.contains("3, wrong"));
        QVERIFY(html.contains("<td>50.000</td>"));  // an approximate one only says its error
        QVERIFY(html.contains("<td>0.50</td>"));
    }

    void aSeriesTellsItsWorstFrameAndItsLag()
    {
        QTemporaryDir folder;
        const QString record = folder.filePath("r.json");
        QVERIFY(writeFile(record.toStdString(), smallRecord()));
        QVERIFY(writeReport(record.toStdString(), folder.filePath("out").toStdString()));
        const QString html = contents(folder.filePath("out/index.html"));
        // frames, slowest, wrong frames, worst share, wrong frames after the cut
        QVERIFY(html.contains("<td>6</td><td>6.000</td><td>1</td><td>18.00</td><td>1</td>"));
        QVERIFY(!QFile::exists(folder.filePath("out/1-series-1.png")));  // the small case has not moved
    }

    void everyChartHasAPictureInBothLanguages()
    {
        QTemporaryDir folder;
        const QString record = folder.filePath("r.json");
        QVERIFY(writeFile(record.toStdString(), smallRecord()));
        QVERIFY(writeReport(record.toStdString(), folder.filePath("out").toStdString()));
        for (const char* name :
             {"1-stages", "1-growth", "1-break-even", "1-speed-error-1", "1-speed-error-2", "1-series-2", "1-lag-2"})
            for (const char* language : {"", "-zh_CN"}) {
                const QImage image(folder.filePath(QStringLiteral("out/%1%2.png").arg(name, language)));
                QVERIFY2(image.width() == 1800, name);
                int ink = 0;
                for (int y = 0; y < image.height(); y += 3)
                    for (int x = 0; x < image.width(); x += 3) ink += qGray(image.pixel(x, y)) < 200;
                QVERIFY2(ink > 500, name);
            }
    }

    void growthIsTheSlopeOnLogarithmicAxes()
    {
        const std::vector<double> x{1, 10, 100, 1000};
        std::vector<double>       y;
        for (const double each : x) y.push_back(3 * std::pow(each, 0.75));
        QVERIFY(std::abs(growthExponent(x, y) - 0.75) < 1e-12);
    }

    void whatIsNoRecordIsRefused()
    {
        QTemporaryDir folder;
        const QString record = folder.filePath("r.json");
        QVERIFY(!writeReport(record.toStdString(), folder.filePath("out").toStdString()));
        QVERIFY(writeFile(record.toStdString(), smallRecord().substr(0, 400)));
        const auto page = writeReport(record.toStdString(), folder.filePath("out").toStdString());
        QVERIFY(!page);
        QCOMPARE(QString::fromStdString(page.error().file), record);
        QVERIFY(!QDir(folder.filePath("out")).exists());
    }
};

ZSCOPE_UI_TEST(ReportTest, "report_test", Window)
#include "report_test.moc"
