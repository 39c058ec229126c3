// `audit` as scripts call it: words, JSON, exit statuses, refusals.
#include <nlohmann/json.hpp>

#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

using nlohmann::json;

class Audit : public Cli {
protected:
    Answer audit(std::vector<std::string> words) const
    {
        words.insert(words.begin(), {"audit", "builtin:soccer-field?count=20", "--size", "160x100"});
        return run(words);
    }
};

TEST_F(Audit, NamesWhatIsCulledAlthoughItIsSeen)
{
    write("v.json", R"([{"group": "instance 0", "culled": true}, {"group": "instance 1", "culled": false},
                        {"name": "far", "min": [1e6, 1e6, 1e6], "max": [2e6, 2e6, 2e6], "culled": false}])");
    const Answer answer = audit({"--verdicts", path("v.json"), "--json"});
    EXPECT_EQ(answer.status, 1) << answer.err;
    const json found = json::parse(answer.out);
    EXPECT_EQ(found.at("objects"), 3);
    EXPECT_EQ(found.at("culled"), 1);
    EXPECT_EQ(found.at("false_culls").at(0).at("name"), "instance 0");
    EXPECT_GT(found.at("false_culls").at(0).at("pixels"), 0);
    EXPECT_EQ(found.at("missed_culls"), json::array({{{"name", "far"}}}));
    EXPECT_EQ(found.at("cause"), nullptr);
    const Answer text = audit({"--verdicts", path("v.json")});
    EXPECT_NE(text.out.find("1 object is culled although it owns"), std::string::npos) << text.out;

    write("r.json", R"([{"group": "instance 0", "culled": false}])");
    EXPECT_EQ(audit({"--verdicts", path("r.json")}).status, 0);
}

TEST_F(Audit, RefusesWithASentence)
{
    write("v.json", "[]\n");
    write("s.json", R"([{"group": "nobody", "culled": true}])");
    write("t.npy", "no array");
    EXPECT_EQ(audit({}).status, 2);
    EXPECT_EQ(audit({"--verdicts", path("v.json"), "--pyramid", path("t.npy")}).status, 2);
    EXPECT_EQ(audit({"--verdicts", path("v.json")}).status, 0);
    EXPECT_EQ(audit({"--verdicts", path("s.json")}).status, 3);
    EXPECT_EQ(audit({"--pyramid", path("t.npy")}).status, 3);
    EXPECT_EQ(audit({"--pyramid", path("none.npy")}).status, 3);
}

}  // namespace
}  // namespace zscope::cli_test
