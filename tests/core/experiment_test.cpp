// Experiments are read as they are written, records are gone on with and joined, and nothing that cannot be compared is
// mixed.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/measure/experiment.h"
#include "core/measure/record.h"

namespace zscope {
namespace {

constexpr const char* kTwoParts = R"({
  "title": {"en": "Growth", "zh_CN": "增长"},
  "baseline": "zbuffer",
  "parts": [
    {"title": "one", "scenes": ["builtin:cubes", {"scene": "builtin:city", "view": "street", "x": 2.5}],
        "algorithms": ["zbuffer", "scanline"],
     "threads": [1, 2], "size": "64x48", "frames": 6, "rounds": 3, "cull": "back", "shade": false, "x": "count"},
    {"title": "two", "scenes": ["builtin:teapot"], "algorithms": ["zbuffer"]}
  ]
})";

Experiment experimentOf(const std::string& text)
{
    auto read = experimentFromJson(text, "e.json");
    EXPECT_TRUE(read) << read.error().sentence;
    return *std::move(read);
}

TEST(Experiment, IsReadAsItIsWritten)
{
    const Experiment experiment = experimentOf(kTwoParts);
    EXPECT_EQ(experiment.title.english, "Growth");
    EXPECT_EQ(experiment.title.chinese, "增长");
    EXPECT_EQ(experiment.baseline, "zbuffer");
    ASSERT_EQ(experiment.parts.size(), 2u);
    const ExperimentPart& one = experiment.parts[0];
    EXPECT_EQ(one.scenes[0].word, "builtin:cubes");
    EXPECT_EQ(one.scenes[1].view, "street");
    EXPECT_EQ(one.scenes[1].x, 2.5);
    EXPECT_EQ(one.algorithms, (std::vector<std::string>{"zbuffer", "scanline"}));
    EXPECT_EQ(one.threads, (std::vector{1, 2}));
    EXPECT_EQ(one.width, 64);
    EXPECT_EQ(one.height, 48);
    EXPECT_EQ(one.frames, 6);
    EXPECT_EQ(one.rounds, 3);
    EXPECT_EQ(one.faceCulling, FaceCulling::Back);
    EXPECT_EQ(one.shade, false);
    EXPECT_FALSE(one.peers);
    EXPECT_TRUE(one.path.empty());
    EXPECT_EQ(one.x.chinese, "count");
    EXPECT_FALSE(experiment.parts[1].hasSize);
    EXPECT_EQ(experiment.parts[1].rounds, 5);

    const auto cases = casesOf(experiment);
    ASSERT_EQ(cases.size(), 3u);
    EXPECT_EQ(cases[2].index, 2u);
    EXPECT_EQ(cases[2].scene->word, "builtin:teapot");
}

TEST(Experiment, KeepsItsDigestWhenOnlyItsTitlesChange)
{
    std::string text = kTwoParts, other = kTwoParts;
    text.replace(text.find("\"one\""), 5, "\"uno\"");
    other.replace(other.find("64x48"), 5, "64x49");
    EXPECT_EQ(experimentOf(text).digest, experimentOf(kTwoParts).digest);
    EXPECT_NE(experimentOf(other).digest, experimentOf(kTwoParts).digest);
}

TEST(Experiment, APartGoesAlongAPathOrIsTimedWithPeers)
{
    const std::string begin = R"({"title":"t","parts":[{"title":"p","algorithms":["zbuffer"],"scenes":["s"],)";
    const auto        path  = experimentOf(begin + R"("path":"p.json","sample":100,"rounds":40}]})").parts.front();
    EXPECT_EQ(path.path, "p.json");
    EXPECT_EQ(path.samples, 100u);
    EXPECT_EQ(path.rounds, 40);  // passes, however few frames one view would have
    const auto peers = experimentOf(begin + R"("peers":true}]})").parts.front();
    EXPECT_TRUE(peers.peers);
    EXPECT_FALSE(peers.shade.has_value());
    EXPECT_NE(experimentOf(begin + R"("path":"p.json"}]})").digest,
              experimentOf(begin + R"("path":"q.json"}]})").digest);
    EXPECT_NE(experimentOf(begin + R"("peers":true}]})").digest, experimentOf(begin + R"("peers":false}]})").digest);
}

TEST(Experiment, ThatIsWrongIsRefusedWithItsLine)
{
    const auto refused = [](const std::string& text, int line, const std::string& word) {
        const auto read = experimentFromJson(text, "e.json");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().file, "e.json");
        EXPECT_EQ(read.error().line, line) << read.error().sentence;
        EXPECT_NE(read.error().sentence.find(word), std::string::npos) << read.error().sentence;
        EXPECT_EQ(read.error().sentence.find("''"), std::string::npos) << read.error().sentence;
    };
    const auto part = [](const std::string& members) { return "{\"title\":\"t\",\n\"parts\":[\n" + members + "]}"; };
    refused("[]", 1, "object");
    refused("{\"title\":\"t\"}", 1, "'parts' is missing");
    refused("{\"parts\":[{}]}", 1, "'title' is missing");
    refused("{\"title\":\"t\",\n\"parts\":[]}", 2, "not empty");
    refused("{\"title\":\"t\",\n\"wrong\":1}", 2, "'wrong'");
    refused("{\"title\":{\"zh_CN\":\"t\"}}", 1, "'en'");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"zbuffer\"]}"), 3, "'scenes' is missing");
    refused(part("{\"title\":\"p\",\"algorithms\":[],\"scenes\":[\"s\"]}"), 3, "'algorithms'");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\n{\"view\":\"v\"}]}"), 4, "no word");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"size\":\"640x\"}"), 4, "WxH");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"size\":\"0x9\"}"), 4, "WxH");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"cull\":\"front\"}"), 4,
            "none or back");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"frames\":0}"), 4,
            "'frames' must be a whole number from 1 to");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\"frames\":4,\n\"rounds\":5}"), 4,
            "'rounds' are parts of the 'frames', so at most 4: only along a 'path'");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"threads\":[-1]}"), 4,
            "'threads' must be a whole number from 0 to 256");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\"threads\":[1,\n257]}"), 4,
            "'threads' must be a whole number from 0 to 256");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"shade\":1}"), 4, "'shade'");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"sample\":0}"), 4, "'sample'");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\n{\"scene\":\"s\",\n\"size\":\"9\"}]}"), 5,
            "WxH");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\n{\"scene\":\"s\",\n\"x\":\"a\"}]}"), 5,
            "'x': 'a' is not a number");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\n{\"scene\":\"s\",\n\"x\":\"inf\"}]}"), 5,
            "'x' must be finite");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"size\":\"16385x20\"}"), 4, "WxH");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\n{\"scene\":\"s\",\n\"choices\":[\"depth\"]}]}"),
            5, "axis=choice");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\"path\":\"f\",\n\"frames\":9}"), 4,
            "as many frames as the path");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\"path\":\"f\",\n\"peers\":true}"), 4,
            "one view");
    refused(part("{\"title\":\"p\",\"algorithms\":[\"a\"],\"scenes\":[\"s\"],\n\"peers\":1}"), 4, "'peers'");
    refused("{\"title\":\"t\",\n", 2, "");
}

TEST(PairedRatio, IsTheMedianAndAnIntervalThatFewRoundsWiden)
{
    const std::vector<double> ones(21, 1.0);
    std::vector<double>       ramp;
    for (int i = 0; i < 21; ++i) ramp.push_back(1 + i);
    const auto of = [&](std::size_t count) {
        return pairedRatio(std::span(ramp).first(count), std::span(ones).first(count));
    };
    EXPECT_EQ(of(1).median, 1);
    EXPECT_EQ(of(5).median, 3);
    EXPECT_EQ(of(5).low, 1);
    EXPECT_EQ(of(5).high, 5);
    // 6 of 21 tosses or fewer on one side: 3.9 % for both sides; 7 or fewer: 18.9 %. Tables of the sign test say 6.
    EXPECT_EQ(of(21).low, 6);
    EXPECT_EQ(of(21).high, 16);
}

RecordCase caseOf(std::size_t index, const std::string& digest)
{
    return {.index       = index,
            .part        = {"p", "p"},
            .x           = {},
            .scene       = "s" + std::to_string(index),
            .sceneDigest = digest,
            .place       = 1,
            .width       = 4,
            .height      = 3,
            .rows        = "[]"};
}

Record recordWith(std::vector<RecordCase> cases)
{
    Record record{recordHeadFor(experimentOf(kTwoParts)), {}};
    for (RecordCase& each : cases) record.add(std::move(each));
    return record;
}

TEST(Record, IsReadBackAsItWasWrittenWhateverTheOrderOfItsCases)
{
    const Record record = recordWith({caseOf(2, "c"), caseOf(0, "a")});
    const auto   read   = recordFromJson(recordToJson(record), "r.json");
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(recordToJson(*read), recordToJson(record));
    EXPECT_EQ(read->cases[0].index, 0u);
    EXPECT_TRUE(read->find(2));
    EXPECT_FALSE(read->find(1));
    EXPECT_TRUE(whyNotComparable(read->head, record.head).empty());
}

TEST(Record, KnowsTheViewOfACaseToTheBit)
{
    RecordCase one = caseOf(0, "a");
    one.word = "builtin:cubes", one.camera.eye = {0.1, 0.2, 0.3}, one.camera.width = 4, one.camera.height = 3,
    one.faceCulling = FaceCulling::Back;
    const auto read = recordFromJson(recordToJson(recordWith({one})), "r.json");
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->cases[0].word, "builtin:cubes");
    EXPECT_EQ(read->cases[0].camera, one.camera);
    EXPECT_EQ(read->cases[0].faceCulling, FaceCulling::Back);
}

TEST(Record, NamesOfRunsLeadBackToTheirPipelines)
{
    for (const Preset& preset : presets()) EXPECT_EQ(pipelineNamed(preset.name), preset.pipeline) << preset.name;
    for (const char* name : {"zbuffer+snap=4-bits+near=drop", "hzb-octree+coherence=last-pyramid",
                             "edge-walk+fault=x-truncated", "zbuffer+fault=no-top-left+fault=box-short"}) {
        const auto pipeline = pipelineNamed(name);
        ASSERT_TRUE(pipeline) << name;
        EXPECT_EQ(nameOf(*pipeline), name);
    }
    for (const char* name : {"", "peer:embree", "zbuffer+", "zbuffer+snap=5-bits", "zbuffer+fault=none-such"})
        EXPECT_FALSE(pipelineNamed(name)) << name;
}

TEST(Record, OfAPieceOfAFileOrOfSomethingElseIsRefused)
{
    const std::string whole = recordToJson(recordWith({caseOf(0, "a")}));
    for (const std::string& text : {whole.substr(0, whole.size() / 2), std::string("[]"), std::string("{\"record\":1}"),
                                    std::string("{\"record\":99}"), std::string()}) {
        const auto read = recordFromJson(text, "r.json");
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().file, "r.json");
    }
}

TEST(Record, NestedDeeperThanAnyOneIsIsRefusedWhereItIs)
{
    const std::string whole = recordToJson(recordWith({caseOf(0, "a")}));
    for (const std::size_t depth : {70u, 1'000u, 200'000u}) {
        std::string       text  = whole;
        const std::size_t place = text.find("\"rows\": []");
        ASSERT_NE(place, std::string::npos);
        text.replace(place, 10, "\"rows\": " + std::string(depth, '[') + std::string(depth, ']'));
        const auto read = recordFromJson(text, "r.json");
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().kind, Trouble::Input);
        EXPECT_EQ(read.error().line,
                  1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
        EXPECT_NE(read.error().sentence.find("nested deeper"), std::string::npos) << read.error().sentence;
    }
}

TEST(Record, WithAValueThatNobodyWroteIsRefusedWithItsLine)
{
    BenchRow row;
    row.simd                = Simd::Scalar;
    row.wrongPixels         = 0;
    RecordCase one          = caseOf(1, "a");
    one.rows                = benchToJson(std::vector{row});
    const std::string whole = recordToJson(recordWith({caseOf(0, "a"), one}));
    ASSERT_TRUE(recordFromJson(whole, "r.json"));
    const auto lineOf = [&](const std::string& text, std::size_t at) {
        return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    };
    // `from` stands in the case of index 1; or before all cases, then the whole record is named.
    const auto refused = [&](const std::string& from, const std::string& to, bool isInCase = true) {
        std::string       text  = whole;
        const std::size_t place = text.rfind(from);
        ASSERT_NE(place, std::string::npos) << from;
        text.replace(place, from.size(), to);
        const auto read = recordFromJson(text, "r.json");
        ASSERT_FALSE(read) << to;
        EXPECT_EQ(read.error().file, "r.json");
        EXPECT_EQ(read.error().line, isInCase ? lineOf(text, text.rfind("  {\n   \"index\"")) : 1) << to << '\n'
                                                                                                   << text;
    };
    for (const char* count : {"-1", "0", "1.5", "1", "1e30", "null"})
        refused("\"case_count\": 3", std::string("\"case_count\": ") + count, std::string(count) == "1");
    for (const char* index : {"-1", "3", "0", "1.5", "\"1\""})
        refused("\"index\": 1", std::string("\"index\": ") + index);
    refused("\"height\": 3", "\"height\": 1e308");
    refused("\"width\": 4", "\"width\": 0");
    refused("\"best_ms\": 0.0", "\"best_ms\": \"x\"");
    refused("\"best_ms\": 0.0", "\"best_ms\": -1");
    refused("\"wrong_pixels\": 0", "\"wrong_pixels\": -1");
    refused("\"threads\": 1", "\"threads\": -1");
    refused("\"claim\": \"exact\"", "\"claim\": \"x\"");
    for (const char* nothing : {"null", "{}", "7"}) {
        std::string text = whole.substr(0, whole.find("\"cases\": [")) + "\"cases\": " + nothing + "}";
        EXPECT_FALSE(recordFromJson(text, "r.json")) << nothing;
    }
    const auto beyond = recordFromJson(whole + std::string("\0}", 2), "r.json");
    ASSERT_FALSE(beyond);
    EXPECT_EQ(beyond.error().line, 1 + std::ranges::count(whole, '\n'));
}

TEST(Record, JoinsWhatCanBeComparedAndNothingElse)
{
    const NamedRecord a{"a.json", recordWith({caseOf(0, "a"), caseOf(2, "c")})},
        b{"b.json", recordWith({caseOf(1, "b"), caseOf(2, "c")})};
    const auto all = joined(std::vector{a, b});
    ASSERT_TRUE(all) << all.error().sentence;
    EXPECT_EQ(all->cases.size(), 3u);
    EXPECT_EQ(recordToJson(*all), recordToJson(recordWith({caseOf(0, "a"), caseOf(1, "b"), caseOf(2, "c")})));

    const NamedRecord otherScene{"c.json", recordWith({caseOf(2, "other")})};
    const auto        refused = joined(std::vector{a, otherScene});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence.find("digests are other and c"), std::string::npos) << refused.error().sentence;

    NamedRecord otherPath                 = otherScene;
    otherPath.record.cases[0].sceneDigest = "c", otherPath.record.cases[0].pathDigest = "p";
    const auto otherWay = joined(std::vector{a, otherPath});
    ASSERT_FALSE(otherWay);
    EXPECT_NE(otherWay.error().sentence.find("camera path"), std::string::npos) << otherWay.error().sentence;

    for (auto change :
         {+[](RecordHead& head) { head.digest = "0"; }, +[](RecordHead& head) { head.version = "0"; },
          +[](RecordHead& head) { head.compiler = "0"; }, +[](RecordHead& head) { head.processor = "abacus"; },
          +[](RecordHead& head) { ++head.cores; }, +[](RecordHead& head) { ++head.caseCount; }}) {
        NamedRecord other = b;
        change(other.record.head);
        EXPECT_FALSE(joined(std::vector{a, other}));
    }
}

TEST(BenchRows, AreReadBackAsTheyWereWritten)
{
    BenchRow row;
    row.scene = "s", row.algorithm = "zbuffer+snap=4-bits", row.claim = Claim::Approximate, row.chosen = "scanline";
    row.threads = 2, row.simd = Simd::Avx2, row.shaded = false, row.pixels = 12, row.wrongPixels = 3,
    row.roundMs = {1.5, 2.5};
    row.figures.emplace();
    row.figures->pixels = 12, row.figures->holes = 1, row.figures->maxDepthSteps = 7;
    row.figures->distanceOnWrongSurface.max = std::numeric_limits<double>::infinity();
    row.counters                            = {{"triangles_in", 9}};
    row.stageMs[2] = 0.25, row.stageQuartiles[2] = {1, 2, 3};
    BenchRow plain;
    plain.simd             = Simd::Scalar;
    const std::string json = benchToJson(std::vector{row, plain});
    const auto        read = benchFromJson(json);
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(benchToJson(*read), json);
    EXPECT_FALSE(benchFromJson("[{\"scene\":1}]"));
    EXPECT_FALSE(benchFromJson("nonsense"));
}

}  // namespace
}  // namespace zscope
