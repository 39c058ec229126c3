// Which files the statement `mtllib NAMES` means.
//
// Names      one name with blanks, or several; each may stand in quotes, and a comment may follow. The reading of which
//            the most exists wins
// Where      inside the folder of the OBJ file. For an absolute path, of this machine or another one, the file of that
//            name beside the OBJ file is taken instead
// Limit      kMaxWords words of a statement are looked at
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace zscope::obj {

inline constexpr std::size_t kMaxWords = 32;

struct LibraryName {
    std::string path;     // real; empty if there is none that may be read
    std::string warning;  // why there is none, or that it is another one than the name says; may be empty
};

std::vector<LibraryName> librariesNamed(const std::string& folder, std::string_view names);

}  // namespace zscope::obj
