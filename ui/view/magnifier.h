// SPDX-License-Identifier: GPL-3.0-or-later
// The card in the corner of the frame view: the surroundings of one pixel, large, and what can be said of it.
#pragma once

#include <QFrame>
#include <QImage>

#include "ui/session/snapshot.h"

namespace zscope::ui {

class Magnifier final : public QFrame {
    Q_OBJECT

public:
    explicit Magnifier(QWidget* parent = nullptr);

    /// `picture` is the picture on show. Hides itself when there is nothing to say.
    /// `whose` picture it is, where two of them are in view; else empty.
    void present(const Snapshot& shown, const QImage& picture, const std::optional<QPoint>& pixel,
                 const QString& whose);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    static constexpr int kAcross = 15;  // pixels in each direction, odd: one is in the middle

    struct Fact {
        QString name, value;
    };

    QImage            m_around;  // kAcross x kAcross
    std::vector<Fact> m_facts;
    bool              m_isPick = false;
};

}  // namespace zscope::ui
