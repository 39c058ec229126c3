#include "core/measure/empty_picture.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/grouped.h"
#include "core/base/quotable.h"
#include "core/measure/reference_walk.h"
#include "core/scene/opacity.h"
#include "core/shade/colour_table.h"

namespace zscope {

using namespace definition;

namespace {

/// What keeps a triangle out of the picture; of two parts of one the later reason counts.
enum class Reason {
    BehindEye,
    BeforeNear,
    OutOfRange,
    NoArea,
    OutsideView,
    BeyondFar,
    BackFace,
    Hole,
    BetweenCentres,
    None,  // nothing does
};
constexpr std::size_t kReasons = 10;
using Counts                   = std::array<std::uint64_t, kReasons>;

std::size_t indexOf(Reason reason) { return static_cast<std::size_t>(reason); }

/// Where a part lies; None if a sample of it is kept.
Reason reasonOf(const Part& part, const View& view)
{
    const auto& [a, b, c]    = part.corners();
    const std::int64_t width = std::int64_t{256} * view.camera.width, height = std::int64_t{256} * view.camera.height;
    if (std::max({a.xs, b.xs, c.xs}) < 0 || std::min({a.xs, b.xs, c.xs}) > width || std::max({a.ys, b.ys, c.ys}) < 0
        || std::min({a.ys, b.ys, c.ys}) > height)
        return Reason::OutsideView;
    const int  right = view.camera.width - 1, bottom = view.camera.height - 1;
    const auto partsFromPicture = [&](const Side& side) {
        return side.at(0, 0) < 0 && side.at(right, 0) < 0 && side.at(0, bottom) < 0 && side.at(right, bottom) < 0;
    };
    if (std::ranges::any_of(part.sides(), partsFromPicture)) return Reason::OutsideView;
    const definition::PixelBox& box = part.box();
    if (static_cast<float>(std::max({a.depth, b.depth, c.depth})) < view.farDepth)
        return box.isEmpty() ? Reason::BetweenCentres : Reason::BeyondFar;

    Reason      reason    = Reason::BetweenCentres;
    const auto& sides     = part.sides();
    const auto  missesRow = [&](const Side& side, int y) { return side.at(box.x0, y) < 0 && side.at(box.x1, y) < 0; };
    for (int y = box.y0; y <= box.y1; ++y) {
        if (std::ranges::any_of(sides, [&](const Side& side) { return missesRow(side, y); })) continue;
        for (int x = box.x0; x <= box.x1; ++x) {
            if (std::ranges::any_of(sides, [&](const Side& side) { return side.at(x, y) < 0; })) continue;
            if (part.isHole(x, y)) {
                if (reason == Reason::BetweenCentres) reason = Reason::Hole;
                continue;
            }
            if (part.depth(x, y) >= view.farDepth) return Reason::None;
            reason = Reason::BeyondFar;
        }
    }
    return reason;
}

/// The walk over a scene that finds the reasons.
class Search {
public:
    /// `isDrawn`: the picture is known to be empty, so triangles that should be seen are counted like the others. Else
    /// the first of them ends the search.
    Search(const Scene& scene, const Camera& camera, FaceCulling faceCulling, bool isDrawn)
        : m_scene(scene), m_view(camera, faceCulling), m_bothSides(camera, FaceCulling::None), m_isDrawn(isDrawn),
          m_visible(scene.meshes.size()), m_boxes(scene.meshes.size()), m_whole(scene.instances.size())
    {
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) m_visible[i] = scene.meshes[i]->triangles.size();
        m_invisible = invisibleMaterialsOf(scene);
        for (const UsedMaterial& used : m_invisible) {
            const Mesh& mesh = *scene.meshes[used.mesh.value];
            for (std::size_t p = 0; p < mesh.polygonCount(); ++p)
                if (mesh.polygonMaterial[p] == used.material)
                    m_visible[used.mesh.value] -= mesh.firstTriangle[p + 1] - mesh.firstTriangle[p];
        }
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) m_boxes[i] = scene.meshes[i]->bounds();
    }

    /// False if it was cancelled, or if something is seen.
    bool run(const Progress& progress)
    {
        const Progress ours{.cancel = &m_stop};
        const auto     wanted = [this](InstanceId instance) { return !isDecided(instance); };
        const auto     count  = [&](std::uint32_t id, Fate fate, const std::vector<Part>& parts) {
            if (progress.cancelled()) m_stop = true;
            const InstanceId    instance = m_scene.instanceOf(TriangleId{id});
            const std::uint32_t triangle = id - m_scene.firstTriangle[instance.value];
            const Mesh&         mesh     = m_scene.meshOf(instance);
            const float         opacity  = mesh.materialOf(mesh.trianglePolygon[triangle]).opacity;
            if (opacity <= 0) return;
            const Reason reason = reasonOf(instance, triangle, fate, parts);
            ++m_counts[indexOf(reason)];
            if (reason != Reason::None) return;
            if (opacity < 1) ++m_faint;
            if (!m_isDrawn) m_stop = true;
        };
        return forEachTriangle(m_scene, m_view, ours, wanted, count).ok();
    }

    const std::vector<UsedMaterial>& invisible() const { return m_invisible; }
    std::uint64_t                    faint() const { return m_faint; }
    Counts                           counts() const
    {
        Counts counts{};
        for (std::size_t i = 0; i < kReasons; ++i) counts[i] = m_counts[i];
        for (std::size_t i = 0; i < m_whole.size(); ++i)
            if (const std::uint8_t whole = m_whole[i]; whole >= kFirstReason)
                counts[whole - kFirstReason] += m_visible[m_scene.instances[i].mesh.value];
        return counts;
    }

private:
    static constexpr std::uint8_t kUnknown = 0, kEach = 1, kFirstReason = 2;

    /// Whether its box gives one reason for all of its triangles.
    bool isDecided(InstanceId instance)
    {
        std::uint8_t whole = m_whole[instance.value];  // two threads may both find it: they find the same
        if (whole == kUnknown) {
            whole                   = wholeOf(instance);
            m_whole[instance.value] = whole;
        }
        return whole != kEach;
    }

    std::uint8_t wholeOf(InstanceId instance) const
    {
        const auto      reason = [](Reason r) { return static_cast<std::uint8_t>(kFirstReason + indexOf(r)); };
        const Instance& placed = m_scene.instances[instance.value];
        const Bounds&   box    = m_boxes[placed.mesh.value];
        if (m_visible[placed.mesh.value] == 0) return reason(Reason::None);  // 0 triangles of it are counted
        if (!reachOf(box, placed.toWorld, m_view).isEmpty()) return kEach;
        double        nearest = HUGE_VAL, farthest = -HUGE_VAL;
        std::size_t   left = 0, right = 0, above = 0, below = 0;  // corners of the box beyond each side of the view
        const Camera& camera = m_view.camera;
        for (int i = 0; i < 8; ++i) {
            const dvec3 corner{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                               i & 4 ? box.max.z : box.min.z};
            const double z = along(camera.forward, instance, corner);
            const double x = along(camera.right, instance, corner) * camera.focal * camera.height / camera.width;
            const double y = along(camera.up, instance, corner) * camera.focal;
            nearest        = std::min(nearest, z);
            farthest       = std::max(farthest, z);
            left += -z > x, right += x > z, above += y > z, below += -z > y;
        }
        if (farthest <= 0) return reason(Reason::BehindEye);
        if (nearest > 0 && farthest < camera.near) return reason(Reason::BeforeNear);
        const bool isBeside = left == 8 || right == 8 || above == 8 || below == 8;
        return isBeside && nearest >= camera.near ? reason(Reason::OutsideView) : kEach;
    }

    /// From the eye along an axis of the view.
    double along(const dvec3& axis, InstanceId instance, const dvec3& place) const
    {
        const dvec3 d = m_scene.instances[instance.value].toWorld(place) - m_view.camera.eye;
        return (axis.x * d.x + axis.y * d.y) + axis.z * d.z;
    }

    Reason reasonOf(InstanceId instance, std::uint32_t triangle, Fate fate, const std::vector<Part>& parts) const
    {
        if (fate == Fate::Drawn) return reasonOf(parts);
        std::vector<Part> blended;
        if (fate == Fate::Transparent) {
            transparentPartsOf(m_scene, instance, triangle, m_view, blended);
            if (!blended.empty()) return reasonOf(blended);
        }
        if (fate == Fate::Transparent || fate == Fate::Culled) {  // what would it be, seen from both sides?
            std::vector<Part> both;
            if (fate == Fate::Culled)
                partsOf(m_scene, instance, triangle, m_bothSides, both);
            else
                transparentPartsOf(m_scene, instance, triangle, m_bothSides, both);
            if (!both.empty()) {
                const Reason where = reasonOf(both);
                return where == Reason::OutsideView || where == Reason::BeyondFar ? where : Reason::BackFace;
            }
        }
        double      farthest = -HUGE_VAL;
        const Mesh& mesh     = m_scene.meshOf(instance);
        for (const std::uint32_t vertex : mesh.triangles[triangle])
            farthest = std::max(farthest, along(m_view.camera.forward, instance, mesh.positions[vertex]));
        const bool isBehindNear =
            fate == Fate::BehindNear || (fate == Fate::Transparent && farthest < m_view.camera.near);
        if (isBehindNear) return farthest > 0 ? Reason::BeforeNear : Reason::BehindEye;
        return fate == Fate::OutOfRange ? Reason::OutOfRange : Reason::NoArea;
    }
    Reason reasonOf(const std::vector<Part>& parts) const
    {
        Reason best = Reason::BehindEye;
        for (const Part& part : parts) best = std::max(best, zscope::reasonOf(part, m_view));
        return best;
    }

    const Scene&                                     m_scene;
    View                                             m_view, m_bothSides;
    bool                                             m_isDrawn;
    std::vector<UsedMaterial>                        m_invisible;
    std::vector<std::uint64_t>                       m_visible;  // of each mesh: triangles of an opacity above 0
    std::vector<Bounds>                              m_boxes;    // of each mesh
    std::vector<std::atomic<std::uint8_t>>           m_whole;    // of each instance: kUnknown, kEach, or a reason
    std::array<std::atomic<std::uint64_t>, kReasons> m_counts{};
    std::atomic<std::uint64_t>                       m_faint = 0;  // of those without a reason: transparent ones
    std::atomic<bool>                                m_stop  = false;
};

std::string clause(std::uint64_t count, std::string_view one, std::string_view many)
{
    return fmt::format("{} {}", grouped(count, ','), count == 1 ? one : many);
}

/// The counts in words. What is invisible comes last: its list of materials ends the sentence.
std::vector<std::string> clausesOf(const Counts& counts, std::uint64_t faint, const Camera& camera)
{
    std::vector<std::string> clauses;
    const auto               add = [&](std::uint64_t count, std::string_view one, std::string_view many) {
        if (count > 0) clauses.push_back(clause(count, one, many));
    };
    const auto of = [&counts](Reason reason) { return counts[indexOf(reason)]; };
    add(of(Reason::BehindEye), "triangle lies behind the eye", "triangles lie behind the eye");
    if (const std::uint64_t count = of(Reason::BeforeNear); count > 0)
        clauses.push_back(clause(count, "triangle lies", "triangles lie")
                          + fmt::format(" before the near plane ({:.6g})", camera.near));
    add(of(Reason::OutsideView), "triangle lies outside the view", "triangles lie outside the view");
    if (const std::uint64_t count = of(Reason::BeyondFar); count > 0)
        clauses.push_back(clause(count, "triangle lies", "triangles lie")
                          + fmt::format(" beyond the far plane ({:.6g})", camera.far));
    add(of(Reason::BackFace), "triangle shows its back, and back faces are culled",
        "triangles show their backs, and back faces are culled");
    add(of(Reason::NoArea), "triangle has no area on the grid", "triangles have no area on the grid");
    add(of(Reason::OutOfRange), "triangle reaches beyond the range of the grid",
        "triangles reach beyond the range of the grid");
    add(of(Reason::Hole), "triangle has holes at all pixels it covers",
        "triangles have holes at all pixels they cover");
    add(of(Reason::BetweenCentres), "triangle lies between the centres of the pixels",
        "triangles lie between the centres of the pixels");
    add(faint, "triangle is too transparent to change a colour", "triangles are too transparent to change a colour");
    add(of(Reason::None) - faint, "triangle covers pixels by the definition, but the chosen method leaves it out",
        "triangles cover pixels by the definition, but the chosen method leaves them out");
    return clauses;
}

const Material& materialOf(const Scene& scene, const UsedMaterial& used)
{
    return scene.meshes[used.mesh.value]->materials[used.material.value];
}

std::string invisibleClause(const Scene& scene, const std::vector<UsedMaterial>& invisible)
{
    constexpr std::size_t    kNamed    = 3;
    std::uint64_t            triangles = 0;
    std::vector<std::string> names;
    for (const UsedMaterial& used : invisible) {
        triangles += used.triangles;
        const Material&   material = materialOf(scene, used);
        const std::string origin   = opacityOrigin(material);
        std::string       name     = fmt::format("'{}'", quotable(material.name));
        if (!origin.empty()) name += fmt::format(" ({})", origin);
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    const std::size_t named = std::min(names.size(), kNamed), more = names.size() - named;
    return clause(triangles, "triangle has opacity 0: ", "triangles have opacity 0: ")
           + (names.size() == 1 ? "material " : "materials ")
           + fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(named), ", "))
           + (more > 0 ? fmt::format(", and {} more", more) : "");
}

/// Some programs write `Tr 1` and mean opaque; then every material of a library says it.
std::string mistakenTr(const Scene& scene, const std::vector<UsedMaterial>& invisible)
{
    for (const UsedMaterial& used : invisible) {
        const auto& from = materialOf(scene, used).opacityFrom;
        if (!from || !from->text.starts_with("Tr ")) return {};
    }
    const FileStatement& first = *materialOf(scene, invisible.front()).opacityFrom;
    return fmt::format("; '{}' was most likely meant as opaque: write 'Tr 0' or 'd 1' into {}", first.text,
                       printable(std::filesystem::path(first.file).filename().string()));
}

/// `what` is empty, and why; nothing if it is not.
std::optional<Warning> judged(const Scene& scene, const Camera& camera, FaceCulling faceCulling, bool isDrawn,
                              const std::string& what, const Progress& progress)
{
    Search search(scene, camera, faceCulling, isDrawn);
    if (!search.run(progress)) return std::nullopt;
    const std::vector<UsedMaterial>& invisible = search.invisible();
    std::vector<std::string>         clauses   = clausesOf(search.counts(), search.faint(), camera);
    Warning                          warning;
    if (!invisible.empty()) {
        clauses.push_back(invisibleClause(scene, invisible));
        if (clauses.size() == 1) {
            clauses.front() += mistakenTr(scene, invisible);
            if (const auto& from = materialOf(scene, invisible.front()).opacityFrom)
                warning.file = from->file, warning.line = from->line;
        }
    }
    if (clauses.empty()) clauses.emplace_back("the scene holds no triangles");
    warning.sentence = fmt::format("{} is empty: {}", what, fmt::join(clauses, "; "));
    return warning;
}

}  // namespace

bool isEmpty(const Frame& frame)
{
    const VisibilityBuffer& visible = frame.visible;
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (visible.rankAt(x, y) != 0) return false;
    return std::ranges::all_of(frame.colour.values(), [](std::uint32_t c) { return c == kBackgroundColour; });
}

std::optional<Warning> whyEmpty(const DrawRequest& request, const Frame& frame)
{
    if (!isEmpty(frame)) return std::nullopt;
    return judged(request.scene->scene(), request.camera, request.faceCulling, true, "the picture",
                  {.cancel = request.cancel});
}

std::optional<Warning> whyEmpty(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                const std::string& cameraName, const Progress& progress)
{
    const std::string what =
        cameraName.empty() ? "the picture" : fmt::format("the picture of camera '{}'", quotable(cameraName));
    return judged(scene, camera, faceCulling, false, what, progress);
}

}  // namespace zscope
