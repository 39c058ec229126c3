// Matrices of OpenGL, Direct3D and Vulkan give back the camera they were made from, in either order and for every depth
// range; what is no camera is refused with its reason.
#include <glm/geometric.hpp>

#include "core/check/matrix_camera.h"
#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

using check::CameraMatrices, check::DepthRange, check::Matrix, check::MatrixOrder;

enum class Hand { Right, Left };  // looks along -z, along +z

struct Style {
    Hand        hand    = Hand::Right;
    DepthRange  range   = DepthRange::MinusOneToOne;
    MatrixOrder order   = MatrixOrder::Rows;
    bool        isYDown = false;
};

Matrix inOrder(const Matrix& rows, MatrixOrder order)
{
    if (order == MatrixOrder::Rows) return rows;
    Matrix columns{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) columns[4 * c + r] = rows[4 * r + c];
    return columns;
}

Matrix viewRows(const Camera& c, Hand hand)
{
    const dvec3 z  = hand == Hand::Right ? -c.forward : c.forward;
    const auto  at = [&](const dvec3& axis) { return -glm::dot(axis, c.eye); };
    return {c.right.x, c.right.y, c.right.z, at(c.right), c.up.x, c.up.y, c.up.z, at(c.up),
            z.x,       z.y,       z.z,       at(z),       0,      0,      0,      1};
}

Matrix projectionRows(const Camera& c, const Style& style)
{
    const double s = style.hand == Hand::Right ? -1 : 1, n = c.near, f = c.far;
    // z_clip / w = a + b/z
    double a = 1, b = -2 * n;
    if (!std::isinf(f)) a = (f + n) / (f - n), b = -2 * f * n / (f - n);
    if (style.range == DepthRange::ZeroToOne)
        a = std::isinf(f) ? 1 : f / (f - n), b = std::isinf(f) ? -n : -f * n / (f - n);
    if (style.range == DepthRange::Reversed)
        a = std::isinf(f) ? 0 : -n / (f - n), b = std::isinf(f) ? n : f * n / (f - n);
    return {
        c.focal * c.height / c.width, 0, 0, 0, 0, style.isYDown ? -c.focal : c.focal, 0, 0, 0, 0, s * a, b, 0, 0, s, 0};
}

Matrix product(const Matrix& a, const Matrix& b)
{
    Matrix p{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t k = 0; k < 4; ++k) p[4 * r + c] += a[4 * r + k] * b[4 * k + c];
    return p;
}

Camera someCamera(double far)
{
    ViewRequest view;
    view.eye = dvec3{3, -2, 7}, view.target = dvec3{0.5, 1, -1}, view.verticalFov = 50;
    view.near = 0.25, view.far = far, view.width = 333, view.height = 217;
    return *makeCamera(view, Bounds{});
}

void expectSame(const Camera& found, const Camera& camera, const std::string& what)
{
    const auto near = [&](const dvec3& a, const dvec3& b) {
        EXPECT_LT(glm::length(a - b), 1e-9 * (1 + glm::length(b))) << what;
    };
    near(found.eye, camera.eye), near(found.right, camera.right), near(found.up, camera.up),
        near(found.forward, camera.forward);
    EXPECT_NEAR(found.focal, camera.focal, 1e-9) << what;
    EXPECT_NEAR(found.near, camera.near, 1e-9) << what;
    if (std::isinf(camera.far))
        EXPECT_TRUE(std::isinf(found.far)) << what;
    else
        EXPECT_NEAR(found.far / camera.far, 1, 1e-6) << what;
    EXPECT_EQ(found.width, camera.width) << what;
    EXPECT_EQ(found.height, camera.height) << what;
}

TEST(Matrices, GiveBackTheCameraTheyWereMadeFrom)
{
    for (const double far : {40.0, HUGE_VAL})
        for (const Hand hand : {Hand::Right, Hand::Left})
            for (const DepthRange range : {DepthRange::MinusOneToOne, DepthRange::ZeroToOne, DepthRange::Reversed})
                for (const MatrixOrder order : {MatrixOrder::Rows, MatrixOrder::Columns})
                    for (const bool isYDown : {false, true}) {
                        const Camera      camera = someCamera(far);
                        const Style       style{hand, range, order, isYDown};
                        const Matrix      view = viewRows(camera, hand), projection = projectionRows(camera, style);
                        const std::string what = std::to_string(static_cast<int>(range))
                                                 + (order == MatrixOrder::Rows ? " rows" : " columns")
                                                 + (isYDown ? " down" : "") + (hand == Hand::Left ? " left" : "");
                        for (const bool isSaid : {true, false}) {
                            CameraMatrices matrices{inOrder(view, order), inOrder(projection, order), {}, {}, {}};
                            if (isSaid) matrices.order = order, matrices.range = range;
                            const auto cameras = check::camerasOf(matrices, 333, 217, "m.json");
                            ASSERT_TRUE(cameras) << what << cameras.error().text();
                            if (isSaid || range == DepthRange::Reversed) {
                                ASSERT_EQ(cameras->size(), 1u) << what;
                                expectSame(cameras->front(), camera, what);
                            } else {
                                // -1..1 and 0..1 cannot be told apart by the matrix: both are given back
                                ASSERT_EQ(cameras->size(), 2u) << what;
                                const bool first = std::abs(cameras->front().near - camera.near) < 1e-9;
                                expectSame((*cameras)[first ? 0 : 1], camera, what);
                            }
                        }
                        if (isYDown) continue;
                        CameraMatrices whole;
                        whole.clipFromWorld = inOrder(product(projection, view), order);
                        whole.range         = range;
                        const auto cameras  = check::camerasOf(whole, 333, 217, "m.json");
                        ASSERT_TRUE(cameras) << what << cameras.error().text();
                        expectSame(cameras->front(), camera, what + " whole");
                    }
}

/// Its transpose is a perspective as well, and only the size of w says which one was meant.
TEST(Matrices, OfACameraWithoutTranslationAreReadInTheirOwnOrder)
{
    Camera camera = someCamera(40);
    camera.eye    = {0, 0, 0};
    for (const MatrixOrder order : {MatrixOrder::Rows, MatrixOrder::Columns}) {
        const CameraMatrices matrices{inOrder(viewRows(camera, Hand::Right), order),
                                      inOrder(projectionRows(camera, {}), order),
                                      {},
                                      {},
                                      DepthRange::MinusOneToOne};
        const auto           cameras = check::camerasOf(matrices, 333, 217, "m.json");
        ASSERT_TRUE(cameras);
        expectSame(cameras->front(), camera, "at the origin");
    }
}

TEST(Matrices, ThatAreNoCameraAreRefusedWithTheReason)
{
    const Camera camera = someCamera(40);
    const Matrix view   = viewRows(camera, Hand::Right);
    const auto   expect = [&](Matrix projection, const std::string& reason, int width = 333) {
        for (const auto order : {std::optional(MatrixOrder::Rows), std::optional<MatrixOrder>()}) {
            const auto cameras = check::camerasOf({view, projection, {}, order, {}}, width, 217, "m.json");
            ASSERT_FALSE(cameras) << reason;
            EXPECT_EQ(cameras.error().kind, Trouble::Input);
            EXPECT_EQ(cameras.error().file, "m.json");
            EXPECT_NE(cameras.error().sentence.find(reason), std::string::npos) << cameras.error().sentence;
        }
    };
    const Matrix good = projectionRows(camera, {});
    Matrix       bad  = good;
    expect(good, "pixels are not square", 300);
    bad[2] = 0.3;
    expect(bad, "the centre of the perspective");
    bad = good, bad[1] = 0.2;
    expect(bad, "skewed");
    bad = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
    expect(bad, "no perspective");
    bad = good, bad[0] = std::nan("");
    expect(bad, "not finite");
}

TEST(Matrices, OfMalformedJsonAreRefused)
{
    const std::string sixteen = "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]";
    for (const std::string& json : {std::string("[]"), std::string("{}"), "{\"view\":" + sixteen + "}",
                                    std::string("{\"view\":[1],\"projection\":[2]}"),
                                    "{\"clip_from_world\":" + sixteen + ",\"view\":" + sixteen + "}",
                                    "{\"clip_from_world\":" + sixteen + ",\"order\":\"both\"}",
                                    "{\"clip_from_world\":" + sixteen + ",\"depth\":\"far\"}",
                                    "{\"clip_from_world\":" + sixteen + ",\"zzz\":1}", std::string("{")}) {
        const auto matrices = check::matricesOf(json, "m.json");
        ASSERT_FALSE(matrices) << json;
        EXPECT_EQ(matrices.error().kind, Trouble::Input);
        EXPECT_EQ(matrices.error().file, "m.json");
    }
}

}  // namespace
}  // namespace zscope::tests
