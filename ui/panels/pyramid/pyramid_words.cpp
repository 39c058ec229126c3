// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pyramid/pyramid_words.h"

#include <QCoreApplication>

#include "core/lesson/pyramid_levels.h"
#include "ui/text/numbers.h"
#include "ui/theme/verdicts.h"

namespace zscope::ui {
namespace {

struct PyramidText {
    Q_DECLARE_TR_FUNCTIONS(Pyramid)
};

QString bold(const QString& text) { return QStringLiteral("<b>%1</b>").arg(text); }

QString verdictText(bool hidden, bool ofTriangle, const Theme& theme)
{
    const NodeVerdict verdict = hidden ? NodeVerdict::Hidden : NodeVerdict::Entered;
    const QString     word    = hidden       ? PyramidText::tr("hidden")
                                : ofTriangle ? PyramidText::tr("may be seen")
                                             : PyramidText::tr("may be seen, entered");
    return QStringLiteral("<span style='color:%1'>%2 <b>%3</b></span>")
        .arg(colourOf(verdict, theme).name(), shapeOf(verdict), word);
}

QString whoWasAsked(const HierarchyState& hierarchy)
{
    if (hierarchy.askedAbout) return PyramidText::tr("Triangle %1").arg(bold(grouped(hierarchy.askedAbout->value)));
    if (hierarchy.now < 0) return PyramidText::tr("A node");
    const NodeRow& node = hierarchy.nodes[static_cast<std::size_t>(hierarchy.now)];
    const QString  name = PyramidText::tr("Node %1").arg(bold(QString::fromStdString(node.path)));
    return node.instance ? PyramidText::tr("%1 of instance %2").arg(name, grouped(node.instance->value)) : name;
}

}  // namespace

QString cellDepth(float value, float empty)
{
    return value <= empty ? PyramidText::tr("background") : depthText(value);
}

QString climbText(const std::vector<CellWrite>& climb)
{
    QStringList levels;
    for (const CellWrite& write : climb) levels << QString::number(write.level);
    return levels.join(QStringLiteral(" \u2192 "));
}

PyramidWords wordsOf(const HierarchyState& hierarchy, float empty, const Theme& theme)
{
    PyramidWords words;
    if (const auto& q = hierarchy.query) {
        const PixelBox cells = cellsUnder(q->box, q->level);
        words.question       = PyramidText::tr("%1 covers %2 × %3 px: level %4, %5 × %6 cells. ")
                             .arg(whoWasAsked(hierarchy))
                             .arg(q->box.x1 - q->box.x0)
                             .arg(q->box.y1 - q->box.y0)
                             .arg(bold(QString::number(q->level)))
                             .arg(cells.x1 - cells.x0)
                             .arg(cells.y1 - cells.y0);
        words.question += q->value <= empty ? PyramidText::tr("There is background among them; it is at nearest %1: ")
                                                  .arg(bold(depthText(q->nearest)))
                                            : PyramidText::tr("Farthest held %1, it is at nearest %2: ")
                                                  .arg(bold(depthText(q->value)), bold(depthText(q->nearest)));
        words.question += verdictText(q->hidden, hierarchy.askedAbout.has_value(), theme) + QStringLiteral(". ");
        if (q->hidden != (q->nearest < q->value)) words.question += PyramidText::tr("Finer cells decided. ");
        words.question += counted(static_cast<std::uint64_t>(q->cells), PyramidText::tr("1 cell or pixel read."),
                                  PyramidText::tr("%1 cells or pixels read."));
    }
    if (const auto& write = hierarchy.update) {
        words.update = PyramidText::tr("Cell (%1, %2) of level %3: ")
                           .arg(write->x)
                           .arg(write->y)
                           .arg(bold(QString::number(write->level)));
        words.update += write->before == write->after
                            ? PyramidText::tr("%1 as before. ").arg(bold(cellDepth(write->after, empty)))
                            : PyramidText::tr("%1 instead of %2. ")
                                  .arg(bold(cellDepth(write->after, empty)), cellDepth(write->before, empty));
        const bool isTop   = !hierarchy.levels.empty() && write->level + 1 >= static_cast<int>(hierarchy.levels.size());
        const bool stopped = write->before == write->after || isTop;
        if (hierarchy.climb.size() > 1 || stopped)
            words.update +=
                (stopped ? PyramidText::tr("Way up: %1, and it stops there.") : PyramidText::tr("Way up so far: %1."))
                    .arg(bold(climbText(hierarchy.climb)));
    }
    return words;
}

}  // namespace zscope::ui
