// What a judgement says in plain English. Every sentence stands by itself, so that each can be translated by itself.
#include <fmt/format.h>

#include "core/base/grouped.h"
#include "core/check/check.h"

namespace zscope::check {
namespace {

/// "holes: 3, spills: 1, ...", in one form for every number.
std::string kindsOf(const MistakeCounts& counts)
{
    const auto count = [&](Mistake mistake) { return grouped(counts.of(mistake), ','); };
    return fmt::format("holes: {}, spills: {}, wrong surfaces: {}, wrong depths: {}", count(Mistake::Hole),
                       count(Mistake::Spill), count(Mistake::WrongSurface), count(Mistake::WrongDepth));
}

std::string roundingOf(const CheckAnswer& answer)
{
    const std::uint64_t rounding = answer.rounding.total();
    if (rounding == 0) return {};
    std::string text = rounding == 1
                           ? std::string(" Rounding alone explains 1 other difference.")
                           : fmt::format(" Rounding alone explains {} other differences.", grouped(rounding, ','));
    if (answer.isRight())
        text = rounding == 1 ? std::string(" 1 pixel differs, by rounding alone.")
                             : fmt::format(" {} pixels differ, all of them by rounding alone.", grouped(rounding, ','));
    if (answer.looksLikeFillRule)
        text += " Most of them lie exactly on an edge: the fill rule is not the top-left rule.";
    if (answer.looksLikeTies)
        text += " Most of them are ties: at equal depth another triangle was kept than the one with the lowest id.";
    return text;
}

std::string causeOf(const Cause& cause)
{
    std::string text = fmt::format(" {} of the wrong pixels are those of '{}' ({}).", percentText(cause.explains),
                                   cause.title, cause.name);
    if (cause.adds > 0)
        text += cause.adds == 1 ? std::string(" That mistake would spoil 1 more pixel.")
                                : fmt::format(" That mistake would spoil {} more pixels.", grouped(cause.adds, ','));
    if (!cause.lesson.empty()) text += fmt::format(" Lesson {} teaches it.", cause.lesson);
    return text;
}

/// What is the matter where no cause is looked for: it comes first.
std::string plightOf(const CheckAnswer& answer)
{
    switch (answer.plight) {
        case Plight::None:
            break;
        case Plight::NothingDrawn:
            return "Nothing was drawn: the files hold background alone. Perhaps a function is still empty, or nothing "
                   "passes the depth test. ";
        case Plight::NoIds:
            return fmt::format("The depths are right, and every id is {}: the ids are not stored. ", answer.noId);
        case Plight::UpsideDown:
            if (answer.wrongTurned == 0)
                return "The picture is upside down: with its rows in the other order it is right. ";
            return fmt::format(
                "The picture is upside down: with its rows in the other order few of its pixels are wrong ({}). ",
                grouped(answer.wrongTurned, ','));
    }
    return {};
}

}  // namespace

std::string percentText(double share) { return fmt::format("{:.1f} %", share * 100); }

std::string sentenceOf(const CheckAnswer& answer, bool diagnosed)
{
    const std::string covered = grouped(answer.covered, ',');
    if (answer.isRight())
        return (answer.rounding.total() == 0
                    ? fmt::format("Nothing is wrong: the reference covers {} pixels.", covered)
                    : fmt::format("Right up to rounding: the reference covers {} pixels.", covered))
               + roundingOf(answer);
    std::string         text  = plightOf(answer);
    const std::uint64_t wrong = answer.wrong.total();
    text += wrong == 1 ? fmt::format("1 pixel is wrong ({}); the reference covers {}.", kindsOf(answer.wrong), covered)
                       : fmt::format("{} pixels are wrong ({}); the reference covers {}.", grouped(wrong, ','),
                                     kindsOf(answer.wrong), covered);
    text += roundingOf(answer);
    if (!diagnosed || answer.plight != Plight::None) return text;
    if (!answer.causes.empty()) return text + causeOf(answer.causes.front());
    text += " No known mistake fits: none explains a fifth of the wrong pixels.";
    if (!answer.clusters.empty()) {
        const Cluster& cluster = answer.clusters.front();
        text += fmt::format(" {} of them lie {}, where {} of the covered pixels lie.", percentText(cluster.share),
                            cluster.where, percentText(cluster.usual));
    }
    return text;
}

}  // namespace zscope::check
