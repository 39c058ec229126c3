// What the tests of the OBJ reader share: text in, import out, and a folder of their own for files.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "core/scene/obj/obj_import.h"

namespace zscope::test {

inline Result<ObjImport> read(std::string_view text) { return importObjText(text, "t.obj", ""); }

/// "t.obj:3: sentence" of every warning, one per line.
inline std::string warningsOf(const ObjImport& import)
{
    std::string all;
    for (const Warning& w : import.warnings) all += Error{Trouble::Input, w.sentence, w.file, w.line}.text() + "\n";
    return all;
}

/// A folder that goes when the test ends.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "zscope-XXXXXX").string();
        m_path              = ::mkdtemp(pattern.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(m_path); }
    TemporaryFolder(const TemporaryFolder&)            = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string operator/(const std::string& name) const { return (m_path / name).string(); }
    std::string write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories((m_path / name).parent_path());
        std::ofstream(m_path / name, std::ios::binary) << text;
        return *this / name;
    }

private:
    std::filesystem::path m_path;
};

inline constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace zscope::test
