#include "core/check/check.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "core/check/matrix_camera.h"

namespace zscope::check {
namespace {

/// What was read: the buffers, and the cameras that they may have been drawn with.
struct Input {
    Foreign             files;
    std::vector<Camera> cameras;
    Conventions         given;
};

Result<std::vector<Camera>> camerasFor(const CheckRequest& request, const std::optional<Dump>& dump)
{
    if (request.camera) return std::vector{*request.camera};
    if (request.matrix) {
        const Result<CameraMatrices> matrices = readMatrices(*request.matrix);
        if (!matrices) return matrices.error();
        return camerasOf(*matrices, request.width, request.height, *request.matrix);
    }
    if (!dump)
        return inputError("no camera is given: neither its ten numbers (--camera FILE), nor matrices, nor a dump");
    if (!dump->view || !dump->projection)
        return inputError("the dump holds no view and projection, and no camera is given (--camera FILE)",
                          *request.dump);
    const CameraMatrices matrices{dump->view, dump->projection, {}, dump->order, dump->range};
    return camerasOf(matrices, dump->width, dump->height, *request.dump);
}

/// Two files that hold the same: which one is meant cannot be known.
Error givenTwice(std::string_view what)
{
    return inputError(fmt::format("the {} are given twice: by a file and by the dump", what));
}

Result<Input> inputOf(const CheckRequest& request)
{
    std::optional<Dump> dump;
    if (request.dump) {
        Result<Dump> read = readDump(*request.dump);
        if (!read) return read.error();
        dump = *std::move(read);
    }
    const auto cameras = camerasFor(request, dump);
    if (!cameras) return cameras.error();
    Input     input{{}, *cameras, request.given};
    const int width = cameras->front().width, height = cameras->front().height;
    if (dump) {
        if (dump->width != width || dump->height != height)
            return inputError(fmt::format("the dump has {}x{} pixels, and the camera's picture has {}x{}", dump->width,
                                          dump->height, width, height),
                              *request.dump);
        if (dump->depth && request.depth) return givenTwice("depths");
        if (dump->ids && request.ids) return givenTwice("ids");
        input.files.depth = std::move(dump->depth);
        input.files.ids   = std::move(dump->ids);
        if (!input.given.rows) input.given.rows = dump->rows;
        if (!input.given.idsFrom) input.given.idsFrom = dump->idsFrom;
    }
    if (request.depth) {
        Result<ForeignDepth> depth = readDepth(*request.depth, width, height);
        if (!depth) return depth.error();
        input.files.depth  = *std::move(depth);
        const auto meaning = request.given.depth;
        if (meaning && input.files.depth->resolution.format == DepthNumberFormat::Fixed && !fitsFractions(*meaning))
            return inputError(
                fmt::format("integers are fractions of their largest value and cannot mean '{}'", wordOf(*meaning)),
                *request.depth);
    }
    if (request.ids) {
        Result<ForeignIds> ids = readIds(*request.ids, width, height);
        if (!ids) return ids.error();
        input.files.ids = *std::move(ids);
    }
    if (request.picture) {
        Result<Grid<std::uint32_t>> picture = readPicture(*request.picture, width, height);
        if (!picture) return picture.error();
        input.files.picture = *std::move(picture);
    }
    if (!input.files.depth && !input.files.ids && !input.files.picture)
        return inputError("nothing is given to be checked: name depth, ids, a picture or a dump");
    return input;
}

/// Ten numbers, size, culling and grid, so that equal ones are found again.
using ViewKey = std::tuple<std::string, FaceCulling, int>;

}  // namespace

struct Checker::Kept {
    struct View {
        std::shared_ptr<const Truth>         truth;
        std::map<std::string, SpoiltPicture> spoilt;  // by the pipeline's name
    };

    std::shared_ptr<const PreparedScene> scene;
    std::map<ViewKey, View>              views;

    Result<View*> viewOf(const Camera& camera, FaceCulling culling, int subpixelBits, const Progress& progress)
    {
        View& view = views[{cameraToJson(camera), culling, subpixelBits}];
        if (!view.truth) {
            auto truth = truthOf(scene, camera, culling, subpixelBits, progress);
            if (!truth) return truth.error();
            view.truth = *std::move(truth);
        }
        return &view;
    }
};

Checker::Checker(std::shared_ptr<const PreparedScene> scene) : m_kept(new Kept{std::move(scene), {}}) {}
Checker::~Checker()                             = default;
Checker::Checker(Checker&&) noexcept            = default;
Checker& Checker::operator=(Checker&&) noexcept = default;

namespace {

using Truths = std::vector<std::shared_ptr<const Truth>>;

struct Best {
    Reading   reading;
    Shown     shown;
    Judgement judgement;
};

/// A reading with culled back faces is not to be believed where the file shows them.
bool showsCulledFaces(const Shown& shown, const Truth& truth)
{
    const auto covered = static_cast<std::uint64_t>(std::ranges::count(shown.covered.values(), 1));
    return truth.culling == FaceCulling::Back && 1000 * backFacesIn(shown, truth) > covered;
}

/// Of readings that agree nearly as well the one that leaves the fewest pixels wrong, and of equal ones the first. Raw
/// normalised device coordinates come last: with another near plane they are window depths. Without ids, culling must
/// explain a third of what is wrong: a mistake may hide faces, too.
Best bestOf(std::vector<Reading> readings, const Foreign& files)
{
    std::optional<Best> best;
    for (Reading& reading : readings) {
        Shown shown = shownBy(files, reading);
        if (best && showsCulledFaces(shown, *reading.truth)) continue;
        Judgement  judgement = judge(shown, *reading.truth);
        const auto rankOf    = [](std::uint64_t wrong, const Reading& of) {
            return std::pair(wrong, of.conventions.depth == DepthMeaning::Ndc);
        };
        std::uint64_t wrong = judgement.wrong.total();
        if (best && !files.ids && best->reading.truth->culling != reading.truth->culling) wrong += wrong / 2;
        if (!best || rankOf(wrong, reading) < rankOf(best->judgement.wrong.total(), best->reading))
            best = Best{std::move(reading), std::move(shown), std::move(judgement)};
    }
    return *std::move(best);
}

/// The files judged without their ids, if these hold background alone and the rest is right; else nothing.
std::optional<Best> rightWithoutIds(const Best& best, const Foreign& files, const Conventions& given,
                                    const Truths& truths)
{
    if (!best.reading.areIdsEmpty || !files.depth || best.reading.isDepthEmpty) return std::nullopt;
    const Foreign depthAlone{files.depth, std::nullopt, std::nullopt};
    Best          other = bestOf(readingsOf(depthAlone, given, truths), depthAlone);
    if (other.judgement.wrong.total() > 0) return std::nullopt;
    return other;
}

/// The pixels that are wrong if the rows are read in the other order than is given; nothing: no order is given.
std::optional<std::uint64_t> wrongTurned(const Foreign& files, Conventions given, const Truths& truths)
{
    if (!given.rows) return std::nullopt;
    given.rows = *given.rows == Rows::TopDown ? Rows::BottomUp : Rows::TopDown;
    return bestOf(readingsOf(files, given, truths), files).judgement.wrong.total();
}

/// What is plainly the matter, before causes are looked for. Where ids are missing, `best` becomes the reading of the
/// depths.
void findPlight(CheckAnswer& answer, Best& best, const Foreign& files, const Conventions& given, const Truths& truths)
{
    if (auto depths = rightWithoutIds(best, files, given, truths)) {
        answer.plight                = Plight::NoIds;
        answer.noId                  = best.reading.idBackground.value_or(-1);
        depths->reading.areIdsEmpty  = true;
        depths->reading.idBackground = best.reading.idBackground;
        best.shown                   = shownBy(files, depths->reading);
        best.judgement               = judge(best.shown, *depths->reading.truth);
        best.reading                 = std::move(depths->reading);
    } else if (const auto turned = wrongTurned(files, given, truths);
               turned && 20 * *turned <= best.judgement.wrong.total()) {
        answer.plight      = Plight::UpsideDown;
        answer.wrongTurned = *turned;
    }
}

std::optional<PixelPosition> firstWrongOf(const Grid<Verdict>& verdicts)
{
    const auto values = verdicts.values();
    const auto found  = std::ranges::find_if(values, &Verdict::isWrong);
    if (found == values.end()) return std::nullopt;
    const auto index = static_cast<int>(found - values.begin());
    return PixelPosition{index % verdicts.width(), index / verdicts.width()};
}

Result<WrongPixel> describe(PixelPosition p, const Foreign& files, const Reading& reading, Mistake mistake,
                            const Progress& progress)
{
    const Truth&       truth = *reading.truth;
    const Conventions& c     = reading.conventions;
    const int          row   = c.rows == Rows::BottomUp ? truth.camera.height - 1 - p.y : p.y;
    const std::int64_t id    = truth.picture.ids.at(p.x, p.y);
    WrongPixel         wrong{p, mistake, {}, {}, {}};
    if (files.ids) {
        const std::int64_t number = c.ids == IdKind::Faces && id >= 0 ? truth.faces.faceOf(id) : id;
        wrong.expected.id         = id < 0 ? reading.idBackground.value_or(-1) : number + c.idsFrom.value_or(0);
        wrong.found.id            = files.ids->values.at(p.x, row);
    } else {
        wrong.expected.id = id;
    }
    if (files.depth) {
        const DepthScale scale(truth.camera, c.depth.value_or(DepthMeaning::NearOverZ));
        wrong.expected.depth = id < 0 ? reading.depthBackground
                                      : std::optional(scale.of(truth.picture.depth.at(p.x, p.y), p.x, p.y).value);
        wrong.found.depth    = files.depth->values.at(p.x, row);
    }
    const PixelPosition points[]{p};
    auto                covers = coversOf(truth.scene->scene(), truth.camera, truth.culling, points, progress);
    if (!covers) return covers.error();
    wrong.covers = std::move(covers->front());
    std::ranges::stable_sort(wrong.covers, std::greater{}, &PixelCover::depth);
    return wrong;
}

}  // namespace

Result<CheckAnswer> Checker::check(const CheckRequest& request)
{
    Result<Input> input = inputOf(request);
    if (!input) return input.error();

    Truths truths;
    for (const Camera& camera : input->cameras)
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            if (request.given.cull && *request.given.cull != culling) continue;
            const auto view = m_kept->viewOf(camera, culling, request.subpixelBits, request.progress);
            if (!view) return view.error();
            const auto& truth = (*view)->truth;
            const bool  isNew = std::ranges::none_of(truths, [&](const auto& other) {
                return other->camera == truth->camera && other->picture == truth->picture;
            });
            if (isNew) truths.push_back(truth);
        }
    CheckAnswer answer;
    Best        best = bestOf(readingsOf(input->files, input->given, truths), input->files);
    if (best.judgement.wrong.total() > 0) {
        if (!best.reading.conventions.rows)
            answer.plight = Plight::NothingDrawn;
        else if (request.diagnoses)
            findPlight(answer, best, input->files, input->given, truths);
    }
    const Reading& reading   = best.reading;
    const Truth&   truth     = *reading.truth;
    const Shown&   shown     = best.shown;
    Judgement&     judgement = best.judgement;

    answer.conventions        = reading.conventions;
    answer.camera             = truth.camera;
    answer.covered            = truth.covered;
    answer.wrong              = judgement.wrong;
    answer.rounding           = judgement.rounding;
    const std::uint64_t moved = judgement.rounding.total() - judgement.rounding.of(Mistake::WrongDepth);
    answer.looksLikeFillRule  = 2 * judgement.onEdges > moved;
    answer.looksLikeTies      = 2 * judgement.ties > moved;
    if (const auto first = firstWrongOf(judgement.verdicts)) {
        auto wrong = describe(*first, input->files, reading, judgement.verdicts.at(first->x, first->y).mistake(),
                              request.progress);
        if (!wrong) return wrong.error();
        answer.firstWrong = *std::move(wrong);
    }
    // Where nothing was drawn the causes are the mistakes that would draw nothing, too.
    const bool diagnosed = request.diagnoses && judgement.wrong.total() > 0
                           && (answer.plight == Plight::None || answer.plight == Plight::NothingDrawn);
    if (diagnosed) {
        const auto view = m_kept->viewOf(truth.camera, truth.culling, request.subpixelBits, request.progress);
        if (!view) return view.error();
        const auto spoilt = [&](const Pipeline& pipeline) -> Result<const SpoiltPicture*> {
            const auto [kept, isNew] = (*view)->spoilt.try_emplace(nameOf(pipeline));
            if (!isNew) return &kept->second;
            const auto drawnSoFar = static_cast<double>((*view)->spoilt.size());
            request.progress.at(drawnSoFar / (drawnSoFar + static_cast<double>(causeEntries().size())), "causes");
            auto drawn = drawSpoilt(truth, pipeline, request.progress);
            if (!drawn) {
                (*view)->spoilt.erase(kept);
                return drawn.error();
            }
            kept->second = *std::move(drawn);
            return &kept->second;
        };
        auto causes = causesOf(shown, judgement, truth, spoilt);
        if (!causes) return causes.error();
        answer.causes = *std::move(causes);
        if (answer.causes.empty()) answer.clusters = clustersOf(judgement, truth);
    }
    answer.verdicts = std::move(judgement.verdicts);
    answer.sentence = sentenceOf(answer, diagnosed);
    answer.truth    = reading.truth;
    answer.shown    = std::move(best.shown);
    return answer;
}

Result<TraceAnswer> Checker::checkTrace(const CheckRequest& request, const Trace& trace, const Pipeline& pipeline)
{
    std::optional<Dump> dump;
    if (!request.camera && !request.matrix && request.dump) {
        Result<Dump> read = readDump(*request.dump);
        if (!read) return read.error();
        dump = *std::move(read);
    }
    const auto cameras = camerasFor(request, dump);
    if (!cameras) return cameras.error();
    std::optional<TraceAnswer> best;
    for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
        if (request.given.cull && *request.given.cull != culling) continue;
        const DrawRequest   drawn{.scene       = m_kept->scene,
                                  .camera      = cameras->front(),
                                  .faceCulling = culling,
                                  .pipeline    = pipeline,
                                  .cancel      = request.progress.cancel};
        Result<TraceAnswer> answer = judgeTrace(trace, drawn, halfStepOf(request.subpixelBits));
        if (!answer) return answer.error();
        if (!best || (answer->firstWrong && *answer->firstWrong > *best->firstWrong) || answer->isRight())
            best = *std::move(answer);
        if (best->isRight()) break;
    }
    return *std::move(best);
}

}  // namespace zscope::check
