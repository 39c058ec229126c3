#include "core/scene/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <span>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "core/base/memory.h"
#include "core/base/quotable.h"
#include "core/base/stopwatch.h"
#include "core/io/json_document.h"
#include "core/io/read_file.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/random.h"
#include "core/scene/obj/names.h"
#include "core/scene/view_json.h"

namespace zscope {

namespace {

/// Reading stops at the first thing that is wrong: every step returns the error, if there is one.
using Problem = std::optional<Error>;

struct FileMaterial {
    Rgb                   colour;
    float                 opacity = 1;
    std::optional<Cutout> cutout  = {};
    std::optional<Relief> relief  = {};
    int                   line    = 0;
    bool                  used    = false;

    std::shared_ptr<const FileStatement> opacityFrom = {};
};

std::string shown(std::string_view text) { return quotable(text, 60); }

class SceneFileReader {
public:
    SceneFileReader(std::string path, std::string folder, const LoadOptions& options)
        : m_path(std::move(path)), m_folder(std::move(folder)), m_options(options),
          m_limit(effectiveMemoryLimit(options.memoryLimit))
    {}

    Result<Scene> read(const JsonValue& document);

private:
    Problem readMaterials(const JsonValue& document);
    Problem readMeshes(const JsonValue& document);
    Problem readMesh(const std::string& name, const JsonValue& value);
    Problem readInstances(const JsonValue& document);
    Problem readInstance(const JsonValue& value);
    Problem placeByMatrix(const JsonValue& value, Instance instance);
    Problem placeInGrid(const JsonValue& value, Instance instance, bool colourEach);
    Problem placeAtRandom(const JsonValue& value, Instance instance, bool colourEach);
    Problem readLight(const JsonValue& document);
    Problem readCameras(const JsonValue& document);

    /// What the file says of the material that a mesh calls so; nullptr if nothing.
    FileMaterial* ownOf(const std::string& name);
    Problem       checkCount(const JsonValue& value, double count, MeshId mesh) const;
    Problem       checkReach(const JsonValue& value, const Instance& instance) const;
    void          add(Instance instance, bool colourEach);
    Result<Rgb>   colourOf(const JsonValue& value) const;
    /// Which of `words` the member 'pattern' of a cut-out or relief is.
    Result<std::size_t> patternOf(const JsonValue& value, std::string_view what,
                                  std::span<const std::string_view> words) const;
    /// A member that is a length.
    Result<double> lengthOf(const JsonValue& value, std::string_view what, std::string_view key) const;
    Result<Cutout> cutoutOf(const JsonValue& value) const;
    Result<Relief> reliefOf(const JsonValue& value) const;

    Error wrong(const JsonValue& value, std::string sentence) const
    {
        return {Trouble::Input, std::move(sentence), m_path, value.line};
    }
    /// The members of an object whose keys are all in `known`.
    Result<const JsonValue::Object*> membersOf(const JsonValue& value, std::string_view what,
                                               std::initializer_list<std::string_view> known) const;
    static const JsonValue*          find(const JsonValue& object, std::string_view key)
    {
        for (const auto& [name, value] : *object.object())
            if (name == key) return &value;
        return nullptr;
    }

    std::string        m_path;
    std::string        m_folder;  // real path
    const LoadOptions& m_options;
    std::uint64_t      m_limit;

    Scene                         m_scene;
    std::map<std::string, MeshId> m_meshes;
    // of each mesh: how far its vertices are from 0 at most, along each axis
    std::vector<dvec3>                  m_reach;
    std::map<std::string, FileMaterial> m_materials;  // by printable name
    std::vector<int>                    m_cameraLines;
};

Result<const JsonValue::Object*> SceneFileReader::membersOf(const JsonValue& value, std::string_view what,
                                                            std::initializer_list<std::string_view> known) const
{
    const JsonValue::Object* members = value.object();
    if (!members) return wrong(value, fmt::format("{} must be an object", what));
    for (const auto& [key, member] : *members)
        if (std::ranges::find(known, key) == known.end())
            return wrong(member, fmt::format("{} has no '{}'; it has {}", what, shown(key), fmt::join(known, ", ")));
    return members;
}

Result<Scene> SceneFileReader::read(const JsonValue& document)
{
    const auto members = membersOf(document, "a scene", {"meshes", "instances", "materials", "light", "cameras"});
    if (!members) return members.error();
    using Step = Problem (SceneFileReader::*)(const JsonValue&);
    for (const Step step :
         {&SceneFileReader::readMaterials, &SceneFileReader::readMeshes, &SceneFileReader::readInstances,
          &SceneFileReader::readLight, &SceneFileReader::readCameras})
        if (auto trouble = (this->*step)(document)) return *std::move(trouble);
    for (const auto& [name, material] : m_materials)
        if (!material.used)
            m_scene.warnings.push_back(
                {m_path, material.line, fmt::format("the material '{}' is used by nothing", name)});

    m_scene.name = m_path;
    m_scene.files.push_back(m_path);
    Stopwatch     watch;
    Result<Scene> scene = assemble(std::move(m_scene));
    if (m_options.times) m_options.times->checkMs += watch.lap();
    if (!scene) return Error{scene.error().kind, scene.error().sentence, m_path};
    for (std::size_t i = 0; i < scene->views.size(); ++i) {
        const Result<Camera> camera = makeCamera(scene->views[i].view, scene->bounds);
        if (!camera)
            return Error{Trouble::Input,
                         fmt::format("the camera '{}': {}", shown(scene->views[i].name), camera.error().sentence),
                         m_path, scene->views[i].line};
    }
    return scene;
}

Problem SceneFileReader::readMaterials(const JsonValue& document)
{
    const JsonValue* value = find(document, "materials");
    if (!value) return {};
    if (!value->object()) return wrong(*value, "'materials' must be an object of materials by name");
    for (const auto& [name, description] : *value->object()) {
        const auto members = membersOf(description, "a material", {"colour", "opacity", "cutout", "relief"});
        if (!members) return members.error();
        const JsonValue* colour = find(description, "colour");
        if (!colour) return wrong(description, fmt::format("the material '{}' needs a 'colour'", shown(name)));
        const Result<Rgb> rgb = colourOf(*colour);
        if (!rgb) return rgb.error();
        FileMaterial material{.colour = *rgb, .line = description.line};
        if (const JsonValue* opacity = find(description, "opacity")) {
            const Result<double> d = realOf(*opacity, m_path, "opacity");
            if (!d) return d.error();
            if (!(*d >= 0 && *d <= 1)) return wrong(*opacity, "'opacity' must be from 0 to 1");
            material.opacity = static_cast<float>(*d);
            if (*d < 1)
                material.opacityFrom = std::make_shared<FileStatement>(
                    FileStatement{fmt::format("\"opacity\": {}", *d), m_path, opacity->line});
        }
        if (const JsonValue* cutout = find(description, "cutout")) {
            const Result<Cutout> holes = cutoutOf(*cutout);
            if (!holes) return holes.error();
            material.cutout = *holes;
        }
        if (const JsonValue* relief = find(description, "relief")) {
            const Result<Relief> depths = reliefOf(*relief);
            if (!depths) return depths.error();
            material.relief = *depths;
        }
        if (!m_materials.emplace(obj::printableName(name), material).second)
            return wrong(description, fmt::format("the material '{}' is given twice", shown(name)));
    }
    return {};
}

Result<Cutout> SceneFileReader::cutoutOf(const JsonValue& value) const
{
    const auto members = membersOf(value, "a cut-out", {"pattern", "size"});
    if (!members) return members.error();
    const auto pattern = patternOf(value, "a cut-out", kCutoutWords);
    if (!pattern) return pattern.error();
    const auto size = lengthOf(value, "a cut-out", "size");
    if (!size) return size.error();
    return Cutout{static_cast<CutoutPattern>(*pattern), *size};
}

Result<Relief> SceneFileReader::reliefOf(const JsonValue& value) const
{
    const auto members = membersOf(value, "a relief", {"pattern", "size", "depth"});
    if (!members) return members.error();
    const auto pattern = patternOf(value, "a relief", kReliefWords);
    if (!pattern) return pattern.error();
    const auto size = lengthOf(value, "a relief", "size");
    if (!size) return size.error();
    const auto depth = lengthOf(value, "a relief", "depth");
    if (!depth) return depth.error();
    return Relief{static_cast<ReliefPattern>(*pattern), *size, *depth};
}

Result<std::size_t> SceneFileReader::patternOf(const JsonValue& value, std::string_view what,
                                               std::span<const std::string_view> words) const
{
    const JsonValue* pattern = find(value, "pattern");
    if (!pattern) return wrong(value, fmt::format("{} needs a 'pattern'", what));
    if (!pattern->text()) return wrong(*pattern, fmt::format("'pattern' must be one of {}", fmt::join(words, ", ")));
    const auto word = std::ranges::find(words, *pattern->text());
    if (word == words.end())
        return wrong(*pattern, fmt::format("'{}' is no pattern: choose one of {}", shown(*pattern->text()),
                                           fmt::join(words, ", ")));
    return static_cast<std::size_t>(word - words.begin());
}

Result<double> SceneFileReader::lengthOf(const JsonValue& value, std::string_view what, std::string_view key) const
{
    const JsonValue* length = find(value, key);
    if (!length) return wrong(value, fmt::format("{} needs a '{}'", what, key));
    const Result<double> real = realOf(*length, m_path, key);
    if (!real) return real.error();
    if (!(*real > 0) || !std::isfinite(*real))
        return wrong(*length, fmt::format("'{}' must be more than 0, and finite", key));
    return *real;
}

Problem SceneFileReader::readMeshes(const JsonValue& document)
{
    const JsonValue* value = find(document, "meshes");
    if (!value) return wrong(document, "the scene has no 'meshes'");
    if (!value->object() || value->object()->empty())
        return wrong(*value, "'meshes' must be an object of meshes by name");
    double done = 0;
    for (const auto& [name, description] : *value->object()) {
        if (m_options.progress.cancelled())
            return Error{Trouble::Cancelled, "the scene was not wanted any more", m_path};
        m_options.progress.at(done / static_cast<double>(value->object()->size()), "meshes");
        if (auto trouble = readMesh(name, description)) return trouble;
        done += 1;
    }
    return {};
}

Problem SceneFileReader::readMesh(const std::string& name, const JsonValue& value)
{
    const auto members = membersOf(value, "a mesh", {"obj", "builtin"});
    if (!members) return members.error();
    if ((*members)->size() != 1)
        return wrong(value, fmt::format("the mesh '{}' must have either 'obj' or 'builtin'", shown(name)));
    const auto& [kind, source] = (*members)->front();
    if (!source.text()) return wrong(source, fmt::format("'{}' must be a text", kind));

    LoadOptions options{.memoryLimit = m_limit,
                        .progress    = {.cancel = m_options.progress.cancel},
                        .times       = m_options.times,
                        .isPart      = true};
    std::string word;
    if (kind == "obj") {
        if (!hasEnding(*source.text(), ".obj"))
            return wrong(source, fmt::format("'{}' is not the name of an .obj file", shown(*source.text())));
        Result<std::string> real = pathInside(m_folder, *source.text());
        if (!real) return wrong(source, real.error().sentence);
        word = *std::move(real);
    } else {
        word = "builtin:" + *source.text();
    }
    Result<Scene> part = loadScene(word, options);
    if (!part) {
        Error error = part.error();
        // Trouble inside an OBJ has its own file and line; anything else is about this line.
        if (error.file.empty())
            error = {error.kind, fmt::format("the mesh '{}': {}", shown(name), error.sentence), m_path, source.line};
        if (error.kind == Trouble::Usage) error.kind = Trouble::Input;
        return error;
    }
    const bool isOneMesh = part->meshes.size() == 1 && part->instances.size() == 1
                           && part->instances[0].toWorld.isIdentity() && !part->instances[0].colour;
    if (!isOneMesh)
        return wrong(source, fmt::format("{} is a scene of {} instances, not one mesh; meshes are for example "
                                         "builtin cube, teapot and soccer-ball",
                                         shown(word), part->instances.size()));
    std::ranges::move(part->warnings, std::back_inserter(m_scene.warnings));
    std::ranges::move(part->files, std::back_inserter(m_scene.files));

    std::shared_ptr<const Mesh> mesh = part->meshes[0];
    if (std::ranges::any_of(mesh->materials, [this](const Material& material) { return ownOf(material.name); })) {
        auto changed = std::make_shared<Mesh>(*mesh);
        for (Material& material : changed->materials)
            if (FileMaterial* own = ownOf(material.name)) {
                material.diffuse     = own->colour;
                material.opacity     = own->opacity;
                material.opacityFrom = own->opacityFrom;
                material.cutout      = own->cutout;
                material.relief      = own->relief;
                own->used            = true;
            }
        mesh = std::move(changed);
    }
    m_meshes.emplace(name, MeshId{static_cast<std::uint32_t>(m_scene.meshes.size())});
    const Bounds box = mesh->bounds();
    m_reach.push_back(box.isEmpty() ? dvec3(0, 0, 0) : glm::max(glm::abs(box.min), glm::abs(box.max)));
    m_scene.meshes.push_back(std::move(mesh));
    return {};
}

FileMaterial* SceneFileReader::ownOf(const std::string& name)
{
    for (const obj::NameReading& reading : obj::readingsOf(name))
        if (const auto own = m_materials.find(std::string(reading.name)); own != m_materials.end()) return &own->second;
    return nullptr;
}

Problem SceneFileReader::readInstances(const JsonValue& document)
{
    const JsonValue* value = find(document, "instances");
    if (!value) return wrong(document, "the scene has no 'instances', so nothing would be seen");
    if (!value->array()) return wrong(*value, "'instances' must be a list");
    for (const JsonValue& instance : *value->array()) {
        if (m_options.progress.cancelled())
            return Error{Trouble::Cancelled, "the scene was not wanted any more", m_path};
        if (auto trouble = readInstance(instance)) return trouble;
    }
    return {};
}

Problem SceneFileReader::readInstance(const JsonValue& value)
{
    const auto members = membersOf(value, "an instance", {"mesh", "matrix", "grid", "random", "material", "colour"});
    if (!members) return members.error();
    const JsonValue* name = find(value, "mesh");
    if (!name || !name->text()) return wrong(name ? *name : value, "an instance needs the name of its 'mesh'");
    const auto mesh = m_meshes.find(*name->text());
    if (mesh == m_meshes.end())
        return wrong(*name, fmt::format("there is no mesh '{}' in 'meshes'", shown(*name->text())));
    Instance instance{mesh->second, Affine{}};

    bool             colourEach = false;
    const JsonValue* material   = find(value, "material");
    const JsonValue* colour     = find(value, "colour");
    if (material && colour) return wrong(*colour, "an instance has either a 'material' or a 'colour'");
    if (material) {
        if (!material->text()) return wrong(*material, "'material' must be the name of a material");
        const auto own = m_materials.find(obj::printableName(*material->text()));
        if (own == m_materials.end())
            return wrong(*material, fmt::format("there is no material '{}' in 'materials'", shown(*material->text())));
        if (own->second.opacity < 1)
            return wrong(*material, "the opacity of an instance is its mesh's: name an opaque material");
        if (own->second.cutout)
            return wrong(*material, "the cut-out of an instance is its mesh's: name a material without one");
        if (own->second.relief)
            return wrong(*material, "the relief of an instance is its mesh's: name a material without one");
        own->second.used = true;
        instance.colour  = own->second.colour;
    } else if (colour && colour->text()) {
        if (*colour->text() != "each") return wrong(*colour, "'colour' must be three numbers from 0 to 1, or \"each\"");
        colourEach = true;
    } else if (colour) {
        const Result<Rgb> rgb = colourOf(*colour);
        if (!rgb) return rgb.error();
        instance.colour = *rgb;
    }

    const JsonValue* matrix = find(value, "matrix");
    const JsonValue* grid   = find(value, "grid");
    const JsonValue* random = find(value, "random");
    if ((matrix != nullptr) + (grid != nullptr) + (random != nullptr) > 1)
        return wrong(value, "an instance has one of 'matrix', 'grid' and 'random'");
    if (grid) return placeInGrid(*grid, instance, colourEach);
    if (random) return placeAtRandom(*random, instance, colourEach);
    if (auto trouble = checkCount(value, 1, instance.mesh)) return trouble;
    if (matrix) {
        if (auto trouble = placeByMatrix(*matrix, instance)) return trouble;
        if (colourEach) m_scene.instances.back().colour = palette::colourOf(m_scene.instances.size() - 1);
        return {};
    }
    add(instance, colourEach);
    return {};
}

Problem SceneFileReader::placeByMatrix(const JsonValue& value, Instance instance)
{
    const JsonValue::Array* entries = value.array();
    if (!entries || entries->size() != 12)
        return wrong(value, "'matrix' must be a list of twelve numbers: three rows of four");
    for (std::size_t i = 0; i < 12; ++i) {
        const Result<double> entry = realOf((*entries)[i], m_path, "matrix");
        if (!entry) return entry.error();
        if (!std::isfinite(*entry)) return wrong((*entries)[i], "'matrix' must be finite");
        instance.toWorld.rows[i / 4][i % 4] = *entry;
    }
    if (auto trouble = checkReach(value, instance)) return trouble;
    add(instance, false);
    return {};
}

Problem SceneFileReader::placeInGrid(const JsonValue& value, Instance instance, bool colourEach)
{
    const auto members = membersOf(value, "a grid", {"count", "step"});
    if (!members) return members.error();
    const JsonValue* count = find(value, "count");
    const JsonValue* step  = find(value, "step");
    if (!count || !step) return wrong(value, "a grid needs 'count' and 'step', three numbers each");
    if (!count->array() || count->array()->size() != 3)
        return wrong(*count, "'count' must be a list of three whole numbers");
    std::array<std::int64_t, 3> copies{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto n = wholeOf((*count->array())[k], m_path, "count", 1, std::int64_t{1} << 32);
        if (!n) return n.error();
        copies[k] = *n;
    }
    const Result<dvec3> apart = vectorOf(*step, m_path, "step");
    if (!apart) return apart.error();
    const double total =
        static_cast<double>(copies[0]) * static_cast<double>(copies[1]) * static_cast<double>(copies[2]);
    if (auto trouble = checkCount(*count, total, instance.mesh)) return trouble;
    const auto copyAt = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
        return Affine::translation(
            {static_cast<double>(x) * apart->x, static_cast<double>(y) * apart->y, static_cast<double>(z) * apart->z});
    };
    instance.toWorld = copyAt(copies[0] - 1, copies[1] - 1, copies[2] - 1);
    if (auto trouble = checkReach(*step, instance)) return trouble;  // the others are nearer

    for (std::int64_t z = 0; z < copies[2]; ++z)
        for (std::int64_t y = 0; y < copies[1]; ++y)
            for (std::int64_t x = 0; x < copies[0]; ++x) {
                instance.toWorld = copyAt(x, y, z);
                add(instance, colourEach);
            }
    return {};
}

Problem SceneFileReader::placeAtRandom(const JsonValue& value, Instance instance, bool colourEach)
{
    const auto members = membersOf(value, "a random group", {"count", "seed", "min", "max", "rotate"});
    if (!members) return members.error();
    const JsonValue* count  = find(value, "count");
    const JsonValue* seed   = find(value, "seed");
    const JsonValue* low    = find(value, "min");
    const JsonValue* high   = find(value, "max");
    const JsonValue* rotate = find(value, "rotate");
    if (!count || !low || !high) return wrong(value, "a random group needs 'count', 'min' and 'max'");
    const auto copies = wholeOf(*count, m_path, "count", 0, std::int64_t{1} << 53);
    if (!copies) return copies.error();
    std::int64_t start = 1;
    if (seed) {
        const auto given = wholeOf(*seed, m_path, "seed", 0, std::int64_t{1} << 53);
        if (!given) return given.error();
        start = *given;
    }
    const Result<dvec3> from = vectorOf(*low, m_path, "min");
    if (!from) return from.error();
    const Result<dvec3> to = vectorOf(*high, m_path, "max");
    if (!to) return to.error();
    for (int k = 0; k < 3; ++k)
        if ((*from)[k] > (*to)[k] || !std::isfinite((*to)[k] - (*from)[k]))
            return wrong(*low, "'min' must not be above 'max', and their distance must be finite");
    if (rotate && !rotate->truth()) return wrong(*rotate, "'rotate' must be true or false");
    if (auto trouble = checkCount(*count, static_cast<double>(*copies), instance.mesh)) return trouble;

    Random random(static_cast<std::uint64_t>(start));
    for (std::int64_t i = 0; i < *copies; ++i) {
        instance.toWorld = rotate && *rotate->truth() ? random.rotation() : Affine{};
        const dvec3 at   = random.between(*from, *to);
        for (int k = 0; k < 3; ++k) instance.toWorld.rows[static_cast<std::size_t>(k)][3] = at[k];
        if (auto trouble = checkReach(value, instance)) return trouble;
        add(instance, colourEach);
    }
    return {};
}

/// Whether so many more copies can be held, and told apart, before the first of them is made.
Problem SceneFileReader::checkCount(const JsonValue& value, double count, MeshId mesh) const
{
    const double     instances = static_cast<double>(m_scene.instances.size()) + count;
    const double     bytes = instances * (sizeof(Instance) + sizeof(std::uint32_t)) * 2;  // a growing list holds twice
    const double     triangles = count * static_cast<double>(m_scene.meshes[mesh.value]->triangles.size());
    constexpr double kMiB      = 1024.0 * 1024.0;
    if (triangles > static_cast<double>(kMaxTriangles) || instances > static_cast<double>(kMaxTriangles))
        return Error{Trouble::Limit,
                     fmt::format("{:.0f} copies make {:.0f} triangles, and at most {} can be told apart", count,
                                 triangles, kMaxTriangles),
                     m_path, value.line};
    if (bytes > static_cast<double>(m_limit))
        return Error{Trouble::Limit,
                     fmt::format("{:.0f} copies would take {:.0f} MiB, and the memory limit is {:.0f} MiB", count,
                                 bytes / kMiB, static_cast<double>(m_limit) / kMiB),
                     m_path, value.line};
    return {};
}

/// Whether every vertex of the copy, and every sum on the way to it, is a finite number.
Problem SceneFileReader::checkReach(const JsonValue& value, const Instance& instance) const
{
    const dvec3& reach = m_reach[instance.mesh.value];
    for (const auto& row : instance.toWorld.rows) {
        const double farthest =
            std::abs(row[0]) * reach.x + std::abs(row[1]) * reach.y + std::abs(row[2]) * reach.z + std::abs(row[3]);
        if (!std::isfinite(farthest))
            return wrong(value, "an instance reaches beyond the largest number: it is too far or too large");
    }
    return {};
}

void SceneFileReader::add(Instance instance, bool colourEach)
{
    if (colourEach) instance.colour = palette::colourOf(m_scene.instances.size());
    m_scene.instances.push_back(instance);
}

Result<Rgb> SceneFileReader::colourOf(const JsonValue& value) const
{
    const JsonValue::Array* parts = value.array();
    if (!parts || parts->size() != 3) return wrong(value, "'colour' must be three numbers from 0 to 1");
    std::array<float, 3> rgb{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Result<double> part = realOf((*parts)[k], m_path, "colour");
        if (!part) return part.error();
        if (!(*part >= 0 && *part <= 1)) return wrong((*parts)[k], "'colour' must be three numbers from 0 to 1");
        rgb[k] = static_cast<float>(*part);
    }
    return Rgb{rgb[0], rgb[1], rgb[2]};
}

Problem SceneFileReader::readLight(const JsonValue& document)
{
    const JsonValue* value = find(document, "light");
    if (!value) return {};
    const auto members = membersOf(*value, "the light", {"direction"});
    if (!members) return members.error();
    const JsonValue* direction = find(*value, "direction");
    if (!direction) return wrong(*value, "the light needs a 'direction'");
    const Result<dvec3> vector = vectorOf(*direction, m_path, "direction");
    if (!vector) return vector.error();
    if (*vector == dvec3{0, 0, 0}) return wrong(*direction, "the light's direction must not be 0 in all three parts");
    m_scene.light.direction = *vector;
    return {};
}

Problem SceneFileReader::readCameras(const JsonValue& document)
{
    const JsonValue* value = find(document, "cameras");
    if (!value) return {};
    if (!value->object()) return wrong(*value, "'cameras' must be an object of cameras by name");
    for (const auto& [name, description] : *value->object()) {
        const Result<ViewRequest> view = viewOf(description, m_path);
        if (!view) return view.error();
        m_scene.views.push_back({name, *view, description.line});
    }
    return {};
}

}  // namespace

Result<Scene> loadSceneFile(const std::string& path, const LoadOptions& options)
{
    const Result<std::string> text =
        readRegularFile(path, std::min(kMaxSceneFileBytes, effectiveMemoryLimit(options.memoryLimit)));
    if (!text) return text.error();
    const Result<std::string> folder = folderOf(path);
    if (!folder) return folder.error();
    const Result<JsonValue> document = parseJson(*text, path, options.memoryLimit);
    if (!document) return document.error();
    return SceneFileReader(path, *folder, options).read(*document);
}

}  // namespace zscope
