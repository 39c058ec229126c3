// The page of a judgement: all of it is there in both languages, its pictures are those of the judgement, and no name
// of a file or a group can become anything but text.
#include <algorithm>
#include <regex>

#include "core/check/report.h"
#include "core/check/report_pictures.h"
#include "core/frame/faults.h"
#include "core/frame/renderer.h"
#include "core/io/markup.h"
#include "core/io/phrase_book.h"
#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

/// Draws a scene with a mistake and judges what was drawn.
class Report : public CheckFiles {
protected:
    check::CheckAnswer judged(const std::string& word, const std::string& preset, FaultSet faults, int width = 160,
                              int height = 120)
    {
        const auto  scene  = preparedScene(word);
        const auto  camera = cameraOf(scene->scene(), width, height);
        DrawRequest request{.scene = scene, .camera = camera, .pipeline = findPreset(preset)->pipeline, .shade = false};
        request.pipeline.fault = faults;
        Frame frame;
        EXPECT_TRUE(Renderer().draw(request, frame));
        const Picture       picture = frame.visible.picture();
        check::CheckRequest asked;
        asked.camera = camera;
        asked.ids    = writeIds("i.npy", picture.ids);
        asked.depth  = writeDepth("d.npy", picture.depth);
        auto answer  = check::Checker(scene).check(asked);
        EXPECT_TRUE(answer);
        return *std::move(answer);
    }
    static std::string pageOf(const check::CheckAnswer& answer, const std::string& command = "zscope-cli check")
    {
        const auto page = check::reportPage(answer, command);
        EXPECT_TRUE(page);
        return page ? *page : std::string();
    }
};

/// What stands between tags outside of the spans of a language.
std::vector<std::string> textsInNoLanguage(const std::string& page)
{
    static const std::regex  spans(R"re(<span class="(en|zh)"[^>]*>[^<]*</span>)re"), tags("<[^>]*>");
    const std::size_t        from = page.find("<main>"), end = page.find("<pre>");
    const std::string        body = std::regex_replace(page.substr(from, end - from), spans, "<>");
    std::vector<std::string> texts;
    for (std::sregex_token_iterator at(body.begin(), body.end(), tags, -1), last; at != last; ++at)
        texts.push_back(*at);
    return texts;
}

TEST_F(Report, SaysAllOfItInBothLanguages)
{
    for (const auto& [scene, preset, fault] : std::vector<std::tuple<std::string, std::string, FaultSet>>{
             {"builtin:city?blocks=4", "scanline", Fault::XTruncated},
             {"builtin:cubes", "zbuffer", Fault::LinearZ},
             {"builtin:cubes", "zbuffer", {}}}) {
        const check::CheckAnswer answer = judged(scene, preset, fault);
        const std::string        page   = pageOf(answer);
        EXPECT_EQ(answer.isRight(), page.find("class=\"verdict right\"") != std::string::npos);
        EXPECT_NE(page.find(markupText(answer.sentence)), std::string::npos) << answer.sentence;
        const auto chinese = chinesePhrases().text(answer.sentence);
        ASSERT_TRUE(chinese) << answer.sentence;
        EXPECT_NE(page.find(markupText(*chinese)), std::string::npos);
        for (const check::Cause& cause : answer.causes) {
            EXPECT_NE(page.find(cause.name), std::string::npos);
            EXPECT_NE(page.find(cause.lesson), std::string::npos);
        }
        if (answer.firstWrong)
            for (const PixelCover& cover : answer.firstWrong->covers)
                EXPECT_NE(page.find("<td>" + std::to_string(cover.triangle.value) + "</td>"), std::string::npos);
        // What has no translation would stand there in English alone.
        static const std::regex untranslated("[A-Z][a-z]+.*|[a-z]+ [a-z]+.*");
        for (const std::string& text : textsInNoLanguage(page))
            EXPECT_FALSE(std::regex_match(text, untranslated)) << text;
        EXPECT_EQ(page, pageOf(answer));
    }
}

TEST_F(Report, TheMapShowsEachPixelAsItWasJudged)
{
    const check::CheckAnswer    answer   = judged("builtin:city?blocks=4", "edge-walk", Fault::FirstLineRounded);
    const check::ReportPictures pictures = check::reportPictures(answer);
    ASSERT_EQ(pictures.scale, 1);
    ASSERT_EQ(pictures.pairs.size(), 2u);
    const auto count = [&](std::uint32_t colour) {
        return static_cast<std::uint64_t>(std::ranges::count(pictures.map.values(), colour));
    };
    EXPECT_GT(answer.wrong.total(), 0u);
    for (const check::Mistake mistake : check::kMistakes)
        EXPECT_EQ(count(check::kMistakeColours[static_cast<std::size_t>(mistake)]), answer.wrong.of(mistake));
    EXPECT_EQ(count(check::kRoundingColour), answer.rounding.total());
    // The two of a pair differ where surfaces differ, and nowhere else.
    const auto& [title, reference, found] = pictures.pairs.front();
    for (std::size_t i = 0; i < reference.values().size(); ++i) {
        const bool isMoved = !answer.verdicts.values()[i].isSame()
                             && answer.verdicts.values()[i].mistake() != check::Mistake::WrongDepth;
        EXPECT_EQ(reference.values()[i] != found.values()[i], isMoved) << i;
    }
}

TEST_F(Report, AWrongPixelOfALargePictureIsSeen)
{
    check::CheckAnswer answer = judged("builtin:cubes", "zbuffer", {}, 3300, 40);
    ASSERT_TRUE(answer.isRight());
    answer.verdicts.at(3001, 7)          = check::Verdict::wrong(check::Mistake::WrongDepth);
    const check::ReportPictures pictures = check::reportPictures(answer);
    EXPECT_EQ(pictures.scale, 3);
    EXPECT_EQ(pictures.map.width(), 1100);
    EXPECT_EQ(pictures.map.height(), 14);
    EXPECT_EQ(pictures.map.at(1000, 2), check::kMistakeColours[3]);
}

TEST_F(Report, NamesInFilesStayText)
{
    const std::string evil = "<script>alert(1)</script>\"'&<img/src=x/onerror=alert(2)>";
    const std::string file = "\"><svg onload=alert(3)>.obj";
    write(file, "g " + evil + "\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
    const check::CheckAnswer answer  = judged(path(file), "scanline", {});
    check::CheckAnswer       spoilt  = answer;
    const Picture&           picture = answer.truth->picture;
    const auto               at = std::ranges::find_if(picture.ids.values(), [](std::int64_t id) { return id >= 0; });
    ASSERT_NE(at, picture.ids.values().end());
    const auto index  = static_cast<int>(at - picture.ids.values().begin());
    spoilt.firstWrong = check::WrongPixel{{index % picture.ids.width(), index / picture.ids.width()},
                                          check::Mistake::Hole,
                                          {0, 0.5},
                                          {},
                                          {{TriangleId{0}, Cover::Opaque, 0.5F}}};
    spoilt.wrong.of(check::Mistake::Hole) = 1;
    const std::string page = pageOf(spoilt, "zscope-cli check '</pre><script>alert(4)</script>'\x01\xff");
    EXPECT_NE(page.find(markupText(evil)), std::string::npos) << "the group is named";
    EXPECT_NE(page.find(markupText(file)), std::string::npos) << "the file is named";
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("<img"), std::string::npos);
    EXPECT_EQ(page.find('\x01'), std::string::npos);
    EXPECT_TRUE(isUtf8(page));
    static const std::regex known(
        R"re(/?(!DOCTYPE html|html|head|meta|title|style|body|input|label|main|h1|h2|p|div|figure|figcaption|svg|image|circle|span|table|tr|th|td|ul|li|i|pre)( [^<]*)?/?)re");
    static const std::regex tag("<([^>]*)>");
    for (std::sregex_iterator each(page.begin(), page.end(), tag), end; each != end; ++each) {
        const std::string inside = (*each)[1].str().substr(0, 200);
        EXPECT_TRUE(std::regex_match(inside, known)) << inside;
        EXPECT_EQ(inside.find("onload"), std::string::npos) << inside;
        EXPECT_EQ(inside.find("onerror"), std::string::npos) << inside;
    }
}

TEST_F(Report, IsWrittenWholeOrNotAtAll)
{
    const check::CheckAnswer answer = judged("builtin:cubes", "zbuffer", {});
    const auto               done   = check::writeReport(answer, "", path("a/b"));
    ASSERT_TRUE(done);
    EXPECT_EQ(*done, path("a/b/report.html"));
    std::ifstream     written(*done, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(written)), {});
    EXPECT_EQ(text, pageOf(answer, ""));
    const auto refused = check::writeReport(answer, "", write("file", "x"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().trouble, Trouble::Output);
    std::filesystem::create_directories(path("c/report.html"));
    EXPECT_FALSE(check::writeReport(answer, "", path("c")));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("c")), {}), 1) << "something was left";
}

}  // namespace
}  // namespace zscope::tests
