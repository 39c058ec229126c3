// Experiments from the command line: records that outlive an interruption, shards that join to the whole, bundled files
// that run.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/measure/approximate_switches.h"
#include "core/measure/experiment.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using Json = nlohmann::json;

constexpr const char* kSmall = R"({"title":"small","question":"which?","baseline":"zbuffer","parts":[
 {"title":"one","size":"40x30","frames":4,"rounds":2,"scenes":["builtin:cubes","builtin:layers?count=3"],
     "algorithms":["zbuffer","scanline","zbuffer+snap=4-bits"]},
 {"title":"two","size":"20x20","frames":2,"rounds":1,"scenes":[{"scene":"builtin:teapot","x":3,"title":"pot"}],
     "algorithms":["zbuffer"]}]})";

/// What a program says that was built without Embree and OSMesa.
constexpr const char* kNobody = "nobody to compare with";

/// A record without anything that differs from run to run.
Json timeless(const std::string& file)
{
    Json record = Json::parse(contentsOf(file));
    for (Json& each : record["cases"])
        for (Json& row : each["rows"])
            for (const char* timed : {"best_ms", "median_ms", "q1_ms", "q3_ms", "read_ms", "parse_ms", "check_ms",
                                      "build_ms", "stages", "stage_quartiles", "round_ms"})
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
    EXPECT_TRUE(contentsOf(path("r.csv"))
                    .starts_with("scene,algorithm,threads,simd,verified,wrong_pixels,best_ms,median_ms,q1_ms,q3_ms,"));
}

TEST_F(Cli, ABenchTimesItsRunsInTurnIfTold)
{
    const auto rounds = [this](const std::vector<std::string>& said) {
        std::vector<std::string> words{"bench",        "builtin:cubes",    "--size",    "40x30",
                                       "--algorithms", "zbuffer,scanline", "--threads", "1,2",
                                       "--json",       path("r.json")};
        words.insert(words.end(), said.begin(), said.end());
        const Answer answer = run(words);
        EXPECT_EQ(answer.status, 0) << answer.err;
        const Json               rows = Json::parse(contentsOf(path("r.json")));
        std::vector<std::size_t> counts;
        for (const Json& row : rows) counts.push_back(row["round_ms"].size());
        return counts;
    };
    EXPECT_EQ(rounds({"--frames", "7"}), (std::vector<std::size_t>{1, 1, 1, 1}));
    EXPECT_EQ(rounds({"--frames", "7", "--rounds", "3"}), (std::vector<std::size_t>{3, 3, 3, 3}));
}

TEST_F(Cli, SecondsAreFilledByTheRunsAndByThePeers)
{
    const Answer answer = run({"bench", "builtin:cubes", "--peers", "--size", "40x30", "--algorithms", "zbuffer",
                               "--threads", "2", "--frames", "1", "--seconds", "0.05", "--json", path("r.json")});
    if (answer.err.find(kNobody) != std::string::npos) GTEST_SKIP() << answer.err;
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const Json& row : Json::parse(contentsOf(path("r.json"))))
        EXPECT_TRUE(row["frames"].get<int>() > 1 || row["median_ms"].get<double>() >= 50)
            << row["algorithm"] << " drew " << row["frames"] << " frames of " << row["median_ms"] << " ms";
}

TEST_F(Cli, ABenchTellsOfEachSceneItsOwnRunsFirstAndThePeersThen)
{
    const std::vector<std::string> scenes{"builtin:cubes", "builtin:teapot"};
    const Answer answer = run({"bench", scenes[0], scenes[1], "--peers", "--size", "40x30", "--algorithms", "zbuffer",
                               "--threads", "1", "--frames", "1", "--json", path("r.json")});
    if (answer.err.find(kNobody) != std::string::npos) GTEST_SKIP() << answer.err;
    ASSERT_EQ(answer.status, 0) << answer.err;
    std::vector<std::pair<std::string, bool>> told;  // scene, whether by a peer; the same ones side by side once
    const Json                                rows = Json::parse(contentsOf(path("r.json")));
    for (const Json& row : rows) {
        const std::pair<std::string, bool> next{row["scene"].get<std::string>(),
                                                row["algorithm"].get<std::string>().starts_with("peer:")};
        if (told.empty() || told.back() != next) told.push_back(next);
    }
    const std::vector<std::pair<std::string, bool>> expected{
        {scenes[0], false}, {scenes[0], true}, {scenes[1], false}, {scenes[1], true}};
    EXPECT_EQ(told, expected);
}

constexpr const char* kTurn = R"({"unit":"scene","keys":[{"frame":0,"eye":[0,0.4,1.6],"target":[0,0,0]},
 {"frame":2,"cut":true,"eye":[0.4,0.4,-1.4],"target":[0,0,0]},{"frame":4,"eye":[0.4,0.4,-1.4],"target":[0,0,0]}]})";

TEST_F(Cli, ABenchAlongACameraPathTellsEveryFrame)
{
    const std::string way = write("way.json", kTurn);
    const Answer answer   = run({"bench", "builtin:soccer-field?count=60", "--path", way, "--size", "80x60", "--frames",
                                 "7", "--threads", "1", "--algorithms", "two-pass,hzb-octree+coherence=last-pyramid",
                                 "--json", path("r.json"), "--csv", path("r.csv")});
    ASSERT_EQ(answer.status, 1) << answer.err;  // a picture was wrong
    EXPECT_NE(answer.out.find("after cuts"), std::string::npos) << answer.out;
    const Json rows = Json::parse(contentsOf(path("r.json")));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["series"]["wrong_pixels"], Json::parse("[0,0,0,0,0]"));
    EXPECT_EQ(rows[0]["round_ms"].size(), 2u);  // two passes have the seven frames
    EXPECT_EQ(rows[1]["series"]["ms"].size(), 5u);
    EXPECT_GT(rows[1]["series"]["wrong_pixels"][2], 0);
    EXPECT_EQ(rows[1]["series"]["lags"], Json::parse(R"([{"cut":2,"wrong_frames":1}])"));
    EXPECT_EQ(rows[1]["series"]["stages"]["raster"].size(), 5u);
}

TEST_F(Cli, APathThatCannotBeFlownIsRefused)
{
    const std::string way     = write("way.json", kTurn);
    const auto        refused = [this](const std::vector<std::string>& more, int status, const std::string& word) {
        std::vector<std::string> all{"bench", "builtin:cubes", "--algorithms", "zbuffer", "--size", "20x20"};
        all.insert(all.end(), more.begin(), more.end());
        const Answer answer = run(all);
        EXPECT_EQ(answer.status, status) << answer.err;
        EXPECT_NE(answer.err.find(word), std::string::npos) << answer.err;
    };
    refused({"--path", way, "--eye", "1,2,3"}, 2, "--eye");
    refused({"--path", way, "--peers"}, 2, "--peers");
    refused({"--sample", "9", "--no-verify"}, 2, "--sample");
    refused({"--path", way, "--sample", "0"}, 2, "--sample");
    refused({"--path", path("nowhere.json")}, 3, "not found");
    refused({"--path", write("bad.json", "{\"keys\":[\n{\"frame\":1}]}")}, 3, "bad.json:2: error:");
}

TEST_F(Cli, AnExperimentAlongAPathGoesOnOnlyAlongTheSamePath)
{
    const std::string way = write("way.json", kTurn);
    const std::string file = write("e.json", "{\"title\":\"t\",\"baseline\":\"zbuffer\",\"parts\":[{\"title\":\"p\",\"path\":\"" + way +
                                                 "\",\"size\":\"40x30\",\"rounds\":2,\"sample\":300,\"scenes\":[\"builtin:cubes\",\"builtin:teapot\"],\"algorithms\":[\"zbuffer\",\"two-pass\"]}]}");
    ASSERT_EQ(run({"bench", "--experiment", file, "--shard", "1/2", "--json", path("r.json")}).status, 0);
    const Answer goesOn = run({"bench", "--experiment", file, "--json", path("r.json")});
    EXPECT_EQ(goesOn.status, 0) << goesOn.err;
    EXPECT_NE(goesOn.out.find("after cuts"), std::string::npos) << goesOn.out;
    EXPECT_EQ(Json::parse(contentsOf(path("r.json")))["cases"].size(), 2u);
    EXPECT_EQ(run({"bench", "--experiment", file, "--shard", "1/2", "--json", path("a.json")}).status, 0);
    std::string other = kTurn;
    other.replace(other.find("1.6"), 3, "1.7");
    write("way.json", other);
    const Answer refused = run({"bench", "--experiment", file, "--json", path("r.json")});
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("another camera path"), std::string::npos) << refused.err;
}

TEST_F(Cli, ASceneOfAnExperimentMayHaveASizeAndChoicesOfItsOwn)
{
    const std::string file = write(
        "e.json",
        R"({"title":"t","baseline":"zbuffer-early","parts":[{"title":"p","x":"operations","size":"40x30","frames":2,
        "sample":50,"algorithms":["zbuffer-early","zbuffer-prepass"],"scenes":[{"scene":"builtin:cubes","x":1},
        {"scene":"builtin:cubes","size":"20x10","choices":["shading-cost=100-operations"],"x":100}]}]})");
    ASSERT_EQ(run({"bench", "--experiment", file, "--json", path("r.json")}).status, 0);
    const Json cases = Json::parse(contentsOf(path("r.json")))["cases"];
    EXPECT_EQ(cases[0]["width"], 40);
    EXPECT_EQ(cases[1]["width"], 20);
    EXPECT_EQ(cases[1]["rows"][1]["pixels"], 200);
    EXPECT_EQ(cases[1]["rows"][1]["algorithm"], "zbuffer-prepass");  // the choice belongs to the scene
    EXPECT_EQ(cases[1]["rows"][1]["samples"], 50);
    std::string wrong = contentsOf(file);
    wrong.replace(wrong.find("100-operations"), 14, "7-operations");
    const Answer refused = run({"bench", "--experiment", write("f.json", wrong)});
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("f.json:3: error:"), std::string::npos) << refused.err;
}

TEST_F(Cli, PeersOfAnExperimentAreInItsRecordAndStayThereWhenItGoesOn)
{
    const std::string file = write(
        "e.json",
        R"({"title":"t","baseline":"zbuffer","parts":[{"title":"p","peers":true,"size":"40x30","frames":2,"rounds":1,
        "threads":[1,2],"scenes":["builtin:cubes","builtin:teapot"],"algorithms":["zbuffer"]}]})");
    const Answer first = run({"bench", "--experiment", file, "--shard", "1/2", "--json", path("a.json")});
    if (first.err.find(kNobody) != std::string::npos) GTEST_SKIP() << first.err;
    ASSERT_EQ(first.status, 0) << first.err;
    ASSERT_EQ(run({"bench", "--experiment", file, "--shard", "2/2", "--json", path("b.json")}).status, 0);
    ASSERT_EQ(run({"merge", path("a.json"), path("b.json"), "-o", path("all.json")}).status, 0);
    const Answer again = run({"bench", "--experiment", file, "--json", path("all.json")});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_NE(again.out.find("peer / this"), std::string::npos) << again.out;
    const Json record = Json::parse(contentsOf(path("all.json")));
    ASSERT_EQ(record["cases"].size(), 2u);
    for (const Json& each : record["cases"]) {
        int peers = 0;
        for (const Json& row : each["rows"])
            peers +=
                std::string(row["algorithm"]).starts_with("peer:") && row["counters"].contains("pixels_that_differ");
        EXPECT_GE(peers, 2);  // one and two threads of at least one
        EXPECT_EQ(peers % 2, 0);
    }
}

TEST_F(Cli, ShardsUnderGnuParallelJoinToWhatOneRunWrites)
{
    if (std::system("command -v parallel > /dev/null 2>&1") != 0) GTEST_SKIP() << "GNU parallel is not installed";
    const std::string file = write("e.json", kSmall);
    ASSERT_EQ(run({"bench", "--experiment", file, "--json", path("whole.json")}).status, 0);
    const std::string shards = "parallel --will-cite --jobs 1 " ZSCOPE_CLI " bench --experiment '" + file
                               + "' --shard {}/2 --json '" + path("part-{}.json") + "' ::: 1 2 > /dev/null 2>&1";
    ASSERT_EQ(std::system(shards.c_str()), 0);
    EXPECT_EQ(timeless(path("part-1.json"))["cases"].size(), 2u);
    EXPECT_EQ(timeless(path("part-2.json"))["cases"].size(), 1u);
    ASSERT_EQ(run({"merge", path("part-2.json"), path("part-1.json"), "-o", path("all.json")}).status, 0);
    EXPECT_EQ(timeless(path("all.json")), timeless(path("whole.json")));
}

TEST_F(Cli, AnInterruptedExperimentLeavesARecordAndGoesOn)
{
    std::string       endless = kSmall;
    const std::string quick   = "\"size\":\"20x20\",\"frames\":2";
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

TEST_F(Cli, AShardWithoutACaseHasARecordThatIsJoinedAndGoneOnWith)
{
    const std::string file = write("e.json", kSmall);
    ASSERT_EQ(run({"bench", "--experiment", file, "--shard", "3/4", "--json", path("c.json")}).status, 0);
    const Answer none = run({"bench", "--experiment", file, "--shard", "4/4", "--json", path("d.json")});
    ASSERT_EQ(none.status, 0) << none.err;
    EXPECT_EQ(Json::parse(contentsOf(path("d.json")))["cases"], Json::array());
    const Answer joined = run({"merge", path("d.json"), path("c.json"), "-o", path("all.json")});
    EXPECT_EQ(joined.status, 0) << joined.err;
    EXPECT_EQ(Json::parse(contentsOf(path("all.json")))["cases"].size(), 1u);
    EXPECT_EQ(run({"bench", "--experiment", file, "--shard", "3/4", "--json", path("d.json")}).status, 0);
    EXPECT_EQ(Json::parse(contentsOf(path("d.json")))["cases"].size(), 1u);
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
    refused(R"("scenes":["builtin:cubes"],"algorithms":["nonsense"])", 3,
            "e.json:1: error: unknown algorithm 'nonsense'");
    refused("\"scenes\":[\"builtin:cubes\"],\"algorithms\":[\"zbuffer\",\n\"nonsense\"]", 3,
            "e.json:2: error: unknown algorithm 'nonsense'");
    refused("\"scenes\":[\n{\"scene\":\"builtin:cubes\",\"choices\":[\"no=such\"]}],\"algorithms\":[\n\"zbuffer\"]", 3,
            "e.json:2: error: ");
    refused("\"scenes\":[\"builtin:cubes\"],\"algorithms\":[\"zbuffer\"],\n\"path\":\"nowhere.json\"", 3,
            "e.json:2: error: ");
    refused(R"("scenes":["builtin:cubes"],"algorithms":["zbuffer+cull=nodes"])", 3, "cannot be drawn");
    refused(R"("scenes":["builtin:nowhere"],"algorithms":["zbuffer"])", 3, "nowhere");
    refused(
        "\"algorithms\":[\"zbuffer\"],\n\"scenes\":[\"builtin:cubes\",\n{\"scene\":\"builtin:city?blocks=2\",\"view\":"
        "\"aboev\"}]",
        3, "e.json:3: error: 'builtin:city?blocks=2' has no view 'aboev': it has above, street");
    refused("\"algorithms\":[\"zbuffer\"],\n\"scenes\":[{\"scene\":\"builtin:cubes\",\"camera\":\"no/cam.json\"}]", 3,
            "e.json:2: error: 'no/cam.json': this file of the project was not found");
    refused("\"algorithms\":[\"zbuffer\"],\n\"scenes\":[{\"scene\":\"builtin:cubes\",\"camera\":\""
                + write("cam.json", "{\n\"eyes\":1}") + "\"}]",
            3, "cam.json:2: error: ");
    refused(R"("algorithms":["zbuffer"],"scenes":["builtin:cubes"],"path":"no/way.json")", 3,
            "e.json:1: error: 'no/way.json': this camera path was not found");
    for (const char* baseline : {"zbufer", "scanline", "all", "auto"}) {
        const std::string wrong =
            R"({"title":"t",)"
            "\n"
            R"("baseline":")"
            + std::string(baseline)
            + R"(","parts":[{"title":"p","scenes":["builtin:cubes"],"algorithms":["zbuffer","zbuffer+depth=late"]}]})";
        const Answer answer = run({"bench", "--experiment", write("e.json", wrong)});
        EXPECT_EQ(answer.status, 3) << baseline;
        EXPECT_NE(answer.err.find("e.json:2: error: unknown baseline '" + std::string(baseline)
                                  + "': choose zbuffer or zbuffer"),
                  std::string::npos)
            << answer.err;
    }
    EXPECT_EQ(run({"bench", "builtin:cubes", "--experiment", "x.json"}).status, 2);
    EXPECT_EQ(run({"bench", "builtin:cubes", "--shard", "1/2"}).status, 2);
    for (const char* shard : {"0/2", "3/2", "1", "a/b", "1/2/3"})
        EXPECT_EQ(run({"bench", "--experiment", write("e.json", kSmall), "--shard", shard}).status, 2) << shard;
}

/// What a still picture's ids and depths do not show: order of blending is a matter of colours.
TEST(BundledExperiments, SpeedAgainstErrorHasEveryApproximateSwitchOnAtLeastFourScenes)
{
    const auto experiment = experimentFromJson(contentsOf(ZSCOPE_ROOT "/assets/experiments/speed-against-error.json"),
                                               "speed-against-error.json");
    ASSERT_TRUE(experiment) << experiment.error().text();
    std::size_t switches = 0;
    for (const char* base : {"zbuffer", "hzb-octree"})
        for (const BenchAlgorithm& each : approximateSwitches(findPreset(base)->pipeline)) {
            const std::size_t plus = each.name.find('+');
            if (plus == std::string::npos) continue;
            ++switches;
            const std::string setting = each.name.substr(plus);
            std::size_t       scenes  = 0;
            for (const ExperimentPart& part : experiment->parts)
                if (std::ranges::any_of(part.algorithms,
                                        [&](const std::string& word) { return word.ends_with(setting); }))
                    scenes += part.scenes.size();
            EXPECT_GE(scenes, 4u) << setting;
        }
    EXPECT_GE(switches, 12u);
}

TEST_F(Cli, EveryBundledExperimentIsWellFormed)
{
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(ZSCOPE_ROOT "/assets/experiments")) {
        ++count;
        // A shard without a case checks all words and measures nothing.
        const Answer answer = run({"bench", "--experiment", entry.path().string(), "--shard", "100000/100000"});
        EXPECT_TRUE(answer.status == 0 || answer.err.find(kNobody) != std::string::npos) << entry.path() << answer.err;
    }
    EXPECT_GE(count, 11);
}

}  // namespace
}  // namespace zscope::cli_test
