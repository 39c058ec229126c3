// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/hierarchy/node_model.h"

#include <QFontDatabase>

#include "ui/text/numbers.h"
#include "ui/theme/verdicts.h"

namespace zscope::ui {

std::vector<std::array<std::size_t, 6>> countsByDepth(const std::vector<NodeRow>& nodes)
{
    std::vector<std::array<std::size_t, 6>> counts;
    for (const NodeRow& node : nodes) {
        const auto depth = static_cast<std::size_t>(node.depth);
        if (counts.size() <= depth) counts.resize(depth + 1);
        ++counts[depth][static_cast<std::size_t>(node.verdict)];
    }
    return counts;
}

void NodeModel::present(const Snapshot& shown)
{
    beginResetModel();
    const ShownStep* step = shown.stepOfPicture();
    const bool       has  = step && step->state.hierarchy && !step->state.hierarchy->nodes.empty();
    m_step                = has ? shown.step : nullptr;
    m_scene               = shown.scene;
    m_nodes               = has ? &m_step->state.hierarchy->nodes : nullptr;
    m_now                 = has && shown.showsStep ? m_step->state.hierarchy->now : -1;
    m_children.assign(has ? m_nodes->size() : 0, {});
    m_place.assign(has ? m_nodes->size() : 0, 0);
    m_roots.clear();
    for (int id = 0; id < count(); ++id) {
        const int         parent              = row(id).parent;
        std::vector<int>& siblings            = parent < 0 ? m_roots : m_children[static_cast<std::size_t>(parent)];
        m_place[static_cast<std::size_t>(id)] = static_cast<int>(siblings.size());
        siblings.push_back(id);
    }
    endResetModel();
}

void NodeModel::setPalette(const QPalette& palette)
{
    m_palette = palette;
    if (!isEmpty())
        emit dataChanged(indexOf(m_roots.front()), indexOf(m_roots.back(), kColumns - 1),
                         {Qt::ForegroundRole, Qt::BackgroundRole});
}

QModelIndex NodeModel::indexOf(int id, int column) const
{
    if (id < 0 || id >= count()) return {};
    return createIndex(m_place[static_cast<std::size_t>(id)], column, static_cast<quintptr>(id));
}

QModelIndex NodeModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, static_cast<quintptr>(childrenOf(idOf(parent))[static_cast<std::size_t>(row)]));
}

QModelIndex NodeModel::parent(const QModelIndex& index) const
{
    return index.isValid() ? indexOf(row(idOf(index)).parent) : QModelIndex();
}

int NodeModel::rowCount(const QModelIndex& parent) const
{
    if (isEmpty() || parent.column() > 0) return 0;
    return static_cast<int>(childrenOf(idOf(parent)).size());
}

int NodeModel::columnCount(const QModelIndex&) const { return kColumns; }

QString NodeModel::text(const NodeRow& node, Column column) const
{
    switch (column) {
        case Node: {
            const QString path = QString::fromStdString(node.path);
            return node.instance && node.path == "0" ? tr("%1  instance %2").arg(path, grouped(node.instance->value))
                                                     : path;
        }
        case Verdict:
            return shapeOf(node.verdict) + QStringLiteral(" ") + nameOf(node.verdict);
        case Screen:
        case Nearest: {
            const NodeOnScreen at = onScreen(node, m_scene->scene(), m_step->camera);
            if (at.crossesNear) return column == Screen ? tr("around the eye") : QString();
            if (column == Screen) return grouped(static_cast<std::uint64_t>(at.pixels));
            return at.pixels > 0 ? decimal(static_cast<double>(at.nearest), 4) : QString();
        }
        case kColumns:
            break;
    }
    return {};
}

QVariant NodeModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const NodeRow& node   = row(idOf(index));
    const auto     column = static_cast<Column>(index.column());
    const Theme&   theme  = themeOf(m_palette);
    switch (role) {
        case Qt::DisplayRole:
            return text(node, column);
        case Qt::ToolTipRole: {
            QString told = tr("Node %1, depth %2: %3")
                               .arg(QString::fromStdString(node.path))
                               .arg(node.depth)
                               .arg(nameOf(node.verdict));
            if (node.instance) told += tr(", in the tree of instance %1").arg(grouped(node.instance->value));
            if (m_step->state.hierarchy->tree) {
                const std::uint64_t below = itemsBelow(node, *m_scene->prepared, *m_step->state.hierarchy->tree);
                told += '\n'
                        + (node.instance ? tr("%1 triangles below").arg(grouped(below))
                                         : tr("%1 instances below").arg(grouped(below)));
            }
            return told;
        }
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::Alignment(
                (column == Screen || column == Nearest ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
        case Qt::BackgroundRole:
            return node.id == m_now ? QVariant(theme.nowTint) : QVariant();
        case Qt::ForegroundRole:
            return column == Verdict ? colourOf(node.verdict, theme) : column == Node ? theme.text : theme.softText;
        default:
            return {};
    }
}

QVariant NodeModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) return {};
    const auto column = static_cast<Column>(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment((column == Screen || column == Nearest ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    if (role == Qt::ToolTipRole) {
        switch (column) {
            case Node:
                return tr("The slots taken from the root of its tree; from 8 on they straddle the planes of division");
            case Verdict:
                return tr("What became of it so far");
            case Screen:
                return tr("Pixels of the rectangle that its box could touch");
            case Nearest:
                return tr("No depth inside its box is larger, that is nearer");
            case kColumns:
                return {};
        }
    }
    if (role != Qt::DisplayRole) return {};
    switch (column) {
        case Node:
            return tr("node");
        case Verdict:
            return tr("verdict");
        case Screen:
            return tr("screen px");
        case Nearest:
            return tr("nearest D");
        case kColumns:
            break;
    }
    return {};
}

NodeFilter::NodeFilter(NodeModel& model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model)
{
    setSourceModel(&model);
    setRecursiveFilteringEnabled(true);
}

void NodeFilter::setText(const QString& text)
{
    m_text = text.trimmed();
    invalidateFilter();
}

void NodeFilter::setVerdicts(const VerdictSet& verdicts)
{
    m_verdicts = verdicts;
    invalidateFilter();
}

bool NodeFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    const NodeRow& node = m_model.row(m_model.idOf(m_model.index(row, 0, parent)));
    if (!m_verdicts[static_cast<std::size_t>(node.verdict)]) return false;
    if (m_text.isEmpty()) return true;
    return QString::fromStdString(node.path).contains(m_text)
           || (node.instance && QString::number(node.instance->value) == m_text);
}

}  // namespace zscope::ui
