// SPDX-License-Identifier: GPL-3.0-or-later
// What another program drew: dropped on the window it becomes B, its mistake is named, and A shows the mistake, too.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>

#include "core/frame/faults.h"
#include "core/io/npy.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/compare/compare_words.h"
#include "ui/panels/diagnosis/cause_row.h"
#include "ui/panels/diagnosis/diagnosis_panel.h"
#include "ui/panels/diagnosis/diagnosis_words.h"
#include "ui/panels/why/why_panel.h"
#include "ui/session/course.h"
#include "ui/session/engine.h"
#include "ui/session/examiner.h"
#include "ui/session/reproduce.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/window/message_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

constexpr QSize kPicture{320, 180};

/// The mistake of a student: a span begins and ends at the truncated x.
Pipeline truncated()
{
    Pipeline pipeline = findPreset("edge-walk")->pipeline;
    pipeline.fault    = Fault::XTruncated;
    return pipeline;
}

struct Student : Desk {
    explicit Student(const QSize& size = {1280, 800}, const QString& scene = "builtin:teapot") : Desk("zbuffer", size)
    {
        isOpen = open(scene, kPicture);
    }
    bool isOpen = false;

    Examiner&           examiner() { return session.examiner(); }
    const Snapshot&     now() { return session.now(); }
    const TheirPicture* theirs() { return session.now().compare.theirs.get(); }
    template <class Kind>
    Kind& panel(const char* word)
    {
        return static_cast<Kind&>(window.dock(word)->panel());
    }
    DiagnosisPanel& diagnosis() { return panel<DiagnosisPanel>("diagnosis"); }

    Picture drawnBy(const Pipeline& pipeline, const QSize& size = kPicture)
    {
        DrawRequest request   = session.request();
        request.pipeline      = pipeline;
        request.camera.width  = size.width();
        request.camera.height = size.height();
        Frame frame;
        [&] { QVERIFY(Renderer().draw(request, frame).ok()); }();
        return pictureOf(frame.visible);
    }
    QString writeDepth(const QString& name, const Grid<float>& depth)
    {
        const QString path = folder.filePath(name);
        const auto    fill = [&](int y, std::span<float> row) { std::ranges::copy(depth.view().row(y), row.begin()); };
        [&] { QVERIFY(writeNpy(path.toStdString(), depth.width(), depth.height(), NpyRow<float>(fill)).ok()); }();
        return path;
    }
    void drop(const QStringList& files, Qt::KeyboardModifiers modifiers = {})
    {
        QMimeData   data;
        QList<QUrl> urls;
        for (const QString& file : files) urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, modifiers);
        QApplication::sendEvent(&window, &enter);
        [&] { QVERIFY(enter.isAccepted()); }();
        QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, modifiers);
        QApplication::sendEvent(&window, &event);
    }
    bool isJudged()
    {
        return QTest::qWaitFor([&] { return examiner().isIdle(); }, kLong) && settles()
               && QTest::qWaitFor([&] { return !theirs() || isStale(now()) || now().compare.result; }, kLong);
    }
    QPushButton* button(const QString& text)
    {
        for (auto* each : diagnosis().findChildren<QPushButton*>())
            if (each->text() == text) return each;
        return nullptr;
    }
    std::vector<CauseRow*> causes()
    {
        std::vector<CauseRow*> seen;
        for (auto* row : diagnosis().findChildren<CauseRow*>())
            if (row->isVisible()) seen.push_back(row);
        return seen;
    }
    QString textNamed(QWidget& in, const QString& accessibleName)
    {
        for (auto* label : in.findChildren<QLabel*>())
            if (label->accessibleName() == accessibleName && !label->isHidden()) return label->text();
        return {};
    }
    QPoint firstOf(check::Mistake mistake)
    {
        const auto& verdicts = theirs()->answer->verdicts;
        for (int y = 0; y < verdicts.height(); ++y)
            for (int x = 0; x < verdicts.width(); ++x)
                if (const auto verdict = verdicts.at(x, y); verdict.isWrong() && verdict.mistake() == mistake)
                    return {x, y};
        return {-1, -1};
    }
};

}  // namespace

class DiagnosisTest final : public QObject {
    Q_OBJECT

private slots:
    void aDroppedDepthBecomesBAndItsMistakeIsNamedAndShownInA()
    {
        Student student;
        QVERIFY(student.isOpen);
        const Picture  spoilt = student.drawnBy(truncated());
        const Pipeline before = student.now().pipeline;
        student.drop({student.writeDepth("depth.npy", spoilt.depth)});
        QVERIFY(student.isJudged());

        QVERIFY(student.theirs());
        QCOMPARE(student.now().compare.seen(), CompareShow::B);
        QVERIFY(student.diagnosis().isVisible());
        const check::CheckAnswer& answer = *student.theirs()->answer;
        QVERIFY(answer.wrong.total() > 100);
        QVERIFY(!answer.causes.empty());
        QCOMPARE(QString::fromStdString(answer.causes.front().name), QString("x-truncated"));
        QCOMPARE(student.textNamed(student.diagnosis(), "Diagnosis"), QString::fromStdString(answer.sentence));
        const auto rows = student.causes();
        QCOMPARE(rows.size(), answer.causes.size());
        QCOMPARE(rows.front()->text(), said(findFault("x-truncated")->title));
        // wrong are those pixels, and no others, that differ from A by more than rounding
        QCOMPARE(student.now().compare.result->difference.differing(), answer.wrong.total());

        QTest::mouseClick(rows.front(), Qt::LeftButton);
        QVERIFY(student.isJudged());
        QVERIFY(student.now().pipeline.fault == Fault::XTruncated);
        QVERIFY(rows.front()->isChecked());
        QCOMPARE(student.now().compare.seen(), CompareShow::A);
        const VisibilityBuffer& a = student.now().frame->frame.visible;
        for (int y = 0; y < kPicture.height(); ++y)
            for (int x = 0; x < kPicture.width(); ++x)
                if (answer.verdicts.at(x, y).isWrong()) QCOMPARE(a.depthAt(x, y), spoilt.depth.at(x, y));
        QCOMPARE(student.now().compare.result->difference.differing(), std::uint64_t{0});
        QVERIFY(wordsOf(*student.now().compare.result).verdict.contains("but for rounding"));
        QVERIFY(QTest::qWaitFor([&] { return imageOf(student.theirs()->painted) == imageOf(*student.now().colours()); },
                                Desk::kLong));
        student.photograph("diagnosis");

        QTest::mouseClick(rows.front(), Qt::LeftButton);
        QVERIFY(student.isJudged());
        QVERIFY(student.now().pipeline == before);
        QVERIFY(!rows.front()->isChecked());
    }
    void whySetsTheirValueBesideTheRightOne()
    {
        Student student;
        QVERIFY(student.isOpen);
        const Picture right = student.drawnBy(findPreset("zbuffer")->pipeline);
        Picture       wrong = right;
        QPoint        at(160, 90);
        while (right.ids.at(at.x(), at.y()) < 0) at.rx() -= 1;
        wrong.depth.at(at.x(), at.y()) *= 0.5f;
        QPoint hole = at - QPoint(0, 5);
        QVERIFY(right.ids.at(hole.x(), hole.y()) >= 0);
        wrong.depth.at(hole.x(), hole.y()) = 0;
        student.drop({student.writeDepth("mine.npy", wrong.depth)});
        QVERIFY(student.isJudged());
        student.window.dock("why")->raise();
        auto& why = student.panel<WhyPanel>("why");
        student.session.pick(at);
        QVERIFY(student.settles());
        const QString said = student.textNamed(why, "What B has at the pixel");
        QVERIFY2(said.contains(significant(static_cast<double>(right.depth.at(at.x(), at.y())), 9)), qPrintable(said));
        QVERIFY2(said.contains(significant(static_cast<double>(wrong.depth.at(at.x(), at.y())), 9)), qPrintable(said));
        QVERIFY2(said.contains("wrong depth"), qPrintable(said));
        student.session.pick(hole);
        QVERIFY2(student.textNamed(why, "What B has at the pixel").contains("<b>hole</b>"), qPrintable(said));
        student.session.pick(at + QPoint(-3, 0));
        QVERIFY(student.textNamed(why, "What B has at the pixel").contains("<b>right</b>"));
        QTest::mouseClick(student.button("First wrong pixel"), Qt::LeftButton);
        QVERIFY(student.now().picked == hole);
        QVERIFY(QTest::qWaitFor([&] { return why.isIdle(); }, Desk::kLong));
        student.photograph("diagnosis-why");
    }
    void flipWipeAndDifferenceShowIt()
    {
        Student student;
        QVERIFY(student.isOpen);
        const Picture spoilt = student.drawnBy(truncated());
        student.drop({student.writeDepth("depth.npy", spoilt.depth)});
        QVERIFY(student.isJudged());
        const FrameView& view = student.window.view();
        const QImage     b    = view.picture(true);
        QVERIFY(b == imageOf(student.theirs()->painted));
        student.press(Qt::Key_T);
        QCOMPARE(student.now().compare.seen(), CompareShow::A);
        QVERIFY(view.picture(true) == imageOf(*student.now().colours()));
        const QImage a = view.picture(true);
        QVERIFY(a != b);
        const auto& verdicts = student.theirs()->answer->verdicts;
        for (int y = 0; y < kPicture.height(); ++y)  // equal depths have equal colours
            for (int x = 0; x < kPicture.width(); ++x)
                if (verdicts.at(x, y).isSame()) QCOMPARE(a.pixel(x, y), b.pixel(x, y));
        student.press(Qt::Key_W);
        QCOMPARE(student.now().compare.seen(), CompareShow::Wipe);
        QVERIFY(view.chips().join(' ').contains("depth.npy"));
        const QPoint hole = student.firstOf(check::Mistake::Hole);
        QVERIFY(hole.x() >= 0);
        student.session.setWipe(0);
        QVERIFY(factsOf(student.now(), hole)->theirs);
        QVERIFY(!factsOf(student.now(), hole)->theirs->isCovered);
        student.session.setWipe(1);
        QVERIFY(!factsOf(student.now(), hole)->theirs);
        student.press(Qt::Key_D);
        QCOMPARE(student.now().compare.seen(), CompareShow::Difference);
        QCOMPARE(view.picture(true).pixel(hole), QRgb{kWrongColour});
        student.photograph("diagnosis-difference");
        student.press(Qt::Key_B);
        QCOMPARE(student.now().compare.seen(), CompareShow::Beside);
        student.photograph("diagnosis-beside");
    }
    void aFileThatCannotBeUsedIsSaidAndNothingIsLost()
    {
        Student student;
        QVERIFY(student.isOpen);
        const Picture right = student.drawnBy(findPreset("zbuffer")->pipeline);
        student.drop({student.writeDepth("good.npy", right.depth)});
        QVERIFY(student.isJudged());
        const auto   good   = student.now().compare.theirs;
        const Camera camera = student.now().camera;
        // of another size, and cut off
        const QString cut = student.writeDepth("cut.npy", Grid<float>(64, 48, 0.5f));
        QFile         file(cut);
        QVERIFY(file.resize(file.size() - 100));
        student.drop({cut});
        QVERIFY(student.isJudged());
        const QString sentence = student.window.messages().sentence();
        QVERIFY2(sentence.contains("cut.npy"), qPrintable(sentence));
        QCOMPARE(sentence.count('\n'), 0);
        QVERIFY(student.now().compare.theirs == good);
        QVERIFY(student.now().camera == camera);
        student.drop({student.folder.filePath("missing.pfm")});
        QVERIFY(student.isJudged());
        QVERIFY(student.window.messages().sentence().contains("missing.pfm"));
        QVERIFY(student.now().compare.theirs == good);

        Desk empty;
        empty.window.openTheirs({cut});
        QVERIFY(empty.window.messages().sentence().contains("Open the scene first"));
    }
    void aPictureOfOursOpensItsSessionAndWithShiftBecomesB()
    {
        Student student;
        QVERIFY(student.isOpen);
        student.session.pick(QPoint(100, 70));
        student.session.setPipeline(findPreset("scanline")->pipeline);
        QVERIFY(student.settles());
        const QString file = student.folder.filePath("mine.png");
        QVERIFY(!savePicture(student.window.view().picture(false), file, student.session, false));
        const Camera camera = student.now().camera;

        student.session.setPipeline(findPreset("zbuffer")->pipeline);
        student.session.pick({});
        student.session.moveCamera([](CameraControl& control) { control.orbit(0.5, 0); });
        QVERIFY(student.settles());
        QVERIFY(!(student.now().camera == camera));
        student.drop({file}, Qt::ShiftModifier);
        QVERIFY(student.isJudged());
        QVERIFY(student.theirs());
        QVERIFY(student.theirs()->answer->wrong.total() > 0);  // seen from elsewhere
        QVERIFY(!(student.now().camera == camera));

        student.drop({file});
        QVERIFY(student.settles());
        QVERIFY(student.now().camera == camera);
        QVERIFY(student.now().pipeline == findPreset("scanline")->pipeline);
        QVERIFY(student.now().picked == QPoint(100, 70));
        QVERIFY(!student.theirs());

        student.drop({file}, Qt::ShiftModifier);
        QVERIFY(student.isJudged());
        QVERIFY(student.theirs());
        QVERIFY2(student.theirs()->answer->isRight(), student.theirs()->answer->sentence.c_str());
        QVERIFY(student.now().look.isShaded());
    }
    void whenTheCameraMovesTheDiagnosisIsOldAndCanBeHadAgain()
    {
        Student student;
        QVERIFY(student.isOpen);
        const Camera  camera = student.now().camera;
        const Picture spoilt = student.drawnBy(truncated());
        student.drop({student.writeDepth("depth.npy", spoilt.depth)});
        QVERIFY(student.isJudged());
        const std::uint64_t wrong = student.theirs()->answer->wrong.total();
        QVERIFY(student.button("Back to its view")->isHidden());
        student.session.moveCamera([](CameraControl& control) { control.orbit(0.3, 0); });
        QVERIFY(student.settles());
        QVERIFY(isStale(student.now()));
        QVERIFY(!student.now().compare.result);
        QVERIFY(student.button("Back to its view")->isVisible());
        student.photograph("diagnosis-old");
        QTest::mouseClick(student.button("Judge again"), Qt::LeftButton);
        QVERIFY(student.isJudged());
        QVERIFY(!isStale(student.now()));
        QVERIFY(student.theirs()->answer->wrong.total() > wrong);
        student.session.useView(Session::seenBy(camera, FaceCulling::None)(student.now().scene->scene()));
        QVERIFY(student.settles());
        student.press(Qt::Key_F7);
        QVERIFY(student.isJudged());
        QCOMPARE(student.theirs()->answer->wrong.total(), wrong);

        QVERIFY(student.open("builtin:cubes", kPicture));
        QVERIFY(student.theirs() && isStale(student.now()));
        QTest::mouseClick(student.button("Back to its view"), Qt::LeftButton);
        QVERIFY(student.isJudged());
        QVERIFY(!isStale(student.now()));
        QCOMPARE(student.now().scene->word, QString("builtin:teapot"));
        QVERIFY(student.now().compare.result);
    }
    void theSizeIsThatOfTheFilesAndNumbersWithoutANameAreTold()
    {
        Student student;
        QVERIFY(student.isOpen);
        student.session.setPictureSize(200, 150);
        QVERIFY(student.settles());
        const Picture right = student.drawnBy(findPreset("zbuffer")->pipeline, {200, 150});
        student.session.setPictureSize(kPicture.width(), kPicture.height());
        QVERIFY(student.settles());
        // uint32, from 1: ids, though the name does not say so
        QByteArray bytes("\x93NUMPY\x01\x00", 8);
        QByteArray head = "{'descr': '<u4', 'fortran_order': False, 'shape': (150, 200), }";
        head            = head.leftJustified(117) + '\n';
        bytes += QByteArray("\x76\x00", 2) + head;
        for (const std::int64_t id : right.ids.values()) {
            const auto number = static_cast<std::uint32_t>(id + 1);
            bytes.append(reinterpret_cast<const char*>(&number), 4);
        }
        QFile file(student.folder.filePath("buffer.npy"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        student.drop({file.fileName()});
        QVERIFY(student.isJudged());
        QVERIFY2(student.theirs(), qPrintable(student.window.messages().sentence()));
        QVERIFY(student.theirs()->hasIds());
        QVERIFY(!student.theirs()->hasDepth());
        QVERIFY2(student.theirs()->answer->isRight(), student.theirs()->answer->sentence.c_str());
        QCOMPARE(student.theirs()->answer->conventions.idsFrom, std::optional(1));
        QCOMPARE(student.now().camera.width, 200);
        QCOMPARE(student.now().camera.height, 150);
        QVERIFY(!isStale(student.now()));
        QCOMPARE(student.now().look.layer->word, std::string_view("ids"));
    }
    void lookingForCausesCanBeCancelled()
    {
        Student student({1280, 800}, "builtin:wall-and-city?blocks=4");
        QVERIFY(student.isOpen);
        const Picture spoilt = student.drawnBy(truncated());
        student.drop({student.writeDepth("depth.npy", spoilt.depth)});
        QVERIFY(
            QTest::qWaitFor([&] { return student.examiner().phase() == Examiner::Phase::Diagnosing; }, Desk::kLong));
        QVERIFY(student.theirs());  // B is there before the causes are
        QVERIFY(student.button("Cancel")->isVisible());
        QTest::mouseClick(student.button("Cancel"), Qt::LeftButton);
        QVERIFY(student.isJudged());
        QVERIFY(student.theirs() && !student.theirs()->isDiagnosed);
        QVERIFY(student.causes().empty());
        QTest::mouseClick(student.button("Judge again"), Qt::LeftButton);
        QVERIFY(student.isJudged());
        QVERIFY(student.theirs()->isDiagnosed);
        QVERIFY(!student.causes().empty());
    }
    void theLessonIsALinkAndChineseIsSpoken()
    {
        Student student;
        QVERIFY(student.isOpen);
        const Picture spoilt = student.drawnBy(truncated());
        student.drop({student.writeDepth("depth.npy", spoilt.depth)});
        QVERIFY(student.isJudged());
        student.window.speak(Language::Chinese);
        QTest::qWait(50);
        const auto rows = student.causes();
        QVERIFY(!rows.empty());
        for (auto* label : student.diagnosis().findChildren<QLabel*>()) {
            QString said = label->text();
            said.remove(QRegularExpression("<[^>]*>|\\([a-z0-9=+ -]+\\)|near/z|depth\\.npy|[a-z0-9]+(-[a-z0-9]+)+"));
            if (!label->isHidden()) QVERIFY2(!said.contains(QRegularExpression("[A-Za-z]{3,}")), qPrintable(said));
        }
        student.photograph("diagnosis-zh");
        QLabel* link = nullptr;
        for (auto* label : student.diagnosis().findChildren<QLabel*>())
            if (label->text().contains("13-holes-and-fill-rules") && label->text().contains("href")) link = label;
        QVERIFY(link);
        link->setFocus();
        QTest::keyClick(link, Qt::Key_Tab);
        QTest::keyClick(link, Qt::Key_Return);
        if (!student.session.course().lesson()) emit link->linkActivated("13-holes-and-fill-rules");
        QVERIFY(student.session.course().lesson());
        student.window.speak(Language::English);
    }
    void aLessonKeepsHerPictureWhereItFitsAndGivesItBackAfterAComparison()
    {
        Student student;  // sees what the lesson's first page shows
        QVERIFY(student.isOpen);
        student.drop({student.writeDepth("depth.npy", student.drawnBy(truncated()).depth)});
        QVERIFY(student.isJudged());
        QString notice;
        connect(&student.session, &Session::noticed, this, [&](const QString& said) { notice = said; });
        Course&    course = student.session.course();
        const auto opens  = [&](const auto& go) {
            go();
            return QTest::qWaitFor([&] { return course.isSettled(); }, Desk::kLong) && student.isJudged();
        };
        const auto before = student.now().compare.theirs->title;
        QVERIFY(opens([&] { course.open(*course.find("13-holes-and-fill-rules")); }));
        QVERIFY(student.theirs() && !isStale(student.now()));
        QCOMPARE(student.now().compare.seen(), CompareShow::B);
        QCOMPARE(notice, QString());

        QVERIFY(opens([&] { course.next(); }));
        QVERIFY(course.page()->compared);
        QVERIFY(student.now().compare.other == course.page()->compared);
        QVERIFY2(notice.contains("your picture is B again after it"), qPrintable(notice));
        QVERIFY(opens([&] { course.back(); }));
        QVERIFY(student.theirs());
        QCOMPARE(student.theirs()->title, before);
        QVERIFY(opens([&] { course.next(); }));
        QVERIFY(!student.theirs());
        course.close();
        QVERIFY(student.isJudged());
        QVERIFY(student.theirs());
    }
    void aLessonOfAnotherSceneSaysWhereHerPictureIs()
    {
        Student student({1280, 800}, "builtin:cubes");
        QVERIFY(student.isOpen);
        student.drop({student.writeDepth("depth.npy", student.drawnBy(truncated()).depth)});
        QVERIFY(student.isJudged());
        QString notice;
        connect(&student.session, &Session::noticed, this, [&](const QString& said) { notice = said; });
        Course& course = student.session.course();
        course.open(*course.find("13-holes-and-fill-rules"));
        QVERIFY(QTest::qWaitFor([&] { return course.isSettled(); }, Desk::kLong));
        QVERIFY(student.isJudged());
        QCOMPARE(student.now().scene->word, QString("builtin:teapot"));
        QVERIFY(student.theirs() && isStale(student.now()));
        QCOMPARE(student.now().compare.seen(), CompareShow::A);
        QVERIFY2(notice.contains("Back to its view"), qPrintable(notice));

        student.window.dock("diagnosis")->raise();
        QTest::mouseClick(student.button("Back to its view"), Qt::LeftButton);
        QVERIFY(student.isJudged());
        QCOMPARE(student.now().scene->word, QString("builtin:cubes"));
        QVERIFY(!isStale(student.now()));
        QVERIFY(course.lesson());  // it is still being read
        course.show();
        QVERIFY(QTest::qWaitFor([&] { return course.isSettled(); }, Desk::kLong));
        QVERIFY(student.isJudged());
        QCOMPARE(student.now().scene->word, QString("builtin:teapot"));
        QVERIFY(student.theirs());
    }
    void aSessionBringsHerPictureBack()
    {
        Student student;
        QVERIFY(student.isOpen);
        student.drop({student.writeDepth("depth.npy", student.drawnBy(truncated()).depth)});
        QVERIFY(student.isJudged());
        student.session.showCompared(CompareShow::Difference);
        const Pipeline      pipeline = student.now().pipeline;
        const std::uint64_t wrong    = student.theirs()->answer->wrong.total();
        const QString       saved    = student.folder.filePath("mine.zscope-session");
        student.window.saveSessionTo(saved);
        QFile file(saved);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"files\": [\"depth.npy\"]"));  // both can be moved

        Student again;
        again.window.openSession(saved);
        QVERIFY(QTest::qWaitFor([&] { return again.theirs() && again.theirs()->isDiagnosed; }, Desk::kLong));
        QVERIFY(again.isJudged());
        QCOMPARE(again.theirs()->answer->wrong.total(), wrong);
        QCOMPARE(again.now().compare.seen(), CompareShow::Difference);
        QVERIFY(again.now().pipeline == pipeline);
        QVERIFY(!isStale(again.now()));

        QVERIFY(QFile::remove(student.folder.filePath("depth.npy")));
        Student without;
        without.window.openSession(saved);
        QVERIFY(
            QTest::qWaitFor([&] { return without.window.messages().sentence().contains("depth.npy"); }, Desk::kLong));
        QVERIFY(without.isJudged());
        QVERIFY(!without.theirs());
        QVERIFY(without.now().camera == student.now().camera);
    }
    void aReportIsSaved()
    {
        Student student;
        QVERIFY(student.isOpen);
        student.drop({student.writeDepth("depth.npy", student.drawnBy(truncated()).depth)});
        QVERIFY(student.isJudged());
        QString notice;
        connect(&student.session, &Session::noticed, this, [&](const QString& said) { notice = said; });
        const QString path = student.folder.filePath("report.html");
        student.examiner().saveReport(path);
        QVERIFY(student.isJudged());
        QVERIFY(notice.contains("report.html"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray page = file.readAll();
        QVERIFY(page.contains("x-truncated"));
        QVERIFY(page.contains("</html>"));
        student.examiner().saveReport(student.folder.filePath("no such folder/report.html"));
        QVERIFY(student.isJudged());
        QVERIFY(student.window.messages().sentence().contains("no such folder"));
    }
    void anotherBEndsIt()
    {
        Student student;
        QVERIFY(student.isOpen);
        student.drop({student.writeDepth("depth.npy", student.drawnBy(truncated()).depth)});
        QVERIFY(student.isJudged());
        student.session.compareWith(findPreset("scanline")->pipeline);
        QVERIFY(student.settles());
        QVERIFY(!student.theirs());
        QVERIFY(student.now().compare.result && student.now().compare.result->figures.isExact());
        QVERIFY(student.causes().empty());
        QVERIFY(student.button("Open my picture…")->isVisible());
    }
};

ZSCOPE_UI_TEST(DiagnosisTest, "diagnosis_test", Window)
#include "diagnosis_test.moc"
