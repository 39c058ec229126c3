// What a lesson can ask about: numbers and words that are read from the state of a step, and values of single pixels.
//
// Growing    a fact is one entry in lesson_facts.cpp; docs/lessons.md lists them, and a test holds the list against it
// Promise    a fact that the state does not have (no line yet, no question asked) is an error with a sentence, never a
//            zero
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/lesson/lesson.h"
#include "core/lesson/step_state.h"

namespace zscope {

struct FactSource {
    const StepState&             state;
    const DrawRequest&           request;
    std::optional<PixelPosition> pick;
};

struct FactEntry {
    std::string_view word;
    std::string_view title;   // what it is, in a few words, with the unit
    bool             isWord;  // its values are words, else numbers
    /// Nothing: the state has no such thing.
    std::optional<FactValue> (*read)(const FactSource& source);
};
std::span<const FactEntry> facts();

/// "work.NAME": a counter of `zscope-cli render --stats`, counted over the whole frame.
bool              isFact(std::string_view word);
Result<FactValue> factOf(std::string_view word, const FactSource& source);

struct PixelFactEntry {
    std::string_view word;
    std::string_view title;
};
/// Values that every pixel has.
std::span<const PixelFactEntry> pixelFacts();
Result<Grid<double>>            pixelFactOf(std::string_view word, const FactSource& source);

}  // namespace zscope
