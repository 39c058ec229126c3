// The dump header compiles without a warning in each language and with each compiler that is there, and what it writes
// is the file that its head describes, byte for byte.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace zscope {
namespace {

namespace fs = std::filesystem;

/// Exit status of a command of the shell.
int statusOf(const std::string& command)
{
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000;
}

std::string contentsOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

template <class T>
std::string bytesOf(const std::vector<T>& values)
{
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

class Dump : public testing::Test {
protected:
    void SetUp() override
    {
        std::string pattern = (fs::temp_directory_path() / "zscope-dump-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        m_folder = pattern;
    }
    void TearDown() override { fs::remove_all(m_folder); }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }
    /// Exit status of the compiler, which makes the program "writer".
    int compile(const std::string& compilerAndOptions) const
    {
        return statusOf(fmt::format("{} -I '{}/assets/homework' '{}/tests/homework/dump_writer.c' -o '{}'",
                                    compilerAndOptions, ZSCOPE_SOURCE_DIR, ZSCOPE_SOURCE_DIR, path("writer")));
    }
    /// Status and file of one run; no file: nullopt.
    std::pair<int, std::optional<std::string>> write(const char* which) const
    {
        const std::string file   = path("out.zdump");
        const int         status = statusOf(fmt::format("'{}' '{}' {}", path("writer"), file, which));
        if (!fs::exists(file)) return {status, std::nullopt};
        const std::string bytes = contentsOf(file);
        fs::remove(file);
        return {status, bytes};
    }

private:
    fs::path m_folder;
};

TEST_F(Dump, CompilesEverywhereAndWritesItsFormat)
{
    const std::vector<std::uint32_t> all{0x01020304, 3, 2, 15, 2, 2, 3, 2, 0},
        depthOnly{0x01020304, 2, 3, 1, 1, 0, 0, 0, 0}, idsAndProjection{0x01020304, 6, 1, 10, 0, 0, 2, 1, 0};
    const std::string   depth = bytesOf<float>({0, 0.25f, 0.5f, 0.75f, 1, 0.125f});
    const std::string   ids   = bytesOf<std::int32_t>({-1, 0, 1, 2, 70000, -1});
    std::vector<double> view, projection;
    for (int i = 0; i < 16; ++i) {
        view.push_back(i + 0.5);
        projection.push_back(-i / 3.0);
    }
    const std::string magic = "ZSDUMP1\n";

    int compiled = 0;
    for (const std::string& compiler : std::vector<std::string>{"gcc", "clang", "g++", "clang++"}) {
        if (statusOf(fmt::format("command -v {} >/dev/null", compiler)) != 0) continue;
        const bool plain = compiler == "gcc" || compiler == "clang";
        for (const std::string& standard :
             plain ? std::vector<std::string>{"c99", "c11", "c17"}
                   : std::vector<std::string>{"c++98", "c++11", "c++14", "c++17", "c++20"}) {
            const std::string how =
                fmt::format("{}{} -std={} -Wall -Wextra -pedantic -pedantic-errors -Wconversion -Wshadow -Werror",
                            compiler, plain ? "" : " -x c++", standard);
            SCOPED_TRACE(how);
            ASSERT_EQ(compile(how), 0);
            ++compiled;
            using Answer = std::pair<int, std::optional<std::string>>;
            EXPECT_EQ(write("all"),
                      Answer(0, magic + bytesOf(all) + bytesOf(view) + bytesOf(projection) + depth + ids));
            EXPECT_EQ(write("depth"), Answer(0, magic + bytesOf(depthOnly) + depth));
            EXPECT_EQ(write("ids"), Answer(0, magic + bytesOf(idsAndProjection) + bytesOf(projection) + ids));
            for (const char* wrong : {"nothing", "size", "large", "contradiction"})
                EXPECT_EQ(write(wrong), Answer(1, std::nullopt)) << wrong;
            EXPECT_EQ(statusOf(fmt::format("'{}' '{}' all", path("writer"), path("missing/out.zdump"))), 2);
        }
    }
    EXPECT_GE(compiled, 3);  // the compiler of these tests is one of them
}

/// A disc that is full leaves no half of a file: a limit on the size of files stands in for it.
TEST_F(Dump, AFileThatCannotBeWrittenWholeIsRemoved)
{
    ASSERT_EQ(compile("c++ -x c++"), 0);
    const std::string file = path("out.zdump");
    EXPECT_EQ(statusOf(fmt::format("trap '' XFSZ; ulimit -f 0; '{}' '{}' all", path("writer"), file)), 2);
    EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace zscope
