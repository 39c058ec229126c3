// Names of materials, groups and libraries, as programs write them: with a number sign, in quotes, in other code pages,
// with the path of another machine.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/scene/load.h"
#include "core/scene/obj/library_names.h"
#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/names.h"
#include "tests/core/obj_support.h"

namespace zscope {
namespace {

using test::kSquare;
using test::TemporaryFolder;
using test::warningsOf;

constexpr Rgb kRed{1, 0, 0}, kGreen{0, 1, 0};

/// A library of two materials, and a square that uses two; what colours its two faces have.
class Materials {
public:
    Result<ObjImport> read(const std::string& first, const std::string& second, const std::string& usesFirst,
                           const std::string& usesSecond) const
    {
        m_folder.write("m.mtl", "newmtl " + first + "\nKd 1 0 0\nnewmtl " + second + "\nKd 0 1 0\n");
        return importObj(m_folder.write("a.obj", "mtllib m.mtl\n" + std::string(kSquare) + "usemtl " + usesFirst
                                                     + "\nf 1 2 3\nusemtl " + usesSecond + "\nf 1 3 4\n"));
    }
    void expectRedAndGreen(const std::string& first, const std::string& second, const std::string& usesFirst,
                           const std::string& usesSecond) const
    {
        const auto import = read(first, second, usesFirst, usesSecond);
        ASSERT_TRUE(import.ok()) << import.error().text();
        EXPECT_EQ(import->mesh->materialOf(PolygonId{0}).diffuse, kRed) << usesFirst;
        EXPECT_EQ(import->mesh->materialOf(PolygonId{1}).diffuse, kGreen) << usesSecond;
        EXPECT_EQ(warningsOf(*import), "") << usesFirst;
        EXPECT_EQ(import->counts.materialNames, 2u) << usesFirst;
    }
    void expectRedAndGreen(const std::string& first, const std::string& second) const
    {
        expectRedAndGreen(first, second, first, second);
    }

private:
    TemporaryFolder m_folder;
};

TEST(ObjNames, KeepTheirNumberSign)
{
    const Materials all;
    all.expectRedAndGreen("Gloss Grey #1", "Gloss Grey #2");
    all.expectRedAndGreen("Gloss Grey # 1", "Gloss Grey # 2");
    all.expectRedAndGreen("Grey\t#1", "Grey\t#2");
    all.expectRedAndGreen("#ff0000", "#00ff00");
    all.expectRedAndGreen("# one", "# two");
    all.expectRedAndGreen("a#1", "a#2");
    all.expectRedAndGreen("a # b #1", "a # b #2");
    all.expectRedAndGreen("a #", "a");
}

TEST(ObjNames, AreReadWithoutACommentWhereThatNamesAMaterial)
{
    const Materials all;
    all.expectRedAndGreen("red", "green", "red # as a brick", "green #second");
    all.expectRedAndGreen("red # a brick", "green", "red", "green");
    all.expectRedAndGreen("red # a brick", "green # grass", "red # of the wall", "green # of the lawn");
    all.expectRedAndGreen("red #1", "red", "red #1 # note", "red # note");
    all.expectRedAndGreen("red #1", "red #2", "red #1 # note", "red #2\t# note");
}

TEST(ObjNames, AreNotTakenForOthersWithAnotherNumber)
{
    const Materials all;
    const auto      import = all.read("Grey #1", "Grey #2", "Grey #3", "Grey");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->materialOf(PolygonId{0}).diffuse, Material{}.diffuse);
    EXPECT_EQ(import->mesh->materialOf(PolygonId{1}).diffuse, Material{}.diffuse);
    EXPECT_EQ(import->warnings.size(), 2u);
    EXPECT_EQ(import->warnings[0].sentence, "material 'Grey #3' is in no material library; it has the standard colour");
}

TEST(ObjNames, ThatMeanTheSameMaterialAreOne)
{
    const Materials all;
    const auto      import = all.read("red", "green", "red # left", "red # right");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->materials.size(), 2u);
    EXPECT_EQ(import->mesh->materials[1].name, "red");
    EXPECT_EQ(import->mesh->polygonMaterial, (std::vector<MaterialId>{{1}, {1}}));
}

TEST(ObjNames, OfGroupsAndObjectsGoToTheEndOfTheLine)
{
    const auto import = test::read(kSquare
                                   + std::string("g Wheel #1\nf 1 2 3\ng Wheel #2\nf 1 2 3\no #3\nf 1 2 3\ng\no a # b\n"
                                                 "f 1 2 3\n"));
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->groups,
              (std::vector<std::string>{"default", "Wheel #1", "Wheel #2", "#3/Wheel #2", "a # b"}));
}

TEST(ObjNames, ThatDifferFarBehindOrInControlCharactersStayDifferent)
{
    const Materials   all;
    const std::string longName(3000, 'x'), longChinese = [] {
        std::string name;
        for (int i = 0; i < 1000; ++i) name += "墙";
        return name;
    }();
    all.expectRedAndGreen(longName + "1", longName + "2");
    all.expectRedAndGreen(longName + " #1", longName + " #2");
    all.expectRedAndGreen("1" + longChinese, "1" + longChinese + "2");
    all.expectRedAndGreen("a\x01", "a\x02");
    all.expectRedAndGreen(std::string("a\x7F") + "b", std::string("a\0b", 3));
    EXPECT_LE(obj::printableName(longChinese + "1").size(), obj::kMaxNameBytes);
    EXPECT_EQ(obj::printableName(" a\x01 "), "a<U+0001>");
    EXPECT_EQ(obj::printableName(std::string(obj::kMaxNameBytes, 'x')), std::string(obj::kMaxNameBytes, 'x'));
}

TEST(ObjNames, OfSceneFilesFollowTheSameRules)
{
    const TemporaryFolder folder;
    folder.write("a.obj", kSquare
                              + std::string("usemtl Grey #1\nf 1 2 3\nusemtl Grey #2\nf 1 3 4\nusemtl red # a brick\n"
                                            "f 1 2 4\nusemtl c\x01\nf 2 3 4\n"));
    const auto scene = loadScene(folder.write("s.json", R"({"meshes": {"a": {"obj": "a.obj"}},
        "instances": [{"mesh": "a"}, {"mesh": "a", "material": "Grey #2"}],
        "materials": {"Grey #1": {"colour": [1, 0, 0]}, "Grey #2": {"colour": [0, 1, 0]},
                      "red": {"colour": [0, 0, 1]}, "c\u0001": {"colour": [0, 1, 1]}}})"));
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    const auto colour = [&](std::uint32_t polygon) { return scene->meshes[0]->materialOf(PolygonId{polygon}).diffuse; };
    EXPECT_EQ(colour(0), kRed);
    EXPECT_EQ(colour(1), kGreen);
    EXPECT_EQ(colour(2), (Rgb{0, 0, 1}));
    EXPECT_EQ(colour(3), (Rgb{0, 1, 1}));
    EXPECT_EQ(scene->instances[1].colour, kGreen);
    const auto twice = loadScene(folder.write("t.json", R"({"meshes": {"a": {"obj": "a.obj"}}, "instances": [],
        "materials": {"a": {"colour": [1, 0, 0]}, " a": {"colour": [0, 1, 0]}}})"));
    ASSERT_FALSE(twice.ok());
    EXPECT_EQ(twice.error().sentence, "the material ' a' is given twice");
}

TEST(ObjNames, KeepASecondByteThatIsABackslash)
{
    const Materials all;
    all.expectRedAndGreen("\x95\\", "green");         // Shift-JIS
    all.expectRedAndGreen("\xB1\x95\\ \t", "green");  // with a half-width letter before, and blanks behind
    all.expectRedAndGreen("x \x81\\", "\x8B\\");      // GBK
    all.expectRedAndGreen("\x95\\\x95\\", "\x95\\ 2");
    const auto import = test::read(kSquare + std::string("g \x95\\\nf 1 2 3\no \x95\\\nf 1 3 4\n# \x95\\\nf 1 2 4\n"));
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->polygonCount(), 3u);
    EXPECT_EQ(warningsOf(*import), "");
}

TEST(ObjNames, ThatABackslashJoinsWithTheNextLineAreReported)
{
    for (const std::string word : {"usemtl", "g", "o"})
        for (const std::string name : {"a", "墙"}) {
            const auto import = test::read(kSquare + ("f 1 2 3\n" + word + ' ' + name) + "\\\nf 1 3 4\nf 1 3 4\n");
            ASSERT_TRUE(import.ok());
            EXPECT_EQ(import->mesh->polygonCount(), 2u);
            ASSERT_FALSE(import->warnings.empty());
            EXPECT_EQ(import->warnings[0].line, 6);
            EXPECT_EQ(import->warnings[0].sentence,
                      word + ": the backslash at the end of the line joins the next line to the name");
        }
    const TemporaryFolder folder;
    folder.write("m.mtl", "newmtl a\\\nKd 1 0 0\n");
    const auto import = importObj(folder.write("a.obj", "mtllib m.mtl\n" + std::string(kSquare) + "f 1 2 3\n"));
    ASSERT_TRUE(import.ok());
    ASSERT_EQ(import->warnings.size(), 1u);
    EXPECT_EQ(import->warnings[0].sentence,
              "newmtl: the backslash at the end of the line joins the next line to the name");
}

/// A folder with libraries, each with the material "m" in a colour of its own, and one that is not in it.
class LibraryNames : public testing::Test {
protected:
    LibraryNames()
    {
        for (const char* name : {"in/a.mtl", "in/b.mtl", "in/my mats.mtl", "in/mats #1.mtl", "in/sub/c.mtl",
                                 "in/'odd'.mtl", "in/\x95\\.mtl", "secret.mtl"})
            m_folder.write(name, "newmtl m\nKd 1 0 0\n");
    }
    /// The names of the files found and the warnings, one per line.
    std::string found(const std::string& names) const
    {
        const std::filesystem::path root = std::filesystem::canonical(m_folder / "in");
        std::string                 all;
        for (const obj::LibraryName& one : obj::librariesNamed(root, names)) {
            if (!one.path.empty()) all += std::filesystem::path(one.path).lexically_relative(root).string() + "\n";
            if (!one.warning.empty()) all += "! " + one.warning + "\n";
        }
        return all;
    }

    TemporaryFolder m_folder;
};

TEST_F(LibraryNames, MayStandInQuotesHaveBlanksAndBeSeveral)
{
    EXPECT_EQ(found("a.mtl"), "a.mtl\n");
    EXPECT_EQ(found("\"a.mtl\""), "a.mtl\n");
    EXPECT_EQ(found("'a.mtl'"), "a.mtl\n");
    EXPECT_EQ(found("\"my mats.mtl\""), "my mats.mtl\n");
    EXPECT_EQ(found("my mats.mtl"), "my mats.mtl\n");
    EXPECT_EQ(found("a.mtl b.mtl"), "a.mtl\nb.mtl\n");
    EXPECT_EQ(found("a.mtl my mats.mtl\tsub\\c.mtl"), "a.mtl\nmy mats.mtl\nsub/c.mtl\n");
    EXPECT_EQ(found("\"my mats.mtl\" 'a.mtl' b.mtl"), "my mats.mtl\na.mtl\nb.mtl\n");
    EXPECT_EQ(found("'odd'.mtl"), "'odd'.mtl\n");
    EXPECT_EQ(found("\x95\\.mtl"), "\x95\\.mtl\n") << "the second byte of a character, not a folder's end";
}

TEST_F(LibraryNames, MayHaveANumberSignOrACommentBehind)
{
    EXPECT_EQ(found("mats #1.mtl"), "mats #1.mtl\n");
    EXPECT_EQ(found("a.mtl mats #1.mtl"), "a.mtl\nmats #1.mtl\n");
    EXPECT_EQ(found("a.mtl # colours"), "a.mtl\n");
    EXPECT_EQ(found("mats #1.mtl # colours"), "mats #1.mtl\n");
    EXPECT_EQ(found("\"my mats.mtl\" a.mtl #both"), "my mats.mtl\na.mtl\n");
    EXPECT_EQ(found("a.mtl # b.mtl"), "a.mtl\n") << "a comment that names a file stays a comment";
}

TEST_F(LibraryNames, ThatAreMissingAreNamedWhole)
{
    const std::string missing = "' cannot be opened: No such file or directory\n";
    EXPECT_EQ(found("gone.mtl"), "! 'gone.mtl" + missing);
    EXPECT_EQ(found("my gone.mtl"), "! 'my gone.mtl" + missing);
    EXPECT_EQ(found("\"my gone.mtl\" a.mtl"), "! 'my gone.mtl" + missing + "a.mtl\n");
    EXPECT_EQ(found("gone.mtl a.mtl lost.mtl"), "! 'gone.mtl" + missing + "a.mtl\n! 'lost.mtl" + missing);
    EXPECT_EQ(found("gone.mtl # note"), "! 'gone.mtl" + missing);
    EXPECT_EQ(found("gone #1.mtl"), "! 'gone #1.mtl" + missing);
}

TEST_F(LibraryNames, InOtherLettersAreNotTakenButNamed)
{
    const std::string missing = "cannot be opened: No such file or directory; '";
    EXPECT_EQ(found("A.MTL"), "! 'A.MTL' " + missing + "a.mtl' would fit, but for the case of its letters\n");
    EXPECT_EQ(found("Sub\\C.mtl"),
              "! 'Sub\\C.mtl' " + missing + "sub/c.mtl' would fit, but for the case of its letters\n");
    EXPECT_EQ(found("C:\\x\\A.mtl"), "! the path 'C:\\x\\A.mtl' is absolute, and beside this file: 'A.mtl' " + missing
                                         + "a.mtl' would fit, but for the case of its letters\n");
    std::filesystem::create_directory_symlink(m_folder / ".", m_folder / "in/up");
    EXPECT_EQ(found("up/Secret.mtl"), "! 'up/Secret.mtl' cannot be opened: No such file or directory\n")
        << "nothing is said about what lies outside";
}

TEST_F(LibraryNames, WithAnAbsolutePathAreTakenFromBesideTheFile)
{
    for (const std::string path : {"C:\\Users\\x\\a.mtl", "D:/models/a.mtl", "/home/x/a.mtl", "\\\\server\\y\\a.mtl",
                                   "c:a.mtl", "/home/my models/a.mtl"})
        for (const std::string& written : {path, '"' + path + '"', path + " # by hand"})
            EXPECT_EQ(found(written),
                      "a.mtl\n! the path '" + path + "' is absolute; 'a.mtl' beside this file is read instead\n")
                << written;
    EXPECT_EQ(found("C:\\x\\a.mtl D:\\y\\b.mtl"),
              "a.mtl\n! the path 'C:\\x\\a.mtl' is absolute; 'a.mtl' beside this file is read instead\n"
              "b.mtl\n! the path 'D:\\y\\b.mtl' is absolute; 'b.mtl' beside this file is read instead\n");
    EXPECT_EQ(found(m_folder / "secret.mtl"), "! the path '" + m_folder / "secret.mtl"
                                                  + "' is absolute, and beside this file: 'secret.mtl' cannot be "
                                                    "opened: No such file or directory\n");
}

TEST_F(LibraryNames, AreLookedForInBoundedTime)
{
    std::string many;
    for (int i = 0; i < 100'000; ++i) many += "x #";
    EXPECT_FALSE(found(many).empty());
    EXPECT_EQ(obj::readingsOf(many).size(), 8u);
}

TEST(MaterialWords, MayBeWrittenInCapitalsAndHaveACommentBehindANumber)
{
    const TemporaryFolder folder;
    folder.write("m.mtl",
                 "NEWMTL a\nkd 1 0 0# red\nD 0.5#half\nNewMtl b\nKD 0 1 0#green\ntr 0.25# a quarter\n"
                 "MAP_KD a.png\nmap_bump b.png\nKd 1.#IND 0 0\n");
    const auto import = importObj(
        folder.write("a.obj", "mtllib m.mtl\n" + std::string(kSquare) + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n"));
    ASSERT_TRUE(import.ok()) << import.error().text();
    const Material a = import->mesh->materialOf(PolygonId{0}), b = import->mesh->materialOf(PolygonId{1});
    EXPECT_EQ(a.diffuse, kRed);
    EXPECT_EQ(a.opacity, 0.5f);
    EXPECT_EQ(b.diffuse, kGreen);
    EXPECT_EQ(b.opacity, 0.75f);
    ASSERT_EQ(import->warnings.size(), 2u) << "textures are told of once";
    EXPECT_EQ(import->warnings[0].line, 7);
    EXPECT_EQ(import->warnings[0].sentence, "textures ('MAP_KD') are not read; materials have the colour of Kd");
    EXPECT_EQ(import->warnings[1].sentence, "Kd: '1.#IND' is not a number; the statement is left out");
}

TEST(SceneFilePaths, AreReadInLettersOfEitherCaseAndWithBackslashes)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.Obj", "sub/b.obj"}) folder.write(name, std::string(kSquare) + "f 1 2 3\n");
    const auto scene = [&](const std::string& path) {
        return loadScene(
            folder.write("s.json", R"({"meshes": {"a": {"obj": ")" + path + R"("}}, "instances": [{"mesh": "a"}]})"));
    };
    EXPECT_TRUE(scene("a.Obj").ok());
    EXPECT_TRUE(scene("sub\\\\b.obj").ok());
    EXPECT_TRUE(scene(".\\\\sub\\\\b.obj").ok());
    EXPECT_TRUE(loadScene(folder / "sub\\b.obj").ok());
    EXPECT_EQ(scene("A.obj").error().sentence,
              "'A.obj' cannot be opened: No such file or directory; 'a.Obj' would fit, "
              "but for the case of its letters");
    EXPECT_NE(scene("..\\\\b.obj").error().sentence.find("leads out of the folder"), std::string::npos);
    EXPECT_NE(scene("sub\\\\..\\\\..\\\\b.obj").error().sentence.find("leads out"), std::string::npos);
    EXPECT_NE(scene("C:\\\\sub\\\\b.obj").error().sentence.find("is absolute"), std::string::npos);
}

}  // namespace
}  // namespace zscope
