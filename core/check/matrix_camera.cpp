#include "core/check/matrix_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/io/json_document.h"
#include "core/io/read_file.h"

namespace zscope::check {
namespace {

constexpr std::uint64_t kMaxMatrixFile = 1 << 20;  // bytes
constexpr double        kSlack         = 1e-4;     // of a matrix in float32, and of products of such

/// Rows of a matrix that is multiplied by column vectors.
using MatrixRows = std::array<std::array<double, 4>, 4>;

MatrixRows rowsOf(const Matrix& m, MatrixOrder order)
{
    MatrixRows rows{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) rows[r][c] = order == MatrixOrder::Rows ? m[4 * r + c] : m[4 * c + r];
    return rows;
}

MatrixRows product(const MatrixRows& a, const MatrixRows& b)
{
    MatrixRows p{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t k = 0; k < 4; ++k) p[r][c] += a[r][k] * b[k][c];
    return p;
}

dvec3 directionOf(const std::array<double, 4>& row) { return {row[0], row[1], row[2]}; }

/// A perspective without its depth range.
struct Perspective {
    Camera camera;        // near and far are still missing
    double a = 0, b = 0;  // z_clip / w = a + b/z
    double w = 0;         // of a point at distance 1: 1 in every matrix as it is usually made
};

/// The answer, or the reason why this is no perspective of that size.
struct Decomposed {
    Perspective perspective;
    std::string why;
};

Decomposed decomposed(const MatrixRows& clip, int width, int height)
{
    Decomposed   d;
    const dvec3  x = directionOf(clip[0]), y = directionOf(clip[1]), z = directionOf(clip[2]), w = directionOf(clip[3]);
    const double lengthX = glm::length(x), lengthY = glm::length(y), lengthW = glm::length(w);
    const auto   refuse = [&d](std::string why) {
        d.why = std::move(why);
        return d;
    };
    for (const auto& row : clip)
        for (const double number : row)
            if (!std::isfinite(number)) return refuse("the matrix holds a number that is not finite");
    if (!(lengthW > 0) || lengthW < 1e-12 * std::max(lengthX, lengthY))
        return refuse("the matrix is no perspective: its w does not change with the distance");
    if (!(lengthX > 0) || !(lengthY > 0)) return refuse("the matrix is no perspective: it flattens the picture");
    const dvec3 right = x / lengthX, up = y / lengthY, forward = w / lengthW;
    if (std::abs(glm::dot(right, forward)) * lengthX > kSlack * 10 * lengthW * lengthX / std::min(lengthX, lengthW)
        || std::abs(glm::dot(up, forward)) * lengthY > kSlack * 10 * lengthW * lengthY / std::min(lengthY, lengthW))
        return refuse("the centre of the perspective is not in the middle of the picture");
    if (std::abs(glm::dot(right, up)) > kSlack * 10)
        return refuse("the matrix is skewed: x and y are not at right angles");
    const double focal = lengthY / lengthW, focalX = lengthX / lengthW * width / height;
    if (std::abs(focalX - focal) > 1e-3 * focal)
        return refuse(
            fmt::format("pixels are not square: the matrix is for a picture that is {:.4f} times as wide as "
                        "high, and this one is {:.4f} times",
                        lengthY / lengthX, static_cast<double>(width) / height));

    // The eye is where x, y and w vanish.
    const dvec3  yw = glm::cross(y, w), wx = glm::cross(w, x), xy = glm::cross(x, y);
    const double det = glm::dot(x, yw);
    if (!(std::abs(det) > 1e-12 * lengthX * lengthY * lengthW))
        return refuse("the matrix has no eye: it cannot be inverted");
    Camera& camera = d.perspective.camera;
    camera.eye     = -(yw * clip[0][3] + wx * clip[1][3] + xy * clip[3][3]) / det;
    camera.right   = right;
    camera.up      = up;
    camera.forward = forward;
    camera.focal   = focal;
    camera.width   = width;
    camera.height  = height;

    const double along = glm::dot(z, forward);
    if (glm::length(z - forward * along) > kSlack * 10 * std::max(glm::length(z), lengthW))
        return refuse("depth does not grow along the view: the near plane is tilted");
    d.perspective.w = lengthW;
    d.perspective.a = along / lengthW;
    d.perspective.b = (glm::dot(z, camera.eye) + clip[2][3]) / lengthW;
    return d;
}

/// The order of a matrix whose file does not name it: a view ends in the row 0 0 0 1, and a perspective's w is
/// the distance. The transpose of a perspective may be one as well, with another w.
MatrixOrder orderOf(const CameraMatrices& matrices, const Decomposed& byRows, const Decomposed& byColumns)
{
    if (matrices.view) {
        const auto isAffine = [&](MatrixOrder order) {
            const auto last = rowsOf(*matrices.view, order)[3];
            return last[0] == 0 && last[1] == 0 && last[2] == 0;
        };
        const bool rows = isAffine(MatrixOrder::Rows), columns = isAffine(MatrixOrder::Columns);
        if (rows != columns) return rows ? MatrixOrder::Rows : MatrixOrder::Columns;
    }
    if (byRows.why.empty() != byColumns.why.empty())
        return byRows.why.empty() ? MatrixOrder::Rows : MatrixOrder::Columns;
    const auto fromOne = [](const Decomposed& d) { return std::abs(d.perspective.w - 1); };
    const bool columns = byColumns.why.empty() && fromOne(byColumns) < fromOne(byRows);
    return columns ? MatrixOrder::Columns : MatrixOrder::Rows;
}

/// near and far of one reading; nothing where it has none.
std::optional<Camera> withRange(const Perspective& p, DepthRange range)
{
    Camera       camera = p.camera;
    const double atNear = range == DepthRange::MinusOneToOne ? -1 : range == DepthRange::ZeroToOne ? 0 : 1;
    const double atFar  = range == DepthRange::Reversed ? 0 : 1;
    camera.near         = p.b / (atNear - p.a);
    const double toFar  = (atFar - p.a) * (p.b > 0 ? 1 : -1);  // 0: there is no far plane; negative: rounding left none
    camera.far          = toFar > 1e-9 ? std::abs(p.b) / toFar : std::numeric_limits<double>::infinity();
    if (toFar < -1e-6 || explainInvalid(camera)) return std::nullopt;
    return camera;
}

Result<Matrix> matrixOf(const JsonValue& value, const std::string& file, std::string_view key)
{
    const JsonValue::Array* numbers = value.array();
    if (!numbers || numbers->size() != 16)
        return inputError(fmt::format("'{}' must be a list of sixteen numbers", key), file, value.line);
    Matrix matrix{};
    for (std::size_t i = 0; i < 16; ++i) {
        const Result<double> real = realOf((*numbers)[i], file, key);
        if (!real) return real.error();
        matrix[i] = *real;
    }
    return matrix;
}

}  // namespace

Result<CameraMatrices> matricesOf(const std::string& json, const std::string& file)
{
    const Result<JsonValue> document = parseJson(json, file);
    if (!document) return document.error();
    const JsonValue::Object* members = document->object();
    if (!members)
        return inputError("the matrices must be an object with 'view' and 'projection', or 'clip_from_world'", file,
                          document->line);
    CameraMatrices matrices;
    for (const auto& [key, value] : *members) {
        const std::string* text = value.text();
        if (key == "view" || key == "projection" || key == "clip_from_world") {
            const Result<Matrix> matrix = matrixOf(value, file, key);
            if (!matrix) return matrix.error();
            (key == "view"         ? matrices.view
             : key == "projection" ? matrices.projection
                                   : matrices.clipFromWorld) = *matrix;
        } else if (key == "order") {
            if (!text || (*text != "rows" && *text != "columns"))
                return inputError("'order' must be \"rows\" or \"columns\"", file, value.line);
            matrices.order = *text == "rows" ? MatrixOrder::Rows : MatrixOrder::Columns;
        } else if (key == "depth") {
            if (!text || (*text != "-1..1" && *text != "0..1" && *text != "reversed"))
                return inputError("'depth' must be \"-1..1\", \"0..1\" or \"reversed\"", file, value.line);
            matrices.range = *text == "-1..1"  ? DepthRange::MinusOneToOne
                             : *text == "0..1" ? DepthRange::ZeroToOne
                                               : DepthRange::Reversed;
        } else {
            return inputError(
                fmt::format("matrices have no '{}'; they have view, projection, clip_from_world, order and depth",
                            key.substr(0, 60)),
                file, value.line);
        }
    }
    const bool isPair = matrices.view && matrices.projection;
    if (matrices.clipFromWorld ? matrices.view || matrices.projection : !isPair)
        return inputError("the matrices must be 'view' and 'projection', or 'clip_from_world' alone", file,
                          document->line);
    return matrices;
}

Result<CameraMatrices> readMatrices(const std::string& path)
{
    const Result<std::string> text = readRegularFile(path, kMaxMatrixFile);
    if (!text) return Error{Trouble::Input, text.error().sentence, text.error().file};
    return matricesOf(*text, path);
}

Result<std::vector<Camera>> camerasOf(const CameraMatrices& matrices, int width, int height, const std::string& file)
{
    const auto clipBy = [&](MatrixOrder order) {
        if (matrices.clipFromWorld) return rowsOf(*matrices.clipFromWorld, order);
        MatrixRows clip = product(rowsOf(*matrices.projection, order), rowsOf(*matrices.view, order));
        if (rowsOf(*matrices.projection, order)[1][1] < 0)
            for (double& number : clip[1]) number = -number;
        return clip;
    };
    const MatrixOrder order =
        matrices.order.value_or(orderOf(matrices, decomposed(clipBy(MatrixOrder::Rows), width, height),
                                        decomposed(clipBy(MatrixOrder::Columns), width, height)));
    const Decomposed d = decomposed(clipBy(order), width, height);
    if (!d.why.empty()) return inputError(d.why, file);

    std::vector<DepthRange> ranges{DepthRange::MinusOneToOne, DepthRange::ZeroToOne};
    const bool              looksAlongPlusZ = matrices.projection && rowsOf(*matrices.projection, order)[3][2] > 0;
    const bool              pointsDown      = matrices.projection && rowsOf(*matrices.projection, order)[1][1] < 0;
    if (looksAlongPlusZ || pointsDown) std::swap(ranges[0], ranges[1]);
    if (d.perspective.b > 0) ranges = {DepthRange::Reversed};
    if (matrices.range) ranges = {*matrices.range};
    std::vector<Camera> cameras;
    for (const DepthRange range : ranges)
        if (const auto camera = withRange(d.perspective, range)) cameras.push_back(*camera);
    if (cameras.empty()) return inputError("no near and far plane follow from the matrix's depths", file);
    return cameras;
}

}  // namespace zscope::check
