#include "core/scene/obj/obj_builder.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/numbers.h"

namespace zscope::obj {

namespace {

constexpr std::uint64_t kMaxIndices = std::numeric_limits<std::uint32_t>::max();

/// Working memory of cutting a concave face, per corner; more than box_tree.h and outline.h take together.
constexpr std::uint64_t kSplitBytesPerCorner = 1024;

/// A name in a map and beside it: text twice and the nodes.
std::uint64_t bytesOfName(const std::string& name) { return 2 * name.size() + 256; }

/// `arguments` of a numeric statement end at any '#'.
std::string_view beforeComment(std::string_view arguments) { return arguments.substr(0, arguments.find('#')); }

}  // namespace

ObjBuilder::ObjBuilder(const std::string& file, const std::string& folder, MemoryBudget budget)
    : m_file(file), m_budget(budget), m_library(folder, file)
{
    m_groups.emplace(m_mesh->groups.front(), GroupId{0});
}

bool ObjBuilder::fail(Trouble kind, std::string sentence, int line)
{
    if (!m_error) m_error = Error{kind, std::move(sentence), m_file, line};
    return false;
}

bool ObjBuilder::outOfMemory(int line)
{
    return fail(Trouble::Limit, "the memory limit is reached; the model is too large", line);
}

template <class Sentence>
void ObjBuilder::loseVertex(int line, const Sentence& sentence)
{
    const std::size_t vertex = m_mesh->positions.size() - 1;
    m_unusable.resize(vertex);
    m_unusable.push_back(true);
    m_mesh->positions.back() = dvec3{0.0};
    ++m_counts.unusableVertices;
    m_warnings.add(m_file, line,
                   [&] { return fmt::format("vertex {} {}; faces that use it are left out", vertex + 1, sentence()); });
}

bool ObjBuilder::addVertex(const Statement& statement)
{
    std::vector<dvec3>& positions = m_mesh->positions;
    if (positions.size() >= kMaxIndices)
        return fail(Trouble::Limit, "more vertices than 32 bits can number", statement.line);
    if (!m_budget.makeRoom(positions, 1)) return outOfMemory(statement.line);
    ++m_counts.vertices;
    positions.push_back(dvec3{0.0});

    std::string_view rest = beforeComment(statement.arguments);
    dvec3            read{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = takeWord(rest);
        if (word.empty()) {
            loseVertex(statement.line, [&] { return fmt::format("has {} of 3 coordinates", axis); });
            return true;
        }
        const NumberTrouble trouble = readReal(word, read[axis]);
        if (trouble == NumberTrouble::None) continue;
        loseVertex(statement.line,
                   [&] { return fmt::format("has a coordinate '{}' that {}", quotable(word), describe(trouble)); });
        return true;
    }
    positions.back() = read;

    // A weight or a colour may follow; neither moves the vertex.
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        double ignored = 0;
        if (readReal(word, ignored) == NumberTrouble::None) continue;
        m_warnings.add(m_file, statement.line, [&] {
            return fmt::format("'{}' after the coordinates of vertex {} is ignored", quotable(word), positions.size());
        });
        break;
    }
    return true;
}

template <class Sentence>
void ObjBuilder::dropFace(int line, const Sentence& sentence)
{
    ++m_counts.droppedFaces;
    if (m_firstDrop.empty()) m_firstDrop = fmt::format("line {}: {}", line, sentence()), m_firstDropLine = line;
    m_warnings.add(m_file, line, [&] { return sentence() + "; the face is left out"; });
}

bool ObjBuilder::addFace(const Statement& statement)
{
    ++m_counts.faces;
    if (!readCorners(statement)) return !m_error;
    if (m_corners.size() < 3) {
        dropFace(statement.line, [&] { return fmt::format("face has {} of at least 3 corners", m_corners.size()); });
        return true;
    }
    return keepFace(statement.line);
}

/// False if the face was dropped, or if there is an error().
bool ObjBuilder::readCorners(const Statement& statement)
{
    m_corners.clear();
    std::string_view rest = beforeComment(statement.arguments);
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        if (!m_budget.makeRoom(m_corners, 1)) return outOfMemory(statement.line);
        if (!readCorner(word, statement.line)) return false;
    }
    return true;
}

/// One corner: v, v/vt, v//vn or v/vt/vn. False if the face was dropped.
bool ObjBuilder::readCorner(std::string_view word, int line)
{
    const std::size_t      slash  = word.find('/');
    const std::string_view vertex = word.substr(0, slash);
    const auto             drop   = [&](const auto& sentence) {
        dropFace(line, sentence);
        return false;
    };
    std::int64_t index = 0;
    if (!readIndex(vertex, index))
        return drop([&] { return fmt::format("face has a corner '{}' that is not a vertex index", quotable(word)); });
    if (slash != std::string_view::npos) {
        std::string_view others = word.substr(slash + 1);
        for (int part = 0; part < 2 && !others.empty(); ++part) {
            const std::size_t      end     = others.find('/');
            const std::string_view other   = others.substr(0, end);
            std::int64_t           ignored = 0;
            if (!other.empty() && !readIndex(other, ignored)) break;
            others = end == std::string_view::npos ? std::string_view{} : others.substr(end + 1);
        }
        if (!others.empty())
            return drop(
                [&] { return fmt::format("face has a corner '{}' that is not of the form v/vt/vn", quotable(word)); });
    }
    const auto count = static_cast<std::int64_t>(m_mesh->positions.size());
    if (index == 0) return drop([] { return std::string("face refers to vertex 0, but vertices count from 1"); });
    if (index > count)
        return drop([&] { return fmt::format("face refers to vertex {} of {}", quotable(vertex), count); });
    if (index < -count)
        return drop(
            [&] { return fmt::format("face refers to vertex {}, counting back over {}", quotable(vertex), count); });
    const auto at = static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
    if (at < m_unusable.size() && m_unusable[at])
        return drop([&] { return fmt::format("face uses vertex {}, which has no usable coordinates", at + 1); });
    m_corners.push_back(at);
    return true;
}

bool ObjBuilder::keepFace(int line)
{
    Mesh&             mesh    = *m_mesh;
    const std::size_t corners = m_corners.size();
    if (mesh.corners.size() + corners > kMaxIndices)
        return fail(Trouble::Limit, "more corners of faces than 32 bits can number", line);
    if (mesh.triangles.size() + corners > kMaxTriangles)
        return fail(Trouble::Limit, "more triangles than there are ids", line);
    const bool fits = m_budget.makeRoom(mesh.corners, corners) && m_budget.makeRoom(mesh.firstCorner, 1)
                      && m_budget.makeRoom(mesh.polygonMaterial, 1) && m_budget.makeRoom(mesh.polygonGroup, 1)
                      && m_budget.makeRoom(mesh.firstTriangle, 1) && m_budget.makeRoom(mesh.triangles, corners)
                      && m_budget.makeRoom(mesh.trianglePolygon, corners) && m_budget.makeRoom(mesh.mendedFaces, 1)
                      && (corners <= 4 || m_budget.fits(corners * kSplitBytesPerCorner));
    if (!fits) return outOfMemory(line);
    if (!m_groupIsEntered && !enterGroup()) return outOfMemory(line);

    switch (mesh.addPolygon(m_corners, m_materialId, m_groupId, m_splitter)) {
        case PolygonSplit::Fan:
        case PolygonSplit::Ears:
            break;
        case PolygonSplit::MendedFan:
            ++m_counts.mendedFaces;
            m_warnings.add(m_file, line, [] {
                return std::string("face has no area or crosses itself; it is drawn as a fan from its first corner");
            });
            break;
        case PolygonSplit::Refused:
            dropFace(line, [&] {
                return fmt::format("face is concave and has {} corners, and at most {} are split", corners,
                                   kMaxConcaveCorners);
            });
            return true;
    }
    (corners == 3 ? m_counts.triangles : corners == 4 ? m_counts.quads : m_counts.largerFaces) += 1;
    return true;
}

bool ObjBuilder::addLibrary(const Statement& statement)
{
    m_library.read(statement.arguments, statement.line, m_warnings);
    return true;
}

bool ObjBuilder::useMaterial(const std::string& name, int line)
{
    if (name.empty()) {
        m_materialId = {};
        return true;
    }
    const auto known = m_materials.find(name);
    if (known != m_materials.end()) {
        m_materialId = known->second;
        return true;
    }
    if (!m_budget.take(bytesOfName(name) + sizeof(Material))) return outOfMemory(line);
    m_materialId = MaterialId{static_cast<std::uint32_t>(m_mesh->materials.size())};
    m_materials.emplace(name, m_materialId);
    m_mesh->materials.push_back(Material{.name = name});
    m_materialLine.push_back(line);
    return true;
}

bool ObjBuilder::useGroup(const std::string& name, int line)
{
    m_group          = name;
    m_groupIsEntered = false;
    if (name.empty() || m_groupNames.contains(name)) return true;
    if (!m_budget.take(bytesOfName(name))) return outOfMemory(line);
    m_groupNames.insert(name);
    return true;
}

bool ObjBuilder::useObject(const std::string& name, int line)
{
    m_object         = name;
    m_groupIsEntered = false;
    if (name.empty() || m_objectNames.contains(name)) return true;
    if (!m_budget.take(bytesOfName(name))) return outOfMemory(line);
    m_objectNames.insert(name);
    return true;
}

/// The group of the names in force; it exists from the first face on.
bool ObjBuilder::enterGroup()
{
    std::string name = m_object.empty() ? m_group : m_group.empty() ? m_object : m_object + '/' + m_group;
    if (name.empty()) name = m_mesh->groups.front();
    const auto known = m_groups.find(name);
    if (known == m_groups.end()) {
        if (!m_budget.take(bytesOfName(name) + sizeof(std::string))) return false;
        m_groupId = GroupId{static_cast<std::uint32_t>(m_mesh->groups.size())};
        m_groups.emplace(name, m_groupId);
        m_mesh->groups.push_back(std::move(name));
    } else {
        m_groupId = known->second;
    }
    m_groupIsEntered = true;
    return true;
}

void ObjBuilder::colourMaterials()
{
    for (std::size_t i = 1; i < m_mesh->materials.size(); ++i) {
        Material& material = m_mesh->materials[i];
        if (const Material* found = m_library.find(material.name)) {
            material = *found;
            continue;
        }
        m_warnings.add(m_file, m_materialLine[i], [&] {
            return fmt::format("material '{}' is in no material library; it has the standard colour",
                               quotable(material.name));
        });
    }
}

Error ObjBuilder::nothingToDraw() const
{
    if (m_counts.faces == 0 && m_counts.vertices == 0)
        return {Trouble::Input, "nothing to draw: the file holds no vertices and no faces; is it an OBJ file?", m_file};
    if (m_counts.faces == 0)
        return {Trouble::Input,
                fmt::format("nothing to draw: the file holds {} {} but no faces", m_counts.vertices,
                            m_counts.vertices == 1 ? "vertex" : "vertices"),
                m_file};
    if (m_counts.faces == 1)
        return {Trouble::Input, fmt::format("nothing to draw: the only face cannot be used ({})", m_firstDrop), m_file,
                m_firstDropLine};
    return {
        Trouble::Input,
        fmt::format("nothing to draw: none of the {} faces can be used (the first, {})", m_counts.faces, m_firstDrop),
        m_file, m_firstDropLine};
}

std::vector<Warning> ObjBuilder::skippedKinds(const StatementStream& stream) const
{
    std::vector<Warning> summaries;
    for (const auto& [kind, skipped] : stream.skipped()) {
        const std::string what = kind.empty() ? "statements of further kinds" : fmt::format("statement '{}'", kind);
        summaries.push_back({m_file, skipped.firstLine, fmt::format("{} skipped, {} in all", what, skipped.count)});
    }
    std::ranges::stable_sort(summaries, {}, &Warning::line);
    return summaries;
}

Result<ObjImport> ObjBuilder::finish(const StatementStream& stream) &&
{
    if (m_error) return *m_error;
    if (m_mesh->triangles.empty()) return nothingToDraw();
    colourMaterials();
    m_mesh->droppedFaces       = m_counts.droppedFaces;
    m_counts.groupNames        = m_groupNames.size();
    m_counts.objectNames       = m_objectNames.size();
    m_counts.materialNames     = m_materials.size();
    m_counts.skippedStatements = stream.skippedCount();
    return ObjImport{.mesh      = std::move(m_mesh),
                     .warnings  = std::move(m_warnings).finish(m_file, skippedKinds(stream)),
                     .counts    = m_counts,
                     .libraries = m_library.files()};
}

}  // namespace zscope::obj
