// SPDX-License-Identifier: GPL-3.0-or-later
// The track of the timeline: all steps from left to right in the bands of
// their stages, what is done filled, a handle at "now", a flag for each bookmark, a tick where the picked pixel
// changes. A slider for the keyboard and for screen readers; runs longer than its range are scaled.
#pragma once

#include <cstdint>
#include <vector>

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

/// What stands on the track beside the handle.
struct TrackMarks {
    struct Named {
        QString       name;
        std::uint64_t step = 0;

        friend bool operator==(const Named&, const Named&) = default;
    };
    std::vector<Named>         stages;  // each with its first step, in order
    std::vector<Named>         bookmarks;
    std::vector<std::uint64_t> changes;  // of the picked pixel

    friend bool operator==(const TrackMarks&, const TrackMarks&) = default;
};

class StepTrack final : public QAbstractSlider {
    Q_OBJECT

public:
    explicit StepTrack(QWidget* parent = nullptr);

    /// Does not emit stepChosen().
    void present(std::uint64_t step, std::uint64_t count);

    void              showMarks(const TrackMarks& marks);
    const TrackMarks& marks() const { return m_marks; }
    /// Where a step's handle stands, from the left edge.
    double placeOf(std::uint64_t step) const;

    QSize sizeHint() const override { return {400, 28}; }
    QSize minimumSizeHint() const override { return {160, 28}; }

signals:
    void stepChosen(std::uint64_t step);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

private:
    int  positionAt(double x) const;
    void paintStages(QPainter& painter, const QRectF& track) const;

    TrackScale m_scale;
    TrackMarks m_marks;
    bool       m_presenting = false;
};

}  // namespace zscope::ui
