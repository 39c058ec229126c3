// SPDX-License-Identifier: GPL-3.0-or-later
// One cause: its name, the share of the wrong pixels that it explains as a bar, and whether A draws with it. A switch.
#pragma once

#include <QAbstractButton>

namespace zscope::ui {

class CauseRow final : public QAbstractButton {
    Q_OBJECT

public:
    explicit CauseRow(QWidget* parent = nullptr);

    /// `share` in [0, 1].
    void present(const QString& title, double share, bool isOn);

    bool  hasHeightForWidth() const override { return true; }
    int   heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect   titleIn(int width) const;
    QString shareText() const;

    double m_share = 0;
};

}  // namespace zscope::ui
