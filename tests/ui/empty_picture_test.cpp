// SPDX-License-Identifier: GPL-3.0-or-later
// A window whose picture is empty says why, in its language, for as long as it is.
#include <QFile>
#include <QRegularExpression>
#include <QToolButton>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/text/phrase_book.h"
#include "ui/window/message_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

void write(const QString& path, const QByteArray& text)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

bool isChinese(const QString& text) { return text.contains(QRegularExpression(QStringLiteral("[\u4E00-\u9FFF]"))); }

ViewRequest seenFrom(const dvec3& eye, const dvec3& target)
{
    ViewRequest view;
    view.eye = eye, view.target = target;
    view.width = 320, view.height = 180;
    return view;
}

}  // namespace

class EmptyPictureTest final : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    /// Two triangles that face +z, in the file `name`.obj.
    QString sceneOf(const QString& name, const QByteArray& materials)
    {
        write(m_folder.filePath(name + ".mtl"), materials);
        const QString file = m_folder.filePath(name + ".obj");
        write(file, "mtllib " + name.toUtf8()
                        + ".mtl\nv -2 -1 0\nv 0 -1 0\nv -1 1 0\nv 0 -1 0\nv 2 -1 0\nv 1 1 0\nusemtl a\nf 1 2 3\n"
                          "usemtl b\nf 4 5 6\n");
        return file;
    }
    static void isSaidInBoth(Desk& desk, const QString& why)
    {
        const MessageBar& bar = desk.window.emptiness();
        QCOMPARE(bar.sentence(), "the picture is empty: " + why);
        desk.window.speak(Language::Chinese);
        QCoreApplication::processEvents();
        QVERIFY2(isChinese(bar.sentence()) && !bar.sentence().contains("triangle"), qPrintable(bar.sentence()));
        desk.window.speak(Language::English);
        QCoreApplication::processEvents();
        QCOMPARE(bar.sentence(), "the picture is empty: " + why);
    }

private slots:
    void everyCauseOfTheViewIsSaidAndGoesWithIt()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open(sceneOf("plain", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n")));
        const MessageBar& bar = desk.window.emptiness();
        QCOMPARE(bar.sentence(), QString());
        const auto from = [&desk](const ViewRequest& view, FaceCulling culling = FaceCulling::None) {
            desk.session.setFaceCulling(culling);
            desk.session.useView(view);
            QVERIFY(desk.settles());
        };
        const ViewRequest good = seenFrom({0, 0, 5}, {0, 0, 0});
        ViewRequest       near = good, far = good;
        near.near = 10, near.far = 20;
        far.near = 0.1, far.far = 2;
        const std::pair<ViewRequest, const char*> causes[] = {
            {seenFrom({0, 0, 5}, {0, 0, 10}), "2 triangles lie behind the eye"},
            {near, "2 triangles lie before the near plane (10)"},
            {seenFrom({0, 0, 5}, {10, 0, 0}), "2 triangles lie outside the view"},
            {far, "2 triangles lie beyond the far plane (2)"},
            {seenFrom({0, 0, 5000}, {0, 0, 0}), "2 triangles lie between the centres of the pixels"}};
        for (const auto& [view, why] : causes) {
            from(view);
            isSaidInBoth(desk, why);
            from(good);
            QCOMPARE(bar.sentence(), QString());
        }
        from(seenFrom({0, 0, -5}, {0, 0, 0}), FaceCulling::Back);
        isSaidInBoth(desk, "2 triangles show their backs, and back faces are culled");
        desk.photograph("empty-picture");
        desk.session.setFaceCulling(FaceCulling::None);
        QVERIFY(desk.settles());
        QCOMPARE(bar.sentence(), QString());
    }
    void invisibleMaterialsAreNamed()
    {
        Desk desk("scanline");
        QVERIFY(desk.open(sceneOf("clear", "newmtl a\nKd 1 0 0\nTr 1\nnewmtl b\nKd 0 1 0\nTr 1\n")));
        isSaidInBoth(desk,
                     "2 triangles have opacity 0: materials 'a' (Tr 1, clear.mtl:3), 'b' (Tr 1, clear.mtl:6); 'Tr 1' "
                     "was most likely meant as opaque: write 'Tr 0' or 'd 1' into clear.mtl");
        // In the middle of a run the reason stays: it is the finished picture's.
        QVERIFY(desk.goTo(Grain::Line, 0));
        QVERIFY(!desk.window.emptiness().sentence().isEmpty());
        QVERIFY(desk.open(sceneOf("half", "newmtl a\nKd 1 0 0\nTr 1\nnewmtl b\nKd 0 1 0\n")));
        QCOMPARE(desk.window.emptiness().sentence(), QString());
    }
    /// tests/cli/empty_test.cpp brings them about.
    void everyOtherSentenceIsInThePhraseBook()
    {
        Desk desk("zbuffer");
        desk.window.speak(Language::Chinese);
        for (const char* sentence :
             {"the picture is empty: 1 triangle lies behind the eye; 1 triangle lies beyond the far plane (2)",
              "the picture is empty: 1,234 triangles have no area on the grid",
              "the picture is empty: 1 triangle has no area on the grid; 3 triangles reach beyond the range of the "
              "grid",
              "the picture is empty: 2 triangles have holes at all pixels they cover",
              "the picture is empty: 1 triangle has holes at all pixels it covers",
              "the picture is empty: 1 triangle is too transparent to change a colour",
              "the picture is empty: 2 triangles are too transparent to change a colour; 1 triangle has opacity 0: "
              "material 'a' (d 0, t.mtl:3)",
              "the picture is empty: 9 triangles have opacity 0: materials 'a' (d 0, t.mtl:3), 'b' (\"opacity\": 0, "
              "s.json:6), 'c', and 2 more",
              "the picture is empty: 9 triangles have opacity 0: materials 'a' (Tr 1, t.mtl:3), 'b' (Tr 1, t.mtl:6), "
              "'c' (Tr 1, t.mtl:9), and 2 more; 'Tr 1' was most likely meant as opaque: write 'Tr 0' or 'd 1' into "
              "t.mtl",
              "the picture is empty: the scene holds no triangles",
              "the picture is empty: 1 triangle covers pixels by the definition, but the chosen method leaves it out",
              "the picture of camera 'back, from far' is empty: 1 triangle shows its back, and back faces are culled",
              "material 'a' has opacity 0 (Tr 1): its faces are not drawn",
              "Triangle 0 covers 17 pixels and has opacity 0 (Tr 1, t.mtl:3): nothing of it is seen.",
              "Triangle 0 has opacity 0 (Tr 1, t.mtl:3) and is, at near/z 0.5, nearer than the opaque depth 0: its "
              "share of the colour is 0, so nothing of it is seen."})
            QVERIFY2(isChinese(said(sentence)) && !said(sentence).contains("triangle"), sentence);
    }
    void aReasonThatWasClosedStaysClosedUntilThereIsAnother()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open(sceneOf("closed", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n")));
        desk.session.useView(seenFrom({0, 0, 5}, {0, 0, 10}));
        QVERIFY(desk.settles());
        MessageBar& bar = desk.window.emptiness();
        QVERIFY(!bar.sentence().isEmpty());
        bar.findChild<QToolButton*>()->click();
        desk.session.useView(seenFrom({0, 0, 6}, {0, 0, 10}));
        QVERIFY(desk.settles());
        QCOMPARE(bar.sentence(), QString());
        desk.session.useView(seenFrom({0, 0, 5}, {10, 0, 0}));
        QVERIFY(desk.settles());
        QVERIFY(bar.sentence().contains("outside the view"));
    }
};

ZSCOPE_UI_TEST(EmptyPictureTest, "empty_picture_test", Window)
#include "empty_picture_test.moc"
