// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/player.h"

#include <algorithm>
#include <cmath>

#include "ui/session/session.h"

namespace zscope::ui {

int Pace::due(double ms)
{
    owed += perSecond * ms / 1000;
    const double whole = std::floor(owed);
    owed -= whole;
    return static_cast<int>(std::min(whole, 1e9));
}

Player::Player(Session& session, QObject* parent) : QObject(parent), m_session(session)
{
    m_tick.setInterval(16);
    m_tick.setTimerType(Qt::PreciseTimer);
    connect(&m_tick, &QTimer::timeout, this, &Player::moveOn);
}

void Player::setPlaying(bool playing)
{
    if (playing == isPlaying() || (playing && !m_session.now().scene)) return;
    if (playing) {
        const auto at = m_session.position();
        if (at && at->step + 1 >= at->count) m_session.goToStart();
        m_pace.owed = 0;
        m_sinceTick.start();
        m_tick.start();
    } else {
        m_tick.stop();
    }
    emit playingChanged(playing);
}

void Player::moveOn()
{
    if (!m_session.isIdle()) return;  // the last step is not shown yet
    const int due = m_pace.due(static_cast<double>(m_sinceTick.restart()));
    if (due > 0) m_session.stepBy(due);
    const auto at = m_session.position();
    if (at && at->step + 1 >= at->count) setPlaying(false);
}

}  // namespace zscope::ui
