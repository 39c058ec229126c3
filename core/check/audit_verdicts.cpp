#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/base/quotable.h"
#include "core/check/audit.h"
#include "core/check/exact_triangle.h"
#include "core/io/json_document.h"

namespace zscope::check {
namespace {

class VerdictReader {
public:
    explicit VerdictReader(const std::string& file) : m_file(file) {}

    Result<CullVerdict> verdictOf(const JsonValue& value) const
    {
        const JsonValue::Object* members = value.object();
        if (!members) return wrong(value, "a verdict must be an object: a box or a group, and 'culled'");
        std::map<std::string_view, const JsonValue*> of;
        for (const auto& [key, member] : *members) of[key] = &member;
        const auto has = [&](std::string_view key) { return of.contains(key); };
        if (!has("culled") || !of["culled"]->truth()) return wrong(value, "'culled' must be true or false");
        const bool isBox = has("min") || has("max");
        if (isBox == has("group")) return wrong(value, "a verdict is of a box ('min' and 'max') or of a 'group'");
        const std::string_view named = isBox ? "name" : "group";
        if (!has(named) || !of[named]->text()) return wrong(value, fmt::format("'{}' must be a text", named));
        CullVerdict verdict{
            .name = *of[named]->text(), .box = {}, .isCulled = *of["culled"]->truth(), .line = value.line};
        if (!isBox) return verdict;
        if (!has("min") || !has("max")) return wrong(value, "a box needs 'min' and 'max'");
        const auto low = pointOf(*of["min"], "min"), high = pointOf(*of["max"], "max");
        if (!low) return low.error();
        if (!high) return high.error();
        if (low->x > high->x || low->y > high->y || low->z > high->z)
            return wrong(value, "'min' of the box lies beyond its 'max'");
        verdict.box = Bounds{*low, *high};
        return verdict;
    }

    Error wrong(const JsonValue& value, std::string sentence) const
    {
        return {Trouble::Input, std::move(sentence), m_file, value.line};
    }

private:
    Result<dvec3> pointOf(const JsonValue& value, std::string_view what) const
    {
        const JsonValue::Array* numbers = value.array();
        if (!numbers || numbers->size() != 3) return wrong(value, fmt::format("'{}' must be three numbers", what));
        dvec3 point{};
        for (int i = 0; i < 3; ++i) {
            const auto number = realOf((*numbers)[static_cast<std::size_t>(i)], m_file, what);
            if (!number) return number.error();
            if (!std::isfinite(*number)) return wrong(value, fmt::format("'{}' must be finite", what));
            point[i] = *number;
        }
        return point;
    }

    const std::string& m_file;
};

/// The point that is seen at the centre of a pixel. Snapping moves the border of a triangle by less than a pixel, so the
/// point of its plane is kept within the box of its corners.
dvec3 seenPoint(const Truth& truth, TriangleId id, int x, int y)
{
    const Camera&       camera   = truth.camera;
    const Scene&        scene    = truth.scene->scene();
    const InstanceId    instance = scene.instanceOf(id);
    const Mesh&         mesh     = scene.meshOf(instance);
    const std::uint32_t own      = id.value - scene.firstTriangle[instance.value];
    const double        depth    = ExactTriangle(scene, camera, id, truth.halfStep).depthOf(x, y).depth;
    const double        z = camera.near / depth, scale = camera.height * 0.5 * camera.focal;
    const dvec3 point = camera.eye + z * camera.forward + (x + 0.5 - camera.width * 0.5) / scale * z * camera.right
                        + (camera.height * 0.5 - y - 0.5) / scale * z * camera.up;
    Bounds corners;
    for (const std::uint32_t v : mesh.triangles[own])
        corners.include(scene.instances[instance.value].toWorld(mesh.positions[v]));
    return glm::clamp(point, corners.min, corners.max);
}

Bounds grown(const Bounds& box)
{
    const dvec3 more = 1e-6 * (box.max - box.min);
    return {box.min - more, box.max + more};
}

bool holds(const Bounds& box, const dvec3& p)
{
    return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z
           && p.z <= box.max.z;
}

/// Which verdicts speak of a triangle, by name.
class Names {
public:
    Names(const Scene& scene, const std::vector<CullVerdict>& verdicts) : m_scene(scene)
    {
        for (std::size_t i = 0; i < verdicts.size(); ++i)
            if (!verdicts[i].box) m_verdicts[verdicts[i].name].push_back(i);
    }

    /// Calls use(verdict) for each of them.
    template <class Use>
    void forEach(TriangleId id, const Use& use) const
    {
        const InstanceId  instance = m_scene.instanceOf(id);
        const Mesh&       mesh     = m_scene.meshOf(instance);
        const std::size_t own      = id.value - m_scene.firstTriangle[instance.value];
        for (const std::string& name : namesOf(instance, mesh, mesh.polygonGroup[mesh.trianglePolygon[own].value]))
            if (const auto known = m_verdicts.find(name); known != m_verdicts.end())
                for (const std::size_t verdict : known->second) use(verdict);
    }

    /// Whether anything of the scene has the name.
    bool isKnown(const std::string& name) const
    {
        for (std::uint32_t i = 0; i < m_scene.instances.size(); ++i) {
            const Mesh& mesh = m_scene.meshOf(InstanceId{i});
            if (name == fmt::format("instance {}", i) || name == mesh.name) return true;
            for (const std::string& group : mesh.groups)
                if (name == group || name == objectOf(group)) return true;
        }
        return false;
    }

private:
    static std::string              objectOf(const std::string& group) { return group.substr(0, group.find('/')); }
    static std::vector<std::string> namesOf(InstanceId instance, const Mesh& mesh, GroupId group)
    {
        const std::string&       whole = mesh.groups[group.value];
        std::vector<std::string> names{fmt::format("instance {}", instance.value), mesh.name, whole, objectOf(whole)};
        std::ranges::sort(names);
        names.erase(std::unique(names.begin(), names.end()), names.end());
        return names;
    }

    const Scene&                                    m_scene;
    std::map<std::string, std::vector<std::size_t>> m_verdicts;
};

}  // namespace

Result<std::vector<CullVerdict>> cullVerdictsOf(std::string_view text, const std::string& file)
{
    const auto document = parseJson(text, file);
    if (!document) return document.error();
    const VerdictReader     reader(file);
    const JsonValue::Array* array = document->array();
    if (!array) return reader.wrong(*document, "the verdicts must be a list: [{\"name\": ..., \"culled\": ...}, ...]");
    std::vector<CullVerdict> verdicts;
    for (const JsonValue& value : *array) {
        auto verdict = reader.verdictOf(value);
        if (!verdict) return verdict.error();
        verdicts.push_back(*std::move(verdict));
    }
    return verdicts;
}

Result<std::vector<CullJudgement>> auditVerdicts(const Truth& truth, const std::vector<CullVerdict>& verdicts,
                                                 const std::string& file)
{
    const Names                names(truth.scene->scene(), verdicts);
    std::vector<CullJudgement> judgements;
    std::vector<std::size_t>   boxes;
    std::vector<Bounds>        grownBoxes;
    for (const CullVerdict& verdict : verdicts) {
        if (verdict.box)
            boxes.push_back(judgements.size()), grownBoxes.push_back(grown(*verdict.box));
        else if (!names.isKnown(verdict.name))
            return Error{Trouble::Input,
                         fmt::format("the scene has no group, object, mesh or instance '{}'", quotable(verdict.name)),
                         file, verdict.line};
        judgements.push_back({verdict.name, verdict.isCulled, 0});
    }
    for (int y = 0; y < truth.camera.height; ++y)
        for (int x = 0; x < truth.camera.width; ++x) {
            const std::int64_t id = truth.picture.ids.at(x, y);
            if (id < 0) continue;
            const TriangleId triangle{static_cast<std::uint32_t>(id)};
            names.forEach(triangle, [&](std::size_t verdict) { ++judgements[verdict].pixels; });
            if (boxes.empty()) continue;
            const dvec3 point = seenPoint(truth, triangle, x, y);
            for (std::size_t i = 0; i < boxes.size(); ++i) judgements[boxes[i]].pixels += holds(grownBoxes[i], point);
        }
    return judgements;
}

}  // namespace zscope::check
