// What the generated scenes promise: strict words, the same bits for the same word, the counts that are stated, closed
// and outward surfaces, and limits told before memory is taken.
#include "core/scene/generators/registry.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

Scene made(const std::string& word)
{
    auto scene = loadScene("builtin:" + word);
    EXPECT_TRUE(scene.ok()) << word << ": " << (scene.ok() ? "" : scene.error().text());
    return scene.ok() ? std::move(scene).value() : Scene{};
}

double scalarProduct(const dvec3& a, const dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
dvec3  normalOf(const Mesh& mesh, const std::array<std::uint32_t, 3>& t)
{
    const dvec3 a = mesh.positions[t[1]] - mesh.positions[t[0]], b = mesh.positions[t[2]] - mesh.positions[t[0]];
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Edges of polygons that have no partner running the other way: 0 for a closed surface turned one way.
std::size_t openEdges(const Mesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::uint32_t p = 0; p < mesh.polygonCount(); ++p) {
        const auto outline = mesh.polygon(PolygonId{p});
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const std::uint32_t a = outline[i], b = outline[(i + 1) % outline.size()];
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& e) { return e.second != 0; }));
}

TEST(Generators, EverySceneLoadsByItsWordAndByItsWrittenDefaults)
{
    std::set<std::string_view> names;
    for (const SceneEntry& entry : builtinScenes()) {
        const std::string name(entry.name);
        EXPECT_TRUE(names.insert(entry.name).second) << name << " is there twice";
        EXPECT_FALSE(entry.title.empty()) << name;
        const Scene plain = made(name);
        EXPECT_EQ(plain.name, "builtin:" + name);
        ASSERT_FALSE(plain.views.empty()) << name;
        for (const NamedView& view : plain.views) {
            const auto camera = makeCamera(view.view, plain.bounds);
            EXPECT_TRUE(camera.ok()) << name << ", " << view.name << ": " << (camera.ok() ? "" : camera.error().text());
        }
        if (!entry.parameters.empty()) {
            EXPECT_EQ(made(name + "?" + std::string(entry.parameters)).digest, plain.digest) << name;
        }
        EXPECT_EQ(made(name).digest, plain.digest) << name << " is another scene the second time";
    }
    for (const char* name : {"cubes", "cube", "teapot", "soccer-ball", "icosphere", "soccer-field", "city", "soup",
                             "layers", "wall-and-city", "hole-in-wall", "rows", "million", "office-tower"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Generators, WrongWordsAreRefusedWithWhatWouldHaveBeenRight)
{
    struct Case {
        const char* word;
        const char* says;
    };
    for (const auto& [word, words] : {Case{"teapott", "teapot"},
                                      Case{"soccer", "soccer-ball"},
                                      Case{"zzzzzzzzzzzz", "cubes"},
                                      Case{"teapot?size=3", "tessellation=10"},
                                      Case{"teapot?tessellation", "needs a value"},
                                      Case{"teapot?tessellation=", "from 1 to 1000"},
                                      Case{"teapot?tessellation=ten", "from 1 to 1000"},
                                      Case{"teapot?tessellation=1001", "from 1 to 1000"},
                                      Case{"teapot?tessellation=0", "from 1 to 1000"},
                                      Case{"teapot?tessellation=3.5", "whole number"},
                                      Case{"teapot?tessellation= 3", "whole number"},
                                      Case{"teapot?tessellation=99999999999999999999", "whole number"},
                                      Case{"teapot?tessellation=3&tessellation=3", "twice"},
                                      Case{"teapot?tessellation=3&", "x"},
                                      Case{"cubes?count=3", "no parameters"},
                                      Case{"layers?order=left", "front, back"},
                                      Case{"soup?size=nan", "a number from"},
                                      Case{"soup?size=inf", "a number from"},
                                      Case{"soup?size=1e-7", "a number from"},
                                      Case{"soup?seed=-1", "from 0"}}) {
        const auto scene = loadScene(std::string("builtin:") + word);
        if (std::string_view(words) == "x") {  // an '&' at the end gives nothing more
            EXPECT_TRUE(scene.ok()) << word;
            continue;
        }
        ASSERT_FALSE(scene.ok()) << word;
        EXPECT_EQ(scene.error().kind, Trouble::Usage) << word;
        EXPECT_NE(scene.error().sentence.find(words), std::string::npos) << word << ": " << scene.error().sentence;
    }
}

TEST(Generators, SeedsMakeDifferentScenes)
{
    for (const char* name : {"soccer-field", "soup", "city"}) {
        const std::string word =
            std::string(name) + (std::string(name) == "city" ? "?blocks=3&seed=" : "?count=50&seed=");
        EXPECT_NE(made(word + "1").digest, made(word + "2").digest) << name;
    }
}

TEST(Generators, MemoryLimitIsToldBeforeMemoryIsTaken)
{
    const auto before = std::chrono::steady_clock::now();
    for (const char* word :
         {"teapot?tessellation=1000", "soccer-field?count=1200000", "city?blocks=200", "soup?count=50000000",
          "layers?count=1000000", "wall-and-city?blocks=200", "rows?nx=500&ny=500&nz=500", "million?faces=50000000",
          "icosphere?frequency=700", "office-tower?n=65"}) {
        const auto scene = loadScene(std::string("builtin:") + word, {.memoryLimit = 16 << 20});
        ASSERT_FALSE(scene.ok()) << word;
        EXPECT_EQ(scene.error().kind, Trouble::Limit) << word;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(1));
}

TEST(Generators, CancelledWorkStops)
{
    std::atomic<bool> cancel = true;
    for (const char* word :
         {"city", "soccer-field", "teapot", "soup", "wall-and-city", "rows", "million", "office-tower"}) {
        const auto scene = loadScene(std::string("builtin:") + word, {.progress = {.cancel = &cancel}});
        ASSERT_FALSE(scene.ok());
        EXPECT_EQ(scene.error().kind, Trouble::Cancelled);
    }
}

TEST(Teapot, HasNewellsBoxAndTheCountOfItsTessellation)
{
    const Scene pot = made("teapot?tessellation=10");
    EXPECT_EQ(pot.triangleCount(), 6320u);  // 32 x 100 quads, of which 8 x 10 are triangles at the poles
    EXPECT_NEAR(pot.bounds.min.x, -3.0, 1e-6);
    EXPECT_NEAR(pot.bounds.max.x, 3.434, 1e-6);
    EXPECT_NEAR(pot.bounds.min.y, 0.0, 1e-6);
    EXPECT_NEAR(pot.bounds.max.y, 3.15, 1e-6);
    EXPECT_NEAR(pot.bounds.min.z, -2.0, 1e-6);
    EXPECT_NEAR(pot.bounds.max.z, 2.0, 1e-6);
    EXPECT_EQ(made("teapot?tessellation=1").meshes[0]->polygonCount(), 32u);
}

TEST(Teapot, HasNoCracksBetweenPatches)
{
    for (int cells : {2, 3, 10, 17}) {  // with 1 the halves of handle and spout lie on each other
        const Scene pot = made("teapot?tessellation=" + std::to_string(cells));
        // Open rims: the rim's inner circle and the lid's edge, both ends of the handle and of the spout.
        EXPECT_EQ(openEdges(*pot.meshes[0]),
                  static_cast<std::size_t>(4 + 4 + 2 + 2 + 2 + 2) * static_cast<std::size_t>(cells))
            << cells;
    }
}

TEST(Teapot, BodyFacesOutwards)
{
    const Scene pot    = made("teapot");
    const Mesh& mesh   = *pot.meshes[0];
    int         inward = 0, faces = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::string& group = mesh.groups[mesh.polygonGroup[mesh.trianglePolygon[t].value].value];
        if (group != "body" && group != "bottom") continue;
        const dvec3 middle = (mesh.positions[mesh.triangles[t][0]] + mesh.positions[mesh.triangles[t][1]]
                              + mesh.positions[mesh.triangles[t][2]])
                             * (1.0 / 3);
        ++faces;
        inward += scalarProduct(normalOf(mesh, mesh.triangles[t]), middle - dvec3{0, 1.2, 0}) <= 0;
    }
    EXPECT_GT(faces, 1500);
    EXPECT_EQ(inward, 0);
}

TEST(SoccerBall, IsAClosedSurfaceOfTwelvePentagonsAndTwentyHexagonsTurnedOutwards)
{
    const Scene scene = made("soccer-ball");
    const Mesh& ball  = *scene.meshes[0];
    EXPECT_EQ(ball.triangles.size(), 3536u);
    EXPECT_EQ(openEdges(ball), 0u);
    std::map<std::size_t, int> corners;
    for (std::uint32_t p = 0; p < ball.polygonCount(); ++p) ++corners[ball.polygon(PolygonId{p}).size()];
    EXPECT_EQ(corners[5], 12);
    EXPECT_EQ(corners[6], 20);
    EXPECT_GT(corners[4], 1000);
    for (const auto& t : ball.triangles) EXPECT_GT(scalarProduct(normalOf(ball, t), ball.positions[t[0]]), 0);
    for (const dvec3& p : ball.positions) EXPECT_NEAR(std::sqrt(scalarProduct(p, p)), 0.9925, 0.0076);
    // Euler: vertices - edges + faces = 2.
    std::size_t sides = 0;
    for (const auto& [n, count] : corners) sides += n * static_cast<std::size_t>(count);
    EXPECT_EQ(ball.positions.size() + ball.polygonCount(), sides / 2 + 2);
}

TEST(SoccerField, HoldsOneBallOnceAndEveryBallHasAPlaceAndAColour)
{
    const Scene field = made("soccer-field?count=1000&seed=1");
    EXPECT_EQ(field.meshes.size(), 1u);
    EXPECT_EQ(field.instances.size(), 1000u);
    EXPECT_EQ(field.triangleCount(), 3'536'000u);
    EXPECT_EQ(field.views[0].view.width, 1024);
    EXPECT_EQ(field.views[0].view.height, 768);
    for (const Instance& ball : field.instances) EXPECT_TRUE(ball.colour.has_value());
}

TEST(Icosphere, HasTwentyTimesTheSquareOfItsFrequencyAllTurnedOutwardsAndClosed)
{
    for (const char* word :
         {"icosphere?frequency=1", "icosphere?frequency=2", "icosphere?frequency=7&bumps=0.3", "icosphere"}) {
        const Scene       scene = made(word);
        const Mesh&       ball  = *scene.meshes[0];
        const std::size_t n     = std::string(word) == "icosphere" ? 16 : std::string(word)[20] - std::size_t{'0'};
        EXPECT_EQ(ball.triangles.size(), 20 * n * n) << word;
        EXPECT_EQ(ball.positions.size(), 10 * n * n + 2) << word;
        EXPECT_EQ(openEdges(ball), 0u) << word;
        double smallest = 1e9, largest = 0;
        for (const auto& triangle : ball.triangles) {
            const dvec3  normal = normalOf(ball, triangle);
            const double area   = std::sqrt(scalarProduct(normal, normal));
            EXPECT_GT(scalarProduct(normal, ball.positions[triangle[0]]), 0) << word;
            smallest = std::min(smallest, area);
            largest  = std::max(largest, area);
        }
        EXPECT_LT(largest, smallest * (std::string(word).ends_with("0.3") ? 20 : 5)) << word;
    }
}

TEST(Icosphere, LeavesTrianglesOutAroundTheBottomOnly)
{
    const Scene whole = made("icosphere?frequency=59&bumps=0.25"),
                open  = made("icosphere?frequency=59&bumps=0.25&left-out=169");
    EXPECT_EQ(whole.triangleCount(), 69'620u);
    EXPECT_EQ(open.triangleCount(), 69'451u);
    EXPECT_EQ(openEdges(*open.meshes[0]), 3u * 13);
    std::set<std::array<double, 3>> left;
    for (const dvec3& p : open.meshes[0]->positions) left.insert({p.x, p.y, p.z});
    for (const dvec3& p : whole.meshes[0]->positions) {
        if (left.contains({p.x, p.y, p.z})) continue;
        EXPECT_LT(p.y, -0.75 * std::sqrt(scalarProduct(p, p)));
    }
    EXPECT_EQ(whole.meshes[0]->positions.size() - left.size(), 66u) << "those that only the triangles left out had";
    EXPECT_EQ(loadScene("builtin:icosphere?frequency=3&left-out=9").error().kind, Trouble::Usage);
}

TEST(SoccerField, TakesTheOtherBallToTheSamePlaces)
{
    const Scene soccer = made("soccer-field"), other = made("soccer-field?ball=icosphere");
    EXPECT_EQ(other.triangleCount(), 5'120'000u);
    for (std::size_t i = 0; i < soccer.instances.size(); ++i)
        EXPECT_EQ(other.instances[i].toWorld, soccer.instances[i].toWorld);
}

TEST(Million, OneGentleSheetFacesTheEyeEverywhere)
{
    const Scene scene = made("million?sheets=1&height=0.75");
    const Mesh& sheet = *scene.meshes[0];
    EXPECT_EQ(sheet.triangles.size(), 1'000'000u);
    std::size_t away = 0;
    // the eye is at 0
    for (const auto& triangle : sheet.triangles)
        away += scalarProduct(normalOf(sheet, triangle), sheet.positions[triangle[0]]) >= 0;
    EXPECT_EQ(away, 0u);
}

TEST(SoccerField, GoodPartOfTheBallsIsInTheDefaultView)
{
    const Scene field  = made("soccer-field");
    const auto  camera = makeCamera(field.views[0].view, field.bounds);
    ASSERT_TRUE(camera.ok());
    int inside = 0;
    for (const Instance& ball : field.instances) {
        const dvec3  d = ball.toWorld({0, 0, 0}) - camera->eye;
        const double z = scalarProduct(camera->forward, d);
        inside += z > 1 && std::abs(scalarProduct(camera->right, d)) * camera->focal < z * 4 / 3
                  && std::abs(scalarProduct(camera->up, d)) * camera->focal < z;
    }
    EXPECT_GT(inside, 200);
    EXPECT_LT(inside, 600);
}

TEST(SoccerField, AMillionBallsFitInAGibibyteEachInAColourOfItsOwn)
{
    const auto field = loadScene("builtin:soccer-field?count=1000000", {.memoryLimit = std::uint64_t{1} << 30});
    ASSERT_TRUE(field.ok()) << field.error().text();
    EXPECT_EQ(field->triangleCount(), 3'536'000'000u);
    const std::size_t bytes =
        field->instances.capacity() * sizeof(Instance) + field->firstTriangle.capacity() * sizeof(std::uint32_t);
    EXPECT_LT(bytes, std::size_t{200} << 20);

    const auto        byte = [](float level) { return static_cast<std::size_t>(std::lround(level * 255)); };
    std::vector<bool> isTaken(std::size_t{1} << 24);
    std::size_t       colours = 0;
    for (const Instance& ball : field->instances) {
        auto taken = isTaken[byte(ball.colour->r) << 16 | byte(ball.colour->g) << 8 | byte(ball.colour->b)];
        colours += !taken;
        taken = true;
    }
    EXPECT_EQ(colours, 1'000'000u) << "the colour of a ball is its number";
}

TEST(City, HasAboutHalfAMillionTrianglesAndTheMemoryCheckIsNotBelowThem)
{
    const Scene city = made("city");
    EXPECT_NEAR(static_cast<double>(city.triangleCount()), 500'000, 50'000);
    for (int seed = 1; seed <= 20; ++seed)
        EXPECT_LT(made("city?blocks=5&seed=" + std::to_string(seed)).triangleCount(), 25u * 7500u) << seed;
}

TEST(City, IsMadeOfPolygonsOfManyKindsAndMaterialsWithTwoViews)
{
    const Scene                scene = made("city?blocks=6");
    const Mesh&                city  = *scene.meshes[0];
    std::map<std::size_t, int> corners;
    std::set<std::uint32_t>    materials;
    for (std::uint32_t p = 0; p < city.polygonCount(); ++p) {
        ++corners[city.polygon(PolygonId{p}).size()];
        materials.insert(city.polygonMaterial[p].value);
    }
    for (std::size_t n : {3u, 4u, 5u, 6u, 8u, 12u}) EXPECT_GT(corners[n], 0) << n;
    EXPECT_GE(materials.size(), 12u);
    EXPECT_EQ(scene.views.size(), 2u);
    EXPECT_EQ(scene.views[1].name, "street");
}

TEST(City, DefaultViewLooksDownAtFortyFiveDegrees)
{
    const Scene city   = made("city");
    const auto  camera = makeCamera(city.views[0].view, city.bounds);
    ASSERT_TRUE(camera.ok());
    EXPECT_NEAR(camera->forward.y, -std::sqrt(0.5), 0.05);
}

TEST(Soup, HasWhatItPromises)
{
    const Scene scene = made("soup?count=5000&seed=3");
    const Mesh& soup  = *scene.meshes[0];
    ASSERT_EQ(soup.triangles.size(), 5000u);
    int    crossing = 0;
    double least = 1e9, most = 0;
    for (const auto& t : soup.triangles) {
        double low = 1e9, high = -1e9, size = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            low              = std::min(low, soup.positions[t[k]].z);
            high             = std::max(high, soup.positions[t[k]].z);
            const dvec3 edge = soup.positions[t[(k + 1) % 3]] - soup.positions[t[k]];
            size             = std::max(size, std::sqrt(scalarProduct(edge, edge)));
        }
        crossing += low < 23 && high > 23;  // the near plane of the default view
        least = std::min(least, size);
        most  = std::max(most, size);
    }
    EXPECT_GT(crossing, 300);
    EXPECT_GT(most / least, 300);
    EXPECT_LT(soup.positions.size(), 3 * soup.triangles.size());  // corners are shared
    // A smaller soup is the beginning of a larger one.
    const Scene start = made("soup?count=100&seed=3");
    for (std::size_t t = 0; t < 100; ++t) EXPECT_EQ(start.meshes[0]->triangles[t], soup.triangles[t]);
}

TEST(Layers, EachCoversTheWholePictureAndTheOrderIsTheOneAskedFor)
{
    for (const bool frontFirst : {true, false}) {
        const Scene scene  = made(std::string("layers?count=7&order=") + (frontFirst ? "front" : "back"));
        const Mesh& layers = *scene.meshes[0];
        ASSERT_EQ(layers.polygonCount(), 7u);
        const auto camera = makeCamera(scene.views[0].view, scene.bounds);
        ASSERT_TRUE(camera.ok());
        double before = 0;
        for (std::uint32_t p = 0; p < 7; ++p) {
            const dvec3  low = layers.positions[layers.polygon(PolygonId{p})[0]];
            const double z   = -low.z;
            EXPECT_GT(-low.x * camera->focal / z, 1280.0 / 720);
            EXPECT_GT(-low.y * camera->focal / z, 1);
            if (p > 0) {
                EXPECT_EQ(z > before, frontFirst);
            }
            before = z;
        }
    }
}

TEST(WallAndCity, TheWallHidesAlmostTheWholePicture)
{
    const Scene scene = made("wall-and-city?blocks=3");
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[1]->triangles.size(), made("city?blocks=3").meshes[0]->triangles.size());
    // Seen from the eye the wall reaches from the left edge to nine tenths of the picture, and over its top.
    const auto camera = makeCamera(scene.views[0].view, scene.bounds);
    ASSERT_TRUE(camera.ok());
    double left = 0, right = 0, top = 0;
    for (const dvec3& p : scene.meshes[0]->positions) {
        if (p.y < 13) continue;
        const dvec3  d = p - camera->eye;
        const double z = scalarProduct(camera->forward, d);
        left           = std::min(left, scalarProduct(camera->right, d) / z * camera->focal);
        right          = std::max(right, scalarProduct(camera->right, d) / z * camera->focal);
        top            = std::max(top, scalarProduct(camera->up, d) / z * camera->focal);
    }
    EXPECT_LT(left, -16.0 / 9);
    EXPECT_GT(top, 1);
    EXPECT_GT(right, 0.75 * 16 / 9);
    EXPECT_LT(right, 0.95 * 16 / 9);
}

TEST(HoleInWall, ExactlyTheHoleOfItsLevelIsNotWall)
{
    for (int level = 0; level <= 8; ++level) {
        const Scene scene = made("hole-in-wall?level=" + std::to_string(level));
        const Mesh& wall  = *scene.meshes[1];
        double      area  = 0;
        for (const auto& t : wall.triangles) area += 0.5 * std::abs(normalOf(wall, t).z);
        EXPECT_EQ(area, 512.0 * 512 - std::pow(4.0, level)) << level;
        for (const dvec3& p : wall.positions) EXPECT_EQ(p.z, -256);
    }
}

TEST(Rows, HoldTheModelOnceAndAsManyInstancesAsAskedFor)
{
    for (const char* model : {"soccer-ball", "teapot", "cube"}) {
        const Scene rows = made(std::string("rows?nx=3&ny=4&nz=5&model=") + model);
        EXPECT_EQ(rows.meshes.size(), 1u);
        EXPECT_EQ(rows.instances.size(), 60u);
        EXPECT_EQ(rows.triangleCount(), 60 * made(model).triangleCount());
        EXPECT_LT(rows.instances.front().toWorld.rows[2][3], rows.instances.back().toWorld.rows[2][3])
            << "the farthest row first";
    }
}

TEST(Million, HasAMillionFacesOfOneMeshAndSixteenSheetsThatFillThePicture)
{
    const Scene scene = made("million");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& mesh = *scene.meshes[0];
    EXPECT_EQ(mesh.polygonCount(), 1'000'000u);
    EXPECT_EQ(mesh.triangles.size(), 1'000'000u);
    const auto camera = makeCamera(scene.views[0].view, scene.bounds);
    ASSERT_TRUE(camera.ok());
    // The area of each sheet that lies within the picture is the whole picture: its border lies outside.
    constexpr std::uint32_t kColumns = 251, kRows = 126;
    for (std::uint32_t sheet = 0; sheet < 16; ++sheet)
        for (std::uint32_t v = 0; v < kColumns * kRows; ++v) {
            const std::uint32_t i = v % kColumns, j = v / kColumns;
            const dvec3&        p = mesh.positions[sheet * kColumns * kRows + v];
            if (i == 0 || i == kColumns - 1) {
                ASSERT_GT(std::abs(p.x) * camera->focal / -p.z, 16.0 / 9);
            }
            if (j == 0 || j == kRows - 1) {
                ASSERT_GT(std::abs(p.y) * camera->focal / -p.z, 1);
            }
        }
    EXPECT_LE(made("million?faces=12345").triangleCount(), 12345u);
}

TEST(OfficeTower, IsHalfABillionTrianglesInAFewMebibytes)
{
    const auto tower = loadScene("builtin:office-tower", {.memoryLimit = 32 << 20});
    ASSERT_TRUE(tower.ok()) << tower.error().text();
    EXPECT_EQ(tower->instances.size(), 35'937u);
    EXPECT_EQ(tower->triangleCount() / 1'000'000, 538u);
    EXPECT_NEAR(static_cast<double>(tower->meshes[0]->triangles.size()), 15'000, 100);
    EXPECT_LT(tower->instances.capacity() * sizeof(Instance), std::size_t{6} << 20);
    EXPECT_EQ(openEdges(*tower->meshes[0]), 0u) << "all of it boxes and posts";
    EXPECT_TRUE(loadScene("builtin:office-tower?n=65").ok())
        << "the largest one has fewer triangles than there are ids";
}

TEST(Random, IsTheSequenceOfSplitMix64)
{
    Random random(1234567);  // the published test values
    EXPECT_EQ(random.bits(), 6457827717110365317u);
    EXPECT_EQ(random.bits(), 3203168211198807973u);
    EXPECT_EQ(random.bits(), 9817491932198370423u);
}

TEST(Circle, PointsAreWithinAFewUnitsOfTheLastPlace)
{
    for (int i = -720; i <= 720; ++i) {
        const auto [c, s]       = pointOnCircle(i / 360.0);
        const long double angle = 2 * 3.14159265358979323846264338327950288L * i / 360;
        EXPECT_NEAR(c, static_cast<double>(std::cos(angle)), 1e-15) << i;
        EXPECT_NEAR(s, static_cast<double>(std::sin(angle)), 1e-15) << i;
    }
    EXPECT_EQ(pointOnCircle(0.25), (std::array<double, 2>{-0.0, 1.0}));
}

}  // namespace
}  // namespace zscope
