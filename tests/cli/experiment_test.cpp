// Experiments from the command line: records that outlive an interruption, shards that join to the whole, bundled files that run.
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using Json = nlohmann::json;

constexpr const char* kSmall = R"({"title":"small","question":"which?","baseline":"zbuffer","parts":[
 {"title":"one","size":"40x30","frames":4,"rounds":2,"scenes":["builtin:cubes","builtin:layers?count=3"],"algorithms":["zbuffer","scanline","zbuffer+snap=4-bits"]},
 {"title":"two","size":"20x20","frames":2,"rounds":1,"scenes":[{"scene":"builtin:teapot","x":3,"title":"pot"}],"algorithms":["zbuffer"]}]})";

/// A record without anything that differs from run to run.
Json timeless(const std::string& file)
{
    Json record = Json::parse(contentsOf(file));
    for (Json& each : record["cases"])
        for (Json& row : each["rows"])
            for (const char* timed : {"best_ms", "median_ms", "q1_ms", "q3_ms", "read_ms", "parse_ms", "check_ms", "build_ms", "stages", "stage_quartiles", "round_ms"})
                row.erase(timed);
    return record;
}

TEST_F(Cli, AnExperimentIsMeasuredAndItsRecordHoldsEveryCase)
{
    const std::string file   = write("e.json", kSmall);
    const Answer      answer = run({"bench", "--experiment", file, "--json", path("r.json"), "--csv", path("r.csv")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NE(answer.out.find("/ zbuffer"), std::string::npos) << answer.out;
    const Json record = Json::parse(contentsOf(path("r.json")));
    ASSERT_EQ(record["cases"].size(), 3u);
    EXPECT_EQ(record["case_count"], 3);
    EXPECT_EQ(record["cases"][0]["rows"].size(), 3u);
    EXPECT_EQ(record["cases"][0]["rows"][0]["round_ms"].size(), 2u);
    EXPECT_EQ(record["cases"][2]["scene"], "pot");
    EXPECT_EQ(record["cases"][2]["place"], 3);
    EXPECT_GT(record["cases"][0]["rows"][2]["wrong_pixels"], 0);  // said to be approximate: no failure
    EXPECT_TRUE(contentsOf(path("r.csv")).starts_with("scene,algorithm,threads,simd,verified,wrong_pixels,best_ms,median_ms,q1_ms,q3_ms,"));
}

TEST_F(Cli, ShardsUnderGnuParallelJoinToWhatOneRunWrites)
{
    if (std::system("command -v parallel > /dev/null 2>&1") != 0) GTEST_SKIP() << "GNU parallel is not installed";
    const std::string file = write("e.json", kSmall);
    ASSERT_EQ(run({"bench", "--experiment", file, "--json", path("whole.json")}).status, 0);
    const std::string shards = "parallel --will-cite --jobs 1 " ZSCOPE_CLI " bench --experiment '" + file + "' --shard {}/2 --json '" + path("part-{}.json") +
                               "' ::: 1 2 > /dev/null 2>&1";
    ASSERT_EQ(std::system(shards.c_str()), 0);
    EXPECT_EQ(timeless(path("part-1.json"))["cases"].size(), 2u);
    EXPECT_EQ(timeless(path("part-2.json"))["cases"].size(), 1u);
    ASSERT_EQ(run({"merge", path("part-2.json"), path("part-1.json"), "-o", path("all.json")}).status, 0);
    EXPECT_EQ(timeless(path("all.json")), timeless(path("whole.json")));
}

TEST_F(Cli, AnInterruptedExperimentLeavesARecordAndGoesOn)
{
    std::string endless = kSmall;
    const std::string quick = "\"size\":\"20x20\",\"frames\":2";
    endless.replace(endless.find(quick), quick.size(), "\"size\":\"1280x960\",\"frames\":90000");
    const std::string file = write("e.json", endless);
    EXPECT_EQ(run({"bench", "--experiment", file, "--shard", "1/3", "--json", path("r.json")}).status, 0);
    const Json begun = timeless(path("r.json"));
    ASSERT_EQ(begun["cases"].size(), 1u);
    // Cases 0 and 1 are soon there; the last would take long. A process that is killed cleans nothing up.
    const Answer killed = runAndSignal({"bench", "--experiment", file, "--json", path("r.json")}, SIGKILL, 3000);
    EXPECT_EQ(killed.status, 1000 + SIGKILL);
    const Json left = timeless(path("r.json"));
    EXPECT_GE(left["cases"].size(), 1u);
    EXPECT_LE(left["cases"].size(), 2u);
    EXPECT_EQ(left["cases"][0], begun["cases"][0]);
    const Answer goesOn = run({"bench", "--experiment", file, "--shard", "2/3", "--json", path("r.json")});
    EXPECT_EQ(goesOn.status, 0) << goesOn.err;
    EXPECT_NE(goesOn.err.find("going on with"), std::string::npos) << goesOn.err;
    EXPECT_EQ(timeless(path("r.json"))["cases"].size(), 2u);
}

TEST_F(Cli, ARecordOfAnotherExperimentOrSceneIsNotGoneOnWith)
{
    const std::string file = write("e.json", kSmall);
    ASSERT_EQ(run({"bench", "--experiment", file, "--shard", "1/3", "--json", path("r.json")}).status, 0);
    std::string other = kSmall;
    other.replace(other.find("40x30"), 5, "40x31");
    const Answer refused = run({"bench", "--experiment", write("f.json", other), "--json", path("r.json")});
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("different questions"), std::string::npos) << refused.err;

    std::string record = contentsOf(path("r.json"));
    const auto  digest = record.find("\"scene_digest\": \"");
    record.replace(digest + 17, 4, "ffff");
    const Answer otherScene = run({"bench", "--experiment", file, "--json", write("s.json", record)});
    EXPECT_EQ(otherScene.status, 3);
    EXPECT_NE(otherScene.err.find("another scene"), std::string::npos) << otherScene.err;
    EXPECT_EQ(run({"merge", path("r.json"), path("s.json"), "-o", path("m.json")}).status, 3);
    EXPECT_FALSE(std::filesystem::exists(path("m.json")));
}

TEST_F(Cli, AnExperimentWithWordsNobodyKnowsIsRefusedBeforeItRuns)
{
    const auto refused = [this](const std::string& part, int status, const std::string& word) {
        const std::string file   = write("e.json", "{\"title\":\"t\",\"parts\":[{\"title\":\"p\"," + part + "}]}");
        const Answer      answer = run({"bench", "--experiment", file});
        EXPECT_EQ(answer.status, status) << answer.err;
        EXPECT_NE(answer.err.find(word), std::string::npos) << answer.err;
    };
    refused(R"("scenes":["builtin:cubes"],"algorithms":["nonsense"])", 3, "e.json:1: error: unknown algorithm 'nonsense'");
    refused(R"("scenes":["builtin:cubes"],"algorithms":["zbuffer+cull=nodes"])", 3, "cannot be drawn");
    refused(R"("scenes":["builtin:nowhere"],"algorithms":["zbuffer"])", 3, "nowhere");
    EXPECT_EQ(run({"bench", "builtin:cubes", "--experiment", "x.json"}).status, 2);
    EXPECT_EQ(run({"bench", "builtin:cubes", "--shard", "1/2"}).status, 2);
    for (const char* shard : {"0/2", "3/2", "1", "a/b", "1/2/3"})
        EXPECT_EQ(run({"bench", "--experiment", write("e.json", kSmall), "--shard", shard}).status, 2) << shard;
}

TEST_F(Cli, EveryBundledExperimentIsWellFormed)
{
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(ZSCOPE_ROOT "/assets/experiments")) {
        ++count;
        // A shard without a case checks all words and measures nothing.
        const Answer answer = run({"bench", "--experiment", entry.path().string(), "--shard", "100000/100000"});
        EXPECT_EQ(answer.status, 0) << entry.path() << answer.err;
    }
    EXPECT_GE(count, 9);
}

}  // namespace
}  // namespace zscope::cli_test
