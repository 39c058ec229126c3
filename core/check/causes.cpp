#include "core/check/causes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <new>

#include "core/frame/faults.h"
#include "core/frame/renderer.h"

namespace zscope::check {
namespace {

struct Lesson {
    std::string_view cause, lesson;
};
constexpr std::array kLessons{
    Lesson{"first-line-rounded", "13-holes-and-fill-rules"},
    Lesson{"x-truncated", "13-holes-and-fill-rules"},
    Lesson{"one-test-per-interval", "06-two-polygons-that-cross"},
    Lesson{"nearest-in-cells", "07-the-pyramid"},
    Lesson{"corners-only", "08-asking-the-pyramid"},
    Lesson{"far-first", "10-octree-front-to-back"},
    Lesson{"depth-numbers=accumulated", "04-depth-along-a-span"},
    Lesson{"depth-format=float32-standard", "14-depth-that-lies"},
    Lesson{"depth-format=fixed-16", "14-depth-that-lies"},
    Lesson{"half-pixel", "16-five-common-mistakes"},
    Lesson{"box-short", "16-five-common-mistakes"},
    Lesson{"winding-flipped", "16-five-common-mistakes"},
    Lesson{"linear-z", "16-five-common-mistakes"},
    Lesson{"painter-order", "16-five-common-mistakes"},
    Lesson{"snap=4-bits", "15-speed-against-error"},
};

std::string_view lessonOf(std::string_view cause)
{
    const auto found = std::ranges::find(kLessons, cause, &Lesson::cause);
    return found == kLessons.end() ? std::string_view() : found->lesson;
}

/// Axes of approximations that concern numbers.
constexpr std::array<std::string_view, 5> kNumbers{"snap", "vertices", "depth-numbers", "depth-format", "edges"};

/// No preset, but what most students write: in file order each triangle is asked about and drawn.
constexpr Pipeline kTriangleByTriangle{.cull = Cull::Triangles, .upkeep = Upkeep::OnQuery};

/// Pictures of a preset do not depend on what came before, so one frame shows the mistake.
bool isOfOneFrame(const Preset& preset)
{
    return preset.pipeline.coherence == Coherence::None && preset.pipeline.chooser == Chooser::Composed
           && hasFastText(preset.pipeline);
}

/// The gallery's own preset comes first.
std::vector<Pipeline> pipelinesOf(const CauseEntry& cause, std::string_view first)
{
    std::vector<Pipeline> pipelines;
    const auto            add = [&](const Pipeline& pipeline) {
        if (const auto with = cause.addedTo(pipeline)) pipelines.push_back(*with);
    };
    add(findPreset(first)->pipeline);
    if (!cause.addedTo(findPreset("zbuffer")->pipeline)) add(kTriangleByTriangle);
    for (const Preset& preset : presets())
        if (isOfOneFrame(preset) && preset.name != first) add(preset.pipeline);
    return pipelines;
}

/// Of an approximation one pipeline is enough: its picture does not depend on the method.
std::vector<Pipeline> pipelinesOf(const CauseEntry& cause)
{
    for (const Preset& preset : presets())
        if (isOfOneFrame(preset))
            if (const auto with = cause.addedTo(preset.pipeline)) return {*with};
    return {};
}

std::vector<CauseEntry> allCauses()
{
    std::vector<CauseEntry> causes;
    for (const FaultEntry& entry : faults()) {
        CauseEntry cause{.name   = std::string(entry.word),
                         .title  = std::string(entry.title),
                         .lesson = lessonOf(entry.word),
                         .fault  = entry.fault};
        cause.pipelines = pipelinesOf(cause, entry.preset);
        causes.push_back(std::move(cause));
    }
    for (const AxisEntry& axis : axes()) {
        if (std::ranges::find(kNumbers, axis.word) == kNumbers.end()) continue;
        for (const ChoiceEntry& choice : axis.choices.subspan(1)) {
            CauseEntry cause{.name   = std::string(axis.word) + "=" + std::string(choice.word),
                             .title  = std::string(choice.title),
                             .lesson = {},
                             .axis   = axis.word,
                             .choice = choice.word};
            cause.lesson    = lessonOf(cause.name);
            cause.pipelines = pipelinesOf(cause);
            if (!cause.pipelines.empty()) causes.push_back(std::move(cause));
        }
    }
    return causes;
}

}  // namespace

std::optional<Pipeline> CauseEntry::addedTo(Pipeline pipeline) const
{
    if (fault != Fault::None) {
        pipeline.fault.add(fault);
    } else {
        const Result<Pipeline> with = withChoice(pipeline, axis, choice);
        if (!with) return std::nullopt;
        pipeline = *with;
    }
    if (explainInvalid(pipeline)) return std::nullopt;
    return pipeline;
}

CauseEntry pairOf(const CauseEntry& a, const CauseEntry& b)
{
    CauseEntry        pair{.name   = a.name + " + " + b.name,
                           .title  = a.title + "' and '" + b.title,
                           .lesson = a.lesson.empty() ? b.lesson : a.lesson};
    const CauseEntry &base = a.fault != Fault::None ? a : b, &other = a.fault != Fault::None ? b : a;
    for (const Pipeline& pipeline : base.pipelines)
        if (const auto with = other.addedTo(pipeline)) pair.pipelines.push_back(*with);
    return pair;
}

const std::vector<CauseEntry>& causeEntries()
{
    static const std::vector<CauseEntry> kCauses = allCauses();
    return kCauses;
}

Result<SpoiltPicture> drawSpoilt(const Truth& truth, const Pipeline& pipeline, const Progress& progress)
try {
    Renderer    renderer;
    Frame       frame;
    DrawRequest request{.scene       = truth.scene,
                        .camera      = truth.camera,
                        .faceCulling = truth.culling,
                        .pipeline    = pipeline,
                        .shade       = false,
                        .cancel      = progress.cancel};
    if (const auto drawn = renderer.draw(request, frame); !drawn) return drawn.error();
    Picture picture = pictureOf(frame.visible);

    Shown shown;
    shown.covered.reset(truth.camera.width, truth.camera.height);
    std::ranges::transform(picture.ids.values(), shown.covered.values().begin(),
                           [](std::int64_t id) { return static_cast<std::uint8_t>(id >= 0); });
    const bool byFace = drawsFaces(pipeline);
    if (byFace)
        for (std::int64_t& id : picture.ids.values())
            if (id >= 0) id = truth.faces.faceOf(id);
    shown.kind                = byFace ? IdKind::Faces : IdKind::Triangles;
    shown.ids                 = picture.ids;
    const Judgement judgement = judge(shown, truth);

    constexpr std::int32_t kSteps = 2;  // fewer are no difference
    SpoiltPicture          spoilt;
    for (std::uint32_t i = 0; i < picture.ids.values().size(); ++i) {
        const Verdict verdict = judgement.verdicts.values()[i];
        const float   depth = picture.depth.values()[i], right = truth.picture.depth.values()[i];
        const auto    steps = std::bit_cast<std::int32_t>(depth) - std::bit_cast<std::int32_t>(right);
        if (verdict.isSame() && steps >= -kSteps && steps <= kSteps) continue;
        std::int64_t id = picture.ids.values()[i];
        if (byFace && id >= 0)
            id = verdict.isSame() ? truth.picture.ids.values()[i] : truth.faces.trianglesOf(id).first;
        spoilt.push_back({i, verdict, id, depth});
    }
    return spoilt;
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "a picture with a mistake does not fit into memory"};
}

}  // namespace zscope::check
