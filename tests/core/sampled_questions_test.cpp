// Questions are left out while they are seldom answered with "hidden", and come back when that changes.
#include <gtest/gtest.h>

#include "core/fast/skipped_questions/sampled_questions.h"

namespace zscope {
namespace {

/// How many of `nodes` are asked about, if all of them are hidden or none is.
int asked(SampledQuestions& questions, int nodes, bool areHidden)
{
    int count = 0;
    for (int i = 0; i < nodes; ++i) {
        if (!questions.isWorthIt()) continue;
        questions.answered(areHidden);
        ++count;
    }
    return count;
}

TEST(SampledQuestions, AreAskedUntilEnoughAreAnswered)
{
    SampledQuestions questions;
    EXPECT_EQ(asked(questions, SampledQuestions::kFirst, false), static_cast<int>(SampledQuestions::kFirst));
    EXPECT_FALSE(questions.isWorthIt());
}

TEST(SampledQuestions, WaitForAsManyAnswersAsTheyAreTold)
{
    SampledQuestions questions(100);
    EXPECT_EQ(asked(questions, 100, false), 100);
    EXPECT_FALSE(questions.isWorthIt());
}

TEST(SampledQuestions, AreSampledWhileNodesAreSeldomHidden)
{
    SampledQuestions questions;
    asked(questions, SampledQuestions::kFirst, false);
    EXPECT_EQ(asked(questions, 10 * SampledQuestions::kSampled, false), 10);
}

TEST(SampledQuestions, AreAllAskedWhileNodesAreOftenHidden)
{
    SampledQuestions questions;
    EXPECT_EQ(asked(questions, 1000, true), 1000);
}

TEST(SampledQuestions, ComeBackWhenSamplesAreHidden)
{
    SampledQuestions questions;
    asked(questions, SampledQuestions::kFirst, false);
    asked(questions, 1000, true);
    EXPECT_EQ(asked(questions, 100, true), 100);
}

}  // namespace
}  // namespace zscope
