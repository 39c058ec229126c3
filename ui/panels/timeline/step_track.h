// SPDX-License-Identifier: GPL-3.0-or-later
// The track of the timeline: all steps from left to right, what is done filled, a handle at "now". A slider for the
// keyboard and for screen readers; runs longer than its range are scaled.
#pragma once

#include <cstdint>

#include <QAbstractSlider>

namespace zscope::ui {

/// Between steps and slider positions, which are limited to 32 bits.
struct TrackScale {
    static constexpr int kMost = 1'000'000'000;

    std::uint64_t count = 1;  // > 0

    int           maximum() const;
    int           positionOf(std::uint64_t step) const;
    std::uint64_t stepOf(int position) const;
};

class StepTrack final : public QAbstractSlider {
    Q_OBJECT

public:
    explicit StepTrack(QWidget* parent = nullptr);

    /// Does not emit stepChosen().
    void present(std::uint64_t step, std::uint64_t count);

    QSize sizeHint() const override { return {400, 22}; }
    QSize minimumSizeHint() const override { return {160, 22}; }

signals:
    void stepChosen(std::uint64_t step);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

private:
    int positionAt(double x) const;

    TrackScale m_scale;
    bool       m_presenting = false;
};

}  // namespace zscope::ui
