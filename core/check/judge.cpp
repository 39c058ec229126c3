#include "core/check/judge.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

#include "core/check/exact_triangle.h"
#include "core/measure/definition.h"
#include "core/measure/error_figures.h"

namespace zscope::check {
namespace {

constexpr double kFloat32Step = 0x1p-23;  // relative, at most

TriangleId triangleOf(std::int64_t id) { return TriangleId{static_cast<std::uint32_t>(id)}; }

bool isEquallyNear(const Place& a, const Place& b)
{
    return std::abs(a.depth - b.depth) <= 2 * kFloat32Step * std::max(a.depth, b.depth);
}

/// Depths that a careful renderer may have the other way round.
bool isTie(const Place& a, const Place& b)
{
    const double moved = a.slack + b.slack + 4 * kFloat32Step * (a.depth + b.depth);
    return isEquallyNear(a, b) || std::abs(a.depth - b.depth) <= moved;
}

/// The far plane may or may not keep it.
bool isAtFar(const Place& place, const Camera& camera)
{
    const double far = camera.near / camera.far;
    return std::abs(place.depth - far) <= place.slack + 4 * kFloat32Step * far;
}

class PixelJudge {
public:
    PixelJudge(const Shown& shown, const Truth& truth)
        : m_shown(shown), m_truth(truth), m_scale(truth.camera, shown.meaning)
    {}

    Verdict at(int x, int y) const
    {
        const std::int64_t id        = m_truth.picture.ids.at(x, y);
        const bool         isCovered = id >= 0, isShown = m_shown.covered.at(x, y) != 0;
        if (!isCovered && !isShown) return {};
        if (isCovered && !isShown) return judged(Mistake::Hole, !m_shown.isEmpty && mayBeMissing(id, x, y));
        if (!isCovered) return judged(Mistake::Spill, m_shown.ids && mayReach(m_shown.ids->at(x, y), x, y));
        if (m_shown.ids && !isSameSurface(id, m_shown.ids->at(x, y)))
            return judged(Mistake::WrongSurface, mayBeSeenInstead(m_shown.ids->at(x, y), id, x, y));
        return m_shown.depth ? depthAt(x, y) : Verdict{};
    }

    /// The depth that the file has there could be that of a triangle at this place.
    bool hasDepthOf(const Place& place, int x, int y) const
    {
        if (!m_shown.depth) return true;
        const DepthValue value = m_scale.of(place.depth, x, y);
        const double     most  = toleranceOf(value, place.depth, place.slack, m_shown.resolution);
        return std::abs(m_shown.depth->at(x, y) - value.value) <= most;
    }

    /// Of a pixel with another surface: the file's is exactly as near as the reference's.
    bool isTieOfDepth(int x, int y) const
    {
        const Place right = exactly(m_truth.picture.ids.at(x, y)).placeOf(x, y);
        bool        is    = false;
        forEachShown(m_shown.ids->at(x, y), x, y,
                     [&](const Place& place) { is |= place.isPossible && isEquallyNear(place, right); });
        return is;
    }

    ExactTriangle exactly(std::int64_t id) const
    {
        return ExactTriangle(m_truth.scene->scene(), m_truth.camera, triangleOf(id), m_truth.halfStep);
    }
    bool isDrawn(const ExactTriangle& triangle) const
    {
        return !triangle.isEmpty() && !(m_truth.culling == FaceCulling::Back && triangle.isSurelyBack());
    }

private:
    static Verdict judged(Mistake mistake, bool isRounding)
    {
        return isRounding ? Verdict::rounding(mistake) : Verdict::wrong(mistake);
    }

    bool isSameSurface(std::int64_t id, std::int64_t shown) const
    {
        if (m_shown.kind == IdKind::Faces) return m_truth.faces.faceOf(id) == shown;
        return isTriangle(shown) && m_truth.faces.areOneSurface(id, shown);
    }
    bool isTriangle(std::int64_t id) const
    {
        return id >= 0 && id < static_cast<std::int64_t>(m_truth.scene->scene().triangleCount());
    }

    Verdict depthAt(int x, int y) const
    {
        const double     depth = m_truth.picture.depth.at(x, y), found = m_shown.depth->at(x, y);
        const DepthValue value = m_scale.of(depth, x, y);
        const double     off   = std::abs(found - value.value);
        const double exact = m_shown.resolution.at(value.value) + kFloat32Step * (value.terms + value.slope * depth);
        if (off <= exact) return {};
        const double most = toleranceOf(value, depth, m_truth.slack.at(x, y), m_shown.resolution);
        return judged(Mistake::WrongDepth, off <= most);
    }

    bool mayBeMissing(std::int64_t id, int x, int y) const
    {
        const Place place = exactly(id).placeOf(x, y);
        return !place.isCertain || isAtFar(place, m_truth.camera);
    }

    /// Calls use(place) for the triangles that the id of the file stands for.
    template <class Use>
    void forEachShown(std::int64_t shown, int x, int y, const Use& use) const
    {
        std::pair<std::int64_t, std::int64_t> range{shown, shown + 1};
        if (m_shown.kind == IdKind::Faces) {
            if (shown < 0 || shown >= m_truth.faces.count()) return;
            range = m_truth.faces.trianglesOf(shown);
        } else if (!isTriangle(shown)) {
            return;
        }
        for (std::int64_t id = range.first; id < range.second; ++id)
            if (const ExactTriangle triangle = exactly(id); isDrawn(triangle)) use(triangle.placeOf(x, y));
    }

    /// Of a pixel that the reference leaves empty.
    bool mayReach(std::int64_t shown, int x, int y) const
    {
        bool may = false;
        forEachShown(shown, x, y, [&](const Place& place) {
            may |= place.isNearEdge() || (place.isPossible && isAtFar(place, m_truth.camera));
        });
        return may;
    }

    bool mayBeSeenInstead(std::int64_t shown, std::int64_t id, int x, int y) const
    {
        const Place right = exactly(id).placeOf(x, y);
        bool        may   = false;
        forEachShown(shown, x, y, [&](const Place& place) {
            if (!place.isPossible) return;
            const bool isNearer = place.depth > right.depth;
            may |= isTie(place, right) || (isNearer ? place.isNearEdge() : !right.isCertain)
                   || isAtFar(isNearer ? place : right, m_truth.camera);
        });
        return may;
    }

    const Shown& m_shown;
    const Truth& m_truth;
    DepthScale   m_scale;
};

/// Files without ids: which of the wrong pixels some triangle explains that may be seen there. Every triangle is placed
/// once, against the wrong pixels in its box.
void explainByAnyTriangle(const PixelJudge& judge, const Truth& truth, Grid<Verdict>& verdicts)
{
    const int                 width = truth.camera.width;
    std::vector<int>          rowStart{0}, columns;  // the pixels to explain, row by row
    std::vector<Place>        right;                 // of the reference's triangle there; none: empty
    std::vector<std::uint8_t> explained;
    for (int y = 0; y < truth.camera.height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Verdict verdict = verdicts.at(x, y);
            if (!verdict.isWrong() || verdict.mistake() == Mistake::Hole) continue;
            const std::int64_t id = truth.picture.ids.at(x, y);
            columns.push_back(x);
            right.push_back(id < 0 ? Place{} : judge.exactly(id).placeOf(x, y));
        }
        rowStart.push_back(static_cast<int>(columns.size()));
    }
    if (columns.empty()) return;
    explained.assign(columns.size(), 0);
    const auto triangles = static_cast<std::int64_t>(truth.scene->scene().triangleCount());
    const auto explains  = [&](const Place& place, const Place& shown) {
        const bool isEmpty  = shown.depth == 0;
        const bool isNearer = isEmpty || place.depth > shown.depth;
        return (isNearer ? place.isNearEdge() : !shown.isCertain) || (!isEmpty && isTie(place, shown))
               || isAtFar(isNearer ? place : shown, truth.camera);
    };
#pragma omp parallel for schedule(dynamic, 1024)
    for (std::int64_t id = 0; id < triangles; ++id) {
        const ExactTriangle triangle = judge.exactly(id);
        if (!judge.isDrawn(triangle)) continue;
        const ExactTriangle::Box box = triangle.box();
        for (int y = box.y0; y <= box.y1; ++y) {
            const auto row = static_cast<std::size_t>(y), end = static_cast<std::size_t>(rowStart[row + 1]);
            for (auto i = static_cast<std::size_t>(rowStart[row]); i < end; ++i) {
                if (columns[i] < box.x0 || columns[i] > box.x1) continue;
                const Place place = triangle.placeOf(columns[i], y);
                if (place.isPossible && judge.hasDepthOf(place, columns[i], y) && explains(place, right[i]))
                    std::atomic_ref(explained[i]).store(1, std::memory_order_relaxed);
            }
        }
    }
    for (int y = 0; y < truth.camera.height; ++y)
        for (auto i = static_cast<std::size_t>(rowStart[static_cast<std::size_t>(y)]);
             i < static_cast<std::size_t>(rowStart[static_cast<std::size_t>(y) + 1]); ++i)
            if (Verdict& verdict = verdicts.at(columns[i], y); explained[i] != 0)
                verdict = Verdict::rounding(verdict.mistake());
}

/// The sample lies on a side of the triangle as the reference snaps it.
bool isOnEdge(const Truth& truth, const definition::View& view, std::int64_t id, int x, int y)
{
    const Scene&                  scene    = truth.scene->scene();
    const InstanceId              instance = scene.instanceOf(triangleOf(id));
    std::vector<definition::Part> parts;
    definition::partsOf(scene, instance, triangleOf(id).value - scene.firstTriangle[instance.value], view, parts);
    return std::ranges::any_of(parts, [&](const definition::Part& part) {
        return part.box().holds(x, y) && std::ranges::any_of(part.sides(), [&](const definition::Side& s) {
                   return s.at(x, y) + s.bias == 0;
               });
    });
}

std::uint64_t countTies(const PixelJudge& judge, const Grid<Verdict>& verdicts)
{
    std::uint64_t count = 0;
    for (int y = 0; y < verdicts.height(); ++y)
        for (int x = 0; x < verdicts.width(); ++x) {
            const Verdict verdict = verdicts.at(x, y);
            if (verdict.isRounding() && verdict.mistake() == Mistake::WrongSurface) count += judge.isTieOfDepth(x, y);
        }
    return count;
}

std::uint64_t countOnEdges(const Shown& shown, const Truth& truth, const Grid<Verdict>& verdicts)
{
    const definition::View view(truth.camera, FaceCulling::None);
    std::uint64_t          count = 0;
    for (int y = 0; y < truth.camera.height; ++y)
        for (int x = 0; x < truth.camera.width; ++x) {
            const Verdict verdict = verdicts.at(x, y);
            if (!verdict.isRounding() || verdict.mistake() == Mistake::WrongDepth) continue;
            const std::int64_t id  = truth.picture.ids.at(x, y);
            const std::int64_t own = shown.ids && shown.kind == IdKind::Triangles ? shown.ids->at(x, y) : -1;
            const bool isTriangle  = own >= 0 && own < static_cast<std::int64_t>(truth.scene->scene().triangleCount());
            count += (id >= 0 && isOnEdge(truth, view, id, x, y)) || (isTriangle && isOnEdge(truth, view, own, x, y));
        }
    return count;
}

}  // namespace

std::string_view wordOf(Mistake mistake)
{
    constexpr std::array<std::string_view, 4> kWords{"hole", "spill", "wrong_surface", "wrong_depth"};
    return kWords[static_cast<std::size_t>(mistake)];
}

Shown shownBy(const Foreign& files, const Reading& reading)
{
    const Camera& camera   = reading.truth->camera;
    const bool    isTurned = reading.conventions.rows == Rows::BottomUp;
    const auto    rowOf    = [&](int y) { return isTurned ? camera.height - 1 - y : y; };
    Shown         shown;
    shown.covered.reset(camera.width, camera.height);
    if (files.depth) {
        shown.meaning    = reading.conventions.depth.value_or(DepthMeaning::NearOverZ);
        shown.resolution = files.depth->resolution;
        shown.depth.emplace(camera.width, camera.height);
    }
    if (files.ids) {
        shown.kind = reading.conventions.ids.value_or(IdKind::Triangles);
        shown.ids.emplace(camera.width, camera.height);
    }
    shown.isEmpty  = files.ids ? reading.areIdsEmpty : files.depth ? reading.isDepthEmpty : reading.isPictureEmpty;
    const int from = reading.conventions.idsFrom.value_or(0);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const int  row     = rowOf(y);
            const bool hasNoId = files.ids && files.ids->values.at(x, row) == reading.idBackground;
            const bool hasNoDepth =
                files.depth && isBackground(files.depth->values.at(x, row), reading.depthBackground);
            if (files.depth) shown.depth->at(x, y) = files.depth->values.at(x, row);
            if (files.ids)
                shown.ids->at(x, y) = hasNoId ? -1 : std::max<std::int64_t>(files.ids->values.at(x, row) - from, -2);
            const bool isEmpty     = files.ids     ? hasNoId
                                     : files.depth ? hasNoDepth
                                                   : files.picture->at(x, row) == reading.pictureBackground;
            shown.covered.at(x, y) = !isEmpty;
        }
    return shown;
}

Judgement judge(const Shown& shown, const Truth& truth)
{
    const PixelJudge judge(shown, truth);
    Judgement        judgement;
    judgement.verdicts.reset(truth.camera.width, truth.camera.height);
#pragma omp parallel for schedule(dynamic)
    for (int y = 0; y < truth.camera.height; ++y)
        for (int x = 0; x < truth.camera.width; ++x) judgement.verdicts.at(x, y) = judge.at(x, y);
    if (!shown.ids) explainByAnyTriangle(judge, truth, judgement.verdicts);
    for (const Verdict verdict : judgement.verdicts.values()) {
        if (verdict.isWrong()) ++judgement.wrong.of(verdict.mistake());
        if (verdict.isRounding()) ++judgement.rounding.of(verdict.mistake());
    }
    judgement.onEdges = countOnEdges(shown, truth, judgement.verdicts);
    if (shown.ids) judgement.ties = countTies(judge, judgement.verdicts);
    return judgement;
}

std::uint64_t backFacesIn(const Shown& shown, const Truth& truth)
{
    if (!shown.ids || shown.kind != IdKind::Triangles) return 0;
    const auto    triangles = static_cast<std::int64_t>(truth.scene->scene().triangleCount());
    std::uint64_t count     = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : count)
    for (int y = 0; y < truth.camera.height; ++y)
        for (const std::int64_t id : shown.ids->view().row(y))
            if (id >= 0 && id < triangles)
                count +=
                    ExactTriangle(truth.scene->scene(), truth.camera, triangleOf(id), truth.halfStep).isSurelyBack();
    return count;
}

}  // namespace zscope::check
