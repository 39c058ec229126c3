// SPDX-License-Identifier: GPL-3.0-or-later
// The window is closed in the middle of whatever it does, 200 times; and stepped through for a long time.
//
// Sanitizers   part of what runs under the address and the thread sanitizer: what is found there is a pointer that
//              outlived its window, or a value that two threads write
#include <fstream>
#include <random>

#include <unistd.h>

#include <QPushButton>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/measure/measure_panel.h"
#include "ui/predict/predictions.h"
#include "ui/session/course.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryIsWatched = true;  // freed memory is kept aside by the sanitizer
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kMemoryIsWatched = true;
#else
constexpr bool kMemoryIsWatched = false;
#endif
#else
constexpr bool kMemoryIsWatched = false;
#endif

constexpr std::uint32_t kSeed = 20261121;

/// Bytes of this process that are in memory.
std::uint64_t residentBytes()
{
    std::ifstream statm("/proc/self/statm");
    std::uint64_t total = 0, resident = 0;
    statm >> total >> resident;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

ViewRequest smallView(const Scene&)
{
    ViewRequest view;
    view.width  = 80;
    view.height = 45;
    return view;
}

enum class Busy {
    Loading,
    Rendering,
    Playing,
    Explaining,
    Comparing,
    Searching,
    Gallery,
    Dragging,
    Lesson,
    Measuring,
    Predicting
};
constexpr std::array kBusy{Busy::Loading,   Busy::Rendering, Busy::Playing,   Busy::Explaining,
                           Busy::Comparing, Busy::Searching, Busy::Gallery,   Busy::Dragging,
                           Busy::Lesson,    Busy::Measuring, Busy::Predicting};

/// Sets the window to work; does not wait for it.
void begin(Desk& desk, Busy what, std::uint32_t chance)
{
    Session& session = desk.session;
    switch (what) {
        case Busy::Loading:
            desk.window.open("builtin:city?blocks=6&seed=2");
            break;
        case Busy::Rendering:
            for (int i = 0; i < 3; ++i) session.moveCamera([](CameraControl& camera) { camera.orbit(0.2, 0.1); });
            break;
        case Busy::Playing:
            session.goToStart();
            session.player().setSpeed(100'000);
            session.player().setPlaying(true);
            break;
        case Busy::Explaining:
            desk.window.dock("why")->raise();
            session.pick(QPoint(40, 22));
            break;
        case Busy::Comparing:
            session.compareWith(findPreset("interval")->pipeline);
            session.linkBy(Link::Line);
            session.stepBy(-20);
            break;
        case Busy::Searching:
            session.pick(QPoint(40, 22));
            session.toggleBreakpoint({.on = Breakpoint::On::Line, .line = 22});
            session.goToStart();
            session.runTo(Direction::Forward);
            session.goToPixelChange(Session::PixelJump::First);
            break;
        case Busy::Gallery:
            desk.window.dock("faults")->raise();
            break;
        case Busy::Dragging:
            for (std::uint64_t step = 0; step < 40; ++step) session.goToStep(step * 7);
            break;
        case Busy::Lesson:
            session.course().open(chance % session.course().lessons().size(), chance / 16 % 4);
            break;
        case Busy::Measuring:
            desk.window.useLayout("profile");
            for (auto* button : desk.window.dock("measure")->findChildren<QPushButton*>())
                if (button->text() == "Measure") button->click();
            break;
        case Busy::Predicting:
            for (const Topic topic : kTopics) session.predictions().setOn(topic, true);
            session.goToStart();
            // asks about what follows a step that is seen
            if (QTest::qWaitFor([&] { return session.isIdle() && session.position(); }, Desk::kLong)) session.stepBy(1);
            break;
    }
}

bool isBusy(Desk& desk)
{
    return !desk.session.isIdle() || !desk.session.course().isSettled()
           || static_cast<MeasurePanel&>(desk.window.dock("measure")->panel()).measurer().isRunning();
}

}  // namespace

class ClosingTest final : public QObject {
    Q_OBJECT

private slots:
    void closingInTheMiddleOfAnythingIsSafe()
    {
        constexpr int kRounds = 200;
        std::mt19937  random(kSeed);
        int           busy = 0;
        for (int round = 0; round < kRounds; ++round) {
            const Busy what = kBusy[static_cast<std::size_t>(round) % kBusy.size()];
            Desk       desk(presets()[random() % presets().size()].name, {1000, 700});
            if (what != Busy::Loading) {
                desk.window.open("builtin:cubes", smallView);
                QVERIFY2(QTest::qWaitFor([&] { return desk.session.now().frame != nullptr; }, Desk::kLong),
                         qPrintable(QString("round %1").arg(round)));
            }
            begin(desk, what, static_cast<std::uint32_t>(random()));
            // ms: sometimes at once, sometimes in the middle, sometimes at the end
            const int wait = static_cast<int>(random() % 12);
            if (wait > 2) QTest::qWait(wait - 2);
            busy += isBusy(desk);
            desk.window.close();
            QVERIFY(!desk.window.isVisible());
            if (random() % 2) QCoreApplication::processEvents();
        }
        QVERIFY2(busy > kRounds / 4, qPrintable(QString::number(busy)));  // in the middle, not after it
    }
    void memoryStaysFlatOverTenThousandSteps()
    {
        if (kMemoryIsWatched) QSKIP("the sanitizer keeps freed memory and looks for leaks itself");
        Session session;
        session.setPipeline(findPreset("hzb-octree")->pipeline);
        session.open("builtin:cubes", smallView);
        const auto settles = [&] {
            return QTest::qWaitFor([&] { return session.isIdle() && session.now().busy.isEmpty(); }, Desk::kLong);
        };
        QVERIFY(settles());
        session.setGrain(Grain::Pixel);
        session.goToStep(0);
        QVERIFY(settles());
        const std::uint64_t count = session.position()->count;
        int                 shown = 0;
        connect(&session, &Session::changed, this, [&](Changes what) { shown += what.testFlag(Change::Picture); });
        const auto walk = [&](std::uint64_t steps) {
            for (std::uint64_t i = 0; i < steps; ++i) {
                const std::uint64_t to = i * 7919 % (count - 1);
                session.goToStep(to);
                // No waiting by the clock: every step is shown before the next is asked for.
                while (!session.now().step || session.now().step->state.step.value != to)
                    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
            }
        };
        walk(500);
        const std::uint64_t before = residentBytes();
        walk(10'000);
        const std::uint64_t after = residentBytes();
        QVERIFY(shown >= 10'000);
        // a kept step would be 100 kB
        QVERIFY2(after < before + (4u << 20), qPrintable(QString("%1 -> %2 bytes").arg(before).arg(after)));
    }
};

ZSCOPE_UI_TEST(ClosingTest, "closing_test", Window)
#include "closing_test.moc"
