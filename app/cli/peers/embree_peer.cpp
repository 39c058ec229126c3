#include "app/cli/peers/embree_peer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <new>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "core/base/stopwatch.h"
#include "core/measure/frame_quota.h"

namespace zscope::cli {
namespace {

template <class Handle, void (*release)(Handle)>
struct Release {
    using pointer = Handle;
    void operator()(Handle handle) const { release(handle); }
};
using Device   = std::unique_ptr<RTCDevice, Release<RTCDevice, rtcReleaseDevice>>;
using RtcScene = std::unique_ptr<RTCScene, Release<RTCScene, rtcReleaseScene>>;
using Geometry = std::unique_ptr<RTCGeometry, Release<RTCGeometry, rtcReleaseGeometry>>;

/// Hits on the side that a counter-clockwise triangle turns away are no hits.
void dropBackFaces(const RTCFilterFunctionNArguments* arguments)
{
    RTCRayN*       ray = arguments->ray;
    RTCHitN*       hit = arguments->hit;
    const unsigned n   = arguments->N;
    for (unsigned i = 0; i < n; ++i) {
        const float along = RTCHitN_Ng_x(hit, n, i) * RTCRayN_dir_x(ray, n, i)
                            + RTCHitN_Ng_y(hit, n, i) * RTCRayN_dir_y(ray, n, i)
                            + RTCHitN_Ng_z(hit, n, i) * RTCRayN_dir_z(ray, n, i);
        if (along >= 0) arguments->valid[i] = 0;
    }
}

/// Whether the triangle turns its back to the eye.
bool facesAway(const Scene& scene, TriangleId id, const dvec3& eye)
{
    const InstanceId i        = scene.instanceOf(id);
    const Mesh&      mesh     = scene.meshOf(i);
    const Affine&    toWorld  = scene.instances[i.value].toWorld;
    const auto&      triangle = mesh.triangles[id.value - scene.firstTriangle[i.value]];
    const dvec3      p = toWorld(mesh.positions[triangle[0]]), e = toWorld(mesh.positions[triangle[1]]) - p,
                f       = toWorld(mesh.positions[triangle[2]]) - p;
    const dvec3  v      = p - eye;
    const double volume = v.x * (e.y * f.z - e.z * f.y) + v.y * (e.z * f.x - e.x * f.z) + v.z * (e.x * f.y - e.y * f.x);
    return toWorld.isMirrored() ? volume < 0 : volume > 0;
}

enum class Mode { Packets8, Packets16, Streams };
constexpr std::array kModes{Mode::Packets8, Mode::Packets16, Mode::Streams};

std::string_view titleOf(Mode mode)
{
    switch (mode) {
        case Mode::Packets8:
            return "packets of 8";
        case Mode::Packets16:
            return "packets of 16";
        case Mode::Streams:
            break;
    }
    return "streams of 256";
}

constexpr int kTile = 16;  // pixels a side: what one thread traces at a time, and one stream

class Tracer {
public:
    explicit Tracer(const PeerRequest& request)
        : m_request(request), m_scene(request.scene), m_device(rtcNewDevice(nullptr))
    {}

    Result<PeerRun> run()
    {
        if (!m_device) return Error{Trouble::Input, "Embree cannot start on this machine"};
        Stopwatch start;
        build();
        PeerRun run;
        run.buildMs = start.lap();
        if (const RTCError trouble = rtcGetDeviceError(m_device.get()); trouble != RTC_ERROR_NONE)
            return Error{trouble == RTC_ERROR_OUT_OF_MEMORY ? Trouble::Limit : Trouble::Input,
                         fmt::format("Embree cannot take this scene (its error {})", static_cast<int>(trouble))};

        const auto pixels =
            static_cast<std::size_t>(m_request.camera.width) * static_cast<std::size_t>(m_request.camera.height);
        m_ids.assign(pixels, kNone);
        m_depth.assign(pixels, 0);
        trace(Mode::Packets16);
        const bool filters = m_request.faceCulling == FaceCulling::Back && showsBackFaces();
        if (filters) cullBackFaces();

        const Mode mode = fastestMode();
        for (int frame = 0; frame < m_request.warmUp; ++frame) trace(mode);
        for (FrameQuota quota(m_request.frames, m_request.leastMs); quota.wantsMore();
             quota.drawn(run.frameMs.back())) {
            if (m_request.progress.cancelled()) return Error{Trouble::Cancelled, "the rays were not wanted any more"};
            Stopwatch begun;
            trace(mode);
            run.frameMs.push_back(begun.lap());
        }
        run.setting = fmt::format("{}{}{}", titleOf(mode), m_usesInstances ? ", instances" : "",
                                  filters ? ", back faces filtered" : "");
        deliver(run);
        return run;
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    Geometry triangles(std::size_t vertices, std::size_t triangles, float*& positions, std::uint32_t*& corners)
    {
        Geometry geometry(rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_HIGH);
        positions = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
        corners   = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
              geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles));
        if (!positions || !corners) throw std::bad_alloc();
        return geometry;
    }

    static void append(const Mesh& mesh, const Affine& toWorld, std::uint32_t firstVertex, float*& positions,
                       std::uint32_t*& corners)
    {
        for (const dvec3& p : mesh.positions) {
            const dvec3 world = toWorld(p);
            for (int k = 0; k < 3; ++k) *positions++ = static_cast<float>(world[k]);
        }
        // Embree takes the side that a triangle shows from the order of its corners alone.
        const std::array<std::size_t, 3> order =
            toWorld.isMirrored() ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
        for (const auto& triangle : mesh.triangles)
            for (const std::size_t k : order) *corners++ = firstVertex + triangle[k];
    }

    RtcScene newScene()
    {
        RtcScene scene(rtcNewScene(m_device.get()));
        rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_HIGH);
        return scene;
    }

    void build()
    {
        m_top = newScene();
        m_usesInstances =
            m_scene.triangleCount() > kMostWrittenOut && m_scene.instances.size() > 1
            && std::ranges::none_of(m_scene.instances, [](const Instance& i) { return i.toWorld.isMirrored(); });
        m_usesInstances ? buildInstances() : buildOneMesh();
        rtcCommitScene(m_top.get());
    }

    void buildOneMesh()
    {
        std::size_t vertices = 0;
        for (std::uint32_t i = 0; i < m_scene.instances.size(); ++i)
            vertices += m_scene.meshOf(InstanceId{i}).positions.size();
        float*         positions = nullptr;
        std::uint32_t* corners   = nullptr;
        if (m_scene.triangleCount() == 0) return;
        Geometry      geometry = triangles(vertices, m_scene.triangleCount(), positions, corners);
        std::uint32_t first    = 0;
        for (std::uint32_t i = 0; i < m_scene.instances.size(); ++i) {
            const Mesh& mesh = m_scene.meshOf(InstanceId{i});
            append(mesh, m_scene.instances[i].toWorld, first, positions, corners);
            first += static_cast<std::uint32_t>(mesh.positions.size());
        }
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(m_top.get(), geometry.get(), 0);
        m_geometries.push_back(std::move(geometry));
    }

    void buildInstances()
    {
        for (const auto& mesh : m_scene.meshes) {
            m_meshScenes.push_back(newScene());
            if (mesh->triangles.empty()) continue;
            float*         positions = nullptr;
            std::uint32_t* corners   = nullptr;
            Geometry       geometry  = triangles(mesh->positions.size(), mesh->triangles.size(), positions, corners);
            append(*mesh, Affine{}, 0, positions, corners);
            rtcCommitGeometry(geometry.get());
            rtcAttachGeometryByID(m_meshScenes.back().get(), geometry.get(), 0);
            rtcCommitScene(m_meshScenes.back().get());
            m_geometries.push_back(std::move(geometry));
        }
        for (std::uint32_t i = 0; i < m_scene.instances.size(); ++i) {
            const Instance&       instance = m_scene.instances[i];
            Geometry              placed(rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
            std::array<float, 12> matrix;
            for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t c = 0; c < 4; ++c) matrix[4 * r + c] = static_cast<float>(instance.toWorld.rows[r][c]);
            rtcSetGeometryInstancedScene(placed.get(), m_meshScenes[instance.mesh.value].get());
            rtcSetGeometryTransform(placed.get(), 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, matrix.data());
            rtcCommitGeometry(placed.get());
            rtcAttachGeometryByID(m_top.get(), placed.get(), i);
        }
    }

    bool showsBackFaces() const
    {
        // one pixel in so many: faces seen edge on, which count as pixels that differ
        constexpr std::size_t kTolerated = 1000;
        const auto            isBack     = [this](std::uint32_t id) {
            return id != kNone && facesAway(m_scene, TriangleId{id}, m_request.camera.eye);
        };
        return static_cast<std::size_t>(std::ranges::count_if(m_ids, isBack)) * kTolerated > m_ids.size();
    }

    void cullBackFaces()
    {
        for (const Geometry& geometry : m_geometries) {
            rtcSetGeometryIntersectFilterFunction(geometry.get(), dropBackFaces);
            rtcCommitGeometry(geometry.get());
        }
        for (const RtcScene& scene : m_meshScenes) rtcCommitScene(scene.get());
        rtcCommitScene(m_top.get());
    }

    Mode fastestMode()
    {
        constexpr int kTrials = 5;
        Mode          fastest = Mode::Packets16;
        double        least   = 1e300;
        for (const Mode mode : kModes) {
            trace(mode);
            for (int trial = 0; trial < kTrials; ++trial) {
                Stopwatch begun;
                trace(mode);
                if (const double ms = begun.lap(); ms < least) {
                    least   = ms;
                    fastest = mode;
                }
            }
        }
        return fastest;
    }

    void trace(Mode mode)
    {
        const int columns = (m_request.camera.width + kTile - 1) / kTile,
                  rows    = (m_request.camera.height + kTile - 1) / kTile;
        const int tiles   = columns * rows;
#pragma omp parallel for schedule(dynamic, 4) num_threads(m_request.threads)
        for (int tile = 0; tile < tiles; ++tile) {
            const int x = tile % columns * kTile, y = tile / columns * kTile;
            switch (mode) {
                case Mode::Packets8:
                    traceTile<RTCRayHit8, 8>(x, y, false);
                    break;
                case Mode::Packets16:
                    traceTile<RTCRayHit16, 16>(x, y, false);
                    break;
                case Mode::Streams:
                    traceTile<RTCRayHit16, 16>(x, y, true);
                    break;
            }
        }
    }

    /// The 256 rays of a tile in packets four pixels wide, one packet after another or all in one stream.
    template <class Packet, int N>
    void traceTile(int tileX, int tileY, bool asStream)
    {
        constexpr int                            kWide = 4, kHigh = N / kWide, kPackets = kTile * kTile / N;
        alignas(64) std::array<Packet, kPackets> packets;
        alignas(64) std::array<int, N>           valid;
        RTCIntersectContext                      context;
        rtcInitIntersectContext(&context);
        context.flags       = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        const auto cornerOf = [&](int p) {
            return std::array{tileX + p % (kTile / kWide) * kWide, tileY + p / (kTile / kWide) * kHigh};
        };
        for (int p = 0; p < kPackets; ++p) {
            const auto [x, y] = cornerOf(p);
            aim<N, kWide>(packets[static_cast<std::size_t>(p)], valid, x, y, asStream);
            if (asStream) continue;
            if constexpr (N == 8)
                rtcIntersect8(valid.data(), m_top.get(), &context, &packets[static_cast<std::size_t>(p)]);
            else
                rtcIntersect16(valid.data(), m_top.get(), &context, &packets[static_cast<std::size_t>(p)]);
        }
        if (asStream)
            rtcIntersectNM(m_top.get(), &context, reinterpret_cast<RTCRayHitN*>(packets.data()), N, kPackets,
                           sizeof(Packet));
        for (int p = 0; p < kPackets; ++p) {
            const auto [x, y] = cornerOf(p);
            store<N, kWide>(packets[static_cast<std::size_t>(p)], x, y);
        }
    }

    template <int N, int kWide, class Packet>
    void aim(Packet& packet, std::array<int, N>& valid, int x0, int y0, bool asStream) const
    {
        const Camera& c     = m_request.camera;
        const auto    scale = static_cast<float>(1 / (0.5 * c.height * c.focal));
        const auto    part  = [](double v) { return static_cast<float>(v); };
        const float   halfW = 0.5f * static_cast<float>(c.width), halfH = 0.5f * static_cast<float>(c.height);
        for (int lane = 0; lane < N; ++lane) {
            const auto  i = static_cast<std::size_t>(lane);
            const int   x = x0 + lane % kWide, y = y0 + lane / kWide;
            const float right   = (static_cast<float>(x) + 0.5f - halfW) * scale,
                        up      = (halfH - static_cast<float>(y) - 0.5f) * scale;
            const bool isInside = x < c.width && y < c.height;
            valid[i]            = isInside ? -1 : 0;
            packet.ray.org_x[i] = part(c.eye.x);
            packet.ray.org_y[i] = part(c.eye.y);
            packet.ray.org_z[i] = part(c.eye.z);
            // Along the view it is one unit long, so that distances on the ray are depths of view space.
            packet.ray.dir_x[i] = part(c.forward.x) + right * part(c.right.x) + up * part(c.up.x);
            packet.ray.dir_y[i] = part(c.forward.y) + right * part(c.right.y) + up * part(c.up.y);
            packet.ray.dir_z[i] = part(c.forward.z) + right * part(c.right.z) + up * part(c.up.z);
            packet.ray.tnear[i] = part(c.near);
            // a stream has no list of the valid ones
            packet.ray.tfar[i]      = asStream && !isInside ? -1.0f : part(c.far);
            packet.ray.time[i]      = 0;
            packet.ray.mask[i]      = ~0u;
            packet.ray.id[i]        = 0;
            packet.ray.flags[i]     = 0;
            packet.hit.geomID[i]    = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
    }

    template <int N, int kWide, class Packet>
    void store(const Packet& packet, int x0, int y0)
    {
        const Camera& c    = m_request.camera;
        const auto    near = static_cast<float>(c.near);
        for (int lane = 0; lane < N; ++lane) {
            const auto i = static_cast<std::size_t>(lane);
            const int  x = x0 + lane % kWide, y = y0 + lane / kWide;
            if (x >= c.width || y >= c.height) continue;
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(c.width) + static_cast<std::size_t>(x);
            const bool isHit = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
            const auto first = m_usesInstances && isHit ? m_scene.firstTriangle[packet.hit.instID[0][i]] : 0;
            m_ids[pixel]     = isHit ? first + packet.hit.primID[i] : kNone;
            m_depth[pixel]   = isHit ? near / packet.ray.tfar[i] : 0;
        }
    }

    void deliver(PeerRun& run) const
    {
        run.ids.reset(m_request.camera.width, m_request.camera.height, -1);
        run.depth.reset(m_request.camera.width, m_request.camera.height);
        for (std::size_t i = 0; i < m_ids.size(); ++i)
            if (m_ids[i] != kNone) run.ids.values()[i] = m_ids[i];
        std::ranges::copy(m_depth, run.depth.values().begin());
    }

    const PeerRequest& m_request;
    const Scene&       m_scene;

    // In this order, so that they go in the other one.
    Device                m_device;
    std::vector<Geometry> m_geometries;  // of triangles
    std::vector<RtcScene> m_meshScenes;  // one per mesh, if instances are used
    RtcScene              m_top;
    bool                  m_usesInstances = false;

    std::vector<std::uint32_t> m_ids;
    std::vector<float>         m_depth;
};

}  // namespace

Result<PeerRun> traceByEmbree(const PeerRequest& request)
try {
    return Tracer(request).run();
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "Embree's trees do not fit into memory"};
}

}  // namespace zscope::cli
