// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/why/why_model.h"

#include <QCoreApplication>
#include <QFont>

#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {
namespace {

struct WhyWords {
    Q_DECLARE_TR_FUNCTIONS(Why)
};

constexpr quintptr kTop = 0;  // internal id of a top row; of an event: 1 + the row of its triangle

}  // namespace

QString nameOf(PixelFate fate)
{
    switch (fate) {
        case PixelFate::Winner:
            return WhyWords::tr("seen");
        case PixelFate::Overwritten:
            return WhyWords::tr("overwritten");
        case PixelFate::Farther:
            return WhyWords::tr("farther");
        case PixelFate::LostTie:
            return WhyWords::tr("lost a tie");
        case PixelFate::IntervalLost:
            return WhyWords::tr("interval lost");
        case PixelFate::Hole:
            return WhyWords::tr("in a hole");
        case PixelFate::BeyondFar:
            return WhyWords::tr("beyond far");
        case PixelFate::TileRejected:
            return WhyWords::tr("tile rejected");
        case PixelFate::TriangleHidden:
            return WhyWords::tr("hidden");
        case PixelFate::NodeHidden:
            return WhyWords::tr("node hidden");
        case PixelFate::NodeOutside:
            return WhyWords::tr("node outside");
        case PixelFate::NodeSmall:
            return WhyWords::tr("node too small");
        case PixelFate::BatchOutside:
            return WhyWords::tr("outside");
        case PixelFate::BackFace:
            return WhyWords::tr("back face");
        case PixelFate::NearClip:
            return WhyWords::tr("before near");
        case PixelFate::NotFilled:
            return WhyWords::tr("not filled");
        case PixelFate::Blended:
            return WhyWords::tr("blended");
        case PixelFate::BehindOpaque:
            return WhyWords::tr("behind opaque");
    }
    return {};
}

QString nameOf(Happening happening)
{
    switch (happening) {
        case Happening::SetUp:
            return WhyWords::tr("set up");
        case Happening::NodeOutside:
            return WhyWords::tr("its node lies outside");
        case Happening::NodeHidden:
            return WhyWords::tr("its node is hidden");
        case Happening::NodeSmall:
            return WhyWords::tr("its node is too small");
        case Happening::NodeEntered:
            return WhyWords::tr("its node is entered");
        case Happening::NodeRecalled:
            return WhyWords::tr("its node is recalled");
        case Happening::TriangleHidden:
            return WhyWords::tr("hidden by the pyramid");
        case Happening::TrianglePassed:
            return WhyWords::tr("passed the pyramid");
        case Happening::TileRejected:
            return WhyWords::tr("rejected with the tile");
        case Happening::Discarded:
            return WhyWords::tr("in a hole of its material");
        case Happening::Won:
            return WhyWords::tr("won the depth test");
        case Happening::Lost:
            return WhyWords::tr("lost the depth test");
        case Happening::Overtaken:
            return WhyWords::tr("overtaken");
        case Happening::IntervalWon:
            return WhyWords::tr("won the interval");
        case Happening::IntervalLost:
            return WhyWords::tr("lost the interval");
    }
    return {};
}

QString shapeOf(PixelFate fate)
{
    switch (fate) {
        case PixelFate::Winner:
            return QStringLiteral("\u25CF");
        case PixelFate::Blended:
            return QStringLiteral("\u25D0");
        case PixelFate::Overwritten:
            return QStringLiteral("\u25BC");
        case PixelFate::TriangleHidden:
        case PixelFate::NodeHidden:
        case PixelFate::TileRejected:
            return QStringLiteral("\u00D7");
        case PixelFate::NodeOutside:
        case PixelFate::BatchOutside:
        case PixelFate::NearClip:
        case PixelFate::BackFace:
        case PixelFate::NodeSmall:
            return QStringLiteral("\u25CB");
        default:
            return QStringLiteral("\u25BD");
    }
}

const QColor& colourOf(PixelFate fate, const Theme& theme)
{
    switch (fate) {
        case PixelFate::Winner:
            return theme.entered;
        case PixelFate::Blended:
            return theme.picked;
        case PixelFate::TriangleHidden:
        case PixelFate::NodeHidden:
        case PixelFate::TileRejected:
            return theme.hidden;
        case PixelFate::NodeOutside:
        case PixelFate::BatchOutside:
        case PixelFate::NearClip:
        case PixelFate::BackFace:
        case PixelFate::NodeSmall:
            return theme.outside;
        case PixelFate::NotFilled:
            return theme.error;
        default:
            return theme.left;
    }
}

void WhyModel::present(std::shared_ptr<const PixelExplanation> explanation)
{
    beginResetModel();
    m_triangle.reset();
    m_pixel = std::move(explanation);
    endResetModel();
}

void WhyModel::present(std::shared_ptr<const TriangleExplanation> explanation)
{
    beginResetModel();
    m_pixel.reset();
    m_triangle = std::move(explanation);
    endResetModel();
}

void WhyModel::clear()
{
    beginResetModel();
    m_pixel.reset();
    m_triangle.reset();
    endResetModel();
}

void WhyModel::setPalette(const QPalette& palette)
{
    m_palette = palette;
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1), {Qt::ForegroundRole});
}

const PixelCandidate* WhyModel::candidateOf(const QModelIndex& at) const
{
    if (!m_pixel || !at.isValid()) return nullptr;
    const auto row =
        at.internalId() == kTop ? static_cast<std::size_t>(at.row()) : static_cast<std::size_t>(at.internalId() - 1);
    return &m_pixel->candidates[row];
}

const Event* WhyModel::eventOf(const QModelIndex& at) const
{
    if (!at.isValid()) return nullptr;
    if (m_triangle) return &m_triangle->events[static_cast<std::size_t>(at.row())];
    const PixelCandidate& candidate = *candidateOf(at);
    if (at.internalId() != kTop) return &candidate.events[static_cast<std::size_t>(at.row())];
    if (candidate.decisive) return &candidate.events[*candidate.decisive];
    return candidate.events.empty() ? nullptr : &candidate.events.back();
}

std::optional<TriangleId> WhyModel::triangleOf(const QModelIndex& at) const
{
    if (!at.isValid()) return {};
    return m_triangle ? m_triangle->drawnAs : candidateOf(at)->drawnAs;
}

QString WhyModel::sentenceOf(const QModelIndex& at) const
{
    if (!at.isValid()) return {};
    if (m_pixel && at.internalId() == kTop) return said(candidateOf(at)->sentence);
    const Event* event = eventOf(at);
    return event ? said(event->sentence) : QString();
}

QModelIndex WhyModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kTop);
}

QModelIndex WhyModel::parent(const QModelIndex& at) const
{
    if (!at.isValid() || at.internalId() == kTop) return {};
    return createIndex(static_cast<int>(at.internalId()) - 1, 0, kTop);
}

int WhyModel::rowCount(const QModelIndex& parent) const
{
    if (parent.column() > 0) return 0;
    if (!parent.isValid())
        return m_pixel      ? static_cast<int>(m_pixel->candidates.size())
               : m_triangle ? static_cast<int>(m_triangle->events.size())
                            : 0;
    if (m_triangle || parent.internalId() != kTop) return 0;
    return static_cast<int>(candidateOf(parent)->events.size());
}

int WhyModel::columnCount(const QModelIndex&) const { return kColumns; }

QString WhyModel::text(const Event& event, Column column) const
{
    switch (column) {
        case What:
            return nameOf(event.happening);
        case Fate:
            return event.node    ? QString::fromStdString(event.node->path)
                   : event.query ? tr("level %1").arg(event.query->level)
                                 : QString();
        case Depth:
            return event.depth > 0 ? depthText(event.depth) : QString();
        case kColumns:
            break;
    }
    return {};
}

QString WhyModel::text(const PixelCandidate& candidate, Column column) const
{
    switch (column) {
        case What:
            return candidate.drawnAs == candidate.triangle
                       ? grouped(candidate.triangle.value)
                       : tr("%1, face %2").arg(grouped(candidate.triangle.value), grouped(candidate.drawnAs.value));
        case Fate:
            return shapeOf(candidate.fate) + ' ' + nameOf(candidate.fate);
        case Depth:
            return candidate.depth > 0 ? depthText(candidate.depth) : QString();
        case kColumns:
            break;
    }
    return {};
}

QVariant WhyModel::data(const QModelIndex& at, int role) const
{
    if (!checkIndex(at, CheckIndexOption::IndexIsValid)) return {};
    const Theme& theme      = themeOf(m_palette);
    const auto   column     = static_cast<Column>(at.column());
    const bool   isTriangle = m_pixel && at.internalId() == kTop;
    switch (role) {
        case Qt::DisplayRole:
            return isTriangle ? text(*candidateOf(at), column) : text(*eventOf(at), column);
        case Qt::ToolTipRole:
            return sentenceOf(at);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(
                Qt::Alignment((column == Depth ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
        case Qt::ForegroundRole:
            if (isTriangle && column == Fate) return colourOf(candidateOf(at)->fate, theme);
            return isTriangle ? theme.text : theme.softText;
        case Qt::FontRole: {
            if (!isTriangle || candidateOf(at)->fate != PixelFate::Winner) return {};
            QFont bold;
            bold.setBold(true);
            return bold;
        }
        default:
            return {};
    }
}

QVariant WhyModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) return {};
    const auto column = static_cast<Column>(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment((column == Depth ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    if (role != Qt::DisplayRole) return {};
    switch (column) {
        case What:
            return m_triangle ? tr("what happened") : tr("triangle");
        case Fate:
            return m_triangle ? tr("where") : tr("fate");
        case Depth:
            return tr("depth D");
        case kColumns:
            break;
    }
    return {};
}

}  // namespace zscope::ui
