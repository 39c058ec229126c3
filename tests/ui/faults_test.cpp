// SPDX-License-Identifier: GPL-3.0-or-later
// The fault gallery: what each fault spoils is counted in the view on show, and can be switched on and off.
#include <QAbstractItemModelTester>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

#include "core/frame/faults.h"
#include "core/lesson/difference.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/faults/faults_model.h"
#include "ui/panels/faults/faults_panel.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

struct Gallery {
    FaultsPanel& panel;
    QTableView&  table;
    FaultsModel& model;

    bool isComplete() const
    {
        return QTest::qWaitFor(
            [&] {
                for (int row = 0; row < model.rowCount(); ++row)
                    if (!model.pictureOf(row)) return false;
                return panel.isIdle();
            },
            Desk::kLong);
    }
};

Gallery galleryOf(Desk& desk)
{
    desk.window.dock("faults")->raise();
    QTest::qWait(50);
    auto& panel = static_cast<FaultsPanel&>(desk.window.dock("faults")->panel());
    auto& table = *panel.findChild<QTableView*>();
    return {panel, table, static_cast<FaultsModel&>(*table.model())};
}

}  // namespace

class FaultsTest final : public QObject {
    Q_OBJECT

private slots:
    void nothingIsDrawnForAGalleryThatIsNotSeen()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        auto& panel = static_cast<FaultsPanel&>(desk.window.dock("faults")->panel());
        QTest::qWait(100);
        QVERIFY(panel.isIdle());
        QVERIFY(!panel.findChild<FaultsModel*>()->pictureOf(0));
    }
    void everyFaultTellsHowManyPixelsItSpoils()
    {
        Desk desk("zbuffer", {1600, 1000});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=2"));
        const Gallery            gallery = galleryOf(desk);
        QAbstractItemModelTester tester(&gallery.model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QVERIFY(gallery.isComplete());
        int spoilt = 0;
        for (int row = 0; row < gallery.model.rowCount(); ++row) {
            const FaultPicture& of = *gallery.model.pictureOf(row);
            // The same by other means: both drawn by the session's own renderer, compared by the definition.
            DrawRequest request = desk.session.request();
            Frame       right, wrong;
            request.pipeline       = of.pipeline;
            request.pipeline.fault = {};
            // a renderer of its own: where stripes meet moves from frame to frame
            QVERIFY(Renderer().draw(request, right).ok());
            request.pipeline = of.pipeline;
            QVERIFY(Renderer().draw(request, wrong).ok());
            std::uint64_t differ = 0;
            for (int y = 0; y < right.visible.height(); ++y)
                for (int x = 0; x < right.visible.width(); ++x)
                    differ += right.visible.idAt(x, y) != wrong.visible.idAt(x, y)
                              || right.visible.depthAt(x, y) != wrong.visible.depthAt(x, y);
            QCOMPARE(of.wrongPixels, differ);
            spoilt += differ > 0;
            bool seen = false;
            for (int y = 0; y < of.picture.height() && !seen; ++y)
                for (int x = 0; x < of.picture.width() && !seen; ++x)
                    seen = of.picture.pixel(x, y) == QRgb{kWrongColour};
            QCOMPARE(seen, differ > 0);
        }
        QVERIFY2(spoilt >= 8, qPrintable(QString::number(spoilt)));
        gallery.table.setCurrentIndex(gallery.model.index(6, 0));
        desk.photograph("faults");
    }
    void aFaultIsSwitchedOnAndOffByTheKeyboard()
    {
        Desk desk("hzb-octree", {1600, 1000});
        QVERIFY(desk.open("builtin:wall-and-city?blocks=2"));
        const Gallery gallery = galleryOf(desk);
        QVERIFY(gallery.isComplete());
        int row = 0;
        while (faults()[static_cast<std::size_t>(row)].fault != Fault::NearestInCells) ++row;
        gallery.table.setCurrentIndex(gallery.model.index(row, 0));
        gallery.table.setFocus();
        QTest::keyClick(&gallery.table, Qt::Key_Return);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline.fault == Fault::NearestInCells);
        QVERIFY(gallery.model.pictureOf(row));  // switching one on does not empty the gallery
        QVERIFY(gallery.model.data(gallery.model.index(row, 0)).toString().startsWith(QChar(0x2716)));
        QTest::keyClick(&gallery.table, Qt::Key_Return);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline == findPreset("hzb-octree")->pipeline);
    }
};

ZSCOPE_UI_TEST(FaultsTest, "faults_test", Window)
#include "faults_test.moc"
