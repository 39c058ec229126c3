// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <cstring>
#include <string>

#include <QCoreApplication>

namespace zscope::ui {
namespace {

constexpr const char* kContext = "Core";

QString shown(const std::optional<std::string>& text) { return text ? QString::fromStdString(*text) : QString(); }

}  // namespace

QString said(std::string_view english) { return QCoreApplication::translate(kContext, std::string(english).c_str()); }

QString said(const Error& error)
{
    const QString sentence = said(error.sentence);
    if (error.file.empty()) return sentence;
    const QString file = QString::fromStdString(error.file);
    return error.line > 0 ? QStringLiteral("%1:%2: %3").arg(file).arg(error.line).arg(sentence)
                          : QStringLiteral("%1: %2").arg(file, sentence);
}

QString CoreTranslator::translate(const char* context, const char* source, const char*, int) const
{
    return std::strcmp(context, kContext) == 0 ? shown(m_book.text(source)) : QString();
}

QString CoreTranslator::phrase(const QString& english) const { return shown(m_book.phrase(english.toStdString())); }

}  // namespace zscope::ui
