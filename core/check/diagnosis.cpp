#include "core/check/diagnosis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check/exact_triangle.h"

namespace zscope::check {
namespace {

constexpr double kLeastShare = 0.2;  // of explained / (wrong + adds): what is below is no cause
constexpr double kGoodEnough = 0.9;  // of explained / (wrong + adds): other presets are not tried any more

class Comparison {
public:
    Comparison(const Shown& shown, const Judgement& judgement, const Truth& truth)
        : m_shown(shown), m_judgement(judgement), m_truth(truth), m_scale(truth.camera, shown.meaning)
    {}

    struct Counts {
        std::uint64_t explained = 0, adds = 0;
        std::uint64_t addsDepth = 0;  // of them: only the depth would be wrong
    };
    Counts of(const SpoiltPicture& picture) const
    {
        Counts counts;
        for (const SpoiltPixel& spoilt : picture) {
            const Verdict verdict = m_judgement.verdicts.values()[spoilt.pixel];
            if (verdict.isWrong())
                counts.explained += isExplained(verdict.mistake(), spoilt);
            else if ((verdict.isSame() || !isExplained(verdict.mistake(), spoilt)) && wouldBeWrong(spoilt)) {
                ++counts.adds;
                counts.addsDepth += spoilt.verdict.isSame();
            }
        }
        return counts;
    }

private:
    int xOf(const SpoiltPixel& s) const { return static_cast<int>(s.pixel) % m_truth.camera.width; }
    int yOf(const SpoiltPixel& s) const { return static_cast<int>(s.pixel) / m_truth.camera.width; }

    bool isExplained(Mistake mistake, const SpoiltPixel& spoilt) const
    {
        const bool shows = spoilt.id >= 0;
        switch (mistake) {
            case Mistake::Hole:
                return !shows;
            case Mistake::Spill:
                return shows && hasSameId(spoilt);
            case Mistake::WrongSurface:
                return shows && !spoilt.verdict.isSame() && hasSameId(spoilt);
            case Mistake::WrongDepth:
                break;
        }
        return shows && (!m_shown.ids || spoilt.verdict.isSame()) && hasSameDepth(spoilt);
    }

    bool hasSameId(const SpoiltPixel& spoilt) const
    {
        if (!m_shown.ids) return true;
        const std::int64_t shown = m_shown.ids->values()[spoilt.pixel];
        return m_shown.kind == IdKind::Faces ? m_truth.faces.faceOf(spoilt.id) == shown : spoilt.id == shown;
    }

    bool hasSameDepth(const SpoiltPixel& spoilt) const
    {
        const int        x = xOf(spoilt), y = yOf(spoilt);
        const double     right = m_truth.picture.depth.at(x, y), found = m_shown.depth->at(x, y);
        const DepthValue value = m_scale.of(spoilt.depth, x, y);
        const double     off   = std::abs(found - m_scale.of(right, x, y).value);
        const double     most  = toleranceOf(value, spoilt.depth, m_truth.slack.at(x, y), m_shown.resolution);
        return std::abs(found - value.value) <= std::max(most, off / 4);
    }

    /// In what the files show.
    bool wouldBeWrong(const SpoiltPixel& spoilt) const
    {
        const std::size_t pixel = spoilt.pixel;
        const bool        shows = spoilt.id >= 0, isCovered = m_truth.isCovered(pixel);
        if (shows != isCovered) return spoilt.verdict.isWrong();
        if (m_shown.ids && !spoilt.verdict.isSame()) return spoilt.verdict.isWrong();
        if (!m_shown.depth || (!spoilt.verdict.isSame() && !spoilt.verdict.isWrong())) return false;
        const int        x = xOf(spoilt), y = yOf(spoilt);
        const double     right = m_truth.picture.depth.at(x, y);
        const DepthValue value = m_scale.of(right, x, y);
        const double     most  = toleranceOf(value, right, m_truth.slack.at(x, y), m_shown.resolution);
        return std::abs(m_scale.of(spoilt.depth, x, y).value - value.value) > most;
    }

    const Shown&     m_shown;
    const Judgement& m_judgement;
    const Truth&     m_truth;
    DepthScale       m_scale;
};

double ratioOf(const Cause& cause, std::uint64_t wrong)
{
    return static_cast<double>(cause.explained) / static_cast<double>(wrong + cause.adds);
}

/// Wrong pixels and covered ones, by place.
class PlaceCounts {
public:
    explicit PlaceCounts(std::string_view where) : m_where(where) {}

    void count(bool isHere, bool isWrong, bool isCovered)
    {
        m_wrong += isWrong, m_wrongHere += isWrong && isHere;
        m_all += isCovered, m_allHere += isCovered && isHere;
    }
    Cluster cluster() const
    {
        const auto share = [](std::uint64_t part, std::uint64_t whole) {
            return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
        };
        return {m_where, share(m_wrongHere, m_wrong), share(m_allHere, m_all)};
    }

private:
    std::string_view m_where;
    std::uint64_t    m_wrong = 0, m_wrongHere = 0, m_all = 0, m_allHere = 0;
};

/// The nearest depth that counts as far: a fifth of the covered pixels are farther.
float farDepthOf(const Truth& truth)
{
    std::vector<float> depths;
    for (std::size_t i = 0; i < truth.picture.depth.values().size(); ++i)
        if (truth.isCovered(i)) depths.push_back(truth.picture.depth.values()[i]);
    if (depths.empty()) return 0;
    const auto at = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 5);
    std::nth_element(depths.begin(), at, depths.end());
    return *at;
}

}  // namespace

Result<std::vector<Cause>> causesOf(const Shown& shown, const Judgement& judgement, const Truth& truth,
                                    const SpoiltSource& spoilt)
{
    const std::uint64_t wrong = judgement.wrong.total();
    if (wrong == 0) return std::vector<Cause>{};
    const Comparison comparison(shown, judgement, truth);
    /// What the entry explains, drawn by pipelines [first, end) of its own.
    const auto best = [&](const CauseEntry& entry, std::size_t first, std::size_t end) -> Result<std::optional<Cause>> {
        std::optional<Cause> found;
        for (std::size_t which = first; which < std::min(end, entry.pipelines.size()); ++which) {
            const auto picture = spoilt(entry.pipelines[which]);
            if (!picture) return picture.error();
            const auto [explained, adds, addsDepth] = comparison.of(**picture);
            const Cause tried{entry.name,
                              entry.title,
                              static_cast<double>(explained) / static_cast<double>(wrong),
                              explained,
                              adds,
                              addsDepth,
                              entry.lesson,
                              entry.pipelines[which]};
            if (!found || ratioOf(tried, wrong) > ratioOf(*found, wrong)) found = tried;
        }
        return found;
    };
    struct Tried {
        const CauseEntry* entry;
        Cause             cause;
    };
    std::vector<Tried> tried;
    for (const CauseEntry& entry : causeEntries()) {
        const auto cause = best(entry, 0, 1);
        if (!cause) return cause.error();
        tried.push_back({&entry, **cause});
    }
    const auto         ratio  = [&](const Tried& t) { return ratioOf(t.cause, wrong); };
    const auto         isGood = [&](const Tried& t) { return ratio(t) >= kGoodEnough; };
    std::vector<Cause> pairs;
    if (std::ranges::none_of(tried, isGood)) {
        for (Tried& t : tried) {
            const auto cause = best(*t.entry, 1, t.entry->pipelines.size());
            if (!cause) return cause.error();
            if (*cause && ratioOf(**cause, wrong) > ratio(t)) t.cause = **cause;
        }
        std::ranges::stable_sort(tried, std::greater{}, ratio);
        for (std::size_t i = 0; i < 3 && std::ranges::none_of(tried, isGood); ++i)
            for (std::size_t j = i + 1; j < 3; ++j) {
                const CauseEntry pair  = pairOf(*tried[i].entry, *tried[j].entry);
                const auto       cause = best(pair, 0, pair.pipelines.size());
                if (!cause) return cause.error();
                if (*cause && ratioOf(**cause, wrong) > ratio(tried[i])) pairs.push_back(**cause);
            }
    }
    std::vector<Cause> causes;
    for (Tried& t : tried) causes.push_back(std::move(t.cause));
    causes.insert(causes.end(), pairs.begin(), pairs.end());

    const bool hasWrongDepths = judgement.wrong.of(Mistake::WrongDepth) > 0;
    std::erase_if(causes, [&](const Cause& cause) {
        const std::uint64_t adds = hasWrongDepths ? cause.adds : cause.adds - cause.addsDepth;
        return static_cast<double>(cause.explained) < kLeastShare * static_cast<double>(wrong + adds);
    });
    std::ranges::stable_sort(causes, std::greater{}, [&](const Cause& cause) { return ratioOf(cause, wrong); });
    return causes;
}

std::vector<Cluster> clustersOf(const Judgement& judgement, const Truth& truth)
{
    const int   width = truth.camera.width, height = truth.camera.height;
    const auto& ids  = truth.picture.ids;
    const float far  = farDepthOf(truth);
    const auto  idAt = [&](int x, int y) { return x < 0 || y < 0 || x >= width || y >= height ? -2 : ids.at(x, y); };
    PlaceCounts edges("on edges of triangles"), lines("on first or last lines of triangles"),
        borders("beside left or right borders of triangles"), depths("in the farthest fifth of the depths"),
        faces("on faces of more than three corners"), nearPlane("on triangles that the near plane cuts");
    std::int64_t last      = -1;
    bool         isPolygon = false, isCut = false;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::int64_t id        = ids.at(x, y);
            const bool         isCovered = id >= 0, isWrong = judgement.verdicts.at(x, y).isWrong();
            if (!isCovered && !isWrong) continue;
            const bool side  = idAt(x - 1, y) != id || idAt(x + 1, y) != id;
            const bool above = idAt(x, y - 1) != id || idAt(x, y + 1) != id;
            if (isCovered && id != last) {
                last      = id;
                isPolygon = truth.faces.cornersOf(truth.faces.faceOf(id)) > 3;
                isCut = ExactTriangle(truth.scene->scene(), truth.camera, TriangleId{static_cast<std::uint32_t>(id)},
                                      truth.halfStep)
                            .isCutByNear();
            }
            edges.count(side || above, isWrong, isCovered);
            lines.count(above, isWrong, isCovered);
            borders.count(side, isWrong, isCovered);
            depths.count(isCovered && truth.picture.depth.at(x, y) <= far, isWrong, isCovered);
            faces.count(isCovered && isPolygon, isWrong, isCovered);
            nearPlane.count(isCovered && isCut, isWrong, isCovered);
        }
    std::vector<Cluster> clusters;
    for (const PlaceCounts& place : {nearPlane, faces, depths, lines, borders, edges}) {
        const Cluster cluster = place.cluster();
        if (cluster.share >= 0.5 && cluster.share >= 2 * cluster.usual) clusters.push_back(cluster);
    }
    std::ranges::stable_sort(clusters, std::greater{}, [](const Cluster& c) { return c.share - c.usual; });
    return clusters;
}

}  // namespace zscope::check
