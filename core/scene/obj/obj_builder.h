// Turns the statements of an OBJ file, one after the other, into a mesh with its warnings and counts.
//
// Promise    after the first false answer error() says why, and nothing more may be added
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh.h"
#include "core/scene/obj/material_library.h"
#include "core/scene/obj/memory_budget.h"
#include "core/scene/obj/obj_import.h"
#include "core/scene/obj/statement_stream.h"
#include "core/scene/obj/warning_list.h"
#include "core/scene/triangulate.h"

namespace zscope::obj {

class ObjBuilder {
public:
    ObjBuilder(const std::string& file, const std::string& folder, MemoryBudget budget);

    bool addVertex(const Statement& statement);
    bool addFace(const Statement& statement);
    bool addLibrary(const Statement& statement);
    bool useMaterial(const Statement& statement);
    /// `g a b` puts what follows into both a and b; here that is one group "a b".
    bool useGroup(const Statement& statement);
    bool useObject(const Statement& statement);

    const std::optional<Error>& error() const { return m_error; }
    /// Gives the materials their colours and hands everything over.
    Result<ObjImport> finish(const StatementStream& stream) &&;

private:
    bool                 fail(Trouble kind, std::string sentence, int line);
    bool                 outOfMemory(int line);
    bool                 readCorners(const Statement& statement);
    bool                 readCorner(std::string_view word, int line);
    void                 dropForVertexBeyond(std::string_view written, std::int64_t vertex, int line);
    bool                 keepFace(int line);
    bool                 enterGroup();
    bool                 keepName(std::set<std::string>& names, const std::string& name, int line);
    void                 warnOfJoinedName(std::string_view word, const Statement& statement);
    void                 colourMaterials();
    void                 nameForwardReferences();
    Error                nothingToDraw() const;
    std::vector<Warning> skippedKinds(const StatementStream& stream) const;

    template <class Sentence>
    void dropFace(int line, const Sentence& sentence);
    template <class Sentence>
    void loseVertex(int line, const Sentence& sentence);

    std::string           m_file;
    MemoryBudget          m_budget;
    std::shared_ptr<Mesh> m_mesh = std::make_shared<Mesh>();
    ObjCounts             m_counts;
    WarningList           m_warnings;
    MaterialLibrary       m_library;
    PolygonSplitter       m_splitter;
    std::optional<Error>  m_error;

    std::vector<bool>                 m_unusable;         // by vertex; shorter than the positions once no more follow
    std::vector<std::uint32_t>        m_corners;          // of the face at hand
    std::string                       m_group, m_object;  // names in force
    bool                              m_groupIsEntered = true;
    GroupId                           m_groupId;
    MaterialId                        m_materialId;
    std::map<std::string, GroupId>    m_groups;
    std::map<std::string, MaterialId> m_materials;
    std::vector<int>                  m_materialLine{0};  // where each was first used
    std::set<std::string>             m_groupNames, m_objectNames;
    std::string                       m_firstDrop;  // why the first face was dropped, for a file without any other
    int                               m_firstDropLine = 0;
    /// Of dropped faces: which warning names a vertex that was not read by then, and the vertex, from 1.
    std::vector<std::pair<std::size_t, std::int64_t>> m_beyondLast;
    std::int64_t                                      m_firstDropBeyond = 0;  // the vertex that m_firstDrop names
};

}  // namespace zscope::obj
