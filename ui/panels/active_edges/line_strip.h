// SPDX-License-Identifier: GPL-3.0-or-later
// One line of the picture as two strips: above, every span that was offered to the line's depth test, in lanes; below,
// which polygon owns each pixel now. stripOf() decides what goes where and is tested without the widget.
//
// Range      the pixels between the outermost active edges, so that a small object fills the strip
#pragma once

#include <vector>

#include <QWidget>

#include "ui/session/snapshot.h"

namespace zscope::ui {

/// A run of pixels [x0, x1) of one polygon.
struct StripRun {
    int           x0 = 0, x1 = 0;
    std::uint32_t polygon = 0;
    int           lane    = 0;      // offered spans: 0 is the lowest
    bool          isNow   = false;  // the span of this step

    friend bool operator==(const StripRun&, const StripRun&) = default;
};

struct LineStripContents {
    static constexpr int kLanes = 4;

    int                   x0 = 0, x1 = 0;  // what the strip's width stands for; equal: nothing to show
    std::vector<StripRun> offered;         // no two of a lane overlap, unless more than kLanes do
    std::vector<StripRun> owners;          // from left to right
    int                   lanes = 0;       // in use
};
LineStripContents stripOf(const StepState& state);

class LineStrip final : public QWidget {
    Q_OBJECT

public:
    explicit LineStrip(QWidget* parent = nullptr);

    void  present(const Snapshot& shown);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

signals:
    /// The pixel of the line that was clicked.
    void picked(int x);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    double             toView(double x) const;
    std::optional<int> pixelAt(double view) const;

    LineStripContents         m_contents;
    std::optional<TriangleId> m_picked;
};

}  // namespace zscope::ui
