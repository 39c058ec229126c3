// The materials of the MTL files that an OBJ file names.
//
// Files      only inside the folder of the OBJ file (links followed first), only regular ones, each read once, at
//            most kMaxLibraries of at most kMaxLibraryBytes
// Words      in letters of either case: "kd" is "Kd"
// Kept       Kd and d (or 1 - Tr, where there is no d), limited to [0, 1]; of materials of the same name the first.
//            A material without Kd has the standard colour
// Textures   are not read; one warning per library says so
// Promise    whatever is wrong with a library is a warning with its file and line; the faces are drawn all the same
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/mesh.h"
#include "core/scene/obj/warning_list.h"

namespace zscope::obj {

inline constexpr std::size_t kMaxLibraries    = 64;
inline constexpr std::size_t kMaxLibraryBytes = std::size_t{16} << 20;

class MaterialLibrary {
public:
    /// `folder` may be empty: then there is no folder to read from, and every library is missing.
    MaterialLibrary(std::string folder, std::string objFile)
        : m_folder(std::move(folder)), m_objFile(std::move(objFile))
    {}

    /// Reads what the statement `mtllib NAMES` on `line` of the OBJ file names (core/scene/obj/library_names.h).
    void read(std::string_view names, int line, WarningList& warnings);
    /// The material that `name` means, under the name that statement and library agree on; nothing if no library read
    /// so far has it. Tried in turn: both names whole; `name` without what may be a comment; the library's name without
    /// it, if only one reads so; and both without what clearly is one.
    std::optional<Material> find(const std::string& name) const;
    /// The real paths of those that were looked into, whether or not they could be used.
    std::vector<std::string> files() const { return {m_read.begin(), m_read.end()}; }

private:
    /// The materials whose names may be read as one that is shorter.
    struct Shortened {
        std::string whole;
        bool        isComment = false;  // as in NameReading
        bool        isOne     = true;   // only one material reads so
    };
    void readFile(const std::string& path, int line, WarningList& warnings);
    void add(Material material);

    std::string                      m_folder, m_objFile;
    std::set<std::string>            m_read;
    std::set<std::string>            m_statements;  // arguments of mtllib
    std::map<std::string, Material>  m_materials;
    std::map<std::string, Shortened> m_shortened;
};

}  // namespace zscope::obj
