// Every kind of text file takes the byte order mark of UTF-8, and refuses UTF-16 with the same sentence.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "core/base/quotable.h"
#include "core/io/json_document.h"
#include "core/io/text_encoding.h"
#include "core/lesson/lesson_file.h"
#include "core/measure/experiment.h"
#include "core/measure/record.h"
#include "core/scene/camera_path.h"
#include "core/scene/load.h"
#include "core/scene/view_json.h"
#include "tests/core/obj_support.h"

namespace zscope {
namespace {

using test::TemporaryFolder;

const std::string kRefused = "the text is UTF-16; save it as UTF-8 or plain ASCII";

enum class Order { Little, Big };

/// ASCII and Chinese of the basic plane as UTF-16.
std::string asUtf16(std::string_view text, Order order)
{
    std::string wide;
    while (!text.empty()) {
        const auto character = firstCharacter(text);
        const char low = static_cast<char>(character->code & 0xFF), high = static_cast<char>(character->code >> 8);
        wide += order == Order::Little ? low : high;
        wide += order == Order::Little ? high : low;
        text.remove_prefix(character->bytes);
    }
    return wide;
}

std::string asUtf32(std::string_view text)
{
    std::string wide;
    for (const char c : text) wide += {c, '\0', '\0', '\0'};
    return wide;
}

std::string sourceFile(const std::string& name)
{
    std::ifstream file(ZSCOPE_SOURCE_DIR + ("/" + name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A kind of file: a good text, and what reading it says; empty if it is read.
struct Kind {
    const char*                                    name;
    std::string                                    text;
    std::function<std::string(const std::string&)> read;
};

template <class Value>
std::string sentenceOf(const Result<Value>& result)
{
    return result.ok() ? "" : result.error().sentence;
}

std::vector<Kind> kinds(const TemporaryFolder& folder)
{
    const std::string square = std::string(test::kSquare) + "f 1 2 3 4\n";
    const std::string camera = R"({"eye": [0, 0, 1], "right": [1, 0, 0], "up": [0, 1, 0], "forward": [0, 0, -1],
        "focal": 100, "near": 0.1, "far": 10, "width": 64, "height": 36})";
    return {
        {"OBJ", square, [](const std::string& text) { return sentenceOf(importObjText(text, "f", "")); }},
        {"MTL", "# 红\nnewmtl red\nKd 1 0 0\n",
         [&folder, square](const std::string& text) {
             folder.write("m.mtl", text);
             const auto import = importObj(folder.write("a.obj", "mtllib m.mtl\nusemtl red\n" + square));
             if (import->warnings.empty()) return std::string();
             const std::string before   = "material library 'm.mtl' is left out: ";
             const std::string sentence = import->warnings.front().sentence;
             return sentence.starts_with(before) ? sentence.substr(before.size()) : sentence;
         }},
        {"scene", R"({"meshes": {"墙": {"builtin": "cube"}}, "instances": [{"mesh": "墙"}]})",
         [&folder](const std::string& text) { return sentenceOf(loadScene(folder.write("s.json", text))); }},
        {"camera", camera, [](const std::string& text) { return sentenceOf(cameraFromJson(text, "f")); }},
        {"camera path", sourceFile("assets/paths/office-walk.json"),
         [](const std::string& text) { return sentenceOf(cameraPathFromJson(text, "f")); }},
        {"experiment", sourceFile("assets/experiments/upkeep.json"),
         [](const std::string& text) { return sentenceOf(experimentFromJson(text, "f")); }},
        {"record",
         R"({"record": 1, "experiment": {"title": {"en": "t", "zh_CN": ""}, "question": {"en": "q", "zh_CN": ""},
             "baseline": "zbuffer", "digest": "d"}, "program": {"version": "1", "compiler": "c"},
             "machine": {"processor": "p", "cores": 2}, "case_count": 1, "cases": []})",
         [](const std::string& text) { return sentenceOf(recordFromJson(text, "f")); }},
        {"lesson", sourceFile("resources/lessons/01-what-hides-what.md"),
         [](const std::string& text) { return sentenceOf(parseLesson(text, "f")); }},
    };
}

TEST(TextEncoding, TakesAByteOrderMarkInEveryKindOfFile)
{
    const TemporaryFolder folder;
    for (const Kind& kind : kinds(folder)) {
        EXPECT_FALSE(kind.text.empty()) << kind.name;
        EXPECT_EQ(kind.read(kind.text), "") << kind.name;
        EXPECT_EQ(kind.read("\xEF\xBB\xBF" + kind.text), "") << kind.name;
    }
}

TEST(TextEncoding, RefusesUtf16WithOneSentenceInEveryKindOfFile)
{
    const TemporaryFolder folder;
    for (const Kind& kind : kinds(folder)) {
        EXPECT_EQ(kind.read(asUtf16("\uFEFF" + kind.text, Order::Little)), kRefused) << kind.name;
        EXPECT_EQ(kind.read(asUtf16("\uFEFF" + kind.text, Order::Big)), kRefused) << kind.name;
        EXPECT_EQ(kind.read(asUtf16(kind.text, Order::Little)), kRefused) << kind.name << " without a mark";
        EXPECT_EQ(kind.read(asUtf16(kind.text, Order::Big)), kRefused) << kind.name << " without a mark";
    }
}

TEST(TextEncoding, IsSeenWithoutAMarkWhereverAQuarterIsAscii)
{
    EXPECT_EQ(encodingTrouble(asUtf16("# 一座城市的模型\no 墙\nv 0 0 0\n", Order::Little)), kRefused);
    EXPECT_EQ(encodingTrouble(asUtf16("墙 一二三\n", Order::Big)), kRefused);
    EXPECT_EQ(encodingTrouble(asUtf32("v 0 0 0\n")), "the text is UTF-32; save it as UTF-8 or plain ASCII");
    using namespace std::string_literals;
    for (const std::string& text : {""s, "v"s, "\0"s, "v 0 0 0\n"s, "# 一座城市的模型\n"s, "g a\0b\nv 0 0 0\n"s,
                                    "\0\0\0\0\0\0\0\0"s, "\x95\\\x95\\\n"s})
        EXPECT_EQ(encodingTrouble(text), std::nullopt) << quotable(text);
}

TEST(Quotable, NamesWhatCannotBeSeen)
{
    EXPECT_EQ(quotable("a\u00A0b\u200Bc\uFEFF\u3000\u202E"), "a<U+00A0>b<U+200B>c<U+FEFF><U+3000><U+202E>");
    EXPECT_EQ(quotable("a\x1B[2Jb\n\t\u0085"), "a<U+001B>[2Jb<U+000A><U+0009><U+0085>");
    EXPECT_EQ(quotable("caf\xE9 \xA0 \xC3"), "caf<0xE9> <0xA0> <0xC3>");
    EXPECT_EQ(quotable("墙é😀"), "墙é😀");
    EXPECT_EQ(quotable("墙墙墙", 7), "墙墙...");
    EXPECT_EQ(quotable("abc", 3), "abc");
    EXPECT_EQ(printable("a\tb\x7F\u00A0"), "a\tb<U+007F>\u00A0") << "names keep their blanks";
}

}  // namespace
}  // namespace zscope
