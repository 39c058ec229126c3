// A lesson: pages that each show one scene, drawn by one algorithm, stopped at one real step, with a text and perhaps a
// question. A teacher writes it as a plain file (core/lesson/lesson_file.h, docs/lessons.md).
//
// Stops      are named by what happens (line 12 is drawn, the third question that says hidden), not by a count of
//            steps, so that they survive a change of the algorithm
// Answers    are read from the renderer's state where a question names a fact; the file only says what to look at
// Languages  English, and Simplified Chinese; where one is missing the other is shown
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/stages.h"
#include "core/cull/cull_events.h"
#include "core/frame/pipeline.h"
#include "core/lesson/explanation.h"
#include "core/lesson/layers.h"
#include "core/measure/reference.h"
#include "core/probe/grain.h"
#include "core/scene/view.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

/// One text in both languages; an empty one was not written.
struct LessonText {
    std::string english, chinese;

    bool               isEmpty() const { return english.empty() && chinese.empty(); }
    const std::string& in(bool isChinese) const
    {
        const std::string& wanted = isChinese ? chinese : english;
        return wanted.empty() ? (isChinese ? english : chinese) : wanted;
    }
};

/// Where a page stops: right after the nth event, of those that are steps of `grain`, for which everything given here
/// holds. With nothing given it is the finished picture.
struct LessonStop {
    Grain                         grain = Grain::Frame;
    std::optional<std::uint64_t>  step;          // a step by its number; then nothing else is given
    std::optional<int>            line;          // the event belongs to this line of the picture
    std::optional<PixelPosition>  pixel;         // a test of this pixel, or a span or an interval that holds it
    std::optional<TriangleId>     triangle;      // the event is about this triangle
    std::optional<NodeName>       node;          // ... about this node
    std::optional<Stage>          stage;         // the end of this stage
    std::optional<Verdict>        verdict;       // a node was judged so
    std::optional<bool>           hidden;        // a question to the pyramid was answered so
    std::optional<int>            update;        // a cell of this level was written
    std::optional<IntervalReason> interval;      // an interval was decided for this reason
    std::optional<bool>           won;           // a depth test ended so
    std::uint64_t                 nth      = 1;  // from 1
    int                           fileLine = 0;

    bool isEnd() const
    {
        return !step && !line && !pixel && !triangle && !node && !stage && !verdict && !hidden && !update && !interval
               && !won;
    }
};

/// A number or a word that is read from the renderer's state; see facts() in core/lesson/lesson_facts.h.
using FactValue = std::variant<double, std::string>;

/// Which values of a fact count: one word, or numbers in [from, to].
struct Accepted {
    std::string word = {};
    double      from = 0, to = 0;  // used if there is no word

    bool holds(const FactValue& value) const;
};

struct LessonChoice {
    LessonText              text;
    bool                    isRight = false;  // as the file says; used if the question names no fact
    std::optional<Accepted> when;             // right for these values of the question's fact
};

struct LessonQuestion {
    enum class Kind { Choice, Number, Pixel };
    // the state that the fact is read from: where the page stops, one step later, the last
    enum class At { Stop, Next, End };

    Kind                      kind = Kind::Choice;
    LessonText                ask, why;
    std::string               fact;  // empty: the file alone says what is right
    At                        at = At::Stop;
    std::vector<LessonChoice> choices;        // of Choice: two or more
    std::optional<double>     answer;         // of Number, as the file says; held against the fact if there are both
    double                    tolerance = 0;  // of Number: how far off an answer may be
    LessonText                unit;           // of Number
    std::optional<Accepted>   accepted;       // of Pixel: the values of the fact at the right pixels
    int                       fileLine = 0;
};

/// Words of the panels that a page may raise.
inline constexpr std::array<std::string_view, 13> kLessonPanels{
    "scene",    "pipeline",   "faults", "marks",   "active-edges", "pyramid", "hierarchy",
    "observer", "depth-test", "why",    "compare", "measure",      "timeline"};

struct LessonPage {
    std::string                   scene;            // a path or builtin:NAME
    ViewRequest                   view;             // with the size of the picture
    bool                          hasView = false;  // otherwise the scene's own first view, in this size
    Pipeline                      pipeline;
    std::optional<Pipeline>       compared;  // B of a comparison
    LessonStop                    stop;
    std::optional<PixelPosition>  pick;
    const Layer*                  layer = &layers().front();
    std::vector<std::string>      overlays;  // "boxes", "pyramid"
    std::string                   panel;     // one of kLessonPanels; empty: none
    LessonText                    text;      // Markdown
    std::optional<LessonQuestion> question;
    int                           fileLine = 0;
};

struct Lesson {
    std::string             file;  // as it was given
    LessonText              title;
    std::vector<LessonPage> pages;  // one or more
};

}  // namespace zscope
