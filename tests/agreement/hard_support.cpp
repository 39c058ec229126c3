#include "tests/agreement/hard_support.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <numeric>
#include <random>
#include <stdexcept>

#include "core/measure/face_figures.h"
#include "core/scene/load.h"

namespace zscope::hardcase {

namespace {

Picture reference(const HardCase& hard, FaceCulling culling)
{
    Result<Picture> picture = referencePicture(*hard.scene, hard.camera, culling);
    if (!picture) throw std::runtime_error(hard.word + ": " + picture.error().text());
    return std::move(picture).value();
}

DrawRequest requestFor(const HardCase& hard, const Preset& preset, FaceCulling culling)
{
    DrawRequest request;
    request.scene       = hard.prepared;
    request.camera      = hard.camera;
    request.faceCulling = culling;
    request.pipeline    = preset.pipeline;
    request.shade       = false;
    return request;
}

/// The first pixel where the pictures differ, in words; empty if there is none.
std::string difference(const Picture& expected, const Picture& actual)
{
    if (expected.ids.width() != actual.ids.width() || expected.ids.height() != actual.ids.height())
        return "sizes differ";
    std::size_t count = 0;
    std::string first;
    for (int y = 0; y < expected.ids.height(); ++y)
        for (int x = 0; x < expected.ids.width(); ++x) {
            const bool same = expected.ids.at(x, y) == actual.ids.at(x, y)
                              && std::bit_cast<std::uint32_t>(expected.depth.at(x, y))
                                     == std::bit_cast<std::uint32_t>(actual.depth.at(x, y));
            if (same) continue;
            if (count++ == 0)
                first = "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is "
                        + std::to_string(actual.ids.at(x, y)) + " at depth " + std::to_string(actual.depth.at(x, y))
                        + ", expected " + std::to_string(expected.ids.at(x, y)) + " at depth "
                        + std::to_string(expected.depth.at(x, y));
        }
    return count == 0 ? first : std::to_string(count) + " pixels differ; " + first;
}

struct Combination {
    int  threads;
    Simd simd;
};

const std::vector<Combination>& combinations()
{
    static const std::vector<Combination> all = [] {
        std::vector<Combination> list;
        for (const SimdEntry& simd : simdTargets())
            for (const int threads : {1, 2, 3})
                if (simd.available && simd.target != Simd::Auto) list.push_back({threads, simd.target});
        return list;
    }();
    return all;
}

void drawAndCompare(const HardCase& hard, const Preset& preset, const Combination& how, FaceCulling culling,
                    const Picture& expected)
{
    static Renderer renderer;  // as in the program: one renderer, frame after frame
    static Frame    frame;
    DrawRequest     request = requestFor(hard, preset, culling);
    request.threads         = how.threads;
    request.simd            = how.simd;
    const std::string name  = hard.word + " by " + std::string(preset.name) + ", " + std::to_string(how.threads)
                             + " threads, " + std::string(wordOf(how.simd))
                             + (culling == FaceCulling::Back ? ", back faces culled" : "");
    const Result<FrameReport> report = renderer.draw(request, frame);
    ASSERT_TRUE(report.ok()) << name << ": " << report.error().text();
    if (preset.isExact()) {
        EXPECT_EQ(difference(expected, pictureOf(frame.visible)), "") << name;
        return;
    }
    const auto figures = compareByFace(*hard.scene, hard.camera, culling, expected, pictureOf(frame.visible));
    ASSERT_TRUE(figures.ok()) << name;
    EXPECT_EQ(figures->holes, 0u) << name;
    EXPECT_EQ(figures->spills, 0u) << name;
}

}  // namespace

HardCase hardCase(const std::string& word, Scene parts, const Camera& camera)
{
    Result<Scene> scene = assemble(std::move(parts));
    if (!scene) throw std::runtime_error(word + ": " + scene.error().text());
    HardCase hard{word, std::make_shared<const Scene>(std::move(scene).value()), nullptr, camera};
    hard.prepared = std::make_shared<const PreparedScene>(hard.scene);
    return hard;
}

HardCase hardCase(const std::string& word)
{
    Result<Scene> scene = loadScene("builtin:hard/" + word);
    if (!scene) throw std::runtime_error(word + ": " + scene.error().text());
    const Result<Camera> camera = makeCamera(scene->views.at(0).view, scene->bounds);
    if (!camera) throw std::runtime_error(word + ": " + camera.error().text());
    HardCase hard{word, std::make_shared<const Scene>(std::move(scene).value()), nullptr, *camera};
    hard.prepared = std::make_shared<const PreparedScene>(hard.scene);
    return hard;
}

HardCase changed(const HardCase& original, const std::string& how, const Camera& camera,
                 const std::function<void(std::vector<dvec3>&, std::vector<std::array<std::uint32_t, 3>>&)>& edit)
{
    std::vector<dvec3>                        positions = original.mesh().positions;
    std::vector<std::array<std::uint32_t, 3>> triangles = original.mesh().triangles;
    edit(positions, triangles);
    auto mesh       = std::make_shared<Mesh>();
    mesh->positions = std::move(positions);
    for (const auto& triangle : triangles) mesh->addPolygon(triangle);
    Scene parts;
    parts.meshes.push_back(std::move(mesh));
    parts.instances.push_back({MeshId{0}, Affine{}});
    return hardCase(original.word + " (" + how + ")", std::move(parts), camera);
}

HardCase only(const HardCase& original, const std::function<bool(std::uint32_t)>& isKept)
{
    return changed(original, "some triangles only", original.camera, [&](auto&, auto& triangles) {
        std::uint32_t id = 0;
        std::erase_if(triangles, [&](const auto&) { return !isKept(id++); });
    });
}

Picture agreedPicture(const HardCase& hard, Effort effort, FaceCulling culling)
{
    static std::size_t  nextPreset = 0, nextCombination = 0;
    std::vector<Preset> exact;
    std::ranges::copy_if(presets(), std::back_inserter(exact),
                         [](const Preset& preset) { return preset.claim != Claim::Approximate; });
    const auto& ways = combinations();
    EXPECT_FALSE(exact.empty() || ways.empty());

    Picture           expected = reference(hard, culling);
    const std::size_t count    = effort == Effort::Some ? std::min<std::size_t>(4, exact.size()) : exact.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Preset& preset = exact[nextPreset++ % exact.size()];
        if (effort == Effort::All)
            for (const Combination& way : ways) drawAndCompare(hard, preset, way, culling, expected);
        else
            drawAndCompare(hard, preset, ways[nextCombination++ % ways.size()], culling, expected);
    }
    ++nextCombination;  // so that a preset meets all combinations even if their numbers have a common divisor
    return expected;
}

std::map<std::string, std::uint64_t> expectCounters(const HardCase& hard, FaceCulling culling)
{
    const Result<TriangleFates> fates = referenceFates(*hard.scene, hard.camera, culling);
    EXPECT_TRUE(fates.ok());
    std::map<std::string, std::uint64_t> first;
    for (const Preset& preset : presets()) {
        SCOPED_TRACE(hard.word + " by " + std::string(preset.name));
        Renderer   renderer;
        const auto counts = renderer.count(requestFor(hard, preset, culling));
        if (!counts.ok()) {
            ADD_FAILURE() << counts.error().text();
            continue;
        }
        std::map<std::string, std::uint64_t> named;
        for (const NamedCount& count : counts->counters) named[count.name] = count.value;
        const auto of = [&named](const std::string& fate) {
            const auto found = named.find("triangles_" + fate);
            EXPECT_NE(found, named.end()) << "triangles_" << fate;
            return found == named.end() ? 0 : found->second;
        };
        const std::uint64_t hidden = of("hidden") + of("hidden_by_node");  // behind what the pyramid holds
        EXPECT_EQ(of("in"), hard.scene->triangleCount());
        EXPECT_EQ(of("in"), of("outside") + of("clipped_away") + of("back_facing") + of("degenerate")
                                + of("no_pixel_centre") + of("out_of_range") + of("drawn") + of("transparent")
                                + hidden);
        EXPECT_LE(of("drawn"), fates->drawn);
        // A batch or node that is outside or hidden does not tell what its triangles would have become.
        if (of("outside") + of("hidden_by_node") == 0) {
            EXPECT_EQ(of("clipped_away"), fates->behindNear);
            EXPECT_EQ(of("out_of_range"), fates->outOfRange);
            EXPECT_EQ(of("drawn") + hidden + of("no_pixel_centre") + of("back_facing") + of("degenerate"),
                      fates->drawn + fates->culled + fates->degenerate);
        }
        const bool takesAllAsTheyCome =
            preset.name == "zbuffer" || preset.name == "edge-walk" || preset.name == "scanline";
        if (first.empty()) {
            EXPECT_TRUE(takesAllAsTheyCome)
                << "the counters of the plain method are those that others are compared with";
            first = named;
        }
        EXPECT_LE(of("drawn"), first["triangles_drawn"]);
        EXPECT_LE(named["pixels_tested"], first["pixels_tested"]);
        if (!takesAllAsTheyCome) continue;
        EXPECT_EQ(named["pixels_tested"], first["pixels_tested"]);
        for (const auto& [name, value] : first) {
            if (name.starts_with("triangles_")) {
                EXPECT_EQ(value, named[name]) << name;
            }
        }
    }
    return first;
}

void expectScaledTwin(const HardCase& hard, const Picture& picture, int exponent)
{
    const double factor = std::ldexp(1.0, exponent);
    Camera       camera = hard.camera;
    camera.eye          = {camera.eye.x * factor, camera.eye.y * factor, camera.eye.z * factor};
    camera.near *= factor;
    camera.far *= factor;
    const HardCase twin =
        changed(hard, "times 2^" + std::to_string(exponent), camera, [factor](auto& positions, auto&) {
            for (dvec3& p : positions) p = {p.x * factor, p.y * factor, p.z * factor};
        });
    EXPECT_EQ(difference(picture, agreedPicture(twin, Effort::Some)), "") << twin.word;
}

void expectShiftedTwin(const HardCase& hard, const Picture& picture, TwinDepth depth)
{
    const int right = 5, down = hard.height() / 2 * 3;  // four times the height keeps the focal factor exact
    if (hard.height() % 2 != 0 || 4 * hard.height() > kMaxPictureSide)
        throw std::logic_error("no such twin: " + hard.word);
    Camera camera = hard.camera;
    camera.width += 2 * right;
    camera.height *= 4;
    camera.focal /= 4;
    const HardCase twin  = changed(hard, "in a larger picture", camera, [](auto&, auto&) {});
    const Picture  large = agreedPicture(twin, Effort::Some);
    Picture        middle{Grid<std::int64_t>(hard.width(), hard.height()), Grid<float>(hard.width(), hard.height())};
    std::int64_t   steps = 0;
    for (int y = 0; y < hard.height(); ++y)
        for (int x = 0; x < hard.width(); ++x) {
            middle.ids.at(x, y)   = large.ids.at(x + right, y + down);
            middle.depth.at(x, y) = large.depth.at(x + right, y + down);
            if (depth == TwinDepth::Same) continue;
            steps = std::max(steps, std::abs(depthSteps(picture.depth.at(x, y), middle.depth.at(x, y))));
            middle.depth.at(x, y) = picture.depth.at(x, y);
        }
    EXPECT_EQ(difference(picture, middle), "") << twin.word;
    EXPECT_LE(steps, 1) << twin.word;
}

void expectReversedTwin(const HardCase& hard, const Picture& picture, TwinDepth depth)
{
    const HardCase twin     = changed(hard, "faces reversed", hard.camera, [](auto&, auto& triangles) {
        for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
    });
    Picture        reversed = agreedPicture(twin, Effort::Some);
    std::int64_t   steps    = 0;
    if (depth == TwinDepth::WithinOneStep) {
        for (std::size_t i = 0; i < reversed.depth.values().size(); ++i)
            steps = std::max(steps, std::abs(depthSteps(picture.depth.values()[i], reversed.depth.values()[i])));
        reversed.depth = picture.depth;
    }
    EXPECT_EQ(difference(picture, reversed), "") << twin.word;
    EXPECT_LE(steps, 1) << twin.word;
}

void expectShuffledTwin(const HardCase& hard, const Picture& picture, std::uint64_t seed)
{
    std::vector<std::uint32_t> order(hard.mesh().triangles.size());  // order[new id] = old id
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937_64 random(seed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    const HardCase twin =
        changed(hard, "shuffled with seed " + std::to_string(seed), hard.camera, [&order](auto&, auto& triangles) {
            const auto original = triangles;
            for (std::size_t i = 0; i < order.size(); ++i) triangles[i] = original[order[i]];
        });
    const Picture shuffled = agreedPicture(twin, Effort::Some);
    EXPECT_EQ(difference({picture.ids, picture.depth}, {picture.ids, shuffled.depth}), "") << twin.word << ": depths";

    int checked = 0;
    for (int y = 0; y < picture.ids.height() && checked < 200; ++y)
        for (int x = 0; x < picture.ids.width() && checked < 200; ++x) {
            const std::int64_t before = picture.ids.at(x, y), drawn = shuffled.ids.at(x, y);
            const std::int64_t after = drawn < 0 ? -1 : std::int64_t{order[static_cast<std::size_t>(drawn)]};
            if (before == after) continue;
            ++checked;
            const auto all = coveringTriangles(*hard.scene, hard.camera, FaceCulling::None, {x, y});
            ASSERT_TRUE(all.ok());
            const bool isTied = std::ranges::any_of(*all, [&](const CoveringTriangle& c) {
                return c.triangle.value == after && c.kept && c.depth == picture.depth.at(x, y);
            });
            EXPECT_TRUE(isTied && before < after)
                << twin.word << ": pixel (" << x << ", " << y << ") shows " << after << " instead of " << before;
        }
}

void expectTwins(const HardCase& hard, const Picture& picture, TwinDepth depth)
{
    expectScaledTwin(hard, picture, 20);
    expectScaledTwin(hard, picture, -33);
    expectShiftedTwin(hard, picture, depth);
    expectReversedTwin(hard, picture, depth);
    expectShuffledTwin(hard, picture);
}

void expectCoveredAtMostOnce(const HardCase& hard)
{
    const auto      count = static_cast<std::uint32_t>(hard.scene->triangleCount());
    const Grid<int> whole = coverageOf(agreedPicture(hard, Effort::Some));
    for (std::uint32_t bit = 1; bit < count; bit *= 2) {
        const auto half = [&](std::uint32_t wanted) {
            return coverageOf(
                agreedPicture(only(hard, [&](std::uint32_t id) { return (id & bit) == wanted; }), Effort::Some));
        };
        Grid<int>       together = half(0);
        const Grid<int> with     = half(bit);
        for (std::size_t i = 0; i < with.values().size(); ++i) together.values()[i] += with.values()[i];
        expectCoverage(whole, together, hard.word + ": two triangles on one pixel");
    }
}

void expectCoverage(const Grid<int>& expected, const Grid<int>& actual, const std::string& what)
{
    for (int y = 0; y < expected.height(); ++y)
        for (int x = 0; x < expected.width(); ++x)
            if (expected.at(x, y) != actual.at(x, y)) {
                ADD_FAILURE() << what << ": pixel (" << x << ", " << y << ") is covered " << actual.at(x, y)
                              << " times, expected " << expected.at(x, y);
                return;
            }
}

std::vector<GridTriangle> gridTriangles(const HardCase& hard)
{
    std::vector<GridTriangle> all;
    for (const auto& triangle : hard.mesh().triangles) {
        GridTriangle seen{};
        for (std::size_t i = 0; i < 3; ++i) {
            const dvec3& p = hard.mesh().positions[triangle[i]];
            seen.corner[i] = snapped(hard.width() * 0.5 + p.x / -p.z, hard.height() * 0.5 - p.y / -p.z);
            seen.depth[i]  = hard.camera.near / -p.z;
        }
        all.push_back(seen);
    }
    return all;
}

void expectWinners(const HardCase& hard, const Picture& picture)
{
    const ExactPicture exact   = winners(gridTriangles(hard), hard.width(), hard.height());
    std::int64_t       unclear = 0;
    for (int y = 0; y < hard.height(); ++y)
        for (int x = 0; x < hard.width(); ++x) {
            unclear += exact.unclear.at(x, y);
            if (exact.unclear.at(x, y)) continue;
            ASSERT_EQ(exact.ids.at(x, y), picture.ids.at(x, y)) << hard.word << " at (" << x << ", " << y << ")";
            if (exact.ids.at(x, y) < 0) continue;
            const auto nearest = static_cast<float>(exact.depth.at(x, y));
            ASSERT_LE(std::abs(depthSteps(nearest, picture.depth.at(x, y))), 1)
                << hard.word << " at (" << x << ", " << y << ")";
        }
    EXPECT_LE(unclear, hard.width() * hard.height() / 20) << hard.word << ": too little is clear to judge by";
}

std::int64_t depthSteps(float a, float b)
{
    return std::int64_t{std::bit_cast<std::int32_t>(b)} - std::bit_cast<std::int32_t>(a);
}

}  // namespace zscope::hardcase
