#include "app/cli/peers/llvmpipe_peer.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <new>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/cli/peers/llvmpipe_frames.h"

namespace zscope::cli {
namespace {

/// All of it, however often the pipe takes only a part.
bool sendAll(int pipe, const void* data, std::size_t bytes)
{
    const auto* at = static_cast<const char*>(data);
    while (bytes > 0) {
        const ssize_t sent = ::write(pipe, at, bytes);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += sent;
        bytes -= static_cast<std::size_t>(sent);
    }
    return true;
}

bool receiveAll(int pipe, void* data, std::size_t bytes)
{
    auto* at = static_cast<char*>(data);
    while (bytes > 0) {
        const ssize_t got = ::read(pipe, at, bytes);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        bytes -= static_cast<std::size_t>(got);
    }
    return true;
}

/// What goes through the pipe first; the error's sentence, or times and depths, follow.
struct Header {
    bool          ok       = false;
    Trouble       trouble  = Trouble::Input;
    double        buildMs  = 0;
    std::uint64_t sentence = 0, frames = 0, pixels = 0;  // how many letters, times and depths
};

void sendRun(int pipe, const Result<PeerRun>& run)
{
    Header header{.ok = run.ok()};
    if (!run) {
        header.trouble  = run.error().kind;
        header.sentence = run.error().sentence.size();
        if (sendAll(pipe, &header, sizeof header)) (void)sendAll(pipe, run.error().sentence.data(), header.sentence);
        return;
    }
    header.buildMs = run->buildMs;
    header.frames  = run->frameMs.size();
    header.pixels  = run->depth.values().size();
    if (sendAll(pipe, &header, sizeof header) && sendAll(pipe, run->frameMs.data(), header.frames * sizeof(double)))
        (void)sendAll(pipe, run->depth.values().data(), header.pixels * sizeof(float));
}

Result<PeerRun> receiveRun(int pipe, const PeerRequest& request)
{
    const Error endedEarly{Trouble::Limit,
                           "the process that drew with llvmpipe ended early, most likely for lack of memory"};
    Header      header;
    if (!receiveAll(pipe, &header, sizeof header)) return endedEarly;
    if (!header.ok) {
        std::string sentence(header.sentence, ' ');
        if (!receiveAll(pipe, sentence.data(), header.sentence)) return endedEarly;
        return Error{header.trouble, sentence};
    }
    PeerRun run;
    run.frameMs.resize(header.frames);
    run.buildMs = header.buildMs;
    run.depth.reset(request.camera.width, request.camera.height);
    if (!receiveAll(pipe, run.frameMs.data(), header.frames * sizeof(double))
        || !receiveAll(pipe, run.depth.values().data(), header.pixels * sizeof(float)))
        return endedEarly;
    return run;
}

/// The frames in a process of their own, which inherits the scene. It makes the only threads it has itself.
Result<PeerRun> runApart(const PeerRequest& request, int threads)
{
    int ends[2];
    if (::pipe(ends) != 0) return Error{Trouble::Limit, "no pipe for the process that draws with llvmpipe"};
    const pid_t child = ::fork();
    if (child < 0) {
        ::close(ends[0]);
        ::close(ends[1]);
        return Error{Trouble::Limit, "no process to draw with llvmpipe"};
    }
    if (child == 0) {
        ::close(ends[0]);
        ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
        ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        try {
            sendRun(ends[1], drawFramesByLlvmpipe(request));
        } catch (const std::bad_alloc&) {
            sendRun(ends[1], Error{Trouble::Limit, "the scene does not fit into memory beside OSMesa's copy of it"});
        }
        ::_exit(0);
    }
    ::close(ends[1]);
    Result<PeerRun> run = receiveRun(ends[0], request);
    ::close(ends[0]);
    while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {}
    return run;
}

double medianOf(std::vector<double> values)
{
    std::ranges::sort(values);
    return values[(values.size() - 1) / 2];
}

}  // namespace

Result<PeerRun> drawByLlvmpipe(const PeerRequest& request)
{
    std::vector<int> settings{0};
    if (request.threads > 1) settings.insert(settings.end(), {request.threads - 1, request.threads});
    Result<PeerRun> best = Error{Trouble::Input, "nothing was drawn"};
    for (const int threads : settings) {
        Result<PeerRun> run = runApart(request, threads);
        if (!run) return run.error();
        run->setting = fmt::format("LP_NUM_THREADS={}{}", threads,
                                   request.scene.instances.size() > 1 ? ", one draw call per instance" : "");
        if (!best || medianOf(run->frameMs) < medianOf(best->frameMs)) best = std::move(run);
    }
    return best;
}

}  // namespace zscope::cli
