// Benchmarks that have a name: scenes, algorithms and threads that were chosen together to answer one question.
//
// Growing    a suite is one entry in suites.cpp; `bench --suite`, `list suites` and the tests read it from there
// Words      algorithms are names of presets, scenes are words for loadScene(), threads as in BenchRequest
// Compared   every time is set against that of kSuiteBaseline, which is in every suite
#pragma once

#include <span>
#include <string_view>

namespace zscope {

inline constexpr std::string_view kSuiteBaseline = "zbuffer";

struct SuiteScene {
    std::string_view word;
    std::string_view view = {};  // one of the scene's own; empty: its first
};

struct Suite {
    std::string_view                  name;
    std::string_view                  title;  // the question, in one line
    std::span<const SuiteScene>       scenes;
    std::span<const std::string_view> algorithms;
    int                               threads;  // 0: one per core
};

std::span<const Suite> suites();
const Suite*           findSuite(std::string_view name);  // nullptr: there is none of this name

}  // namespace zscope
