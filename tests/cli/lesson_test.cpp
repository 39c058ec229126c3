// Lessons from the command line: where pages stop, what is right, and what is wrong with a file.
#include <fstream>

#include "tests/cli/run_cli.h"

namespace zscope::cli_test {
namespace {

constexpr const char* kGood =
    "=== lesson\n{\"title\": \"Good\"}\n"
    "=== page\n{\"scene\": \"builtin:cube\", \"size\": [64, 36], \"algorithm\": \"scanline\",\n\"stop\": {\"grain\": "
    "\"line\", \"line\": 12}}\n"
    "=== en\nText\n"
    "=== question\n{\"kind\": \"number\", \"fact\": \"line\", \"ask\": \"Which line?\", \"why\": \"So.\"}\n";

TEST_F(Cli, LessonTellsWhereEachPageStopsAndWhatIsRight)
{
    std::ofstream(path("good.md")) << kGood;
    const Answer answer = run({"lesson", path("good.md")});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_NE(answer.out.find("Line 12 is drawn"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("Which line? -> 12"), std::string::npos) << answer.out;
}

TEST_F(Cli, LessonTellsFileAndLineOfEachBrokenFileAndChecksTheRest)
{
    std::ofstream(path("good.md")) << kGood;
    std::string never = kGood;
    never.replace(never.find("\"line\": 12"), 10, "\"line\": 77");
    std::ofstream(path("never.md")) << never;
    std::ofstream(path("broken.md")) << "=== lesson\n{\"titel\": 1}\n";
    const Answer answer = run({"lesson", path("broken.md"), path("never.md"), path("good.md")});
    EXPECT_EQ(answer.status, 3);
    EXPECT_NE(answer.err.find("broken.md:2: error: "), std::string::npos) << answer.err;
    EXPECT_NE(answer.err.find("never.md:5: error: the run never comes to this stop"), std::string::npos) << answer.err;
    EXPECT_NE(answer.out.find("Which line? -> 12"), std::string::npos) << answer.out;
    EXPECT_EQ(run({"lesson"}).status, 2);
    EXPECT_EQ(run({"lesson", path("missing.md")}).status, 3);
}

}  // namespace
}  // namespace zscope::cli_test
