// The fuzzer's seeds and a few thousand seeded changes to them, in bounded time, wherever the tests run.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/obj_target.h"

namespace zscope {
namespace {

const std::filesystem::path kSeeds = std::filesystem::path(ZSCOPE_SOURCE_DIR) / "tests/fuzz/obj_seeds";

std::vector<std::string> seeds()
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(kSeeds)) paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<std::string> texts;
    for (const auto& path : paths) {
        std::ifstream file(path, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return texts;
}

/// One to eight changes: bytes, copies, cuts, and words that readers stumble over.
std::string changed(std::string text, const std::vector<std::string>& all, std::mt19937_64& random)
{
    static const std::vector<std::string> kWords{"nan",
                                                 "inf",
                                                 "1e999",
                                                 "-1",
                                                 "0",
                                                 "4294967297",
                                                 "\\\n",
                                                 "\r",
                                                 "\n",
                                                 "#",
                                                 "/",
                                                 "//",
                                                 "f 1 2 3\n",
                                                 "f -1 -2 -3 -4\n",
                                                 "v 0 0 0\n",
                                                 "g\n",
                                                 "o\n",
                                                 "usemtl\n",
                                                 "mtllib\n",
                                                 "mtllib ../../dev/zero\n",
                                                 "\xEF\xBB\xBF",
                                                 std::string("\0", 1),
                                                 " ",
                                                 "\t",
                                                 "e",
                                                 ".",
                                                 "\xFF\xFE",
                                                 " #",
                                                 "usemtl a #1\n",
                                                 "\x95\\\n",
                                                 "\\ \n",
                                                 "\f",
                                                 "1.#IND",
                                                 "\u00A0"};
    const auto                            below = [&](std::size_t limit) {
        return static_cast<std::size_t>(random() % std::max<std::size_t>(limit, 1));
    };
    for (std::size_t changes = 1 + below(8); changes > 0; --changes) {
        const std::size_t at = below(text.size() + 1);
        switch (below(5)) {
            case 0:
                text.insert(at, kWords[below(kWords.size())]);
                break;
            case 1:
                text.erase(at, below(20));
                break;
            case 2:
                if (at < text.size()) text[at] = static_cast<char>(random());
                break;
            case 3:
                text.insert(at, text.substr(below(text.size() + 1), below(200)));
                break;
            default: {
                const std::string& other = all[below(all.size())];
                text.insert(at, other.substr(below(other.size() + 1), below(200)));
            }
        }
    }
    return text;
}

TEST(ObjSeeds, MostGiveAMesh)
{
    int meshes = 0, count = 0;
    for (const std::string& text : seeds()) {
        meshes += fuzz::readAsObj(text);
        ++count;
    }
    EXPECT_GE(count, 10) << "the seeds are in " << kSeeds;
    EXPECT_GE(meshes, count / 2);
}

TEST(ObjMutations, KeepEveryPromiseOfTheReader)
{
    constexpr std::uint64_t        kSeed = 2026;
    std::mt19937_64                random(kSeed);
    const std::vector<std::string> all = seeds();
    ASSERT_FALSE(all.empty());
    int meshes = 0;
    for (int i = 0; i < 6000; ++i) meshes += fuzz::readAsObj(changed(all[random() % all.size()], all, random));
    EXPECT_GT(meshes, 1000) << "seed " << kSeed << ": the changes should leave many files readable";
}

}  // namespace
}  // namespace zscope
