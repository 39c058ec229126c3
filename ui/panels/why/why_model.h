// SPDX-License-Identifier: GPL-3.0-or-later
// Why a pixel shows what it shows, as a tree of two levels: the triangles that cover it, and what happened to each.
//
// Links      every row has a moment of the run that it can jump to, and a node or level that belongs to it
#pragma once

#include <memory>
#include <vector>

#include <QAbstractItemModel>
#include <QPalette>

#include "core/lesson/explanation.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

class WhyModel final : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { What, Fate, Depth, kColumns };

    explicit WhyModel(QObject* parent = nullptr) : QAbstractItemModel(parent) {}

    void present(std::shared_ptr<const PixelExplanation> explanation);
    /// Of a single triangle: its events are the rows.
    void present(std::shared_ptr<const TriangleExplanation> explanation);
    void clear();
    void setPalette(const QPalette& palette);

    /// The event of a row: its own, or the one that decided about the triangle; nullptr if there is none.
    const Event* eventOf(const QModelIndex& index) const;
    /// The triangle that a row is about.
    std::optional<TriangleId> triangleOf(const QModelIndex& index) const;
    QString                   sentenceOf(const QModelIndex& index) const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int         rowCount(const QModelIndex& parent = {}) const override;
    int         columnCount(const QModelIndex& parent = {}) const override;
    QVariant    data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant    headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const PixelCandidate* candidateOf(const QModelIndex& index) const;  // of a triangle's row
    QString               text(const Event& event, Column column) const;
    QString               text(const PixelCandidate& candidate, Column column) const;

    std::shared_ptr<const PixelExplanation>    m_pixel;
    std::shared_ptr<const TriangleExplanation> m_triangle;
    QPalette                                   m_palette;
};

QString       nameOf(const PixelFate& fate);  // translated
QString       nameOfEvent(std::string_view word);
QString       shapeOf(const PixelFate& fate);
const QColor& colourOf(const PixelFate& fate, const Theme& theme);

}  // namespace zscope::ui
