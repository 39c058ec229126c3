// The words of the command line and what each mistake costs: exit statuses, sentences, lists.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "core/frame/pipeline.h"
#include "core/frame/renderer.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;

const std::string kCubes = "builtin:cubes";

TEST_F(Cli, TheTimesOfLoadingAreToldApartWhereTheyAreAskedFor)
{
    std::ofstream(path("m.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n";
    std::ofstream(path("s.json")) << R"({"meshes": {"m": {"obj": "m.obj"}}, "instances": [{"mesh": "m"}]})";
    const std::string files[] = {path("m.obj"), path("s.json")};
    for (const std::string& file : files) {
        const json info = json::parse(run({"info", file, "--json", "--times"}).out);
        for (const char* part : {"read_ms", "parse_ms", "check_ms", "prepare_ms"})
            EXPECT_GT(info["times"][part], 0) << file << ' ' << part;
        EXPECT_FALSE(json::parse(run({"info", file, "--json"}).out).contains("times"));
        for (const char* part : {"read", "parse", "check", "prepare"})
            EXPECT_NE(run({"info", file, "--times"}).out.find(part), std::string::npos);
        ASSERT_EQ(run({"bench", file, "--size", "32x24", "--frames", "1", "--algorithms", "zbuffer", "--json",
                       path("t.json")})
                      .status,
                  0);
        std::ifstream stream(path("t.json"));
        for (const json& row : json::parse(stream))
            for (const char* part : {"read_ms", "parse_ms", "check_ms", "build_ms"})
                EXPECT_GT(row[part], 0) << file << ' ' << part;
    }
}

TEST_F(Cli, EveryMistakeOnTheCommandLineEndsWithTwoAndSaysWhat)
{
    struct Mistake {
        std::vector<std::string> arguments;
        std::string              said;  // somewhere on standard error
    };
    const std::vector<Mistake> mistakes{
        {{}, "subcommand"},
        {{"draw"},
         "render, info, export, verify, check, grade, audit, step, explain, lesson, compare, bench, merge or list"},
        {{"illuminate", kCubes}, "unknown command"},
        {{"render"}, "SCENE"},
        {{"render", "builtin:no-such-scene"}, "list scenes"},
        {{"render", kCubes, "--bogus"}, "--bogus"},
        {{"render", kCubes, "extra"}, "extra"},
        {{"render", kCubes, "--size", "0x0"}, "0x0"},
        {{"render", kCubes, "--size", "100000x100000"}, "16384"},
        {{"render", kCubes, "--size", "99999999999999999999x1"}, "--size"},
        {{"render", kCubes, "--size", "640"}, "--size"},
        {{"render", kCubes, "--size", "640x480x3"}, "--size"},
        {{"render", kCubes, "--size", "-640x480"}, "--size"},
        {{"render", kCubes, "--size", "1e3x480"}, "--size"},
        {{"render", kCubes, "--size", "64x64", "--size", "32x32"}, "--size"},
        {{"render", kCubes, "--eye", "1,2"}, "--eye"},
        {{"render", kCubes, "--eye", "1,2,nan"}, "--eye"},
        {{"render", kCubes, "--eye", "1,2,inf"}, "--eye"},
        {{"render", kCubes, "--eye", "1,2,3x"}, "--eye"},
        {{"render", kCubes, "--eye", "1,2,3,4"}, "--eye"},
        {{"render", kCubes, "--eye", "1,2,1e999"}, "--eye"},
        {{"render", kCubes, "--eye", "1,1,1", "--target", "1,1,1"}, "same point"},
        {{"render", kCubes, "--eye", "0,9,0", "--target", "0,0,0"}, "parallel"},
        {{"render", kCubes, "--fov", "0"}, "180"},
        {{"render", kCubes, "--fov", "180"}, "180"},
        {{"render", kCubes, "--fov", "nan"}, "--fov"},
        {{"render", kCubes, "--near", "0"}, "near"},
        {{"render", kCubes, "--near", "-1"}, "near"},
        {{"render", kCubes, "--near", "inf"}, "--near"},
        {{"render", kCubes, "--near", "5", "--far", "5"}, "far"},
        {{"render", kCubes, "--cull", "front"}, "none or back"},
        {{"render", kCubes, "--algorithm", "zbufer"}, "choose zbuffer, edge-walk, "},
        {{"render", kCubes, "--algorithm", "all"}, "algorithm"},
        {{"render", kCubes, "--algorithm", "zbuffer,scanline"}, "algorithm"},
        {{"render", kCubes, "--set", "scan"}, "axis=choice"},
        {{"render", kCubes, "--set", "scan=magic"}, "magic"},
        {{"render", kCubes, "--set", "snap=4-bits", "--set", "snap=12-bits"}, "'snap' is chosen twice"},
        {{"render", kCubes, "--algorithm", "zbuffer+snap=4-bits+snap=12-bits"}, "'snap' is chosen twice"},
        {{"render", kCubes, "--algorithm", "zbuffer+depth"}, "axis=choice"},
        {{"render", kCubes, "--algorithm", "zbuffer+depth=soon"}, "deferred, late, early, zcull, prepass"},
        {{"render", kCubes, "--algorithm", "zbuffer+depth=zcull+scan=edge-walk"}, "knows no tiles"},
        {{"render", kCubes, "--algorithm", "scanline+depth=late"}, "shades it once"},
        {{"render", kCubes, "--set", "taste=sweet"}, "taste"},
        {{"render", kCubes, "--threads=-1"}, "--threads"},
        {{"render", kCubes, "--threads=-1"}, "--threads"},
        {{"render", kCubes, "--threads", "257"}, "--threads wants a whole number from 0 to 256"},
        {{"render", kCubes, "--threads", "two"}, "--threads"},
        {{"render", kCubes, "--threads", "99999999999999999999"}, "--threads"},
        {{"render", kCubes, "--simd", "mmx"}, "auto, scalar"},
        {{"render", kCubes, "--memory-limit", "0"}, "--memory-limit"},
        {{"render", kCubes, "--show", "depth"}, "-o"},
        {{"render", kCubes, "-o", path("x.png"), "--show", "heat"}, "shaded, depth, ids or tests"},
        {{"verify", kCubes, "--algorithm", "zbuffer,,scanline"}, "''"},
        {{"verify", kCubes, "--sample", "0"}, "--sample"},
        {{"export", kCubes}, "--triangles"},
        {{"step", kCubes, "--count"}, "--grain"},
        {{"step", kCubes, "--grain", "line"}, "--count"},
        {{"step", kCubes, "--grain", "atom", "--count"}, "frame, stage"},
        {{"step", kCubes, "--grain", "line", "--count"}, "line"},  // a z-buffer has no lines
        {{"step", kCubes, "--grain", "frame", "--at", "-1"}, "--at"},
        {{"step", kCubes, "--grain", "frame", "--at", "1"}, "1"},
        {{"step", kCubes, "--grain", "frame", "--count", "-o", path("x.png")}, "--at"},
        {{"explain", kCubes}, "--pixel"},
        {{"explain", kCubes, "--pixel", "1,1", "--triangle", "1"}, "--pixel"},
        {{"explain", kCubes, "--pixel", "1"}, "X,Y"},
        {{"explain", kCubes, "--pixel", "1,x"}, "--pixel"},
        {{"explain", kCubes, "--size", "32x24", "--pixel", "32,0"}, "32x24"},
        {{"explain", kCubes, "--size", "32x24", "--pixel", "0,24"}, "32x24"},
        {{"explain", kCubes, "--triangle", "-1"}, "--triangle"},
        {{"explain", kCubes, "--triangle", "4000000000"}, "there is no triangle"},
        {{"compare", kCubes, "-o", path("x.png")}, "--algorithms"},
        {{"compare", kCubes, "--algorithms", "zbuffer", "-o", path("x.png")}, "two or more"},
        {{"compare", kCubes, "--algorithms", "zbuffer,scanline"}, "-o"},
        {{"compare", kCubes, "--algorithms", "zbuffer,bogus", "-o", path("x.png")}, "bogus"},
        {{"compare", kCubes, "--algorithms", "zbuffer,zbuffer+fault=bogus", "-o", path("x.png")}, "list faults"},
        {{"compare", kCubes, "--algorithms", "zbuffer,zbuffer+fault=box-short+fault=box-short", "-o", path("x.png")},
         "chosen twice"},
        {{"verify", kCubes, "--fault", "half-pixel+bogus"}, "'bogus'"},
        {{"verify", kCubes, "--fault", "half-pixel+"}, "''"},
        {{"verify", kCubes, "--algorithm", "zbuffer", "--fault", "half-pixel+edge-drift"},
         "The fault 'edge-drift' cannot happen here"},
        {{"compare", kCubes, "--algorithms", "zbuffer,scanline", "--frames", "0", "-o", path("x.png")}, "--frames"},
        {{"bench", kCubes, "--frames", "0"}, "--frames"},
        {{"bench", kCubes, "--frames", "6", "--rounds", "7"}, "--rounds"},
        {{"bench", kCubes, "--rounds", "2", "--path", "way.json"}, "--rounds"},
        {{"bench", kCubes, "--seconds", "-1"}, "--seconds"},
        {{"bench", kCubes, "--seconds", "3601"}, "--seconds"},
        {{"bench", kCubes, "--seconds", "inf"}, "--seconds"},
        {{"bench", kCubes, "--seconds", "2", "--path", "way.json"}, "--seconds"},
        {{"bench", "--seconds", "2", "--experiment", "e.json"}, "--shard"},
        {{"bench", "--rounds", "2", "--experiment", "e.json"}, "--shard"},
        {{"bench", kCubes, "--threads", "1,x"}, "--threads"},
        {{"bench"}, "SCENE"},
        {{"bench", "--suite", "speed"}, "four-modes, octree-quadtree, soccer-field or peers"},
        {{"list"}, "LIST"},
        {{"list", "colours"}, "algorithms, choices"},
    };
    for (const Mistake& mistake : mistakes) {
        const Answer answer = run(mistake.arguments);
        std::string  words;
        for (const std::string& argument : mistake.arguments) words += argument + ' ';
        EXPECT_EQ(answer.status, 2) << words << '\n' << answer.err;
        EXPECT_NE(answer.err.find(mistake.said), std::string::npos) << words << '\n' << answer.err;
        EXPECT_EQ(answer.out, "") << words;
    }
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Cli, SeveralFaultsAreNamedWithAPlusBetweenThem)
{
    const auto algorithmOf = [&](const std::string& faults) {
        const Answer done = run({"verify", "builtin:cubes", "--size", "32x24", "--fault", faults, "--json"});
        EXPECT_EQ(done.status, 0) << faults << ": " << done.err;
        return nlohmann::json::parse(done.out).at(0).at("algorithm").get<std::string>();
    };
    EXPECT_EQ(algorithmOf("no-top-left"), "zbuffer+fault=no-top-left");
    EXPECT_EQ(algorithmOf("box-short+no-top-left"), "zbuffer+fault=no-top-left+fault=box-short");
    EXPECT_EQ(algorithmOf("half-pixel+edge-drift"), "edge-walk+fault=half-pixel+fault=edge-drift")
        << "the first preset that takes both";
}

TEST_F(Cli, AVectorTargetTheMachineLacksIsRefused)
{
    for (const SimdEntry& entry : simdTargets())
        EXPECT_EQ(run({"render", kCubes, "--size", "32x32", "--simd", std::string(entry.word)}).status,
                  entry.available ? 0 : 2)
            << entry.word;
}

TEST_F(Cli, AnInputThatCannotBeUsedEndsWithThree)
{
    const std::string empty   = write("empty.obj", "");
    const std::string broken  = write("broken.json", "{\"meshes\": ");
    const std::string camera  = write("camera.json", "{\"eye\":[0,0,0]}");
    const std::string nothing = path("nothing.obj");
    const std::string flat =
        write("flat.json",
              R"({"materials": {"m": {"colour": [1, 0, 0], "relief": {"pattern": "bricks", "size": 1, "depth": 0}}}})");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"render", nothing},
                                               {"info", nothing},
                                               {"render", empty},
                                               {"render", broken},
                                               {"render", flat},
                                               {"render", path("")},
                                               {"render", kCubes, "--camera", nothing},
                                               {"render", kCubes, "--camera", camera}}) {
        const Answer answer = run(arguments);
        EXPECT_EQ(answer.status, 3) << arguments[0] << ' ' << arguments[1] << '\n' << answer.err;
        EXPECT_NE(answer.err.find("error: "), std::string::npos) << answer.err;
    }
}

TEST_F(Cli, DiagnosticsCarryFileLineAndSeverity)
{
    const std::string file   = write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 99\n");
    const Answer      answer = run({"render", file, "--size", "32x32"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_NE(answer.err.find(file + ":5: warning: "), std::string::npos) << answer.err;
}

TEST_F(Cli, ALimitThatIsExceededEndsWithFive)
{
    const Answer answer = run({"render", kCubes, "--size", "8000x8000", "--memory-limit", "1", "-o", path("x.png")});
    EXPECT_EQ(answer.status, 5) << answer.err;
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Cli, WhatAFrameTakesTogetherIsHeldAgainstTheLimit)
{
    const auto drawn = [this](const char* algorithm, const char* limit) {
        return run({"render", "builtin:million", "--size", "1280x960", "--threads", "2", "--algorithm", algorithm,
                    "--memory-limit", limit, "--stats", path("s.json")});
    };
    const Answer whole = drawn("interval", "1000");
    ASSERT_EQ(whole.status, 0) << whole.err;
    const json    stats = json::parse(contentsOf(path("s.json")));
    std::uint64_t bytes = 0;
    for (const json& taken : stats["bytes"]) bytes += taken.get<std::uint64_t>();
    ASSERT_GT(bytes, std::uint64_t{125} << 20);
    std::filesystem::remove(path("s.json"));
    const Answer answer = drawn("interval", "120");
    EXPECT_EQ(answer.status, 5) << answer.err;
    EXPECT_NE(answer.err.find("drawing this scene with interval takes 1"), std::string::npos) << answer.err;
    EXPECT_NE(answer.err.find(" MiB, more than the limit of 120 MiB"), std::string::npos) << answer.err;
    EXPECT_EQ(filesInFolder(), 0u);
    EXPECT_EQ(drawn("zbuffer", "120").status, 0) << "what it takes is less";
    std::filesystem::remove(path("s.json"));
    // Far below, it does not come so far as to know what the whole would have taken.
    const Answer soon = run({"render", "builtin:soccer-field", "--size", "320x240", "--threads", "2", "--algorithm",
                             "interval", "--memory-limit", "40", "-o", path("x.png")});
    EXPECT_EQ(soon.status, 5) << soon.err;
    EXPECT_NE(soon.err.find("takes more memory than there is, or than the limit of 40 MiB"), std::string::npos)
        << soon.err;
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Cli, AnInterruptEndsWithOneHundredAndThirtyAndLeavesNothing)
{
    const std::vector<std::vector<std::string>> longWork{
        {"bench", kCubes, "--frames", "1000000", "--no-verify", "--csv", path("x.csv")},
        {"verify", "builtin:layers?count=3000", "--size", "4000x4000"},
        {"step", "builtin:layers?count=3000", "--size", "4000x4000", "--grain", "pixel", "--at", "40000000000",
         "--state", path("x.json"), "-o", path("x.png")}};
    for (const std::vector<std::string>& arguments : longWork) {
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
            const Answer answer = runAndSignal(arguments, signal, 200);
            EXPECT_EQ(answer.status, 130) << arguments[0] << '\n' << answer.err;
            EXPECT_EQ(answer.out, "") << arguments[0];
        }
    }
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Cli, AnExportIsInterruptedAmongTheTrianglesOfAMesh)
{
    const Answer answer =
        runIntoFifoAndSignal(path("t"), {"export", "builtin:million", "--triangles", path("t")}, SIGINT);
    EXPECT_EQ(answer.status, 130) << answer.err;
    EXPECT_LT(answer.out.size(), 1'000'000u * 72 / 2);
}

TEST_F(Cli, OutputsOfOneRunMayNotReplaceEachOtherOrWhatIsRead)
{
    const std::string obj    = write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string camera = write("cam.json", run({"render", obj, "--size", "32x24", "--print-camera"}).out);
    std::filesystem::create_symlink("m.obj", path("link.obj"));
    std::filesystem::create_symlink("new.png", path("nowhere.png"));
    const auto refused = [this](const std::vector<std::string>& arguments, const std::string& said) {
        const std::size_t before = filesInFolder();
        const Answer      answer = run(arguments);
        EXPECT_EQ(answer.status, 2) << arguments[0] << '\n' << answer.err;
        EXPECT_NE(answer.err.find(said), std::string::npos) << answer.err;
        EXPECT_EQ(filesInFolder(), before);
    };
    const std::string replaced = " would replace '" + obj + "', which is read";
    refused({"render", obj, "-o", path("same"), "--ids", path("same")}, "-o and --ids name the same file");
    refused({"render", obj, "--depth", path("same"), "--stats", path("./no/../same")},
            "--depth and --stats name the same file");
    refused({"render", obj, "-o", obj}, "-o" + replaced);
    refused({"render", path("link.obj"), "--ids", obj}, "--ids would replace '" + path("link.obj"));
    refused({"render", obj, "--depth", path("link.obj")}, "--depth" + replaced);
    refused({"render", obj, "--camera", camera, "--stats", camera}, "--stats would replace '" + camera);
    refused({"step", obj, "--grain", "frame", "--at", "0", "--state", path("same"), "-o", path("same")},
            "--state and -o");
    refused({"step", obj, "--grain", "frame", "--at", "0", "--state", obj}, "--state" + replaced);
    refused({"export", obj, "--triangles", obj}, "--triangles" + replaced);
    refused({"compare", obj, "--algorithms", "zbuffer,scanline", "-o", obj}, "-o" + replaced);
    refused({"bench", obj, "--csv", path("same"), "--json", path("same")}, "--json and --csv");
    refused({"bench", kCubes, obj, "--csv", obj}, "--csv" + replaced);
    const std::string experiment = write(
        "e.json", R"({"title":"t","parts":[{"title":"p","scenes":[")" + obj + R"("],"algorithms":["zbuffer"]}]})");
    refused({"bench", "--experiment", experiment, "--csv", experiment}, "--csv would replace '" + experiment);
    refused({"bench", "--experiment", experiment, "--csv", obj}, "--csv" + replaced);
    refused({"render", obj, "--print-camera", "-o", path("x.png")}, "--print-camera draws nothing");
    for (const char* option : {"-o", "--ids", "--depth", "--stats"})
        refused({"render", obj, option, ""}, std::string(option) + " wants the name of a file");
    refused({"export", obj, "--triangles", ""}, "--triangles wants");
    refused({"merge", experiment, "-o", ""}, "-o wants");

    // Nor what a scene leads to: the models of a scene file, the material libraries of a model.
    const std::string library = write("m", "newmtl a\n"),
                      dressed = write("d.obj", "mtllib m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string scene   = write("s.json", R"({"meshes":{"a":{"obj":"d.obj"}},"instances":[{"mesh":"a"}]})");
    const std::string later =
        write("l.json", R"({"title":"t","parts":[{"title":"p","scenes":[")" + scene
                            + R"("],"algorithms":["zbuffer"],"frames":2,"rounds":1,"size":"32x24"}]})");
    for (const std::string& led : {library, dressed}) {
        const auto taken = [&](const std::string& option) {
            return option + " would replace '" + std::filesystem::canonical(led).string() + "', which is read";
        };
        for (const char* option : {"--ids", "--depth", "--stats"})
            refused({"render", scene, "--size", "32x24", option, led}, taken(option));
        refused({"step", scene, "--size", "32x24", "--grain", "frame", "--at", "0", "--state", led}, taken("--state"));
        refused({"export", scene, "--triangles", led}, taken("--triangles"));
        refused({"bench", kCubes, scene, "--size", "32x24", "--frames", "2", "--algorithms", "zbuffer", "--csv", led},
                taken("--csv"));
        refused({"bench", "--experiment", later, "--csv", led}, taken("--csv"));
    }
    const std::string readLibrary =
        " would replace '" + std::filesystem::canonical(library).string() + "', which is read";
    refused({"render", scene, "--size", "32x24", "-o", library}, "-o" + readLibrary);
    refused({"compare", scene, "--size", "32x24", "--algorithms", "zbuffer,scanline", "-o", library},
            "-o" + readLibrary);

    EXPECT_EQ(run({"render", obj, "--size", "32x24", "--ids", "/dev/null", "--depth", "/dev/null"}).status, 0)
        << "nothing is lost in it";
    refused({"render", obj, "--size", "32x24", "-o", path("nowhere.png"), "--ids", path("new.png")},
            "-o and --ids name the same file");
}

TEST_F(Cli, WhatASceneHoldsIsToldOnOneLineWithoutControlBytes)
{
    const std::string cube = R"({"meshes":{"c":{"builtin":"cube"}},"instances":[{"mesh":")";
    for (const std::string& text :
         {cube + R"(\u001b[31m\u0000\n"}]})", cube + R"(c","\u001b]0;\u0007":1}]})",
          std::string(R"({"meshes":{"c":{"obj":"\u001b/\u0007.obj"}}})"),
          cube + R"(c"}],"cameras":{"v":{"\u001b[2J":1}}})", cube + R"(c"}],"\u001b":1,"\u001b":2})"}) {
        const Answer answer = run({"info", write("s.json", text)});
        EXPECT_EQ(answer.status, 3) << answer.err;
        EXPECT_EQ(answer.err.find_first_of(std::string("\x1b\a\0", 3)), std::string::npos) << answer.err;
        EXPECT_EQ(std::ranges::count(answer.err, '\n'), 1) << answer.err;
    }
}

TEST_F(Cli, WhatIsTooFarInASceneOrAPathIsToldWithItsLine)
{
    write("big.obj", "v 1e308 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto told = [this](const std::string& instance, const std::string& line) {
        const Answer answer =
            run({"info", write("s.json", R"({"meshes":{"c":{"builtin":"cube"},"b":{"obj":"big.obj"}},)"
                                         "\n\"instances\":[{\"mesh\":\"b\"},\n{"
                                             + instance + "}]}")});
        EXPECT_EQ(answer.status, 3) << instance;
        EXPECT_NE(answer.err.find("s.json:" + line + ": error: an instance reaches beyond the largest number"),
                  std::string::npos)
            << answer.err;
    };
    told("\"mesh\":\"c\",\"grid\":{\"count\":[4,1,1],\n\"step\":[1e308,0,0]}", "4");
    told("\"mesh\":\"c\",\"matrix\":[1.5e308,1e308,0,0, 0,1,0,0, 0,0,1,0]", "3");
    told("\"mesh\":\"b\",\"random\":{\"count\":3,\"min\":[1e308,0,0],\"max\":[1.1e308,0,0]}", "3");

    const auto flown = [this](const std::string& keys, const std::string& said) {
        const Answer answer = run({"bench", kCubes, "--algorithms", "zbuffer", "--size", "20x20", "--path",
                                   write("way.json", "{\"keys\":[\n" + keys + "]}")});
        EXPECT_EQ(answer.status, 3) << keys;
        EXPECT_NE(answer.err.find(said), std::string::npos) << answer.err;
    };
    flown("{\"frame\":0,\"eye\":[0,0,9],\"target\":[0,0,0]},\n{\"frame\":8,\"eye\":[1e308,0,0],\"target\":[0,0,0]}",
          "way.json:3: error: eye and target are too far apart");
    flown("{\"frame\":0,\"eye\":[0,0,9],\"target\":[0,0,0]}],\n\"near\":1e300,\"unused\":[", "way.json:3: error: ");
    flown(
        "{\"frame\":0,\"eye\":[0,0,9],\"target\":[0,0,0]},\n{\"frame\":2,\"eye\":[1e300,0,0],\"target\":[1.001e300,0,0]"
        "}",
        "way.json:3: error: ");
}

TEST_F(Cli, HelpAndVersionAreNoMistake)
{
    EXPECT_EQ(run({"--help"}).status, 0);
    EXPECT_EQ(run({"--version"}).status, 0);
    for (const char* command :
         {"render", "info", "export", "verify", "step", "explain", "lesson", "compare", "bench", "merge", "list"}) {
        const Answer answer = run({command, "--help"});
        EXPECT_EQ(answer.status, 0);
        EXPECT_NE(answer.out.find("--quiet"), std::string::npos) << command;
    }
}

TEST_F(Cli, HelpNamesWhatEachCommandIsAskedWith)
{
    const std::vector<std::pair<std::string, std::vector<std::string>>> words{
        {"bench",
         {"--algorithms", "--threads", "--frames", "--path", "--sample", "--suite", "--experiment", "--peers",
          "--shard", "--json", "--csv"}},
        {"compare", {"--algorithms", "--require-equal"}},
        {"step", {"--grain", "--count", "--at", "--state"}},
        {"verify", {"--algorithm", "--sample", "--set", "--fault"}}};
    for (const auto& [command, options] : words) {
        const std::string help = run({command, "--help"}).out;
        for (const std::string& option : options)
            EXPECT_NE(help.find(option), std::string::npos) << command << " " << option;
    }
}

TEST_F(Cli, ListsAreTheRegistries)
{
    const json algorithms = json::parse(run({"list", "algorithms", "--json"}).out);
    ASSERT_EQ(algorithms.size(), presets().size());
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset& preset = presets()[i];
        EXPECT_EQ(algorithms[i]["name"], preset.name);
        EXPECT_EQ(algorithms[i]["title"], preset.title);
        EXPECT_EQ(algorithms[i]["exact"], preset.isExact());
        EXPECT_EQ(algorithms[i]["exact_by_face"], preset.claim != Claim::Approximate);
        EXPECT_EQ(algorithms[i]["family"], familyOf(preset.pipeline));
        EXPECT_EQ(algorithms[i]["family"] == "sweep", drawsLineByLine(preset.pipeline));
        EXPECT_EQ(algorithms[i]["grains"].size(), grainsOf(preset.pipeline).size());
    }
    for (const char* list : {"algorithms", "choices", "scenes", "layers", "grains", "simd", "suites"}) {
        const Answer table = run({"list", list});
        const json   items = json::parse(run({"list", list, "--json"}).out);
        EXPECT_EQ(table.status, 0);
        ASSERT_FALSE(items.empty()) << list;
        for (const json& item : items) {
            EXPECT_TRUE(item["name"].is_string() && item["title"].is_string()) << list;
            EXPECT_NE(table.out.find(item["name"].get<std::string>()), std::string::npos) << list;
        }
    }
}

TEST_F(Cli, EverySceneOfTheListCanBeCounted)
{
    for (const json& scene : json::parse(run({"list", "scenes", "--json"}).out)) {
        const std::string word = "builtin:" + scene["name"].get<std::string>();
        if (word.find("/A6") != std::string::npos || word.find("/F9") != std::string::npos) continue;  // large
        const Answer answer = run({"info", word, "--json"});
        ASSERT_EQ(answer.status, 0) << word << '\n' << answer.err;
        EXPECT_GT(json::parse(answer.out)["triangles"].get<long>(), 0) << word;
    }
}

TEST_F(Cli, InfoCountsWhatTheFileHolds)
{
    const std::string file   = write("counts.obj",
                                     "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0.5\n"
                                       "g left\nf 1 2 3 4\ng right\nf 1 2 5\nf 1 2 77\n");
    const Answer      answer = run({"info", file, "--json"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const json info = json::parse(answer.out);
    EXPECT_EQ(info["vertices"], 5);
    EXPECT_EQ(info["polygons"], 2);
    EXPECT_EQ(info["triangles"], 3);
    EXPECT_EQ(info["instances"], 1);
    EXPECT_EQ(info["groups"], 2);
    EXPECT_EQ(info["dropped"], 1);
    EXPECT_EQ(info["split"], 1);
    EXPECT_EQ(info["bounds"]["max"], json::parse("[2.0,2.0,0.5]"));
    ASSERT_EQ(info["warnings"].size(), 1u);
    EXPECT_EQ(info["warnings"][0]["file"], file);
    EXPECT_EQ(info["warnings"][0]["line"], 10);
    EXPECT_EQ(info["digest"].get<std::string>().size(), 16u);
}

TEST_F(Cli, ResultsThatCannotBePrintedEndWithFour)
{
    EXPECT_EQ(runInto("/dev/full", {"list", "algorithms"}).status, 4);
    EXPECT_EQ(runInto("/dev/full", {"info", kCubes}).status, 4);
}

}  // namespace
}  // namespace zscope::cli_test
