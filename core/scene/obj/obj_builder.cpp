#include "core/scene/obj/obj_builder.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/base/quotable.h"
#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/names.h"
#include "core/scene/obj/numbers.h"

namespace zscope::obj {

namespace {

constexpr std::uint64_t kMaxIndices = std::numeric_limits<std::uint32_t>::max();

/// Working memory of cutting a concave face, per corner; more than box_tree.h and outline.h take together.
constexpr std::uint64_t kSplitBytesPerCorner = 1024;

/// A name in a map and beside it: text twice and the nodes.
std::uint64_t bytesOfName(const std::string& name) { return 2 * name.size() + 256; }

std::string followsFurtherDown(std::int64_t vertex)
{
    return fmt::format("face refers to vertex {}, which follows further down: vertices must come first", vertex);
}

constexpr std::string_view kLeftOut = "; the face is left out";

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
    m_warnings.add(m_file, line, [&] { return sentence() + std::string(kLeftOut); });
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
    if (index > count) {
        dropForVertexBeyond(vertex, index, line);
        return false;
    }
    if (index < -count)
        return drop(
            [&] { return fmt::format("face refers to vertex {}, counting back over {}", quotable(vertex), count); });
    const auto at = static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
    if (at < m_unusable.size() && m_unusable[at])
        return drop([&] { return fmt::format("face uses vertex {}, which has no usable coordinates", at + 1); });
    m_corners.push_back(at);
    return true;
}

void ObjBuilder::dropForVertexBeyond(std::string_view written, std::int64_t vertex, int line)
{
    if (m_firstDrop.empty()) m_firstDropBeyond = vertex;
    if (!m_warnings.isFull()) m_beyondLast.emplace_back(m_warnings.kept().size(), vertex);
    dropFace(line, [&] {
        return fmt::format("face refers to vertex {} of {}", quotable(written), m_mesh->positions.size());
    });
}

/// Only at the end it is known which of the vertices that were missing have followed.
void ObjBuilder::nameForwardReferences()
{
    const auto count = static_cast<std::int64_t>(m_mesh->positions.size());
    for (const auto& [warning, vertex] : m_beyondLast)
        if (vertex <= count) m_warnings.replace(warning, followsFurtherDown(vertex) + std::string(kLeftOut));
    if (m_firstDropBeyond > 0 && m_firstDropBeyond <= count)
        m_firstDrop = fmt::format("line {}: {}", m_firstDropLine, followsFurtherDown(m_firstDropBeyond));
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

void ObjBuilder::warnOfJoinedName(std::string_view word, const Statement& statement)
{
    if (!statement.isJoined) return;
    m_warnings.add(m_file, statement.line, [&] { return joinedNameSentence(word); });
}

bool ObjBuilder::useMaterial(const Statement& statement)
{
    warnOfJoinedName("usemtl", statement);
    const std::string name = printableName(statement.arguments);
    if (name.empty()) {
        m_materialId = {};
        return true;
    }
    const auto known = m_materials.find(name);
    if (known != m_materials.end()) {
        m_materialId = known->second;
        return true;
    }
    if (!m_budget.take(bytesOfName(name) + sizeof(Material))) return outOfMemory(statement.line);
    m_materialId = MaterialId{static_cast<std::uint32_t>(m_mesh->materials.size())};
    m_materials.emplace(name, m_materialId);
    m_mesh->materials.push_back(Material{.name = name});
    m_materialLine.push_back(statement.line);
    return true;
}

bool ObjBuilder::useGroup(const Statement& statement)
{
    warnOfJoinedName("g", statement);
    std::string      all;
    std::string_view rest = statement.arguments;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        if (!all.empty()) all += ' ';
        all += word;
    }
    m_group          = printableName(all);
    m_groupIsEntered = false;
    return keepName(m_groupNames, m_group, statement.line);
}

bool ObjBuilder::useObject(const Statement& statement)
{
    warnOfJoinedName("o", statement);
    m_object         = printableName(statement.arguments);
    m_groupIsEntered = false;
    return keepName(m_objectNames, m_object, statement.line);
}

bool ObjBuilder::keepName(std::set<std::string>& names, const std::string& name, int line)
{
    if (name.empty() || names.contains(name)) return true;
    if (!m_budget.take(bytesOfName(name))) return outOfMemory(line);
    names.insert(name);
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
    std::vector<Material>             kept{m_mesh->materials.front()};
    std::vector<MaterialId>           becomes{MaterialId{0}};
    std::map<std::string, MaterialId> ids;  // two names may be read as one of the library's
    for (std::size_t i = 1; i < m_mesh->materials.size(); ++i) {
        Material& material = m_mesh->materials[i];
        if (auto found = m_library.find(material.name))
            material = *std::move(found);
        else
            m_warnings.add(m_file, m_materialLine[i], [&] {
                return fmt::format("material '{}' is in no material library; it has the standard colour",
                                   quotable(material.name));
            });
        const auto [at, isNew] = ids.try_emplace(material.name, MaterialId{static_cast<std::uint32_t>(kept.size())});
        if (isNew) kept.push_back(std::move(material));
        becomes.push_back(at->second);
    }
    m_mesh->materials = std::move(kept);
    for (MaterialId& id : m_mesh->polygonMaterial) id = becomes[id.value];
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
    nameForwardReferences();
    if (m_mesh->triangles.empty()) return nothingToDraw();
    colourMaterials();
    m_mesh->droppedFaces       = m_counts.droppedFaces;
    m_counts.groupNames        = m_groupNames.size();
    m_counts.objectNames       = m_objectNames.size();
    m_counts.materialNames     = m_mesh->materials.size() - 1;
    m_counts.skippedStatements = stream.skippedCount();
    return ObjImport{.mesh      = std::move(m_mesh),
                     .warnings  = std::move(m_warnings).finish(m_file, skippedKinds(stream)),
                     .counts    = m_counts,
                     .libraries = m_library.files()};
}

}  // namespace zscope::obj
