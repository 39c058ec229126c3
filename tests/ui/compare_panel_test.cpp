// SPDX-License-Identifier: GPL-3.0-or-later
// Two algorithms side by side: keys, flip, wipe, difference, linked steps; and the arithmetic of the difference.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/compare/compare_words.h"
#include "ui/session/engine.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

const Pipeline& pipelineOf(std::string_view name) { return findPreset(name)->pipeline; }

/// One that is wrong on purpose: a fill rule that rounds the first line.
Pipeline wrong()
{
    Pipeline pipeline = pipelineOf("edge-walk");
    pipeline.fault    = Fault::FirstLineRounded;
    return pipeline;
}

VisibilityBuffer bufferOf(const std::vector<std::pair<int, float>>& pixels)  // id or -1, depth
{
    VisibilityBuffer buffer;
    buffer.resize(static_cast<int>(pixels.size()), 1, {});
    buffer.clearRows(0, 1);
    for (std::size_t x = 0; x < pixels.size(); ++x) {
        if (pixels[x].first < 0) continue;
        buffer.row(0)[x] = keyOf(pixels[x].second, static_cast<std::uint32_t>(pixels[x].first) + 1);
    }
    return buffer;
}

}  // namespace

class CompareTest final : public QObject {
    Q_OBJECT

private slots:
    void everyPixelHasItsKindOfDifference()
    {
        const float near = 0.5f, nearer = std::nextafter(near, 1.0f), far = 0.25f;
        const auto  a = bufferOf({{1, near}, {1, near}, {1, near}, {1, near}, {-1, 0}, {-1, 0}, {1, near}});
        const auto  b = bufferOf({{1, near}, {1, nearer}, {1, far}, {-1, 0}, {2, near}, {-1, 0}, {2, near}});
        using enum PixelDifference;
        const Difference                   exact = differenceOf(a, b, 0);
        const std::vector<PixelDifference> kinds{None, DepthNearer, DepthFarther, Hole, Spill, None, Surface};
        for (std::size_t x = 0; x < kinds.size(); ++x) QCOMPARE(exact.kinds.at(static_cast<int>(x), 0), kinds[x]);
        QCOMPARE(exact.differing(), std::uint64_t{5});
        QCOMPARE(exact.heat.at(0, 0), 0xFFFFFFFFu);
        QCOMPARE(exact.heat.at(3, 0), kWrongColour);
        QVERIFY(exact.heat.at(1, 0) != kWrongColour && exact.heat.at(1, 0) != exact.heat.at(2, 0));
        QVERIFY(exact.worst);
        QCOMPARE((*exact.worst)[0], 4);  // a spill ranks before a hole
        const Difference tolerant = differenceOf(a, b, 1);
        QCOMPARE(tolerant.kinds.at(1, 0), None);
        QCOMPARE(tolerant.kinds.at(2, 0), DepthFarther);
        QCOMPARE(tolerant.differing(), std::uint64_t{4});
    }
    void twoExactAlgorithmsAreEqualToTheBit()
    {
        Desk desk("hzb-octree");
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.compareWith(pipelineOf("scanline"));
        QVERIFY(desk.settles());
        const auto& result = desk.session.now().compare.result;
        QVERIFY(result);
        QVERIFY(result->figures.isExact());
        QCOMPARE(result->difference.differing(), std::uint64_t{0});
        QVERIFY(wordsOf(*result).verdict.contains("to the bit"));
    }
    void aFaultIsCountedAndItsWorstPixelCanBePicked()
    {
        Desk desk("zbuffer", {1920, 1080});
        QVERIFY(desk.open("builtin:teapot", {640, 360}));
        desk.session.compareWith(wrong());
        QVERIFY(desk.settles());
        const auto& result = desk.session.now().compare.result;
        QVERIFY(result);
        QVERIFY(result->figures.wrongPixels() > 0);
        QCOMPARE(result->difference.counts[static_cast<std::size_t>(PixelDifference::Hole)], result->figures.holes);
        QCOMPARE(result->difference.counts[static_cast<std::size_t>(PixelDifference::Spill)], result->figures.spills);
        QCOMPARE(result->difference.counts[static_cast<std::size_t>(PixelDifference::Surface)],
                 result->figures.wrongSurface());
        desk.window.dock("compare")->raise();
        for (auto* button : desk.window.dock("compare")->findChildren<QPushButton*>())
            if (button->text() == "Worst pixel") QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(desk.session.now().picked);
        const QPoint at = *desk.session.now().picked;
        QVERIFY(result->difference.kinds.at(at.x(), at.y()) >= PixelDifference::Surface);
        desk.press(Qt::Key_D);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::Difference);
        desk.photograph("difference");
    }
    void aFaultIsJudgedByWhatIsRightWhicheverOfThemIsA()
    {
        Desk     desk("zbuffer");
        Pipeline faulty = pipelineOf("edge-walk");
        faulty.fault    = Fault::HorizontalByX;
        QVERIFY(desk.open("builtin:teapot", {640, 360}));
        desk.session.compareWith(faulty);
        QVERIFY(desk.settles());
        const ErrorFigures asB = desk.session.now().compare.result->figures;
        QVERIFY(asB.holes > 0);
        desk.session.swapCompared();
        QVERIFY(desk.settles());
        const Comparison& swapped = *desk.session.now().compare.result;
        QVERIFY(swapped.isAJudged);
        QCOMPARE(swapped.figures.holes, asB.holes);
        QCOMPARE(swapped.figures.spills, asB.spills);
        QVERIFY(wordsOf(swapped).figures[0].name.contains("B shows something, A does not"));
    }
    void sideBySideBothPanesMoveTogetherAndPickTheSamePixel()
    {
        Desk desk("zbuffer", {1600, 900});
        QVERIFY(desk.open("builtin:teapot", {640, 360}));
        desk.session.compareWith(wrong());
        QVERIFY(desk.settles());
        desk.press(Qt::Key_B);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::Beside);
        auto& view = *desk.window.findChild<FrameView*>();
        QVERIFY(view.view().area().width() < view.width() / 2.0);
        const QPoint pixel(320, 180);
        const QPoint at     = view.view().toView(QPointF(pixel) + QPointF(0.5, 0.5)).toPoint();
        const int    offset = static_cast<int>(view.view().area().width()) + 4;
        QTest::mouseClick(&view, Qt::RightButton, {}, at + QPoint(offset, 0));
        QCOMPARE(desk.session.now().picked, std::optional(pixel));
        desk.session.pick({});
        QTest::mouseClick(&view, Qt::RightButton, {}, at);
        QCOMPARE(desk.session.now().picked, std::optional(pixel));
        QTest::mouseClick(&view, Qt::RightButton, {}, QPoint(view.width() / 2, at.y()));  // between them lies no pixel
        QVERIFY(!desk.session.now().picked);
        const QImage seen   = view.grab().toImage();
        const QRgb   ground = seen.pixel(2, seen.height() - 2);
        int          left = 0, right = 0;
        for (int x = 0; x < seen.width(); ++x)
            (x < seen.width() / 2 ? left : right) += seen.pixel(x, seen.height() / 2) != ground;
        QVERIFY(left > 50 && right > 50);
        desk.photograph("side-by-side");
        desk.press(Qt::Key_B);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::A);
        QVERIFY(view.view().area().width() > view.width() * 0.9);
    }
    void beyondTheWipePixelsAreThoseOfB()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot", {640, 360}));
        desk.session.compareWith(wrong());
        QVERIFY(desk.settles());
        const auto& kinds = desk.session.now().compare.result->difference.kinds;
        QPoint      differs(-1, -1);
        for (int y = 0; y < 360 && differs.x() < 0; ++y)
            for (int x = 0; x < 640; ++x)
                if (kinds.at(x, y) >= PixelDifference::Surface) differs = {x, y};
        QVERIFY(differs.x() >= 0);
        desk.press(Qt::Key_W);
        const auto idShown = [&] {
            const auto facts = factsOf(desk.session.now(), differs);
            return facts->triangle ? static_cast<std::int64_t>(facts->triangle->value) : -1;
        };
        desk.session.setWipe(1);
        QCOMPARE(idShown(), desk.session.now().frame->frame.visible.idAt(differs.x(), differs.y()));
        desk.session.setWipe(0);
        QCOMPARE(idShown(), desk.session.now().compare.frame->frame.visible.idAt(differs.x(), differs.y()));
        QVERIFY(desk.session.now().frame->frame.visible.idAt(differs.x(), differs.y())
                != desk.session.now().compare.frame->frame.visible.idAt(differs.x(), differs.y()));
    }
    void keysChooseBFlipWipeAndShowTheDifference()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        desk.press(Qt::Key_3, Qt::ShiftModifier);
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().compare.other == presets()[2].pipeline);
        QVERIFY(desk.session.now().pipeline == pipelineOf("zbuffer"));
        desk.press(Qt::Key_T);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::B);
        desk.press(Qt::Key_T);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::A);
        desk.press(Qt::Key_W);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::Wipe);
        desk.press(Qt::Key_D);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::Difference);
        desk.press(Qt::Key_D);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::A);
        desk.press(Qt::Key_2);  // A changes, B stays
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline == presets()[1].pipeline);
        QVERIFY(desk.session.now().compare.other == presets()[2].pipeline);
        QVERIFY(desk.session.now().compare.result && desk.session.now().compare.result->a == desk.session.now().frame);
    }
    void holdingShiftShowsBForAsLong()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.compareWith(pipelineOf("scanline"));
        QVERIFY(desk.settles());
        QTest::keyPress(&desk.window, Qt::Key_Shift);
        QVERIFY(QTest::qWaitFor([&] { return desk.session.now().compare.seen() == CompareShow::B; }, Desk::kLong));
        QTest::keyRelease(&desk.window, Qt::Key_Shift);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::A);
        QTest::keyPress(&desk.window, Qt::Key_Shift);  // with another key it is part of a shortcut
        desk.press(Qt::Key_4, Qt::ShiftModifier);
        QTest::qWait(200);
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::A);
        QTest::keyRelease(&desk.window, Qt::Key_Shift);
    }
    void theWipeIsDraggedByItsHandle()
    {
        Desk desk("zbuffer", {1920, 1080});
        QVERIFY(desk.open("builtin:teapot", {640, 360}));
        desk.session.compareWith(wrong());
        QVERIFY(desk.settles());
        desk.press(Qt::Key_W);
        FrameView& view    = desk.window.view();
        const auto placeOf = [&](double x) {
            return (view.view().toView(QPointF(x, 100)) / view.devicePixelRatioF()).toPoint();
        };
        QTest::mousePress(&view, Qt::LeftButton, {}, placeOf(320));
        QTest::mouseMove(&view, placeOf(200));
        QTest::mouseMove(&view, placeOf(160));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, placeOf(160));
        QVERIFY(std::abs(desk.session.now().compare.wipe - 0.25) < 0.01);
        QVERIFY(!desk.session.now().picked);
        auto* slider = desk.window.dock("compare")->findChild<QSlider*>();
        QVERIFY(std::abs(slider->value() - 250) < 10);
        slider->setValue(700);
        QCOMPARE(desk.session.now().compare.wipe, 0.7);
        desk.session.setWipe(0.4);
        desk.photograph("wipe");
    }
    void bStopsAtTheSameLine()
    {
        Desk desk("scanline", {1920, 1080});
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.compareWith(pipelineOf("interval"));
        QVERIFY(desk.goTo(Grain::Line, 70));
        const Snapshot& now = desk.session.now();
        QVERIFY(now.compare.step);
        QVERIFY(now.compare.step->pipeline == pipelineOf("interval"));
        QCOMPARE(now.compare.step->state.step.value, std::uint64_t{70});
        QVERIFY(now.compare.result && now.compare.result->stepA == now.step);
        desk.press(Qt::Key_Right);
        QVERIFY(desk.settles());
        QCOMPARE(now.compare.step->state.step.value, std::uint64_t{71});
        desk.session.compareWith(pipelineOf("zbuffer"));  // has no lines: the same part of its run
        QVERIFY(desk.settles());
        desk.session.showCompared(CompareShow::Wipe);
        desk.window.dock("compare")->raise();
        desk.photograph("compare");
        const double partA = static_cast<double>(now.step->state.step.value) / static_cast<double>(now.step->last());
        const double partB =
            static_cast<double>(now.compare.step->state.step.value) / static_cast<double>(now.compare.step->last());
        QVERIFY(std::abs(partA - partB) < 0.01);
        desk.session.goToEnd();
        QVERIFY(desk.settles());
        QVERIFY(now.compare.result && now.compare.result->figures.isExact());
    }
    void bFollowsTheCameraAndAToleranceIsAskedAgain()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:teapot"));
        Pipeline rough             = pipelineOf("zbuffer");
        rough.approximation.format = DepthFormat::Fixed16;
        desk.session.compareWith(rough);
        QVERIFY(desk.settles());
        desk.session.moveCamera([](CameraControl& camera) { camera.orbit(0.3, 0.1); });
        QVERIFY(desk.settles());
        const CompareState& compare = desk.session.now().compare;
        QVERIFY(compare.frame->camera == desk.session.now().frame->camera);
        QVERIFY(compare.result && compare.result->b == compare.frame);
        const std::uint64_t strict = compare.result->difference.differing();
        auto*               box    = desk.window.dock("compare")->findChild<QSpinBox*>();
        box->setValue(100'000'000);
        QVERIFY(desk.settles());
        QCOMPARE(compare.result->tolerance, 100'000'000u);
        QVERIFY(compare.result->difference.differing() < strict);
        QCOMPARE(compare.result->figures.depthBitsDiffer > 0, true);
    }
    void swappingAndEndingLeaveNothingBehind()
    {
        Desk desk("zbuffer");
        QVERIFY(desk.open("builtin:cubes"));
        desk.session.compareWith(pipelineOf("scanline"));
        QVERIFY(desk.settles());
        desk.session.swapCompared();
        QVERIFY(desk.settles());
        QVERIFY(desk.session.now().pipeline == pipelineOf("scanline"));
        QVERIFY(desk.session.now().compare.other == pipelineOf("zbuffer"));
        QVERIFY(desk.session.now().compare.result);
        desk.session.showCompared(CompareShow::Difference);
        desk.session.compareWith({});
        QCOMPARE(desk.session.now().compare.seen(), CompareShow::A);
        QVERIFY(!desk.session.now().compare.result);
        QVERIFY(desk.settles());
    }
};

ZSCOPE_UI_TEST(CompareTest, "compare_panel_test", Window)
#include "compare_panel_test.moc"
