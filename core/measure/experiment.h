// An experiment: a question, and which scenes are drawn how to answer it, written down in a JSON file so that its table
// can be made again by anyone.
//
// File       {"title":T,"question":T,"baseline":ALGORITHM,"parts":[{"title":T,"scenes":[SCENE...],
//            "algorithms":[WORD...],"threads":[N...],"size":"WxH","cull":"none|back","frames":N,"rounds":N,
//            "shade":bool,"x":T,"path":FILE,"sample":N,"peers":bool}...]} T is a text, or {"en":text,"zh_CN":text}. A
//            SCENE is a word for loadScene(), or {"scene":word,"title":text,
//            "view":name,"camera":file,"model":file,"model_camera":file,"x":number,"size":"WxH","choices":[CHOICE...]}
//            as in a Suite; choices are set in every algorithm of the part, for this scene. An algorithm is a preset,
//            with +axis=choice and +fault=name after it for what differs
// Case       a scene of a part with all of the part's algorithms and thread counts: they are timed in turn, so that
//            their times may be divided. The unit that is recorded, resumed and given to a shard
// Words      of scenes, algorithms and files are checked by whoever runs it: this reads what is written and its form
// Errors     "file:line: sentence"; Input, or Limit where there is too much of something
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/measure/suites.h"

namespace zscope {

inline constexpr std::uint64_t kMaxExperimentFile = 1 << 20;  // bytes
inline constexpr std::size_t   kMaxCases          = 10'000;

/// What people read, in the languages of the window.
struct ExperimentText {
    std::string english, chinese;  // chinese: the same as english where the file has none

    friend bool operator==(const ExperimentText&, const ExperimentText&) = default;
};

struct ExperimentScene {
    std::string              word;
    std::string              title, view, camera;  // as in SuiteScene; empty: none
    std::string              model, modelCamera;
    std::optional<double>    x     = {};             // its place on the axis of a growth curve
    int                      width = 0, height = 0;  // 0: the part's
    std::vector<std::string> choices;                // "axis=choice"
    int                      line = 0;               // of the file, for errors about its words
};

struct ExperimentPart {
    ExperimentText               title;
    std::vector<ExperimentScene> scenes;
    std::vector<std::string>     algorithms;
    std::vector<int>             algorithmLines;  // of the file, for errors about them; likewise the next
    int                          pathLine = 0;
    std::vector<int>             threads  = {1};              // 0: one per core
    int                          width = 1280, height = 720;  // where a camera file does not say
    bool                         hasSize     = false;
    std::optional<FaceCulling>   faceCulling = {};
    ShortcutSet                  shortcuts   = ShortcutSet::all();
    int                          frames      = 30;  // timed, of every run
    int                          rounds      = 5;   // that these frames are parted in, 1 to frames
    std::optional<bool>          shade       = {};  // absent: yes, and where there are peers ids and depth alone too
    // a file of key frames: `rounds` passes along it instead of frames of one view
    std::string                  path    = {};
    std::optional<std::uint64_t> samples = {};     // pixels that are verified of each picture; absent: all
    bool                         peers   = false;  // other renderers are timed too
    ExperimentText               x       = {};     // what the places of its scenes mean; empty: they are a list
    int                          line    = 0;
};

struct Experiment {
    ExperimentText              title, question;
    std::string                 baseline;          // the algorithm that the others' times are divided by
    int                         baselineLine = 0;  // of the file, for errors about it
    std::vector<ExperimentPart> parts;
    std::string                 digest;  // 16 hex digits of everything but titles and questions

    std::size_t caseCount() const;
};

/// One case: counted through all parts from 0.
struct ExperimentCase {
    std::size_t            index = 0;
    const ExperimentPart*  part  = nullptr;
    const ExperimentScene* scene = nullptr;
};
std::vector<ExperimentCase> casesOf(const Experiment& experiment);

/// 16 hex digits that tell whether two texts are the same, not that nobody forged one.
std::string digestOfText(std::string_view text);

Result<Experiment> experimentFromJson(const std::string& text, const std::string& file);

}  // namespace zscope
