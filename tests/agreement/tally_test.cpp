// A timed run of plain text tells in its tallies what an observed run of the same frame counts, number by number.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/base/tally.h"
#include "core/frame/renderer.h"
#include "core/scene/load.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

std::uint64_t valueOf(const std::vector<NamedCount>& counts, std::string_view name)
{
    const auto found = std::ranges::find(counts, name, &NamedCount::name);
    return found == counts.end() ? 0 : found->value;
}

DrawRequest requestFor(const std::string& scene, FaceCulling culling)
{
    auto loaded = loadScene("builtin:" + scene);
    EXPECT_TRUE(loaded.ok()) << scene;
    ViewRequest view = loaded->views.empty() ? ViewRequest{} : loaded->views.front().view;
    view.width = 96, view.height = 64;
    const auto  camera = makeCamera(view, loaded->bounds);
    DrawRequest request;
    request.scene       = std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(loaded)));
    request.camera      = *camera;
    request.faceCulling = culling;
    request.threads     = 1;
    request.shortcuts   = ShortcutSet();
    return request;
}

class Tallies : public testing::TestWithParam<std::string_view> {};

TEST_P(Tallies, OfPlainTextAreTheCountsOfAnObservedRun)
{
    std::uint64_t compared = 0;
    for (const char* scene : {"teapot", "city?blocks=2", "soccer-field?count=60", "glass", "cutouts", "reliefs"})
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            SCOPED_TRACE(scene);
            DrawRequest request = requestFor(scene, culling);
            request.pipeline    = findPreset(GetParam())->pipeline;
            Renderer renderer;
            Frame    frame;
            for (int drawn = 0; drawn < 3; ++drawn) {  // what the frames before have left is taken over
                const auto report = renderer.draw(request, frame);
                ASSERT_TRUE(report.ok()) << report.error().text();
                const auto tallies = report->tally.named();
                const auto work    = renderer.count(request);
                ASSERT_TRUE(work.ok());
                for (const NamedCount& tally : tallies) {
                    EXPECT_EQ(tally.value, valueOf(work->counters, tally.name)) << tally.name << ", frame " << drawn;
                    ++compared;
                }
                for (const char* name : {"vertices_transformed", "triangle_set_ups", "pixels_tested", "nodes_visited",
                                         "pyramid_queries", "spans", "fragments_shaded", "pixels_blended"})
                    EXPECT_EQ(valueOf(report->tally.named(), name), valueOf(work->counters, name)) << name;
            }
        }
    EXPECT_GT(compared, 100u);
}

std::vector<std::string_view> namesOfPresets()
{
    std::vector<std::string_view> names;
    for (const Preset& preset : presets()) names.push_back(preset.name);
    return names;
}
INSTANTIATE_TEST_SUITE_P(EveryPreset, Tallies, testing::ValuesIn(namesOfPresets()), [](const auto& named) {
    std::string name(named.param);
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(Tallies, OfSeveralStripesAddUp)
{
    DrawRequest request = requestFor("teapot", FaceCulling::None);
    request.pipeline    = findPreset("scanline")->pipeline;
    Renderer   renderer;
    Frame      frame;
    const auto one  = renderer.draw(request, frame);
    request.threads = 2;
    const auto two  = renderer.draw(request, frame);
    ASSERT_TRUE(one.ok() && two.ok());
    for (const char* name : {"active_edge_lines", "spans", "pixels_tested", "fragments_shaded"})
        EXPECT_EQ(valueOf(one->tally.named(), name), valueOf(two->tally.named(), name)) << name;
}

TEST(Tallies, ShortcutsTellWhatTheyDidThemselves)
{
    DrawRequest request = requestFor("soccer-field?count=60", FaceCulling::Back);
    Renderer    renderer;
    Frame       frame;
    const auto  talliesOf = [&](const char* preset, ShortcutSet shortcuts) {
        request.pipeline  = findPreset(preset)->pipeline;
        request.shortcuts = shortcuts;
        return renderer.draw(request, frame)->tally.named();
    };
    const auto fast = talliesOf("zbuffer", ShortcutSet::all()), plain = talliesOf("zbuffer", ShortcutSet());
    EXPECT_GT(valueOf(fast, "windows"), 0u);
    EXPECT_EQ(valueOf(fast, "pixels_tested"), 0u) << "windows are counted there, not pixels";
    EXPECT_LT(valueOf(fast, "triangle_set_ups"), valueOf(plain, "triangle_set_ups")) << "patches that face away";
    EXPECT_LT(valueOf(talliesOf("hzb-octree", ShortcutSet::all()), "pyramid_queries"),
              valueOf(talliesOf("hzb-octree", ShortcutSet()), "pyramid_queries"))
        << "small triangles are not worth a question";
}

}  // namespace
}  // namespace zscope::tests
