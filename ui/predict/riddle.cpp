// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/predict/riddle.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "ui/text/numbers.h"

namespace zscope::ui {
namespace {

struct PredictWords {
    Q_DECLARE_TR_FUNCTIONS(Predict)
};

constexpr double kTenthOfAPixel = 0.1;

/// What is asked changes from line to line, so that nobody answers by rote.
std::optional<Riddle> edgesRiddle(const StepState& before, const StepState& after)
{
    if (!before.sweep || !after.sweep || after.sweep->y != before.sweep->y + 1 || after.sweep->y < 0) return {};
    Riddle     riddle{.line = after.sweep->y};
    const bool enter = !after.sweep->entered.empty(), leave = !after.sweep->left.empty();
    if (enter && (!leave || riddle.line % 2 == 0)) {
        riddle.ask    = Riddle::Ask::EdgesEnter;
        riddle.answer = static_cast<double>(after.sweep->entered.size());
        return riddle;
    }
    if (leave) {
        riddle.ask    = Riddle::Ask::EdgesLeave;
        riddle.answer = static_cast<double>(after.sweep->left.size());
        return riddle;
    }
    // An edge that goes on; which one wanders through the table.
    const auto& active = before.sweep->activeEdges;
    for (std::size_t i = 0; i < active.size(); ++i) {
        const EdgeRow& edge = active[(i + static_cast<std::size_t>(riddle.line)) % active.size()];
        const auto     next = std::ranges::find_if(after.sweep->activeEdges, [&](const EdgeRow& e) {
            return e.polygon == edge.polygon && e.firstLine == edge.firstLine && e.lastLine == edge.lastLine
                   && e.dx == edge.dx;
        });
        if (next == after.sweep->activeEdges.end()) continue;
        riddle.ask       = Riddle::Ask::EdgeX;
        riddle.edge      = edge;
        riddle.answer    = next->x;
        riddle.tolerance = kTenthOfAPixel;
        return riddle;
    }
    return {};
}

QString nodeText(const Riddle& riddle)
{
    return riddle.instance
               ? PredictWords::tr("Node %1 of instance %2").arg(riddle.about, grouped(riddle.instance->value))
               : PredictWords::tr("Node %1").arg(riddle.about);
}

void name(const NodeRow& node, Riddle& riddle)
{
    riddle.about    = QString::fromStdString(node.path);
    riddle.instance = node.instance;
}

std::optional<Riddle> pyramidRiddle(const ShownStep& before, const StepState& after)
{
    if (!after.hierarchy) return {};
    const HierarchyState& hierarchy = *after.hierarchy;
    if (after.event == Grain::Update && hierarchy.update) {
        const CellWrite& cell = *hierarchy.update;
        return Riddle{.ask          = Riddle::Ask::CellChanges,
                      .about        = QStringLiteral("(%1, %2)").arg(cell.x).arg(cell.y),
                      .level        = cell.level,
                      .value        = cell.before,
                      .isBackground = cell.before <= before.pyramid.empty,
                      .answer       = cell.before == cell.after ? 1.0 : 0.0};
    }
    const bool asked = after.event == Grain::Query || (after.event == Grain::Node && hierarchy.asked == "node");
    if (!asked || !hierarchy.query || after.tile) return {};
    // perhaps it is an older one
    if (after.event == Grain::Node && before.state.hierarchy && before.state.hierarchy->query) {
        const PyramidQuery &old = *before.state.hierarchy->query, &now = *hierarchy.query;
        if (old.box.x0 == now.box.x0 && old.box.y0 == now.box.y0 && old.box.x1 == now.box.x1
            && old.nearest == now.nearest)
            return {};
    }
    Riddle riddle{.ask        = Riddle::Ask::QueryVerdict,
                  .isTriangle = hierarchy.askedAbout.has_value(),
                  .query      = hierarchy.query,
                  .answer     = hierarchy.query->hidden ? 0.0 : 1.0};
    if (hierarchy.askedAbout)
        riddle.about = grouped(hierarchy.askedAbout->value);
    else if (hierarchy.now >= 0)
        name(hierarchy.nodes[static_cast<std::size_t>(hierarchy.now)], riddle);
    return riddle;
}

std::optional<Riddle> nodesRiddle(const ShownStep& after, const Scene& scene)
{
    const StepState& state = after.state;
    if (!state.hierarchy || state.event != Grain::Node || state.hierarchy->now < 0) return {};
    const NodeRow& node = state.hierarchy->nodes[static_cast<std::size_t>(state.hierarchy->now)];
    Riddle         riddle{.ask = Riddle::Ask::NodeVerdict};
    name(node, riddle);
    switch (node.verdict) {
        case NodeVerdict::Outside:
            riddle.answer = 0;
            break;
        case NodeVerdict::Hidden:
            riddle.answer = 1;
            break;
        case NodeVerdict::Entered:
        case NodeVerdict::Drawn:
            riddle.answer = 2;
            break;
        case NodeVerdict::Waiting:
        case NodeVerdict::Small:
            return {};
    }
    const NodeOnScreen screen = onScreen(node, scene, after.camera);
    riddle.pixels             = screen.crossesNear ? -1 : screen.pixels;
    riddle.nearest            = screen.nearest;
    return riddle;
}

}  // namespace

std::optional<Riddle> riddleOf(Topic topic, const ShownStep& before, const ShownStep& after, const Scene& scene)
{
    switch (topic) {
        case Topic::Edges:
            return edgesRiddle(before.state, after.state);
        case Topic::Pyramid:
            return pyramidRiddle(before, after.state);
        case Topic::Nodes:
            return nodesRiddle(after, scene);
    }
    return {};
}

QString titleOf(Topic topic)
{
    switch (topic) {
        case Topic::Edges:
            return PredictWords::tr("active edges");
        case Topic::Pyramid:
            return PredictWords::tr("pyramid");
        case Topic::Nodes:
            return PredictWords::tr("hierarchy");
    }
    return {};
}

QString askText(const Riddle& riddle)
{
    using Ask          = Riddle::Ask;
    const QString line = grouped(static_cast<unsigned>(riddle.line));
    switch (riddle.ask) {
        case Ask::EdgesEnter:
            return PredictWords::tr("Line %1 comes next. How many edges enter?").arg(line);
        case Ask::EdgesLeave:
            return PredictWords::tr("Line %1 comes next. How many edges leave?").arg(line);
        case Ask::EdgeX:
            return PredictWords::tr(
                       "Line %1 comes next. The edge of polygon %2 is at x = %3 and moves by dx = %4. Where will it "
                       "be? (to 0.1 pixel)")
                .arg(line, grouped(riddle.edge.polygon.value), decimal(riddle.edge.x, 2),
                     signedDecimal(static_cast<double>(riddle.edge.dx[0]) / static_cast<double>(riddle.edge.dx[1]), 4));
        case Ask::QueryVerdict: {
            const QString who =
                riddle.isTriangle ? PredictWords::tr("Triangle %1").arg(riddle.about) : nodeText(riddle);
            return PredictWords::tr(
                       "%1 covers the pixels %2 to %3 across and %4 to %5 down, and is at nearest D = %6. What does "
                       "the pyramid answer?")
                .arg(who)
                .arg(riddle.query->box.x0)
                .arg(riddle.query->box.x1 - 1)
                .arg(riddle.query->box.y0)
                .arg(riddle.query->box.y1 - 1)
                .arg(depthText(riddle.query->nearest));
        }
        case Ask::CellChanges:
            return PredictWords::tr("Cell %1 of level %2 is computed anew; it held %3. What comes of it?")
                .arg(riddle.about, QString::number(riddle.level),
                     riddle.isBackground ? PredictWords::tr("background") : depthText(riddle.value));
        case Ask::NodeVerdict:
            if (riddle.pixels < 0)
                return PredictWords::tr("%1 is judged next. Its box reaches around the eye. What becomes of it?")
                    .arg(nodeText(riddle));
            return PredictWords::tr(
                       "%1 is judged next. Its box covers %2 pixels and is at nearest D = %3. What becomes of it?")
                .arg(nodeText(riddle), grouped(static_cast<std::uint64_t>(riddle.pixels)), depthText(riddle.nearest));
    }
    return {};
}

QStringList choicesOf(const Riddle& riddle)
{
    using Ask = Riddle::Ask;
    switch (riddle.ask) {
        case Ask::QueryVerdict:
            return {PredictWords::tr("Hidden"), PredictWords::tr("May be seen")};
        case Ask::CellChanges:
            return {PredictWords::tr("It changes"), PredictWords::tr("It stays")};
        case Ask::NodeVerdict:
            return {PredictWords::tr("Outside"), PredictWords::tr("Hidden"), PredictWords::tr("Entered")};
        default:
            return {};
    }
}

QString truthText(const Riddle& riddle)
{
    using Ask         = Riddle::Ask;
    const auto number = static_cast<std::uint64_t>(std::max(0.0, riddle.answer));
    switch (riddle.ask) {
        case Ask::EdgesEnter:
            return PredictWords::tr("%1 enter: so many lie in the bucket of line %2.")
                .arg(grouped(number))
                .arg(riddle.line);
        case Ask::EdgesLeave:
            return PredictWords::tr("%1 leave: line %2 was their last.").arg(grouped(number)).arg(riddle.line - 1);
        case Ask::EdgeX:
            return PredictWords::tr("x = %1: the x before, and dx.").arg(decimal(riddle.answer, 2));
        case Ask::QueryVerdict:
            return riddle.answer == 0 ? PredictWords::tr("Hidden: all that is there is nearer than %1.")
                                            .arg(depthText(riddle.query->nearest))
                                      : PredictWords::tr("May be seen: something there is not nearer than %1.")
                                            .arg(depthText(riddle.query->nearest));
        case Ask::CellChanges:
            return riddle.answer == 0
                       ? PredictWords::tr(
                           "It changes: the farthest below it has come nearer, and the cells above may change, too.")
                       : PredictWords::tr("It stays: the farthest below it is as far as before, and the way up ends.");
        case Ask::NodeVerdict:
            return riddle.answer == 0 ? PredictWords::tr("Outside: the box does not reach the view.")
                   : riddle.answer == 1
                       ? PredictWords::tr("Hidden: what is drawn already is nearer all over its rectangle.")
                       : PredictWords::tr("Entered: it cannot be called hidden.");
    }
    return {};
}

}  // namespace zscope::ui
