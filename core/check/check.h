// Judges what another program drew: files in, one value out, from which text, JSON and reports are made.
//
// Steps      foreign files (foreign.h) -> conventions (conventions.h) -> judgement (judge.h) -> diagnosis (diagnosis.h)
// Keeps      references and pictures with mistakes, per camera and culling, so that many pictures of one scene are
//            judged with the same ones. One Checker is used by one thread at a time
// Errors     Input: a file, a matrix or their sizes cannot be used. Limit, Cancelled
// Source     docs/check.md
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/check/conventions.h"
#include "core/check/diagnosis.h"
#include "core/check/judge.h"
#include "core/check/trace.h"
#include "core/measure/pixel_covers.h"

namespace zscope::check {

struct CheckRequest {
    // the camera: given, or from matrices and a size, or from the dump
    std::optional<Camera>      camera = {};
    std::optional<std::string> matrix = {};            // a file
    int                        width = 0, height = 0;  // with `matrix`
    // at least one
    std::optional<std::string> depth = {}, ids = {}, picture = {}, dump = {};
    Conventions                given        = {};
    int                        subpixelBits = 8;     // of the grid that the program snaps to; 1 to 24
    bool                       diagnoses    = true;  // looks for causes
    Progress                   progress     = {};
};

/// What the reference or a file holds at a pixel, in the file's own numbers; what no file says is absent.
struct PixelContent {
    std::optional<std::int64_t> id;
    std::optional<double>       depth;
};

struct WrongPixel {
    PixelPosition           pixel;
    Mistake                 mistake = Mistake::Hole;
    PixelContent            expected, found;
    std::vector<PixelCover> covers;  // all triangles that meet it, the nearest first
};

/// What is said in place of causes where no mistake of the gallery is meant.
enum class Plight : std::uint8_t {
    None,
    NothingDrawn,  // the files hold background alone
    NoIds,         // without their ids, all of which are background, the files are right
    UpsideDown,    // their rows are given; in the other order at most a twentieth of the wrong pixels is wrong
};

struct CheckAnswer {
    Conventions               conventions;
    Camera                    camera;
    std::uint64_t             covered = 0;  // pixels of the reference
    MistakeCounts             wrong, rounding;
    bool                      looksLikeFillRule = false;  // most roundings lie exactly on an edge
    bool                      looksLikeTies     = false;  // most roundings are surfaces at equal depth
    Plight                    plight            = Plight::None;
    std::int64_t              noId              = 0;   // of NoIds: what the file of ids holds everywhere
    std::uint64_t             wrongTurned       = 0;   // of UpsideDown: pixels that are wrong in the other order
    std::optional<WrongPixel> firstWrong        = {};  // in reading order
    std::vector<Cause>        causes            = {};  // the best first
    std::vector<Cluster>      clusters          = {};  // where nothing explains the wrong pixels
    Grid<Verdict>             verdicts          = {};
    std::string               sentence          = {};  // all of it in plain English

    // what was compared
    std::shared_ptr<const Truth> truth = {};
    Shown                        shown = {};

    bool isRight() const { return wrong.total() == 0; }
};

class Checker {
public:
    explicit Checker(std::shared_ptr<const PreparedScene> scene);
    ~Checker();
    Checker(Checker&&) noexcept;
    Checker& operator=(Checker&&) noexcept;

    Result<CheckAnswer> check(const CheckRequest& request);
    /// A trace of a run with the request's camera; of its files the dump alone is read. Where the culling is not given,
    /// the one that more of the trace agrees with.
    Result<TraceAnswer> checkTrace(const CheckRequest& request, const Trace& trace, const Pipeline& pipeline);

private:
    struct Kept;
    std::unique_ptr<Kept> m_kept;
};

/// "89.0 %": a share of pixels, wherever it is shown.
std::string percentText(double share);
/// "12 of 3 456 covered pixels are wrong: ..." in a few sentences.
std::string sentenceOf(const CheckAnswer& answer, bool diagnosed);

}  // namespace zscope::check
