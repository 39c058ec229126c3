// Every mistake of the gallery is found from the files that a renderer with it writes; two programs with different
// mistakes are not confused; lessons that are named exist and teach the mistake.
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "core/check/causes.h"
#include "core/frame/faults.h"
#include "core/frame/renderer.h"
#include "core/io/phrase_book.h"
#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

class Causes : public CheckFiles {
protected:
    check::CheckRequest requestFor(const Camera& camera, const Picture& picture, bool withIds) const
    {
        check::CheckRequest request;
        request.camera = camera;
        request.depth  = writeDepth("d.npy", picture.depth);
        if (withIds) request.ids = writeIds("i.npy", picture.ids);
        return request;
    }
};

/// A face whose fan covers what its notch leaves open. Elsewhere a fan is a face cut otherwise, which is no mistake.
constexpr const char* kArrow = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nf 1 2 3 4\n";

/// A scene in which the mistake shows beyond rounding; of FarFirst there is none, it decides ties alone.
std::string sceneFor(Fault fault)
{
    switch (fault) {
        case Fault::OneTestPerInterval:
            return "builtin:hard/F8";
        case Fault::EqualIsHidden:
            return "builtin:layers?order=back";
        case Fault::NearRejected:
        case Fault::BehindTheEye:
            return "builtin:wall-and-city";
        case Fault::LinearZ:
            return "builtin:cubes";
        default:
            return "builtin:city?blocks=8";
    }
}

TEST_F(Causes, EveryMistakeOfTheGalleryIsNamedFirst)
{
    for (const FaultEntry& entry : faults()) {
        if (entry.fault == Fault::FarFirst || entry.fault == Fault::NoTopLeft) continue;  // rounding, by definition
        const auto scene =
            preparedScene(entry.fault == Fault::ConcaveFanned ? write("arrow.obj", kArrow) : sceneFor(entry.fault));
        const auto  camera = cameraOf(scene->scene(), 233, 151);
        DrawRequest request{
            .scene = scene, .camera = camera, .pipeline = findPreset(entry.preset)->pipeline, .shade = false};
        request.pipeline.fault = entry.fault;
        Frame frame;
        ASSERT_TRUE(Renderer().draw(request, frame));
        check::Checker checker(scene);
        const Picture  picture = pictureOf(frame.visible);
        for (const bool withIds : {true, false}) {
            const auto answer = checker.check(requestFor(camera, picture, withIds));
            ASSERT_TRUE(answer) << answer.error().text();
            if (answer->isRight() && !withIds) continue;  // depth alone need not show it
            EXPECT_FALSE(answer->isRight()) << entry.word;
            ASSERT_FALSE(answer->causes.empty()) << entry.word << (withIds ? "" : " depth alone: ") << answer->sentence;
            const auto& best = answer->causes.front();
            const auto  own  = std::ranges::find(answer->causes, entry.word, &check::Cause::name);
            ASSERT_NE(own, answer->causes.end()) << entry.word;
            EXPECT_TRUE(best.name == entry.word || (own->explained == best.explained && own->adds == best.adds))
                << entry.word << (withIds ? "" : " depth alone") << " but " << answer->sentence;
            EXPECT_GT(own->explains, 0.95) << entry.word << answer->sentence;
        }
    }
}

TEST_F(Causes, TwoMistakesAtOnceAreNamedAsAPair)
{
    const auto  scene  = preparedScene("builtin:city?blocks=8");
    const auto  camera = cameraOf(scene->scene(), 233, 151);
    DrawRequest request{.scene = scene, .camera = camera, .pipeline = findPreset("zbuffer")->pipeline, .shade = false};
    request.pipeline.fault.add(Fault::BoxShort);
    request.pipeline.fault.add(Fault::CrossingDropped);
    Frame frame;
    ASSERT_TRUE(Renderer().draw(request, frame));
    const auto answer = check::Checker(scene).check(requestFor(camera, pictureOf(frame.visible), true));
    ASSERT_TRUE(answer) << answer.error().text();
    ASSERT_FALSE(answer->causes.empty()) << answer->sentence;
    EXPECT_EQ(answer->causes.front().name, "box-short + crossing-dropped") << answer->sentence;
    EXPECT_GT(answer->causes.front().explains, 0.95) << answer->sentence;
}

/// A mistake that the gallery does not have: the right picture, moved by seven pixels.
TEST_F(Causes, AreNoneWhereNothingExplainsAFifth)
{
    const auto    scene   = preparedScene("builtin:teapot?tessellation=6");
    const Camera  camera  = cameraOf(scene->scene(), 200, 150);
    const Picture right   = *referencePicture(scene->scene(), camera, FaceCulling::None);
    Picture       picture = right;
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x) {
            picture.ids.at(x, y)   = right.ids.at((x + 7) % 200, y);
            picture.depth.at(x, y) = right.depth.at((x + 7) % 200, y);
        }
    check::Checker checker(scene);
    const auto     answer = checker.check(requestFor(camera, picture, true));
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->isRight());
    EXPECT_TRUE(answer->causes.empty()) << answer->sentence;
    EXPECT_NE(answer->sentence.find("No known mistake fits: none explains"), std::string::npos);
    EXPECT_TRUE(chinesePhrases().text(answer->sentence)) << answer->sentence;
}

TEST_F(Causes, AreNotLookedForWhereNothingIsWrongOrNobodyAsks)
{
    const auto     scene  = preparedScene("builtin:city?blocks=4");
    const Camera   camera = cameraOf(scene->scene(), 120, 90);
    Picture        right  = *referencePicture(scene->scene(), camera, FaceCulling::None);
    check::Checker checker(scene);
    EXPECT_TRUE(checker.check(requestFor(camera, right, true))->causes.empty());
    for (std::int64_t& id : right.ids.values()) id = -1;
    check::CheckRequest request = requestFor(camera, right, true);
    request.diagnoses           = false;
    EXPECT_TRUE(checker.check(request)->causes.empty());
}

/// What is plainly the matter comes first, and no cause is looked for.
class PlainCauses : public Causes {
protected:
    void SetUp() override
    {
        Causes::SetUp();
        m_scene  = preparedScene("builtin:teapot?tessellation=6");
        m_camera = cameraOf(m_scene->scene(), 200, 150);
        m_right  = *referencePicture(m_scene->scene(), m_camera, FaceCulling::None);
    }
    check::CheckAnswer judged(const check::CheckRequest& request)
    {
        auto answer = check::Checker(m_scene).check(request);
        EXPECT_TRUE(answer) << answer.error().text();
        return *std::move(answer);
    }
    static void expectNoCause(const check::CheckAnswer& answer, check::Plight plight, const std::string& begins)
    {
        EXPECT_FALSE(answer.isRight());
        EXPECT_EQ(answer.plight, plight) << answer.sentence;
        if (plight != check::Plight::NothingDrawn) {
            EXPECT_TRUE(answer.causes.empty() && answer.clusters.empty()) << answer.sentence;
        }
        EXPECT_EQ(answer.sentence.find(" are those of "), std::string::npos) << answer.sentence;
        EXPECT_TRUE(answer.sentence.starts_with(begins)) << answer.sentence;
        EXPECT_EQ(answer.sentence.find("No known mistake"), std::string::npos) << answer.sentence;
        EXPECT_TRUE(chinesePhrases().text(answer.sentence)) << answer.sentence;
    }

    std::shared_ptr<const PreparedScene> m_scene;
    Camera                               m_camera;
    Picture                              m_right;
};

TEST_F(PlainCauses, BackgroundAloneIsNoMistakeOfTheGallery)
{
    Picture empty = m_right;
    std::ranges::fill(empty.ids.values(), -1);
    std::ranges::fill(empty.depth.values(), 0.0f);
    const std::string begins = "Nothing was drawn: the files hold background alone. Perhaps a function is still empty";
    check::CheckRequest request = requestFor(m_camera, empty, true);
    expectNoCause(judged(request), check::Plight::NothingDrawn, begins);
    request.diagnoses = false;
    expectNoCause(judged(request), check::Plight::NothingDrawn, begins);
    expectNoCause(judged(requestFor(m_camera, empty, false)), check::Plight::NothingDrawn, begins);
}

TEST_F(PlainCauses, IdsThatAreNotStoredAreToldFromWrongPictures)
{
    Picture picture = m_right;
    std::ranges::fill(picture.ids.values(), -1);
    const auto answer = judged(requestFor(m_camera, picture, true));
    expectNoCause(answer, check::Plight::NoIds, "The depths are right, and every id is -1: the ids are not stored. ");
    EXPECT_EQ(answer.wrong.of(check::Mistake::Hole), answer.covered);

    for (float& depth : picture.depth.values()) depth *= depth;  // nor are the depths right
    EXPECT_EQ(judged(requestFor(m_camera, picture, true)).plight, check::Plight::None);
}

TEST_F(PlainCauses, APictureUpsideDownIsCalledSo)
{
    Picture picture = m_right;
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x) {
            picture.ids.at(x, y)   = m_right.ids.at(x, 149 - y);
            picture.depth.at(x, y) = m_right.depth.at(x, 149 - y);
        }
    check::CheckRequest request = requestFor(m_camera, picture, true);
    EXPECT_TRUE(judged(request).isRight()) << "which row comes first was not said";
    request.given.rows = check::Rows::TopDown;
    expectNoCause(judged(request), check::Plight::UpsideDown,
                  "The picture is upside down: with its rows in the other order it is right. ");

    picture.ids.at(100, 75) = picture.ids.at(100, 75) < 0 ? 0 : -1;
    request                 = requestFor(m_camera, picture, true);
    request.given.rows      = check::Rows::TopDown;
    expectNoCause(judged(request), check::Plight::UpsideDown,
                  "The picture is upside down: with its rows in the other order few of its pixels are wrong (1). ");
}

TEST_F(PlainCauses, WithoutACameraTheOptionIsNamed)
{
    std::string dump = "ZSDUMP1\n";
    for (const std::uint32_t word : {0x01020304u, 2u, 1u, 2u, 1u, 0u, 0u, 1u, 0u}) append(dump, word);
    for (const std::int32_t id : {-1, 0}) append(dump, id);
    check::CheckRequest request;
    request.dump      = write("no-camera.zdump", dump);
    const auto answer = check::Checker(m_scene).check(request);
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().text().find("no camera is given (--camera FILE)"), std::string::npos)
        << answer.error().text();
}

/// The first comer keeps a tie where the lowest id should.
TEST_F(Causes, TiesOfDepthAreNamedWhereTheyExplainMostDifferences)
{
    const auto  scene  = preparedScene("builtin:hard/C2");
    const auto  camera = cameraOf(scene->scene(), 233, 151);
    DrawRequest request{
        .scene = scene, .camera = camera, .pipeline = findPreset("hzb-octree")->pipeline, .shade = false};
    request.pipeline.fault = Fault::FarFirst;
    Frame frame;
    ASSERT_TRUE(Renderer().draw(request, frame));
    const auto answer = check::Checker(scene).check(requestFor(camera, pictureOf(frame.visible), true));
    ASSERT_TRUE(answer) << answer.error().text();
    EXPECT_TRUE(answer->isRight());
    EXPECT_GT(answer->rounding.total(), 0u);
    EXPECT_TRUE(answer->looksLikeTies);
    EXPECT_TRUE(answer->sentence.starts_with("Right up to rounding: ")) << answer->sentence;
    EXPECT_NE(answer->sentence.find("Most of them are ties: at equal depth another triangle was kept"),
              std::string::npos)
        << answer->sentence;
    EXPECT_TRUE(chinesePhrases().text(answer->sentence)) << answer->sentence;
}

/// The sentence and the tables show the same number.
TEST_F(Causes, SharesAreRoundedToATenthOfAPercent)
{
    EXPECT_EQ(check::percentText(0.8896), "89.0 %");
    EXPECT_EQ(check::percentText(1), "100.0 %");
    check::CheckAnswer answer;
    answer.wrong.of(check::Mistake::Hole) = 1000;
    answer.causes.push_back(
        {.name = "x-truncated", .title = "Truncated x", .explains = 0.8896, .lesson = {}, .pipeline = {}});
    const std::string sentence = check::sentenceOf(answer, true);
    EXPECT_NE(sentence.find(" 89.0 % of the wrong pixels are those of 'Truncated x' (x-truncated)."), std::string::npos)
        << sentence;
    EXPECT_TRUE(chinesePhrases().text(sentence)) << sentence;
}

TEST(CauseEntries, NameLessonsThatTeachThem)
{
    namespace fs = std::filesystem;
    std::map<std::string, std::string> lessons;
    for (const auto& file : fs::directory_iterator(fs::path(ZSCOPE_SOURCE_DIR) / "resources/lessons")) {
        std::ifstream     stream(file.path());
        std::stringstream text;
        text << stream.rdbuf();
        lessons[file.path().stem().string()] = text.str();
    }
    int taught = 0;
    for (const check::CauseEntry& cause : check::causeEntries()) {
        EXPECT_FALSE(cause.pipelines.empty()) << cause.name;
        EXPECT_FALSE(cause.title.empty()) << cause.name;
        const bool isFault = cause.name.find('=') == std::string::npos;
        const auto says    = [&](const std::string& text) {
            const std::size_t equal = cause.name.find('=');
            const std::string key   = isFault ? "fault" : cause.name.substr(0, equal);
            const std::string value = isFault ? cause.name : cause.name.substr(equal + 1);
            return text.find(fmt::format("\"{}\": \"{}\"", key, value)) != std::string::npos;
        };
        if (!cause.lesson.empty()) {
            ASSERT_TRUE(lessons.contains(std::string(cause.lesson))) << cause.lesson;
            EXPECT_TRUE(says(lessons[std::string(cause.lesson)])) << cause.lesson << " does not show " << cause.name;
            ++taught;
        } else {
            for (const auto& [name, text] : lessons) EXPECT_FALSE(says(text)) << name << " teaches " << cause.name;
        }
    }
    EXPECT_GT(taught, 6);
}

}  // namespace
}  // namespace zscope::tests
