// Pictures out: PNG with 8 bits per part and the words that reproduce the picture.
//
// Colours    0xAARRGGBB; the file has an alpha channel only if some pixel is not opaque
// Texts      UTF-8 (iTXt chunks), so that a path in any script survives
// Promise    the same pixels and texts give the same bytes: no time stamp, no machine's name, any number of threads
// Strips     the picture is cut into strips of whole rows, kPngStripBytes or one row each. Threads compress them
//            independently of each other, and each strip is one IDAT chunk
// Memory     two strips per thread and a few rows, whatever the size of the picture
// Source     PNG (Portable Network Graphics) Specification, Third Edition, W3C; zlib's deflate with Z_SYNC_FLUSH, which
//            ends every strip but the last on a whole byte
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/base/result.h"

namespace zscope {

inline constexpr std::size_t kPngStripBytes = std::size_t{1} << 18;  // of a strip before it is compressed

struct PngText {
    std::string keyword;  // 1 to 79 Latin letters
    std::string text;     // UTF-8
};

/// The keywords every picture of ZScope carries: what made it, of which scene, and how to make it again.
inline constexpr const char* kPngSoftware    = "Software";      // "ZScope 0.1.0"
inline constexpr const char* kPngCommand     = "Command";       // a command line
inline constexpr const char* kPngSceneDigest = "Scene digest";  // Scene::digest
/// Of the window's pictures besides: what opens the same view again.
inline constexpr const char* kPngSession = "Session";

/// The three texts above. `command` is the command line without the options that name outputs.
std::vector<PngText> reproducingTexts(const std::string& command, const std::string& sceneDigest);

/// How a picture is encoded; the bytes do not depend on it.
struct PngWork {
    int                      threads = 0;        // 0: one per core
    const std::atomic<bool>* cancel  = nullptr;  // set to true: the file is left out, and the error is Cancelled
};

/// Width and height must be at least 1.
Result<Done> writePng(const std::string& path, GridView<const std::uint32_t> argb, std::span<const PngText> texts,
                      const PngWork& work = {});
/// The bytes of that file. Errors: Limit, Cancelled.
Result<std::string> pngOf(GridView<const std::uint32_t> argb, std::span<const PngText> texts = {},
                          const PngWork& work = {});

}  // namespace zscope
