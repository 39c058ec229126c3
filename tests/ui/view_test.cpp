// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of the window, without a widget: zoom and pan, camera, overlay, numbers, track, pace.
#include <cmath>

#include <QTest>

#include "tests/ui/ui_test.h"
#include "ui/camera/camera_control.h"
#include "ui/panels/active_edges/bucket_chart.h"
#include "ui/panels/timeline/step_track.h"
#include "ui/session/player.h"
#include "ui/text/numbers.h"
#include "ui/view/overlay.h"
#include "ui/view/view_transform.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

double distanceOf(const dvec3& a, const dvec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }
double distanceOf(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

void verifyOrthonormal(const CameraControl& camera)
{
    const auto dot = [](const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    for (const dvec3* axis : {&camera.right, &camera.up, &camera.forward})
        QVERIFY(std::abs(dot(*axis, *axis) - 1) < 1e-12);
    QVERIFY(std::abs(dot(camera.right, camera.up)) < 1e-12);
    QVERIFY(std::abs(dot(camera.right, camera.forward)) < 1e-12);
    QVERIFY(std::abs(dot(camera.up, camera.forward)) < 1e-12);
}

}  // namespace

class ViewTest final : public QObject {
    Q_OBJECT

private slots:
    void zoomKeepsThePlaceUnderTheCursor()
    {
        ViewTransform view;
        view.setArea({1000, 800});
        view.setPicture({1600, 900});
        const QPointF cursor(700, 420);
        for (const double factor : {1.25, 3.0, 0.7, 10.0, 0.2}) {
            const QPointF held = view.toPicture(cursor);
            view.zoomAt(cursor, factor);
            QVERIFY(distanceOf(view.toPicture(cursor), held) < 1e-9);
        }
    }
    void fitShowsTheWholePictureAndFollowsTheWindow()
    {
        ViewTransform view;
        view.setPicture({1600, 900});
        for (const QSizeF area : {QSizeF(1000, 800), QSizeF(300, 900), QSizeF(3200, 2000)}) {
            view.setArea(area);
            QVERIFY(view.isFitted());
            const QRectF shown = view.toView(QRectF(0, 0, 1600, 900));
            QVERIFY(QRectF(-1, -1, area.width() + 2, area.height() + 2).contains(shown));
            QCOMPARE(view.visiblePixels(), QRect(0, 0, 1600, 900));
        }
        view.zoomAt({10, 10}, 2);
        QVERIFY(!view.isFitted());
    }
    void oneToOneIsExactlyOneDevicePixelPerPixel()
    {
        ViewTransform view;
        view.setArea({1001, 803});
        view.setPicture({1600, 900});
        view.oneToOne();
        QCOMPARE(view.zoom(), 1.0);
        const QPointF corner = view.toView(QPointF(0, 0));
        QCOMPARE(corner, QPointF(std::round(corner.x()), std::round(corner.y())));
    }
    void someOfThePictureStaysInViewHoweverFarItIsPanned()
    {
        ViewTransform view;
        view.setArea({1000, 800});
        view.setPicture({1600, 900});
        view.oneToOne();
        for (const QPointF by : {QPointF(1e6, 0), QPointF(-1e7, 3e6), QPointF(0, -1e7)}) {
            view.panBy(by);
            QVERIFY(view.toView(QRectF(0, 0, 1600, 900)).intersects(QRectF(0, 0, 1000, 800)));
        }
    }
    void everyPixelIsFoundFromItsCentreAndNothingOutside()
    {
        ViewTransform view;
        view.setArea({640, 480});
        view.setPicture({31, 17});
        view.zoomAt({100, 100}, 1.7);
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 31; ++x)
                QCOMPARE(view.pixelAt(view.toView(QPointF(x + 0.5, y + 0.5))), std::optional(QPoint(x, y)));
        QVERIFY(!view.pixelAt(view.toView(QPointF(-0.01, 3))));
        QVERIFY(!view.pixelAt(view.toView(QPointF(31.01, 3))));
    }
    void revealBringsAPixelIntoView()
    {
        ViewTransform view;
        view.setArea({400, 300});
        view.setPicture({1600, 900});
        view.oneToOne();
        view.reveal({1590, 5});
        QVERIFY(view.visiblePixels().contains(QPoint(1590, 5)));
    }

    void orbitKeepsPivotAndDistance()
    {
        CameraControl camera;
        camera.pivot    = {3, -2, 7};
        camera.distance = 12;
        for (int i = 0; i < 1000; ++i) camera.orbit(0.31, i % 3 == 0 ? 0.4 : -0.1);
        QVERIFY(std::abs(distanceOf(camera.eye(), {3, -2, 7}) - 12) < 1e-9);
        verifyOrthonormal(camera);
        QVERIFY(camera.up.y >= 0);  // the world never stands on its head
    }
    void anglesSetAreAnglesRead()
    {
        for (double first = -170; first < 180; first += 35)
            for (double second = 5; second < 180; second += 35)
                for (double third = -170; third < 180; third += 35) {
                    CameraControl camera;
                    camera.setAngles({first, second, third});
                    verifyOrthonormal(camera);
                    const YzyAngles read = camera.angles();
                    QVERIFY(std::abs(read.first - first) < 1e-9);
                    QVERIFY(std::abs(read.second - second) < 1e-9);
                    QVERIFY(std::abs(read.third - third) < 1e-9);
                }
    }
    void anglesOfTheFrontViewAreZeroAndDescribeItAgain()
    {
        CameraControl camera;
        camera.lookAlong(AxisView::Front);
        const YzyAngles zero = camera.angles();
        QCOMPARE(zero.first, 0.0);
        QCOMPARE(zero.second, 0.0);
        QCOMPARE(zero.third, 0.0);
        for (const AxisView axis : {AxisView::Front, AxisView::Right, AxisView::Top}) {
            camera.lookAlong(axis);
            CameraControl again;
            again.setAngles(camera.angles());
            QVERIFY(distanceOf(again.forward, camera.forward) < 1e-9);
            QVERIFY(distanceOf(again.up, camera.up) < 1e-9);
        }
    }
    void theModelTurnsAboutYByTheFirstAngle()
    {
        // Turning the model by a about y is moving the camera by -a: from +z towards -x.
        CameraControl camera;
        camera.distance = 1;
        camera.setAngles({90, 0, 0});
        QVERIFY(distanceOf(camera.eye(), {-1, 0, 0}) < 1e-12);
    }
    void lookingKeepsTheEyeAndFlyingMovesIt()
    {
        CameraControl camera;
        camera.distance = 4;
        camera.unit     = 2;
        const dvec3 eye = camera.eye();
        camera.look(0.7, 0.2);
        QVERIFY(distanceOf(camera.eye(), eye) < 1e-12);
        camera.fly(0, 0, 0.5);
        QVERIFY(std::abs(distanceOf(camera.eye(), eye) - 1) < 1e-12);
    }
    void theRequestOfAMovedCameraGivesThatCamera()
    {
        Bounds box;
        box.include({-1, -1, -1});
        box.include({1, 1, 1});
        CameraControl control;
        control.pivot    = {0.2, 0.1, 0};
        control.distance = 5;
        control.orbit(0.6, -0.3);
        const auto camera = makeCamera(control.view({}), box);
        QVERIFY(camera.ok());
        QVERIFY(distanceOf(camera->eye, control.eye()) < 1e-12);
        QVERIFY(distanceOf(camera->forward, control.forward) < 1e-12);
        QVERIFY(distanceOf(camera->up, control.up) < 1e-12);
        const CameraControl back = CameraControl::of(*camera, box);
        QVERIFY(distanceOf(back.eye(), control.eye()) < 1e-9);
    }

    void anEdgeIsDrawnFromItsFirstToItsLastLine()
    {
        const EdgeRow edge{
            .polygon = {}, .x = 20, .xSubpixels = 20 * 256, .dx = {1, 2}, .firstLine = 10, .lastLine = 30};
        const auto segment = segmentOf(edge, 20, {100, 100});
        QVERIFY(segment);
        QCOMPARE(segment->p1(), QPointF(15, 10.5));
        QCOMPARE(segment->p2(), QPointF(25, 30.5));
    }
    void anEdgeIsCutAtTheSidesOfThePicture()
    {
        const EdgeRow steep{
            .polygon = {}, .x = 5, .xSubpixels = 5 * 256, .dx = {1000, 1}, .firstLine = -500, .lastLine = 500};
        const auto segment = segmentOf(steep, 50, {100, 100});
        QVERIFY(segment);
        QVERIFY(segment->x1() >= -1e-9 && segment->x2() <= 100 + 1e-9);
        const EdgeRow outside{
            .polygon = {}, .x = 500, .xSubpixels = 500 * 256, .dx = {0, 1}, .firstLine = 0, .lastLine = 99};
        QVERIFY(!segmentOf(outside, 50, {100, 100}));
    }

    void numbersAreGroupedAndKeepTheirSign()
    {
        QCOMPARE(grouped(1234567), QString("1,234,567"));
        QCOMPARE(groupedSigned(-1234), QString("\u22121,234"));
        QCOMPARE(signedDecimal(0.25, 4), QString("+0.2500"));
        QCOMPARE(signedDecimal(-0.25, 4), QString("\u22120.2500"));
        QCOMPARE(signedDecimal(0, 4), QString("0.0000"));
        QCOMPARE(fraction({-15, 128}), QString("\u221215/128"));
        QCOMPARE(fraction({3, 1}), QString("3"));
    }
    void barsKeepTheHighestOfTheirLines()
    {
        QCOMPARE(gathered({1, 5, 2, 0, 7, 3}, 3), std::vector<int>({5, 2, 7}));
        QCOMPARE(gathered({1, 2}, 10), std::vector<int>({1, 2}));
        QCOMPARE(gathered({}, 10), std::vector<int>());
    }
    void aTrackOfAnyLengthReachesBothEnds()
    {
        for (const std::uint64_t count : {std::uint64_t{1}, std::uint64_t{900}, std::uint64_t{1} << 40}) {
            const TrackScale scale{count};
            QCOMPARE(scale.stepOf(0), std::uint64_t{0});
            QCOMPARE(scale.stepOf(scale.maximum()), count - 1);
            QCOMPARE(scale.positionOf(0), 0);
            QCOMPARE(scale.positionOf(count - 1), scale.maximum());
        }
        const TrackScale scale{900};
        for (std::uint64_t step = 0; step < 900; ++step) QCOMPARE(scale.stepOf(scale.positionOf(step)), step);
    }
    void paceOwesWhatItHasNotPlayed()
    {
        Pace pace{.perSecond = 10};
        int  played = 0;
        for (int i = 0; i < 100; ++i) played += pace.due(16);
        QCOMPARE(played, 16);
    }
};

ZSCOPE_UI_TEST(ViewTest, "view_test", Events)
#include "view_test.moc"
