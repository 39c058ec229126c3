// Conventions are guessed right: every meaning of depth, both orders of rows, ids of triangles and of faces from 0 and
// from 1, culling, and the depth range of a matrix.
#include <limits>

#include <fmt/format.h>
#include <png.h>
#include <glm/geometric.hpp>

#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

using check::Conventions, check::DepthMeaning, check::IdKind, check::Rows;

const std::array<std::string, 3> kScenes{"builtin:teapot?tessellation=4", "builtin:city?blocks=3",
                                         "builtin:soccer-field?count=12"};

/// In float64, written independently of core/check.
double valueOf(DepthMeaning meaning, double z, int x, int y, const Camera& c)
{
    const double n = c.near, f = c.far, ndc = (f + n) / (f - n) - 2 * f * n / (f - n) / z;
    const double k = c.height / 2.0 * c.focal;
    const dvec3  ray{(x + 0.5 - c.width / 2.0) / k, (y + 0.5 - c.height / 2.0) / k, 1};
    switch (meaning) {
        case DepthMeaning::NearOverZ:
            return n / z;
        case DepthMeaning::Z:
            return z;
        case DepthMeaning::Distance:
            return z * glm::length(ray);
        case DepthMeaning::Ndc:
            return ndc;
        case DepthMeaning::Window:
            return (ndc + 1) / 2;
        case DepthMeaning::WindowReversed:
            return 1 - (ndc + 1) / 2;
        case DepthMeaning::Linear:
            break;
    }
    return (z - n) / (f - n);
}

class Guessed : public CheckFiles {
protected:
    Grid<double> depthsOf(const Picture& picture, const Camera& camera, DepthMeaning meaning, double background) const
    {
        Grid<double> depths(camera.width, camera.height, background);
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x)
                if (picture.ids.at(x, y) >= 0)
                    depths.at(x, y) = valueOf(meaning, camera.near / picture.depth.at(x, y), x, y, camera);
        return depths;
    }
    std::string writeFloats(const std::string& name, const Grid<double>& values, Rows rows) const
    {
        Grid<float> floats(values.width(), values.height());
        for (int y = 0; y < values.height(); ++y)
            for (int x = 0; x < values.width(); ++x)
                floats.at(x, y) = static_cast<float>(values.at(x, rows == Rows::TopDown ? y : values.height() - 1 - y));
        return writeDepth(name, floats);
    }
    /// A PNG of 16 bits, written by libpng.
    std::string writePng16(const std::string& name, const Grid<double>& values) const
    {
        FILE*       file = std::fopen(path(name).c_str(), "wb");
        png_structp png  = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
        png_infop   info = png_create_info_struct(png);
        png_init_io(png, file);
        png_set_IHDR(png, info, static_cast<png_uint_32>(values.width()), static_cast<png_uint_32>(values.height()), 16,
                     PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, info);
        for (int y = 0; y < values.height(); ++y) {
            std::string row;
            for (const double value : values.view().row(y)) {
                const auto code = static_cast<unsigned>(std::lround(value * 65535));
                row += static_cast<char>(code >> 8), row += static_cast<char>(code & 255);
            }
            png_write_row(png, reinterpret_cast<png_const_bytep>(row.data()));
        }
        png_write_end(png, nullptr);
        png_destroy_write_struct(&png, &info);
        std::fclose(file);
        return path(name);
    }
    void expectRight(check::Checker& checker, check::CheckRequest request, const Conventions& expected,
                     const std::string& what)
    {
        request.diagnoses = false;
        const auto answer = checker.check(request);
        ASSERT_TRUE(answer) << what << answer.error().text();
        EXPECT_TRUE(answer->isRight()) << what << ": " << answer->sentence;
        const auto         number = [](const auto& value) { return value ? static_cast<int>(*value) : -1; };
        const Conventions& found  = answer->conventions;
        EXPECT_EQ(number(found.depth), number(expected.depth)) << what;
        EXPECT_EQ(number(found.rows), number(expected.rows)) << what;
        EXPECT_EQ(number(found.ids), number(expected.ids)) << what;
        EXPECT_EQ(number(found.idsFrom), number(expected.idsFrom)) << what;
        EXPECT_EQ(number(found.cull), number(expected.cull)) << what;
    }
};

TEST_F(Guessed, EveryMeaningOfDepthInBothOrdersOfRows)
{
    for (const std::string& word : kScenes) {
        const auto     scene  = preparedScene(word);
        const Camera   camera = cameraOf(scene->scene(), 97, 61);
        const Picture  right  = *referencePicture(scene->scene(), camera, FaceCulling::None);
        check::Checker checker(scene);
        for (const DepthMeaning meaning : check::kDepthMeanings)
            for (const Rows rows : {Rows::TopDown, Rows::BottomUp})
                for (const double background : {0.0, 1.0, HUGE_VAL, std::nan("")}) {
                    check::CheckRequest request;
                    request.camera = camera;
                    request.depth  = writeFloats("d.npy", depthsOf(right, camera, meaning, background), rows);
                    expectRight(checker, request, {meaning, rows, {}, {}, FaceCulling::None},
                                fmt::format("{} {} {}", word, check::wordOf(meaning), background));
                }
        for (const DepthMeaning meaning :
             {DepthMeaning::Window, DepthMeaning::WindowReversed, DepthMeaning::Linear, DepthMeaning::NearOverZ}) {
            check::CheckRequest request;
            request.camera = camera;
            request.depth  = writePng16(
                 "d.png",
                 depthsOf(right, camera, meaning, meaning == DepthMeaning::Window || meaning == DepthMeaning::Linear));
            expectRight(checker, request, {meaning, Rows::TopDown, {}, {}, FaceCulling::None},
                        fmt::format("{} png {}", word, check::wordOf(meaning)));
        }
    }
}

TEST_F(Guessed, IdsOfTrianglesAndFacesFromZeroAndOne)
{
    for (const std::string& word : kScenes) {
        const auto               scene  = preparedScene(word);
        const Camera             camera = cameraOf(scene->scene(), 97, 61);
        const Picture            right  = *referencePicture(scene->scene(), camera, FaceCulling::None);
        const check::FaceNumbers faces(scene->scene());
        const bool     hasPolygons = faces.count() != static_cast<std::int64_t>(scene->scene().triangleCount());
        check::Checker checker(scene);
        for (const IdKind kind : {IdKind::Triangles, IdKind::Faces})
            for (const int from : {0, 1})
                for (const Rows rows : {Rows::TopDown, Rows::BottomUp})
                    for (const std::int64_t background : {-1, 0}) {
                        if (background == 0 && from == 0) continue;  // 0 would be an id as well
                        Grid<std::int64_t> ids(camera.width, camera.height, background);
                        for (int y = 0; y < camera.height; ++y)
                            for (int x = 0; x < camera.width; ++x) {
                                const std::int64_t id =
                                    right.ids.at(x, rows == Rows::TopDown ? y : camera.height - 1 - y);
                                if (id >= 0) ids.at(x, y) = (kind == IdKind::Faces ? faces.faceOf(id) : id) + from;
                            }
                        check::CheckRequest request;
                        request.camera        = camera;
                        request.ids           = writeIds("i.npy", ids);
                        const IdKind expected = hasPolygons ? kind : IdKind::Triangles;
                        expectRight(checker, request, {{}, rows, expected, from, FaceCulling::None},
                                    fmt::format("{} {} {}", word, static_cast<int>(kind), from));
                    }
    }
}

TEST_F(Guessed, WhetherBackFacesAreDrawn)
{
    for (const std::string word : {"builtin:hard/B5", "builtin:hard/A13", "builtin:teapot?tessellation=4"}) {
        const auto     scene  = preparedScene(word);
        const Camera   camera = cameraOf(scene->scene(), 97, 61);
        check::Checker checker(scene);
        const Picture  both = *referencePicture(scene->scene(), camera, FaceCulling::None);
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            const Picture right = *referencePicture(scene->scene(), camera, culling);
            if (std::ranges::all_of(right.ids.values(), [](std::int64_t id) { return id < 0; })) continue;
            check::CheckRequest request;
            request.camera             = camera;
            request.ids                = writeIds("i.npy", right.ids);
            const FaceCulling expected = right == both ? FaceCulling::None : culling;
            expectRight(checker, request, {{}, Rows::TopDown, IdKind::Triangles, 0, expected}, word);
        }
    }
}

/// -1..1 and 0..1 cannot be told apart by the matrix; a depth buffer tells.
TEST_F(Guessed, WhichDepthRangeAMatrixHas)
{
    for (const std::string& word : kScenes) {
        const auto     scene = preparedScene(word);
        const Camera   c     = cameraOf(scene->scene(), 97, 61);
        const Picture  right = *referencePicture(scene->scene(), c, FaceCulling::None);
        check::Checker checker(scene);
        for (const int range : {0, 1, 2})
            for (const bool byColumns : {false, true}) {
                const double n = c.near, f = c.far;
                const double a = range == 0 ? (f + n) / (f - n) : range == 1 ? f / (f - n) : -n / (f - n);
                const double b = range == 0 ? -2 * f * n / (f - n) : range == 1 ? -f * n / (f - n) : f * n / (f - n);
                std::array<std::array<double, 4>, 4> view{}, projection{};
                const std::array<dvec3, 3>           axes{c.right, c.up, -c.forward};
                for (std::size_t r = 0; r < 3; ++r)
                    view[r] = {axes[r].x, axes[r].y, axes[r].z, -glm::dot(axes[r], c.eye)};
                view[3]    = {0, 0, 0, 1};
                projection = {
                    {{c.focal * c.height / c.width, 0, 0, 0}, {0, c.focal, 0, 0}, {0, 0, -a, b}, {0, 0, -1, 0}}};
                const auto text = [&](const auto& m) {
                    std::string list;
                    for (std::size_t i = 0; i < 16; ++i)
                        list +=
                            (i ? ", " : "") + fmt::format("\"{:a}\"", byColumns ? m[i % 4][i / 4] : m[i / 4][i % 4]);
                    return "[" + list + "]";
                };
                const DepthMeaning  meaning = range == 2 ? DepthMeaning::WindowReversed : DepthMeaning::Window;
                check::CheckRequest request;
                request.matrix =
                    write("m.json", "{\"view\": " + text(view) + ", \"projection\": " + text(projection) + "}");
                request.width = c.width, request.height = c.height;
                request.depth = writeFloats("d.npy", depthsOf(right, c, meaning, range == 2 ? 0 : 1), Rows::TopDown);
                expectRight(checker, request, {meaning, Rows::TopDown, {}, {}, FaceCulling::None},
                            fmt::format("{} range {} {}", word, range, byColumns));
                const auto answer = checker.check(request);
                EXPECT_NEAR(answer->camera.near / c.near, 1, 1e-6) << word << range;
            }
    }
}

/// Where the reference leaves nothing empty, holes have to be told from surfaces by their value.
TEST_F(Guessed, WhatIsEmptyWhereTheReferenceCoversAll)
{
    const auto          scene  = preparedScene("builtin:wall-and-city");
    const Camera        camera = cameraOf(scene->scene(), 97, 61);
    const Picture       right  = *referencePicture(scene->scene(), camera, FaceCulling::None);
    check::Checker      checker(scene);
    check::CheckRequest request;
    request.camera    = camera;
    request.diagnoses = false;
    request.ids       = writeIds("i.npy", right.ids);
    request.depth     = writeDepth("d.npy", right.depth);
    EXPECT_EQ(checker.check(request)->covered, 97u * 61u);
    EXPECT_TRUE(checker.check(request)->isRight());
    Picture holed = right;
    for (int x = 20; x < 60; ++x)
        for (int y = 20; y < 40; ++y) holed.ids.at(x, y) = -1, holed.depth.at(x, y) = 0;
    request.ids   = writeIds("i.npy", holed.ids);
    request.depth = writeDepth("d.npy", holed.depth);
    EXPECT_EQ(checker.check(request)->wrong.of(check::Mistake::Hole)
                  + checker.check(request)->rounding.of(check::Mistake::Hole),
              800u);
    request.ids.reset();
    EXPECT_EQ(checker.check(request)->wrong.of(check::Mistake::Hole)
                  + checker.check(request)->rounding.of(check::Mistake::Hole),
              800u);
}

TEST_F(Guessed, NothingOfAFileThatHoldsBackgroundAlone)
{
    const auto     scene  = preparedScene(kScenes[0]);
    const Camera   camera = cameraOf(scene->scene(), 97, 61);
    check::Checker checker(scene);
    for (const float value :
         {0.0f, 1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        check::CheckRequest request;
        request.camera    = camera;
        request.depth     = writeDepth("d.npy", Grid<float>(97, 61, value));
        request.diagnoses = false;
        const auto answer = checker.check(request);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->conventions, Conventions{});
        EXPECT_EQ(answer->wrong.of(check::Mistake::Hole) + answer->rounding.of(check::Mistake::Hole), answer->covered);
        EXPECT_EQ(answer->rounding.of(check::Mistake::Hole), 0u) << "not even an outline pixel is right";
    }
}

}  // namespace
}  // namespace zscope::tests
