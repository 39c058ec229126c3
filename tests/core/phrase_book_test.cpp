// What core says in Chinese, and text that goes into HTML and XML.
#include <gtest/gtest.h>

#include "core/io/markup.h"
#include "core/io/phrase_book.h"

namespace zscope {
namespace {

TEST(PhraseBook, PutsTemplatesTogetherInTheOrderOfTheOtherLanguage)
{
    const auto book = PhraseBook::fromJson(
        R"({"Line {1} has {a}.":"有{a}，在第{1}行。","{1} edges":"{1}条边","no edge":"没有边","File {A} is bad":"文件{A}有错","Done.":"完成。"})",
        "book");
    ASSERT_TRUE(book);
    EXPECT_EQ(book->text("Line 3 has 12 edges."), "有 12 条边，在第 3 行。");
    EXPECT_EQ(book->text("Line 3 has no edge. Done."), "有没有边，在第 3 行。完成。");
    EXPECT_EQ(book->text("File a b.obj is bad"), "文件 a b.obj 有错");
    EXPECT_EQ(book->text("Line 3 4 has no edge."), std::nullopt) << "a value holds no blank";
    EXPECT_EQ(book->text("Line 3 has a lamp."), std::nullopt) << "the phrase is not in the book";
    EXPECT_EQ(book->text("Done. Something else."), std::nullopt) << "all or nothing";
    EXPECT_EQ(book->said("Something else."), "Something else.");
    EXPECT_EQ(book->text(""), std::nullopt);
}

TEST(PhraseBook, RefusesWhatIsNoBook)
{
    for (const char* json : {"[]", "{\"a\":1}", "{", ""}) EXPECT_FALSE(PhraseBook::fromJson(json, "book")) << json;
}

TEST(PhraseBook, TheChineseOneIsInTheProgram)
{
    EXPECT_EQ(chinesePhrases().text("Nothing is wrong: the reference covers 1,234 pixels."),
              "没有错误：参考图像覆盖 1,234 个像素。");
}

TEST(Markup, TextStaysText)
{
    EXPECT_EQ(markupText("<a href='x' b=\"y\">&amp;"), "&lt;a href=&#39;x&#39; b=&quot;y&quot;&gt;&amp;amp;");
    EXPECT_EQ(markupText("面\x01\n\xff|"), "面   |");
    EXPECT_EQ(markupText("\xEF\xBF\xBF"), " ") << "U+FFFF is no character of XML";
}

TEST(Markup, Base64IsThatOfTheStandard)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string_view("\xff\xfe\x00", 3)), "//4A");
}

}  // namespace
}  // namespace zscope
