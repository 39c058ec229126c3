#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/statement_stream.h"
#include "core/scene/obj/warning_list.h"
#include "core/scene/triangulate.h"
#include "tests/core/obj_support.h"
#include "tests/core/outline_shapes.h"

namespace zscope {
namespace {

using test::kSquare;
using test::read;
using test::warningsOf;

std::string objOf(const std::vector<test::GridPoint>& corners)
{
    std::string text, face = "f";
    for (std::size_t i = 0; i < corners.size(); ++i) {
        text += fmt::format("v {} {} 0\n", corners[i].x, corners[i].y);
        face += fmt::format(" {}", i + 1);
    }
    return text + face + "\n";
}

/// The face is dropped with this warning on line 5, and the good face after it stays.
void expectDropped(const std::string& face, const std::string& sentence)
{
    const auto import = read(kSquare + face + "\nf 1 2 3\n");
    ASSERT_TRUE(import.ok()) << face;
    EXPECT_EQ(import->mesh->polygonCount(), 1u) << face;
    EXPECT_EQ(import->mesh->droppedFaces, 1u) << face;
    EXPECT_EQ(warningsOf(*import), "t.obj:5: " + sentence + "; the face is left out\n") << face;
}

void expectSquare(const std::string& text, const std::string& why)
{
    const auto import = read(text);
    ASSERT_TRUE(import.ok()) << why << ": " << import.error().text();
    EXPECT_EQ(import->mesh->triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}})) << why;
    EXPECT_EQ(import->mesh->positions[2], dvec3(1, 1, 0)) << why;
    EXPECT_EQ(warningsOf(*import), "") << why;
}

TEST(ObjFaces, AreReadInEveryForm)
{
    expectSquare(std::string(kSquare) + "f 1 2 3 4\n", "v");
    expectSquare(std::string(kSquare) + "vt 0 0\nf 1/1 2/1 3/1 4/1\n", "v/vt");
    expectSquare(std::string(kSquare) + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n", "v//vn");
    expectSquare(std::string(kSquare) + "f 1/7/9 2/7/9 3/-7/-9 4/7/9\n", "v/vt/vn, whose ranges do not matter");
    expectSquare(std::string(kSquare) + "f -4 -3 -2 -1\n", "relative");
    expectSquare(std::string(kSquare) + "  \tf\t1   2 \t3 4  \n", "blanks");
    expectSquare(std::string(kSquare) + "f 1 2 3 4", "no line end");
}

TEST(ObjFaces, WithAnUnusableCornerAreDroppedWholeWithTheirLine)
{
    expectDropped("f 1 2 99", "face refers to vertex 99 of 4");
    expectDropped("f 1 2 3 0", "face refers to vertex 0, but vertices count from 1");
    expectDropped("f -5 -6 -7", "face refers to vertex -5, counting back over 4");
    expectDropped("f 1 2 4294967297", "face refers to vertex 4294967297 of 4");
    expectDropped("f 1 2 -99999999999999999999999",
                  "face refers to vertex -99999999999999999999999, counting back over 4");
    expectDropped("f 1 2 1.5", "face has a corner '1.5' that is not a vertex index");
    expectDropped("f 1 2 x", "face has a corner 'x' that is not a vertex index");
    expectDropped("f 1/a 2 3", "face has a corner '1/a' that is not of the form v/vt/vn");
    expectDropped("f 1/1/1/1 2 3", "face has a corner '1/1/1/1' that is not of the form v/vt/vn");
    expectDropped("f /1 2 3", "face has a corner '/1' that is not a vertex index");
}

TEST(ObjFaces, WithFewerThanThreeCornersAreDropped)
{
    expectDropped("f 1 2", "face has 2 of at least 3 corners");
    expectDropped("f 1", "face has 1 of at least 3 corners");
    expectDropped("f", "face has 0 of at least 3 corners");
    expectDropped("f # 1 2 3", "face has 0 of at least 3 corners");
}

TEST(ObjFaces, MayOnlyReferToVerticesReadSoFar)
{
    const auto import = read(std::string(kSquare) + "f 1 2 5\nv 9 9 9\nf 1 2 5\nf 1 2 -1\n");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 4}, {0, 1, 4}}));
    EXPECT_EQ(warningsOf(*import),
              "t.obj:5: face refers to vertex 5, which follows further down: vertices must come first; the face is "
              "left out\n");
}

TEST(ObjFaces, BeforeAllOfTheirVerticesAreRefusedWithTheReason)
{
    const auto import = read("f 1 2 3\nf 1 2 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
    ASSERT_FALSE(import.ok());
    EXPECT_EQ(import.error().text(),
              "t.obj:1: nothing to draw: none of the 2 faces can be used (the first, line 1: face refers to vertex 1, "
              "which follows further down: vertices must come first)");
    const auto some = read("f 1 2 3\nf 4 2 1\n" + std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n"));
    ASSERT_TRUE(some.ok());
    EXPECT_EQ(
        warningsOf(*some),
        "t.obj:1: face refers to vertex 1, which follows further down: vertices must come first; the face is left "
        "out\n"
        "t.obj:2: face refers to vertex 4 of 0; the face is left out\n"
        "t.obj:7: face refers to vertex 9 of 3; the face is left out\n");
}

TEST(ObjVertices, ThatCannotBeUsedKeepTheirNumberAndTakeTheirFacesWithThem)
{
    for (const auto& [vertex, sentence] : std::vector<std::pair<std::string, std::string>>{
             {"v nan 0 0", "has a coordinate 'nan' that is not a finite number"},
             {"v 0 inf 0", "has a coordinate 'inf' that is not a finite number"},
             {"v 0 0 1e999", "has a coordinate '1e999' that is beyond the range of numbers"},
             {"v 1,5 0 0", "has a coordinate '1,5' that is not a number"},
             {"v 1.#IND 0 0", "has a coordinate '1.#IND' that is not a number"},
             {"v 0 -1.#IND00 0", "has a coordinate '-1.#IND00' that is not a number"},
             {"v 0 0 1.#QNAN# comment", "has a coordinate '1.#QNAN' that is not a number"},
             {"v 0 1.#J 0", "has a coordinate '1.#J' that is not a number"},
             {"v 0 1.# I 0", "has 2 of 3 coordinates"},
             {"v 0 0\u00A00", "has a coordinate '0<U+00A0>0' that is not a number"},
             {"v 0 0 \u200B1", "has a coordinate '<U+200B>1' that is not a number"},
             {"v 0 0 1\xA0", "has a coordinate '1<0xA0>' that is not a number"},
             {"v 0x1p3 0 0", "has a coordinate '0x1p3' that is not a number"},
             {"v 1 2", "has 2 of 3 coordinates"},
             {"v", "has 0 of 3 coordinates"}}) {
        const auto import = read(kSquare + vertex + "\nf 1 2 3\nf 1 2 5\nf 2 3 4\nv 7 7 7\nf 1 2 6\n");
        ASSERT_TRUE(import.ok()) << vertex;
        EXPECT_EQ(import->mesh->triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 2, 3}, {0, 1, 5}}))
            << vertex;
        EXPECT_EQ(import->mesh->positions[4], dvec3(0, 0, 0)) << vertex;
        EXPECT_EQ(import->counts.unusableVertices, 1u);
        EXPECT_EQ(warningsOf(*import),
                  "t.obj:5: vertex 5 " + sentence + "; faces that use it are left out\n"
                      + "t.obj:7: face uses vertex 5, which has no usable coordinates; the face is left out\n");
    }
}

TEST(ObjVertices, MayCarryAWeightOrAColour)
{
    const auto import = read("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 red\nf 1 2 3\n");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(warningsOf(*import), "t.obj:3: 'red' after the coordinates of vertex 3 is ignored\n");
}

TEST(ObjLines, EndInEveryWayAndJoinAtABackslash)
{
    const std::string text = std::string(kSquare) + "f 1 2 3 4\n";
    const auto        with = [&](const std::string& end) {
        std::string other;
        for (const char c : text) c == '\n' ? other += end : other += c;
        return other;
    };
    expectSquare(with("\r\n"), "CR LF");
    expectSquare(with("\r"), "lone CR");
    expectSquare(with("\n\r\n"), "blank lines between");
    expectSquare("\xEF\xBB\xBF" + text, "byte order mark");
    expectSquare(std::string(kSquare) + "f 1 2 \\\n3 \\\r\n4\n", "backslash");
    expectSquare(std::string(kSquare) + "f 1 2\\\n3\\\n4\\", "backslash without a blank, and at the end of the file");
    expectSquare(std::string(kSquare) + "f 1 2 \\ \n3 \\\t\v\f\r\n4\n", "blanks after a backslash");
    expectSquare("v 0 0\f0\nv 1\v0 0\n\fv\t1 1 0\nv 0 1 0\v\nf\f1\v2\f3 4\n", "form feed and vertical tab");
    expectSquare(std::string(kSquare) + "\xEF\xBB\xBF" + "f 1 2 \\\n\xEF\xBB\xBF\xEF\xBB\xBF" + "3 4\n",
                 "byte order marks at the start of later lines");
    expectSquare("v 0 0 0 # first\n#\n# C:\\models\\\nv 1 0 0\nv 1 1 0# third\nv 0 1 0\nf 1 2 3 4#\\\n",
                 "comments, in which a backslash joins nothing");
}

TEST(ObjLines, AreCountedAsTheyStandInTheFile)
{
    const auto import =
        read("\r\n# a\r\n" + std::string(kSquare) + "f 1 \\\n 2 \\\n 3\n\nf 1 2 9\nf 1 2 \\\n 8\nf 1 2 7\n");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(warningsOf(*import),
              "t.obj:11: face refers to vertex 9 of 4; the face is left out\n"
              "t.obj:12: face refers to vertex 8 of 4; the face is left out\n"
              "t.obj:14: face refers to vertex 7 of 4; the face is left out\n");
}

TEST(ObjLines, AreReadTheSameWhateverTheyEndWith)
{
    std::string lf, cr, both;
    for (int i = 0; i < 3000; ++i) {
        const std::string line = i % 3 == 2 ? "f -1 -2 -999999" : fmt::format("v {} 0 {}", i, i * i);
        lf += line + "\n";
        cr += line + "\r";
        both += line + "\r\n";
    }
    const std::string last  = "f 1 2 3";
    const auto        first = read(lf + last), second = read(cr + last), third = read(both + last);
    ASSERT_TRUE(first.ok() && second.ok() && third.ok());
    EXPECT_EQ(warningsOf(*first), warningsOf(*second));
    EXPECT_EQ(warningsOf(*first), warningsOf(*third));
    EXPECT_EQ(first->mesh->positions, second->mesh->positions);
    EXPECT_EQ(first->mesh->positions, third->mesh->positions);
}

TEST(ObjLines, WithZeroBytesAreJudgedLikeAnyOtherText)
{
    using namespace std::string_literals;
    const auto import = read(kSquare + "f 1 2 3\0\nf 1 2 4\ng a\0b\nf 1 2 3\n\0\0\0\n"s);
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->polygonCount(), 2u);
    EXPECT_EQ(import->mesh->groups.back(), "a<U+0000>b");
    EXPECT_EQ(warningsOf(*import),
              "t.obj:5: face has a corner '3<U+0000>' that is not a vertex index; the face is left out\n"
              "t.obj:9: statement '<U+0000><U+0000><U+0000>' skipped, 1 in all\n");
}

TEST(ObjLines, LongerThanTheLimitAreRefused)
{
    std::string text(kSquare);
    text += "f 1 2 3\n# ";
    const auto comment = text + std::string(obj::kMaxLineBytes + 1, 'x');
    const auto import  = read(comment);
    ASSERT_FALSE(import.ok());
    EXPECT_EQ(import.error().kind, Trouble::Limit);
    EXPECT_EQ(import.error().text(), "t.obj:6: the line is longer than 64 MiB");
}

TEST(ObjStatements, ThatAreUnknownAreSkippedAndCountedByKind)
{
    std::string text =
        std::string(kSquare) + "vp 1 2\nl 1 2\nl 2 3\ns 1\nvn 0 0 1\nvt 0 0\nf 1 2 3\ncurv2 1\nl 3 4\n\x01\x02 weird\n";
    const auto import = read(text);
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->counts.skippedStatements, 6u);
    EXPECT_EQ(warningsOf(*import),
              "t.obj:5: statement 'vp' skipped, 1 in all\n"
              "t.obj:6: statement 'l' skipped, 3 in all\n"
              "t.obj:12: statement 'curv2' skipped, 1 in all\n"
              "t.obj:14: statement '<U+0001><U+0002>' skipped, 1 in all\n");
}

TEST(ObjStatements, OfAThousandUnknownKindsEndInAFewWarnings)
{
    std::string text = std::string(kSquare) + "f 1 2 3\n";
    for (int i = 0; i < 1000; ++i) text += fmt::format("kind{} 1\n", i);
    const auto import = read(text);
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->counts.skippedStatements, 1000u);
    EXPECT_EQ(import->warnings.size(), obj::kMaxSkippedKinds + 1);
}

TEST(ObjWarnings, AreCappedAndTheRestCounted)
{
    std::string text(kSquare);
    for (int i = 0; i < 1000; ++i) text += "f 1 2 99\n";
    const auto import = read(text + "f 1 2 3\nl 1 2\n");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->counts.droppedFaces, 1000u);
    ASSERT_EQ(import->warnings.size(), obj::kMaxWarnings + 2);
    EXPECT_EQ(import->warnings[obj::kMaxWarnings - 1].line, 104);
    EXPECT_EQ(import->warnings[obj::kMaxWarnings].sentence, "statement 'l' skipped, 1 in all");
    EXPECT_EQ(import->warnings.back().sentence, "and 900 more warnings");
}

TEST(ObjGroups, ObjectsAndMaterialsAreKept)
{
    const auto import = read(std::string(kSquare) + "f 1 2 3\no car\ng wheel\nusemtl red #1\nf 1 2 3\ng\nusemtl\nf 1 2 4\n"
                                                    "g door  left\nusemtl blue#2 # note\nf 1 2 4\no\ng wheel\nf 1 2 4\n");
    ASSERT_TRUE(import.ok()) << import.error().text();
    const Mesh& mesh = *import->mesh;
    EXPECT_EQ(mesh.groups, (std::vector<std::string>{"default", "car/wheel", "car", "car/door left", "wheel"}));
    EXPECT_EQ(mesh.polygonGroup, (std::vector<GroupId>{{0}, {1}, {2}, {3}, {4}}));
    ASSERT_EQ(mesh.materials.size(), 3u);
    EXPECT_EQ(mesh.materials[1].name, "red #1");
    EXPECT_EQ(mesh.materials[2].name, "blue#2 # note") << "nothing says that the rest is a comment";
    EXPECT_EQ(mesh.polygonMaterial, (std::vector<MaterialId>{{0}, {1}, {0}, {2}, {2}}));
    EXPECT_EQ(import->counts.groupNames, 2u);
    EXPECT_EQ(import->counts.objectNames, 1u);
}

TEST(ObjPolygons, RingOfSixtySixCornersWithABridgeIsCutIntoEars)
{
    const auto polygon = test::bridgedRing(32, 1'000'000, 500'000);
    ASSERT_EQ(polygon.corners.size(), 66u);
    const auto import = read(objOf(polygon.corners));
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->triangles.size(), 64u);
    EXPECT_EQ(warningsOf(*import), "");
    double     area = 0, expected = 0;
    const auto cross = [&](std::uint32_t a, std::uint32_t b) {
        const dvec3 &p = import->mesh->positions[a], &q = import->mesh->positions[b];
        return p.x * q.y - p.y * q.x;
    };
    for (const auto& t : import->mesh->triangles) {
        const double twice = cross(t[0], t[1]) + cross(t[1], t[2]) + cross(t[2], t[0]);
        EXPECT_GE(twice, 0);
        area += twice;
    }
    for (std::uint32_t i = 0; i < 66; ++i) expected += cross(i, (i + 1) % 66);
    EXPECT_EQ(area, expected) << "all below 2^53, so exact";
}

TEST(ObjPolygons, FaceOfThreeHundredCornersIsReadWhole)
{
    const auto import = read(objOf(test::star(150, 1'000'000, 700'000).corners));
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->corners.size(), 300u);
    EXPECT_EQ(import->mesh->triangles.size(), 298u);
    EXPECT_EQ(import->mesh->splitFaces, 1u);
}

TEST(ObjPolygons, ConvexFaceOfAHundredThousandCornersIsAFan)
{
    std::string text, face = "f";
    for (int i = 0; i < 100'000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 100'000;
        text += fmt::format("v {} {} 0\n", 1e6 * std::cos(angle), 1e6 * std::sin(angle));
        face += fmt::format(" {}", i + 1);
    }
    const auto start  = std::chrono::steady_clock::now();
    const auto import = read(text + face + "\n");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    ASSERT_TRUE(import.ok());
    ASSERT_EQ(import->mesh->triangles.size(), 99'998u);
    EXPECT_EQ(import->mesh->triangles.back(), (std::array<std::uint32_t, 3>{0, 99'998, 99'999}));
    EXPECT_EQ(warningsOf(*import), "");
}

TEST(ObjPolygons, BeyondTheConcaveLimitAreDroppedAndTheLimitSaid)
{
    const auto polygon = test::comb(static_cast<int>(kMaxConcaveCorners) / 4, 1000);
    const auto import  = read(objOf(polygon.corners) + "f 1 2 3\n");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->polygonCount(), 1u);
    EXPECT_EQ(import->mesh->droppedFaces, 1u);
    EXPECT_NE(warningsOf(*import).find("face is concave and has 20002 corners, and at most 20000 are split"),
              std::string::npos);
}

TEST(ObjPolygons, ThatCrossThemselvesAreReported)
{
    const auto import = read(std::string(kSquare) + "f 1 3 2 4\n");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 2, 1}, {0, 1, 3}}));
    EXPECT_EQ(warningsOf(*import),
              "t.obj:5: face has no area or crosses itself; it is drawn as a fan from its first corner\n");
    EXPECT_EQ(import->counts.mendedFaces, 1u);
}

TEST(ObjTriangles, OfNoAreaKeepTheirPlace)
{
    const auto import = read(std::string(kSquare) + "f 1 1 2\nf 1 2 3\n");
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->mesh->triangles.size(), 2u);
    EXPECT_EQ(warningsOf(*import), "");
}

TEST(ObjNothing, ToDrawIsOneClearError)
{
    const auto sentence = [](std::string_view text) {
        const auto import = read(text);
        EXPECT_FALSE(import.ok());
        if (import.ok()) return std::string();
        EXPECT_EQ(import.error().kind, Trouble::Input);
        return import.error().text();
    };
    EXPECT_EQ(sentence(""), "t.obj: the file is empty");
    EXPECT_EQ(sentence("\n\n# nothing\n"),
              "t.obj: nothing to draw: the file holds no vertices and no faces; is it an OBJ file?");
    EXPECT_EQ(sentence("v 1 2 3\nv 4 5 6\n"), "t.obj: nothing to draw: the file holds 2 vertices but no faces");
    EXPECT_EQ(
        sentence("v 1 2 3\nf 1 2 3\nf 4 5 6\n"),
        "t.obj:2: nothing to draw: none of the 2 faces can be used (the first, line 2: face refers to vertex 2 of 1)");
}

TEST(ObjEncoding, Utf16IsRefusedWithASentence)
{
    using namespace std::string_literals;
    for (const std::string& text :
         {"\xFF\xFEv\0 \0"s, "\x21\x6A\x8B\x57\n\0v\0 \0"s, "\xFE\xFF\0v\0 "s, "v\0 \0"s + "1\0"s,
          "\0v\0 \0"
          "1"s}) {
        const auto import = read(text);
        ASSERT_FALSE(import.ok());
        EXPECT_EQ(import.error().text(), "t.obj: the text is UTF-16; save it as UTF-8 or plain ASCII");
    }
}

TEST(ObjProgress, IsReportedAndCancelIsHonoured)
{
    std::string text(kSquare);
    for (int i = 0; i < 20'000; ++i) text += "f 1 2 3\n";
    std::vector<double> fractions;
    ObjOptions          options;
    options.progress.report = [&](double fraction, std::string_view) { fractions.push_back(fraction); };
    ASSERT_TRUE(importObjText(text, "t.obj", "", options).ok());
    EXPECT_GE(fractions.size(), 5u);
    EXPECT_TRUE(std::ranges::is_sorted(fractions));
    EXPECT_EQ(fractions.back(), 1.0);

    std::atomic<bool> cancel = false;
    int               calls  = 0;
    options.progress.cancel  = &cancel;
    options.progress.report  = [&](double, std::string_view) { cancel = ++calls == 3; };
    const auto stopped       = importObjText(text, "t.obj", "", options);
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().kind, Trouble::Cancelled);
    EXPECT_EQ(calls, 3) << "nothing is read once somebody asked to stop";
}

TEST(ObjMemory, BeyondTheLimitEndsWithTroubleLimit)
{
    std::string text(kSquare);
    for (int i = 0; i < 20'000; ++i) text += "v 1 2 3\nf 1 2 3\n";
    for (const std::uint64_t limit : {text.size() + 1000, text.size() + 100'000, text.size() + 500'000}) {
        const auto import = importObjText(text, "t.obj", "", {.memoryLimit = limit});
        ASSERT_FALSE(import.ok()) << limit;
        EXPECT_EQ(import.error().kind, Trouble::Limit);
        EXPECT_GT(import.error().line, 4);
    }
    EXPECT_TRUE(importObjText(text, "t.obj", "", {.memoryLimit = text.size() + 8'000'000}).ok());
    std::string names(kSquare);
    for (int i = 0; i < 10'000; ++i) names += fmt::format("g group{}\nusemtl material{}\nf 1 2 3\n", i, i);
    const auto import = importObjText(names, "t.obj", "", {.memoryLimit = names.size() + 1'000'000});
    ASSERT_FALSE(import.ok()) << "names take memory too";
    EXPECT_EQ(import.error().kind, Trouble::Limit);
}

}  // namespace
}  // namespace zscope
