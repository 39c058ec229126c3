// SPDX-License-Identifier: GPL-3.0-or-later
// Plays the steps at a chosen speed. It waits for each step to be shown: a slow machine plays slower or in larger
// strides, and never queues.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace zscope::ui {

class Session;

/// How many whole steps are due after `ms` at `perSecond`, keeping the rest for the next time.
struct Pace {
    double perSecond = 10;
    double owed      = 0;  // steps, below 1

    int due(double ms);
};

class Player final : public QObject {
    Q_OBJECT

public:
    explicit Player(Session& session, QObject* parent = nullptr);

    bool   isPlaying() const { return m_tick.isActive(); }
    double speed() const { return m_pace.perSecond; }
    void   setSpeed(double stepsPerSecond) { m_pace.perSecond = stepsPerSecond; }
    /// At the end it starts from the beginning.
    void setPlaying(bool playing);

signals:
    void playingChanged(bool playing);

private:
    void moveOn();

    Session&      m_session;
    QTimer        m_tick;
    QElapsedTimer m_sinceTick;
    Pace          m_pace;
};

}  // namespace zscope::ui
