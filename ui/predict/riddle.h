// SPDX-License-Identifier: GPL-3.0-or-later
// What a student can be asked before a step is shown: one question per step
// and table, made from the state before it and the state after it, so that the right answer is always the renderer's.
// No widgets.
//
// Edges      how many enter, how many leave, where an edge meets the next line
// Pyramid    whether a question is answered "hidden", whether a cell changes
// Nodes      what becomes of the node that is judged next
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <QString>

#include "ui/session/snapshot.h"

namespace zscope::ui {

enum class Topic { Edges, Pyramid, Nodes };
inline constexpr std::array kTopics{Topic::Edges, Topic::Pyramid, Topic::Nodes};

struct Riddle {
    enum class Ask { EdgesEnter, EdgesLeave, EdgeX, QueryVerdict, CellChanges, NodeVerdict };

    Ask                       ask   = Ask::EdgesEnter;
    int                       line  = 0;   // of the edges: the next one
    EdgeRow                   edge  = {};  // EdgeX: as it stood on the line before
    QString                   about = {};  // who is asked about: number of a triangle, path of a node, place of a cell
    std::optional<InstanceId> instance       = {};     // of the node
    int                       level          = 0;      // CellChanges
    bool                      isTriangle     = false;  // QueryVerdict
    std::optional<PyramidQuery> query        = {};     // QueryVerdict
    std::int64_t                pixels       = 0;      // NodeVerdict: of the node's rectangle on the screen
    float                       nearest      = 0;      // NodeVerdict: the nearest depth in it
    float                       value        = 0;      // CellChanges: what the cell held
    bool                        isBackground = false;  // CellChanges: that is the depth of background
    double                      answer       = 0;      // a number, or the place of the right one among choicesOf()
    double                      tolerance    = 0;

    bool isNumber() const { return ask == Ask::EdgesEnter || ask == Ask::EdgesLeave || ask == Ask::EdgeX; }
    bool accepts(double given) const { return std::abs(given - answer) <= tolerance; }
};

/// Nothing: the step brings nothing of this topic.
std::optional<Riddle> riddleOf(Topic topic, const ShownStep& before, const ShownStep& after, const Scene& scene);

// In the language of the window.
QString     askText(const Riddle& riddle);
QStringList choicesOf(const Riddle& riddle);  // empty: a number is asked for
/// What is right, and by which rule.
QString truthText(const Riddle& riddle);
QString titleOf(Topic topic);

}  // namespace zscope::ui
