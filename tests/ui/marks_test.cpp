// SPDX-License-Identifier: GPL-3.0-or-later
// Breakpoints are marked on the picture where they have a place; and what saved pictures are called.
#include <set>

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/session/picture_name.h"
#include "ui/view/overlay.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

QPoint coveredPixel(const Session& session)
{
    const VisibilityBuffer& visible = *session.now().visible();
    for (int x = visible.width() / 2; x < visible.width(); ++x)
        if (visible.idAt(x, visible.height() / 2) >= 0) return {x, visible.height() / 2};
    return {-1, -1};
}

OverlayMarks marksOf(const Session& session) { return overlayOf(session.now(), session.now().layers).marks; }

QRectF boundsOf(const std::vector<QLineF>& lines)
{
    QPolygonF corners;
    for (const QLineF& line : lines) corners << line.p1() << line.p2();
    return corners.boundingRect();
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class MarksTest final : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QCoreApplication::processEvents(); }

    void everyKindOfBreakpointIsMarkedWhereItHasAPlace()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:cubes"));
        Session&     session = desk.session;
        const QPoint pixel   = coveredPixel(session);
        session.pick(pixel);
        QVERIFY(desk.settles());
        QVERIFY(marksOf(session).isEmpty());
        const auto triangle =
            TriangleId{static_cast<std::uint32_t>(session.now().visible()->idAt(pixel.x(), pixel.y()))};
        session.toggleBreakpoint({.on = Breakpoint::On::Line, .line = 50});
        session.toggleBreakpoint({.on = Breakpoint::On::Line, .line = 9999});  // has no place
        session.toggleBreakpoint({.on = Breakpoint::On::Pixel, .pixel = {pixel.x(), pixel.y()}});
        session.toggleBreakpoint({.on = Breakpoint::On::Pixel, .pixel = {9999, 1}});
        QCOMPARE(marksOf(session).lines, std::vector<int>{50});
        QCOMPARE(marksOf(session).pixels, std::vector<QPoint>{pixel});
        QVERIFY(marksOf(session).outlines.empty());

        session.toggleBreakpoint({.on = Breakpoint::On::Triangle, .triangle = triangle});
        QCOMPARE(marksOf(session).outlines.size(), std::size_t{1});
        QVERIFY(
            boundsOf(marksOf(session).outlines[0]).adjusted(-1, -1, 1, 1).contains(QPointF(pixel) + QPointF(0.5, 0.5)));
        Breakpoint unknown{.on = Breakpoint::On::Node};
        unknown.node = {std::nullopt, "0.7.7.7.7.7"};
        session.toggleBreakpoint(unknown);
        QCOMPARE(marksOf(session).outlines.size(), std::size_t{1});
        const HierarchyState& hierarchy = *session.now().hierarchy();
        const int id = nodeHolding(triangle, hierarchy.nodes, *session.now().scene->prepared, TreeKind::Octree);
        QVERIFY(id >= 0);
        Breakpoint node{.on = Breakpoint::On::Node};
        node.node = nameOf(hierarchy.nodes[static_cast<std::size_t>(id)]);
        session.toggleBreakpoint(node);
        QCOMPARE(marksOf(session).outlines.size(), std::size_t{2});
        // its triangle is inside it
        QVERIFY(boundsOf(marksOf(session).outlines[1]).contains(QPointF(pixel) + QPointF(0.5, 0.5)));
        desk.photograph("breakpoints");
    }
    void aMarkIsSeenOverThePictureAndCanBeHidden()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        const QPoint pixel = coveredPixel(desk.session);
        const auto   view  = [&] {
            QCoreApplication::processEvents();
            return desk.window.view().picture(true);
        };
        const QImage bare = view(), plain = desk.window.view().picture(false);
        desk.session.toggleBreakpoint({.on = Breakpoint::On::Pixel, .pixel = {pixel.x(), pixel.y()}});
        const QImage marked = view();
        QVERIFY(marked != bare);
        QCOMPARE(marked.pixel(pixel), bare.pixel(pixel));  // what it shows is still to be seen
        desk.session.toggleBreakpoint({.on = Breakpoint::On::Line, .line = 30});
        const QImage lined   = view();
        int          touched = 0;
        for (int x = 0; x < lined.width(); ++x) touched += lined.pixel(x, 30) != marked.pixel(x, 30);
        QVERIFY(touched > lined.width() / 2);
        QCOMPARE(desk.window.view().picture(false), plain);
        desk.window.findChild<QAction*>("over.marks")->trigger();
        QCOMPARE(view(), bare);
        desk.window.findChild<QAction*>("over.marks")->trigger();
        QCOMPARE(view(), lined);
    }
    void aTemplateIsHeldAgainstWhatAFileMayBeCalled()
    {
        for (const char* good : {"{scene}_{algorithm}_{n}", "{n}", "lesson 3 {grain} {step} ({n})", "\xE5\x9B\xBE{n}"})
            QVERIFY2(!whyNoPictureTemplate(QString::fromUtf8(good)), good);
        std::set<QString> reasons;
        for (const char* bad : {"", "  ", "{scene}", "../{n}", "a/{n}", "a\\{n}", "{n}:", ".{n}", "{size}_{n}", "{n",
                                "n}", "{scene{n}}", "a\nb{n}"}) {
            const auto why = whyNoPictureTemplate(bad);
            QVERIFY2(why && !why->isEmpty(), bad);
            reasons.insert(*why);
        }
        QVERIFY(whyNoPictureTemplate(QString(200, 'x') + "{n}"));
        QVERIFY(reasons.size() >= 6);
        Settings settings(QDir::temp().filePath("zscope-no-such-settings.ini"));
        QCOMPARE(settings.pictureTemplate(), QString(kPictureTemplate));
    }
    void theTemplateIsTypedAndNamesThePicturesAndNoneTakesThePlaceOfAnother()
    {
        Desk          desk("zbuffer");
        QTemporaryDir pictures;
        desk.settings.setPictureFolder(pictures.path());
        QVERIFY(desk.open("builtin:teapot"));
        desk.press(Qt::Key_F12);
        QVERIFY(QFile::exists(pictures.filePath("teapot_zbuffer_1.png")));
        bool wasRefused = false, showedNext = false;
        QTimer::singleShot(100, &desk.window, [&] {
            auto* dialog = desk.window.findChild<QDialog*>("pictureNames");
            QVERIFY(dialog);
            auto* field = dialog->findChild<QLineEdit*>();
            auto* keep  = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
            QVERIFY(field->hasFocus());
            QTest::keyClicks(field, "view of {scene}");  // all was selected: it is typed over
            wasRefused = !keep->isEnabled();
            QTest::keyClicks(field, " {n}");
            for (const QLabel* label : dialog->findChildren<QLabel*>())
                showedNext = showedNext || label->text().contains("view of teapot 1.png");
            if (const QString where = qEnvironmentVariable("ZSCOPE_PICTURES"); !where.isEmpty())
                dialog->grab().save(where + "/picture-names.png");
            QTest::keyClick(field, Qt::Key_Return);
        });
        desk.window.findChild<QAction*>("file.picture-names")->trigger();
        QVERIFY(wasRefused);
        QVERIFY(showedNext);
        QCOMPARE(desk.settings.pictureTemplate(), QString("view of {scene} {n}"));
        desk.window.activateWindow();  // as a window manager does when the dialog has gone
        QVERIFY(QTest::qWaitForWindowActive(&desk.window));
        desk.press(Qt::Key_F12);
        const QByteArray first = bytesOf(pictures.filePath("view of teapot 1.png"));
        QVERIFY(!first.isEmpty());
        desk.session.setPipeline(findPreset("scanline")->pipeline);
        QVERIFY(desk.settles());
        desk.press(Qt::Key_F12, Qt::ControlModifier);
        QVERIFY(QFile::exists(pictures.filePath("view of teapot 2.png")));
        QCOMPARE(bytesOf(pictures.filePath("view of teapot 1.png")), first);
        desk.settings.setPictureTemplate("no number");  // refused, wherever it comes from
        QCOMPARE(desk.settings.pictureTemplate(), QString("view of {scene} {n}"));
    }
};

ZSCOPE_UI_TEST(MarksTest, "marks_test", Window)
#include "marks_test.moc"
