// A camera that moves: key frames written by hand or recorded, and the camera of every frame between them.
//
// File       {"unit":"world|scene","near":n,"far":F,"keys":[{"frame":N,"eye":[3],"target":[3],"up":[3],"fov":degrees,
//            "cut":bool}...]}; a key needs frame, eye and target; up is 0,1,0 and the field of view 45 degrees where it
//            does not say. The first key is frame 0, frames rise, and the path ends with the last. Numbers as in a
//            camera's file
// Unit       scene: eye and target are measured from the middle of the scene's box, in halves of its diagonal, so that
//            one path fits every scene
// Between    the eye goes straight, the view turns the shorter way (a half-turn goes to the left), the field of view
//            changes evenly. Until a key with a cut the camera stands where the key before it left it
// Promise    the same file, box and size give the same cameras on one machine; a key frame is what makeCamera() makes
//            of it. Elsewhere sine and arc cosine may differ in the last bit
// Errors     Input with the line; Limit for more than kMaxPathFrames
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh.h"
#include "core/scene/view.h"

namespace zscope {

inline constexpr int           kMaxPathFrames = 100'000;
inline constexpr std::uint64_t kMaxPathFile   = 16 << 20;  // bytes

struct CameraKey {
    int    frame = 0;
    dvec3  eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};
    double verticalFov = 45;  // degrees
    bool   isCut       = false;
    int    line        = 0;  // of the file that it was read from, for errors

    /// Wherever they were read.
    friend bool operator==(const CameraKey& a, const CameraKey& b)
    {
        return a.frame == b.frame && a.eye == b.eye && a.target == b.target && a.up == b.up
               && a.verticalFov == b.verticalFov && a.isCut == b.isCut;
    }
};

struct CameraPath {
    std::vector<CameraKey> keys;                 // at least one; the first is frame 0; frames rise
    bool                   inScene = false;      // the unit is the scene
    std::optional<double>  near = {}, far = {};  // of every frame; absent: from the scene's bounds

    int              frameCount() const { return keys.back().frame + 1; }
    std::vector<int> cuts() const;  // the frames of keys with a cut

    friend bool operator==(const CameraPath&, const CameraPath&) = default;
};

/// `file` is named in errors.
Result<CameraPath> cameraPathFromJson(const std::string& text, const std::string& file);
/// Reading it back gives the same path to the bit.
std::string cameraPathToJson(const CameraPath& path);

/// The camera of every frame. Errors: Usage with the key's line, what makeCamera() refuses, which a key read from a
/// file gives no reason for but by the scene's place and size, or by the picture's.
Result<std::vector<Camera>> camerasOf(const CameraPath& path, const Bounds& scene, int width, int height);

/// A key that looks from where this camera looks; `distance` > 0 is that of the target.
CameraKey keyOf(const Camera& camera, int frame, double distance);

}  // namespace zscope
