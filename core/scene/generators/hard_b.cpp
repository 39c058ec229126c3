// builtin:hard/B1 .. hard/B13: the hard cases of transform and clipping (docs/correctness.md, Hard cases, B).

#include <algorithm>
#include <cmath>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/hard_scene.h"
#include "core/scene/generators/random.h"

namespace zscope::generated {

namespace {

using namespace zscope::hard;

/// The triangle with its corners listed from number `first` on.
void triangleFrom(HardScene& hard, std::int64_t first, const std::array<Vertex, 3>& corner)
{
    const auto number = [&](std::int64_t i) { return corner[static_cast<std::size_t>((first + i) % 3)]; };
    hard.triangle(number(0), number(1), number(2));
}

/// Every edge that crosses the near plane does so at its middle.
Result<Scene> cornersBehind(const Arguments& arguments)
{
    HardScene             hard(64, 64);
    std::array<Vertex, 3> corner{};
    switch (arguments.whole("behind")) {
        case 1:  // seen as (12, 22), (-4, 68), (76, 68), (52, 22)
            corner = {hard.inView({-20, 10, 1}), hard.inView({2, -28, -0.5}), hard.inView({20, 10, 1})};
            break;
        case 2:  // seen as (32, 12), (24, 72), (52, 52)
            corner = {hard.inView({0, 20, 1}), hard.inView({-4, -40, -0.5}), hard.inView({10, -30, -0.5})};
            break;
        default:
            corner = {hard.inView({0, 20, -1}), hard.inView({-4, -40, -0.5}), hard.inView({10, -30, 0.125})};
    }
    triangleFrom(hard, arguments.whole("first"), corner);
    return hard.finish();
}

/// Two triangles whose shared edge has one end behind the near plane, the edge listed once from each end. They lie on
/// different sides of the plane through the eye and that edge, so they do not overlap.
Result<Scene> sharedEdgeAcrossNear(const Arguments& arguments)
{
    Random     random(static_cast<std::uint64_t>(arguments.whole("seed")));
    HardScene  hard(64, 64);
    const auto side = [](const dvec3& p, const dvec3& q, const dvec3& r) {
        return p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
    };
    dvec3 front, behind, left, right;
    do {
        front  = random.between(dvec3{-8, 0, 0.3}, dvec3{8, 28, 2});
        behind = random.between(dvec3{-8, -30, -1}, dvec3{8, 4, 0.24});
        left   = random.between(dvec3{-30, -9, -0.5}, dvec3{-1, 9, 1});
        right  = random.between(dvec3{1, -9, -0.5}, dvec3{30, 9, 1});
    } while (!(side(front, left, behind) > 0.5 && side(behind, right, front) > 0.5));
    const Vertex a = hard.inView(front), b = hard.inView(left), c = hard.inView(behind), d = hard.inView(right);
    hard.triangle(a, b, c);
    hard.triangle(c, d, a);
    return hard.finish();
}

Result<Scene> onTheNearPlane(const Arguments& arguments)
{
    HardScene hard(64, 64);
    if (arguments.word("what") == "face") {
        hard.triangle({8.5, 8.5}, {20, 55}, {56, 12}, 1);
    } else {
        const Vertex a = hard.at({8.5, 8.5}, 1), b = hard.at({20, 55}, 0.25), c = hard.at({56, 12}, 0.5);
        triangleFrom(hard, arguments.whole("first"), {a, b, c});
    }
    return hard.finish();
}

/// Two corners at z = 1 and one at, behind, or hardly in front of the eye.
Result<Scene> aroundTheEye(const Arguments& arguments)
{
    HardScene          hard(64, 64);
    const std::string& what = arguments.word("z");
    const double       z    = what == "zero" ? 0 : what == "minus-near" ? -kNear : what == "tiny" ? 0x1p-60 : 0x1p-1060;
    const Vertex       a = hard.inView({-20, 10, 1}), b = hard.inView({1, -8, z}), c = hard.inView({20, 14, 1});
    triangleFrom(hard, arguments.whole("first"), {a, b, c});
    return hard.finish();
}

/// A box of twelve triangles, the camera inside it and off its middle.
Result<Scene> insideBox(const Arguments& arguments)
{
    HardScene hard(64, 48);
    for (const double z : {-2.0, 3.0})
        for (const double y : {-1.5, 1.0})
            for (const double x : {-1.0, 2.0}) hard.inWorld({x, y, z});
    for (const auto& face : std::array<std::array<Vertex, 4>, 6>{
             {{4, 6, 7, 5}, {1, 3, 2, 0}, {5, 7, 3, 1}, {0, 2, 6, 4}, {6, 2, 3, 7}, {0, 4, 5, 1}}})
        hard.quad(face[0], face[1], face[2], face[3]);  // counter-clockwise from the inside
    const auto number         = static_cast<int>(arguments.whole("direction"));
    const auto [side, ahead]  = pointOnCircle(number / 12.0);
    const auto [level, slope] = pointOnCircle((number % 5 - 2) / 11.0);
    ViewRequest view;
    view.eye         = dvec3{0.3, -0.2, 0.4};
    view.target      = dvec3{0.3 + side * level, -0.2 + slope, 0.4 + ahead * level};
    view.verticalFov = 90;
    view.near        = 1.0 / 64;
    view.far         = kInfinity;
    view.width       = 64;
    view.height      = 48;
    return hard.finish(view);
}

/// A floor from behind the eye to the horizon at the height of the eye, above and below it nothing.
Result<Scene> inThePlane(const Arguments& arguments)
{
    Camera camera             = pixelCamera(65, 65);
    const auto [cosine, sine] = pointOnCircle(arguments.real("roll") / 360);
    camera.right              = {cosine, sine, 0};
    camera.up                 = {-sine, cosine, 0};
    HardScene    hard(camera);
    const Vertex a = hard.inView({-100, 0, -3}), b = hard.inView({100, 0, -3});
    const Vertex c = hard.inView({70, 0, 40}), d = hard.inView({-110, 0, 50});
    hard.quad(a, b, c, d);
    return hard.finish();
}

/// A cloud of triangles in the view of a camera of 60 degrees; everything measured in `unit`.
Result<Scene> scaledCloud(const Arguments& arguments)
{
    const double unit = arguments.real("scale");
    Camera       camera;
    camera.focal  = 1.75;
    camera.eye    = {3 * unit, -2 * unit, 5 * unit};
    camera.near   = 0.25 * unit;
    camera.far    = 64 * unit;
    camera.width  = 96;
    camera.height = 64;
    HardScene hard(camera);
    Random    random(7);
    for (int i = 0; i < 80; ++i) {
        const dvec3 middle = random.between(dvec3{-3, -5, -9}, dvec3{9, 1, 4.9});
        const auto  corner = [&] {
            const dvec3 p = middle + random.between(dvec3{-2}, dvec3{2});
            return hard.inWorld({p.x * unit, p.y * unit, p.z * unit});
        };
        const Vertex a = corner(), b = corner(), c = corner();
        hard.triangle(a, b, c);
    }
    return hard.finish();
}

/// A bumpy sheet of detail 1e-3, `offset` away from the origin on all three axes, seen from 0.03 above.
Result<Scene> farFromTheOrigin(const Arguments& arguments)
{
    const double offset = arguments.real("offset");
    const double detail = arguments.word("detail") == "decimal" ? 1e-3 : 0x1p-10;
    Camera       camera;
    camera.eye    = {offset + 10 * detail, offset + 10 * detail, offset + 32 * detail};
    camera.focal  = 3;
    camera.near   = 8 * detail;
    camera.far    = 128 * detail;
    camera.width  = 128;
    camera.height = 128;
    HardScene               hard(camera);
    Random                  random(11);
    constexpr std::uint32_t kSide = 20;
    for (std::uint32_t y = 0; y <= kSide; ++y)
        for (std::uint32_t x = 0; x <= kSide; ++x) {
            const double height = static_cast<double>(random.below(1024)) / 256;  // in units of the detail
            hard.inWorld({offset + x * detail, offset + y * detail, offset + height * detail});
        }
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const Vertex a = y * (kSide + 1) + x, b = a + kSide + 1;
            hard.quad(a, a + 1, b + 1, b);
        }
    return hard.finish();
}

/// A cloud that fills the view of an extreme angle.
Result<Scene> extremeAngle(const Arguments& arguments)
{
    const double degrees = arguments.real("angle");
    ViewRequest  view;
    view.eye           = dvec3{0, 0, 0};
    view.target        = dvec3{0, 0, -1};
    view.verticalFov   = degrees;
    view.near          = 0.125;
    view.far           = kInfinity;
    view.width         = 96;
    view.height        = 64;
    const double slope = std::tan(degrees * (3.141592653589793 / 360));  // of the picture's upper edge
    HardScene    hard(64, 64);
    Random       random(5);
    for (int i = 0; i < 60; ++i) {
        const double z      = random.between(0.5, 8);
        const auto   corner = [&] {
            const double depth = z * random.between(0.75, 1.25);
            const double x = random.between(-1.6, 1.6), y = random.between(-1.1, 1.1);
            return hard.inView({x * slope * depth, y * slope * depth, depth});
        };
        const Vertex a = corner(), b = corner(), c = corner();
        hard.triangle(a, b, c);
    }
    return hard.finish(view);
}

/// Two sheets, the farther one first in the file, a part in 100,000 apart, flat or leaning back to twice the distance.
Result<Scene> thinSheets(const Arguments& arguments)
{
    HardScene    hard(64, 64, 1e-4, 1e7);
    const double distance = arguments.word("end") == "near" ? 1e-3 : 4.5e6;
    const double lean     = arguments.word("sheet") == "leaning" ? 2 : 1;
    for (const double apart : {1.00001, 1.0}) {
        const double z  = distance * apart;
        const auto   at = [&](double x, double y, double depth) { return hard.inView({x * depth, y * depth, depth}); };
        const Vertex a = at(-24, 24, z * lean), b = at(-24, -24, z), c = at(24, -24, z), d = at(24, 24, z * lean);
        hard.quad(a, b, c, d);
    }
    return hard.finish();
}

/// Three upright sheets side by side: one float32 step nearer than far, exactly at far, one step beyond.
Result<Scene> atTheFarPlane(const Arguments& arguments)
{
    const double far = arguments.real("far");
    HardScene    hard(48, 32, kNear, far);
    const auto   limit = static_cast<float>(kNear / far);
    double       left  = 2;
    for (const float depth : {std::nextafter(limit, 1.0f), limit, std::nextafter(limit, 0.0f)}) {
        hard.rectangle({left, 4}, {left + 12, 28}, static_cast<double>(depth));
        left += 16;
    }
    return hard.finish();
}

/// An ordinary triangle, one with extreme coordinates, another ordinary one.
Result<Scene> extremeNumbers(const Arguments& arguments)
{
    HardScene          hard(64, 64);
    const std::string& what = arguments.word("what");
    hard.triangle({2.5, 2.5}, {2.5, 30}, {30, 2.5});
    constexpr double kHuge = 1e308, kDenormal = 0x1p-1074;
    const auto       extreme = [&](const dvec3& a, const dvec3& b, const dvec3& c) {
        const Vertex first = hard.inView(a), second = hard.inView(b), third = hard.inView(c);
        hard.triangle(first, second, third);
    };
    if (what == "huge-x") extreme({-20, 20, 1}, {kHuge, -20, 1}, {20, 20, 1});
    if (what == "huge-z") extreme({-20, 20, 1}, {-20, -20, kHuge}, {20, 20, 1});
    if (what == "huge-behind") extreme({-20, 20, 1}, {-20, -20, -kHuge}, {20, 20, 1});
    if (what == "huge-all") extreme({kHuge, kHuge, kHuge}, {-kHuge, kHuge, -kHuge}, {kHuge, -kHuge, kHuge});
    if (what == "denormal") extreme({kDenormal, 20, 1}, {-20, -kDenormal, 1}, {20, kDenormal, 1});
    if (what == "denormal-z") extreme({-20, 20, 1}, {-20, -20, kDenormal}, {20, 20, 1});
    hard.triangle({61.5, 61.5}, {61.5, 34}, {34, 61.5});
    return hard.finish();
}

/// The smallest pictures there are: one pixel wide, high, or both.
Result<Scene> smallestPicture(const Arguments& arguments)
{
    const auto   side = [&](std::string_view key) { return static_cast<int>(arguments.whole(key)); };
    HardScene    hard(side("width"), side("height"));
    const double width = hard.camera.width, height = hard.camera.height;
    hard.triangle({-1, -1}, {-1, 3 * height}, {2 * width, -1}, 0.125);
    hard.triangle({0.25, 0.25}, {0.25, height * 0.75}, {width * 0.75, 0.25}, 0.25);
    return hard.finish();
}

}  // namespace

std::vector<Generator> hard_b()
{
    const Parameter first{"first", WholeNumber{0, 0, 2}};  // the corner that is listed first
    return {
        {"hard/B1",
         "One, two or three corners behind the near plane",
         {{"behind", WholeNumber{1, 1, 3}}, first},
         cornersBehind},
        {"hard/B2",
         "A shared edge that crosses the near plane",
         {{"seed", WholeNumber{1, 0, 1'000'000}}},
         sharedEdgeAcrossNear},
        {"hard/B3",
         "A corner or a face exactly on the near plane",
         {{"what", OneOf{{"corner", "face"}}}, first},
         onTheNearPlane},
        {"hard/B4",
         "A corner level with the eye, behind it, or hardly in front",
         {{"z", OneOf{{"zero", "minus-near", "tiny", "denormal"}}}, first},
         aroundTheEye},
        {"hard/B5", "The camera inside a closed box", {{"direction", WholeNumber{0, 0, 11}}}, insideBox},
        {"hard/B6",
         "The camera in the plane of a large face; roll in degrees",
         {{"roll", RealNumber{0, -180, 180}}},
         inThePlane},
        {"hard/B7", "A cloud of triangles, all lengths scaled", {{"scale", RealNumber{1, 1e-30, 1e30}}}, scaledCloud},
        {"hard/B8",
         "Detail of a thousandth, far from the origin",
         {{"offset", RealNumber{1e6, -1e9, 1e9}}, {"detail", OneOf{{"decimal", "binary"}}}},
         farFromTheOrigin},
        {"hard/B9", "An extreme vertical angle, in degrees", {{"angle", RealNumber{179, 0.01, 179}}}, extremeAngle},
        {"hard/B10",
         "Thin sheets at both ends of a depth range of eleven decades",
         {{"end", OneOf{{"near", "far"}}}, {"sheet", OneOf{{"flat", "leaning"}}}},
         thinSheets},
        {"hard/B11",
         "Sheets exactly at far and one float32 step to either side",
         {{"far", RealNumber{256, 1, 1e30}}},
         atTheFarPlane},
        {"hard/B12",
         "Coordinates of extreme size between ordinary neighbours",
         {{"what", OneOf{{"huge-x", "huge-z", "huge-behind", "huge-all", "denormal", "denormal-z"}}}},
         extremeNumbers},
        {"hard/B13",
         "The smallest pictures there are",
         {{"width", WholeNumber{1, 1, kMaxPictureSide}}, {"height", WholeNumber{64, 1, kMaxPictureSide}}},
         smallestPicture},
    };
}

}  // namespace zscope::generated
