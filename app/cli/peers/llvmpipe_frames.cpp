#include "app/cli/peers/llvmpipe_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "app/cli/peers/gl_functions.h"
#include "core/base/stopwatch.h"
#include "core/measure/frame_quota.h"

namespace zscope::cli {
namespace {

struct GlVertex {
    std::array<float, 3>        position;
    std::array<std::uint8_t, 4> colour;  // of the triangle that has it as its last corner
};

struct GlMesh {
    std::vector<GlVertex>      vertices;
    std::vector<std::uint32_t> corners;  // three per triangle
};

/// Neighbours differ, none is black.
std::array<std::uint8_t, 4> colourOf(std::uint32_t triangle)
{
    const std::uint32_t mixed = triangle * 2654435761u;
    const auto          part  = [mixed](int shift) { return static_cast<std::uint8_t>(96 + (mixed >> shift & 127)); };
    return {part(8), part(16), part(24), 255};
}

/// The mesh with a colour per triangle: turned so that its last corner is one that no earlier triangle has coloured,
/// and where all are taken, with a copy of its last corner.
GlMesh glMeshOf(const Mesh& mesh)
{
    GlMesh            gl;
    std::vector<bool> isTaken(mesh.positions.size());
    for (const dvec3& p : mesh.positions)
        gl.vertices.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}, {}});
    gl.corners.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<std::uint32_t, 3> corners = mesh.triangles[t];
        const auto                   free = std::ranges::find_if(corners, [&](std::uint32_t v) { return !isTaken[v]; });
        if (free != corners.end()) {
            std::rotate(corners.begin(), free + 1, corners.end());
            isTaken[corners[2]] = true;
        } else {
            gl.vertices.push_back(gl.vertices[corners[2]]);
            corners[2] = static_cast<std::uint32_t>(gl.vertices.size() - 1);
        }
        gl.vertices[corners[2]].colour = colourOf(t);
        gl.corners.insert(gl.corners.end(), corners.begin(), corners.end());
    }
    return gl;
}

/// World to clip space, as OpenGL wants it: columns first.
using GlMatrix = std::array<double, 16>;
GlMatrix matrixOf(const Camera& c, const Affine& toWorld)
{
    const bool   hasFar = std::isfinite(c.far);
    const double a      = hasFar ? (c.far + c.near) / (c.far - c.near) : 1,
                 b      = hasFar ? -2 * c.far * c.near / (c.far - c.near) : -2 * c.near;
    const auto row      = [&](const dvec3& axis, double scale, double offset) {
        std::array<double, 4> out{};
        const auto dot = [&axis](double x, double y, double z) { return axis.x * x + axis.y * y + axis.z * z; };
        for (std::size_t k = 0; k < 4; ++k)
            out[k] = scale * dot(toWorld.rows[0][k], toWorld.rows[1][k], toWorld.rows[2][k]);
        out[3] += offset - scale * dot(c.eye.x, c.eye.y, c.eye.z);
        return out;
    };
    const std::array<std::array<double, 4>, 4> rows{row(c.right, c.focal * c.height / c.width, 0),
                                                    row(c.up, c.focal, 0), row(c.forward, a, b), row(c.forward, 1, 0)};
    GlMatrix                                   matrix{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t k = 0; k < 4; ++k) matrix[4 * k + r] = rows[r][k];
    return matrix;
}

class GlRun {
public:
    GlRun(const PeerRequest& request, const GlFunctions& functions) : m_request(request), gl(functions) {}

    Result<PeerRun> run()
    {
        const Camera& camera  = m_request.camera;
        OSMesaContext context = gl.OSMesaCreateContextExt(OSMESA_BGRA, 24, 0, 0, nullptr);
        // What is drawn goes to a frame buffer of our own; OSMesa only wants to have one.
        std::array<std::uint32_t, 4> unused{};
        if (!context || !gl.OSMesaMakeCurrent(context, unused.data(), GL_UNSIGNED_BYTE, 2, 2))
            return Error{Trouble::Input, "OSMesa gives no context to draw with"};
        const auto* renderer = reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER));
        if (!renderer || !std::string_view(renderer).starts_with("llvmpipe"))
            return Error{Trouble::Input, fmt::format("OSMesa draws with '{}' here and not with llvmpipe",
                                                     renderer ? renderer : "nothing")};

        Stopwatch start;
        upload();
        PeerRun run;
        run.buildMs = start.lap();
        if (!prepare()) return Error{Trouble::Limit, "OSMesa has no frame buffer of that size"};

        for (int frame = 0; frame < m_request.warmUp; ++frame) draw();
        for (FrameQuota quota(m_request.frames, m_request.leastMs); quota.wantsMore();
             quota.drawn(run.frameMs.back())) {
            if (m_request.progress.cancelled()) return Error{Trouble::Cancelled, "the frames were not wanted any more"};
            Stopwatch begun;
            draw();
            run.frameMs.push_back(begun.lap());
        }
        readDepth(run);
        if (gl.glGetError() != GL_NO_ERROR)
            return Error{Trouble::Limit, "OSMesa reports an error, most likely for lack of memory"};
        gl.OSMesaDestroyContext(context);
        run.setting = fmt::format("{}x{}", camera.width, camera.height);
        return run;
    }

private:
    struct Buffers {
        GLuint  vertices = 0, corners = 0;
        GLsizei count = 0;  // of corners
    };

    void upload()
    {
        for (const auto& mesh : m_request.scene.meshes) {
            const GlMesh          own = glMeshOf(*mesh);
            std::array<GLuint, 2> names{};
            gl.glGenBuffers(2, names.data());
            gl.glBindBuffer(GL_ARRAY_BUFFER, names[0]);
            gl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(own.vertices.size() * sizeof(GlVertex)),
                            own.vertices.data(), GL_STATIC_DRAW);
            gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
            gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                            static_cast<GLsizeiptr>(own.corners.size() * sizeof(std::uint32_t)), own.corners.data(),
                            GL_STATIC_DRAW);
            m_buffers.push_back({names[0], names[1], static_cast<GLsizei>(own.corners.size())});
        }
        for (const Instance& instance : m_request.scene.instances)
            m_matrices.push_back(matrixOf(m_request.camera, instance.toWorld));
    }

    bool prepare()
    {
        const int             width = m_request.camera.width, height = m_request.camera.height;
        GLuint                target = 0;
        std::array<GLuint, 2> images{};
        gl.glGenFramebuffers(1, &target);
        gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
        gl.glGenRenderbuffers(2, images.data());
        for (const std::size_t i : {0u, 1u}) {
            gl.glBindRenderbuffer(GL_RENDERBUFFER, images[i]);
            gl.glRenderbufferStorage(GL_RENDERBUFFER, i == 0 ? GL_RGBA8 : GL_DEPTH_COMPONENT24, width, height);
            gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT,
                                         GL_RENDERBUFFER, images[i]);
        }
        if (gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
        gl.glViewport(0, 0, width, height);
        gl.glEnable(GL_DEPTH_TEST);
        if (m_request.faceCulling == FaceCulling::Back) gl.glEnable(GL_CULL_FACE);
        gl.glShadeModel(GL_FLAT);
        gl.glMatrixMode(GL_PROJECTION);
        gl.glLoadIdentity();
        gl.glMatrixMode(GL_MODELVIEW);
        gl.glEnableClientState(GL_VERTEX_ARRAY);
        gl.glEnableClientState(GL_COLOR_ARRAY);
        return true;
    }

    void draw()
    {
        gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const Scene&  scene       = m_request.scene;
        std::uint32_t bound       = ~0u;
        bool          wasMirrored = false;
        gl.glCullFace(GL_BACK);
        for (std::size_t i = 0; i < scene.instances.size(); ++i) {
            const std::uint32_t mesh    = scene.instances[i].mesh.value;
            const Buffers&      buffers = m_buffers[mesh];
            if (mesh != bound) {
                gl.glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
                gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.corners);
                gl.glVertexPointer(3, GL_FLOAT, sizeof(GlVertex), nullptr);
                gl.glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(GlVertex),
                                  reinterpret_cast<const void*>(offsetof(GlVertex, colour)));
                bound = mesh;
            }
            gl.glLoadMatrixd(m_matrices[i].data());
            if (const bool isMirrored = scene.instances[i].toWorld.isMirrored(); isMirrored != wasMirrored) {
                gl.glCullFace(isMirrored ? GL_FRONT : GL_BACK);
                wasMirrored = isMirrored;
            }
            gl.glDrawElements(GL_TRIANGLES, buffers.count, GL_UNSIGNED_INT, nullptr);
        }
        gl.glFinish();
    }

    void readDepth(PeerRun& run) const
    {
        const Camera&      c = m_request.camera;
        std::vector<float> window(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height));
        gl.glPixelStorei(GL_PACK_ALIGNMENT, 1);
        gl.glReadPixels(0, 0, c.width, c.height, GL_DEPTH_COMPONENT, GL_FLOAT, window.data());
        const double scale = std::isfinite(c.far) ? c.far / (c.far - c.near) : 1;
        run.depth.reset(c.width, c.height);
        for (int y = 0; y < c.height; ++y)
            for (int x = 0; x < c.width; ++x) {  // OpenGL's first row is the lowest
                const float d = window[static_cast<std::size_t>(c.height - 1 - y) * static_cast<std::size_t>(c.width)
                                       + static_cast<std::size_t>(x)];
                if (d < 1) run.depth.at(x, y) = static_cast<float>(1 - d / scale);
            }
    }

    const PeerRequest&    m_request;
    const GlFunctions&    gl;          // named as its functions are known
    std::vector<Buffers>  m_buffers;   // one per mesh
    std::vector<GlMatrix> m_matrices;  // one per instance
};

}  // namespace

Result<PeerRun> drawFramesByLlvmpipe(const PeerRequest& request)
{
    const auto functions = GlFunctions::load();
    if (!functions) return Error{Trouble::Input, "libOSMesa.so.8 is not there any more, or lacks functions"};
    return GlRun(request, *functions).run();
}

}  // namespace zscope::cli
