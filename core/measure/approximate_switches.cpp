#include "core/measure/approximate_switches.h"

#include <optional>

namespace zscope {
namespace {

BenchAlgorithm named(const Pipeline& pipeline) { return {nameOf(pipeline), pipeline, claimOf(pipeline)}; }

/// `pipeline` with the switch, if that is an approximation and can run.
std::optional<Pipeline> switched(const Pipeline& pipeline, std::string_view axis, std::string_view choice)
{
    const Result<Pipeline> with = withChoice(pipeline, axis, choice);
    if (!with || !with->approximation.isAny() || explainInvalid(*with)) return {};
    return *with;
}

}  // namespace

std::vector<BenchAlgorithm> presetsToTime()
{
    std::vector<BenchAlgorithm> all;
    for (const Preset& preset : presets())
        if (!explainInvalid(preset.pipeline) && hasFastText(preset.pipeline))
            all.push_back({std::string(preset.name), preset.pipeline, preset.claim});
    return all;
}

std::vector<BenchAlgorithm> approximateSwitches(Pipeline base)
{
    base.approximation = {};
    base.fault         = {};
    base.transparency  = BlendOrder::Sorted;
    if (base.coherence == Coherence::LastPyramid) base.coherence = Coherence::None;

    std::vector<BenchAlgorithm> all{named(base)};
    for (const AxisEntry& axis : axes()) {
        for (const ChoiceEntry& choice : axis.choices) {
            std::optional<Pipeline> with = switched(base, axis.word, choice.word);
            for (const Preset& preset : presets())
                if (!with && hasFastText(preset.pipeline) && hasFastText(base))
                    with = switched(preset.pipeline, axis.word, choice.word);
            if (with) all.push_back(named(*with));
        }
    }
    return all;
}

}  // namespace zscope
