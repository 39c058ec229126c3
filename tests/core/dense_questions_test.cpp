// Questions about dense nodes are left out while they are seldom answered with "hidden", and come back when that changes.
#include <gtest/gtest.h>

#include "core/cull/dense_questions.h"

namespace zscope {
namespace {

/// How many of `nodes` are asked about, if all of them are hidden or none is.
int asked(DenseQuestions& questions, int nodes, bool areHidden)
{
    int count = 0;
    for (int i = 0; i < nodes; ++i) {
        if (!questions.isWorthIt()) continue;
        questions.answered(areHidden);
        ++count;
    }
    return count;
}

TEST(DenseQuestions, AreAskedUntilEnoughAreAnswered)
{
    DenseQuestions questions;
    EXPECT_EQ(asked(questions, DenseQuestions::kFirst, false), static_cast<int>(DenseQuestions::kFirst));
    EXPECT_FALSE(questions.isWorthIt());
}

TEST(DenseQuestions, AreSampledWhileNodesAreSeldomHidden)
{
    DenseQuestions questions;
    asked(questions, DenseQuestions::kFirst, false);
    EXPECT_EQ(asked(questions, 10 * DenseQuestions::kSampled, false), 10);
}

TEST(DenseQuestions, AreAllAskedWhileNodesAreOftenHidden)
{
    DenseQuestions questions;
    EXPECT_EQ(asked(questions, 1000, true), 1000);
}

TEST(DenseQuestions, ComeBackWhenSamplesAreHidden)
{
    DenseQuestions questions;
    asked(questions, DenseQuestions::kFirst, false);
    asked(questions, 1000, true);
    EXPECT_EQ(asked(questions, 100, true), 100);
}

}  // namespace
}  // namespace zscope
