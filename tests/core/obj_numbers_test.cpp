#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include <fmt/format.h>

#include "core/scene/obj/numbers.h"
#include "tests/core/obj_support.h"

namespace zscope {
namespace {

using obj::NumberTrouble;

void expectAsStrtod(const std::string& text)
{
    double       value    = 0;
    const auto   trouble  = obj::readReal(text, value);
    const double expected = std::strtod(text.c_str(), nullptr);  // the "C" locale of a test program
    if (std::isinf(expected)) {
        EXPECT_EQ(trouble, NumberTrouble::OutOfRange) << text;
        return;
    }
    ASSERT_EQ(trouble, NumberTrouble::None) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
}

TEST(ObjNumbers, AreTheNearestFloat64BitForBit)
{
    std::mt19937_64 random(21);
    const auto      digits = [&](std::uint64_t count) {
        std::string text;
        for (std::uint64_t i = 0; i < count; ++i) text += static_cast<char>('0' + random() % 10);
        return text;
    };
    for (int i = 0; i < 50'000; ++i) {
        std::string text = random() % 3 == 0 ? "-" : random() % 5 == 0 ? "+" : "";
        text += digits(1 + random() % 12);
        if (random() % 4 != 0) text.append(".").append(digits(random() % 24));
        if (random() % 3 == 0)
            text += fmt::format("e{}{}", random() % 2 ? "-" : random() % 2 ? "+" : "", random() % 330);
        expectAsStrtod(text);
        if (testing::Test::HasFailure()) FAIL() << "seed 21, case " << i;
    }
    for (int i = 0; i < 50'000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (std::isfinite(value)) expectAsStrtod(fmt::format("{:.17g}", value));
    }
}

TEST(ObjNumbers, HalfwayBetweenTwoFloat64GoToTheEvenOne)
{
    expectAsStrtod("9007199254740993");
    expectAsStrtod("9007199254740993.00000000000000000000000000000000000000000000000000000000000001");
    expectAsStrtod("1.00000000000000011102230246251565404236316680908203125");
    expectAsStrtod("2.4703282292062327208e-324");
    expectAsStrtod("2.2250738585072011e-308");
    expectAsStrtod("179769313486231580793728971405301e276");
    expectAsStrtod(".5");
    expectAsStrtod("5.");
    expectAsStrtod("-0");
}

TEST(ObjNumbers, TooSmallForFloat64AreZeroAndTooLargeAreRefused)
{
    for (const char* tiny : {"1e-400", "-1e-999999999999999999999", "0.000e99999", "1e-324"}) expectAsStrtod(tiny);
    expectAsStrtod("0." + std::string(400, '0') + "1");
    expectAsStrtod("0." + std::string(400, '0') + "1e401");
    for (const char* huge : {"1e999", "-1e309", "1e99999999999999999999999"}) expectAsStrtod(huge);
    expectAsStrtod(std::string(400, '9'));
    expectAsStrtod(std::string(400, '9') + "e-390");
}

TEST(ObjNumbers, AreNothingButWholeWords)
{
    double value = 0;
    for (const char* word :
         {"1,5", "0x10", "1.5abc", "", "+", "-", ".", "e5", "1e", "+-1", "++1", "--1", "1.2.3", "1f", "1_000"})
        EXPECT_EQ(obj::readReal(word, value), NumberTrouble::NotANumber) << word;
    for (const char* word : {"nan", "-nan", "inf", "-inf", "infinity", "NaN", "INF"})
        EXPECT_EQ(obj::readReal(word, value), NumberTrouble::NotFinite) << word;
    EXPECT_EQ(obj::readReal("+1.5", value), NumberTrouble::None);
    EXPECT_EQ(value, 1.5);
}

TEST(ObjNumbers, ReachTheMeshUnchanged)
{
    const auto import =
        test::read("v 0.1 -2.675 1e-3\nv +1.5 123456789.123456789 5e-324\nv 1e308 -1e308 -0.0\nf 1 2 3\n");
    ASSERT_TRUE(import.ok()) << import.error().text();
    EXPECT_EQ(import->mesh->positions[0], dvec3(0.1, -2.675, 1e-3));
    EXPECT_EQ(import->mesh->positions[1], dvec3(1.5, 123456789.123456789, 5e-324));
    EXPECT_EQ(import->mesh->positions[2], dvec3(1e308, -1e308, -0.0));
    EXPECT_TRUE(import->warnings.empty());
}

}  // namespace
}  // namespace zscope
