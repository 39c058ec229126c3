// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_page.h"

#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/scene/load.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kWord = Qt::UserRole;

QListWidget* list()
{
    auto* made = new QListWidget;
    made->setFrameShape(QFrame::NoFrame);
    made->setSelectionMode(QAbstractItemView::SingleSelection);
    made->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    made->setTextElideMode(Qt::ElideRight);
    made->setUniformItemSizes(true);
    made->setSpacing(2);
    made->setProperty("ownsArrows", true);
    made->setProperty("ownsEnter", true);
    made->setMinimumWidth(160);
    return made;
}

QLabel* section()
{
    auto* made = new QLabel;
    made->setObjectName("section");
    return made;
}

}  // namespace

StartPage::StartPage(Requests requests, QWidget* parent)
    : QWidget(parent), m_requests(std::move(requests)), m_open(new QPushButton), m_lesson(new QPushButton),
      m_recentTitle(section()), m_examples(list()), m_recent(list())
{
    setObjectName("startPage");
    auto* title         = new QLabel(QStringLiteral("ZScope"));
    auto* line          = new QLabel;
    auto* drop          = new QLabel;
    auto* examplesTitle = section();
    QFont large         = title->font();
    large.setPointSizeF(large.pointSizeF() * 2);
    large.setWeight(QFont::DemiBold);
    title->setFont(large);
    line->setObjectName("soft");
    line->setWordWrap(true);
    drop->setObjectName("soft");
    m_open->setObjectName("strong");
    m_lesson->setVisible(static_cast<bool>(m_requests.firstLesson));
    for (const SceneEntry& scene : builtinScenes()) {
        const QString name = utf8Text(scene.name);
        if (name.startsWith("hard/")) continue;  // those are for the tests; the menu has them
        auto* item = new QListWidgetItem(name, m_examples);
        item->setData(kWord, "builtin:" + name);
    }

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kStep);
    buttons->addWidget(m_open);
    buttons->addWidget(m_lesson);
    buttons->addWidget(drop);
    buttons->addStretch(1);
    auto* lists = new QGridLayout;
    lists->setVerticalSpacing(kStep / 2);
    lists->addWidget(examplesTitle, 0, 0);
    lists->addWidget(m_recentTitle, 0, 1);
    lists->addWidget(m_examples, 1, 0);
    lists->addWidget(m_recent, 1, 1);
    lists->setColumnStretch(0, 3);  // of the widgets that are there
    m_lists      = lists;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(5 * kStep, 4 * kStep, 5 * kStep, 3 * kStep);
    layout->setSpacing(2 * kStep);
    layout->addWidget(title);
    layout->addWidget(line);
    layout->addLayout(buttons);
    layout->addSpacing(kStep);
    layout->addLayout(lists, 1);

    connect(m_open, &QPushButton::clicked, this, [this] { m_requests.open(); });
    connect(m_lesson, &QPushButton::clicked, this, [this] { m_requests.firstLesson(); });
    for (QListWidget* each : {m_examples, m_recent}) {
        connect(each, &QListWidget::itemClicked, this, &StartPage::choose);
        connect(each, &QListWidget::itemActivated, this, &StartPage::choose);
    }
    spoken(*this, [this, line, drop, examplesTitle] {
        line->setText(
            tr("A microscope for visible-surface algorithms: step through how a picture is made, and ask of any pixel "
               "why it shows what it shows."));
        drop->setText(tr("or drop an OBJ file here"));
        examplesTitle->setText(tr("Examples"));
        m_recentTitle->setText(tr("Opened before"));
        m_open->setText(tr("Open a scene…"));
        m_lesson->setText(tr("Begin with lesson 1"));
        m_examples->setAccessibleName(tr("Examples"));
        m_recent->setAccessibleName(tr("Opened before"));
        for (int i = 0; i < m_examples->count(); ++i) {
            QListWidgetItem* item = m_examples->item(i);
            const QString    name = item->data(kWord).toString().mid(8);
            for (const SceneEntry& scene : builtinScenes())
                if (scene.name == name.toStdString())
                    item->setText(name + QStringLiteral("  \u2014  ") + said(scene.title));
            item->setToolTip(item->text());
        }
    });
    showRecent({});
    dress();
}

void StartPage::showRecent(const QStringList& files)
{
    m_recent->clear();
    for (const QString& path : files) {
        auto* item = new QListWidgetItem(QFileInfo(path).fileName(), m_recent);
        item->setToolTip(path);
        item->setData(kWord, path);
    }
    m_recent->setVisible(!files.isEmpty());
    m_recentTitle->setVisible(!files.isEmpty());
    m_lists->setColumnStretch(1, files.isEmpty() ? 0 : 2);
    m_lists->setHorizontalSpacing(files.isEmpty() ? 0 : 4 * kStep);
}

void StartPage::choose(const QListWidgetItem* item)
{
    if (item) m_requests.openWord(item->data(kWord).toString());
}

void StartPage::dress() { m_open->setIcon(iconOf("open", themeOf(palette()).buttonText)); }

void StartPage::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) dress();
    QWidget::changeEvent(event);
}

}  // namespace zscope::ui
