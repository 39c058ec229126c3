// The materials of the MTL files that an OBJ file names.
//
// Files      only inside the folder of the OBJ file (links followed first), only regular ones, each read once, at
//            most kMaxLibraries of at most kMaxLibraryBytes
// Kept       Kd and d (or 1 - Tr, where there is no d), limited to [0, 1]; of materials of the same name the first.
//            A material without Kd has the standard colour
// Promise    whatever is wrong with a library is a warning with its file and line; the faces are drawn all the same
#pragma once

#include <cstddef>
#include <map>
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

    /// Reads what the statement `mtllib NAMES` on `line` of the OBJ file names: one name with blanks, or several.
    void read(std::string_view names, int line, WarningList& warnings);
    /// nullptr if no library read so far has it. Valid until the next read().
    const Material* find(const std::string& name) const;
    /// The real paths of those that were looked into, whether or not they could be used.
    std::vector<std::string> files() const { return {m_read.begin(), m_read.end()}; }

private:
    void readFile(const std::string& path, int line, WarningList& warnings);

    std::string                     m_folder, m_objFile;
    std::set<std::string>           m_read;
    std::map<std::string, Material> m_materials;
};

}  // namespace zscope::obj
