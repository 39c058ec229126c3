// SPDX-License-Identifier: GPL-3.0-or-later
// What the picture shows of each pixel: depths in a range that can be moved, ids, how often each pixel was tested.
#include <QAction>
#include <QSignalSpy>
#include <QToolButton>

#include "core/lesson/colour_maps.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/session/engine.h"
#include "ui/view/range_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

QImage shownBy(const Session& session) { return imageOf(*session.now().colours()).copy(); }

}  // namespace

class LayersTest final : public QObject {
    Q_OBJECT

private slots:
    void aPlaceInTheBarAndItsDepthAreInverse()
    {
        for (const bool isLogarithmic : {false, true}) {
            const RangeScale scale{
                {.isAutomatic = false, .farthest = 0.001f, .nearest = 0.8f, .isLogarithmic = isLogarithmic}};
            for (int i = 0; i <= 20; ++i) QVERIFY(std::abs(scale.partOf(scale.depthAt(i / 20.0)) - i / 20.0) < 1e-5);
        }
        const RangeScale scale{{.isAutomatic = false, .farthest = 0.01f, .nearest = 1, .isLogarithmic = true}};
        QVERIFY(std::abs(static_cast<double>(scale.depthAt(0.5)) - 0.1) < 1e-6);
    }
    void theHistogramCountsEveryPixelOnceWhateverItsScale()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.setLayer(*findLayer("depth"));
        QVERIFY(desk.settles());
        for (const bool isLogarithmic : {false, true}) {
            desk.session.setDepthRange({.isLogarithmic = isLogarithmic});
            QVERIFY(desk.settles());
            std::uint64_t sum = 0;
            for (const std::uint64_t count : desk.session.now().spread()->histogram) sum += count;
            QCOMPARE(sum, desk.session.now().frame->coveredPixels);
        }
    }
    void theEndsOfTheRangeAreTheDarkestAndTheLightest()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.setLayer(*findLayer("depth"));
        QVERIFY(desk.settles());
        const QImage picture = shownBy(desk.session);
        const auto&  visible = *desk.session.now().visible();
        const auto&  used    = desk.session.now().spread()->used;
        int          darkest = 0, lightest = 0;
        for (int y = 0; y < visible.height(); ++y)
            for (int x = 0; x < visible.width(); ++x) {
                if (visible.idAt(x, y) < 0) continue;
                const bool isNearest  = visible.depthAt(x, y) == used.nearest,
                           isFarthest = visible.depthAt(x, y) == used.farthest;
                lightest += isNearest;
                darkest += isFarthest;
                if (isNearest) QCOMPARE(picture.pixel(x, y), cividis(1));
                if (isFarthest) QCOMPARE(picture.pixel(x, y), cividis(0));
            }
        QVERIFY(darkest > 0 && lightest > 0);
    }
    void draggingTheEndOfTheRangeRepaintsAndDoesNotDrawAgain()
    {
        Desk desk("zbuffer", {1920, 1080});
        QVERIFY(desk.open("builtin:city", {1280, 720}));
        auto* bar = desk.window.findChild<RangeBar*>();
        QVERIFY(!bar->isVisible());
        desk.session.setLayer(*findLayer("depth"));
        QVERIFY(desk.settles());
        QVERIFY(bar->isVisible());
        const QImage before     = shownBy(desk.session);
        const auto   generation = desk.session.now().frame->generation;
        QTest::mousePress(bar, Qt::LeftButton, {}, QPoint(bar->width() - 40, 20));
        for (int x = bar->width() - 60; x > bar->width() / 2; x -= 20) QTest::mouseMove(bar, QPoint(x, 20));
        QTest::mouseRelease(bar, Qt::LeftButton, {}, QPoint(bar->width() / 2, 20));
        QVERIFY(desk.settles());
        QVERIFY(!desk.session.now().look.range.isAutomatic);
        QVERIFY(shownBy(desk.session) != before);
        QCOMPARE(desk.session.now().frame->generation, generation);
        QVERIFY(desk.session.now().frame->look == desk.session.now().look);
        desk.photograph("depth");
        bar->setFocus();
        const float nearest = desk.session.now().look.range.nearest;
        QTest::keyClick(bar, Qt::Key_Left);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().look.range.nearest < nearest);
        desk.press(Qt::Key_N);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().look.range.isAutomatic);
        QCOMPARE(shownBy(desk.session), before);
        desk.session.setLayer(*findLayer("shaded"));
        QVERIFY(desk.settles());
        QVERIFY(!bar->isVisible());
    }
    void theHeatOfTestsGrowsWithTheSteps()
    {
        Desk desk("zbuffer", {1920, 1080});
        QVERIFY(desk.open("builtin:city", {640, 360}));
        desk.session.setLayer(*findLayer("tests"));
        QVERIFY(desk.settles());
        const auto sumOf = [&] {
            std::uint64_t sum = 0;
            for (const std::uint32_t tests : desk.session.now().step->state.tests.values()) sum += tests;
            return sum;
        };
        const std::uint64_t all   = sumOf();
        const QImage        whole = shownBy(desk.session);
        QVERIFY(whole != imageOf(desk.session.now().frame->frame.colour));  // the finished picture shows them, too
        desk.photograph("tests");
        QVERIFY(desk.goTo(Grain::Triangle, 20'000));
        QVERIFY(sumOf() < all && sumOf() > 0);
        QVERIFY(shownBy(desk.session) != whole);
    }
    void aStepLooksLikeThePictureItBecomes()
    {
        Desk desk("scanline");
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.setLayer(*findLayer("ids"));
        QVERIFY(desk.goTo(Grain::Line, 80));
        QVERIFY(desk.session.now().step->look.layer == findLayer("ids"));
        desk.session.setLayer(*findLayer("depth"));
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().step->look == desk.session.now().look);
        QVERIFY(!desk.session.now().step->ghosted.isNull());
        QVERIFY(desk.session.now().frame->look == desk.session.now().look);
    }
};

ZSCOPE_UI_TEST(LayersTest, "layers_test", Window)
#include "layers_test.moc"
