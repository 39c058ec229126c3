// What core/scene/view promises: the ten numbers by the written definition, a sentence for every view that is none,
// framing that shows the whole scene whatever its size, and cameras that survive their JSON to the bit.
#include "core/scene/view.h"

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "core/scene/mesh.h"

namespace zscope {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Bounds box(const dvec3& min, const dvec3& max)
{
    Bounds bounds;
    bounds.include(min);
    bounds.include(max);
    return bounds;
}

ViewRequest lookingAt(const dvec3& eye, const dvec3& target)
{
    ViewRequest view;
    view.eye    = eye;
    view.target = target;
    return view;
}

double dot(const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

struct Spread {  // of the corners of a box in the picture and along the view
    double left = std::numeric_limits<double>::infinity(), right = -std::numeric_limits<double>::infinity(),
           top = std::numeric_limits<double>::infinity(), bottom = -std::numeric_limits<double>::infinity(),
           nearest = std::numeric_limits<double>::infinity(), farthest = -std::numeric_limits<double>::infinity();
};
Spread spreadOf(const Camera& camera, const Bounds& bounds)
{
    Spread spread;
    for (int i = 0; i < 8; ++i) {
        const dvec3 p{i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                      i & 4 ? bounds.max.z : bounds.min.z};
        const dvec3  d = p - camera.eye;
        const double z = dot(camera.forward, d);
        const double x = camera.width * 0.5 + camera.height * 0.5 * camera.focal * dot(camera.right, d) / z;
        const double y = camera.height * 0.5 - camera.height * 0.5 * camera.focal * dot(camera.up, d) / z;
        spread         = {std::min(spread.left, x),   std::max(spread.right, x),   std::min(spread.top, y),
                          std::max(spread.bottom, y), std::min(spread.nearest, z), std::max(spread.farthest, z)};
    }
    return spread;
}

TEST(View, CameraFollowsTheWrittenDefinition)
{
    ViewRequest view  = lookingAt({2, 3, 8}, {0.5, 1, -1});
    view.verticalFov  = 53;
    view.near         = 0.25;
    view.far          = std::numeric_limits<double>::infinity();
    const auto camera = makeCamera(view, {});
    ASSERT_TRUE(camera.ok()) << camera.error().text();

    const dvec3  d{0.5 - 2, 1.0 - 3, -1.0 - 8};
    const double length = std::sqrt((d.x * d.x + d.y * d.y) + d.z * d.z);
    const dvec3  f{d.x / length, d.y / length, d.z / length};
    const dvec3  side{f.y * 0 - f.z * 1, f.z * 0 - f.x * 0, f.x * 1 - f.y * 0};  // f x (0, 1, 0)
    const double reach = std::sqrt((side.x * side.x + side.y * side.y) + side.z * side.z);
    const dvec3  r{side.x / reach, side.y / reach, side.z / reach};
    const dvec3  u{r.y * f.z - r.z * f.y, r.z * f.x - r.x * f.z, r.x * f.y - r.y * f.x};
    EXPECT_EQ(camera->forward, f);
    EXPECT_EQ(camera->right, r);
    EXPECT_EQ(camera->up, u);
    EXPECT_EQ(camera->focal, 1 / std::tan(53 * (3.141592653589793 / 180) * 0.5));
    EXPECT_EQ(camera->eye, (dvec3{2, 3, 8}));
    EXPECT_EQ(camera->near, 0.25);
    EXPECT_EQ(camera->far, std::numeric_limits<double>::infinity());
    EXPECT_EQ(camera->width, 1280);
    EXPECT_EQ(camera->height, 720);
}

TEST(View, ScalingEyeAndTargetByAPowerOfTwoKeepsTheAxesBitForBit)
{
    for (double scale : {0x1p-600, 0x1p-20, 0x1p20, 0x1p600}) {
        const auto  plain = makeCamera(lookingAt({2, 3, 8}, {0.5, 1, -1}), {});
        ViewRequest view  = lookingAt(dvec3{2, 3, 8} * scale, dvec3{0.5, 1, -1} * scale);
        view.near         = 1;
        view.far          = 2;
        const auto scaled = makeCamera(view, {});
        ASSERT_TRUE(plain.ok() && scaled.ok()) << scale;
        EXPECT_EQ(plain->forward, scaled->forward);
        EXPECT_EQ(plain->right, scaled->right);
        EXPECT_EQ(plain->up, scaled->up);
    }
}

TEST(View, WhatIsNoViewIsRefusedWithASentence)
{
    struct Case {
        const char*                       what;
        std::function<void(ViewRequest&)> spoil;
        const char*                       says;
    };
    const std::array cases{
        Case{"up parallel",
             [](ViewRequest& v) {
                 v.up = {-1, -1, -1};
             },
             "parallel"},
        Case{"up anti-parallel",
             [](ViewRequest& v) {
                 v.up = {2, 2, 2};
             },
             "parallel"},
        Case{"up nearly parallel",
             [](ViewRequest& v) {
                 v.up = {-1, -1, -1 + 1e-12};
             },
             "parallel"},
        Case{"up zero",
             [](ViewRequest& v) {
                 v.up = {0, 0, 0};
             },
             "up"},
        Case{"up not a number", [](ViewRequest& v) { v.up.x = kNaN; }, "up"},
        Case{"eye = target", [](ViewRequest& v) { v.eye = v.target; }, "same point"},
        Case{"eye infinite",
             [](ViewRequest& v) {
                 v.eye = dvec3{std::numeric_limits<double>::infinity(), 0, 0};
             },
             "eye"},
        Case{"target not a number",
             [](ViewRequest& v) {
                 v.target = dvec3{0, kNaN, 0};
             },
             "target"},
        Case{"too far apart",
             [](ViewRequest& v) {
                 v.eye    = dvec3{1e308, 0, 0};
                 v.target = dvec3{-1e308, 0, 0};
             },
             "far apart"},
        Case{"near = far",
             [](ViewRequest& v) {
                 v.near = 2;
                 v.far  = 2;
             },
             "far must be above near"},
        Case{"near > far",
             [](ViewRequest& v) {
                 v.near = 3;
                 v.far  = 2;
             },
             "far must be above near"},
        Case{"near 0", [](ViewRequest& v) { v.near = 0; }, "near"},
        Case{"near negative", [](ViewRequest& v) { v.near = -1; }, "near"},
        Case{"near infinite", [](ViewRequest& v) { v.near = std::numeric_limits<double>::infinity(); }, "near"},
        Case{"near not a number", [](ViewRequest& v) { v.near = kNaN; }, "near"},
        Case{"far not a number", [](ViewRequest& v) { v.far = kNaN; }, "far"},
        Case{"far negative", [](ViewRequest& v) { v.far = -1; }, "far"},
        Case{"width 0", [](ViewRequest& v) { v.width = 0; }, "size"},
        Case{"height 0", [](ViewRequest& v) { v.height = 0; }, "size"},
        Case{"width negative", [](ViewRequest& v) { v.width = -4; }, "size"},
        Case{"too wide", [](ViewRequest& v) { v.width = kMaxPictureSide + 1; }, "size"},
        Case{"fov 0", [](ViewRequest& v) { v.verticalFov = 0; }, "field of view"},
        Case{"fov 180", [](ViewRequest& v) { v.verticalFov = 180; }, "field of view"},
        Case{"fov not a number", [](ViewRequest& v) { v.verticalFov = kNaN; }, "field of view"},
        Case{"fov denormal", [](ViewRequest& v) { v.verticalFov = 1e-320; }, "field of view"},
    };
    for (const Case& c : cases) {
        ViewRequest view = lookingAt({1, 1, 1}, {0, 0, 0});
        c.spoil(view);
        const auto camera = makeCamera(view, box({-1, -1, -1}, {1, 1, 1}));
        ASSERT_FALSE(camera.ok()) << c.what;
        EXPECT_EQ(camera.error().kind, Trouble::Usage) << c.what;
        EXPECT_NE(camera.error().sentence.find(c.says), std::string::npos) << c.what << ": " << camera.error().sentence;
    }
}

TEST(View, PicturesOnePixelWideOrHighAndExtremeAnglesAreViews)
{
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 900}, {900, 1}, {kMaxPictureSide, kMaxPictureSide}})
        for (double fov : {0.01, 45.0, 179.0}) {
            ViewRequest view;
            view.width       = width;
            view.height      = height;
            view.verticalFov = fov;
            EXPECT_TRUE(makeCamera(view, box({-1, -1, -1}, {1, 1, 1})).ok()) << width << "x" << height << " " << fov;
        }
}

TEST(View, ExactCameraIsTakenAsItIsOrRefused)
{
    Camera exact{.eye    = {1e6, 0.1, -3},
                 .focal  = 0.3,
                 .near   = 1e-4,
                 .far    = std::numeric_limits<double>::infinity(),
                 .width  = 7,
                 .height = 1};
    exact.right = {0.9, 0.1, 0};  // not orthonormal: used as given all the same
    ViewRequest view;
    view.exact       = exact;
    view.width       = 640;
    const auto taken = makeCamera(view, {});
    ASSERT_TRUE(taken.ok());
    EXPECT_EQ(*taken, exact);

    view.exact->far = view.exact->near;
    EXPECT_FALSE(makeCamera(view, {}).ok());
    view.exact       = exact;
    view.exact->up.y = kNaN;
    EXPECT_FALSE(makeCamera(view, {}).ok());
    view.exact        = exact;
    view.exact->focal = 0;
    EXPECT_FALSE(makeCamera(view, {}).ok());
}

TEST(View, FramedSceneFitsThePictureAndIsNotClipped)
{
    const std::array boxes{box({-1, -1, -1}, {1, 1, 1}),
                           box({-50, 0, -1}, {50, 1, 1}),
                           box({0, -80, 0}, {1, 80, 1}),
                           box({-1, 0, -300}, {1, 1, 0}),
                           box({-1, -1, 0}, {1, 1, 0}),
                           box({0, 0, 0}, {0, 5, 0}),
                           box({-1e-6, 0, 0}, {0, 1e-6, 1e-6}),
                           box({-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}),
                           box({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 2, 1e6 + 3}),
                           box({-1e200, 0, 0}, {1e200, 1e200, 1e200})};
    for (const Bounds& bounds : boxes)
        for (const auto& [width, height] : {std::pair{1280, 720}, {300, 900}, {64, 64}})
            for (double fov : {10.0, 45.0, 120.0}) {
                SCOPED_TRACE(testing::Message()
                             << bounds.max.x << " " << bounds.max.y << " " << width << "x" << height << " " << fov);
                ViewRequest view;
                view.width        = width;
                view.height       = height;
                view.verticalFov  = fov;
                const auto camera = makeCamera(view, bounds);
                ASSERT_TRUE(camera.ok()) << camera.error().text();
                EXPECT_LT(camera->forward.z, 0);
                EXPECT_LT(camera->forward.y, 0);  // from above
                EXPECT_EQ(camera->forward.x, 0);
                const Spread spread = spreadOf(*camera, bounds);
                EXPECT_GT(spread.left, 0);
                EXPECT_LT(spread.right, width);
                EXPECT_GT(spread.top, 0);
                EXPECT_LT(spread.bottom, height);
                EXPECT_GT(spread.nearest, camera->near);
                EXPECT_LT(spread.farthest, camera->far);
                EXPECT_LT(camera->far / camera->near, 1e5);
                // Comfortable: it fills at least three quarters of one direction.
                EXPECT_GT(std::max((spread.right - spread.left) / width, (spread.bottom - spread.top) / height), 0.75);
            }
}

TEST(View, SceneWithoutExtentOrWithoutAnythingStillHasACamera)
{
    for (const Bounds& bounds : {Bounds{}, box({0, 0, 0}, {0, 0, 0}), box({3, 4, 5}, {3, 4, 5}),
                                 box({1e9, 1e9, -1e9}, {1e9, 1e9, -1e9}), box({1e-300, 0, 0}, {1e-300, 0, 0})}) {
        const auto camera = makeCamera({}, bounds);
        ASSERT_TRUE(camera.ok()) << camera.error().text();
        if (bounds.isEmpty()) continue;
        const Spread spread = spreadOf(*camera, bounds);
        EXPECT_GT(spread.nearest, camera->near);
        EXPECT_LT(spread.farthest, camera->far);
    }
}

TEST(View, EyeInsideTheSceneSeesWhatIsNear)
{
    ViewRequest view   = lookingAt({0, 0, 0}, {0, 0, -1});
    const auto  camera = makeCamera(view, box({-100, -100, -100}, {100, 100, 100}));
    ASSERT_TRUE(camera.ok());
    EXPECT_LT(camera->near, 0.1);
    EXPECT_GT(camera->far, 100);
    EXPECT_LT(camera->far / camera->near, 1e5);
}

TEST(View, EyeWithoutTargetLooksAtTheMiddleOfTheScene)
{
    ViewRequest view;
    view.eye          = dvec3{10, 2, 3};
    const auto camera = makeCamera(view, box({0, 0, 0}, {2, 4, 6}));
    ASSERT_TRUE(camera.ok());
    EXPECT_EQ(camera->forward, (dvec3{-1, 0, 0}));
    view.eye = dvec3{1, 2, 3};
    EXPECT_FALSE(makeCamera(view, box({0, 0, 0}, {2, 4, 6})).ok());
}

TEST(View, WhatIsGivenOfNearAndFarIsKeptAndTheOtherFollows)
{
    ViewRequest  view = lookingAt({0, 0, 10}, {0, 0, 0});
    const Bounds unit = box({-1, -1, -1}, {1, 1, 1});
    view.near         = 1e6;
    auto camera       = makeCamera(view, unit);
    ASSERT_TRUE(camera.ok());
    EXPECT_EQ(camera->near, 1e6);
    EXPECT_GT(camera->far, 1e6);
    view.near.reset();
    view.far = 1e-3;
    camera   = makeCamera(view, unit);
    ASSERT_TRUE(camera.ok());
    EXPECT_EQ(camera->far, 1e-3);
    EXPECT_LT(camera->near, 1e-3);
}

TEST(CameraJson, ReadingBackGivesTheSameBits)
{
    const std::array reals{0.1, -0.0, 1.0 / 3, 5e-324, -1.7976931348623157e308, 1e-310, 123456789.123456789};
    for (double a : reals) {
        Camera     camera{.eye     = {a, -a, 0.7},
                          .right   = {a, 1, 2},
                          .up      = {0, a, 0},
                          .forward = {0, 0, a},
                          .focal   = 1.7320508075688772,
                          .near    = 1e-4,
                          .far     = std::numeric_limits<double>::infinity(),
                          .width   = 1024,
                          .height  = 1};
        const auto back = cameraFromJson(cameraToJson(camera), "cam.json");
        ASSERT_TRUE(back.ok()) << back.error().text();
        EXPECT_EQ(*back, camera);
        EXPECT_EQ(std::signbit(back->eye.x), std::signbit(camera.eye.x));
        camera.far      = 0x1.fffffffffffffp+100;
        const auto next = cameraFromJson(cameraToJson(camera), "cam.json");
        ASSERT_TRUE(next.ok());
        EXPECT_EQ(next->far, camera.far);
    }
}

std::string cameraText(const std::string& near, const std::string& extra = "")
{
    return "{\"eye\":[1,\"2.5\",\"0x1.8p+1\"],\n\"right\":[1,0,0],\"up\":[0,1,0],\"forward\":[0,0,-1],\n\"focal\":"
           "\"1e0\",\"near\":"
           + near + ",\n\"far\":\"inf\",\"width\":640,\"height\":480" + extra + "}";
}

TEST(CameraJson, NumbersMayBeDecimalHexOrInfAndAreCorrectlyRounded)
{
    auto camera = cameraFromJson(cameraText("0.1"), "cam.json");
    ASSERT_TRUE(camera.ok()) << camera.error().text();
    EXPECT_EQ(camera->eye, (dvec3{1, 2.5, 3}));
    EXPECT_EQ(camera->near, 0.1);
    EXPECT_EQ(camera->far, std::numeric_limits<double>::infinity());
    // Half way between two float64: to the even one; a little above: up.
    EXPECT_EQ(cameraFromJson(cameraText("\"1.00000000000000011102230246251565404236316680908203125\""), "c")->near,
              1.0);
    EXPECT_EQ(cameraFromJson(cameraText("\"1.00000000000000011102230246251565404236316680908203126\""), "c")->near,
              1.0000000000000002);
    EXPECT_EQ(cameraFromJson(cameraText("\"-0x1p-3\""), "c").ok(), false);  // near must be above 0
    EXPECT_EQ(cameraFromJson(cameraText("\"+0X1.8P-1\""), "c")->near, 0.75);
}

TEST(CameraJson, WhatIsNoCameraIsRefusedWithFileAndLine)
{
    struct Case {
        std::string text;
        int         line;
        const char* says;
    };
    const std::array cases{
        Case{"", 1, "not JSON"},
        Case{"{\"eye\":[1,2,3],\n", 2, "not JSON"},
        Case{"[1,2]", 1, "object"},
        Case{cameraText("1") + std::string("\n\0x", 3), 5, "zero byte"},
        Case{cameraText(std::string(100'000, '9')), 3, "999... is beyond"},
        Case{"{}", 1, "'eye' is missing"},
        Case{cameraText("1", ",\n\"zoom\":2"), 5, "no 'zoom'"},
        Case{cameraText("1", ",\n\"near\":2"), 5, "twice"},
        Case{cameraText("\"nan\""), 3, "not a number"},
        Case{cameraText("\"--1\""), 3, "not a number"},
        Case{cameraText("\"0x\""), 3, "not a number"},
        Case{cameraText("\"1,5\""), 3, "not a number"},
        Case{cameraText("\" 1\""), 3, "not a number"},
        Case{cameraText("\"1e400\""), 3, "range"},
        Case{cameraText("1e400"), 3, "largest"},
        Case{cameraText("null"), 3, "must be a number"},
        Case{cameraText("\"inf\""), 1, "near"},
        Case{cameraText("1.5\n").replace(0, 7, "{\"eyes\":"), 1, "no 'eyes'"},
        Case{"{\"eye\":[1,2]}", 1, "three numbers"},
        Case{"{\"eye\":[1,2,\"inf\"]}", 1, "finite"},
        Case{"{\n\"width\":12.5}", 2, "whole number"},
        Case{"{\n\"width\":0}", 2, "whole number"},
        Case{"{\n\"width\":\"640\"\n}", 2, "whole number"},
        Case{"{\n\"width\":16385\n}", 2, "whole number"},
    };
    for (const Case& c : cases) {
        const auto camera = cameraFromJson(c.text, "cam.json");
        ASSERT_FALSE(camera.ok()) << c.text;
        EXPECT_EQ(camera.error().kind, Trouble::Input);
        EXPECT_EQ(camera.error().file, "cam.json");
        EXPECT_EQ(camera.error().line, c.line) << c.text << "\n" << camera.error().text();
        EXPECT_NE(camera.error().sentence.find(c.says), std::string::npos) << c.text << ": " << camera.error().sentence;
    }
}

TEST(CameraJson, DeepNestingIsRefusedInBoundedTime)
{
    const auto camera = cameraFromJson(std::string(1'000'000, '['), "cam.json");
    ASSERT_FALSE(camera.ok());
    EXPECT_NE(camera.error().sentence.find("deeper"), std::string::npos);
}

}  // namespace
}  // namespace zscope
