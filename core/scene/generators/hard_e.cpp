// builtin:hard/E1 .. hard/E8: the hard cases of octree and BVH (docs/correctness.md, Hard cases, E). All have more
// triangles than a node keeps without being divided.

#include "core/scene/generators/hard_scene.h"
#include "core/scene/generators/random.h"

namespace zscope::generated {

namespace {

using namespace zscope::hard;

constexpr int kSize = 96;

/// Squares that lie in the splitting planes of a cube's octants, and of theirs, and between them.
Result<Scene> onThePlanes(const Arguments&)
{
    Camera camera = pixelCamera(kSize, kSize);
    camera.focal  = 1;
    HardScene    hard(camera);
    const dvec3  middle{0, 0, 160};
    const double half   = 64;
    const auto   square = [&](int axis, double across, double u, double v, double side) {
        std::array<Vertex, 4> corner;
        for (std::size_t i = 0; i < 4; ++i) {
            dvec3 p;
            p[axis]           = across;
            p[(axis + 1) % 3] = u + (i == 1 || i == 2 ? side : 0);
            p[(axis + 2) % 3] = v + (i >= 2 ? side : 0);
            corner[i]         = hard.inView(middle + p);
        }
        hard.quad(corner[0], corner[1], corner[2], corner[3]);
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int plane = -2; plane <= 2; ++plane)
            for (int i = 0; i < 8; ++i)
                for (int j = 0; j < 8; ++j)
                    if ((i + j + plane) % 3 == 0)
                        square(axis, 0.5 * half * plane, half * (i - 4) / 4, half * (j - 4) / 4, half / 4);
    return hard.finish();
}

/// The same triangle again and again, and one elsewhere so that the box is larger than it.
Result<Scene> coincident(const Arguments& arguments)
{
    HardScene    hard(kSize, kSize);
    const Vertex a = hard.at({10.25, 12.5}, 0.125), b = hard.at({14, 60}, 0.0625), c = hard.at({60, 30}, 0.25);
    for (std::int64_t i = 0; i < arguments.whole("count"); ++i) hard.triangle(a, b, c);
    hard.triangle({70, 70}, {72, 90}, {90, 72}, 0x1p-12);
    return hard.finish();
}

/// Small triangles at random about and behind one that is larger than the picture.
Result<Scene> giantAmongTiny(const Arguments& arguments)
{
    HardScene hard(kSize, kSize);
    Random    random(1);
    hard.triangle({-300, -200}, {-100, 500}, {500, 20}, 0.125);
    for (std::int64_t i = 0; i < arguments.whole("count"); ++i) {
        const Place  at{random.between(0, kSize), random.between(0, kSize)};
        const double depth = random.between(0.06, 0.13);
        hard.triangle(at, {at.x + random.between(-3, 3), at.y + 2}, {at.x + 2, at.y + random.between(-3, 3)}, depth);
    }
    return hard.finish();
}

/// A scene whose box has no extent along one axis, or along two, or none at all (and shows nothing).
Result<Scene> flat(const Arguments& arguments)
{
    HardScene          hard(kSize, kSize);
    const std::string& shape = arguments.word("shape");
    for (int i = 0; i < 400; ++i) {
        const double x = -40 + 4 * (i % 20), y = -40 + 4 * (i / 20.0);
        const auto   at = [&](double u, double v) {
            if (shape == "wall") return hard.inView({x + u, y + v, 1});
            if (shape == "floor") return hard.inView({x + u, -20, 1.75 + 0.015625 * (y + v)});
            if (shape == "line") return hard.inView({x + u + v, 3, 1});
            return hard.inView({5, 6, 1});
        };
        const Vertex a = at(0, 0), b = at(3, 0), c = at(0, 3);
        hard.triangle(a, b, c);
    }
    return hard.finish();
}

/// A patch of 1e-6 units close to the eye among triangles of 1e6 far away, and a stray corner at 1e9.
Result<Scene> tinyNextToHuge(const Arguments&)
{
    HardScene hard(pixelCamera(kSize, kSize, 1e-7));
    Random    random(5);
    for (int i = 0; i < 400; ++i) {
        const dvec3 at{random.between(-2e-5, 2e-5), random.between(-2e-5, 2e-5), random.between(1e-6, 2e-6)};
        const auto  near = [&] {
            return hard.inView(at + random.between(dvec3{-4e-6, -4e-6, -2e-7}, dvec3{4e-6, 4e-6, 2e-7}));
        };
        const Vertex a = near(), b = near(), c = near();
        hard.triangle(a, b, c);
    }
    for (int i = 0; i < 400; ++i) {
        const dvec3 at{random.between(-4e7, 4e7), random.between(-4e7, 4e7), random.between(1e6, 2e6)};
        const auto  far = [&] {
            return hard.inView(at + random.between(dvec3{-8e6, -8e6, -1e5}, dvec3{8e6, 8e6, 1e5}));
        };
        const Vertex a = far(), b = far(), c = far();
        hard.triangle(a, b, c);
    }
    const Vertex stray = hard.inView({1e9, -1e9, 1e9}), a = hard.inView({-3e6, 1e6, 2e6}),
                 b = hard.inView({1e6, 5e6, 3e6});
    hard.triangle(a, b, stray);
    return hard.finish();
}

/// Triangles about one centre, nested, in either order.
Result<Scene> oneCentre(const Arguments& arguments)
{
    HardScene     hard(kSize, kSize);
    constexpr int kCount  = 600;
    const bool    forward = arguments.word("order") == "forward";
    for (int n = 0; n < kCount; ++n) {
        const int    i    = forward ? n : kCount - 1 - n;
        const double size = 0.07 * (i + 1);
        const double tilt = i % 7 * 0.1;
        const auto   at   = [&](double x, double y, double z) {
            return hard.inView({x * size, y * size, 64 + z * tilt * size});
        };
        // one of them crosses: boxes share a centre
        const Vertex a = at(-60, -60, -1), b = at(60, -60, 1), c = at(-60, 60, 0);
        const Vertex d = at(60, 60, 0);
        if (i % 2)
            hard.triangle(a, b, d);
        else
            hard.triangle(a, d, c);
    }
    return hard.finish();
}

/// A ball of triangles all round the eye, which is at its centre (a corner of eight octants), in a splitting plane, or
/// aside; it crosses the near plane on every side.
Result<Scene> eyeWithin(const Arguments& arguments)
{
    const std::string& where  = arguments.word("eye");
    Camera             camera = pixelCamera(kSize, kSize, 0.5);
    camera.focal              = 1;
    if (where == "face") camera.eye = {0, 1.25, -2.5};
    if (where == "edge") camera.eye = {0, 0, 1.5};
    if (where == "inside") camera.eye = {1.25, -2.125, 0.75};
    HardScene hard(camera);
    Random    random(7);
    for (const double side : {-8.0, 8.0})  // two corners make the box of everything a cube about the origin
        for (int i = 0; i < 2; ++i) {
            const Vertex a = hard.inWorld({side, side, side}), b = hard.inWorld({side, side * 0.9, side}),
                         c = hard.inWorld({side, side, side * 0.9});
            hard.triangle(a, b, c);
        }
    for (int i = 0; i < 1500; ++i) {
        const dvec3  middle = random.between(dvec3{-7, -7, -7}, dvec3{7, 7, 7});
        const auto   near   = [&] { return hard.inWorld(middle + random.between(dvec3{-1, -1, -1}, dvec3{1, 1, 1})); };
        const Vertex a = near(), b = near(), c = near();
        hard.triangle(a, b, c);
    }
    return hard.finish();
}

/// A long band of triangles from behind the eye, through the near plane, to the far side of a wall that hides its end.
Result<Scene> throughTheNearPlane(const Arguments&)
{
    HardScene hard(kSize, kSize);
    for (int i = 0; i < 600; ++i) {
        const double z = -1 + 0.01 * i;
        const Vertex a = hard.inView({-20 - z, -3 * z, z}), b = hard.inView({20, -3 * z - 1, z}),
                     c = hard.inView({0, 8 - z, z + 0.3});
        hard.triangle(a, b, c);
    }
    hard.rectangle({8, 8}, {88, 88}, 0.125);
    return hard.finish();
}

}  // namespace

std::vector<Generator> hard_e()
{
    return {
        {"hard/E1", "Squares in the splitting planes of the octree", {}, onThePlanes},
        {"hard/E2", "The same triangle many times", {{"count", WholeNumber{1000, 1, 1'000'000}}}, coincident},
        {"hard/E3", "A giant triangle among tiny ones", {{"count", WholeNumber{3000, 1, 10'000'000}}}, giantAmongTiny},
        {"hard/E4",
         "A scene without extent along an axis",
         {{"shape", OneOf{{"wall", "floor", "line", "point"}}}},
         flat},
        {"hard/E5", "Triangles of 1e-6 before triangles of 1e6, and a stray corner", {}, tinyNextToHuge},
        {"hard/E6", "Triangles about one centre", {{"order", OneOf{{"forward", "reversed"}}}}, oneCentre},
        {"hard/E7", "Triangles all round the eye", {{"eye", OneOf{{"corner", "edge", "face", "inside"}}}}, eyeWithin},
        {"hard/E8", "A band through the near plane to behind a wall", {}, throughTheNearPlane},
    };
}

}  // namespace zscope::generated
