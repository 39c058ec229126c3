// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the bottom: what drew the picture, how long it took, what it shows, and the pixel under the cursor.
#pragma once

#include <optional>

#include <QPoint>
#include <QStatusBar>
#include <QTimer>

#include "ui/session/session.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace zscope::ui {

class StatusLine final : public QStatusBar {
    Q_OBJECT

public:
    explicit StatusLine(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what);
    void hover(const std::optional<QPoint>& pixel);

private:
    void showPixel(const Snapshot& shown);
    void showBusy(const Snapshot& shown);

    Session&              m_session;
    std::optional<QPoint> m_hovered;
    QLabel *              m_algorithm, *m_time, *m_exact, *m_triangles, *m_pixel, *m_machine, *m_work;
    QProgressBar*         m_progress;
    QToolButton*          m_cancel;
    QTimer                m_patience;  // short work is not worth a word
};

/// "x 980  y 478  triangle 8,841  D 0.1187  z 0.247".
QString pixelText(const Snapshot& shown, const std::optional<QPoint>& pixel);

}  // namespace zscope::ui
