// Camera paths are read as they are written, go through their key frames, and turn the way that is said.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/scene/camera_path.h"

namespace zscope {
namespace {

constexpr const char* kPath = R"({"unit":"world","near":0.5,"far":"inf","keys":[
 {"frame":0,"eye":[0,0,8],"target":[0,0,0]},
 {"frame":4,"eye":[4,0,8],"target":[4,0,0],"fov":60},
 {"frame":7,"cut":true,"eye":[0,1,0],"target":[0,1,-3]},
 {"frame":11,"eye":[0,1,0],"target":[0,1,3]}]})";

Bounds boxBetween(const dvec3& min, const dvec3& max)
{
    Bounds bounds;
    bounds.include(min);
    bounds.include(max);
    return bounds;
}
const Bounds kBox = boxBetween({-1, -1, -1}, {1, 1, 1});

CameraPath pathOf(const std::string& text)
{
    auto read = cameraPathFromJson(text, "p.json");
    EXPECT_TRUE(read) << read.error().text();
    return *std::move(read);
}

std::vector<Camera> camerasIn(const CameraPath& path, const Bounds& bounds = kBox)
{
    auto made = camerasOf(path, bounds, 64, 48);
    EXPECT_TRUE(made) << made.error().text();
    return *std::move(made);
}

double apart(const dvec3& a, const dvec3& b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z); }

TEST(CameraPath, HasACameraPerFrameAndGoesThroughItsKeys)
{
    const CameraPath path    = pathOf(kPath);
    const auto       cameras = camerasIn(path);
    ASSERT_EQ(path.frameCount(), 12);
    ASSERT_EQ(cameras.size(), 12u);
    EXPECT_EQ(path.cuts(), std::vector<int>{7});
    for (const CameraKey& key : path.keys) {
        ViewRequest view;
        view.eye = key.eye, view.target = key.target, view.up = key.up, view.verticalFov = key.verticalFov;
        view.near = 0.5, view.far = std::numeric_limits<double>::infinity();
        view.width = 64, view.height = 48;
        EXPECT_EQ(cameras[static_cast<std::size_t>(key.frame)], *makeCamera(view, kBox)) << key.frame;
    }
}

TEST(CameraPath, GoesStraightAndEvenlyBetweenKeysAndStandsStillBeforeACut)
{
    const auto cameras = camerasIn(pathOf(kPath));
    EXPECT_LT(apart(cameras[1].eye, {1, 0, 8}), 1e-12);
    EXPECT_LT(apart(cameras[3].eye, {3, 0, 8}), 1e-12);
    EXPECT_NEAR(2 * std::atan(1 / cameras[2].focal) * 180 / 3.141592653589793, 52.5, 1e-9);
    EXPECT_LT(apart(cameras[2].forward, {0, 0, -1}), 1e-12);
    EXPECT_EQ(cameras[5], cameras[4]);
    EXPECT_EQ(cameras[6], cameras[4]);
    EXPECT_NE(cameras[7], cameras[4]);
}

TEST(CameraPath, AHalfTurnGoesToTheLeftEvenly)
{
    const auto   cameras = camerasIn(pathOf(kPath));
    const double root    = std::sqrt(0.5);
    EXPECT_LT(apart(cameras[8].forward, {-root, 0, -root}), 1e-12);
    EXPECT_LT(apart(cameras[9].forward, {-1, 0, 0}), 1e-12);
    EXPECT_LT(apart(cameras[10].forward, {-root, 0, root}), 1e-12);
    for (std::size_t frame = 7; frame < 12; ++frame) EXPECT_LT(apart(cameras[frame].up, {0, 1, 0}), 1e-12) << frame;
}

TEST(CameraPath, TurnsTheShorterWayAboutAnyAxis)
{
    const auto cameras = camerasIn(
        pathOf(R"({"keys":[{"frame":0,"eye":[0,0,0],"target":[0,0,-1]},{"frame":2,"eye":[0,0,0],"target":[1,0,0]},
        {"frame":4,"eye":[0,0,0],"target":[0,1,0],"up":[-1,0,0]}]})"));
    const double root = std::sqrt(0.5);
    EXPECT_LT(apart(cameras[1].forward, {root, 0, -root}), 1e-12);  // to the right
    EXPECT_LT(apart(cameras[3].forward, {root, root, 0}), 1e-12);   // up
    EXPECT_LT(apart(cameras[3].up, {-root, root, 0}), 1e-12);
}

TEST(CameraPath, InUnitsOfTheSceneFitsEveryScene)
{
    const CameraPath path = pathOf(R"({"unit":"scene","keys":[{"frame":0,"eye":[0,0,2],"target":[0,0,0]}]})");
    // the middle is (12, 2, 1), half the diagonal 3
    const auto cameras = camerasIn(path, boxBetween({10, 0, 0}, {14, 4, 2}));
    EXPECT_LT(apart(cameras[0].eye, {12, 2, 7}), 1e-12);
    EXPECT_LT(apart(cameras[0].forward, {0, 0, -1}), 1e-12);
}

TEST(CameraPath, IsReadBackAsItWasWritten)
{
    CameraPath path    = pathOf(kPath);
    path.keys[0].eye.x = 0.1;
    EXPECT_EQ(pathOf(cameraPathToJson(path)), path);
    EXPECT_EQ(cameraPathToJson(pathOf(cameraPathToJson(path))), cameraPathToJson(path));
}

TEST(CameraPath, AKeyMadeOfACameraLooksAsItDoes)
{
    const Camera     camera = camerasIn(pathOf(kPath))[9];
    const CameraPath path{.keys = {keyOf(camera, 0, 2.5)}, .near = camera.near, .far = camera.far};
    const Camera     again = camerasIn(path)[0];
    EXPECT_LT(apart(again.eye, camera.eye) + apart(again.forward, camera.forward) + apart(again.up, camera.up), 1e-12);
    EXPECT_NEAR(again.focal, camera.focal, 1e-12);
}

TEST(CameraPath, ThatIsWrongIsRefusedWithItsLine)
{
    const auto refused = [](const std::string& text, int line, const std::string& word) {
        const auto read = cameraPathFromJson(text, "p.json");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().file, "p.json");
        EXPECT_EQ(read.error().line, line) << read.error().sentence;
        EXPECT_NE(read.error().sentence.find(word), std::string::npos) << read.error().sentence;
    };
    const std::string first = "{\"keys\":[\n{\"frame\":0,\"eye\":[0,0,1],\"target\":[0,0,0]}";
    refused("[]", 1, "object");
    refused("{}", 1, "'keys' is missing");
    refused("{\"keys\":\n[]}", 2, "not empty");
    refused("{\n\"unit\":\"mile\"}", 2, "'unit'");
    refused("{\n\"speed\":1}", 2, "'speed'");
    refused("{\n\"near\":0}", 2, "'near'");
    refused("{\n\"far\":-1}", 2, "'far'");
    refused("{\"near\":2,\"far\":1,\"keys\":[{\"frame\":0,\"eye\":[0,0,1],\"target\":[0,0,0]}]}", 1, "less than");
    refused("{\"keys\":[\n7]}", 2, "object");
    refused("{\"keys\":[\n{\"eye\":[0,0,1],\"target\":[0,0,0]}]}", 2, "'frame' is missing");
    refused("{\"keys\":[\n{\"frame\":0,\"target\":[0,0,0]}]}", 2, "'eye' is missing");
    refused("{\"keys\":[\n{\"frame\":0,\"eye\":[0,0,1]}]}", 2, "'target' is missing");
    refused("{\"keys\":[\n{\"frame\":1,\"eye\":[0,0,1],\"target\":[0,0,0]}]}", 2, "frame 0");
    refused("{\"keys\":[\n{\"frame\":0,\"cut\":true,\"eye\":[0,0,1],\"target\":[0,0,0]}]}", 2, "cut");
    refused(first + ",\n{\"frame\":0,\"eye\":[0,0,1],\"target\":[0,0,0]}]}", 3, "rise");
    refused(first + ",\n{\"frame\":100000,\"eye\":[0,0,1],\"target\":[0,0,0]}]}", 3, "frame");
    refused(first + ",\n{\"frame\":1,\"eye\":[0,0,1],\"target\":[0,0,1]}]}", 3, "same point");
    refused(first + ",\n{\"frame\":1,\"eye\":[0,0],\"target\":[0,0,1]}]}", 3, "'eye'");
    refused(first + ",\n{\"frame\":1,\"eye\":[0,0,1],\"target\":[0,0,0],\"up\":[0,0,1]}]}", 3, "parallel");
    refused(first + ",\n{\"frame\":1,\"eye\":[0,0,1],\"target\":[0,0,0],\"fov\":180}]}", 3, "field of view");
    refused(first + ",\n{\"frame\":1,\"eye\":[0,0,1],\"target\":[0,0,0],\"cut\":1}]}", 3, "'cut'");
    refused(first + ",\n{\"frame\":1,\"eye\":[0,0,1],\"target\":[0,0,0],\"roll\":1}]}", 3, "'roll'");
}

}  // namespace
}  // namespace zscope
