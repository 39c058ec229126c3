// Every mistake of the gallery is found from the files that a renderer with it writes; two programs with different
// mistakes are not confused; lessons that are named exist and teach the mistake.
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "core/check/causes.h"
#include "core/frame/faults.h"
#include "core/frame/renderer.h"
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
    EXPECT_NE(answer->sentence.find("No mistake of the gallery explains"), std::string::npos);
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
