#include "app/cli/grade_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include <fmt/format.h>

#include "app/cli/grade_command.h"
#include "app/cli/grade_journal.h"
#include "app/cli/grade_judge.h"
#include "app/cli/outputs.h"
#include "app/cli/scene_export.h"
#include "app/cli/words.h"
#include "core/base/quotable.h"
#include "core/io/file_writer.h"
#include "core/io/read_file.h"

namespace zscope::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kOutputBase     = std::uint64_t{64} << 20;  // bytes that any program may write
constexpr std::uint64_t kOutputPerPixel = 64;    // and for each pixel: depth and ids of 8 bytes, a few times
constexpr std::size_t   kWarningsShown  = 3;     // of each scene
constexpr std::size_t   kLongestSaid    = 1000;  // of a program's words, bytes: a line with a long path, whole

struct Submission {
    std::string name, path;  // no path: there is one program, which the command names
    std::string digest;
};

struct GradeScene {
    std::string                     name;
    std::string                     obj;    // under which name the program finds it
    std::vector<Shown>              shown;  // the scene's files and the camera
    Camera                          camera;
    std::optional<FaceCulling>      faceCulling;  // only if it was said
    std::string                     digest;
    std::mutex                      oneAtATime;
    std::unique_ptr<check::Checker> checker;
};

std::string absolute(const std::string& path) { return fs::absolute(path).lexically_normal().string(); }

std::string signalName(int signal)
{
    const char* name = ::sigabbrev_np(signal);
    return name ? fmt::format("signal {} (SIG{})", signal, name) : fmt::format("signal {}", signal);
}

/// The line of a program's last words that tells most: the first one with "error", else the last one.
std::string saidIn(const std::string& text)
{
    std::string last, error;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end  = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
        if (error.empty() && (line.find("error") != std::string::npos || line.find("Error") != std::string::npos))
            error = line;
        at = end + 1;
    }
    const std::string line = error.empty() ? last : error;
    return line.empty() ? "" : fmt::format(": {}", quotable(line, kLongestSaid));
}

class Grading {
public:
    Grading(const GradeOptions& options, Session& session) : m_options(options), m_session(session) {}

    Result<std::vector<GradeRow>> run()
    {
        for (const Result<Done>& done : {readWords(), checkSandbox()})
            if (!done) return done.error();
        if (const auto done = findSubmissions(); !done) return done.error();
        if (const auto done = loadScenes(); !done) return done.error();
        auto journal = GradeJournal::open(m_options.journal.value_or(""), head());
        if (!journal) return journal.error();
        m_journal = *std::move(journal);
        if (m_journal->size() > 0)
            m_session.note(fmt::format("going on with '{}': {} of {} runs are there", *m_options.journal,
                                       m_journal->size(), m_submissions.size() * m_scenes.size()));
        m_rows.resize(m_submissions.size() * m_scenes.size());
        if (const auto done = runAll(); !done) return done.error();
        std::vector<GradeRow> rows;
        for (std::optional<GradeRow>& row : m_rows) rows.push_back(*std::move(row));
        return rows;
    }

private:
    Result<Done> readWords()
    {
        if (const auto done = checkGradeCommand(m_options.program, m_options.submissions.has_value()); !done)
            return done.error();
        const auto words = m_options.view.read();
        if (!words) return words.error();
        m_view = *words;
        if (m_options.timeLimit) {
            const auto seconds = realNumber(*m_options.timeLimit, "--time-limit");
            if (!seconds) return seconds.error();
            if (*seconds <= 0) return Error{Trouble::Usage, "--time-limit is a number of seconds above 0"};
            m_limits.seconds = *seconds;
        }
        if (m_options.memoryLimit) {
            const auto bytes = memoryLimitOf(*m_options.memoryLimit);
            if (!bytes) return bytes.error();
            m_limits.memory = *bytes;
        }
        if (m_options.threads) {
            const auto threads = threadsOf(*m_options.threads);
            if (!threads) return threads.error();
            m_threads = static_cast<std::size_t>(*threads);
        }
        if (m_threads == 0) m_threads = std::max(1u, std::thread::hardware_concurrency());
        if (m_options.gradescope && m_options.submissions)
            return Error{Trouble::Usage,
                         "--gradescope is the result of one program: it cannot be mixed with --submissions"};
        std::vector<std::string> inputs = m_options.scenes;
        inputs.push_back(m_options.view.cameraFile());
        return checkOutputs({{"--journal", m_options.journal, {".json"}},
                             {"--junit", m_options.junit, {".xml"}},
                             {"--gradescope", m_options.gradescope, {".json"}}},
                            inputs);
    }

    Result<Done> checkSandbox()
    {
        std::error_code trouble;
        m_startsIn = m_options.submissions ? "" : fs::current_path(trouble).string();
        if (m_options.withoutSandbox) {
            m_confinement = Confinement::LimitsOnly;
            return Done{};
        }
        if (const auto why = whyNoSandbox())
            return Error{
                Trouble::Usage,
                fmt::format("there is no sandbox to run programs in: {}; --no-sandbox runs them without one, with all "
                            "that you may do yourself",
                            *why)};
        if (!m_startsIn.empty() && isTooMuchToShow(m_startsIn))
            return Error{Trouble::Usage,
                         fmt::format("the program may read the folder in which it starts, and '{}' is too much: "
                                     "change to the program's folder",
                                     m_startsIn)};
        return Done{};
    }

    Result<Done> findSubmissions()
    {
        if (!m_options.submissions) {
            Submission program{.name = "program", .path = "", .digest = ""};
            for (const std::string& file : filesNamedBy(m_options.program)) {
                const auto digest = digestOfFiles(file);
                if (!digest) return digest.error();
                program.digest += *digest;
            }
            m_submissions.push_back(std::move(program));
            return Done{};
        }
        std::error_code        trouble;
        fs::directory_iterator entries(*m_options.submissions, trouble);
        for (; !trouble && entries != fs::directory_iterator(); entries.increment(trouble)) {
            const std::string name = entries->path().filename().string();
            if (name.starts_with('.')) continue;
            const auto digest = digestOfFiles(entries->path().string());
            if (!digest) return digest.error();
            m_submissions.push_back({name, absolute(entries->path().string()), *digest});
        }
        if (trouble) return Error{Trouble::Input, trouble.message(), *m_options.submissions};
        if (m_submissions.empty())
            return Error{Trouble::Input, "there is no submission in this folder", *m_options.submissions};
        std::ranges::sort(m_submissions, {}, &Submission::name);
        return Done{};
    }

    Result<Done> loadScenes()
    {
        auto folder = PrivateFolder::create();
        if (!folder) return folder.error();
        m_folder.emplace(*std::move(folder));
        for (const std::string& word : m_options.scenes) {
            const auto scene = cli::loadScene(word, m_session, 0, kWarningsShown);
            if (!scene) return scene.error();
            const auto view = m_view.of(**scene);
            if (!view) return view.error();
            auto graded         = std::make_unique<GradeScene>();
            graded->name        = word;
            graded->camera      = view->camera;
            graded->faceCulling = m_view.faceCulling;
            graded->digest      = (*scene)->digest;
            if (const auto done = showFiles(**scene, *graded); !done) return done.error();
            graded->checker = std::make_unique<check::Checker>(std::make_shared<const PreparedScene>(*scene));
            m_scenes.push_back(std::move(graded));
        }
        return Done{};
    }

    /// An OBJ file is shown as it is, with the files that it names; any other scene as an OBJ file of its triangles.
    Result<Done> showFiles(const Scene& scene, GradeScene& graded) const
    {
        const std::string prefix = fmt::format("{}/{}-", m_folder->path(), m_scenes.size());
        if (hasEnding(graded.name, ".obj") && !graded.name.starts_with("builtin:")) {
            const fs::path obj = absolute(graded.name);
            graded.obj         = plainNameOf(obj.string(), "scene");
            graded.shown.push_back({obj.string(), "scene/" + graded.obj});
            for (const std::string& file : scene.files) {
                const fs::path relative = fs::path(absolute(file)).lexically_relative(obj.parent_path());
                if (!relative.empty() && *relative.begin() != ".." && relative != obj.filename())
                    graded.shown.push_back({absolute(file), "scene/" + relative.string()});
            }
        } else {
            graded.obj = "scene.obj";
            if (const auto done = writeObj(scene, prefix + graded.obj, m_session.cancel()); !done) return done.error();
            graded.shown.push_back({prefix + graded.obj, "scene/" + graded.obj});
        }
        if (const auto done = writeFile(prefix + "camera.json", cameraToJson(graded.camera)); !done)
            return done.error();
        graded.shown.push_back({prefix + "camera.json", "camera.json"});
        return Done{};
    }

    Json head() const
    {
        Json scenes = Json::array();
        for (const auto& scene : m_scenes)
            scenes.push_back({{"name", scene->name},
                              {"digest", scene->digest},
                              {"camera", cameraToJson(scene->camera)},
                              {"cull", !scene->faceCulling                        ? "found out"
                                       : *scene->faceCulling == FaceCulling::Back ? "back"
                                                                                  : "none"}});
        return {{"version", ZSCOPE_VERSION},
                {"program", m_options.program},
                {"time_limit", m_limits.seconds},
                {"memory_limit", m_limits.memory},
                {"sandbox", m_confinement == Confinement::Sandbox},
                {"scenes", std::move(scenes)}};
    }

    Result<Done> runAll()
    {
        std::vector<std::thread> workers;
        m_working = std::min(m_threads, m_rows.size());
        for (std::size_t i = std::min(m_threads, m_rows.size()); i > 0; --i) workers.emplace_back([this] { work(); });
        const Progress progress = m_session.progress();
        while (m_done < m_rows.size() && m_working > 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            progress.at(static_cast<double>(m_done) / static_cast<double>(m_rows.size()), "grading");
        }
        for (std::thread& worker : workers) worker.join();
        if (m_error) return *m_error;
        return Done{};
    }

    /// One of the threads: takes the next run until there is none.
    void work()
    {
        for (std::size_t next = 0; (next = m_next++) < m_rows.size() && !m_stop;) {
            const Submission& submission = m_submissions[next / m_scenes.size()];
            GradeScene&       scene      = *m_scenes[next % m_scenes.size()];
            if (const auto done = rowOf(submission, scene, m_rows[next]); !done) {
                const std::lock_guard lock(m_lock);
                if (!m_error) m_error = done.error();
                m_stop = true;
            }
            ++m_done;
        }
        --m_working;
    }

    Result<Done> rowOf(const Submission& submission, GradeScene& scene, std::optional<GradeRow>& row)
    {
        {
            const std::lock_guard lock(m_lock);
            if (const GradeRow* known = m_journal->find(submission.name, scene.name, submission.digest)) {
                row = *known;
                return Done{};
            }
        }
        auto graded = grade(submission, scene);
        if (!graded) return graded.error();
        row = *std::move(graded);
        const std::lock_guard lock(m_lock);
        return m_journal->add(*row);
    }

    Result<GradeRow> grade(const Submission& submission, GradeScene& scene)
    {
        if (m_session.interrupted()) return Error{Trouble::Cancelled, "interrupted"};
        auto folder = PrivateFolder::create();
        if (!folder) return folder.error();
        const std::string root   = rootOf(m_confinement, *folder) + '/';
        const std::string handed = "submission/" + plainNameOf(submission.path, "submitted");
        Job               job{.command     = withPaths(m_options.program, {{"{scene}", root + "scene/" + scene.obj},
                                                                           {"{camera}", root + "camera.json"},
                                                                           {"{out}", root + "out"},
                                                                           {"{submission}", root + handed}}),
                              .shown       = scene.shown,
                              .alsoShown   = pathsNamedBy(m_options.program),
                              .startsIn    = m_startsIn,
                              .confinement = m_confinement,
                              .limits      = m_limits};
        if (!submission.path.empty()) job.shown.push_back({submission.path, handed});
        job.limits.output = kOutputBase
                            + kOutputPerPixel * static_cast<std::uint64_t>(scene.camera.width)
                                  * static_cast<std::uint64_t>(scene.camera.height);
        const auto outcome = cli::run(job, *folder, m_session.cancel());
        if (!outcome) return outcome.error();

        GradeRow   row{.submission = submission.name,
                       .scene      = scene.name,
                       .seconds    = outcome->seconds,
                       .peakMiB    = static_cast<double>(outcome->peakMemory) / (1 << 20),
                       .detail     = {},
                       .digest     = submission.digest};
        const bool hasResult = outcome->ending == Ending::Exited && outcome->status == 0;
        const auto done      = hasResult ? judge(*folder, scene, row) : tell(*outcome, row);
        if (!done) return done.error();
        return row;
    }

    Result<Done> judge(const PrivateFolder& folder, GradeScene& scene, GradeRow& row)
    {
        check::CheckRequest request;
        request.camera          = scene.camera;
        request.given.cull      = scene.faceCulling;
        request.progress.cancel = m_session.cancel();
        const std::lock_guard lock(scene.oneAtATime);
        auto                  judged = judgeFolder(folder.out(), *scene.checker, request);
        if (!judged) return judged.error();
        row.verdict = judged->verdict;
        row.detail  = std::move(judged->detail);
        row.check   = std::move(judged->check);
        return Done{};
    }

    /// Of a program that did not end well.
    Result<Done> tell(const Outcome& outcome, GradeRow& row) const
    {
        const auto is = [&row](GradeVerdict verdict, std::string detail) {
            row.verdict = verdict;
            row.detail  = std::move(detail);
            return Done{};
        };
        switch (outcome.ending) {
            case Ending::Exited:
                return is(GradeVerdict::Failed,
                          fmt::format("it ended with status {}{}", outcome.status, saidIn(outcome.text)));
            case Ending::Signalled:
                return is(GradeVerdict::Crashed,
                          fmt::format("{} ended it{}", signalName(outcome.status), saidIn(outcome.text)));
            case Ending::TimedOut:
                return is(
                    GradeVerdict::TimedOut,
                    fmt::format("it was still running after {} s; compiling counts (--time-limit)", m_limits.seconds));
            case Ending::TooMuchMemory:
                return is(GradeVerdict::TooMuchMemory,
                          fmt::format("it came within 5 % of {} MiB", m_limits.memory >> 20));
            case Ending::TooManyProcesses:
                return is(GradeVerdict::TooMuchMemory,
                          fmt::format("it had more than {} processes", m_limits.processes));
            case Ending::TooMuchOutput:
                return is(GradeVerdict::TooMuchOutput, "it wrote more than a picture can need");
        }
        return Done{};
    }

    const GradeOptions&                      m_options;
    Session&                                 m_session;
    ViewWords                                m_view;
    Limits                                   m_limits;
    Confinement                              m_confinement = Confinement::Sandbox;
    std::string                              m_startsIn;  // empty: the private folder
    std::optional<PrivateFolder>             m_folder;    // of files that are made for all programs
    std::vector<Submission>                  m_submissions;
    std::vector<std::unique_ptr<GradeScene>> m_scenes;
    std::size_t                              m_threads = 0;

    std::vector<std::optional<GradeRow>> m_rows;  // each is written by one thread
    std::atomic<std::size_t>             m_next{0}, m_done{0}, m_working{0};
    std::atomic<bool>                    m_stop{false};
    std::mutex                           m_lock;  // of what follows
    std::optional<GradeJournal>          m_journal;
    std::optional<Error>                 m_error;
};

}  // namespace

Result<std::vector<GradeRow>> gradeAll(const GradeOptions& options, Session& session)
{
    return Grading(options, session).run();
}

}  // namespace zscope::cli
