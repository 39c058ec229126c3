// Explanations against the definition: who meets a pixel, who wins it, and whether each loser's stated reason is true.
#include <algorithm>
#include <bit>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/lesson/explain.h"
#include "core/measure/definition.h"
#include "core/measure/verify.h"
#include "core/method/intervals.h"
#include "core/probe/words.h"
#include "core/scan/pixel_events.h"
#include "tests/replay/replay_support.h"

namespace zscope::tests {
namespace {

/// What the definition says of a scene, once.
struct Truth {
    explicit Truth(const SeenScene& scene, FaceCulling faceCulling = FaceCulling::None)
        : seen(scene), culling(faceCulling), picture(*referencePicture(scene.scene->scene(), scene.camera, culling))
    {}

    const SeenScene& seen;
    FaceCulling      culling;
    Picture          picture;

    /// Every pixel of the box shows something strictly nearer.
    bool isNearerAllOver(const PixelBox& box, float depth) const
    {
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x)
                if (!(depth < stored(x, y))) return false;
        return true;
    }
    /// As a visibility buffer holds it: background just below everything that is kept.
    float stored(int x, int y) const
    {
        return picture.ids.at(x, y) >= 0
                   ? picture.depth.at(x, y)
                   : DepthEncoding(DepthFormat::ReversedFloat32, seen.camera.near, seen.camera.far).empty;
    }
};

/// The triangles that cover each point by the definition, with their nearest depths: one walk for all points.
std::vector<std::vector<CoveringTriangle>> coveringAt(const Truth& truth, std::span<const PixelPosition> points)
{
    const Scene&                               scene = truth.seen.scene->scene();
    const definition::View                     view(truth.seen.camera, truth.culling);
    std::vector<std::vector<CoveringTriangle>> all(points.size());
    std::vector<definition::Part>              parts;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
        for (std::uint32_t id = scene.firstTriangle[i]; id < scene.firstTriangle[i + 1]; ++id) {
            definition::partsOf(scene, InstanceId{i}, id - scene.firstTriangle[i], view, parts);
            for (const definition::Part& part : parts)
                for (std::size_t p = 0; p < points.size(); ++p) {
                    const auto [x, y] = points[p];
                    if (!part.box().holds(x, y) || !part.covers(x, y)) continue;
                    const float depth = part.depth(x, y);
                    if (all[p].empty() || all[p].back().triangle != TriangleId{id})
                        all[p].push_back({TriangleId{id}, depth, depth >= view.farDepth});
                    else if (depth > all[p].back().depth)
                        all[p].back() = {TriangleId{id}, depth, depth >= view.farDepth};
                }
        }
    return all;
}

float depthIn(const std::vector<CoveringTriangle>& covering, TriangleId id)
{
    const auto found = std::ranges::lower_bound(covering, id, {}, &CoveringTriangle::triangle);
    return found == covering.end() || found->triangle != id ? -1 : found->depth;
}

/// Whether the reason that a loser gives is true of the definition's picture. Depths are the definition's to the bit
/// but where whole faces are drawn.
void expectTrue(const PixelCandidate& c, PixelPosition p, const Truth& truth,
                const std::vector<CoveringTriangle>& covering, bool byFace, bool hasReliefs)
{
    const auto depthOf   = [&](TriangleId id) { return depthIn(covering, id); };
    const auto sameDepth = [&](float depth, TriangleId id) {
        if (!byFace) {
            EXPECT_EQ(std::bit_cast<std::uint32_t>(depth), std::bit_cast<std::uint32_t>(depthOf(id))) << id.value;
        }
    };
    const Event* decisive = c.decisive ? &c.events[*c.decisive] : nullptr;
    if (c.fate == fates::kWinner) return;
    if (c.fate.kind == FateKind::Overtaken || c.fate.kind == FateKind::Behind) {
        ASSERT_TRUE(decisive && c.rival && decisive->rivalDepth);
        const float rivalDepth = *decisive->rivalDepth;
        EXPECT_EQ(c.stepsBehind, float32StepsBetween(decisive->depth, rivalDepth));
        if (!byFace && !hasReliefs) {
            EXPECT_EQ(decisive->depth, c.depth);
        }
        if (hasReliefs) {
            EXPECT_GE(decisive->depth, c.depth) << "a bound, until the relief is asked";
        }
        if (!hasReliefs || c.fate != fates::kIntervalLost) sameDepth(rivalDepth, *c.rival);
        EXPECT_LE(decisive->depth, rivalDepth);
        if (decisive->depth == rivalDepth) {
            EXPECT_EQ(c.stepsBehind, 0u);
            EXPECT_LT(*c.rival, c.drawnAs) << "the lower id wins";
        }
        if (c.fate == fates::kIntervalLost) {
            EXPECT_GT(c.stepsBehind, 2u);
        }
    } else if (c.fate.kind == FateKind::Hidden) {
        ASSERT_TRUE(decisive && decisive->pixels);
        EXPECT_EQ(decisive->effect, Effect::Ends);
        EXPECT_TRUE(decisive->pixels->holds(p));
        EXPECT_TRUE(truth.isNearerAllOver(*decisive->pixels, decisive->depth)) << "really hidden";
        EXPECT_LE(c.depth, decisive->depth);
        EXPECT_LT(decisive->depth, truth.stored(p.x, p.y));
        EXPECT_EQ(c.fate == fates::kNodeHidden, decisive->node.has_value() && decisive->word == "node-hidden");
        EXPECT_EQ(c.fate == fates::kTileRejected, decisive->word == "tile-rejected");
    } else if (c.fate == fates::kHole) {
        EXPECT_EQ(c.cover, Cover::Hole);
    } else if (c.fate == fates::kBeyondFar) {
        EXPECT_EQ(c.cover, Cover::BeyondFar);
    } else if (c.fate == fates::kBackFace) {
        EXPECT_EQ(c.cover, Cover::BackFace);
    } else if (c.fate == fates::kNearClip) {
        EXPECT_EQ(c.cover, Cover::BeforeNear);
        EXPECT_GT(c.depth, 1);
    } else if (c.fate == fates::kBlended || c.fate == fates::kBehindOpaque) {
        EXPECT_EQ(c.cover, Cover::Transparent);
        EXPECT_EQ(c.fate == fates::kBlended, c.depth > truth.picture.depth.at(p.x, p.y));
    } else if (c.fate == fates::kNotFilled) {
        EXPECT_TRUE(byFace || c.cover == Cover::Hole) << c.triangle.value << ' ' << c.sentence;
    } else {
        ADD_FAILURE() << "what covers a pixel is in view: " << c.sentence;
    }
}

/// How many explanations ended in each fate, over all.
std::map<std::string_view, int> expectExplained(const Truth& truth, const Pipeline& pipeline, std::size_t pixels,
                                                std::uint64_t seed)
{
    const auto& [what, prepared, camera] = truth.seen;
    const Scene& scene                   = prepared->scene();
    const bool   byFace                  = drawsFaces(pipeline);
    const bool   hasReliefs              = std::ranges::any_of(scene.meshes, [](const auto& mesh) {
        return std::ranges::any_of(mesh->materials, [](const Material& m) { return m.relief.has_value(); });
    });
    DrawRequest  request                 = truth.seen.request(pipeline);
    request.faceCulling                  = truth.culling;
    const auto points                    = randomPixels(camera, pixels, seed);
    const auto all                       = explainPixels(request, points);
    EXPECT_TRUE(all.ok());
    if (!all.ok()) return {};
    EXPECT_EQ(all->size(), points.size());

    const auto coveringOf = coveringAt(truth, points);
    Renderer   renderer;
    Frame      frame;
    EXPECT_TRUE(renderer.draw(request, frame).ok());
    std::map<std::string_view, int> counts;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PixelPosition     p = points[i];
        const PixelExplanation& e = (*all)[i];
        SCOPED_TRACE(what + ' ' + nameOf(pipeline) + " pixel " + std::to_string(p.x) + ',' + std::to_string(p.y) + '\n'
                     + explanationToText(e));
        EXPECT_EQ(e.pixel, p);
        EXPECT_EQ(e.winner, frame.visible.idAt(p.x, p.y));
        EXPECT_EQ(e.depth, frame.visible.depthAt(p.x, p.y));
        EXPECT_FALSE(e.sentence.empty());
        if (!byFace) {
            EXPECT_EQ(e.winner, truth.picture.ids.at(p.x, p.y));
            EXPECT_EQ(e.depth, truth.picture.depth.at(p.x, p.y));
        }

        const std::vector<CoveringTriangle>& covering = coveringOf[i];
        std::set<TriangleId>                 listed;
        int                                  winners = 0;
        for (const PixelCandidate& c : e.candidates) {
            EXPECT_TRUE(listed.insert(c.triangle).second) << "listed once: " << c.triangle.value;
            EXPECT_FALSE(c.sentence.empty());
            EXPECT_EQ(c.instance, scene.instanceOf(c.triangle));
            const bool covers = depthIn(covering, c.triangle) >= 0;
            EXPECT_EQ(covers, c.cover == Cover::Opaque || c.cover == Cover::BeyondFar) << c.triangle.value;
            if (covers) {
                EXPECT_EQ(c.depth, depthIn(covering, c.triangle));
            }
            winners += c.fate == fates::kWinner && c.drawnAs == TriangleId{static_cast<std::uint32_t>(e.winner)};
            for (const Event& event : c.events) EXPECT_FALSE(event.sentence.empty());
            expectTrue(c, p, truth, covering, byFace, hasReliefs);
            ++counts[c.fate.word];
            if (testing::Test::HasFailure()) return counts;
        }
        for (const CoveringTriangle& t : covering) EXPECT_TRUE(listed.contains(t.triangle)) << t.triangle.value;
        EXPECT_EQ(winners > 0, e.winner >= 0);
        if (testing::Test::HasFailure()) return counts;
    }
    return counts;
}

class EveryPreset : public testing::TestWithParam<Preset> {};

TEST_P(EveryPreset, ExplainsAThousandPixelsOfThreeScenesAsTheReferenceSaysAndEachLosersReasonIsTrue)
{
    static const SeenScene wall = builtinScene("wall-and-city?blocks=4", 96, 64);
    static const SeenScene rows = builtinScene("rows?nx=3&ny=2&nz=4", 96, 64);
    static const SeenScene soup = soupScene(SoupKind::Loose, 3, 64, 48, 150);
    static const Truth     truths[]{Truth(wall), Truth(rows), Truth(soup)};
    for (const Truth& truth : truths) {
        const auto counts = expectExplained(truth, GetParam().pipeline, 1000, 11);
        EXPECT_GT(counts.size(), 1u) << truth.seen.what;
        if (HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(Exact, EveryPreset, testing::ValuesIn([] {
                             std::vector<Preset> exact;
                             for (const Preset& preset : presets())
                                 if (preset.claim != Claim::Approximate) exact.push_back(preset);
                             return exact;
                         }()),
                         [](const auto& param) {
                             std::string name(param.param.name);
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

/// All fates that turn up over every exact preset.
std::map<std::string_view, int> fatesOf(const SeenScene& scene, FaceCulling culling, std::size_t pixels)
{
    const Truth                     truth(scene, culling);
    std::map<std::string_view, int> all;
    for (const Preset& preset : presets()) {
        if (preset.claim == Claim::Approximate) continue;
        for (const auto& [fate, count] : expectExplained(truth, preset.pipeline, pixels, 5)) all[fate] += count;
        if (testing::Test::HasFailure()) break;
    }
    return all;
}

TEST(Explain, TellsWhichTransparentSurfacesAreBlendedAndWhichAreBehind)
{
    const auto counts = fatesOf(builtinScene("glass", 64, 48), FaceCulling::None, 200);
    EXPECT_TRUE(counts.contains(fates::kBlended.word));
    EXPECT_TRUE(counts.contains(fates::kBehindOpaque.word));
}

TEST(Explain, TellsOfHolesInCutOutMaterials)
{
    const auto counts = fatesOf(builtinScene("cutouts", 64, 48), FaceCulling::None, 200);
    EXPECT_TRUE(counts.contains(fates::kHole.word));
}

TEST(Explain, TellsOfReliefsWhereTheyMoveAFragmentBack)
{
    const auto counts = fatesOf(builtinScene("reliefs", 64, 48), FaceCulling::None, 200);
    EXPECT_TRUE(counts.contains(fates::kWinner.word) && counts.contains(fates::kFarther.word));
}

TEST(Explain, TellsOfBackFacesWhenTheyAreCulled)
{
    const auto counts = fatesOf(builtinScene("teapot?tessellation=3", 64, 48), FaceCulling::Back, 200);
    EXPECT_TRUE(counts.contains(fates::kBackFace.word));
}

TEST(Explain, TellsWhatTheNearPlaneCutAway)
{
    const auto counts = fatesOf(soupScene(SoupKind::NearCrossing, 4, 64, 48, 60), FaceCulling::None, 300);
    EXPECT_TRUE(counts.contains(fates::kNearClip.word));
}

TEST(Explain, TellsWhatLiesBeyondFar)
{
    const auto counts = fatesOf(soupScene(SoupKind::BeyondFar, 4, 64, 48, 60), FaceCulling::None, 300);
    EXPECT_TRUE(counts.contains(fates::kBeyondFar.word));
}

TEST(Explain, TellsOfTiesByTheLowerId)
{
    const auto counts = fatesOf(soupScene(SoupKind::Repeated, 4, 64, 48, 60), FaceCulling::None, 300);
    EXPECT_TRUE(counts.contains(fates::kLostTie.word));
}

TEST(Explain, EveryWayOfLosingToAPyramidOrAnIntervalTurnsUpBehindAWall)
{
    const auto counts = fatesOf(builtinScene("wall-and-city?blocks=4", 96, 64), FaceCulling::None, 300);
    for (const PixelFate& fate : {fates::kWinner, fates::kOverwritten, fates::kFarther, fates::kIntervalLost,
                                  fates::kTileRejected, fates::kTriangleHidden, fates::kNodeHidden})
        EXPECT_TRUE(counts.contains(fate.word)) << wordOf(fate);
}

TEST(Explain, TheStepsOfAnEventShowIt)
{
    const SeenScene scene = builtinScene("wall-and-city?blocks=3", 48, 32);
    for (const Preset& preset : presets()) {
        if (preset.claim == Claim::Approximate) continue;
        SCOPED_TRACE(preset.name);
        const DrawRequest request = scene.request(preset.pipeline);
        Replay            replay(request);
        int               looked = 0;
        for (const PixelPosition p : randomPixels(scene.camera, 4, 3)) {
            const auto e = explainPixel(request, p);
            ASSERT_TRUE(e.ok());
            for (const PixelCandidate& c : e->candidates) {
                for (const Event& event : c.events) {
                    if (looked > 25) break;
                    const Grain grain = event.grain;
                    ASSERT_NE(std::ranges::find(e->grains, grain), e->grains.end());
                    const auto state = replay.at(grain, event.moment.at(grain));
                    ASSERT_TRUE(state.ok()) << state.error().sentence;
                    ++looked;
                    if (event.word == "won" || event.word == "lost" || event.word == "discarded") {
                        ASSERT_TRUE(state->pixel);
                        EXPECT_EQ((PixelPosition{state->pixel->x, state->pixel->y}), p);
                        EXPECT_EQ(state->pixel->triangle, c.drawnAs);
                        EXPECT_EQ(state->pixel->won, event.word == "won");
                    } else if (event.word == "overtaken") {
                        ASSERT_TRUE(state->pixel);
                        EXPECT_EQ(state->pixel->triangle, *event.rival);
                        EXPECT_EQ(state->pixel->rival, c.drawnAs);
                    } else if (event.word == "node-hidden") {
                        ASSERT_TRUE(state->hierarchy);
                        const NodeRow& node = state->hierarchy->nodes[static_cast<std::size_t>(state->hierarchy->now)];
                        EXPECT_EQ(node.path, event.node->path);
                        EXPECT_EQ(node.instance, event.node->instance);
                    } else if (event.word == "triangle-hidden") {
                        ASSERT_TRUE(state->hierarchy && state->hierarchy->query);
                        EXPECT_EQ(state->hierarchy->askedAbout, c.triangle);
                        EXPECT_TRUE(state->hierarchy->query->hidden);
                    } else if (event.word == "tile-rejected") {
                        ASSERT_TRUE(state->tile);
                        EXPECT_EQ(state->tile->triangle, c.triangle);
                        EXPECT_TRUE(state->tile->rejected);
                    } else if (event.word == "interval-won" || event.word == "interval-lost") {
                        ASSERT_TRUE(state->interval);
                        EXPECT_EQ(state->interval->y, p.y);
                        EXPECT_TRUE(state->interval->x0 <= p.x && p.x < state->interval->x1);
                    }
                }
            }
        }
        EXPECT_GT(looked, 0);
    }
}

TEST(Explain, OfATriangleCountsItsPixelsAndNamesWhoTookTheOthers)
{
    const SeenScene         scene = builtinScene("wall-and-city?blocks=3", 64, 48);
    const Truth             truth(scene);
    std::set<std::uint32_t> ids;  // some that are seen, and some of all
    for (std::size_t i = 0; i < truth.picture.ids.values().size(); i += 211)
        if (const std::int64_t id = truth.picture.ids.values()[i]; id >= 0) ids.insert(static_cast<std::uint32_t>(id));
    for (std::uint32_t id = 0; id < scene.scene->scene().triangleCount(); id += 1997) ids.insert(id);
    for (const Preset& preset : presets()) {
        if (preset.claim != Claim::Exact) continue;
        std::map<std::string_view, int> counts;
        for (const std::uint32_t id : ids) {
            SCOPED_TRACE(std::string(preset.name) + " triangle " + std::to_string(id));
            const auto e = explainTriangle(scene.request(preset.pipeline), TriangleId{id});
            ASSERT_TRUE(e.ok());
            ++counts[e->fate.word];
            std::uint64_t shown = 0;
            for (const std::int64_t pixel : truth.picture.ids.values()) shown += pixel == std::int64_t{id};
            const TriangleTally& t = e->tally;
            EXPECT_EQ(t.shown, shown);
            EXPECT_EQ(e->fate == fates::kWinner, shown > 0);
            std::uint64_t taken = 0;
            for (const Taker& taker : e->takers) taken += taker.pixels;
            if (e->otherTakers == 0) {
                EXPECT_EQ(taken + shown, t.covered) << "who has the covered pixels";
            }
            EXPECT_LE(t.of("passed"), t.of("tested"));
            if (familyOf(preset.pipeline) == "stream") {
                EXPECT_TRUE(t.of("tested") == t.covered || e->fate == fates::kTriangleHidden
                            || e->fate == fates::kNodeHidden || t.of("tile_rejected") > 0)
                    << t.of("tested") << " of " << t.covered << '\n'
                    << explanationToText(*e);
            }
            EXPECT_FALSE(e->sentence.empty());
            if (e->fate == fates::kNodeHidden || e->fate == fates::kTriangleHidden) {
                const auto hidden =
                    std::ranges::find_if(e->events, [&](const Event& event) { return event.fate == e->fate; });
                ASSERT_NE(hidden, e->events.end());
                EXPECT_TRUE(truth.isNearerAllOver(*hidden->pixels, hidden->depth));
            }
            if (HasFailure()) return;
        }
        EXPECT_TRUE(counts.contains(fates::kWinner.word)) << preset.name;
        EXPECT_GT(counts.size(), 1u) << preset.name;
    }
}

TEST(Explain, RefusesWhatIsNotThere)
{
    const SeenScene   scene   = soupScene(SoupKind::Loose, 3, 32, 24, 20);
    const DrawRequest request = scene.request(findPreset("zbuffer")->pipeline);
    for (const PixelPosition p :
         {PixelPosition{32, 0}, PixelPosition{0, 24}, PixelPosition{-1, 0}, PixelPosition{0, -1}}) {
        const auto e = explainPixel(request, p);
        ASSERT_FALSE(e.ok());
        EXPECT_EQ(e.error().kind, Trouble::Usage);
    }
    const auto e =
        explainTriangle(request, TriangleId{static_cast<std::uint32_t>(scene.scene->scene().triangleCount())});
    ASSERT_FALSE(e.ok());
    EXPECT_EQ(e.error().kind, Trouble::Usage);
}

TEST(Explain, AFaultIsExplainedTooWithWhatShouldNotBeThere)
{
    const SeenScene scene   = soupScene(SoupKind::Loose, 9, 64, 48, 80);
    DrawRequest     request = scene.request(findPreset("edge-walk")->pipeline);
    request.pipeline.fault  = Fault::XTruncated;
    int        unexpected = 0, unfilled = 0;
    const auto all = explainPixels(request, randomPixels(scene.camera, 1500, 1));
    ASSERT_TRUE(all.ok());
    for (const PixelExplanation& e : *all)
        for (const PixelCandidate& c : e.candidates) {
            unexpected += !c.cover;
            unfilled += c.cover == Cover::Opaque && c.fate == fates::kNotFilled;
        }
    EXPECT_GT(unexpected, 0);
    EXPECT_GT(unfilled, 0);
}

TEST(Explain, TheJsonHoldsWhatTheValueHolds)
{
    const SeenScene scene = builtinScene("wall-and-city?blocks=3", 48, 32);
    const auto      e     = explainPixel(scene.request(findPreset("hzb-octree")->pipeline), {20, 16});
    ASSERT_TRUE(e.ok());
    const auto json = nlohmann::json::parse(explanationToJson(*e));
    EXPECT_EQ(json["winner"], e->winner);
    ASSERT_EQ(json["triangles"].size(), e->candidates.size());
    for (std::size_t i = 0; i < e->candidates.size(); ++i) {
        const PixelCandidate& c = e->candidates[i];
        EXPECT_EQ(json["triangles"][i]["triangle"], c.triangle.value);
        EXPECT_EQ(json["triangles"][i]["fate"], wordOf(c.fate));
        ASSERT_EQ(json["triangles"][i]["events"].size(), c.events.size());
        for (std::size_t j = 0; j < c.events.size(); ++j)
            for (const Grain grain : e->grains)
                EXPECT_EQ(json["triangles"][i]["events"][j]["steps"][std::string(wordOf(grain))],
                          c.events[j].moment.at(grain).value);
    }
}

}  // namespace
}  // namespace zscope::tests
