// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/faults/faults_model.h"

#include <QFont>

#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {

FaultsModel::FaultsModel(QObject* parent) : QAbstractTableModel(parent), m_pictures(faults().size()) {}

void FaultsModel::forget()
{
    for (auto& picture : m_pictures) picture.reset();
    emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

void FaultsModel::add(FaultPicture picture)
{
    for (std::size_t row = 0; row < faults().size(); ++row) {
        if (faults()[row].fault != picture.fault) continue;
        m_pictures[row] = std::move(picture);
        emit dataChanged(index(static_cast<int>(row), 0), index(static_cast<int>(row), kColumns - 1));
        return;
    }
}

void FaultsModel::setChosen(const FaultSet& faults)
{
    if (faults == m_chosen) return;
    m_chosen = faults;
    emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

const FaultPicture* FaultsModel::pictureOf(int row) const
{
    if (row < 0 || row >= rowCount() || !m_pictures[static_cast<std::size_t>(row)]) return nullptr;
    return &*m_pictures[static_cast<std::size_t>(row)];
}

int FaultsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_pictures.size());
}

int FaultsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant FaultsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) return {};
    const FaultEntry&   entry    = faults()[static_cast<std::size_t>(index.row())];
    const FaultPicture* picture  = pictureOf(index.row());
    const bool          isChosen = m_chosen.has(entry.fault);
    switch (role) {
        case Qt::DisplayRole:
            if (index.column() == Title) return (isChosen ? QStringLiteral("\u2716 ") : QString()) + said(entry.title);
            return picture ? grouped(picture->wrongPixels) : QStringLiteral("\u2013");
        case Qt::ToolTipRole:
            return said(entry.cause);
        case Qt::TextAlignmentRole:
            return QVariant(index.column() == Wrong ? Qt::AlignRight | Qt::AlignVCenter
                                                    : Qt::AlignLeft | Qt::AlignVCenter);
        case Qt::FontRole:
            if (isChosen) {
                QFont bold;
                bold.setBold(true);
                return bold;
            }
            return {};
        default:
            return {};
    }
}

QVariant FaultsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant(section == Wrong ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    return section == Title ? tr("fault") : tr("wrong pixels");
}

}  // namespace zscope::ui
