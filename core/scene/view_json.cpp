#include "core/scene/view_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace zscope {

namespace {

/// [W, H] or "WxH".
Result<std::array<int, 2>> sizeOf(const JsonValue& value, const std::string& file)
{
    const auto refused = [&] {
        return errorAt(
            value, file,
            fmt::format("'size' must be [width, height] or \"WIDTHxHEIGHT\", each from 1 to {}", kMaxPictureSide));
    };
    std::array<int, 2> size{};
    if (const JsonValue::Array* pair = value.array()) {
        if (pair->size() != 2) return refused();
        for (std::size_t i = 0; i < 2; ++i) {
            const Result<std::int64_t> side = wholeOf((*pair)[i], file, "size", 1, kMaxPictureSide);
            if (!side) return side.error();
            size[i] = static_cast<int>(*side);
        }
        return size;
    }
    if (!value.text()) return refused();
    const std::string& text  = *value.text();
    const char*        end   = text.data() + text.size();
    const auto         width = std::from_chars(text.data(), end, size[0]);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return refused();
    const auto height = std::from_chars(width.ptr + 1, end, size[1]);
    if (height.ec != std::errc{} || height.ptr != end) return refused();
    for (int side : size)
        if (side < 1 || side > kMaxPictureSide) return refused();
    return size;
}

bool isExactForm(const JsonValue::Object& members)
{
    constexpr std::array<std::string_view, 5> kOnlyExact{"right", "forward", "focal", "width", "height"};
    return std::ranges::any_of(
        members, [&](const auto& member) { return std::ranges::find(kOnlyExact, member.first) != kOnlyExact.end(); });
}

}  // namespace

Result<dvec3> vectorOf(const JsonValue& value, const std::string& file, std::string_view what)
{
    const JsonValue::Array* entries = value.array();
    if (!entries || entries->size() != 3)
        return Error{Trouble::Input, fmt::format("'{}' must be a list of three numbers", what), file, value.line};
    dvec3 vector{0, 0, 0};
    for (int i = 0; i < 3; ++i) {
        const Result<double> real = realOf((*entries)[static_cast<std::size_t>(i)], file, what);
        if (!real) return real.error();
        if (!std::isfinite(*real))
            return Error{Trouble::Input, fmt::format("'{}' must be finite", what), file, value.line};
        vector[i] = *real;
    }
    return vector;
}

Result<Camera> cameraOf(const JsonValue& document, const std::string& file)
{
    const JsonValue::Object* members = document.object();
    if (!members) return errorAt(document, file, "a camera must be an object with its ten numbers");

    Camera camera;
    struct Vector {
        std::string_view key;
        dvec3*           to;
    };
    struct Real {
        std::string_view key;
        double*          to;
    };
    struct Whole {
        std::string_view key;
        int*             to;
    };
    const std::array vectors{Vector{"eye", &camera.eye}, Vector{"right", &camera.right}, Vector{"up", &camera.up},
                             Vector{"forward", &camera.forward}};
    const std::array reals{Real{"focal", &camera.focal}, Real{"near", &camera.near}, Real{"far", &camera.far}};
    const std::array wholes{Whole{"width", &camera.width}, Whole{"height", &camera.height}};

    std::size_t met = 0;  // keys are unique, so counting the known ones tells whether all are there
    for (const auto& [key, value] : *members) {
        ++met;
        if (const auto v = std::ranges::find(vectors, key, &Vector::key); v != vectors.end()) {
            const Result<dvec3> vector = vectorOf(value, file, key);
            if (!vector) return vector.error();
            *v->to = *vector;
        } else if (const auto r = std::ranges::find(reals, key, &Real::key); r != reals.end()) {
            const Result<double> real = realOf(value, file, key);
            if (!real) return real.error();
            *r->to = *real;
        } else if (const auto w = std::ranges::find(wholes, key, &Whole::key); w != wholes.end()) {
            const Result<std::int64_t> whole = wholeOf(value, file, key, 1, kMaxPictureSide);
            if (!whole) return whole.error();
            *w->to = static_cast<int>(*whole);
        } else {
            return errorAt(value, file,
                           fmt::format("a camera has no '{}'; it has eye, right, up, forward, focal, near, far, "
                                       "width and height",
                                       key.substr(0, 60)));
        }
    }
    if (met < vectors.size() + reals.size() + wholes.size()) {
        const auto has = [&](std::string_view key) {
            return std::ranges::find(*members, key, &JsonValue::Member::first) != members->end();
        };
        for (const Vector& v : vectors)
            if (!has(v.key)) return errorAt(document, file, fmt::format("the camera's '{}' is missing", v.key));
        for (const Real& r : reals)
            if (!has(r.key)) return errorAt(document, file, fmt::format("the camera's '{}' is missing", r.key));
        for (const Whole& w : wholes)
            if (!has(w.key)) return errorAt(document, file, fmt::format("the camera's '{}' is missing", w.key));
    }
    if (const auto why = explainInvalid(camera)) return errorAt(document, file, *why);
    return camera;
}

Result<ViewRequest> viewOf(const JsonValue& document, const std::string& file)
{
    const JsonValue::Object* members = document.object();
    if (!members) return errorAt(document, file, "a camera must be an object of view options, or of its ten numbers");
    ViewRequest view;
    if (isExactForm(*members)) {
        const Result<Camera> camera = cameraOf(document, file);
        if (!camera) return camera.error();
        view.exact  = *camera;
        view.width  = camera->width;
        view.height = camera->height;
        return view;
    }
    for (const auto& [key, value] : *members) {
        if (key == "eye" || key == "target" || key == "up") {
            const Result<dvec3> vector = vectorOf(value, file, key);
            if (!vector) return vector.error();
            if (key == "eye")
                view.eye = *vector;
            else if (key == "target")
                view.target = *vector;
            else
                view.up = *vector;
        } else if (key == "fov" || key == "near" || key == "far") {
            const Result<double> real = realOf(value, file, key);
            if (!real) return real.error();
            if (key == "fov")
                view.verticalFov = *real;
            else if (key == "near")
                view.near = *real;
            else
                view.far = *real;
        } else if (key == "size") {
            const auto size = sizeOf(value, file);
            if (!size) return size.error();
            view.width  = (*size)[0];
            view.height = (*size)[1];
        } else if (key == "cull") {
            if (!value.text() || (*value.text() != "none" && *value.text() != "back"))
                return errorAt(value, file, "'cull' must be \"none\" or \"back\"");
            view.faceCulling = *value.text() == "back" ? FaceCulling::Back : FaceCulling::None;
        } else {
            return errorAt(value, file,
                           fmt::format("a view has no '{}'; it has size, eye, target, up, fov, near, far and "
                                       "cull, or the ten numbers of a camera",
                                       key.substr(0, 60)));
        }
    }
    return view;
}

Result<Camera> cameraFromJson(const std::string& text, const std::string& file)
{
    Result<JsonValue> document = parseJson(text, file);
    if (!document) return document.error();
    return cameraOf(*document, file);
}

std::string cameraToJson(const Camera& camera)
{
    const auto real = [](double x) {
        return std::isinf(x) ? fmt::format("\"{}inf\"", x < 0 ? "-" : "") : fmt::format("\"{:a}\"", x);
    };
    const auto vector = [&real](const dvec3& v) {
        return fmt::format("[{}, {}, {}]", real(v.x), real(v.y), real(v.z));
    };
    return fmt::format(
        "{{\"eye\": {},\n \"right\": {},\n \"up\": {},\n \"forward\": {},\n"
        " \"focal\": {}, \"near\": {}, \"far\": {},\n \"width\": {}, \"height\": {}}}\n",
        vector(camera.eye), vector(camera.right), vector(camera.up), vector(camera.forward), real(camera.focal),
        real(camera.near), real(camera.far), camera.width, camera.height);
}

}  // namespace zscope
