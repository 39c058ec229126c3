// What the command line says before it draws: names of files that cannot be right, numbers of threads, and tables that
// fit.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <nlohmann/json.hpp>

#include "core/frame/faults.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A frame that would take minutes: what is refused in seconds is refused before drawing.
const std::vector<std::string> kLong{"builtin:layers?count=3000", "--size", "8000x8000"};

std::vector<std::string> withLongFrame(std::vector<std::string> words)
{
    words.insert(words.begin() + 1, kLong.begin(), kLong.end());
    return words;
}

bool isPng(const std::string& file) { return contentsOf(file).starts_with("\x89PNG\r\n\x1a\n"); }

TEST_F(Cli, APictureUnderAnEndingOfAnotherFormatIsRefusedBeforeDrawing)
{
    for (const char* ending : {".jpg", ".jpeg", ".bmp", ".gif", ".webp", ".JPG", ".tiff", ".pdf", ".npy"}) {
        const std::string name = path(std::string("x") + ending);
        for (const auto& words :
             {withLongFrame({"render", "-o", name}), withLongFrame({"render", "--show", "depth", "-o", name}),
              withLongFrame({"step", "--grain", "pixel", "--at", "40000000000", "-o", name})}) {
            const Answer answer = run(words);
            EXPECT_EQ(answer.status, 2) << name << '\n' << answer.err;
            EXPECT_NE(answer.err.find("-o writes no ."), std::string::npos) << answer.err;
            EXPECT_NE(answer.err.find("file: let its name end in .png\n"), std::string::npos) << answer.err;
            EXPECT_EQ(std::ranges::count(answer.err, '\n'), 1) << answer.err;
        }
    }
    const Answer sheet = run(withLongFrame({"compare", "--algorithms", "zbuffer,scanline", "-o", path("x.jpg")}));
    EXPECT_EQ(sheet.status, 2) << sheet.err;
    EXPECT_NE(sheet.err.find("-o writes no .jpg file: let its name end in .png or .pdf\n"), std::string::npos);
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Cli, APictureIsWrittenUnderPngInAnyLettersAndUnderANameWithoutEnding)
{
    fs::create_directory(path("folder.jpg"));
    for (const char* name : {"a.png", "b.PNG", "c.Png", "d", ".hidden", "folder.jpg/e"}) {
        const Answer answer = run({"render", kTeapot, "--size", "32x24", "-o", path(name)});
        EXPECT_EQ(answer.status, 0) << name << '\n' << answer.err;
        EXPECT_TRUE(isPng(path(name))) << name;
    }
    EXPECT_EQ(run({"render", kTeapot, "--size", "32x24", "-o", "/dev/null"}).status, 0);
    for (const char* command : {"render", "step", "compare"})
        EXPECT_NE(run({command, "--help"}).out.find("has no"), std::string::npos) << command;
    const Answer sheet =
        run({"compare", kTeapot, "--size", "32x24", "--algorithms", "zbuffer,scanline", "-o", path("s.PDF")});
    EXPECT_TRUE(sheet.status == 2 || contentsOf(path("s.PDF")).starts_with("%PDF")) << sheet.err;
}

TEST_F(Cli, AFileThatCannotBeCreatedIsRefusedBeforeDrawing)
{
    std::string deep;
    while (deep.size() <= 4095) deep += "./";
    struct Wrong {
        std::string name, said;
    };
    for (const auto& [name, said] : {Wrong{path(std::string(252, 'n') + ".png"), "File name too long"},
                                     Wrong{path(deep + "x.png"), "File name too long"},
                                     Wrong{path("nowhere/x.png"), "No such file or directory"}}) {
        for (const char* option : {"-o", "--ids", "--depth", "--stats"}) {
            const Answer answer = run(withLongFrame({"render", option, name}));
            EXPECT_EQ(answer.status, 4) << answer.err;
            EXPECT_TRUE(answer.err.ends_with(": error: cannot be created: " + said + "\n")) << answer.err;
            EXPECT_EQ(std::ranges::count(answer.err, '\n'), 1) << answer.err;
        }
    }
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Cli, LinksStayLinksAndWhatTheyNameIsWritten)
{
    fs::create_directory(path("real"));
    write("real/old.png", "old");
    fs::create_symlink("real/old.png", path("old.png"));
    fs::create_symlink("real/new.png", path("new.png"));
    for (const std::string name : {"old.png", "new.png"}) {
        ASSERT_EQ(run({"render", kTeapot, "--size", "32x24", "-o", path(name)}).status, 0);
        EXPECT_TRUE(fs::is_symlink(path(name))) << name;
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("real/" + name)))) << name;
        EXPECT_TRUE(isPng(path("real/" + name))) << name;
    }
}

TEST_F(Cli, AFileWhoseNameBeginsWithADashIsHintedAt)
{
    for (const char* command : {"info", "render", "verify"}) {
        const Answer answer = run({command, "-dash.obj"});
        EXPECT_EQ(answer.status, 2);
        EXPECT_NE(answer.err.find("'-dash.obj' is read as an option: write the file's name as './-dash.obj'\n"),
                  std::string::npos)
            << answer.err;
    }
    EXPECT_EQ(run({"info", kTeapot, "--bogus"}).err.find("is read as an option"), std::string::npos);
}

TEST_F(Cli, NoThreadsAreOnePerCore)
{
    const auto threads = [this](const std::vector<std::string>& more) {
        std::vector<std::string> words{"render", kTeapot, "--size", "64x48", "--stats", path("s.json")};
        words.insert(words.end(), more.begin(), more.end());
        const Answer answer = run(words);
        EXPECT_EQ(answer.status, 0) << answer.err;
        return json::parse(contentsOf(path("s.json")))["threads"].get<int>();
    };
    const int cores = threads({});
    EXPECT_EQ(threads({"--threads", "0"}), cores);
    ASSERT_EQ(run({"bench", kTeapot, "--size", "64x48", "--algorithms", "zbuffer", "--threads", "0,1", "--frames", "1",
                   "--json", path("b.json")})
                  .status,
              0);
    const json rows = json::parse(contentsOf(path("b.json")));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["threads"], cores);
    EXPECT_EQ(rows[1]["threads"], 1);
    EXPECT_EQ(run({"verify", kTeapot, "--size", "64x48", "--threads", "0"}).status, 0);
    EXPECT_EQ(run({"compare", kTeapot, "--size", "64x48", "--algorithms", "zbuffer,scanline", "--threads", "0",
                   "--require-equal"})
                  .status,
              0);
    for (const char* command : {"render", "verify", "step", "explain", "compare", "bench"})
        EXPECT_NE(run({command, "--help"}).out.find("0: one per core"), std::string::npos) << command;
}

std::size_t longestLine(const std::string& text)
{
    std::size_t        longest = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
    return longest;
}

TEST_F(Cli, ListsFitTheWidthOfTheOutput)
{
    const char* const lists[]{"algorithms", "choices", "scenes", "layers", "grains", "simd", "suites", "faults"};
    ::unsetenv("COLUMNS");
    for (const char* list : lists) EXPECT_LE(longestLine(run({"list", list}).out), 100u) << list;
    const std::string json100 = run({"list", "faults", "--json"}).out;

    ::setenv("COLUMNS", "140", 1);
    const std::string wide = run({"list", "faults"}).out;
    EXPECT_LE(longestLine(wide), 140u);
    EXPECT_GT(longestLine(wide), 110u);
    EXPECT_EQ(run({"list", "faults", "--json"}).out, json100);

    // Nothing is lost: the words of the last column follow each other from line to line.
    std::istringstream lines(wide);
    std::string        head, text;
    std::getline(lines, head);
    const std::size_t column = head.find("title");
    for (std::string line; std::getline(lines, line);) text += line.substr(std::min(column, line.size())) + ' ';
    for (const FaultEntry& fault : faults())
        EXPECT_NE(text.find(std::string(fault.title) + ". " + std::string(fault.cause) + ' ' + std::string(fault.cure)),
                  std::string::npos)
            << fault.word;

    ::setenv("COLUMNS", "60", 1);
    for (const char* list : {"choices", "layers", "grains", "faults"})
        EXPECT_LE(longestLine(run({"list", list}).out), 60u) << list;
    for (const char* odd : {"0", "-3", "wide", "", "1"}) {  // of a single column, words still stay whole
        ::setenv("COLUMNS", odd, 1);
        EXPECT_NE(run({"list", "faults"}).out.find("first-line-rounded"), std::string::npos) << odd;
    }
    ::unsetenv("COLUMNS");
}

}  // namespace
}  // namespace zscope::cli_test
