// A side of a triangle, walked from line to line: on each it says where the triangle's pixels begin or end.
//
// Position   exact: whole subpixels and a remainder; with accumulated edges (an approximation) a float32
#pragma once

#include <variant>

#include "core/geometry/rules.h"
#include "core/scan/edge_stepper.h"

namespace zscope::plain {

class TriangleSide {
public:
    /// The side from (xa, ya) down to (xb, yb), in subpixels, standing at `line`, one of the lines that it crosses. It
    /// is asked about no line below `lastLine`.
    TriangleSide(double xa, double ya, double xb, double yb, int line, int lastLine, const ChosenRules& rules)
        : m_rules(rules), m_crossing(EdgeStepper<std::int64_t>())
    {
        if (rules.accumulatesEdges())  // an approximation
            m_crossing = AccumulatedEdge(xa, ya, xb, yb, line, lastLine);
        else
            m_crossing = EdgeStepper<std::int64_t>(xa, ya, xb, yb, line, lastLine);
        if (rules.stepsByWholeSubpixels())  // a fault
            std::visit([](auto& crossing) { crossing.stepByWholeSubpixels(); }, m_crossing);
    }

    /// The first pixel whose centre is not left of the side.
    int firstPixel() const
    {
        // rules.firstPixel(): a fault truncates x
        return std::visit([this](const auto& at) { return m_rules.firstPixel(at.firstPixel(), at.x()); }, m_crossing);
    }
    void nextLine()
    {
        std::visit([](auto& crossing) { crossing.nextLine(); }, m_crossing);
    }

private:
    const ChosenRules&                                       m_rules;
    std::variant<EdgeStepper<std::int64_t>, AccumulatedEdge> m_crossing;
};

}  // namespace zscope::plain
