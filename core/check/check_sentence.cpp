// What a judgement says in plain English. Every sentence stands by itself, so that each can be translated by itself.
#include <cmath>

#include <fmt/format.h>

#include "core/base/grouped.h"
#include "core/check/check.h"

namespace zscope::check {
namespace {

std::string counted(std::uint64_t count, std::string_view one, std::string_view many)
{
    return fmt::format("{} {}", grouped(count, ','), count == 1 ? one : many);
}

int percentOf(double share) { return static_cast<int>(std::floor(share * 100)); }

/// "3 holes, 1 spill"
std::string kindsOf(const MistakeCounts& counts)
{
    std::string text;
    const auto  add = [&](Mistake mistake, std::string_view one, std::string_view many) {
        if (counts.of(mistake) > 0) text += (text.empty() ? "" : ", ") + counted(counts.of(mistake), one, many);
    };
    add(Mistake::Hole, "hole", "holes");
    add(Mistake::Spill, "spill", "spills");
    add(Mistake::WrongSurface, "wrong surface", "wrong surfaces");
    add(Mistake::WrongDepth, "wrong depth", "wrong depths");
    return text;
}

std::string roundingOf(const CheckAnswer& answer)
{
    const std::uint64_t rounding = answer.rounding.total();
    if (rounding == 0) return {};
    std::string text = rounding == 1
                           ? std::string(" Rounding alone explains 1 other difference.")
                           : fmt::format(" Rounding alone explains {} other differences.", grouped(rounding, ','));
    if (answer.isRight())
        text = rounding == 1
                   ? std::string(" Rounding alone explains the 1 pixel that differs.")
                   : fmt::format(" Rounding alone explains the {} pixels that differ.", grouped(rounding, ','));
    if (answer.looksLikeFillRule)
        text += " Most of them lie exactly on an edge: the fill rule is not the top-left rule.";
    return text;
}

std::string causeOf(const Cause& cause)
{
    std::string text = fmt::format(" {} % of the wrong pixels are those of '{}' ({}).", percentOf(cause.explains),
                                   cause.title, cause.name);
    if (cause.adds > 0)
        text += cause.adds == 1 ? std::string(" That mistake would spoil 1 more pixel.")
                                : fmt::format(" That mistake would spoil {} more pixels.", grouped(cause.adds, ','));
    if (!cause.lesson.empty()) text += fmt::format(" Lesson {} teaches it.", cause.lesson);
    return text;
}

}  // namespace

std::string sentenceOf(const CheckAnswer& answer, bool diagnosed)
{
    const std::string covered = grouped(answer.covered, ',');
    if (answer.isRight())
        return fmt::format("Nothing is wrong: the reference covers {} pixels.", covered) + roundingOf(answer);
    std::string text;
    const auto& c = answer.conventions;
    if (!c.rows && answer.wrong.of(Mistake::Hole) == answer.wrong.total()) text = "The files hold background alone. ";
    const std::uint64_t wrong = answer.wrong.total();
    text += wrong == 1 ? fmt::format("1 pixel is wrong ({}); the reference covers {}.", kindsOf(answer.wrong), covered)
                       : fmt::format("{} pixels are wrong ({}); the reference covers {}.", grouped(wrong, ','),
                                     kindsOf(answer.wrong), covered);
    text += roundingOf(answer);
    if (!diagnosed) return text;
    if (!answer.causes.empty()) return text + causeOf(answer.causes.front());
    text += " No mistake of the gallery explains a fifth of the wrong pixels.";
    if (!answer.clusters.empty()) {
        const Cluster& cluster = answer.clusters.front();
        text += fmt::format(" {} % of them lie {}, where {} % of the covered pixels lie.", percentOf(cluster.share),
                            cluster.where, percentOf(cluster.usual));
    }
    return text;
}

}  // namespace zscope::check
