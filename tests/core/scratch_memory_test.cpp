// What a thread's scratch memory happens to hold before its first frame: nothing of it may be used, not even by lanes
// that no triangle fills.
#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <span>

#include "core/depth/visibility_buffer.h"
#include "core/fast/kernels.h"
#include "core/scene/load.h"

namespace zscope::tests {
namespace {

/// Scratch memory made where every byte was `byte`.
class SoiledScratch {
public:
    explicit SoiledScratch(unsigned char byte) : m_memory(::operator new(sizeof(StripeScratch), kAlignment))
    {
        // volatile: nobody reads them before the constructor
        volatile auto* bytes = static_cast<unsigned char*>(m_memory);
        for (std::size_t i = 0; i < sizeof(StripeScratch); ++i) bytes[i] = byte;
        m_scratch = new (m_memory) StripeScratch;
    }
    ~SoiledScratch()
    {
        m_scratch->~StripeScratch();
        ::operator delete(m_memory, kAlignment);
    }
    SoiledScratch(const SoiledScratch&)            = delete;
    SoiledScratch& operator=(const SoiledScratch&) = delete;

    StripeScratch& operator*() const { return *m_scratch; }

private:
    static constexpr std::align_val_t kAlignment{alignof(StripeScratch)};

    void*          m_memory;
    StripeScratch* m_scratch;
};

struct Subject {
    std::shared_ptr<PreparedScene> scene;
    Camera                         camera;
};

Subject subjectOf(const char* word)
{
    Result<Scene> scene = loadScene(word);
    EXPECT_TRUE(scene.ok());
    ViewRequest view;
    if (!scene->views.empty()) view = scene->views.front().view;
    view.width = 160, view.height = 90;
    const Result<Camera> camera = makeCamera(view, scene->bounds);
    EXPECT_TRUE(camera.ok());
    return {std::make_shared<PreparedScene>(std::make_shared<const Scene>(std::move(*scene))), *camera};
}

Picture drawn(const Subject& subject, const Pipeline& pipeline, Simd simd, FaceCulling culling, StripeScratch& scratch)
{
    const Camera&    camera = subject.camera;
    const Projection projection(camera);
    VisibilityBuffer visible;
    visible.resize(camera.width, camera.height, DepthEncoding(pipeline.approximation.format, camera.near, camera.far));
    StageClock      clock;
    const LaneRules rules(pipeline.approximation, camera);
    Stripe          whole{*subject.scene, projection, culling, visible, 0, camera.height, {}};
    whole.shortcuts = ShortcutSet::all();
    kernelsOf(simd)->drawStripe(pipeline, rules, whole, scratch, clock);
    return pictureOf(visible);
}

TEST(ScratchMemory, MayHoldAnythingBeforeItsFirstFrame)
{
    for (const char* word : {"builtin:teapot", "builtin:city?blocks=4&seed=1"}) {
        const Subject subject = subjectOf(word);
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back})
            for (const SimdEntry& target : simdTargets())
                for (const Preset& preset : presets()) {
                    if (!target.available || !kernelsOf(target.target) || !hasFastText(preset.pipeline)) continue;
                    SoiledScratch clean(0), high(0xA5), low(0x5A);
                    const Picture wanted = drawn(subject, preset.pipeline, target.target, culling, *clean);
                    for (const SoiledScratch* soiled : {&high, &low})
                        EXPECT_TRUE(drawn(subject, preset.pipeline, target.target, culling, **soiled) == wanted)
                            << word << ' ' << preset.name << ' ' << target.word;
                }
    }
}

}  // namespace
}  // namespace zscope::tests
