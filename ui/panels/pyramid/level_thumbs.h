// SPDX-License-Identifier: GPL-3.0-or-later
// All levels of the pyramid side by side; the one on show is framed. Arrow keys and clicks choose another.
#pragma once

#include <vector>

#include <QWidget>

#include "ui/session/snapshot.h"

namespace zscope::ui {

/// Where the thumbnails lie: rows of equal cells, as few rows as keep them readable.
struct ThumbLayout {
    int   columns = 0, rows = 0;
    QSize cell;  // of one thumbnail, without the gap

    QRect placeOf(int index, int gap) const;
};
ThumbLayout thumbLayout(int count, int width, QSize picture, int gap);

class LevelThumbs final : public QWidget {
    Q_OBJECT

public:
    explicit LevelThumbs(QWidget* parent = nullptr);

    void present(const Snapshot& shown);

signals:
    void chosen(int level);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    int  levelAt(const QPoint& place) const;  // -1: none
    int  heightFor(int width) const;
    void makeThumbs();

    std::shared_ptr<const ShownStep> m_step;  // nothing: there are no levels
    std::vector<QImage>              m_thumbs;
    int                              m_current = -1;
};

}  // namespace zscope::ui
