// An empty picture says why: each cause, from `render` and from `info`, and no word where something is seen.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/frame/pipeline.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// Two triangles that face +z, each with a material of its own, `materials` in t.mtl.
std::string twoTriangles(double x = 0)
{
    const auto at = [x](double corner) { return std::to_string(x + corner); };
    return "mtllib t.mtl\nv " + at(-2) + " -1 0\nv " + at(0) + " -1 0\nv " + at(-1) + " 1 0\nv " + at(0) + " -1 0\nv "
           + at(2) + " -1 0\nv " + at(1) + " 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 4 5 6\n";
}
std::string library(const std::string& ofA, const std::string& ofB)
{
    return "newmtl a\nKd 1 0 0\n" + ofA + "\nnewmtl b\nKd 0 1 0\n" + ofB + "\n";
}

Words with(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

Words messagesOf(const Answer& info)
{
    const json parsed = json::parse(info.out);
    Words      messages;
    for (const json& warning : parsed["warnings"]) messages.push_back(warning["message"]);
    return messages;
}

bool has(const Words& words, const std::string& word) { return std::ranges::find(words, word) != words.end(); }

void expectSaidBy(const std::string& scene, const Words& view, const std::string& why)
{
    const std::string sentence = "the picture is empty: " + why;
    const Answer      render   = run(with({"render", scene, "--size", "320x180"}, view));
    EXPECT_EQ(render.status, 0) << render.err;
    EXPECT_NE(render.err.find("warning: " + sentence + '\n'), std::string::npos) << why << "\n" << render.err;
    const Answer info = run(with({"info", scene, "--json", "--size", "320x180"}, view));
    EXPECT_EQ(info.status, 0) << info.err;
    EXPECT_TRUE(has(messagesOf(info), sentence)) << info.out;
    const Answer table = run(with({"info", scene, "--size", "320x180"}, view));
    EXPECT_NE(table.err.find("warning: " + sentence + '\n'), std::string::npos) << table.err;
}

void expectNothingSaid(const std::string& scene, const Words& view = {})
{
    const Answer render = run(with({"render", scene, "--size", "320x180"}, view));
    EXPECT_EQ(render.status, 0);
    EXPECT_EQ(render.err, "");
    EXPECT_EQ(messagesOf(run(with({"info", scene, "--json", "--size", "320x180"}, view))), Words{});
}

TEST_F(Cli, AnEmptyPictureSaysWhichPartOfTheViewIsWrong)
{
    write("t.mtl", library("d 1", "d 1"));
    const std::string scene = write("t.obj", twoTriangles());
    const Words       front{"--eye", "0,0,5", "--target", "0,0,0"};
    expectNothingSaid(scene);
    expectNothingSaid(scene, front);
    expectNothingSaid(scene, {"--eye", "0,0,-5", "--target", "0,0,0"});

    expectSaidBy(scene, {"--eye", "0,0,5", "--target", "0,0,10"}, "2 triangles lie behind the eye");
    expectSaidBy(scene, with(front, {"--near", "10", "--far", "20"}), "2 triangles lie before the near plane (10)");
    expectSaidBy(scene, {"--eye", "0,0,5", "--target", "10,0,0"}, "2 triangles lie outside the view");
    expectSaidBy(scene, with(front, {"--near", "0.1", "--far", "2"}), "2 triangles lie beyond the far plane (2)");
    expectSaidBy(scene, {"--eye", "0,0,-5", "--target", "0,0,0", "--cull", "back"},
                 "2 triangles show their backs, and back faces are culled");
    expectSaidBy(scene, {"--eye", "0,0,5000", "--target", "0,0,0", "--far", "inf"},
                 "2 triangles lie between the centres of the pixels");
    // An eye between the two: the near plane at 0.5 has what is left of neither.
    write("apart.obj", "v -1 -1 5\nv 1 -1 5\nv 0 1 5\nv -1 -1 -5\nv 1 -1 -5\nv 0 1 -5\nf 1 2 3\nf 4 5 6\n");
    expectSaidBy(path("apart.obj"), {"--eye", "0,0,0", "--target", "0,0,-1", "--near", "0.5", "--far", "2"},
                 "1 triangle lies behind the eye; 1 triangle lies beyond the far plane (2)");
    write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    expectSaidBy(path("line.obj"), front, "1 triangle has no area on the grid");
}

TEST_F(Cli, AnEmptyPictureNamesTheMaterialsThatAreInvisibleAndWhatSetThem)
{
    const std::string scene = write("t.obj", twoTriangles());
    const auto said = [&](const std::string& ofA, const std::string& ofB, const Words& view, const std::string& why) {
        write("t.mtl", library(ofA, ofB));
        expectSaidBy(scene, view, why);
    };
    const std::string meant = "; 'Tr 1.0' was most likely meant as opaque: write 'Tr 0' or 'd 1' into t.mtl";
    said("Tr 1.0", "Tr 1", {},
         "2 triangles have opacity 0: materials 'a' (Tr 1.0, t.mtl:3), 'b' (Tr 1, t.mtl:6)" + meant);
    said("Tr 1.0", "d 0", {}, "2 triangles have opacity 0: materials 'a' (Tr 1.0, t.mtl:3), 'b' (d 0, t.mtl:6)");
    said("d -halo 0.0", "d 0", {},
         "2 triangles have opacity 0: materials 'a' (d -halo 0.0, t.mtl:3), 'b' (d 0, t.mtl:6)");
    said("d 0\nTr 0", "Tr 0\nd 0", {}, "2 triangles have opacity 0: materials 'a' (d 0, t.mtl:3), 'b' (d 0, t.mtl:8)");
    said("d 0", "d 1", {"--eye", "0,0,-5", "--target", "0,0,0", "--cull", "back"},
         "1 triangle shows its back, and back faces are culled; 1 triangle has opacity 0: material 'a' (d 0, t.mtl:3)");
    said("d 0.001", "d 0", {"--eye", "0,0,5", "--target", "0,0,10"},
         "1 triangle lies behind the eye; 1 triangle has opacity 0: material 'b' (d 0, t.mtl:6)");

    // The place of the warning is the statement's.
    write("t.mtl", library("Tr 1", "Tr 1"));
    const json warnings = json::parse(run({"info", scene, "--json"}).out)["warnings"];
    ASSERT_EQ(warnings.size(), 3u);
    for (const std::size_t i : {0u, 2u}) {
        EXPECT_TRUE(warnings[i]["file"].get<std::string>().ends_with("/t.mtl"));
        EXPECT_EQ(warnings[i]["line"], 3);
    }
    EXPECT_EQ(warnings[1]["line"], 6);
}

TEST_F(Cli, AMaterialOfOpacity0IsToldOfWhereTheRestIsSeen)
{
    const std::string scene = write("t.obj", twoTriangles());
    for (const std::string statement : {"d 0", "Tr 1", "d -halo 0"}) {
        write("t.mtl", library(statement, "d 1"));
        const std::string sentence = "material 'a' has opacity 0 (" + statement + "): its faces are not drawn";
        const Answer      render   = run({"render", scene});
        EXPECT_NE(render.err.find("/t.mtl:3: warning: " + sentence + '\n'), std::string::npos) << render.err;
        EXPECT_EQ(render.err.find("empty"), std::string::npos) << render.err;
        EXPECT_EQ(messagesOf(run({"info", scene, "--json"})), Words{sentence});
    }
    // Opaque, nearly invisible, and a material that no face has.
    write("t.mtl", library("d 1", "d 0.01") + "newmtl c\nd 0\n");
    expectNothingSaid(scene);
}

std::string sceneOf(const std::string& materials, const std::string& cameras = "{}")
{
    return "{\"meshes\": {\"m\": {\"obj\": \"t.obj\"}},\n\"instances\": [{\"mesh\": \"m\"}],\n\"materials\": "
           + materials + ",\n\"cameras\": " + cameras + "}";
}

TEST_F(Cli, ASceneFileThatSetsOpacitiesIsNamedAndSetsThoseOfALibraryRight)
{
    write("t.obj", twoTriangles());
    write("t.mtl", library("Tr 1", "Tr 1"));
    expectNothingSaid(write("right.json", sceneOf("{\"a\": {\"colour\": [1, 0, 0]}, \"b\": {\"colour\": [0, 1, 0]}}")));

    write("t.mtl", library("d 1", "d 1"));
    const std::string clear = write("clear.json", sceneOf("{\"a\": {\"colour\": [1, 0, 0],\n\"opacity\": 0},\n"
                                                          "\"b\": {\"colour\": [0, 1, 0], \"opacity\": 0.0}}"));
    expectSaidBy(clear, {},
                 "2 triangles have opacity 0: materials 'a' (\"opacity\": 0, clear.json:4), 'b' (\"opacity\": 0, "
                 "clear.json:5)");
    const Words messages = messagesOf(run({"info", clear, "--json"}));
    EXPECT_TRUE(has(messages, "material 'a' has opacity 0 (\"opacity\": 0): its faces are not drawn"));

    write("t.obj", twoTriangles(60));  // all of it in the hole from 50 to 100
    const std::string cut = "{\"colour\": [1, 0, 0], \"cutout\": {\"pattern\": \"stripes\", \"size\": 100}}";
    expectSaidBy(write("cut.json", sceneOf("{\"a\": " + cut + ", \"b\": " + cut + "}")), {},
                 "2 triangles have holes at all pixels they cover");
    expectSaidBy(write("none.json", "{\"meshes\": {\"m\": {\"obj\": \"t.obj\"}}, \"instances\": []}"), {},
                 "the scene holds no triangles");
}

TEST_F(Cli, InfoJudgesEveryNamedCameraAndAViewThatIsAskedFor)
{
    write("t.obj", twoTriangles());
    write("t.mtl", library("d 1", "d 1"));
    const std::string scene =
        write("s.json", sceneOf("{}",
                                "{\n\"good\": {\"eye\": [0, 0, 5], \"target\": [0, 0, 0]},\n"
                                "\"lost\": {\"eye\": [0, 0, 5], \"target\": [0, 0, 10]},\n"
                                "\"back\": {\"eye\": [0, 0, -5], \"target\": [0, 0, 0], \"cull\": \"back\"}}"));
    const json warnings = json::parse(run({"info", scene, "--json"}).out)["warnings"];
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0]["message"], "the picture of camera 'lost' is empty: 2 triangles lie behind the eye");
    EXPECT_EQ(warnings[0]["line"], 6);
    EXPECT_EQ(warnings[0]["file"], scene);
    EXPECT_EQ(warnings[1]["message"],
              "the picture of camera 'back' is empty: 2 triangles show their backs, and back faces are culled");
    EXPECT_EQ(warnings[1]["line"], 7);
    expectNothingSaid(scene, {"--eye", "0,0,5", "--target", "0,0,0"});
    expectSaidBy(scene, {"--eye", "9,9,9", "--target", "10,10,10"}, "2 triangles lie behind the eye");
    EXPECT_EQ(run({"info", scene, "--eye", "1,2"}).status, 2);
}

TEST_F(Cli, AMethodThatLeavesEverythingOutSaysSo)
{
    const std::string scene = write("big.obj", "v -9 -1 9\nv 9 -1 9\nv 0 -1 -9\nf 1 2 3\n");
    const Words       view{"--eye", "0,0,0", "--target", "0,0,-1", "--near", "0.5", "--far", "50", "--size", "99x55"};
    EXPECT_EQ(run(with({"render", scene}, view)).err, "");
    const Answer dropped = run(with({"render", scene, "--algorithm", "zbuffer", "--set", "near=drop"}, view));
    EXPECT_EQ(dropped.status, 0);
    EXPECT_NE(dropped.err.find("warning: the picture is empty: 1 triangle covers pixels by the definition, but the "
                               "chosen method leaves it out\n"),
              std::string::npos)
        << dropped.err;
}

TEST_F(Cli, ExplainStatesTheOpacity)
{
    const std::string scene = write("t.obj", twoTriangles());
    write("t.mtl", library("Tr 1", "d 0.25"));
    const auto explain = [&](const Words& what) {
        return run(with({"explain", scene, "--size", "320x180", "--eye", "0,0,5", "--target", "0,0,0"}, what)).out;
    };
    const auto holds = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    };
    holds(explain({"--triangle", "0"}), "and has opacity 0 (Tr 1, t.mtl:3): nothing of it is seen.");
    holds(explain({"--triangle", "0"}), "material 'a', opacity 0 (Tr 1, t.mtl:3), ");
    holds(explain({"--triangle", "1"}), "and has opacity 0.25 (d 0.25, t.mtl:6): it is outside ids and depth, and");
    // Triangle 0 covers x from -2 to 0, about the middle line; at 5 units 43 pixels are one.
    holds(explain({"--pixel", "117,90"}), "Triangle 0 has opacity 0 (Tr 1, t.mtl:3) and is, at near/z ");
    holds(explain({"--pixel", "117,90"}), ": its share of the colour is 0, so nothing of it is seen.");
    holds(explain({"--pixel", "203,90"}), "Triangle 1 has opacity 0.25 (d 0.25, t.mtl:6) and is, at near/z ");
    EXPECT_EQ(json::parse(explain({"--pixel", "117,90", "--json"}))["triangles"][0]["opacity"], 0);
    EXPECT_EQ(json::parse(explain({"--triangle", "1", "--json"}))["opacity"], 0.25);
}

TEST_F(Cli, VerifyJudgesTheColoursOfEveryShadingCost)
{
    for (const char* cost : {"0-operations", "10-operations", "100-operations", "1000-operations"}) {
        const Answer answer = run({"verify", "builtin:glass", "--size", "160x90", "--algorithm", "all", "--set",
                                   std::string("shading-cost=") + cost, "--json"});
        EXPECT_EQ(answer.status, 0) << cost;
        for (const json& row : json::parse(answer.out)) {
            const std::string name = row["algorithm"];
            if (findPreset(name.substr(0, name.find('+')))->claim == Claim::Approximate) continue;
            EXPECT_EQ(row["wrong_colours"], 0) << cost << ": " << row;
        }
    }
    const Answer wrong = run({"verify", "builtin:glass", "--size", "160x90", "--algorithm", "all", "--set",
                              "transparency=back-then-front", "--json"});
    for (const json& row : json::parse(wrong.out)) EXPECT_GT(row["wrong_colours"], 500) << row;
}

}  // namespace
}  // namespace zscope::cli_test
