// SPDX-License-Identifier: GPL-3.0-or-later
// Predict mode: what is asked is true of the next step, nothing of it is
// shown before the answer, and the score is a table.
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/active_edges/edge_table_model.h"
#include "ui/panels/panel.h"
#include "ui/predict/predict_bar.h"
#include "ui/predict/predictions.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

QString shownText(const QWidget& widget)
{
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>())
        if (label->isVisibleTo(&widget)) texts << label->text();
    return texts.join('\n');
}

/// The state at a step, made anew.
StepState stateAt(const Session& session, Grain grain, std::uint64_t step)
{
    Replay replay(session.request());
    auto   state = replay.at(grain, {step});
    return state ? std::move(*state) : StepState{};
}

bool forward(Desk& desk)
{
    const auto from = desk.session.position();
    desk.press(Qt::Key_Right);
    return desk.settles() && desk.session.position() && desk.session.position()->step == from->step + 1;
}

PredictBar* barOf(Desk& desk, const char* panel) { return desk.window.dock(panel)->findChild<PredictBar*>(); }

}  // namespace

class PredictTest final : public QObject {
    Q_OBJECT

private slots:
    void aGrainWhoseStepsNeverAskIsSaid()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:wall-and-city?blocks=3", {320, 180}));
        QVERIFY(desk.goTo(Grain::Triangle, 3));
        PredictBar* bar = barOf(desk, "pyramid");
        QVERIFY(!shownText(*bar).contains("query"));
        desk.session.predictions().setOn(Topic::Pyramid, true);
        QVERIFY(shownText(*bar).contains("Steps by the grain “query” ask."));
        QVERIFY(desk.goTo(Grain::Query, 3));
        QVERIFY(!shownText(*bar).contains("Steps by the grain"));
    }
    void theTableOfTheNextLineIsHiddenUntilItWasPredicted()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:cube", {160, 90}));
        QVERIFY(desk.goTo(Grain::Line, 13));
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        Predictions& predictions = desk.session.predictions();
        PredictBar*  bar         = barOf(desk, "active-edges");
        auto*        model       = desk.window.dock("active-edges")->findChild<EdgeTableModel*>();
        auto*        edgesPanel  = &desk.window.dock("active-edges")->panel();
        auto*        timeline    = &desk.window.dock("timeline")->panel();
        QTest::mouseClick(bar->findChild<QCheckBox*>(), Qt::LeftButton, {}, QPoint(6, 8));
        QVERIFY(predictions.isOn(Topic::Edges));
        QVERIFY(!predictions.open(Topic::Edges));

        const QSize size       = desk.window.size();
        const int   rowsBefore = static_cast<int>(model->rows().size());
        QVERIFY(forward(desk));  // line 13, on which the first edges enter
        const Riddle* riddle = predictions.open(Topic::Edges);
        QVERIFY(riddle);
        QVERIFY(riddle->ask == Riddle::Ask::EdgesEnter);
        const StepState truth = stateAt(desk.session, Grain::Line, 14);
        QCOMPARE(truth.sweep->y, 13);
        QCOMPARE(riddle->answer, static_cast<double>(truth.sweep->entered.size()));
        QVERIFY(truth.sweep->entered.size() > 0);
        QCOMPARE(static_cast<int>(model->rows().size()), rowsBefore);  // the table of the line before
        QVERIFY(!shownText(*timeline).contains(QString::fromStdString(truth.sentence)));
        QVERIFY(shownText(*bar).contains("How many edges enter?"));
        QCOMPARE(desk.window.size(), size);  // the question finds room in its panel
        desk.photograph("predict-edges");

        auto* field = bar->findChild<QLineEdit*>();
        QVERIFY(field->hasFocus());
        QTest::keyClicks(field, "5");  // wrong
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!predictions.open(Topic::Edges));
        QVERIFY(shownText(*bar).contains(QString::fromUtf8("✘")));
        QVERIFY(shownText(*bar).contains(QString::number(truth.sweep->entered.size()) + " enter"));
        QCOMPARE(static_cast<std::size_t>(std::ranges::count_if(
                     model->rows(), [](const auto& row) { return row.state != EdgeTableModel::State::Left; })),
                 truth.sweep->activeEdges.size());
        QVERIFY(shownText(*timeline).contains(QString::fromStdString(truth.sentence)));
        QVERIFY(shownText(*edgesPanel).contains("0 of 1 right"));
        desk.photograph("predict-edges-answered");

        QVERIFY(forward(desk));  // line 14: nothing enters or leaves, so an edge is asked about
        riddle = predictions.open(Topic::Edges);
        QVERIFY(riddle && riddle->ask == Riddle::Ask::EdgeX);
        const double right =
            riddle->edge.x + static_cast<double>(riddle->edge.dx[0]) / static_cast<double>(riddle->edge.dx[1]);
        QVERIFY(riddle->accepts(right));
        QVERIFY(!riddle->accepts(right + 0.5));
        QTest::keyClicks(field, QString::number(right, 'f', 2));
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(shownText(*bar).contains(QString::fromUtf8("✔")));
        QVERIFY(shownText(*bar).contains("1 of 2 right"));
        QVERIFY(forward(desk));  // and the keys step again
    }
    void anOpenQuestionHoldsNoKeys()
    {
        const auto key = [](Desk& desk, Qt::Key pressed) {  // wherever the focus is
            QTest::keyClick(QApplication::focusWidget(), pressed);
            return desk.settles();
        };
        {
            Desk desk("scanline");
            QVERIFY(desk.open("builtin:cube", {160, 90}));
            QVERIFY(desk.goTo(Grain::Line, 13));
            desk.window.activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(&desk.window));
            desk.window.setFocus();
            desk.session.pick(QPoint(80, 45));
            Predictions& predictions = desk.session.predictions();
            predictions.setOn(Topic::Edges, true);
            QVERIFY(key(desk, Qt::Key_Right));
            auto* field = barOf(desk, "active-edges")->findChild<QLineEdit*>();
            QVERIFY(predictions.open(Topic::Edges));
            QVERIFY(field->hasFocus());
            QVERIFY(key(desk, Qt::Key_Right));
            QCOMPARE(desk.session.position()->step, std::uint64_t{15});
            QCOMPARE(predictions.skippedOf(Topic::Edges), 1);
            QVERIFY(field->hasFocus());  // of the next question

            QTest::keyClicks(field, "12");
            QVERIFY(key(desk, Qt::Key_Left));
            QCOMPARE(field->cursorPosition(), 1);  // it edits
            QCOMPARE(desk.session.position()->step, std::uint64_t{15});
            QVERIFY(key(desk, Qt::Key_Escape));
            QVERIFY(!field->hasFocus());
            QVERIFY(predictions.open(Topic::Edges));
            QVERIFY(desk.session.now().picked);  // nothing else was meant
            QVERIFY(key(desk, Qt::Key_Right));
            QCOMPARE(desk.session.position()->step, std::uint64_t{16});
            QCOMPARE(predictions.skippedOf(Topic::Edges), 2);
            QVERIFY(field->hasFocus());
            QVERIFY(key(desk, Qt::Key_Left));  // withdraws the question
            QCOMPARE(desk.session.position()->step, std::uint64_t{15});
            QVERIFY(!predictions.isAnyOpen());
            QVERIFY(key(desk, Qt::Key_Left));
            QCOMPARE(desk.session.position()->step, std::uint64_t{14});
        }
        Desk desk("hzb-octree", {1280, 1000});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=2", {160, 90}));
        QVERIFY(desk.goTo(Grain::Node, 3));
        desk.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.window.setFocus();
        Predictions& predictions = desk.session.predictions();
        predictions.setOn(Topic::Nodes, true);
        for (int i = 0; i < 3; ++i) {
            QVERIFY(key(desk, Qt::Key_Right));
            QCOMPARE(desk.session.position()->step, std::uint64_t{4} + static_cast<std::uint64_t>(i));
            QVERIFY(predictions.open(Topic::Nodes));
            QCOMPARE(predictions.skippedOf(Topic::Nodes), i);
            QVERIFY(qobject_cast<QPushButton*>(QApplication::focusWidget()));
        }
        for (const std::uint64_t step : {5, 4}) {
            QVERIFY(key(desk, Qt::Key_Left));
            QCOMPARE(desk.session.position()->step, step);
            QVERIFY(!predictions.isAnyOpen());
        }
    }
    void backAndJumpsShowAtOnce()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:cube", {160, 90}));
        QVERIFY(desk.goTo(Grain::Line, 20));
        Predictions& predictions = desk.session.predictions();
        predictions.setOn(Topic::Edges, true);
        QVERIFY(forward(desk));
        QVERIFY(predictions.open(Topic::Edges));
        desk.press(Qt::Key_Left);
        QVERIFY(desk.settles());
        QVERIFY(!predictions.isAnyOpen());
        QVERIFY(desk.goTo(Grain::Line, 40));
        QVERIFY(!predictions.isAnyOpen());
        QVERIFY(forward(desk));
        QVERIFY(predictions.open(Topic::Edges));
        desk.session.setLayer(*findLayer("depth"));  // painted anew: the question stays
        QVERIFY(desk.settles());
        QVERIFY(predictions.open(Topic::Edges));
        predictions.setOn(Topic::Edges, false);
        QVERIFY(!predictions.isAnyOpen());
        QVERIFY(desk.session.now().sweep()->y == 40);
    }
    void playingWaitsForThePrediction()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:cube", {160, 90}));
        QVERIFY(desk.goTo(Grain::Line, 11));
        desk.session.predictions().setOn(Topic::Edges, true);
        desk.session.player().setPlaying(true);
        QVERIFY(QTest::qWaitFor([&] { return desk.session.predictions().isAnyOpen(); }, Desk::kLong));
        QVERIFY(!desk.session.player().isPlaying());
    }
    void everyQuestionAboutThePyramidAndTheNodesIsTrueOfTheStepThatFollows()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:wall-and-city?blocks=2", {160, 90}));
        Predictions& predictions = desk.session.predictions();
        predictions.setOn(Topic::Pyramid, true);
        predictions.setOn(Topic::Nodes, true);
        int hidden = 0, seen = 0, nodes = 0;
        QVERIFY(desk.goTo(Grain::Query, 1));
        const auto isEnough = [&] { return hidden > 0 && seen > 0 && nodes > 3; };
        for (int i = 0; i < 90 || (i < 900 && !isEnough()); ++i) {
            QVERIFY(forward(desk));
            const StepState& after = desk.session.now().step->state;
            if (const Riddle* riddle = predictions.open(Topic::Pyramid)) {
                QVERIFY(after.hierarchy->query);
                QCOMPARE(riddle->answer, after.hierarchy->query->hidden ? 0.0 : 1.0);
                (after.hierarchy->query->hidden ? hidden : seen)++;
                predictions.answer(Topic::Pyramid, riddle->answer);
                QVERIFY(predictions.last(Topic::Pyramid)->isRight);
            }
            if (const Riddle* riddle = predictions.open(Topic::Nodes)) {
                const NodeVerdict verdict =
                    after.hierarchy->nodes[static_cast<std::size_t>(after.hierarchy->now)].verdict;
                const int right = verdict == NodeVerdict::Outside ? 0 : verdict == NodeVerdict::Hidden ? 1 : 2;
                QCOMPARE(riddle->answer, static_cast<double>(right));
                predictions.answer(Topic::Nodes, 2);
                QCOMPARE(predictions.last(Topic::Nodes)->isRight, right == 2);
                ++nodes;
            }
            QVERIFY(!predictions.isAnyOpen());
        }
        QVERIFY2(isEnough(),
                 qPrintable(QStringLiteral("%1 hidden, %2 seen, %3 nodes").arg(hidden).arg(seen).arg(nodes)));

        desk.session.setPipeline(*withChoice(findPreset("quadtree")->pipeline, "upkeep", "pushed"));
        QVERIFY(desk.settles());
        QVERIFY(desk.goTo(Grain::Update, 1));
        int changes = 0, stays = 0;
        for (int i = 0; i < 900 && changes + stays <= 10; ++i) {
            QVERIFY(forward(desk));
            const Riddle* riddle = predictions.open(Topic::Pyramid);
            if (!riddle) continue;
            const auto& write = *desk.session.now().step->state.hierarchy->update;
            if (riddle->ask == Riddle::Ask::CellChanges) {
                QCOMPARE(riddle->answer, write.before == write.after ? 1.0 : 0.0);
                (write.before == write.after ? stays : changes)++;
            }
            predictions.answer(Topic::Pyramid, 0);
        }
        QVERIFY(changes + stays > 10);
    }
    void theHierarchyAndThePyramidShowTheStepBeforeMeanwhile()
    {
        Desk desk("hzb-octree", {1280, 1000});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=2", {160, 90}));
        QVERIFY(desk.goTo(Grain::Node, 3));
        Predictions& predictions = desk.session.predictions();
        predictions.setOn(Topic::Nodes, true);
        predictions.setOn(Topic::Pyramid, true);
        const auto countText = [&] { return shownText(*desk.window.dock("hierarchy")); };
        for (int i = 0; i < 12; ++i) {
            const StepState before = stateAt(desk.session, Grain::Node, desk.session.position()->step);
            QVERIFY(forward(desk));
            QVERIFY(predictions.open(Topic::Nodes));
            const auto veiled = predictions.before(Topic::Nodes, desk.session.now());
            QVERIFY(veiled && veiled->hierarchy());
            QCOMPARE(veiled->hierarchy()->nodes.size(), before.hierarchy->nodes.size());
            QVERIFY(countText().contains(QString("%1 nodes").arg(before.hierarchy->nodes.size())));
            if (i == 5) desk.photograph("predict-nodes");
            auto*      bar     = barOf(desk, "hierarchy");
            const auto buttons = bar->findChildren<QPushButton*>();
            const auto entered = std::ranges::find_if(
                buttons, [](const QPushButton* b) { return b->text() == "Entered" && b->isVisibleTo(b->window()); });
            QVERIFY(entered != buttons.end());
            QTest::mouseClick(*entered, Qt::LeftButton);
            QVERIFY(!predictions.open(Topic::Nodes));
            if (predictions.open(Topic::Pyramid)) predictions.answer(Topic::Pyramid, 0);
            QVERIFY(countText().contains(QString("%1 nodes").arg(desk.session.now().hierarchy()->nodes.size())));
        }
    }
    void theScoreIsATableThatASpreadsheetReads()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:cube", {160, 90}));
        QVERIFY(desk.goTo(Grain::Line, 13));
        Predictions& predictions = desk.session.predictions();
        predictions.setOn(Topic::Edges, true);
        for (int i = 0; i < 3; ++i) {
            QVERIFY(forward(desk));
            QVERIFY(predictions.open(Topic::Edges));
            predictions.answer(Topic::Edges, i == 0 ? -3 : predictions.open(Topic::Edges)->answer);
        }
        QVERIFY(forward(desk));
        QVERIFY(predictions.open(Topic::Edges));
        QVERIFY(forward(desk));  // passes the question by
        QVERIFY(predictions.open(Topic::Edges));
        QCOMPARE(predictions.skippedOf(Topic::Edges), 1);
        QCOMPARE(predictions.countOf(Topic::Edges), 4);
        QVERIFY(shownText(*barOf(desk, "active-edges")).contains("2 of 4 right, 1 skipped"));
        desk.press(Qt::Key_Left);  // going back withdraws the question
        QVERIFY(desk.settles());
        QVERIFY(!predictions.isAnyOpen());
        QCOMPARE(predictions.countOf(Topic::Edges), 4);
        const QString file = desk.folder.filePath("score.csv");
        QVERIFY(!predictions.save(file));
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray bytes = written.readAll();
        QVERIFY(bytes.startsWith("\xEF\xBB\xBF"));
        const QStringList lines = QString::fromUtf8(bytes.mid(3)).split("\r\n", Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 5);
        QCOMPARE(lines[0], QString("time,table,scene,algorithm,grain,step,question,answer,right answer,right,skipped"));
        QVERIFY(lines[1].contains(",active edges,builtin:cube,scanline,line,15,"));
        QVERIFY(lines[1].endsWith(",-3,8,0,0"));
        QVERIFY(lines[2].endsWith(",1,0"));
        QVERIFY(lines[4].endsWith(",0,1"));
        for (const QString& line : lines) {  // as many cells everywhere, commas inside quotes not counted
            int  cells  = 1;
            bool quoted = false;
            for (const QChar c : line) {
                if (c == '"') quoted = !quoted;
                cells += !quoted && c == ',';
            }
            QCOMPARE(cells, 11);
        }
        QVERIFY(predictions.save("/nowhere/at/all.csv"));
    }
    void inChineseTheQuestionIsChinese()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:cube", {160, 90}));
        QVERIFY(desk.goTo(Grain::Line, 13));
        desk.session.predictions().setOn(Topic::Edges, true);
        QVERIFY(forward(desk));
        desk.window.speak(Language::Chinese);
        QCoreApplication::processEvents();
        QVERIFY(shownText(*barOf(desk, "active-edges")).contains(QString::fromUtf8("有多少条边进入")));
        desk.photograph("predict-chinese");
        desk.window.speak(Language::English);
        QCoreApplication::processEvents();
    }
};

ZSCOPE_UI_TEST(PredictTest, "predict_test", Window)
#include "predict_test.moc"
