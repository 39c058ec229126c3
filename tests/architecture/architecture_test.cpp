// The rules of docs/architecture.md, section 2, held against every file of the project.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLines = 600;

const fs::path kRoot = ZSCOPE_SOURCE_DIR;

std::string textOf(const fs::path& file)
{
    std::ifstream      stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

bool isSource(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

/// Sources below a folder, as paths from the root.
std::vector<std::string> sourcesIn(const std::string& folder)
{
    std::vector<std::string> files;
    if (!fs::exists(kRoot / folder)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / folder))
        if (entry.is_regular_file() && isSource(entry.path()))
            files.push_back(entry.path().lexically_relative(kRoot).generic_string());
    std::ranges::sort(files);
    return files;
}

/// Where the comment or the string literal ends that begins there; `at` itself if none does. A regex would go as deep
/// as they are long.
std::size_t endOfNoise(const std::string& text, std::size_t at)
{
    const auto behind = [&](std::string_view last, std::size_t from) {
        const std::size_t found = text.find(last, from);
        return found == std::string::npos ? text.size() : found + last.size();
    };
    const std::string_view rest = std::string_view(text).substr(at);
    if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size());
    if (rest.starts_with("/*")) return behind("*/", at + 2);
    if (rest.starts_with("R\"(")) return behind(")\"", at + 3);
    if (!rest.starts_with('"')) return at;
    for (std::size_t i = at + 1; i < text.size() && text[i] != '\n'; i += text[i] == '\\' ? 2 : 1)
        if (text[i] == '"') return i + 1;
    return at;  // no literal: a character
}

/// The code without comments and without string literals.
std::string codeOf(const std::string& text)
{
    std::string code;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = endOfNoise(text, i);
        code += end > i ? ' ' : text[i];
        i = std::max(end, i + 1);
    }
    return code;
}

struct Includes {
    std::vector<std::string> ours;    // "a/b.h"
    std::vector<std::string> system;  // <a>
};
Includes includesOf(const std::string& text)
{
    static const std::regex include(R"re((^|\n)[ \t]*#[ \t]*include[ \t]*(["<])([^">\n]+)[">])re");
    Includes                includes;
    for (std::sregex_iterator at(text.begin(), text.end(), include), end; at != end; ++at)
        ((*at)[2] == "\"" ? includes.ours : includes.system).push_back((*at)[3]);
    return includes;
}

/// Folder -> the folders it may include, from the table in the document.
using Table = std::map<std::string, std::set<std::string>>;
Table tableOf(const std::string& document)
{
    static const std::regex row(R"re(\n\| `([a-z/]+)` \|([^|\n]*)\|(?=\n))re");
    static const std::regex word("`([a-z/]+)`");
    const std::size_t       start = document.find("| Folder | May include |");
    if (start == std::string::npos) return {};
    const std::string table = document.substr(start, document.find("\n\n", start) + 1 - start);
    Table             rules;
    for (std::sregex_iterator at(table.begin(), table.end(), row), end; at != end; ++at) {
        const std::string      cell    = (*at)[2];
        std::set<std::string>& allowed = rules[(*at)[1]];
        for (std::sregex_iterator w(cell.begin(), cell.end(), word); w != end; ++w) allowed.insert((*w)[1]);
    }
    return rules;
}

const Table& rules()
{
    static const Table table = tableOf(textOf(kRoot / "docs/architecture.md"));
    return table;
}

/// "core/scan/x.h" is in "core/scan"; "app/cli.cpp" is in "app/cli".
bool isIn(const std::string& file, const std::string& folder)
{
    return file.starts_with(folder) && (file[folder.size()] == '/' || file[folder.size()] == '.');
}

/// The longest folder of the table that the file is in: "app/cli/peers/x.h" is in "app/cli/peers".
std::string folderOf(const std::string& file)
{
    std::string longest;
    for (const auto& [folder, allowed] : rules())
        if (isIn(file, folder) && folder.size() > longest.size()) longest = folder;
    return longest;
}

bool mayInclude(const std::string& file, const std::string& included)
{
    const std::string folder = folderOf(file);
    if (folder.empty()) return false;
    if (isIn(included, folder)) return true;
    return std::ranges::any_of(rules().at(folder), [&](const std::string& allowed) { return isIn(included, allowed); });
}

TEST(Architecture, TheTableIsReadAndCanForbid)
{
    ASSERT_GE(rules().size(), 10u) << "the table of docs/architecture.md was not found";
    EXPECT_TRUE(mayInclude("core/scan/a.h", "core/scan/b.h"));
    EXPECT_TRUE(mayInclude("core/scene/obj/a.h", "core/base/result.h"));
    EXPECT_TRUE(mayInclude("app/cli.cpp", "core/frame/renderer.h"));
    EXPECT_FALSE(mayInclude("core/base/result.h", "core/scene/scene.h"));
    EXPECT_FALSE(mayInclude("core/scene/scene.h", "core/frame/renderer.h"));
    EXPECT_FALSE(mayInclude("core/probe/observer.h", "core/fast/lanes/half_space-inl.h"));
    EXPECT_FALSE(mayInclude("core/lesson/replay.h", "ui/window/main_window.h"));
    EXPECT_FALSE(mayInclude("app/cli/render.cpp", "ui/window/main_window.h"));
    EXPECT_EQ(folderOf("app/cli/peers/a.h"), "app/cli/peers");
    EXPECT_EQ(folderOf("app/cli/a.h"), "app/cli");
    EXPECT_FALSE(mayInclude("core/nowhere/a.h", "core/base/result.h"));
    EXPECT_EQ(includesOf("// x\n  #  include \"a/b.h\"\n#include <c>\n").ours, std::vector<std::string>{"a/b.h"});
    EXPECT_EQ(codeOf("a // printf(\n\"exit(\" b").find("printf"), std::string::npos);
}

TEST(Architecture, NobodyIncludesWhatTheTableForbids)
{
    std::size_t checked = 0;
    for (const char* top : {"core", "ui", "app"}) {
        for (const std::string& file : sourcesIn(top)) {
            EXPECT_FALSE(folderOf(file).empty()) << file << " is in a folder that the table does not know";
            for (const std::string& included : includesOf(textOf(kRoot / file)).ours) {
                if (!fs::exists(kRoot / included)) continue;  // generated, or told by the next test
                EXPECT_TRUE(mayInclude(file, included)) << file << " includes " << included;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 100u);
}

TEST(Architecture, IncludesAreWrittenFromTheRoot)
{
    for (const char* top : {"core", "app", "ui"})
        for (const std::string& file : sourcesIn(top))
            for (const std::string& included : includesOf(textOf(kRoot / file)).ours)
                EXPECT_TRUE(fs::exists(kRoot / included) || included.ends_with(".moc") || included.starts_with("ui_"))
                    << file << " includes " << included;
}

TEST(Architecture, CoreAndCommandLineKnowNoQt)
{
    static const std::regex  qt("Q[A-Z][A-Za-z]*(/.*)?|qt.*|qcustomplot.*");
    std::vector<std::string> files = sourcesIn("core");
    std::ranges::copy_if(sourcesIn("app"), std::back_inserter(files),
                         [](const std::string& file) { return isIn(file, "app/cli"); });
    ASSERT_GT(files.size(), 20u);
    for (const std::string& file : files) {
        const Includes includes = includesOf(textOf(kRoot / file));
        for (const auto* list : {&includes.system, &includes.ours})
            for (const std::string& included : *list)
                EXPECT_FALSE(std::regex_match(included, qt)) << file << " includes " << included;
    }
}

TEST(Architecture, CoreNeitherPrintsNorExits)
{
    static const std::regex forbidden(
        R"re(\b(printf|fprintf|vprintf|vfprintf|puts|fputs|putchar|perror|exit|_exit|_Exit|quick_exit|abort|getenv)\s*\(|\bstd::(cout|cerr|clog)\b|\bfmt::print\b)re");
    for (const std::string& file : sourcesIn("core")) {
        const std::string text = textOf(kRoot / file);
        for (const std::string& included : includesOf(text).system) EXPECT_NE(included, "iostream") << file;
        const std::string code = codeOf(text);
        std::smatch       found;
        EXPECT_FALSE(std::regex_search(code, found, forbidden)) << file << " says " << found.str();
    }
}

TEST(Architecture, NoFileIsLongerThanSixHundredLines)
{
    for (const char* top : {"core", "ui", "app", "tests"}) {
        for (const std::string& file : sourcesIn(top)) {
            const std::string text = textOf(kRoot / file);
            EXPECT_LE(static_cast<std::size_t>(std::ranges::count(text, '\n')), kMostLines) << file;
        }
    }
}

TEST(Architecture, WindowFilesSayThatTheyAreGpl)
{
    for (const std::string& file : sourcesIn("ui"))
        EXPECT_NE(textOf(kRoot / file).find("SPDX-License-Identifier: GPL-3.0-or-later"), std::string::npos) << file;
    for (const std::string& file : sourcesIn("core"))
        EXPECT_EQ(textOf(kRoot / file).find("GPL-3.0"), std::string::npos) << file;
}

/// The lecture's text is one lane and one thread.
TEST(Architecture, PlainTextNamesNoLanesThreadsOrInstructionSets)
{
    static const std::regex fast(R"re(\b(hwy|HWY_\w*|hn|omp\w*|simd|_mm\w*|avx\w*|sse\w*)\b|-inl\.h)re",
                                 std::regex::icase);
    std::size_t             checked = 0;
    for (const char* folder : {"core/plain", "core/method"})
        for (const std::string& file : sourcesIn(folder)) {
            std::smatch       found;
            const std::string text = textOf(kRoot / file);
            EXPECT_FALSE(std::regex_search(text, found, fast)) << file << " says " << found.str();
            ++checked;
        }
    EXPECT_GT(checked, 20u);
}

/// Shortcuts are told by no observer and break no rule; lanes are theirs alone.
TEST(Architecture, ShortcutsKnowNoObserverAndNoFaultAndNobodyElseNamesLanes)
{
    static const std::regex watched(R"re(\b(observers?|faults?|FaultSet)\b)re", std::regex::icase),
        lanes(R"re(\b(hwy|HWY_\w*|hn)\b|-inl\.h)re");
    std::size_t checked = 0;
    for (const std::string& file : sourcesIn("core")) {
        const bool        isFast = isIn(file, "core/fast");
        std::smatch       found;
        const std::string text = isFast ? textOf(kRoot / file) : codeOf(textOf(kRoot / file));
        EXPECT_FALSE(std::regex_search(text, found, isFast ? watched : lanes)) << file << " says " << found.str();
        checked += isFast;
    }
    EXPECT_GT(checked, 30u);
}

/// Kernels are written for any number of lanes: a processor's own names stand in the files that are named for them.
TEST(Architecture, IntrinsicsStandInTheFilesNamedForThem)
{
    static const std::regex intrinsic(
        R"re(\b(_mm\d*_\w+|_MM_\w+|__m(128|256|512)\w*|__builtin_ia32_\w+|v(ld|st)\d\w*q_\w+)\b)re");
    const std::set<std::string> allowed{"core/base/ticks.h", "core/fast/lanes/avx512_words-inl.h"};
    std::set<std::string>       found;
    for (const char* top : {"core", "app", "ui"})
        for (const std::string& file : sourcesIn(top))
            if (std::regex_search(codeOf(textOf(kRoot / file)), intrinsic)) found.insert(file);
    EXPECT_EQ(found, allowed);
}

}  // namespace
