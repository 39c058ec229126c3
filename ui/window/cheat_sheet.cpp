// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/cheat_sheet.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/theme/theme.h"
#include "ui/window/actions.h"

namespace zscope::ui {
namespace {

/// The rows of a menu and of those below it.
QString rowsOf(const QMenu& menu)
{
    QString rows;
    for (const QAction* action : menu.actions()) {
        if (action->menu())
            rows += rowsOf(*action->menu());
        else if (!action->shortcuts().isEmpty() && action->isVisible())
            rows +=
                QStringLiteral(
                    "<tr><td width='170' style='padding:2px 0'><b>%1</b></td><td style='padding:2px 0'>%2</td></tr>")
                    .arg(QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText).toHtmlEscaped(),
                         plainName(*action).remove(QChar(0x2026)).toHtmlEscaped());
    }
    return rows;
}

}  // namespace

CheatSheet::CheatSheet(const QMenuBar& menus, QWidget* parent)
    : QDialog(parent), m_menus(menus), m_text(new QTextBrowser)
{
    setObjectName("cheatSheet");
    setAttribute(Qt::WA_DeleteOnClose);
    resize(620, 680);
    m_text->setFrameShape(QFrame::NoFrame);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text);
    layout->addWidget(buttons);
    m_later.setSingleShot(true);
    m_later.setInterval(0);
    connect(&m_later, &QTimer::timeout, this, &CheatSheet::write);
    for (const QAction* action : parent->findChildren<QAction*>())
        connect(action, &QAction::changed, &m_later, qOverload<>(&QTimer::start));
    write();
}

void CheatSheet::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) m_later.start();
    QDialog::changeEvent(event);
}

void CheatSheet::write()
{
    setWindowTitle(tr("Keys and mouse"));
    QString html =
        tr("<p><b>Inspect</b>: the wheel zooms to the cursor, dragging pans, a click picks a pixel.<br>"
           "<b>Camera</b>, or Alt held: left drag orbits, middle drag pans, right drag looks around, the wheel "
           "dollies, the arrow keys turn the model, W A S D Q E fly, Shift flies faster.<br>"
           "<b>Shift held</b> with Inspect: B is seen for as long.</p>");
    for (const QAction* entry : m_menus.actions()) {
        if (!entry->menu()) continue;
        if (const QString rows = rowsOf(*entry->menu()); !rows.isEmpty())
            html += QStringLiteral("<h4 style='margin-bottom:4px'>%1</h4><table>%2</table>")
                        .arg(plainName(*entry).toHtmlEscaped(), rows);
    }
    m_text->setHtml(html);
}

}  // namespace zscope::ui
