// `zscope-cli grade` over a class of programs that are right, wrong or hostile: each gets its verdict, the same one
// twice, and nothing of it is left.
#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/sandbox/sandbox.h"
#include "core/measure/reference.h"
#include "core/scene/load.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

namespace fs = std::filesystem;
using Json   = nlohmann::json;

const std::string kScene = "builtin:cubes";

class Grade : public Cli {
protected:
    void SetUp() override
    {
        static const std::optional<std::string> why = cli::whyNoSandbox();
        if (why) GTEST_SKIP() << *why;
        Cli::SetUp();
        for (const char* folder : {"class", "tmp"}) fs::create_directory(path(folder));
        ::setenv("TMPDIR", path("tmp").c_str(), 1);  // where grade makes its private folders
    }
    void TearDown() override
    {
        if (IsSkipped()) return;
        EXPECT_TRUE(fs::is_empty(path("tmp"))) << "grade has left a file";
        ::unsetenv("TMPDIR");
        Cli::TearDown();
    }

    /// A submission: a script "render" that gets the scene, the camera and the folder.
    void submit(const std::string& name, const std::string& script) const
    {
        const std::string folder = path("class/" + name);
        fs::create_directories(folder);
        std::ofstream(folder + "/render") << "#!/bin/sh\nhere=$(dirname \"$0\")\n" << script << '\n';
        fs::permissions(folder + "/render", fs::perms::owner_all);
        fs::copy_file(ZSCOPE_HOSTILE, folder + "/hostile", fs::copy_options::overwrite_existing);
    }
    void submitDump(const std::string& name, const std::string& dump) const
    {
        submit(name, "cp \"$here/made\" \"$3/out.zdump\"");
        std::ofstream(path("class/" + name + "/made"), std::ios::binary) << dump;
    }

    std::vector<std::string> grading(std::vector<std::string> more = {}) const
    {
        std::vector<std::string> words{
            "grade",         kScene,        "--size",         "64x48",
            "--submissions", path("class"), "--program",      "{submission}/render {scene} {camera} {out}",
            "--time-limit",  "2",           "--memory-limit", "96"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static std::map<std::string, Json> rowsOf(const std::string& json)
    {
        std::map<std::string, Json> rows;
        for (const Json& row : Json::parse(json)) rows[row["submission"]] = row;
        return rows;
    }
};

/// What a right program writes; `spoil` changes the ids first.
std::string dumpOf(const std::function<void(std::vector<std::int32_t>&)>& spoil = {})
{
    const auto  scene                 = loadScene(kScene);
    ViewRequest view                  = scene->views.empty() ? ViewRequest() : scene->views.front().view;
    view.width                        = 64;
    view.height                       = 48;
    const Picture             picture = *referencePicture(*scene, *makeCamera(view, scene->bounds), FaceCulling::None);
    std::vector<float>        depth;
    std::vector<std::int32_t> ids;
    const std::vector<std::uint32_t> header{0x01020304, 64, 48, 3, 1, 0, 0, 1, 0};
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            depth.push_back(picture.depth.at(x, y));
            ids.push_back(static_cast<std::int32_t>(picture.ids.at(x, y)));
        }
    if (spoil) spoil(ids);
    std::string bytes  = "ZSDUMP1\n";
    const auto  append = [&bytes](const auto& values) {
        const std::size_t at = bytes.size();
        bytes.resize(at + values.size() * sizeof values[0]);
        std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof values[0]);
    };
    append(header);
    append(depth);
    append(ids);
    return bytes;
}

TEST_F(Grade, GivesEachProgramItsVerdictTwice)
{
    submitDump("right", dumpOf());
    submitDump("wrong", dumpOf([](auto& ids) {
                   std::ranges::replace_if(
                       ids, [](int id) { return id > 20; }, -1);
               }));
    submitDump("no-ids", dumpOf([](auto& ids) { std::ranges::fill(ids, -1); }));
    submitDump("unreadable", "ZSDUMP1\nand so on");
    submit("nothing", "true");
    submit("linked", "ln -s /etc/passwd \"$3/out.zdump\"");
    submit("failed", "echo one >&2; echo 'error: no such thing' >&2; echo three >&2; exit 4");
    submit("not-a-program", "exec \"$here/missing\"");
    const std::string noLibrary =
        "render: error while loading shared libraries: libsoftware-renderer-helper.so.3: cannot "
        "open shared object file. No such file or directory";
    submit("no-library", "echo '" + noLibrary + "' >&2; echo and so on >&2; exit 127");
    submit("crash", "exec \"$here/hostile\" crash");
    submit("loop", "exec \"$here/hostile\" loop");
    submit("memory", "exec \"$here/hostile\" memory");
    submit("text", "exec \"$here/hostile\" text");
    submit("file", "exec \"$here/hostile\" file \"$3/out.zdump\"");
    submit("daemon", "\"$here/hostile\" daemon; cp \"$here/../right/made\" \"$3/out.zdump\"");
    submit("network", "exec \"$here/hostile\" connect 22");
    submit("thief", fmt::format("exec \"$here/hostile\" read {}/right/made", path("class")));
    submit("vandal", fmt::format("exec \"$here/hostile\" write {}/new", path("class")));
    fs::create_directory(path("class/.hidden"));
    fs::copy_file(path("class/right/made"), path("class/file-alone"));  // not a folder, and no program

    const Answer json = run(grading({"--json"}));
    EXPECT_EQ(json.status, 1) << json.err;
    auto                                     rows = rowsOf(json.out);
    const std::map<std::string, std::string> expected{
        {"right", "right"},           {"wrong", "wrong"},           {"no-ids", "wrong"},
        {"unreadable", "unreadable"}, {"nothing", "wrote-nothing"}, {"linked", "unreadable"},
        {"failed", "failed"},         {"not-a-program", "failed"},  {"crash", "crashed"},
        {"no-library", "failed"},     {"loop", "timed-out"},        {"memory", "too-much-memory"},
        {"text", "too-much-output"},  {"file", "too-much-output"},  {"daemon", "failed"},
        {"network", "failed"},        {"thief", "failed"},          {"vandal", "failed"},
        {"file-alone", "failed"}};
    std::map<std::string, std::string> verdicts;
    for (const auto& [name, row] : rows) verdicts[name] = row["verdict"];
    EXPECT_EQ(verdicts, expected);
    EXPECT_FALSE(fs::exists(path("class/new")));
    EXPECT_EQ(rows["failed"]["detail"], "it ended with status 4: error: no such thing");
    EXPECT_EQ(rows["no-library"]["detail"], "it ended with status 127: " + noLibrary);
    EXPECT_NE(rows["not-a-program"]["detail"].get<std::string>().find("missing: not found"), std::string::npos)
        << rows["not-a-program"]["detail"];
    EXPECT_TRUE(rows["crash"]["detail"].get<std::string>().starts_with("signal 11 (SIGSEGV) ended it"));
    EXPECT_EQ(rows["linked"]["detail"], "out.zdump is not a regular file");
    EXPECT_GT(rows["memory"]["peak_mib"], 90);
    EXPECT_GT(rows["loop"]["seconds"], 1.9);
    EXPECT_TRUE(rows["loop"]["check"].is_null());
    EXPECT_EQ(rows["loop"]["detail"], "it was still running after 2 s; compiling counts (--time-limit)");
    EXPECT_TRUE(rows["no-ids"]["check"]["causes"].empty());
    EXPECT_TRUE(rows["no-ids"]["detail"].get<std::string>().starts_with("The depths are right, and every id is -1: "))
        << rows["no-ids"]["detail"];
    EXPECT_GT(rows["wrong"]["check"]["wrong"]["holes"], 100);
    for (const auto& [name, row] : rows)
        EXPECT_EQ(row["detail"].get<std::string>().find("zscope-run"), std::string::npos);

    const Answer first = run(grading({"--threads", "2"})), second = run(grading({"--threads", "1"}));
    EXPECT_EQ(first.out, second.out);
    EXPECT_EQ(std::ranges::count(first.out, '\n') > 17, true) << first.out;
    EXPECT_NE(first.out.find("directory\n"), std::string::npos) << "the whole line of the missing library\n"
                                                                << first.out;
}

TEST_F(Grade, AProgramWithoutSubmissionsStartsWhereGradeRuns)
{
    submitDump("right", dumpOf());
    const fs::path before = fs::current_path();
    fs::current_path(path("class/right"));
    const std::vector<std::string> words{"grade",        kScene,
                                         "--size",       "64x48",
                                         "--program",    "./render {scene} {camera} {out}",
                                         "--gradescope", path("results.json"),
                                         "--junit",      path("junit.xml")};
    const Answer                   answer = run(words);
    const Answer writes = run({"grade", kScene, "--size", "64x48", "--program", "touch new {out}/depth.npy", "--json"});
    fs::current_path(before);
    EXPECT_EQ(answer.status, 0) << answer.err << answer.out;
    const Json results = Json::parse(contentsOf(path("results.json")));
    ASSERT_EQ(results["tests"].size(), 1u);
    EXPECT_EQ(results["tests"][0]["score"], 1);
    EXPECT_EQ(results["tests"][0]["status"], "passed");
    expectFitsSchema(path("junit.xml"));
    expectFitsSchema(path("results.json"));
    EXPECT_NE(contentsOf(path("junit.xml")).find("<testsuites tests=\"1\" failures=\"0\" errors=\"0\">"),
              std::string::npos);
    EXPECT_EQ(Json::parse(writes.out)[0]["verdict"], "failed");  // that folder is for reading
    EXPECT_FALSE(fs::exists(path("class/right/new")));
}

TEST_F(Grade, AnInterruptedRunGoesOnFromItsJournal)
{
    submitDump("a-right", dumpOf());
    submitDump("b-right", dumpOf());
    submit("c-loop", "exec \"$here/hostile\" loop");
    submit("d-nothing", "true");
    const auto words = grading({"--threads", "1", "--journal", path("journal.json"), "--json", "--time-limit", "60"});
    std::vector<std::string> longer = words;
    std::erase(longer, "2");
    longer.erase(std::ranges::find(longer, "--time-limit"));
    const Answer stopped = runAndSignal(longer, SIGINT, 2500);
    EXPECT_EQ(stopped.status, 130) << stopped.err;
    const Json kept = Json::parse(contentsOf(path("journal.json")));
    ASSERT_EQ(kept["rows"].size(), 2u);
    EXPECT_EQ(kept["rows"][0]["submission"], "a-right");

    submitDump("b-right", dumpOf([](auto& ids) { std::ranges::fill(ids, -1); }));  // handed in again
    submit("c-loop", "exit 3");
    const Answer finished = run(longer);
    EXPECT_EQ(finished.status, 1);
    EXPECT_NE(finished.err.find("2 of 4 runs are there"), std::string::npos) << finished.err;
    auto rows = rowsOf(finished.out);
    EXPECT_EQ(rows["a-right"]["seconds"], kept["rows"][0]["seconds"]);
    EXPECT_EQ(rows["b-right"]["verdict"], "wrong");
    EXPECT_EQ(rows["c-loop"]["verdict"], "failed");
    EXPECT_EQ(rows["d-nothing"]["verdict"], "wrote-nothing");

    std::vector<std::string> other       = longer;
    *(std::ranges::find(other, "64x48")) = "80x60";
    const Answer refused                 = run(other);
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("journal of another grading"), std::string::npos) << refused.err;
    EXPECT_EQ(run(grading({"--journal", write("text.json", "{}")})).status, 3);
}

TEST_F(Grade, RefusesWhatCannotWork)
{
    submit("nothing", "true");
    const auto refused = [&](std::vector<std::string> words, const char* says, int status = 2) {
        words.insert(words.begin(), {"grade", kScene});
        const Answer answer = run(words);
        EXPECT_EQ(answer.status, status) << says;
        EXPECT_NE(answer.err.find(says), std::string::npos) << answer.err;
    };
    refused({"--program", "./render"}, "--program needs {out}");
    refused({"--program", "{submission} {out}"}, "there is no --submissions");
    refused({"--program", "render {out}", "--submissions", path("class")}, "--program needs {submission}");
    refused({"--program", "{submission} {out}", "--submissions", path("missing")}, "missing", 3);
    refused({"--program", "{submission} {out}", "--submissions", path("tmp")}, "no submission", 3);
    refused({"--program", "x {out}", "--time-limit", "0"}, "--time-limit");
    refused({"--program", "{submission} {out}", "--submissions", path("class"), "--gradescope", path("x.json")},
            "--gradescope");

    const std::string paths = ::getenv("PATH");
    ::setenv("PATH", path("tmp").c_str(), 1);
    const Answer without = run(grading());
    const Answer anyway  = run(grading({"--no-sandbox", "--json"}));
    ::setenv("PATH", paths.c_str(), 1);
    EXPECT_EQ(without.status, 2);
    EXPECT_NE(without.err.find("bubblewrap (the program bwrap) is not installed; --no-sandbox"), std::string::npos)
        << without.err;
    EXPECT_EQ(Json::parse(anyway.out)[0]["verdict"], "wrote-nothing") << anyway.out;
}

TEST_F(Grade, WithoutASandboxTheLimitsHold)
{
    submitDump("right", dumpOf());
    submit("daemon", "exec \"$here/hostile\" daemon");
    submit("loop", "exec \"$here/hostile\" loop");
    submit("memory", "exec \"$here/hostile\" memory");
    auto rows = rowsOf(run(grading({"--no-sandbox", "--json"})).out);
    EXPECT_EQ(rows["right"]["verdict"], "right");
    EXPECT_EQ(rows["daemon"]["verdict"], "wrote-nothing");
    EXPECT_EQ(rows["loop"]["verdict"], "timed-out");
    EXPECT_EQ(rows["memory"]["verdict"], "too-much-memory");
}

}  // namespace
}  // namespace zscope::cli_test
