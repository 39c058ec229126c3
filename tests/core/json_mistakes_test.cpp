// JSON as people write it: every common mistake is told by its name, with line and column, and everything else is read
// as nlohmann's parser reads it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/io/json_document.h"
#include "core/lesson/lesson_file.h"
#include "core/measure/experiment.h"
#include "core/measure/record.h"
#include "core/scene/camera_path.h"
#include "core/scene/view_json.h"

namespace zscope {
namespace {

std::string errorOf(const std::string& text)
{
    const auto read = parseJson(text, "f");
    return read.ok() ? "none" : read.error().text();
}

TEST(JsonMistakes, AreToldByTheirNameWithLineAndColumn)
{
    struct Case {
        std::string text;
        int         line, column;
        const char* sentence;
    };
    const char* const       kSingle = "a text stands in double quotes, not in single ones";
    const char* const       kCurly  = "a text stands in straight double quotes, not in curly ones";
    const char* const       kComma  = "a comma is missing before this place";
    const char* const       kOpen   = "the text that begins here has no closing double quote on its line";
    const std::vector<Case> cases{
        {"{\"a\": 1,}", 1, 8, "no comma may stand before '}'"},
        {"{\"a\": [1,\n 2 ,\n\n]}", 2, 4, "no comma may stand before ']'"},
        {"{\"a\": {\"b\": 1,\r\n}}", 1, 14, "no comma may stand before '}'"},
        {"[1],", 1, 4, "nothing may follow the end of the document, no comma either"},
        {"[1] [2]", 1, 5, "nothing may follow the end of the document"},
        {"// scene\n{}", 1, 1, "JSON has no comments"},
        {"{\n  \"a\": 1, // one\n}", 2, 11, "JSON has no comments"},
        {"{\"a\": /* one */ 1}", 1, 7, "JSON has no comments"},
        {"{\"a\": 1 # one\n}", 1, 9, "JSON has no comments"},
        {"{} // end", 1, 4, "JSON has no comments"},
        {"{'a': 1}", 1, 2, kSingle},
        {"{\"a\": 'b'}", 1, 7, kSingle},
        {"[\n'b']", 2, 1, kSingle},
        {"{“a”: 1}", 1, 2, kCurly},
        {"{\"墙\": “b”}", 1, 7, kCurly},
        {"[„b“]", 1, 2, kCurly},
        {"{a: 1}", 1, 2, "the key 'a' needs double quotes"},
        {"{\"b\": 1,\n  a_2: 1}", 2, 3, "the key 'a_2' needs double quotes"},
        {"{1: 1}", 1, 2, "a key in double quotes must stand here"},
        {"{\"a\": 1,5}", 1, 8, "a decimal has a point, not a comma"},
        {"[NaN]", 1, 2, "'NaN' is no number of JSON"},
        {"[-Infinity]", 1, 2, "'-Infinity' is no number of JSON"},
        {"[1.#IND]", 1, 2, "'1.#IND' is no number of JSON"},
        {"[-1.#QNAN0, 2]", 1, 2, "'-1.#QNAN0' is no number of JSON"},
        {"[.5]", 1, 2, "'.5' is no number of JSON"},
        {"[5.]", 1, 2, "'5.' is no number of JSON"},
        {"[+5]", 1, 2, "'+5' is no number of JSON"},
        {"[05]", 1, 2, "'05' is no number of JSON"},
        {"[0x1F]", 1, 2, "'0x1F' is no number of JSON"},
        {"[1e]", 1, 2, "'1e' is no number of JSON"},
        {"[-]", 1, 2, "'-' is no number of JSON"},
        {"{\"a\": True}", 1, 7, "'True' is no value of JSON: a text stands in double quotes"},
        {"[red]", 1, 2, "'red' is no value of JSON: a text stands in double quotes"},
        {"[1 2]", 1, 4, kComma},
        {"{\"a\": 1\n \"b\": 2}", 2, 2, kComma},
        {"[{} {}]", 1, 5, kComma},
        {"[\"a\"\n\"b\"]", 2, 1, kComma},
        {"{\"a\" 1}", 1, 6, "a colon is missing after the key 'a'"},
        {"{\"a\", 1}", 1, 5, "a colon is missing after the key 'a'"},
        {"{\"a\": }", 1, 7, "a value is missing before '}'"},
        {"[1,,2]", 1, 4, "a value is missing before ','"},
        {"[,1]", 1, 2, "a value is missing before ','"},
        {"{\"a\": [1, 2}", 1, 12, "'}' does not close the '[' of line 1"},
        {"{\n\"a\": 1]", 2, 7, "']' does not close the '{' of line 1"},
        {"{\"a\": 1", 1, 8, "the text ends before the '{' of line 1 is closed"},
        {"{\n\"a\": [\n1,\n", 4, 1, "the text ends before the '[' of line 2 is closed"},
        {"{\"a\"", 1, 5, "the text ends before the '{' of line 1 is closed"},
        {"{", 1, 2, "the text ends before the '{' of line 1 is closed"},
        {"", 1, 1, "the text ends before a value"},
        {" \n", 2, 1, "the text ends before a value"},
        {"[\"a, 1]", 1, 2, kOpen},
        {"{\"a: 1,\n\"b\": 2}", 1, 2, kOpen},
        {"[\"a\\", 1, 4, "a backslash inside of a text is written twice"},
        {"[\"a\tb\"]", 1, 4, "inside of a text, U+0009 is written \\u0009"},
        {"[\"C:\\models\"]", 1, 5, "a backslash inside of a text is written twice"},
        {"[\"\\u12g4\"]", 1, 3, "\\u needs four hexadecimal digits"},
        {"[\"\\uD800\"]", 1, 3, "half of a surrogate pair is no character"},
        {"[\"\\uDC00\"]", 1, 3, "half of a surrogate pair is no character"},
        {"[\"caf\xE9\"]", 1, 6, "the byte 0xE9 is no UTF-8: save the file as UTF-8"},
        {"[1,\u00A02]", 1, 4, "the character U+00A0 is no blank of JSON"},
        {"[\u200B1]", 1, 2, "the character U+200B is no blank of JSON"},
        {"{\"a\":\u30001}", 1, 6, "the character U+3000 is no blank of JSON"},
        {"[;]", 1, 2, "a value must stand here"},
    };
    for (const Case& c : cases)
        EXPECT_EQ(errorOf(c.text), "f:" + std::to_string(c.line) + ": this is not JSON at column "
                                       + std::to_string(c.column) + ": " + c.sentence)
            << c.text;
}

TEST(JsonMistakes, AreToldAlikeInEveryKindOfFile)
{
    const std::string text     = "{\"a\": 1,\n \"b\": 2,\n}",
                      sentence = "f:2: this is not JSON at column 8: no comma may stand before '}'";
    EXPECT_EQ(errorOf(text), sentence);
    EXPECT_EQ(cameraFromJson(text, "f").error().text(), sentence);
    EXPECT_EQ(cameraPathFromJson(text, "f").error().text(), sentence);
    EXPECT_EQ(experimentFromJson(text, "f").error().text(), sentence);
    EXPECT_EQ(recordFromJson(text, "f").error().text(), sentence);
    EXPECT_EQ(parseLesson("A remark.\n=== lesson\n" + text + "\n", "f").error().text(),
              "f:4: this is not JSON at column 8: no comma may stand before '}'");
}

using Json = nlohmann::ordered_json;

/// The two documents say the same.
bool isSame(const JsonValue& ours, const Json& other)
{
    if (const auto* array = ours.array()) {
        if (!other.is_array() || array->size() != other.size()) return false;
        for (std::size_t i = 0; i < array->size(); ++i)
            if (!isSame((*array)[i], other[i])) return false;
        return true;
    }
    if (const auto* object = ours.object()) {
        if (!other.is_object() || object->size() != other.size()) return false;
        auto member = other.begin();
        for (const JsonMember& own : *object) {
            if (own.first != member.key() || !isSame(own.second, member.value())) return false;
            ++member;
        }
        return true;
    }
    if (const auto* text = ours.text()) return other.is_string() && *text == other.get<std::string>();
    if (const auto* truth = ours.truth()) return other.is_boolean() && *truth == other.get<bool>();
    if (const auto* whole = std::get_if<std::int64_t>(&ours.value))
        return other.is_number_integer() && *whole == other.get<std::int64_t>();
    if (const auto* large = std::get_if<std::uint64_t>(&ours.value))
        return other.is_number_unsigned() && *large == other.get<std::uint64_t>();
    if (const auto* real = std::get_if<double>(&ours.value))
        return other.is_number_float() && *real == other.get<double>()
               && std::signbit(*real) == std::signbit(other.get<double>());
    return other.is_null();
}

TEST(JsonDocument, IsReadAsAnotherParserReadsIt)
{
    const std::vector<std::string> seeds{
        R"({"a": [1, -2, 3.5e-7, 1E+5, 0.25, -0, -0.0, 1e-400, -1e-400, 4.9e-324, 123456789012345678901234567890]})",
        R"([9223372036854775807, 9223372036854775808, 18446744073709551615, 18446744073709551616, -9223372036854775808])",
        R"({"text": "\"\\\/\b\f\n\r\t\u0041\u00e9\u4e2d\ud83d\ude00 墙 é 😀", "": [], "o": {}, "t": true, "f": false})",
        "\xEF\xBB\xBF [ null , { \"a\" : { \"b\" : [ [ ] , [ 1 ] ] } } ] \r\n\t ",
        "\"x\"",
        "7",
        "null",
        R"({"size": [64, 36], "eye": ["0x1.8p3", 2, 1], "up": [0, 1, 0], "name": "C:\\models\\a.obj"})"};
    const std::string kBytes = "{}[],:\"\\ -+.eE0123456789truefalsn\n\tu\x01\x80\xC3\xE2\xED\xF0'/#";
    std::mt19937_64   random(77);
    int               good = 0, bad = 0;
    for (int i = 0; i < 60'000; ++i) {
        std::string text = seeds[random() % seeds.size()];
        for (std::uint64_t changes = random() % 4; changes > 0 && !text.empty(); --changes) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = kBytes[random() % kBytes.size()];
                    break;
                case 1:
                    text.insert(at, 1, kBytes[random() % kBytes.size()]);
                    break;
                case 2:
                    text.erase(at, 1 + random() % 3);
                    break;
                default:
                    text.insert(at, text.substr(random() % text.size(), random() % 8));
            }
        }
        const auto ours  = parseJson(text, "f");
        Json       other = Json::parse(text, nullptr, false);
        if (!ours.ok() && !other.is_discarded()) {  // it keeps the last of two equal keys, and reads 1e999 as an error
            EXPECT_NE(ours.error().sentence.find("given twice"), std::string::npos) << text << ours.error().text();
            continue;
        }
        ASSERT_EQ(ours.ok(), !other.is_discarded()) << text;
        if (ours.ok())
            EXPECT_TRUE(isSame(*ours, other)) << text;
        else
            EXPECT_TRUE(ours.error().line >= 1 || ours.error().sentence.find("UTF-") != std::string::npos) << text;
        ++(ours.ok() ? good : bad);
    }
    EXPECT_GT(good, 10'000);
    EXPECT_GT(bad, 10'000);
}

}  // namespace
}  // namespace zscope
