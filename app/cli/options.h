// The options that several subcommands share: which scene, seen how, drawn how. What is written here is what
// `--help` says and what cli.md's sections "View" and "How" promise.
//
// Order      words are checked before a scene is loaded, so that a misspelt option never costs a wait
// Errors     Usage for words and values; Input for files that cannot be used
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/session.h"
#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/scene/load.h"

namespace zscope::cli {

inline constexpr std::int64_t  kMaxFrames     = 1'000'000;
inline constexpr std::uint64_t kMaxCameraFile = 1 << 20;  // bytes; ten numbers need a few hundred

inline Error usage(std::string sentence) { return {Trouble::Usage, std::move(sentence)}; }

/// A scene as a subcommand needs it.
struct LoadedScene {
    std::shared_ptr<const Scene>         scene;
    std::shared_ptr<const PreparedScene> prepared;
};

class SceneOption {
public:
    void add(CLI::App& parser);

    const std::string& word() const { return m_word; }
    /// Loads it and shows its first warnings.
    Result<std::shared_ptr<const Scene>> load(Session& session, std::uint64_t memoryLimit) const;
    /// The same, made ready for drawing.
    Result<LoadedScene> prepare(Session& session, std::uint64_t memoryLimit) const;

private:
    std::string m_word;
};

Result<std::shared_ptr<const Scene>> loadScene(const std::string& word, Session& session, std::uint64_t memoryLimit,
                                               std::size_t warningsShown, LoadTimes* times = nullptr);

/// What was said about the view, checked as far as it can be without a scene.
struct ViewWords {
    ViewRequest                request;  // what was not said is as in a default request
    std::vector<std::string>   given;    // option names, without --cull
    std::optional<FaceCulling> faceCulling;

    struct View {
        Camera      camera;
        FaceCulling faceCulling = FaceCulling::None;
    };
    /// The scene's own view of that name, or its first, with what was said put over it.
    ViewRequest requestFor(const Scene& scene, std::string_view viewName = {}) const;
    /// The camera of that, completed from the scene's bounds.
    Result<View> of(const Scene& scene, std::string_view viewName = {}) const;
};

class ViewOptions {
public:
    void              add(CLI::App& parser);
    Result<ViewWords> read() const;
    /// The file of --camera; empty: none was named.
    std::string cameraFile() const { return m_camera.value_or(""); }

private:
    Result<ViewWords> readCamera(ViewWords words) const;
    Result<ViewWords> readParts(ViewWords words) const;

    std::optional<std::string> m_size, m_eye, m_target, m_up, m_fov, m_near, m_far, m_cull, m_camera;
};

/// A composition with the name it is reported by.
struct NamedPipeline {
    std::string name;
    Pipeline    pipeline;
    Claim       claim = Claim::Exact;
};

struct How {
    std::vector<NamedPipeline> algorithms;       // one, unless the subcommand takes several
    int                        threads     = 0;  // 0: one per core
    Simd                       simd        = Simd::Auto;
    ShortcutSet                shortcuts   = ShortcutSet::all();
    std::uint64_t              memoryLimit = 0;  // bytes; 0: the default

    const NamedPipeline& algorithm() const { return algorithms.front(); }
    DrawRequest          request(const LoadedScene& scene, const ViewWords::View& view, const Session& session) const;
};

class HowOptions {
public:
    /// One: `--algorithm NAME`. Several: `--algorithm NAME[,NAME...]|all`.
    enum class Algorithms { One, Several };
    void        add(CLI::App& parser, Algorithms algorithms);
    Result<How> read() const;

private:
    Algorithms                 m_algorithms = Algorithms::One;
    std::optional<std::string> m_algorithm, m_fault, m_threads, m_simd, m_shortcuts, m_memoryLimit;
    std::vector<std::string>   m_set;
};

/// "zbuffer,scanline" or "all".
Result<std::vector<NamedPipeline>> algorithmsOf(std::string_view words);
/// The same for times side by side: "all" leaves out what would be drawn by plain text beside fast text.
Result<std::vector<NamedPipeline>> algorithmsToTime(std::string_view words, ShortcutSet shortcuts);
/// 0: one per core.
Result<int>           threadsOf(std::string_view word);
Result<Simd>          simdOf(std::string_view word);
Result<std::uint64_t> memoryLimitOf(std::string_view word);

}  // namespace zscope::cli
