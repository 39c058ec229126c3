#include "app/cli/scene_export.h"

#include <array>
#include <iterator>

#include <fmt/format.h>

#include "core/io/file_writer.h"
#include "core/io/npy.h"

namespace zscope::cli {
namespace {

constexpr std::uint64_t kTrianglesAtATime = 1 << 14;  // between two looks at whether they are still wanted

/// Calls `visit` with the corners 0, 1, 2 of each triangle until it says false. False: cancelled.
template <class Visit>
bool forEachTriangle(const Scene& scene, const std::atomic<bool>* cancel, const Visit& visit)
{
    std::uint64_t visited = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh  = *scene.meshes[instance.mesh.value];
        const bool  moved = !instance.toWorld.isIdentity();
        for (const auto& triangle : mesh.triangles) {
            if (visited++ % kTrianglesAtATime == 0 && cancel && cancel->load(std::memory_order_relaxed)) return false;
            std::array<double, 9> corners;
            for (std::size_t c = 0; c < 3; ++c) {
                const dvec3& p = mesh.positions[triangle[c]];
                const dvec3  q = moved ? instance.toWorld(p) : p;
                for (std::size_t axis = 0; axis < 3; ++axis) corners[c * 3 + axis] = q[static_cast<int>(axis)];
            }
            if (!visit(corners)) return true;
        }
    }
    return true;
}

}  // namespace

Result<Done> writeTriangles(const Scene& scene, const std::string& path, const std::atomic<bool>* cancel)
{
    Result<NpyTriangleWriter> file = NpyTriangleWriter::create(path, scene.triangleCount());
    if (!file) return file.error();
    const auto put = [&](const std::array<double, 9>& corners) {
        file->triangle(corners);
        return !file->failed();  // commit() says why
    };
    if (!forEachTriangle(scene, cancel, put)) return Error{Trouble::Cancelled, "interrupted"};
    return file->commit();
}

Result<Done> writeObj(const Scene& scene, const std::string& path, const std::atomic<bool>* cancel)
{
    Result<FileWriter> file = FileWriter::create(path);
    if (!file) return file.error();
    fmt::memory_buffer lines;
    const auto         put = [&](const std::array<double, 9>& corners) {
        lines.clear();
        for (std::size_t c = 0; c < 9; c += 3)
            fmt::format_to(std::back_inserter(lines), "v {} {} {}\n", corners[c], corners[c + 1], corners[c + 2]);
        fmt::format_to(std::back_inserter(lines), "f -3 -2 -1\n");
        file->write({lines.data(), lines.size()});
        return !file->failed();
    };
    if (!forEachTriangle(scene, cancel, put)) return Error{Trouble::Cancelled, "interrupted"};
    return file->commit();
}

}  // namespace zscope::cli
