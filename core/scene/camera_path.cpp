#include "core/scene/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/products.h"
#include "core/scene/view_json.h"

namespace zscope {
namespace {

constexpr double kDegreesPerRadian = 180 / 3.141592653589793;

ViewRequest requestOf(const CameraPath& path, const CameraKey& key, int width, int height)
{
    ViewRequest view;
    view.eye         = key.eye;
    view.target      = key.target;
    view.up          = key.up;
    view.verticalFov = key.verticalFov;
    view.near        = path.near;
    view.far         = path.far;
    view.width       = width;
    view.height      = height;
    return view;
}

Result<bool> truthOf(const JsonValue& value, const std::string& file, std::string_view what)
{
    if (!value.truth()) return errorAt(value, file, fmt::format("'{}' is true or false", what));
    return *value.truth();
}

class PathReader {
public:
    explicit PathReader(const std::string& file) : m_file(file) {}

    Result<CameraPath> read(const JsonValue& document)
    {
        if (!document.object()) return errorAt(document, m_file, "a camera path is an object with 'keys'");
        CameraPath       path;
        const JsonValue* keys = nullptr;
        for (const auto& [name, value] : *document.object()) {
            if (name == "unit") {
                if (!value.text() || (*value.text() != "world" && *value.text() != "scene"))
                    return errorAt(value, m_file, "'unit' is \"world\" or \"scene\"");
                path.inScene = *value.text() == "scene";
            } else if (name == "near" || name == "far") {
                const Result<double> real = realOf(value, m_file, name);
                if (!real) return real.error();
                if (!(*real > 0) || (name == "near" && !std::isfinite(*real)))
                    return errorAt(value, m_file, fmt::format("'{}' must be above 0", name));
                (name == "near" ? path.near : path.far) = *real;
            } else if (name == "keys") {
                keys = &value;
            } else {
                return errorAt(
                    value, m_file,
                    fmt::format("a camera path has no '{}': it has unit, near, far and keys", name.substr(0, 60)));
            }
        }
        if (!keys) return errorAt(document, m_file, "'keys' is missing");
        if (!keys->array() || keys->array()->empty())
            return errorAt(*keys, m_file, "'keys' is a list that is not empty");
        for (const JsonValue& each : *keys->array()) {
            const auto key = keyFrom(each, path);
            if (!key) return key.error();
            path.keys.push_back(*key);
        }
        return path;
    }

private:
    Result<CameraKey> keyFrom(const JsonValue& value, const CameraPath& path) const
    {
        if (!value.object()) return errorAt(value, m_file, "a key frame is an object with frame, eye and target");
        CameraKey key{.line = value.line};
        bool      hasFrame = false, hasEye = false, hasTarget = false;
        for (const auto& [name, member] : *value.object()) {
            if (name == "frame") {
                const auto frame = wholeOf(member, m_file, "frame", 0, kMaxPathFrames - 1);
                if (!frame) return frame.error();
                key.frame = static_cast<int>(*frame);
                hasFrame  = true;
            } else if (name == "eye" || name == "target" || name == "up") {
                const Result<dvec3> vector = vectorOf(member, m_file, name);
                if (!vector) return vector.error();
                (name == "eye" ? key.eye : name == "target" ? key.target : key.up) = *vector;
                hasEye |= name == "eye";
                hasTarget |= name == "target";
            } else if (name == "fov") {
                const Result<double> real = realOf(member, m_file, name);
                if (!real) return real.error();
                key.verticalFov = *real;
            } else if (name == "cut") {
                const auto truth = truthOf(member, m_file, name);
                if (!truth) return truth.error();
                key.isCut = *truth;
            } else {
                return errorAt(member, m_file,
                               fmt::format("a key frame has no '{}': it has frame, eye, target, up, fov and cut",
                                           name.substr(0, 60)));
            }
        }
        for (const auto& [has, name] :
             {std::pair{hasFrame, "frame"}, std::pair{hasEye, "eye"}, std::pair{hasTarget, "target"}})
            if (!has) return errorAt(value, m_file, fmt::format("the key frame's '{}' is missing", name));
        if (path.keys.empty() && key.frame != 0)
            return errorAt(value, m_file, fmt::format("the first key frame is frame 0, not {}", key.frame));
        if (path.keys.empty() && key.isCut)
            return errorAt(value, m_file, "the first key frame has nothing before it to cut from");
        if (!path.keys.empty() && key.frame <= path.keys.back().frame)
            return errorAt(value, m_file,
                           fmt::format("frames must rise, and {} comes after {}", key.frame, path.keys.back().frame));
        // Any box will do: what is wrong with a key alone is found here, where its line is known.
        Bounds anyBox;
        anyBox.include({-1, -1, -1});
        anyBox.include({1, 1, 1});
        CameraPath depthless = path;
        depthless.near = depthless.far = std::nullopt;
        if (const auto camera = makeCamera(requestOf(depthless, key, 1, 1), anyBox); !camera)
            return errorAt(value, m_file, camera.error().sentence);
        // Frames between this key and the next aim at a target as far away.
        if (!std::isfinite(dotAsWritten(key.target - key.eye, key.target - key.eye)))
            return errorAt(value, m_file, "eye and target are too far apart");
        return key;
    }

    const std::string& m_file;
};

/// A rotation as (w, v): 2 acos(w) about v.
struct Turn {
    double w = 1;
    dvec3  v{0, 0, 0};
};

/// The rotation that takes the axes of a camera from (1,0,0), (0,1,0), (0,0,-1) to what they are. Source: Shepperd
/// 1978.
Turn turnOf(const Camera& camera)
{
    const dvec3  x = camera.right, y = camera.up, z = -camera.forward;
    const double trace = x.x + y.y + z.z;
    Turn         turn;
    if (trace >= x.x && trace >= y.y && trace >= z.z) {
        turn = {1 + trace, {y.z - z.y, z.x - x.z, x.y - y.x}};
    } else if (x.x >= y.y && x.x >= z.z) {
        turn = {y.z - z.y, {1 + x.x - y.y - z.z, x.y + y.x, z.x + x.z}};
    } else if (y.y >= z.z) {
        turn = {z.x - x.z, {x.y + y.x, 1 - x.x + y.y - z.z, y.z + z.y}};
    } else {
        turn = {x.y - y.x, {z.x + x.z, y.z + z.y, 1 - x.x - y.y + z.z}};
    }
    const double length = std::sqrt(turn.w * turn.w + dotAsWritten(turn.v, turn.v));
    return {turn.w / length, turn.v / length};
}

/// From the axes of `a` to those of `b`, the shorter way; a half-turn goes to the left.
Turn between(const Camera& a, const Camera& b)
{
    constexpr double kHalfTurn = 1e-9;  // |cosine of half the angle| below which both ways are as short
    const Turn       p = turnOf(a), q = turnOf(b);
    Turn             turn{q.w * p.w + dotAsWritten(q.v, p.v), p.w * q.v - q.w * p.v - crossAsWritten(q.v, p.v)};
    const bool       isHalf = std::abs(turn.w) < kHalfTurn;
    if (isHalf ? dotAsWritten(turn.v, a.up) < 0 : turn.w < 0) turn = {-turn.w, -turn.v};
    return turn;
}

dvec3 turned(const dvec3& by, const dvec3& axis, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return by * c + crossAsWritten(axis, by) * s + axis * (dotAsWritten(axis, by) * (1 - c));
}

/// The view a part of the way from `from` to `to`, in [0, 1].
CameraKey keyBetween(const CameraKey& from, const CameraKey& to, const Camera& a, const Camera& b, double part)
{
    const Turn   turn   = between(a, b);
    const double length = std::sqrt(dotAsWritten(turn.v, turn.v));
    const double angle  = 2 * std::atan2(length, turn.w) * part;
    const dvec3  axis   = length > 0 ? turn.v / length : dvec3(0, 1, 0);
    const auto   mixed  = [part](const auto& x, const auto& y) { return x * (1 - part) + y * part; };
    const double far    = mixed(std::sqrt(dotAsWritten(from.target - from.eye, from.target - from.eye)),
                                std::sqrt(dotAsWritten(to.target - to.eye, to.target - to.eye)));
    CameraKey    key;
    key.eye         = mixed(from.eye, to.eye);
    key.target      = key.eye + turned(a.forward, axis, angle) * far;
    key.up          = turned(a.up, axis, angle);
    key.verticalFov = mixed(from.verticalFov, to.verticalFov);
    return key;
}

std::string textOf(const dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }
std::string numberText(double x) { return std::isinf(x) ? "\"inf\"" : fmt::format("{}", x); }

}  // namespace

std::vector<int> CameraPath::cuts() const
{
    std::vector<int> frames;
    for (const CameraKey& key : keys)
        if (key.isCut) frames.push_back(key.frame);
    return frames;
}

Result<CameraPath> cameraPathFromJson(const std::string& text, const std::string& file)
{
    const Result<JsonValue> document = parseJson(text, file);
    if (!document) return document.error();
    Result<CameraPath> path = PathReader(file).read(*document);
    if (path && path->near && path->far && !(*path->near < *path->far))
        return errorAt(*document, file, "'near' must be less than 'far'");
    return path;
}

std::string cameraPathToJson(const CameraPath& path)
{
    std::string text = fmt::format("{{\n \"unit\": \"{}\",\n", path.inScene ? "scene" : "world");
    if (path.near) text += fmt::format(" \"near\": {},\n", numberText(*path.near));
    if (path.far) text += fmt::format(" \"far\": {},\n", numberText(*path.far));
    text += " \"keys\": [";
    for (const CameraKey& key : path.keys)
        text += fmt::format("{}\n  {{\"frame\": {}, \"eye\": {}, \"target\": {}, \"up\": {}, \"fov\": {}{}}}",
                            &key == path.keys.data() ? "" : ",", key.frame, textOf(key.eye), textOf(key.target),
                            textOf(key.up), key.verticalFov, key.isCut ? ", \"cut\": true" : "");
    return text + "\n ]\n}\n";
}

Result<std::vector<Camera>> camerasOf(const CameraPath& path, const Bounds& scene, int width, int height)
{
    std::vector<CameraKey> keys = path.keys;
    if (path.inScene && !scene.isEmpty()) {
        const dvec3  middle = scene.min * 0.5 + scene.max * 0.5, half = scene.max * 0.5 - scene.min * 0.5;
        const double length = std::sqrt(dotAsWritten(half, half));
        const double unit   = length > 0 ? length : 1;
        for (CameraKey& key : keys) {
            key.eye    = middle + key.eye * unit;
            key.target = middle + key.target * unit;
        }
    }
    const auto cameraAt = [&](const CameraKey& key) -> Result<Camera> {
        Result<Camera> camera = makeCamera(requestOf(path, key, width, height), scene);
        if (!camera)
            return Error{camera.error().kind,
                         fmt::format("frame {} of the camera path: {}", key.frame, camera.error().sentence),
                         {},
                         key.line};
        return camera;
    };
    std::vector<Camera> ends;
    for (const CameraKey& key : keys) {
        const auto camera = cameraAt(key);
        if (!camera) return camera.error();
        ends.push_back(*camera);
    }
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        cameras.push_back(ends[i]);
        const int frames = keys[i + 1].frame - keys[i].frame;
        for (int step = 1; step < frames; ++step) {
            if (keys[i + 1].isCut) {
                cameras.push_back(ends[i]);
                continue;
            }
            CameraKey key = keyBetween(keys[i], keys[i + 1], ends[i], ends[i + 1], static_cast<double>(step) / frames);
            key.frame     = keys[i].frame + step;
            key.line      = keys[i + 1].line;
            const auto camera = cameraAt(key);
            if (!camera) return camera.error();
            cameras.push_back(*camera);
        }
    }
    cameras.push_back(ends.back());
    return cameras;
}

CameraKey keyOf(const Camera& camera, int frame, double distance)
{
    CameraKey key;
    key.frame       = frame;
    key.eye         = camera.eye;
    key.target      = camera.eye + camera.forward * distance;
    key.up          = camera.up;
    key.verticalFov = 2 * std::atan(1 / camera.focal) * kDegreesPerRadian;
    return key;
}

}  // namespace zscope
