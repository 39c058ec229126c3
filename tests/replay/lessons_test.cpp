// Lessons: every bundled one is read, run and asked; broken files say where; the documentation is complete.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "core/lesson/lesson_facts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_run.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

namespace fs            = std::filesystem;
const fs::path kRoot    = ZSCOPE_SOURCE_DIR;
const fs::path kLessons = kRoot / "resources/lessons";

std::string textOf(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::vector<fs::path> lessonFiles()
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kLessons))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

DrawRequest requestOf(const LessonPage& page)
{
    static std::map<std::string, std::shared_ptr<const PreparedScene>> loaded;
    auto&                                                              prepared = loaded[page.scene];
    if (!prepared) {
        auto scene = loadScene(page.scene);
        EXPECT_TRUE(scene) << page.scene;
        prepared = std::make_shared<PreparedScene>(std::make_shared<const Scene>(std::move(*scene)));
    }
    const ViewRequest view   = viewOfPage(page, prepared->scene());
    const auto        camera = makeCamera(view, prepared->scene().bounds);
    EXPECT_TRUE(camera);
    return {.scene       = prepared,
            .camera      = *camera,
            .faceCulling = view.faceCulling.value_or(FaceCulling::None),
            .pipeline    = page.pipeline,
            .threads     = 1};
}

void expectBoth(const LessonText& text, const std::string& where)
{
    EXPECT_FALSE(text.english.empty()) << where;
    EXPECT_FALSE(text.chinese.empty()) << where;
}

TEST(BundledLessons, AreAtLeastFifteenInBothLanguagesWithTwoQuestionsEach)
{
    const auto files = lessonFiles();
    ASSERT_GE(files.size(), 15u);
    for (const fs::path& file : files) {
        const auto lesson = readLesson(file.string());
        ASSERT_TRUE(lesson) << lesson.error().text();
        const std::string where = file.filename().string();
        expectBoth(lesson->title, where);
        int questions = 0;
        for (const LessonPage& page : lesson->pages) {
            expectBoth(page.text, where);
            if (!page.question) continue;
            ++questions;
            expectBoth(page.question->ask, where);
            expectBoth(page.question->why, where);
            std::set<std::string> texts;
            for (const LessonChoice& choice : page.question->choices) {
                expectBoth(choice.text, where);
                EXPECT_TRUE(texts.insert(choice.text.english).second) << where << ": " << choice.text.english;
            }
        }
        EXPECT_GE(questions, 2) << where;
    }
}

TEST(BundledLessons, EveryPageComesToItsStopAndEveryQuestionHasOneRightAnswerThatIsTrueOfTheState)
{
    int asked = 0;
    for (const fs::path& file : lessonFiles()) {
        const auto lesson = readLesson(file.string());
        ASSERT_TRUE(lesson);
        for (const LessonPage& page : lesson->pages) {
            const DrawRequest request = requestOf(page);
            const auto        run     = runPage(page, lesson->file, request);
            ASSERT_TRUE(run) << run.error().text();
            Replay     replay(request);
            const auto count = replay.count(run->grain);
            ASSERT_TRUE(count);
            EXPECT_LT(run->step.value, *count);
            if (!page.question) continue;
            ++asked;
            const std::string   where  = file.filename().string() + ":" + std::to_string(page.question->fileLine);
            const LessonAnswer& answer = *run->answer;
            if (page.question->kind == LessonQuestion::Kind::Pixel) {
                ASSERT_TRUE(page.pick || answer.pixels.width() > 0) << where;
                EXPECT_FALSE(page.pick && answer.acceptsPixel(*page.pick))
                    << where << ": the marked pixel is the answer";
                continue;
            }
            EXPECT_EQ(answer.choice.has_value(), page.question->kind == LessonQuestion::Kind::Choice) << where;
            EXPECT_EQ(answer.number.has_value(), page.question->kind == LessonQuestion::Kind::Number) << where;
            if (page.question->fact.empty() || page.question->at != LessonQuestion::At::Stop) continue;
            // The same fact from a state that was made here.
            const auto state = replay.at(run->grain, run->step);
            ASSERT_TRUE(state);
            const auto value = factOf(page.question->fact, {*state, request, page.pick});
            ASSERT_TRUE(value) << where << ": " << value.error().text();
            if (answer.number) {
                EXPECT_EQ(std::get<double>(*value), *answer.number) << where;
                continue;
            }
            for (std::size_t i = 0; i < page.question->choices.size(); ++i)
                EXPECT_EQ(page.question->choices[i].when->holds(*value), i == *answer.choice)
                    << where << " choice " << i + 1;
        }
    }
    EXPECT_GE(asked, 30);
}

// Files ---------------------------------------------------------------------------------------------------------------

const std::string kHead = "=== lesson\n{\"title\": \"t\"}\n";  // lines 1, 2
const std::string kPage =
    "=== page\n{\"scene\": \"builtin:cube\", \"algorithm\": \"scanline\", \"size\": [64, 36], \"stop\": STOP}\n=== "
    "en\ntext\n";

std::string pageWith(const std::string& stop)
{
    std::string page = kPage;
    return page.replace(page.find("STOP"), 4, stop);
}
const std::string kEnd = R"({"grain": "frame", "end": true})";

struct Broken {
    std::string text;
    int         line;
    std::string says;
};

TEST(LessonFile, SaysFileAndLineOfEveryMistake)
{
    const std::string good  = kHead + pageWith(kEnd);  // 6 lines
    const Broken      all[] = {
             {"", 1, "=== lesson"},
             {"=== page\n{}\n", 2, "scene"},
             {kHead, 3, "no page"},
             {kHead + "=== lesson\n{\"title\": \"u\"}\n", 3, "one lesson"},
             {kHead + "=== pages\n", 3, "no section 'pages'"},
             {"=== lesson\n{\"titel\": \"t\"}\n", 2, "no 'titel'"},
             {"=== lesson\n{\n\"title\": 3}\n", 3, "'title' must be text"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\"\n\n", 6, "JSON"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\",\n \"algorithm\": \"zbufer\"}\n", 5, "preset"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\",\n \"choices\": {\"depth\": \"soon\"}}\n", 5, "soon"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\",\n \"choices\": {\"depht\": \"late\"}}\n", 5, "axis"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\",\n \"fault\": \"typo\"}\n", 5, "fault"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\",\n \"fault\": \"half-pixel+typo\"}\n", 5, "fault"},
             {kHead
                  + "=== page\n{\"scene\": \"builtin:cube\", \"algorithm\": \"zbuffer\",\n \"choices\": {\"upkeep\": "
                         "\"pushed\"}}\n",
              4, "upkeep"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\", \"size\": [0, 9]}\n", 4, "size"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\", \"size\": [20, 10], \"pick\": [20, 0]}\n", 4, "outside"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\", \"layer\": \"x-ray\"}\n", 4, "layer"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\",\n\"panel\": \"active-edge\"}\n", 5, "'panel' must be one of"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\"}\n", 3, "no text"},
             {kHead + "=== page\n{\"scene\": \"builtin:cube\"}\n=== en\n\n", 5, "empty"},
             {kHead + "=== en\nhello\n", 3, "before the first page"},
             {good + "=== en\nmore\n", 7, "already"},
             {kHead + pageWith(R"({"grain": "nod", "end": true})"), 4, "grain"},
             {kHead + pageWith(R"({"grain": "node", "verdict": "hidden"})"), 4, "no steps of grain 'node'"},
             {kHead + pageWith(R"({"grain": "line"})"), 4, "names an event"},
             {kHead + pageWith(R"({"line": 3})"), 4, "grain"},
             {kHead + pageWith(R"({"grain": "line", "line": 3, "step": 4})"), 4, "not both"},
             {kHead + pageWith(R"({"grain": "line", "line": 3, "end": true})"), 4, "'end'"},
             {kHead + pageWith(R"({"grain": "line", "line": 3, "nth": 0})"), 4, "nth"},
             {good + "=== question\n{\"ask\": \"a\", \"why\": \"b\"}\n", 8, "kind"},
             {good + "=== question\n{\"kind\": \"number\", \"ask\": \"a\"}\n", 8, "why"},
             {good + "=== question\n{\"kind\": \"number\", \"ask\": \"a\", \"why\": \"b\"}\n", 8, "fact"},
             {good + "=== question\n{\"kind\": \"number\", \"ask\": \"a\", \"why\": \"b\", \"fact\": \"edges\"}\n", 8,
              "no fact 'edges'"},
             {good
                  + "=== question\n{\"kind\": \"choice\", \"ask\": \"a\", \"why\": \"b\", \"choices\": [{\"text\": \"x\", "
                         "\"right\": true}]}\n",
              8, "two"},
             {good
                  + "=== question\n{\"kind\": \"choice\", \"ask\": \"a\", \"why\": \"b\", \"choices\": [{\"text\": \"x\"}, "
                         "{\"text\": \"y\"}]}\n",
              8, "exactly one"},
             {good
                  + "=== question\n{\"kind\": \"pixel\", \"ask\": \"a\", \"why\": \"b\", \"fact\": \"line\", \"value\": "
                         "1}\n",
              8, "of pixels"},
             {good
                  + "=== question\n{\"kind\": \"number\", \"ask\": \"a\", \"why\": \"b\", \"answer\": 1, \"choices\": "
                         "[]}\n=== question\n{}\n",
              9, "one question"},
    };
    ASSERT_TRUE(parseLesson(good, "a.md")) << parseLesson(good, "a.md").error().text();
    for (const Broken& broken : all) {
        const auto lesson = parseLesson(broken.text, "a.md");
        ASSERT_FALSE(lesson) << broken.text;
        EXPECT_EQ(lesson.error().file, "a.md");
        EXPECT_EQ(lesson.error().line, broken.line) << broken.text << lesson.error().text();
        EXPECT_NE(lesson.error().sentence.find(broken.says), std::string::npos) << broken.text << lesson.error().text();
    }
}

Result<PageRun> runOf(const std::string& text)
{
    const auto lesson = parseLesson(text, "a.md");
    if (!lesson) return lesson.error();
    return runPage(lesson->pages.back(), "a.md", requestOf(lesson->pages.back()));
}

TEST(LessonRun, AStopIsTheNthEventThatIsAllOfWhatItNames)
{
    const auto line = runOf(kHead + pageWith(R"({"grain": "line", "line": 12})"));
    ASSERT_TRUE(line) << line.error().text();
    const auto lesson = parseLesson(kHead + pageWith(R"({"grain": "line", "line": 12})"), "a.md");
    Replay     replay(requestOf(lesson->pages[0]));
    const auto state = replay.at(Grain::Line, line->step);
    ASSERT_TRUE(state);
    EXPECT_EQ(state->sweep->y, 12);

    const auto pixel = runOf(kHead + pageWith(R"({"grain": "pixel", "pixel": [30, 15], "test": "won"})"));
    ASSERT_TRUE(pixel) << pixel.error().text();
    const auto tested = replay.at(Grain::Pixel, pixel->step);
    ASSERT_TRUE(tested && tested->pixel);
    EXPECT_EQ(tested->pixel->x, 30);
    EXPECT_EQ(tested->pixel->y, 15);
    EXPECT_TRUE(tested->pixel->won);

    const auto second = runOf(kHead + pageWith(R"({"grain": "span", "line": 12, "nth": 3})"));
    const auto first  = runOf(kHead + pageWith(R"({"grain": "span", "line": 12, "nth": 2})"));
    ASSERT_TRUE(first && second);
    EXPECT_EQ(second->step.value, first->step.value + 1);
}

TEST(LessonRun, SaysWhereAStopOrAnAnswerIsNotTrue)
{
    const auto never = runOf(kHead
                             + pageWith("\n"
                                        R"({"grain": "line", "line": 40})"));
    ASSERT_FALSE(never);
    EXPECT_EQ(never.error().text(), "a.md:5: the run never comes to this stop");

    const auto ask = [](const std::string& question) {
        return kHead + pageWith(R"({"grain": "line", "line": 12})") + "=== question\n" + question + "\n";
    };
    const std::string number = R"({"kind": "number", "ask": "a", "why": "b", "fact": "line", "answer": )";
    EXPECT_TRUE(runOf(ask(number + "12}")));
    const auto lie = runOf(ask(number + "13}"));
    ASSERT_FALSE(lie);
    EXPECT_EQ(lie.error().text(), "a.md:8: the file says 13, but the renderer's 'line' is 12");

    const std::string choice =
        R"({"kind": "choice", "ask": "a", "why": "b", "fact": "line", "choices": [{"text": "x", "from": 0, "to": 5},
            {"text": "y", )";
    const auto right = runOf(ask(choice + R"("from": 6}]})"));
    ASSERT_TRUE(right) << right.error().text();
    EXPECT_EQ(*right->answer->choice, 1u);
    const auto none = runOf(ask(choice + R"("value": 11}]})"));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text().find("no choice"), std::string::npos);
    const auto both = runOf(ask(choice + R"("value": 12}, {"text": "z", "value": 12}]})"));
    ASSERT_FALSE(both);
    EXPECT_NE(both.error().text().find("two choices"), std::string::npos);
    const auto nothing = runOf(ask(R"({"kind": "number", "ask": "a", "why": "b", "fact": "query-level"})"));
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().line, 8);
    const auto all = runOf(ask(R"({"kind": "pixel", "ask": "a", "why": "b", "fact": "tests", "from": 0})"));
    ASSERT_FALSE(all);
    EXPECT_NE(all.error().text().find("more than half"), std::string::npos);
}

// Documentation
// ---------------------------------------------------------------------------------------------------------

TEST(LessonDocumentation, NamesEveryFact)
{
    const std::string text = textOf(kRoot / "docs/lessons.md");
    for (const FactEntry& fact : facts())
        EXPECT_NE(text.find(std::string("`").append(fact.word).append("`")), std::string::npos) << fact.word;
    for (const PixelFactEntry& fact : pixelFacts())
        EXPECT_NE(text.find(std::string("`").append(fact.word).append("`")), std::string::npos) << fact.word;
}

TEST(LessonDocumentation, ItsExampleIsALessonThatRuns)
{
    const std::string text  = textOf(kRoot / "docs/lessons.md");
    const std::string fence = "````\n";
    const auto        from  = text.find(fence);
    ASSERT_NE(from, std::string::npos);
    const auto to = text.find("````", from + fence.size());
    ASSERT_NE(to, std::string::npos);
    const auto lesson = parseLesson(text.substr(from + fence.size(), to - from - fence.size()), "example.md");
    ASSERT_TRUE(lesson) << lesson.error().text();
    EXPECT_GE(lesson->pages.size(), 2u);
    for (const LessonPage& page : lesson->pages) {
        const auto run = runPage(page, "example.md", requestOf(page));
        EXPECT_TRUE(run) << run.error().text();
    }
}

}  // namespace
}  // namespace zscope
