// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/command_palette.h"

#include <algorithm>
#include <numeric>

#include <QAction>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/theme/theme.h"
#include "ui/window/actions.h"
#include "ui/window/fuzzy.h"

namespace zscope::ui {
namespace {

constexpr int kKeysRole = Qt::UserRole, kPossibleRole = Qt::UserRole + 1, kMenuRole = Qt::UserRole + 2;

QString keysOf(const QAction& action)
{
    return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText);
}

/// The name to the left and its menu beside it, the keys to the right.
class CommandDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const Theme& theme = themeOf(option.palette);
        if (option.state & QStyle::State_Selected) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(theme.pickedTint);
            painter->drawRoundedRect(option.rect.adjusted(2, 1, -2, -1), 4, 4);
        }
        const QRect   inside = option.rect.adjusted(kStep + 2, 0, -kStep - 2, 0);
        const QString name = index.data().toString(), keys = index.data(kKeysRole).toString();
        painter->setPen(index.data(kPossibleRole).toBool() ? theme.text : theme.softText);
        painter->drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, name);
        painter->setPen(theme.softText);
        painter->drawText(inside, Qt::AlignRight | Qt::AlignVCenter, keys);
        const QFontMetrics& letters = option.fontMetrics;
        const QRect         between = inside.adjusted(letters.horizontalAdvance(name) + 2 * kStep, 0,
                                                      -letters.horizontalAdvance(keys) - kStep, 0);
        if (between.width() <= 0) return;
        const QString menu = letters.elidedText(index.data(kMenuRole).toString(), Qt::ElideRight, between.width());
        painter->drawText(between, Qt::AlignLeft | Qt::AlignVCenter, menu);
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override
    {
        return {200, option.fontMetrics.height() + kStep};
    }
};

}  // namespace

CommandModel::CommandModel(std::vector<QAction*> commands, QObject* parent)
    : QAbstractListModel(parent), m_commands(commands.begin(), commands.end())
{
    filter({});
}

void CommandModel::filter(const QString& query)
{
    std::vector<std::pair<int, std::size_t>> scored;
    for (std::size_t i = 0; i < m_commands.size(); ++i) {
        if (!m_commands[i] || !isListed(*m_commands[i])) continue;
        const auto label = fuzzyScore(query, plainName(*m_commands[i]));
        const auto name  = fuzzyScore(query, m_commands[i]->objectName());
        if (label || name) scored.emplace_back(std::max(label.value_or(-1'000'000), name.value_or(-1'000'000)), i);
    }
    std::ranges::stable_sort(scored, std::greater(), &std::pair<int, std::size_t>::first);
    beginResetModel();
    m_shown.clear();
    for (const auto& [score, i] : scored) m_shown.push_back(i);
    endResetModel();
}

QAction* CommandModel::at(int row) const
{
    if (row < 0 || row >= rowCount()) return nullptr;
    return m_commands[m_shown[static_cast<std::size_t>(row)]];
}

int CommandModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

QVariant CommandModel::data(const QModelIndex& index, int role) const
{
    const QAction* action = index.isValid() ? at(index.row()) : nullptr;
    if (!action) return {};
    switch (role) {
        case Qt::DisplayRole:
            return plainName(*action);
        case kKeysRole:
            return keysOf(*action);
        case kPossibleRole:
            return action->isEnabled();
        case kMenuRole:
            return menuNameOf(*action);
        case Qt::AccessibleTextRole: {
            const QString name = plainName(*action) + ' ' + menuNameOf(*action);
            return action->isEnabled() ? name + ' ' + keysOf(*action) : tr("%1, not possible now").arg(name);
        }
        default:
            return {};
    }
}

CommandPalette::CommandPalette(std::vector<QAction*> commands, QWidget* parent)
    : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint), m_model(new CommandModel(std::move(commands), this)),
      m_query(new QLineEdit), m_list(new QListView)
{
    setObjectName("commandPalette");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Commands"));
    m_query->setPlaceholderText(tr("Type a few letters of a command"));
    m_query->setAccessibleName(tr("Letters of a command"));
    m_list->setModel(m_model);
    m_list->setItemDelegate(new CommandDelegate(m_list));
    m_list->setAccessibleName(tr("Commands"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setFocusPolicy(Qt::NoFocus);  // the letters go to the query, the arrows come here
    m_list->setUniformItemSizes(true);
    m_query->installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kStep, kStep, kStep, kStep);
    layout->setSpacing(kStep);
    layout->addWidget(m_query);
    layout->addWidget(m_list);
    resize(std::min(560, parent->width() - 4 * kStep), std::min(440, parent->height() - 8 * kStep));
    move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, 8 * kStep)));

    connect(m_query, &QLineEdit::textChanged, this, [this](const QString& query) {
        m_model->filter(query);
        m_list->setCurrentIndex(m_model->index(0));
    });
    connect(m_list, &QListView::clicked, this, [this] { run(); });
    m_list->setCurrentIndex(m_model->index(0));
    m_query->setFocus();
}

void CommandPalette::run()
{
    const QPointer<QAction> action = m_model->at(m_list->currentIndex().row());
    if (!action || !action->isEnabled()) return;
    close();
    // Once this window is gone: the command may open one of its own.
    QTimer::singleShot(0, action, [action] { action->trigger(); });
}

bool CommandPalette::eventFilter(QObject* object, QEvent* event)
{
    if (object != m_query || event->type() != QEvent::KeyPress) return QDialog::eventFilter(object, event);
    const auto move = [this](int by) {
        const int row = std::clamp(m_list->currentIndex().row() + by, 0, std::max(0, m_model->rowCount() - 1));
        m_list->setCurrentIndex(m_model->index(row));
        return true;
    };
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Down:
            return move(1);
        case Qt::Key_Up:
            return move(-1);
        case Qt::Key_PageDown:
            return move(10);
        case Qt::Key_PageUp:
            return move(-10);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            run();
            return true;
        default:
            return QDialog::eventFilter(object, event);
    }
}

}  // namespace zscope::ui
