// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/diagnosis/diagnosis_words.h"

#include <QCoreApplication>

#include "ui/text/numbers.h"
#include "ui/text/utf8_text.h"

namespace zscope::ui {
namespace {

using check::Mistake;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Diagnosis)
};

/// One of a kind, where nameOf() names many.
QString kindOf(Mistake mistake)
{
    switch (mistake) {
        case Mistake::Hole:
            return Words::tr("hole");
        case Mistake::Spill:
            return Words::tr("spill");
        case Mistake::WrongSurface:
            return Words::tr("wrong surface");
        case Mistake::WrongDepth:
            break;
    }
    return Words::tr("wrong depth");
}

}  // namespace

QString conventionsText(const check::Conventions& c)
{
    if (!c.rows) return Words::tr("The files hold background alone: there are no conventions.");
    QStringList parts;
    if (c.depth) parts << Words::tr("depth is %1").arg(utf8Text(check::wordOf(*c.depth)));
    parts << (*c.rows == check::Rows::TopDown ? Words::tr("the top row comes first")
                                              : Words::tr("the bottom row comes first"));
    if (c.ids)
        parts << (*c.ids == check::IdKind::Triangles ? Words::tr("ids are triangles, counted from %1")
                                                     : Words::tr("ids are faces, counted from %1"))
                     .arg(c.idsFrom.value_or(0));
    if (c.cull)
        parts << (*c.cull == FaceCulling::Back ? Words::tr("back faces are left out")
                                               : Words::tr("back faces are drawn"));
    return parts.join(QStringLiteral(" · "));
}

QString nameOf(Mistake mistake)
{
    switch (mistake) {
        case Mistake::Hole:
            return Words::tr("holes");
        case Mistake::Spill:
            return Words::tr("spills");
        case Mistake::WrongSurface:
            return Words::tr("wrong surfaces");
        case Mistake::WrongDepth:
            break;
    }
    return Words::tr("wrong depths");
}

QString nameOf(const check::Verdict& verdict)
{
    if (verdict.isSame()) return Words::tr("right");
    if (verdict.isRounding()) return Words::tr("rounding (%1)").arg(kindOf(verdict.mistake()));
    return kindOf(verdict.mistake());
}

QString pixelText(const TheirPicture& theirs, const QPoint& pixel, const Theme& theme)
{
    const TheirPixel at     = theirPixel(theirs, pixel);
    const bool       isBad  = at.verdict.isWrong();
    const auto&      c      = theirs.answer->conventions;
    const bool       hasIds = theirs.hasIds() || at.expectedId;
    const auto       row    = [&](const QString& name, bool isCovered, const std::optional<std::int64_t>& id,
                         const std::optional<double>& depth) {
        QString cells = QStringLiteral("<td>%1&nbsp;&nbsp;</td>").arg(name.toHtmlEscaped());
        if (!isCovered) return "<tr>" + cells + "<td colspan=2>" + Words::tr("background") + "</td></tr>";
        if (hasIds)
            cells += QStringLiteral("<td align=right>%1&nbsp;&nbsp;</td>")
                         .arg(id ? QString::number(*id) : QStringLiteral("\u2013"));
        if (theirs.hasDepth())
            cells += QStringLiteral("<td align=right>%1</td>")
                         .arg(depth ? significant(*depth, 9) : QStringLiteral("\u2013"));
        return "<tr>" + cells + "</tr>";
    };
    QString head = QStringLiteral("<td></td>");
    if (hasIds)
        head += QStringLiteral("<td align=right>%1&nbsp;&nbsp;</td>")
                    .arg(c.ids == check::IdKind::Faces ? Words::tr("face") : Words::tr("triangle"));
    if (theirs.hasDepth())
        head += QStringLiteral("<td align=right>%1</td>")
                    .arg(c.depth ? utf8Text(check::wordOf(*c.depth)).toHtmlEscaped() : Words::tr("depth"));
    return QStringLiteral("<table cellspacing=0><tr style='color:%1'>%2</tr>").arg(theme.softText.name(), head)
           + row(Words::tr("right"), at.isExpected, at.expectedId, at.expectedDepth)
           + row(Words::tr("B"), at.isCovered, at.id, at.depth)
           + QStringLiteral("</table><span style='color:%1'>%2 <b>%3</b></span>")
                 .arg((isBad                 ? theme.error
                       : at.verdict.isSame() ? theme.entered
                                             : theme.text)
                          .name(),
                      isBad                 ? QStringLiteral("\u2716")
                      : at.verdict.isSame() ? QStringLiteral("\u2713")
                                            : QStringLiteral("\u2248"),
                      nameOf(at.verdict).toHtmlEscaped());
}

}  // namespace zscope::ui
