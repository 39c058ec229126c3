// Benchmarks that have a name: scenes, algorithms and threads that were chosen together to answer one question.
//
// Growing    a suite is one entry in suites.cpp; `bench --suite`, `list suites` and the tests read it from there
// Words      algorithms are names of presets, scenes are words for loadScene(), threads as in BenchRequest
// Cameras    a view of the scene's own, or a file of ten numbers, which sets the size of the picture too; such files
//            and models are named relative to the root of the project
// Compared   every time is set against that of kSuiteBaseline, which is in every suite
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/scene/view.h"

namespace zscope {

inline constexpr std::string_view kSuiteBaseline = "zbuffer";

struct SuiteScene {
    std::string_view word;         // there on every machine
    std::string_view view   = {};  // one of the scene's own; empty: its first
    std::string_view title  = {};  // what tables call it; empty: word and view
    std::string_view camera = {};  // a file, instead of a view

    // Drawn instead, with a camera of its own, where it is there: the word is then a stand-in of the same size.
    std::string_view model       = {};  // a file
    std::string_view modelCamera = {};  // a file
};

/// What is timed: shaded pictures, ids and depth only, or one after the other.
enum class BenchPictures { Shaded, Unshaded, Both };

struct Suite {
    std::string_view                  name;
    std::string_view                  title;  // the question, in one line
    std::span<const SuiteScene>       scenes;
    std::span<const std::string_view> algorithms;
    std::span<const int>              threads;           // 0: one per core
    std::optional<FaceCulling>        faceCulling = {};  // absent: as the view says
    BenchPictures                     pictures    = BenchPictures::Shaded;
};

std::span<const Suite> suites();
const Suite*           findSuite(std::string_view name);  // nullptr: there is none of this name

}  // namespace zscope
