// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison sheet: what the dialog asks, what stands on the page, and the files that come of it.
#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTimer>

#include "core/measure/approximate_switches.h"
#include "core/measure/compare.h"
#include "core/measure/comparison_sheet.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/sheet/sheet_maker.h"
#include "ui/text/numbers.h"

using namespace zscope;
using namespace zscope::ui;

class SheetTest final : public QObject {
    Q_OBJECT

private slots:
    void aSheetOfAViewThatNoOptionsCanSayBringsItsCameraAlong()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        const Camera camera = desk.session.now().camera;
        desk.session.open("builtin:teapot", Session::seenBy(camera, FaceCulling::None));
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().view.exact);
        const std::vector pair{BenchAlgorithm{"zbuffer", findPreset("zbuffer")->pipeline},
                               BenchAlgorithm{"scanline", findPreset("scanline")->pipeline}};
        QSignalSpy        made(&desk.window.sheets(), &SheetMaker::made);
        for (const char* name : {"exact.png", "exact.pdf"}) {
            desk.window.sheets().make(pair, desk.folder.filePath(name));
            QVERIFY(made.wait(Desk::kLong));
        }
        const QImage picture(desk.folder.filePath("exact.png"));
        QCOMPARE(picture.text("camera.json").toStdString(), cameraToJson(camera));
        QVERIFY(picture.text("Command").contains("--camera camera.json"));
        QFile page(desk.folder.filePath("exact.pdf"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray bytes = page.readAll();
        QVERIFY(bytes.contains("/EmbeddedFile"));
        QVERIFY(bytes.contains("camera.json") || bytes.contains(QByteArray("\0c\0a\0m\0e\0r\0a", 12)));
    }
    void cleanup() { QCoreApplication::processEvents(); }

    void aComparisonSheetIsAPageOrAPictureInTheLanguageOfTheWindow()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.compareWith(findPreset("scanline")->pipeline);
        QVERIFY(desk.settles());
        std::size_t likely = 0;
        const auto  all    = SheetMaker::choices(desk.session, likely);
        QCOMPARE(likely, std::size_t{2});  // A and B
        QCOMPARE(all.size(), presetsToTime().size());
        const std::vector pair{all[0], all[1]};
        QSignalSpy made(&desk.window.sheets(), &SheetMaker::made), failed(&desk.window.sheets(), &SheetMaker::failed);
        for (const char* language : {"english", "chinese"}) {
            desk.window.findChild<QAction*>(QStringLiteral("language.") + language)->trigger();
            for (const char* name : {"sheet.pdf", "sheet.png"}) {
                const QString file = desk.folder.filePath(QString::fromLatin1(language) + name);
                desk.window.sheets().make(pair, file);
                QVERIFY(made.wait(60'000));
                QFile written(file);
                QVERIFY(written.open(QIODevice::ReadOnly));
                const QByteArray bytes = written.readAll();
                if (file.endsWith("pdf")) {
                    QVERIFY(bytes.startsWith("%PDF-"));
                } else {
                    QVERIFY(bytes.contains("zscope-cli compare builtin:cubes"));
                    QVERIFY(bytes.contains("--algorithms zbuffer,scanline"));
                    QVERIFY(QImage(file).width() > 2 * 320);
                }
            }
        }
        if (const QString where = qEnvironmentVariable("ZSCOPE_PICTURES"); !where.isEmpty())
            for (const char* name : {"englishsheet.png", "chinesesheet.png", "chinesesheet.pdf"})
                QFile::copy(desk.folder.filePath(name), where + '/' + name);
        QVERIFY(QImage(desk.folder.filePath("englishsheet.png")) != QImage(desk.folder.filePath("chinesesheet.png")));
        desk.window.sheets().make(pair, "/no/such/folder/sheet.pdf");
        QVERIFY(failed.wait(60'000));
    }
    void aSheetHasTheCountersThatTheMeasurePanelShowsGroupedAsThere()
    {
        struct Writer final : SheetCanvas {
            std::vector<QString> texts;
            void                 begin(int, int) override {}
            int  width(std::string_view utf8, int size) override { return static_cast<int>(utf8.size()) * size / 2; }
            void text(int, int, std::string_view utf8, int, std::uint32_t) override
            {
                texts.push_back(QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())));
            }
            void fill(int, int, int, int, std::uint32_t) override {}
            void picture(int, int, int, int, const Grid<std::uint32_t>&) override {}
        } writer;
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        std::size_t    likely = 0;
        const auto     pair   = std::vector{SheetMaker::choices(desk.session, likely)[0],
                                      BenchAlgorithm{"scanline", findPreset("scanline")->pipeline}};
        CompareRequest request{.scene        = desk.session.now().scene->prepared,
                               .camera       = desk.session.now().camera,
                               .algorithms   = pair,
                               .frames       = 1,
                               .useReference = false};
        const auto     made = compareAlgorithms(request);
        QVERIFY(made);
        const Scene& scene = request.scene->scene();
        drawSheet(*made, scene, sheetWordsOf(*made, scene, request.camera, "zscope-cli compare"), writer);
        QVERIFY(scene.triangleCount() > 999);
        QCOMPARE(std::ranges::count(writer.texts, QString("triangles_in")), 2);
        // triangles_in and triangle_set_ups, of both algorithms
        QCOMPARE(std::ranges::count(writer.texts, grouped(scene.triangleCount())), 4);
        // of one of them only, and a dash for the other
        QCOMPARE(std::ranges::count(writer.texts, QString("active_edge_lines")), 2);
        // of neither
        QVERIFY(std::ranges::none_of(writer.texts, [](const QString& text) { return text == "pyramid_queries"; }));
        for (const QString& text : writer.texts)
            QVERIFY2(!text.contains(QRegularExpression("[0-9] [0-9]{3}\\b")), qPrintable(text));
    }
    void theDialogOfASheetBeginsWithWhatIsShownAndWantsTwoColumns()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:cubes"));
        bool wasAsked = false;
        QTimer::singleShot(0, &desk.window, [&] {
            auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            if (!dialog) return;
            wasAsked         = true;
            const auto boxes = dialog->findChildren<QCheckBox*>();
            auto*      ok    = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
            QCOMPARE(boxes[0]->text(), QString("hzb-octree"));
            QVERIFY(ok->isEnabled());  // two are checked
            boxes[1]->setChecked(false);
            QVERIFY(!ok->isEnabled() && !ok->toolTip().isEmpty());
            boxes[3]->setChecked(true);
            if (const QString where = qEnvironmentVariable("ZSCOPE_PICTURES"); !where.isEmpty())
                dialog->grab().save(where + "/sheet-dialog.png");
            ok->click();
        });
        const auto chosen = SheetMaker::ask(&desk.window, desk.session);
        QVERIFY(wasAsked);
        QCOMPARE(chosen.size(), std::size_t{2});
        QCOMPARE(chosen[0].name, std::string("hzb-octree"));
    }
};

ZSCOPE_UI_TEST(SheetTest, "sheet_test", Window)
#include "sheet_test.moc"
