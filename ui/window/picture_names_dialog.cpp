// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_names_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "ui/session/picture_name.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

PictureNamesDialog::PictureNamesDialog(const QString& pattern, const Snapshot& shown, const QString& folder,
                                       QWidget* parent)
    : QDialog(parent), m_shown(shown), m_folder(folder), m_pattern(new QLineEdit(pattern)), m_next(new QLabel)
{
    setObjectName("pictureNames");
    setWindowTitle(tr("Names of pictures"));
    m_pattern->setAccessibleName(tr("Template"));
    m_next->setWordWrap(true);
    m_next->setTextFormat(Qt::PlainText);
    m_next->setAccessibleName(tr("Next picture"));
    m_next->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_next->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* fields =
        new QLabel(tr("{scene}  name of the scene\n{algorithm}  preset, or the choices\n{grain}  grain of the steps\n"
                      "{step}  step, or end\n{n}  the first number that is free"));
    fields->setObjectName("soft");
    auto* form = new QFormLayout;
    form->setVerticalSpacing(kStep);
    form->addRow(tr("Template"), m_pattern);
    form->addRow(tr("Fields"), fields);
    form->addRow(tr("Next picture"), m_next);
    auto* buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
    m_keep       = buttons->button(QDialogButtonBox::Ok);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(2 * kStep);
    layout->addLayout(form);
    layout->addWidget(buttons);
    resize(560, sizeHint().height());

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] { m_pattern->setText(kPictureTemplate); });
    connect(m_pattern, &QLineEdit::textChanged, this, &PictureNamesDialog::showNext);
    showNext();
    m_pattern->setFocus();
    m_pattern->selectAll();
}

QString PictureNamesDialog::pattern() const { return m_pattern->text().trimmed(); }

void PictureNamesDialog::showNext()
{
    const auto trouble = whyNoPictureTemplate(pattern());
    m_keep->setEnabled(!trouble);
    m_next->setText(trouble ? QStringLiteral("\u26A0 ") + *trouble
                            : QDir::toNativeSeparators(
                                QDir(m_folder).filePath(freePictureName(m_shown, m_folder, pattern()) + ".png")));
}

}  // namespace zscope::ui
