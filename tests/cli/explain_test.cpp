// Explanations from the command line: the picture's own winner, the words, and what is refused.
#include <nlohmann/json.hpp>

#include "core/frame/pipeline.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;

std::vector<std::string> explaining(std::string_view algorithm, const std::vector<std::string>& what)
{
    std::vector<std::string> arguments{"explain", "builtin:cubes", "--size",
                                       "97x61",   "--algorithm",   std::string(algorithm)};
    arguments.insert(arguments.end(), what.begin(), what.end());
    return arguments;
}

/// The id at a pixel of ids.npy.
std::int64_t idAt(const std::string& file, int x, int y)
{
    const std::string bytes  = contentsOf(file);
    const std::size_t header = 10 + static_cast<unsigned char>(bytes[8]) + 256 * static_cast<unsigned char>(bytes[9]);
    std::int64_t      id     = 0;
    bytes.copy(reinterpret_cast<char*>(&id), sizeof id, header + sizeof id * static_cast<std::size_t>(y * 97 + x));
    return id;
}

TEST_F(Cli, ExplainNamesTheWinnerThatRenderDraws)
{
    for (const Preset& preset : presets()) {
        ASSERT_EQ(run({"render", "builtin:cubes", "--size", "97x61", "--algorithm", std::string(preset.name), "--ids",
                       path("ids.npy")})
                      .status,
                  0);
        for (const auto& [x, y] : {std::pair(48, 30), std::pair(20, 40), std::pair(0, 0)}) {
            const Answer answer =
                run(explaining(preset.name, {"--pixel", std::to_string(x) + ',' + std::to_string(y), "--json"}));
            ASSERT_EQ(answer.status, 0) << answer.err;
            const json explanation = json::parse(answer.out);
            EXPECT_EQ(explanation["winner"], idAt(path("ids.npy"), x, y)) << preset.name;
            EXPECT_EQ(explanation["pixel"], json::array({x, y}));
            int winners = 0;
            for (const json& triangle : explanation["triangles"])
                winners += triangle["fate"] == "winner" && triangle["drawn_as"] == explanation["winner"];
            EXPECT_EQ(winners > 0, explanation["winner"] != -1) << preset.name;
        }
    }
}

TEST_F(Cli, ExplainAnswersInTextWithTheStepsToGoTo)
{
    const Answer answer = run(explaining("hzb-octree", {"--pixel", "48,30"}));
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_TRUE(answer.out.starts_with("Pixel (48, 30) shows ")) << answer.out;
    EXPECT_NE(answer.out.find(": winner"), std::string::npos);
    EXPECT_NE(answer.out.find("at step: "), std::string::npos);
}

TEST_F(Cli, ExplainSaysWhatBecameOfATriangle)
{
    const json pixel    = json::parse(run(explaining("zbuffer", {"--pixel", "48,30", "--json"})).out);
    const json triangle = json::parse(
        run(explaining("zbuffer", {"--triangle", std::to_string(pixel["winner"].get<long>()), "--json"})).out);
    EXPECT_EQ(triangle["fate"], "winner");
    EXPECT_GT(triangle["pixels"]["shown"].get<long>(), 0);
    EXPECT_GE(triangle["pixels"]["covered"].get<long>(), triangle["pixels"]["shown"].get<long>());
    EXPECT_TRUE(run(explaining("zbuffer", {"--triangle", "0"})).out.starts_with("Triangle 0"));
}

}  // namespace
}  // namespace zscope::cli_test
