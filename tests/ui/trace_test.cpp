// SPDX-License-Identifier: GPL-3.0-or-later
// What another program wrote of its steps: dropped on the window it is stepped beside A, and its first wrong row found.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QTreeView>

#include "core/lesson/replay.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/trace/trace_models.h"
#include "ui/panels/trace/trace_panel.h"
#include "ui/session/tracer.h"
#include "ui/text/phrase_book.h"
#include "ui/window/message_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

constexpr QSize kPicture{200, 150};

struct Stepper : Desk {
    explicit Stepper(std::string_view algorithm = "scanline", const QString& scene = "builtin:cubes") : Desk(algorithm)
    {
        isOpen = open(scene, kPicture);
    }
    bool isOpen = false;

    Tracer&         tracer() { return session.tracer(); }
    const Snapshot& now() { return session.now(); }
    TracePanel&     panel() { return static_cast<TracePanel&>(window.dock("trace")->panel()); }

    /// The states of a run as a student's program writes them: one line of JSON per line of the picture.
    std::vector<QJsonObject> rowsOf(std::string_view algorithm, FaceCulling culling = FaceCulling::None)
    {
        DrawRequest request = session.request();
        request.pipeline    = findPreset(algorithm)->pipeline;
        request.faceCulling = culling;
        Replay                   replay(request);
        std::vector<QJsonObject> rows;
        for (std::uint64_t step = 0; step < *replay.count(Grain::Line); ++step) {
            const auto        state = replay.at(Grain::Line, StepIndex{step});
            const auto        json  = QJsonDocument::fromJson(QByteArray::fromStdString(stateToJson(*state)));
            const QJsonObject all   = json.object();
            if (state->event != Grain::Line) continue;
            rows.push_back({{"line", all["line"]}, {"active_edges", all["active_edges"]}, {"spans", all["spans"]}});
        }
        return rows;
    }
    QString write(const QString& name, const std::vector<QJsonObject>& rows)
    {
        const QString path = folder.filePath(name);
        QFile         file(path);
        [&] { QVERIFY(file.open(QIODevice::WriteOnly)); }();
        for (const QJsonObject& row : rows) file.write(QJsonDocument(row).toJson(QJsonDocument::Compact) + '\n');
        return path;
    }
    void drop(const QString& path)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &event);
    }
    /// Judged, and the step and the fields of the row are there.
    bool isThere()
    {
        return QTest::qWaitFor([&] { return tracer().isIdle(); }, kLong) && settles()
               && QTest::qWaitFor([&] { return !tracer().row() || tracer().fields(); }, kLong) && settles();
    }
    int lineOfStep() { return now().sweep() ? now().sweep()->y : -1; }
    int lineOfRow()
    {
        const auto row = tracer().row();
        return row ? static_cast<int>(tracer().trace()->trace->rows[*row].key.a) : -1;
    }
    template <class Kind>
    Kind* named(const QString& accessibleName)
    {
        for (auto* part : panel().findChildren<Kind*>())
            if (part->accessibleName() == accessibleName) return part;
        return nullptr;
    }
    QPushButton* button(const QString& text)
    {
        for (auto* each : panel().findChildren<QPushButton*>())
            if (each->text() == text) return each;
        return nullptr;
    }
    QString    sentence() { return named<QLabel>("What differs")->text(); }
    QTreeView& rows() { return *named<QTreeView>("Rows of the trace"); }
    QTreeView& fields() { return *named<QTreeView>("Fields of the row: ours and yours"); }
    /// What stands in the table of fields, "✖ polygon 95 | – | 12".
    QStringList fieldTexts()
    {
        QStringList texts;
        const auto& model = *fields().model();
        for (int row = 0; row < model.rowCount(); ++row) {
            QStringList cells;
            for (int column = 0; column < TraceFieldsModel::kColumns; ++column)
                cells << model.index(row, column).data().toString().trimmed();
            texts << cells.join('|');
        }
        return texts;
    }
};

/// A student's mistake: on some line the table still holds an edge whose last line is over.
struct Spoilt {
    std::vector<QJsonObject> rows;
    std::size_t              row     = 0;
    int                      line    = 0;
    int                      polygon = 0;
};
Spoilt keepsAnEdge(std::vector<QJsonObject> rows)
{
    Spoilt spoilt{std::move(rows)};
    for (std::size_t i = 40; i + 1 < spoilt.rows.size(); ++i) {
        for (const QJsonValue& edge : spoilt.rows[i]["active_edges"].toArray()) {
            if (edge["last_line"].toInt() != spoilt.rows[i]["line"].toInt()) continue;
            QJsonObject& next  = spoilt.rows[i + 1];
            QJsonArray   edges = next["active_edges"].toArray();
            edges.append(edge);
            next["active_edges"] = edges;
            spoilt.row           = i + 1;
            spoilt.line          = next["line"].toInt();
            spoilt.polygon       = edge["polygon"].toInt();
            return spoilt;
        }
    }
    return spoilt;
}

}  // namespace

class TraceTest final : public QObject {
    Q_OBJECT

private slots:
    void aWrongRowIsFoundAndStandsBesideOurs()
    {
        Stepper student;
        QVERIFY(student.isOpen);
        const Spoilt spoilt = keepsAnEdge(student.rowsOf("scanline"));
        QVERIFY(spoilt.row > 0);
        student.drop(student.write("steps.jsonl", spoilt.rows));
        QVERIFY(student.isThere());

        QVERIFY(student.panel().isVisible());
        const QString sentence =
            QString("On line %1 your table still holds an edge of polygon %2, whose last line was %3.")
                .arg(spoilt.line)
                .arg(spoilt.polygon)
                .arg(spoilt.line - 1);
        QCOMPARE(student.sentence(),
                 QString("Line %1 of the trace is the first that differs from scanline. %2 Rows that "
                         "differ: 1 of %3.")
                     .arg(spoilt.row + 1)
                     .arg(sentence)
                     .arg(spoilt.rows.size()));
        QVERIFY(student.tracer().row() == spoilt.row);
        QCOMPARE(student.lineOfStep(), spoilt.line);
        QVERIFY(student.now().showsStep);
        QCOMPARE(student.rows().currentIndex().row(), static_cast<int>(spoilt.row));
        QCOMPARE(student.rows().currentIndex().siblingAtColumn(0).data().toString(), QStringLiteral("✖"));
        QCOMPARE(student.rows().model()->index(0, 0).data().toString(), QStringLiteral("✓"));

        QVERIFY(student.fields().visibleRegion().boundingRect().height() >= 80);  // without scrolling the panel

        // one edge of the table differs, in all that it says; the others are the same
        const QStringList fields = student.fieldTexts();
        const auto        wrong  = fields.filter(QRegularExpression("^✖"));
        QCOMPARE(wrong.first(), QStringLiteral("✖|active_edges||"));
        QCOMPARE(wrong[1], QStringLiteral("✖|polygon %1||").arg(spoilt.polygon));
        const QString last = QStringLiteral("✖|last_line|–|%1").arg(spoilt.line - 1);
        QVERIFY2(wrong.contains(last), qPrintable(wrong.join('\n')));
        QCOMPARE(wrong.size(), 7);
        QVERIFY(fields.contains("|line|" + QString::number(spoilt.line) + '|' + QString::number(spoilt.line)));
        student.photograph("trace");
    }
    void stepsAndRowsMoveTogether()
    {
        Stepper student;
        QVERIFY(student.isOpen);
        const Spoilt spoilt = keepsAnEdge(student.rowsOf("scanline"));
        student.drop(student.write("steps.jsonl", spoilt.rows));
        QVERIFY(student.isThere());

        QTest::mouseClick(student.named<QPushButton>("The row before"), Qt::LeftButton);
        QVERIFY(student.isThere());
        QCOMPARE(student.lineOfStep(), spoilt.line - 1);
        QVERIFY(student.fieldTexts().filter(QRegularExpression("^✖")).isEmpty());
        student.press(Qt::Key_Right);
        QVERIFY(student.isThere());
        QVERIFY(student.tracer().row() == spoilt.row);
        QCOMPARE(student.rows().currentIndex().row(), static_cast<int>(spoilt.row));
        QVERIFY(!student.fieldTexts().filter(QRegularExpression("^✖")).isEmpty());
        QTest::mouseClick(student.named<QPushButton>("The next row"), Qt::LeftButton);
        QVERIFY(student.isThere());
        QCOMPARE(student.lineOfStep(), spoilt.line + 1);

        const QModelIndex at = student.rows().model()->index(static_cast<int>(spoilt.row) + 2, TraceRowsModel::Moment);
        student.rows().scrollTo(at);
        QTest::mouseClick(student.rows().viewport(), Qt::LeftButton, {}, student.rows().visualRect(at).center());
        QVERIFY(student.isThere());
        QCOMPARE(student.lineOfStep(), spoilt.line + 2);
        QTest::mouseClick(student.button("First difference"), Qt::LeftButton);
        QVERIFY(student.isThere());
        QCOMPARE(student.lineOfStep(), spoilt.line);

        // between two rows the one before is the last that was reached
        QVERIFY(student.goTo(Grain::Pixel, 0));
        const auto first = student.tracer().trace()->answer->rows[60].events;
        QVERIFY(student.goTo(Grain::Pixel, static_cast<std::int64_t>(first) + 1));
        QVERIFY(student.isThere());
        QVERIFY(student.tracer().row() == 60);
        QCOMPARE(student.lineOfStep(), student.lineOfRow() + 1);
        QVERIFY(student.goTo(Grain::Line, -1));
        QVERIFY(student.isThere());
        QVERIFY(student.tracer().row() == spoilt.rows.size() - 1);
    }
    void aRightTraceSaysThatNothingDiffers()
    {
        Stepper student;
        QVERIFY(student.isOpen);
        const auto rows = student.rowsOf("scanline");
        student.drop(student.write("steps.json-lines", rows));
        QVERIFY(student.isThere());
        QVERIFY(student.tracer().trace()->answer->isRight());
        QCOMPARE(student.sentence(),
                 QString("Every row of the trace agrees with scanline: %1 of %1.").arg(rows.size()));
        QVERIFY(!student.button("First difference")->isEnabled());
        QVERIFY(student.goTo(Grain::Line, 70));
        QVERIFY(student.isThere());
        QVERIFY(student.tracer().row());
        QVERIFY(student.fieldTexts().size() > 3);
        QVERIFY(student.fieldTexts().filter(QRegularExpression("^[✖≈]")).isEmpty());
    }
    void aFileThatIsNoTraceIsRefusedWithItsLineAndNothingIsLost()
    {
        Stepper student;
        QVERIFY(student.isOpen);
        auto          rows = student.rowsOf("scanline");
        const QString good = student.write("good.jsonl", rows);
        student.drop(good);
        QVERIFY(student.isThere());
        const TheirTrace* before = student.tracer().trace();
        QVERIFY(before);
        const auto step = student.now().step;

        const QString bad = student.write("bad.jsonl", rows);
        QFile         file(bad);
        QVERIFY(file.open(QIODevice::Append));
        file.write("{\"line\": 3, \"active_edges\": 7}\n");
        file.close();
        student.drop(bad);
        QVERIFY(student.isThere());
        const QString sentence = student.window.messages().sentence();
        QVERIFY2(sentence.contains(QString("bad.jsonl:%1: ").arg(rows.size() + 1)), qPrintable(sentence));
        QVERIFY2(sentence.contains("'active_edges' must be a list"), qPrintable(sentence));
        QCOMPARE(sentence.count('\n'), 0);
        QVERIFY(student.tracer().trace() == before);
        QVERIFY(student.now().step == step);
        student.drop(student.folder.filePath("missing.jsonl"));
        QVERIFY(student.isThere());
        QVERIFY(student.window.messages().sentence().contains("missing.jsonl"));
        QVERIFY(student.tracer().trace() == before);

        Desk empty;
        empty.window.openTrace(good);
        QVERIFY(empty.window.messages().sentence().contains("Open the scene first"));
    }
    void itIsHeldAgainstTheRunOnShowOrAgainstOneThatHasItsTables()
    {
        Stepper student("zbuffer", "builtin:teapot");
        QVERIFY(student.isOpen);
        const Pipeline scanline = findPreset("scanline")->pipeline, interval = findPreset("interval")->pipeline;
        student.drop(student.write("culled.jsonl", student.rowsOf("scanline", FaceCulling::Back)));
        QVERIFY(student.isThere());
        QVERIFY2(student.tracer().trace()->answer->isRight(), student.tracer().trace()->answer->sentence.c_str());
        QVERIFY(student.now().pipeline == scanline);
        QVERIFY(student.session.settings().faceCulling == FaceCulling::Back);

        // the tables of the interval method are the same: the algorithm on show stays
        student.session.setPipeline(interval);
        QVERIFY(student.settles());
        QVERIFY(student.tracer().isOld());
        QVERIFY(student.button("Back to its run")->isVisible());
        QTest::mouseClick(student.button("Judge again"), Qt::LeftButton);
        QVERIFY(student.isThere());
        QVERIFY(!student.tracer().isOld());
        QVERIFY(student.now().pipeline == interval);
        student.session.moveCamera([](CameraControl& control) { control.orbit(0.4, 0); });
        QVERIFY(student.settles());
        QVERIFY(student.tracer().isOld());
        QTest::mouseClick(student.button("Back to its run"), Qt::LeftButton);
        QVERIFY(student.isThere());
        QVERIFY(!student.tracer().isOld());
        QTest::mouseClick(student.button("Close"), Qt::LeftButton);
        QVERIFY(!student.tracer().trace());
        QVERIFY(student.button("Open my trace…")->isVisible());
    }
    void aRowThatOurRunNeverReachesIsShownWithoutAStep()
    {
        Stepper student;
        QVERIFY(student.isOpen);
        auto rows = student.rowsOf("scanline");
        rows.push_back({{"line", 700}, {"active_polygons", QJsonArray{3}}});
        student.drop(student.write("steps.jsonl", rows));
        QVERIFY(student.isThere());
        QVERIFY(student.tracer().row() == rows.size() - 1);
        QVERIFY2(student.sentence().contains("Our run never draws line 700."), qPrintable(student.sentence()));
        QVERIFY(student.fieldTexts().contains("✖|active_polygons|–|[3]"));
    }
    void aSessionBringsTheTraceBack()
    {
        Stepper student;
        QVERIFY(student.isOpen);
        const Spoilt spoilt = keepsAnEdge(student.rowsOf("scanline"));
        student.drop(student.write("steps.jsonl", spoilt.rows));
        QVERIFY(student.isThere());
        QTest::mouseClick(student.named<QPushButton>("The row before"), Qt::LeftButton);
        QVERIFY(student.isThere());
        const QString saved = student.folder.filePath("mine.zscope-session");
        student.window.saveSessionTo(saved);
        QFile file(saved);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"trace\": \"steps.jsonl\""));  // both can be moved

        Stepper again;
        again.window.openSession(saved);
        QVERIFY(QTest::qWaitFor([&] { return again.tracer().trace() && again.tracer().row(); }, Desk::kLong));
        QVERIFY(again.isThere());
        QVERIFY(again.tracer().row() == spoilt.row - 1);  // the step stays
        QVERIFY(again.tracer().trace()->answer->firstWrong == spoilt.row);

        QVERIFY(QFile::remove(student.folder.filePath("steps.jsonl")));
        again.window.openSession(saved);
        QVERIFY(
            QTest::qWaitFor([&] { return again.window.messages().sentence().contains("steps.jsonl"); }, Desk::kLong));
        QVERIFY(again.isThere());
        QVERIFY(!again.tracer().trace());
        QCOMPARE(again.lineOfStep(), spoilt.line - 1);
    }
    void chineseIsSpoken()
    {
        Stepper student;
        QVERIFY(student.isOpen);
        student.drop(student.write("steps.jsonl", keepsAnEdge(student.rowsOf("scanline")).rows));
        QVERIFY(student.isThere());
        student.window.speak(Language::Chinese);
        QTest::qWait(50);
        for (auto* label : student.panel().findChildren<QLabel*>()) {
            QString text = label->text();
            text.remove("steps.jsonl").remove("scanline");
            if (!label->isHidden()) QVERIFY2(!text.contains(QRegularExpression("[A-Za-z]{2,}")), qPrintable(text));
        }
        const auto* rows = student.panel().findChildren<QTreeView*>().first();
        for (int row = 0; row < rows->model()->rowCount(); ++row) {
            const QString moment = rows->model()->index(row, TraceRowsModel::Moment).data().toString();
            QVERIFY2(!moment.contains(QRegularExpression("[A-Za-z,，]")), qPrintable(moment));
        }
        student.photograph("trace-zh");
        student.window.speak(Language::English);
    }
};

ZSCOPE_UI_TEST(TraceTest, "trace_test", Window)
#include "trace_test.moc"
