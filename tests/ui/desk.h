// SPDX-License-Identifier: GPL-3.0-or-later
// A window with a session, as a person has it in front of him, for tests that click and type.
#pragma once

#include <QApplication>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "ui/session/session.h"
#include "ui/view/frame_view.h"
#include "ui/window/dock.h"
#include "ui/window/main_window.h"

namespace zscope::ui {

struct Desk {
    static constexpr int kLong = 60'000;  // ms; a machine under load

    QTemporaryDir folder;
    Settings      settings{folder.filePath("settings.ini")};
    Session       session;
    MainWindow    window{session, settings, QApplication::palette()};

    explicit Desk(std::string_view algorithm = "scanline", const QSize& size = {1280, 800})
    {
        session.setPipeline(findPreset(algorithm)->pipeline);
        window.resize(size);
        window.show();
    }
    bool settles()
    {
        return QTest::qWaitFor([&] { return session.isIdle() && session.now().busy.isEmpty(); }, kLong);
    }
    bool open(const QString& word, const QSize& picture = {320, 180})
    {
        window.open(word, [picture](const Scene& scene) {
            ViewRequest view = scene.views.empty() ? ViewRequest{} : scene.views.front().view;
            view.width       = picture.width();
            view.height      = picture.height();
            return view;
        });
        return settles() && session.now().step;
    }
    /// To a step of a grain; -1 is the last.
    bool goTo(Grain grain, std::int64_t step)
    {
        session.setGrain(grain);
        if (step < 0)
            session.goToEnd();
        else
            session.goToStep(static_cast<std::uint64_t>(step));
        return settles() && session.now().step && session.now().step->state.grain == grain;
    }
    void press(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&window, static_cast<Qt::Key>(key), modifiers);
    }

    /// A picture of the window for whoever looks at it, if ZSCOPE_PICTURES names a folder.
    void photograph(const QString& name)
    {
        const QString where = qEnvironmentVariable("ZSCOPE_PICTURES");
        if (where.isEmpty()) return;
        QTest::qWait(200);
        window.grab().save(QDir(where).filePath(name + ".png"));
    }
};

}  // namespace zscope::ui
