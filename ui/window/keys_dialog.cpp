// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/keys_dialog.h"

#include <algorithm>
#include <iterator>

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/theme/theme.h"
#include "ui/window/actions.h"
#include "ui/window/key_bindings.h"

namespace zscope::ui {
namespace {

QString textOf(const QList<QKeySequence>& keys) { return QKeySequence::listToString(keys, QKeySequence::NativeText); }

}  // namespace

KeysModel::KeysModel(KeyBindings& bindings, QObject* parent) : QAbstractTableModel(parent), m_bindings(bindings)
{
    std::ranges::copy_if(bindings.commands(), std::back_inserter(m_commands),
                         [](const QAction* command) { return isListed(*command); });
}

void KeysModel::refresh() { emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1)); }

QAction* KeysModel::at(int row) const
{
    return row < 0 || row >= rowCount() ? nullptr : m_commands[static_cast<std::size_t>(row)];
}

int KeysModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_commands.size());
}

int KeysModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant KeysModel::data(const QModelIndex& index, int role) const
{
    const QAction* command = index.isValid() ? at(index.row()) : nullptr;
    if (!command) return {};
    if (role == Qt::FontRole && index.column() == Keys && m_bindings.isChanged(*command)) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case Command:
            return plainName(*command);
        case Keys:
            return textOf(command->shortcuts());
        case Default:
            return m_bindings.isChanged(*command) ? textOf(m_bindings.defaultsOf(*command)) : QString();
    }
    return {};
}

QVariant KeysModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == Command ? tr("command") : section == Keys ? tr("keys") : tr("default, where it was changed");
}

KeysDialog::KeysDialog(KeyBindings& bindings, QWidget* parent)
    : QDialog(parent), m_bindings(bindings), m_model(new KeysModel(bindings, this)),
      m_found(new QSortFilterProxyModel(this)), m_filter(new QLineEdit), m_table(new QTableView),
      m_keys(new QKeySequenceEdit), m_conflict(new QLabel), m_assign(new QPushButton(tr("Assign"))),
      m_none(new QPushButton(tr("No key"))), m_default(new QPushButton(tr("Default"))),
      m_all(new QPushButton(tr("Reset all keys")))
{
    setObjectName("keysDialog");
    setWindowTitle(tr("Change keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_found->setSourceModel(m_model);
    m_found->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_found->setFilterKeyColumn(-1);
    m_filter->setPlaceholderText(tr("Find a command or a key"));
    m_filter->setAccessibleName(tr("Find a command or a key"));
    m_filter->setClearButtonEnabled(true);
    m_table->setModel(m_found);
    m_table->setAccessibleName(tr("Commands and their keys"));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(24);
    m_table->horizontalHeader()->setSectionResizeMode(KeysModel::Command, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(KeysModel::Keys, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(KeysModel::Default, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_keys->setAccessibleName(tr("New key for the chosen command"));
    m_conflict->setWordWrap(true);
    m_conflict->setAccessibleName(tr("Who has this key already"));
    m_conflict->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_conflict->setAlignment(Qt::AlignLeft | Qt::AlignTop);

    auto* row = new QHBoxLayout;
    row->setSpacing(kStep);
    row->addWidget(m_keys, 1);
    for (QPushButton* button : {m_assign, m_none, m_default}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    m_all->setAutoDefault(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_all, QDialogButtonBox::ResetRole);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(kStep);
    layout->addWidget(m_filter);
    layout->addWidget(m_table, 1);
    layout->addLayout(row);
    layout->addWidget(m_conflict);
    layout->addWidget(buttons);
    resize(680, 560);

    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_found->setFilterFixedString(text);
        m_table->setCurrentIndex(m_found->index(0, 0));
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &KeysDialog::showChosen);
    connect(m_keys, &QKeySequenceEdit::keySequenceChanged, this, &KeysDialog::showConflict);
    connect(m_assign, &QPushButton::clicked, this, [this] { change({m_keys->keySequence()}); });
    connect(m_none, &QPushButton::clicked, this, [this] { change({}); });
    connect(m_default, &QPushButton::clicked, this, [this] {
        if (const QAction* command = chosen()) change(m_bindings.defaultsOf(*command));
    });
    connect(m_all, &QPushButton::clicked, this, [this] {
        m_bindings.resetAll();
        m_model->refresh();
        showChosen();
    });
    m_table->setCurrentIndex(m_found->index(0, 0));
    showChosen();
    m_filter->setFocus();
}

QAction* KeysDialog::chosen() const { return m_model->at(m_found->mapToSource(m_table->currentIndex()).row()); }

void KeysDialog::showChosen()
{
    const QAction*       command = chosen();
    const QSignalBlocker quiet(m_keys);
    m_keys->setKeySequence(command && !command->shortcuts().isEmpty() ? command->shortcuts().first() : QKeySequence());
    for (QWidget* widget : {static_cast<QWidget*>(m_keys), static_cast<QWidget*>(m_none)}) widget->setEnabled(command);
    m_default->setEnabled(command && m_bindings.isChanged(*command));
    showConflict();
}

void KeysDialog::showConflict()
{
    const QAction*     command = chosen();
    const QKeySequence keys    = m_keys->keySequence();
    m_assign->setEnabled(command && !keys.isEmpty() && !command->shortcuts().contains(keys));
    QStringList names;
    if (command)
        for (const QAction* other : m_bindings.conflictsOf(*command, keys)) names << plainName(*other);
    m_conflict->setText(names.isEmpty()
                            ? QString()
                            : tr("\u26A0 %1 belongs to: %2. Assigning it takes it away from there.")
                                  .arg(keys.toString(QKeySequence::NativeText), names.join(QStringLiteral(", "))));
}

void KeysDialog::change(const QList<QKeySequence>& keys)
{
    if (QAction* command = chosen()) m_bindings.assign(*command, keys);
    m_model->refresh();
    showChosen();
}

}  // namespace zscope::ui
