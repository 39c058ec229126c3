// `check` as scripts call it: words, JSON, exit statuses, reports, and the files that render writes.
#include <nlohmann/json.hpp>

#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;

class Check : public Cli {
protected:
    /// Writes ids, depth, picture and camera of a view.
    void draw(const std::string& scene, const std::vector<std::string>& how = {})
    {
        const Answer camera = run({"render", scene, "--size", "160x120", "--print-camera"});
        ASSERT_EQ(camera.status, 0) << camera.err;
        write("cam.json", camera.out);
        std::vector<std::string> words{"render",  scene,         "--camera", path("cam.json"), "--ids", path("i.npy"),
                                       "--depth", path("d.npy"), "-o",       path("p.png")};
        words.insert(words.end(), how.begin(), how.end());
        const Answer drawn = run(words);
        ASSERT_EQ(drawn.status, 0) << drawn.err;
    }
    Answer check(const std::string& scene, std::vector<std::string> words) const
    {
        words.insert(words.begin(), {"check", scene, "--camera", path("cam.json")});
        return run(words);
    }
};

const std::string kCity = "builtin:city?blocks=4";

TEST_F(Check, OfOurOwnPictureFindsNothingWrong)
{
    const std::string scene = "builtin:teapot?tessellation=4";  // background in every corner
    draw(scene);
    const Answer answer = check(scene, {"--ids", path("i.npy"), "--depth", path("d.npy"), "--json"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    const json found = json::parse(answer.out);
    const json none  = {{"holes", 0}, {"spills", 0}, {"wrong_surface", 0}, {"wrong_depth", 0}};
    const json words = {
        {"depth", "near/z"}, {"rows", "top-down"}, {"ids", "triangles"}, {"ids_from", 0}, {"cull", "none"}};
    EXPECT_EQ(found.at("conventions"), words);
    EXPECT_EQ(found.at("wrong"), none);
    EXPECT_EQ(found.at("rounding"), none);
    EXPECT_EQ(found.at("first_wrong"), nullptr);
    EXPECT_EQ(found.at("causes"), json::array());
    EXPECT_GT(found.at("covered"), 1000);
    EXPECT_EQ(found.size(), 7u);
    EXPECT_EQ(check(scene, {"--picture", path("p.png")}).status, 0);
}

TEST_F(Check, NamesTheMistakeAndTheFirstWrongPixel)
{
    draw(kCity, {"--algorithm", "scanline", "--fault", "x-truncated"});
    const Answer answer = check(kCity, {"--ids", path("i.npy"), "--depth", path("d.npy"), "--json"});
    EXPECT_EQ(answer.status, 1) << answer.err;
    const json found = json::parse(answer.out);
    const json cause = found.at("causes").at(0);
    EXPECT_EQ(cause.at("name"), "x-truncated");
    EXPECT_EQ(cause.at("explains"), 1.0);
    EXPECT_EQ(cause.at("adds"), 0);
    EXPECT_EQ(cause.at("lesson"), "13-holes-and-fill-rules");
    const json first = found.at("first_wrong");
    for (const char* key : {"x", "y", "kind", "expected", "found"}) EXPECT_TRUE(first.contains(key)) << key;
    EXPECT_NE(first.at("expected"), first.at("found"));

    const Answer text = check(kCity, {"--ids", path("i.npy")});
    EXPECT_EQ(text.status, 1);
    EXPECT_NE(text.out.find("first wrong pixel ("), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("x-truncated"), std::string::npos);
    const Answer plain = check(kCity, {"--ids", path("i.npy"), "--no-diagnose", "--json"});
    EXPECT_EQ(json::parse(plain.out).at("causes"), json::array());
}

TEST_F(Check, WritesReportsForCourses)
{
    draw(kCity, {"--algorithm", "edge-walk", "--fault", "first-line-rounded"});
    const Answer answer =
        check(kCity, {"--ids", path("i.npy"), "--junit", path("r.xml"), "--gradescope", path("r.json")});
    EXPECT_EQ(answer.status, 1) << answer.err;
    const std::string xml = contentsOf(path("r.xml"));
    EXPECT_NE(xml.find("<testsuites tests=\"3\" failures=\"2\" errors=\"0\">"), std::string::npos) << xml;
    EXPECT_NE(xml.find("name=\"depth\""), std::string::npos);
    EXPECT_NE(xml.find("<skipped"), std::string::npos) << "there is no depth file";
    expectFitsSchema(path("r.xml"));
    expectFitsSchema(path("r.json"));
    const json results = json::parse(contentsOf(path("r.json")));
    EXPECT_EQ(results.at("tests").size(), 2u);
    for (const json& test : results.at("tests")) {
        EXPECT_EQ(test.at("score"), 0);
        EXPECT_EQ(test.at("max_score"), 1);
        EXPECT_EQ(test.at("status"), "failed");
    }
    EXPECT_FALSE(results.at("output").get<std::string>().empty());
}

TEST_F(Check, WritesAPageThatSaysHowToJudgeAgain)
{
    draw(kCity, {"--algorithm", "scanline", "--fault", "x-truncated"});
    const Answer answer = check(kCity, {"--ids", path("i.npy"), "--report", path("deep/report")});
    EXPECT_EQ(answer.status, 1) << answer.err;
    const std::string page = contentsOf(path("deep/report/report.html"));
    EXPECT_NE(page.find("--ids " + path("i.npy") + "</pre>"), std::string::npos) << "without the option of the report";
    EXPECT_NE(page.find("13-holes-and-fill-rules"), std::string::npos);
    EXPECT_EQ(check(kCity, {"--ids", path("i.npy"), "--report", path("i.npy")}).status, 4);
    const auto files = filesInFolder();
    EXPECT_EQ(check(kCity, {"--ids", path("absent.npy"), "--report", path("deep/report")}).status, 3);
    EXPECT_EQ(filesInFolder(), files);
    EXPECT_EQ(contentsOf(path("deep/report/report.html")), page) << "a check that fails changes nothing";
}

TEST_F(Check, ReportsFitTheirSchemasWhateverFilesAreCalled)
{
    const std::string scene = write("a<b>&\"c\"'\x01 \xC3\xA4.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
    draw(scene);
    for (const auto& how : std::vector<std::vector<std::string>>{{}, {"--depth", path("d.npy")}}) {
        std::vector<std::string> words{"--ids",       path("i.npy"),  "--junit",
                                       path("r.xml"), "--gradescope", path("r.json")};
        words.insert(words.end(), how.begin(), how.end());
        EXPECT_EQ(check(scene, words).status, 0);
        expectFitsSchema(path("r.xml"));
        expectFitsSchema(path("r.json"));
    }
}

TEST_F(Check, ATraceIsJudgedAloneOrWithAPicture)
{
    const std::string scene = "builtin:cubes";
    draw(scene);
    std::vector<json> rows;
    for (const char* step : {"0", "40", "60", "80"}) {
        const Answer stepped = run({"step", scene, "--camera", path("cam.json"), "--algorithm", "scanline", "--grain",
                                    "line", "--at", step, "--state", path("s.json")});
        ASSERT_EQ(stepped.status, 0) << stepped.err;
        rows.push_back(json::parse(contentsOf(path("s.json"))));
    }
    const auto trace = [&] {
        std::string text;
        for (const json& row : rows) text += row.dump() + "\n";
        return write("t.jsonl", text);
    };
    const Answer right = check(scene, {"--trace", trace(), "--json"});
    EXPECT_EQ(right.status, 0) << right.err << right.out;
    EXPECT_EQ(json::parse(right.out).at("trace").at("rows"), 4);
    EXPECT_EQ(json::parse(right.out).at("trace").at("first_wrong"), nullptr);

    rows[2]["active_edges"].erase(3);
    const Answer wrong = check(scene, {"--trace", trace(), "--ids", path("i.npy"), "--json", "--junit", path("r.xml"),
                                       "--gradescope", path("r.json")});
    EXPECT_EQ(wrong.status, 1) << wrong.err;
    const json found = json::parse(wrong.out);
    EXPECT_EQ(found.at("wrong").at("holes"), 0) << "the picture is right";
    const json first = found.at("trace").at("first_wrong");
    EXPECT_EQ(first.at("row"), 2);
    EXPECT_EQ(first.at("line"), 3);
    EXPECT_EQ(first.at("grain"), "line");
    EXPECT_EQ(first.at("step"), 60);
    EXPECT_NE(first.at("sentence").get<std::string>().find("your table lacks an edge of polygon"), std::string::npos);
    EXPECT_NE(contentsOf(path("r.xml")).find("name=\"trace\""), std::string::npos);
    expectFitsSchema(path("r.xml"));
    expectFitsSchema(path("r.json"));
    const Answer text = check(scene, {"--trace", path("t.jsonl")});
    EXPECT_EQ(text.status, 1);
    EXPECT_NE(text.out.find("first wrong row: 2, " + path("t.jsonl") + ":3"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("ours: step --algorithm scanline --grain line --at 60"), std::string::npos) << text.out;

    const Answer refused = check(scene, {"--trace", write("bad.jsonl", "{\"line\":1}\nnonsense\n")});
    EXPECT_EQ(refused.status, 3);
    EXPECT_EQ(refused.err.find(path("bad.jsonl") + ":2: error: "), 0u) << refused.err;
    EXPECT_EQ(check(scene, {"--trace", path("t.jsonl"), "--algorithm", "none"}).status, 2);
    EXPECT_EQ(check(scene, {"--trace", path("t.jsonl"), "--report", path("page")}).status, 2);
    const Answer both =
        check(scene, {"--trace", path("t.jsonl"), "--ids", path("i.npy"), "--report", path("page"), "--no-diagnose"});
    EXPECT_EQ(both.status, 1) << both.err;
    const std::string page = contentsOf(path("page/report.html"));
    EXPECT_NE(page.find("Line 3 of the trace is the first that differs from scanline."), std::string::npos);
    EXPECT_NE(page.find("<td class=\"l\">step --algorithm scanline --grain line --at 60</td>"), std::string::npos);
    EXPECT_NE(page.find("--trace " + path("t.jsonl")), std::string::npos);
    EXPECT_EQ(check(scene, {"--ids", path("i.npy"), "--algorithm", "scanline"}).status, 2);
}

TEST_F(Check, ASizeAloneMeansTheScenesOwnView)
{
    draw(kCity);  // its own view, 160 by 120 pixels
    const std::string ids = path("i.npy");
    const Answer      own = run({"check", kCity, "--size", "160x120", "--ids", ids, "--json"});
    EXPECT_EQ(own.status, 0) << own.err << own.out;
    EXPECT_EQ(json::parse(own.out), json::parse(check(kCity, {"--ids", ids, "--json"}).out));
    EXPECT_EQ(run({"check", kCity, "--size", "120x160", "--ids", ids}).status, 3) << "the file has another size";
    EXPECT_EQ(run({"check", kCity, "--size", "0x160", "--ids", ids}).status, 2);
}

TEST_F(Check, RefusesWhatCannotBeUsed)
{
    draw(kCity);
    const auto status = [&](const std::vector<std::string>& words) {
        const Answer answer = run(words);
        EXPECT_TRUE(answer.out.empty()) << answer.out;
        EXPECT_NE(answer.err.find("error: "), std::string::npos) << answer.err;
        return answer.status;
    };
    const std::string ids = path("i.npy"), camera = path("cam.json");
    EXPECT_EQ(status({"check", kCity, "--camera", camera}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", ids}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", ids, "--matrix", camera}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", ids, "--camera", camera, "--size", "160x120"}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", ids, "--camera", camera, "--rows", "sideways"}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", ids, "--camera", camera, "--depth-is", "far"}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", ids, "--camera", camera, "--subpixel-bits", "0"}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", ids, "--camera", camera, "--junit", ids}), 2);
    EXPECT_EQ(status({"check", kCity, "--ids", path("absent.npy"), "--camera", camera}), 3);
    EXPECT_EQ(status({"check", kCity, "--depth", ids, "--camera", camera}), 3);
    EXPECT_EQ(status({"check", kCity, "--dump", ids}), 3);
    EXPECT_EQ(status({"check", kCity, "--ids", ids, "--matrix", camera, "--size", "160x120"}), 3);
    EXPECT_EQ(status({"check", kCity, "--picture", ids, "--camera", camera}), 3);
}

}  // namespace
}  // namespace zscope::cli_test
