// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/why/why_model.h"

#include <algorithm>
#include <array>

#include <QCoreApplication>
#include <QFont>

#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {
namespace {

constexpr quintptr kTop = 0;  // internal id of a top row; of an event: 1 + the row of its triangle

/// What the window calls the words of core; a word that is not here is shown as it is.
struct Name {
    std::string_view word;
    const char*      name;
};
constexpr std::array kFateNames{
    Name{"winner", QT_TRANSLATE_NOOP("Why", "seen")},
    Name{"overwritten", QT_TRANSLATE_NOOP("Why", "overwritten")},
    Name{"farther", QT_TRANSLATE_NOOP("Why", "farther")},
    Name{"lost-tie", QT_TRANSLATE_NOOP("Why", "lost a tie")},
    Name{"interval-lost", QT_TRANSLATE_NOOP("Why", "interval lost")},
    Name{"hole", QT_TRANSLATE_NOOP("Why", "in a hole")},
    Name{"beyond-far", QT_TRANSLATE_NOOP("Why", "beyond far")},
    Name{"tile-rejected", QT_TRANSLATE_NOOP("Why", "tile rejected")},
    Name{"triangle-hidden", QT_TRANSLATE_NOOP("Why", "hidden")},
    Name{"node-hidden", QT_TRANSLATE_NOOP("Why", "node hidden")},
    Name{"node-outside", QT_TRANSLATE_NOOP("Why", "node outside")},
    Name{"node-small", QT_TRANSLATE_NOOP("Why", "node too small")},
    Name{"batch-outside", QT_TRANSLATE_NOOP("Why", "outside")},
    Name{"back-face", QT_TRANSLATE_NOOP("Why", "back face")},
    Name{"near-clip", QT_TRANSLATE_NOOP("Why", "before near")},
    Name{"not-filled", QT_TRANSLATE_NOOP("Why", "not filled")},
    Name{"blended", QT_TRANSLATE_NOOP("Why", "blended")},
    Name{"behind-opaque", QT_TRANSLATE_NOOP("Why", "behind opaque")},
};
constexpr std::array kEventNames{
    Name{"set-up", QT_TRANSLATE_NOOP("Why", "set up")},
    Name{"node-outside", QT_TRANSLATE_NOOP("Why", "its node lies outside")},
    Name{"node-hidden", QT_TRANSLATE_NOOP("Why", "its node is hidden")},
    Name{"node-small", QT_TRANSLATE_NOOP("Why", "its node is too small")},
    Name{"node-entered", QT_TRANSLATE_NOOP("Why", "its node is entered")},
    Name{"node-recalled", QT_TRANSLATE_NOOP("Why", "its node is recalled")},
    Name{"triangle-hidden", QT_TRANSLATE_NOOP("Why", "hidden by the pyramid")},
    Name{"triangle-passed", QT_TRANSLATE_NOOP("Why", "passed the pyramid")},
    Name{"tile-rejected", QT_TRANSLATE_NOOP("Why", "rejected with the tile")},
    Name{"discarded", QT_TRANSLATE_NOOP("Why", "in a hole of its material")},
    Name{"won", QT_TRANSLATE_NOOP("Why", "won the depth test")},
    Name{"lost", QT_TRANSLATE_NOOP("Why", "lost the depth test")},
    Name{"overtaken", QT_TRANSLATE_NOOP("Why", "overtaken")},
    Name{"interval-won", QT_TRANSLATE_NOOP("Why", "won the interval")},
    Name{"interval-lost", QT_TRANSLATE_NOOP("Why", "lost the interval")},
};

template <class Names>
QString named(const Names& names, std::string_view word)
{
    const auto found = std::ranges::find(names, word, &Name::word);
    return found == names.end() ? QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()))
                                : QCoreApplication::translate("Why", found->name);
}

}  // namespace

QString nameOf(const PixelFate& fate) { return named(kFateNames, fate.word); }
QString nameOfEvent(std::string_view word) { return named(kEventNames, word); }

QString shapeOf(const PixelFate& fate)
{
    switch (fate.kind) {
        case FateKind::Seen:
            return QStringLiteral("\u25CF");
        case FateKind::Blended:
            return QStringLiteral("\u25D0");
        case FateKind::Overtaken:
            return QStringLiteral("\u25BC");
        case FateKind::Hidden:
            return QStringLiteral("\u00D7");
        case FateKind::LeftOut:
            return QStringLiteral("\u25CB");
        default:
            return QStringLiteral("\u25BD");
    }
}

const QColor& colourOf(const PixelFate& fate, const Theme& theme)
{
    switch (fate.kind) {
        case FateKind::Seen:
            return theme.entered;
        case FateKind::Blended:
            return theme.picked;
        case FateKind::Hidden:
            return theme.hidden;
        case FateKind::LeftOut:
            return theme.outside;
        case FateKind::NotFilled:
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
            return nameOfEvent(event.word);
        case Fate:
            return event.node    ? QString::fromStdString(event.node->path)
                   : event.level ? tr("level %1").arg(*event.level)
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
            if (!isTriangle || candidateOf(at)->fate != fates::kWinner) return {};
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
