// What the command line writes: arrays that hold the renderer's picture, cameras that come back to the bit, tables
// with the promised columns, and nothing at all where something went wrong.
#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "core/frame/renderer.h"
#include "core/scene/load.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

template <class T>
std::vector<T> npyValues(const std::string& file, const std::string& description)
{
    const std::string bytes = contentsOf(file);
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8)) << file;
    if (bytes.size() < 10) return {};
    const std::size_t start = 10u + static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    EXPECT_NE(bytes.substr(10, start - 10).find(description), std::string::npos) << bytes.substr(10, start - 10);
    std::vector<T> values((bytes.size() - start) / sizeof(T));
    std::memcpy(values.data(), bytes.data() + start, values.size() * sizeof(T));
    return values;
}

struct Reference {
    Scene   scene;
    Picture picture;
};
Reference drawn(const std::string& word, int width, int height)
{
    Reference   reference{*loadScene(word), {}};
    ViewRequest view;
    if (!reference.scene.views.empty()) view = reference.scene.views.front().view;
    view.width  = width;
    view.height = height;
    DrawRequest request;
    request.scene    = std::make_shared<const PreparedScene>(std::make_shared<const Scene>(reference.scene));
    request.camera   = *makeCamera(view, reference.scene.bounds);
    request.pipeline = presets().front().pipeline;
    Frame    frame;
    Renderer renderer;
    EXPECT_TRUE(renderer.draw(request, frame));
    reference.picture = pictureOf(frame.visible);
    return reference;
}

TEST_F(Cli, ArraysHoldTheRenderersPicture)
{
    const Answer answer =
        run({"render", kTeapot, "--size", "257x193", "--ids", path("i.npy"), "--depth", path("d.npy")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const Picture expected = drawn(kTeapot, 257, 193).picture;
    const auto    ids   = npyValues<std::int64_t>(path("i.npy"), "'<i8', 'fortran_order': False, 'shape': (193, 257)");
    const auto    depth = npyValues<float>(path("d.npy"), "'<f4', 'fortran_order': False, 'shape': (193, 257)");
    EXPECT_TRUE(std::ranges::equal(ids, expected.ids.values()));
    EXPECT_TRUE(std::ranges::equal(depth, expected.depth.values()));
    EXPECT_TRUE(std::ranges::any_of(ids, [](std::int64_t id) { return id >= 0; }));
}

TEST_F(Cli, EveryAlgorithmThreadCountAndTargetWritesTheSameBytes)
{
    std::set<std::string> ids, depths;
    for (const Preset& preset : presets()) {
        if (!preset.isExact()) continue;  // by face: the ids are others
        for (const char* threads : {"1", "2", "3"}) {
            for (const char* simd : {"scalar", "auto"}) {
                const Answer answer =
                    run({"render", kTeapot, "--size", "131x97", "--algorithm", std::string(preset.name), "--threads",
                         threads, "--simd", simd, "--ids", path("i.npy"), "--depth", path("d.npy")});
                ASSERT_EQ(answer.status, 0) << answer.err;
                ids.insert(contentsOf(path("i.npy")));
                depths.insert(contentsOf(path("d.npy")));
            }
        }
    }
    EXPECT_EQ(ids.size(), 1u);
    EXPECT_EQ(depths.size(), 1u);
}

TEST_F(Cli, TrianglesAreExportedInTheOrderOfTheirIds)
{
    const std::string word   = "builtin:soccer-field?count=3&seed=5";
    const Answer      answer = run({"export", word, "--triangles", path("t.npy")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const Scene scene  = *loadScene(word);
    const auto  values = npyValues<double>(
        path("t.npy"), "'<f8', 'fortran_order': False, 'shape': (" + std::to_string(scene.triangleCount()) + ", 3, 3)");
    ASSERT_EQ(values.size(), scene.triangleCount() * 9);
    for (std::uint32_t id = 0; id < scene.triangleCount(); id += 97) {
        const InstanceId instance = scene.instanceOf({id});
        const Mesh&      mesh     = scene.meshOf(instance);
        const auto&      corners  = mesh.triangles[id - scene.firstTriangle[instance.value]];
        for (std::size_t c = 0; c < 3; ++c) {
            const dvec3 p = scene.instances[instance.value].toWorld(mesh.positions[corners[c]]);
            EXPECT_EQ(values[id * 9 + c * 3 + 0], p.x);
            EXPECT_EQ(values[id * 9 + c * 3 + 1], p.y);
            EXPECT_EQ(values[id * 9 + c * 3 + 2], p.z);
        }
    }
}

TEST_F(Cli, ACameraComesBackToTheBit)
{
    const std::vector<std::string> view{"--size", "321x123", "--eye",  "1.1,2.2,7.3", "--target", "0.1,0.2,0.3",
                                        "--fov",  "33.3",    "--near", "0.1",         "--far",    "inf"};
    std::vector<std::string>       print{"render", kTeapot, "--print-camera"};
    print.insert(print.end(), view.begin(), view.end());
    const Answer camera = run(print);
    ASSERT_EQ(camera.status, 0) << camera.err;
    write("cam.json", camera.out);
    EXPECT_EQ(run({"render", kTeapot, "--camera", path("cam.json"), "--print-camera"}).out, camera.out);

    std::vector<std::string> byView{"render", kTeapot, "--ids", path("a.npy"), "--depth", path("b.npy")};
    byView.insert(byView.end(), view.begin(), view.end());
    ASSERT_EQ(run(byView).status, 0);
    ASSERT_EQ(
        run({"render", kTeapot, "--camera", path("cam.json"), "--ids", path("c.npy"), "--depth", path("d.npy")}).status,
        0);
    EXPECT_EQ(contentsOf(path("a.npy")), contentsOf(path("c.npy")));
    EXPECT_EQ(contentsOf(path("b.npy")), contentsOf(path("d.npy")));

    const std::vector<std::pair<std::string, std::string>> others{
        {"--size", "64x64"}, {"--eye", "1,2,3"}, {"--target", "1,2,3"}, {"--up", "0,0,1"},
        {"--fov", "30"},     {"--near", "1"},    {"--far", "100"}};
    for (const auto& [option, value] : others)
        EXPECT_EQ(run({"render", kTeapot, "--camera", path("cam.json"), option, value}).status, 2) << option;
    EXPECT_EQ(run({"render", kTeapot, "--camera", path("cam.json"), "--cull", "back"}).status, 0);
}

TEST_F(Cli, StatisticsAddUpAndNameEveryStage)
{
    const Answer answer = run({"render", kTeapot, "--size", "320x200", "--stats", path("s.json")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const json stats = json::parse(contentsOf(path("s.json")));
    EXPECT_EQ(stats["algorithm"], "auto");
    EXPECT_EQ(stats["chosen"], "zbuffer");
    EXPECT_NE(stats["why"].get<std::string>().find("auto begins with zbuffer"), std::string::npos) << stats["why"];
    EXPECT_NE(answer.out.find("auto begins with zbuffer"), std::string::npos) << answer.out;
    EXPECT_EQ(stats["picture"]["width"], 320);
    EXPECT_EQ(stats["picture"]["height"], 200);
    EXPECT_GT(stats["picture"]["covered"].get<int>(), 0);
    EXPECT_GT(stats["scene"]["triangles"].get<int>(), 0);
    EXPECT_FALSE(stats["counters"].empty());
    EXPECT_FALSE(stats["bytes"].empty());
    const std::vector<std::string> stages{"clear", "transform", "cull",   "setup", "prepass",
                                          "build", "raster",    "upkeep", "shade", "other"};
    ASSERT_EQ(stats["stages"].size(), stages.size());
    double sum = 0;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const json& stage = stats["stages"][i];
        EXPECT_EQ(stage["name"], stages[i]);
        EXPECT_TRUE(stage["ran"].is_boolean());
        EXPECT_FALSE(stage["why"].get<std::string>().empty());
        sum += stage["ms"].get<double>();
    }
    EXPECT_NEAR(sum, stats["frame_ms"].get<double>(), 1e-6 + 1e-9 * sum);
}

TEST_F(Cli, StatisticsOfAHierarchyAddUpOverItsDepthsAndTellWhatWasMissed)
{
    const std::string field = "builtin:soccer-field?count=60";
    for (const char* algorithm : {"hzb-octree", "hzb-bvh", "quadtree", "zbuffer"}) {
        SCOPED_TRACE(algorithm);
        ASSERT_EQ(
            run({"render", field, "--size", "320x240", "--algorithm", algorithm, "--stats", path("s.json")}).status, 0);
        const json stats    = json::parse(contentsOf(path("s.json")));
        const json counters = stats["counters"];
        const bool hasTree  = std::string_view(algorithm).starts_with("hzb");
        EXPECT_EQ(stats["hierarchy"].empty(), !hasTree);
        std::map<std::string, std::uint64_t> sums;
        for (const json& depth : stats["hierarchy"]) {
            for (const auto& [name, value] : depth.items())
                if (value.is_number() && name != "depth") sums[name] += value.get<std::uint64_t>();
            EXPECT_EQ(depth["nodes_visited"].get<int>(), depth["nodes_outside"].get<int>()
                                                             + depth["nodes_hidden"].get<int>()
                                                             + depth["nodes_entered"].get<int>());
        }
        for (const char* name : {"nodes_visited", "nodes_outside", "nodes_hidden", "nodes_entered", "nodes_drawn",
                                 "triangles_hidden_by_node", "triangles_hidden", "triangles_drawn", "pyramid_queries",
                                 "pyramid_cells_read"}) {
            if (hasTree) {
                EXPECT_EQ(sums[name], counters[name].get<std::uint64_t>()) << name;
            }
        }
        std::uint64_t written = 0, changed = 0;
        for (const json& level : stats["pyramid"]) {
            written += level["cells_written"].get<std::uint64_t>();
            changed += level["cells_changed"].get<std::uint64_t>();
        }
        EXPECT_EQ(stats["pyramid"].empty(), std::string_view(algorithm) == "zbuffer");
        EXPECT_EQ(written, counters["pyramid_writes"].get<std::uint64_t>());
        EXPECT_EQ(changed, counters["pyramid_levels_updated"].get<std::uint64_t>());
        EXPECT_EQ(counters["updates"].get<std::uint64_t>(),
                  written == 0 ? 0 : stats["pyramid"][0]["cells_written"].get<std::uint64_t>());
        const json missed = stats["missed_culls"], over = stats["over_render"];
        EXPECT_EQ(missed["nodes_entered"], counters["nodes_entered"]);
        EXPECT_EQ(missed["triangles_drawn"], counters["triangles_drawn"]);
        EXPECT_LE(missed["nodes"].get<int>(), missed["nodes_entered"].get<int>());
        EXPECT_LE(missed["triangles"].get<int>(),
                  missed["triangles_drawn"].get<int>() - over["triangles_visible"].get<int>());
        EXPECT_EQ(over["triangles_rasterised"], counters["triangles_drawn"]);
        EXPECT_EQ(over["pixels_covered"], stats["picture"]["covered"]);
        EXPECT_GE(over["triangles"].get<double>(), 1);
        EXPECT_GE(over["fragments"].get<double>(), 1);
    }
    ASSERT_EQ(run({"render", field, "--size", "64x48", "--algorithm", "scanline", "--stats", path("s.json")}).status,
              0);
    EXPECT_TRUE(json::parse(contentsOf(path("s.json")))["missed_culls"].is_null())
        << "a sweep draws no triangle at a time";
}

TEST_F(Cli, AMillionBallsAreDrawnAndVerifiedInLessThanAGibibyte)
{
    const std::string field = "builtin:soccer-field?count=1000000";
    ASSERT_EQ(run({"render", field, "--size", "640x480", "--algorithm", "hzb-octree"}).status, 0);
    EXPECT_EQ(run({"verify", field, "--size", "640x480", "--algorithm", "hzb-octree,hzb-bvh", "--sample", "40"}).status,
              0);
    rusage children{};
    ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &children), 0);
    EXPECT_LT(children.ru_maxrss, 1L << 20) << "KiB, of the largest process";
}

TEST_F(Cli, PicturesCarryWhatReproducesThem)
{
    ASSERT_EQ(run({"render", kTeapot, "--size", "64x48", "--quiet", "-o", path("a.png")}).status, 0);
    ASSERT_EQ(run({"render", kTeapot, "--size", "64x48", "-o", path("b.png"), "--stats=" + path("s.json")}).status, 0);
    const std::string picture = contentsOf(path("a.png"));
    EXPECT_NE(picture.find("zscope-cli render 'builtin:teapot?tessellation=3' --size 64x48"), std::string::npos);
    EXPECT_NE(picture.find("ZScope "), std::string::npos);
    EXPECT_NE(picture.find(json::parse(run({"info", kTeapot, "--json"}).out)["digest"].get<std::string>()),
              std::string::npos);
    EXPECT_EQ(picture, contentsOf(path("b.png"))) << "where outputs go must not change what is in them";
}

TEST_F(Cli, LayersAreDifferentPicturesOfOneFrame)
{
    std::set<std::string> pictures;
    for (const char* layer : {"shaded", "depth", "ids", "tests"}) {
        ASSERT_EQ(run({"render", kTeapot, "--size", "64x48", "--show", layer, "-o", path("l.png")}).status, 0) << layer;
        pictures.insert(contentsOf(path("l.png")).substr(contentsOf(path("l.png")).find("IDAT")));
    }
    EXPECT_EQ(pictures.size(), 4u);
}

TEST_F(Cli, AnOutputThatCannotBeWrittenEndsWithFourAndLeavesNothing)
{
    const std::vector<std::vector<std::string>> commands{
        {"render", kTeapot, "--size", "64x48", "-o"},
        {"render", kTeapot, "--size", "64x48", "--ids"},
        {"render", kTeapot, "--size", "64x48", "--depth"},
        {"render", kTeapot, "--size", "64x48", "--stats"},
        {"export", kTeapot, "--triangles"},
        {"step", kTeapot, "--size", "64x48", "--grain", "frame", "--at", "0", "--state"},
        {"bench", kTeapot, "--size", "64x48", "--frames", "1", "--csv"},
        {"bench", kTeapot, "--size", "64x48", "--frames", "1", "--json"}};
    fs::create_directory(path("folder"));
    for (const std::vector<std::string>& command : commands) {
        for (const std::string& target : {std::string("/dev/full"), path("folder"), path("no/such/file")}) {
            std::vector<std::string> arguments = command;
            arguments.push_back(target);
            const Answer answer = run(arguments);
            EXPECT_EQ(answer.status, 4) << command[0] << ' ' << command.back() << ' ' << target << '\n' << answer.err;
            EXPECT_NE(answer.err.find(target + ": error: "), std::string::npos) << answer.err;
        }
    }
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(Cli, AFileThatMayNotGrowIsAnOutputThatCannotBeWritten)
{
    rlimit unlimited{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &unlimited), 0);
    const rlimit small{4096, unlimited.rlim_max};
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"render", kTeapot, "--size", "64x48", "--ids", path("i.npy")},
                                               {"export", kTeapot, "--triangles", path("t.npy")}}) {
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const Answer answer = run(command);
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &unlimited), 0);
        EXPECT_EQ(answer.status, 4) << answer.err;
        EXPECT_NE(answer.err.find(command.back() + ": error: cannot be written: File too large"), std::string::npos)
            << answer.err;
    }
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Cli, APictureOfASceneWithANameOfAnyBytesCarriesTextThatIsUtf8)
{
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    ASSERT_EQ(run({"render", write("b\xff'\n.obj", obj), "--size", "32x24", "-o", path("p.png")}).status, 0);
    EXPECT_NE(contentsOf(path("p.png")).find("b\\377\\'\\012.obj' --size 32x24"), std::string::npos)
        << "as a shell reads it";
    ASSERT_EQ(run({"render", write("\xE7\x90\x83.obj", obj), "--size", "32x24", "-o", path("p.png")}).status, 0);
    EXPECT_NE(contentsOf(path("p.png")).find("\xE7\x90\x83.obj' --size 32x24"), std::string::npos);
}

TEST_F(Cli, VerifyFindsNoDifferenceAndSaysSoInJson)
{
    const Answer answer = run({"verify", kTeapot, "--size", "129x65", "--algorithm", "all", "--json"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const json rows = json::parse(answer.out);
    ASSERT_EQ(rows.size(), presets().size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const json& row = rows[i];
        EXPECT_EQ(row["exact"], presets()[i].isExact());
        if (presets()[i].claim == Claim::Approximate) continue;
        for (const char* figure : {"holes", "spills", "false_culls"})
            EXPECT_EQ(row[figure], 0) << row["algorithm"] << ' ' << figure;
        if (!presets()[i].isExact()) continue;  // by face: depth is a figure
        for (const char* figure : {"wrong_surface", "depth_bits_differ", "max_depth_steps", "lost_triangles"})
            EXPECT_EQ(row[figure], 0) << row["algorithm"] << ' ' << figure;
    }
    for (const json& row : rows) {
        EXPECT_GT(row["covered"].get<int>(), 0);
    }
    EXPECT_EQ(run({"verify", kTeapot, "--size", "129x65", "--sample", "500"}).status, 0);
}

TEST_F(Cli, EverySuiteRunsByNameOnItsScenesOrOnOthersAndSetsTimesAgainstTheZBuffer)
{
    const json suites = json::parse(run({"list", "suites", "--json"}).out);
    ASSERT_EQ(suites.size(), 4u);
    for (const json& suite : suites) {
        const std::string name = suite["name"];
        SCOPED_TRACE(name);
        for (const json& scene : suite["scenes"]) {
            const std::string word = scene.get<std::string>().substr(0, scene.get<std::string>().find(" ("));
            EXPECT_EQ(word.rfind("builtin:", 0), 0u) << word << ": what a suite draws is there on every machine";
        }
        const Answer answer = run({"bench", "--suite", name, "builtin:soccer-field?count=20", "--size", "96x64",
                                   "--frames", "1", "--threads", "1", "--json", path("b.json")});
        ASSERT_EQ(answer.status, 0) << answer.err;
        json rows = json::array();
        for (const json& row : json::parse(contentsOf(path("b.json"))))
            if (row["shaded"] == true) rows.push_back(row);
        ASSERT_EQ(rows.size(), suite["algorithms"].size());
        bool hasBaseline = false;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            EXPECT_EQ(rows[i]["algorithm"], suite["algorithms"][i]);
            EXPECT_EQ(rows[i]["verified"], true);
            hasBaseline = hasBaseline || rows[i]["algorithm"] == "zbuffer";
        }
        EXPECT_TRUE(hasBaseline);
        for (const char* column : {"median ms", "/ zbuffer", "raster", "textbook: in view", "culled by node",
                                   "by triangle", "share", "nodes"})
            EXPECT_NE(answer.out.find(column), std::string::npos) << column;
        EXPECT_NE(answer.out.find("  1.00  "), std::string::npos) << "the z-buffer against itself";
    }
}

TEST_F(Cli, SevenScenesAreDrawnForComparisonWithOtherRenderersEachVerifiedShadedAndNot)
{
    const Answer answer = run({"bench", "--suite", "peers", "--size", "160x90", "--algorithms", "zbuffer", "--threads",
                               "1", "--frames", "1", "--no-count", "--csv", path("b.csv"), "--json", path("b.json")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const json    rows         = json::parse(contentsOf(path("b.json")));
    constexpr int kTriangles[] = {69'451, 5'120'000, 516'288, 516'288, 200, 200, 1'000'000};
    ASSERT_EQ(rows.size(), 2 * std::size(kTriangles));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        SCOPED_TRACE(rows[i]["scene"]);
        EXPECT_EQ(rows[i]["triangles"], kTriangles[i / 2]);
        EXPECT_EQ(rows[i]["pixels"], 160 * 90);
        EXPECT_EQ(rows[i]["verified"], true);
        EXPECT_EQ(rows[i]["shaded"], i % 2 == 0);
        EXPECT_EQ(rows[i]["stages"]["shade"] == 0, i % 2 == 1);
    }
    const bool standsIn = rows[0]["scene"] == "bunny (stand-in)";
    EXPECT_EQ(answer.err.find("stands in") != std::string::npos, standsIn) << "a stand-in is said to be one";
    std::istringstream lines(contentsOf(path("b.csv")));
    for (std::string line, ending = ",shaded"; std::getline(lines, line); ending = ending == ",1" ? ",0" : ",1")
        EXPECT_TRUE(line.ends_with(ending)) << line;
}

TEST_F(Cli, ASuiteSeesItsScenesThroughItsOwnCamerasWithBackFacesCulledUnlessToldOtherwise)
{
    const auto counters = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"bench",       "--suite",  "peers", "--algorithms", "zbuffer",    "--threads",
                                       "1",           "--frames", "1",     "--no-verify",  "--no-shade", "--json",
                                       path("b.json")};
        words.insert(words.end(), more.begin(), more.end());
        const Answer answer = run(words);
        EXPECT_EQ(answer.status, 0) << answer.err;
        std::vector<json> all;
        for (const json& row : json::parse(contentsOf(path("b.json")))) all.push_back(row["counters"]);
        return all;
    };
    const auto own = counters({"--size", "160x120"});
    ASSERT_EQ(own.size(), 7u);
    EXPECT_NEAR(own[1]["triangles_in"].get<double>() - own[1]["triangles_outside"].get<double>(), 1.72e6, 0.1e6)
        << "of the balls";
    for (const std::size_t i : {4u, 5u})
        EXPECT_EQ(own[i]["pixels_tested"], 160 * 120 * 100) << "each layer covers the picture";
    EXPECT_GT(own[0]["triangles_back_facing"], 20'000);
    EXPECT_EQ(own[6]["triangles_back_facing"], 0) << "the grid faces the eye";

    for (const json& all : counters({"--size", "160x120", "--cull", "none"}))
        EXPECT_EQ(all["triangles_back_facing"], 0);
    EXPECT_LT(counters({"--eye", "0,0,1000", "--size", "160x120"})[6]["pixels_tested"], 5000)
        << "a view that is said replaces the file's";
}

TEST_F(Cli, OtherRenderersDrawTheSamePictureUpToAFewPixelsBesideEdges)
{
    // An open scene of many surfaces, instances turned at random with the eye among them, a street with the near plane
    // in it.
    for (const std::string scene : {"builtin:teapot", "builtin:soccer-field?count=60", "builtin:city?blocks=3"}) {
        for (const std::string cull : {"none", "back"}) {
            SCOPED_TRACE(scene + ' ' + cull);
            const Answer answer =
                run({"bench", scene, "--peers", "--size", "203x151", "--cull", cull, "--algorithms", "zbuffer",
                     "--threads", "1,2", "--frames", "3", "--json", path("p.json"), "--csv", path("p.csv")});
            if (answer.status == 2) {
                EXPECT_NE(answer.err.find("install libosmesa6-dev and libembree-dev"), std::string::npos) << answer.err;
                GTEST_SKIP() << "this program was built without other renderers";
            }
            ASSERT_EQ(answer.status, 0) << "pixels of others that differ are no failure of ours: " << answer.err;
            int peers = 0;
            for (const json& row : json::parse(contentsOf(path("p.json")))) {
                if (!row["algorithm"].get<std::string>().starts_with("peer:")) continue;
                ++peers;
                SCOPED_TRACE(row["algorithm"]);
                EXPECT_EQ(row["shaded"], row["algorithm"] == "peer:llvmpipe");
                EXPECT_FALSE(row["chosen"].get<std::string>().empty()) << "its setting";
                EXPECT_LE(row["wrong_pixels"], 203 * 151 / 200);
                EXPECT_EQ(row["wrong_pixels"], row["counters"]["pixels_that_differ"]);
                EXPECT_GT(row["best_ms"], 0);
            }
            EXPECT_EQ(peers % 2, 0) << "each with one thread and with two";
            EXPECT_GE(peers, 2);
            EXPECT_NE(answer.out.find("geometric mean"), std::string::npos);
        }
    }
    // Ten million triangles are too many to write out: Embree takes the instances.
    const Answer many =
        run({"bench", "builtin:soccer-field?count=3000", "--peers", "--no-shade", "--size", "203x151", "--algorithms",
             "hzb-octree", "--threads", "2", "--frames", "1", "--no-verify", "--no-count", "--json", path("p.json")});
    ASSERT_EQ(many.status, 0) << many.err;
    for (const json& row : json::parse(contentsOf(path("p.json")))) {
        if (row["algorithm"] != "peer:embree") continue;
        EXPECT_NE(row["chosen"].get<std::string>().find("instances"), std::string::npos);
        EXPECT_LE(row["wrong_pixels"], 203 * 151 / 50) << "triangles smaller than pixels";
    }
    EXPECT_EQ(run({"bench", "builtin:glass", "--peers", "--size", "64x48", "--algorithms", "zbuffer", "--frames", "1"})
                  .status,
              3);
}

TEST_F(Cli, BenchTablesHaveThePromisedColumns)
{
    const Answer answer =
        run({"bench", kTeapot, "builtin:cubes", "--size", "160x120", "--algorithms", "zbuffer,scanline", "--threads",
             "1,2", "--frames", "5", "--csv", path("b.csv"), "--json", path("b.json")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    std::istringstream       lines(contentsOf(path("b.csv")));
    std::vector<std::string> rows;
    for (std::string line; std::getline(lines, line);) rows.push_back(line);
    ASSERT_EQ(rows.size(), 1u + 2 * 2 * 2);
    EXPECT_EQ(rows[0],
              "scene,algorithm,threads,simd,verified,wrong_pixels,best_ms,median_ms,q1_ms,q3_ms,triangles,pixels,"
              "build_ms,bytes,clear,transform,cull,setup,prepass,build,raster,upkeep,shade,other");
    for (std::size_t r = 1; r < rows.size(); ++r) {
        std::istringstream       cells(rows[r]);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        ASSERT_EQ(row.size(), 24u) << rows[r];
        EXPECT_EQ(row[4], "1");
        EXPECT_EQ(row[5], "0");
        EXPECT_LE(std::stod(row[6]), std::stod(row[8]));  // best <= q1 <= median <= q3
        EXPECT_LE(std::stod(row[8]), std::stod(row[7]));
        EXPECT_LE(std::stod(row[7]), std::stod(row[9]));
        double stages = 0;
        for (std::size_t s = 14; s < 24; ++s) stages += std::stod(row[s]);
        EXPECT_NEAR(stages, std::stod(row[7]), 1e-5 * 10);
    }
    EXPECT_EQ(json::parse(contentsOf(path("b.json"))).size(), 8u);

    ASSERT_EQ(run({"bench", kTeapot, "--size", "64x48", "--frames", "1", "--no-verify", "--csv", path("n.csv")}).status,
              0);
    EXPECT_NE(contentsOf(path("n.csv")).find(",,,"), std::string::npos) << "not verified is empty, not 1";
}

}  // namespace
}  // namespace zscope::cli_test
