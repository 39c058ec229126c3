// Stepping from the command line: counts, states, and the same bytes however a step is reached.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>

#include <png.h>
#include <nlohmann/json.hpp>

#include "core/frame/pipeline.h"
#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;

const std::vector<std::string> kView{"builtin:cubes", "--size", "97x61"};

std::vector<std::string> stepping(const std::string& algorithm, const std::string& grain,
                                  const std::vector<std::string>& more)
{
    std::vector<std::string> arguments{"step"};
    arguments.insert(arguments.end(), kView.begin(), kView.end());
    arguments.insert(arguments.end(), {"--algorithm", algorithm, "--grain", grain});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

long countOf(const std::string& algorithm, const std::string& grain)
{
    const Answer answer = run(stepping(algorithm, grain, {"--count"}));
    EXPECT_EQ(answer.status, 0) << answer.err;
    return std::atol(answer.out.c_str());
}

std::vector<unsigned> pixelsOf(const std::string& file)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&image, file.c_str())) << image.message;
    image.format = PNG_FORMAT_RGBA;
    std::vector<unsigned> pixels(static_cast<std::size_t>(image.width) * image.height);
    EXPECT_TRUE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr)) << image.message;
    return pixels;
}

TEST_F(Cli, EveryGrainHasStepsAndFinerOnesHaveMore)
{
    // What two passes drew a frame ago leaves nothing to update in the small scene.
    const auto countIn = [](const Preset& preset, Grain grain) {
        const std::string name(preset.name), word(wordOf(grain));
        if (preset.pipeline.coherence == Coherence::None) return countOf(name, word);
        const Answer answer =
            run({"step", "builtin:city?blocks=1", "--size", "96x64", "--algorithm", name, "--grain", word, "--count"});
        EXPECT_EQ(answer.status, 0) << answer.err;
        return std::atol(answer.out.c_str());
    };
    for (const Preset& preset : presets()) {
        long coarser = 0;
        for (const Grain grain : grainsOf(preset.pipeline)) {
            const long count = countIn(preset, grain);
            EXPECT_GT(count, coarser) << preset.name << ' ' << wordOf(grain);
            coarser = count;
        }
        EXPECT_EQ(countOf(std::string(preset.name), "frame"), 1);
    }
}

TEST_F(Cli, AStepBeyondTheLastIsAMistake)
{
    for (const Preset& preset : presets()) {
        for (const Grain grain : grainsOf(preset.pipeline)) {
            const std::string name(preset.name), word(wordOf(grain));
            const long        count = countOf(name, word);
            const auto        at    = [&](long k) {
                return run(stepping(name, word, {"--at", std::to_string(k), "--state", path("s.json")}));
            };
            EXPECT_EQ(at(count - 1).status, 0);
            std::filesystem::remove(path("s.json"));
            EXPECT_EQ(at(count).status, 2);
            EXPECT_FALSE(std::filesystem::exists(path("s.json")));
        }
    }
}

TEST_F(Cli, TheLastStepIsTheRenderedPicture)
{
    for (const Preset& preset : presets()) {
        std::vector<std::string> render{"render"};
        render.insert(render.end(), kView.begin(), kView.end());
        render.insert(render.end(), {"--algorithm", std::string(preset.name), "-o", path("whole.png")});
        ASSERT_EQ(run(render).status, 0);
        for (const Grain grain : grainsOf(preset.pipeline)) {
            const std::string name(preset.name), word(wordOf(grain));
            const std::string last = std::to_string(countOf(name, word) - 1);
            ASSERT_EQ(run(stepping(name, word, {"--at", last, "-o", path("last.png")})).status, 0);
            EXPECT_EQ(pixelsOf(path("last.png")), pixelsOf(path("whole.png"))) << name << ' ' << word;
        }
    }
}

TEST_F(Cli, AStepIsTheSameBytesForwardsBackwardsAndAtRandom)
{
    for (const Preset& preset : presets()) {
        const std::string name(preset.name);
        const std::string word(wordOf(grainsOf(preset.pipeline)[2]));  // triangle or line
        const long        count = countOf(name, word);
        std::vector<long> steps;
        for (long k = 0; k < count; k += std::max(1L, count / 12)) steps.push_back(k);
        std::map<long, std::string> first;
        std::mt19937                random(7);
        for (const char* order : {"forwards", "backwards", "at random"}) {
            for (const long k : steps) {
                ASSERT_EQ(run(stepping(name, word,
                                       {"--at", std::to_string(k), "--state", path("s.json"), "-o", path("p.png")}))
                              .status,
                          0);
                const std::string bytes = contentsOf(path("s.json")) + contentsOf(path("p.png"));
                EXPECT_EQ(first.try_emplace(k, bytes).first->second, bytes)
                    << name << ' ' << word << ' ' << k << ' ' << order;
            }
            std::ranges::reverse(steps);
            if (std::string(order) == "backwards") std::ranges::shuffle(steps, random);
        }
        EXPECT_GT(first.size(), 5u);
    }
}

TEST_F(Cli, TheScanlineStateHoldsItsTables)
{
    const long count    = countOf("scanline", "line");
    bool       sawEdges = false;
    for (long k = 0; k < count; k += 3) {
        ASSERT_EQ(run(stepping("scanline", "line", {"--at", std::to_string(k), "--state", path("s.json")})).status, 0);
        const json state = json::parse(contentsOf(path("s.json")));
        EXPECT_EQ(state["algorithm"], "scanline");
        EXPECT_EQ(state["grain"], "line");
        EXPECT_EQ(state["step"], k);
        EXPECT_EQ(state["count"], count);
        EXPECT_FALSE(state["sentence"].get<std::string>().empty());
        if (!state.contains("active_edges")) continue;  // before the first line
        double last = -1e300;
        for (const json& edge : state["active_edges"]) {
            sawEdges = true;
            EXPECT_GE(edge["x"].get<double>(), last) << "sorted by x";
            last = edge["x"].get<double>();
            EXPECT_EQ(edge["x_subpixels"].get<double>(), std::floor(last * 256));
            EXPECT_GT(edge["dx"][1].get<long>(), 0);
            EXPECT_GE(edge["last_line"].get<int>(), state["line"].get<int>());
            const auto& polygons = state["active_polygons"];
            EXPECT_NE(std::ranges::find(polygons, edge["polygon"]), polygons.end());
        }
        for (const json& span : state["spans"]) EXPECT_LT(span["x0"].get<int>(), span["x1"].get<int>());
        EXPECT_TRUE(state["entered"].is_array() && state["left"].is_array());
    }
    EXPECT_TRUE(sawEdges);
}

TEST_F(Cli, LevelsPutsTheValuesOfThePyramidIntoTheState)
{
    const long last      = countOf("hzb-octree", "query") - 1;
    const auto stateWith = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"--at", std::to_string(last), "--state", path("s.json")};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(run(stepping("hzb-octree", "query", words)).status, 0);
        return json::parse(contentsOf(path("s.json")));
    };
    EXPECT_FALSE(stateWith({})["pyramid"].contains("stored"));
    const json  pyramid = stateWith({"--levels"})["pyramid"];
    const auto& stored  = pyramid["stored"];
    ASSERT_FALSE(stored.empty());
    EXPECT_EQ(stored.back()["farthest"].size(), 1u) << "the top is one cell";
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const json& size = pyramid["levels"][stored[i]["level"].get<std::size_t>()];
        const json& rows = stored[i]["farthest"];
        ASSERT_EQ(rows.size(), size[1].get<std::size_t>());
        for (const json& row : rows) ASSERT_EQ(row.size(), size[0].get<std::size_t>());
        if (i == 0) continue;
        // No cell is nearer than the farthest of its four children, stale or not.
        const json& below = stored[i - 1]["farthest"];
        for (std::size_t y = 0; y < rows.size(); ++y)
            for (std::size_t x = 0; x < rows[y].size(); ++x)
                for (std::size_t j = 0; j < 4; ++j) {
                    const std::size_t childY = 2 * y + j / 2, childX = 2 * x + j % 2;
                    if (childY >= below.size() || childX >= below[0].size()) continue;
                    EXPECT_LE(rows[y][x].get<float>(), below[childY][childX].get<float>());
                }
    }
    EXPECT_EQ(run(stepping("hzb-octree", "query", {"--at", "0", "--levels"})).status, 2);
}

}  // namespace
}  // namespace zscope::cli_test
