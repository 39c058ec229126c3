#include "core/measure/suites.h"

#include <algorithm>
#include <array>

namespace zscope {

namespace {

using Names = std::string_view;

// One model of growing size, alone and in rows that hide one another.
constexpr std::array kFourModesScenes{
    SuiteScene{"builtin:teapot?tessellation=1"},   // 64 triangles
    SuiteScene{"builtin:teapot?tessellation=12"},  // 9 216
    SuiteScene{"builtin:teapot?tessellation=37"},  // 87 616
    SuiteScene{"builtin:teapot?tessellation=42"},  // 112 896
    SuiteScene{"builtin:teapot?tessellation=91"},  // 529 984
    SuiteScene{"builtin:rows?model=soccer-ball&nx=6&ny=4&nz=10"},
    SuiteScene{"builtin:rows?model=teapot&nx=10&ny=5&nz=20"},
    SuiteScene{"builtin:million"},
};
constexpr std::array<Names, 4> kFourModes{"zbuffer", "scanline", "hzb-simple", "hzb-bvh-prepass"};

constexpr std::array kTreeAndPyramidScenes{
    SuiteScene{"builtin:teapot?tessellation=33"},  // 69 696 triangles, as many as a well-known bunny
    SuiteScene{"builtin:soccer-field?count=100"}, SuiteScene{"builtin:city", "above"},
    SuiteScene{"builtin:city", "street"},         SuiteScene{"builtin:million"},
};
constexpr std::array<Names, 5> kTreeAndPyramid{"hzb-octree", "quadtree", "octree-frustum", "scanline", "zbuffer"};

constexpr std::array           kFieldScenes{SuiteScene{"builtin:soccer-field"}};
constexpr std::array<Names, 4> kField{"hzb-octree", "quadtree", "octree-order", "zbuffer"};

// Seven scenes that are measured against other renderers: one model, many, near and far, nothing hidden and nearly
// everything.
constexpr std::array kPeerScenes{
    // 69 451 triangles, as the model has
    SuiteScene{.word        = "builtin:icosphere?frequency=59&bumps=0.25&left-out=169",
               .title       = "bunny",
               .camera      = "assets/peers/bunny-stand-in.json",
               .model       = "../shared/models/stanford-bunny.obj",
               .modelCamera = "assets/peers/bunny.json"},
    SuiteScene{.word   = "builtin:soccer-field?ball=icosphere",
               .title  = "1,000 balls",
               .camera = "assets/peers/ball-field.json"},
    SuiteScene{.word = "builtin:city", .title = "city from above", .camera = "assets/peers/city-above.json"},
    SuiteScene{.word = "builtin:city", .title = "city, street level", .camera = "assets/peers/city-street.json"},
    SuiteScene{.word   = "builtin:layers?order=back",
               .title  = "100 layers, back to front",
               .camera = "assets/peers/layers.json"},
    SuiteScene{.word = "builtin:layers", .title = "100 layers, front to back", .camera = "assets/peers/layers.json"},
    SuiteScene{.word   = "builtin:million?sheets=1&height=0.75",
               .title  = "a million, 1-2 pixels",
               .camera = "assets/peers/grid.json"},
};
constexpr std::array<Names, 6> kPeerPresets{"zbuffer", "zbuffer-zcull", "hzb-octree", "hzb-bvh", "two-pass", "auto"};

constexpr std::array kOneThread{1};
constexpr std::array kAllThreads{0};
constexpr std::array kOneAndTwoThreads{1, 2};

constexpr std::array kSuites{
    Suite{"four-modes", "Z-buffer, scanline, pyramid after a pre-pass, the same over a BVH", kFourModesScenes,
          kFourModes, kAllThreads},
    Suite{"octree-quadtree", "Octree and pyramid, each left out in turn, and a plain scanline", kTreeAndPyramidScenes,
          kTreeAndPyramid, kOneThread},
    Suite{"soccer-field", "A thousand balls: octree with pyramid, pyramid alone, octree order without the node test",
          kFieldScenes, kField, kOneThread},
    Suite{"peers", "Seven scenes to hold against other renderers, back faces culled", kPeerScenes, kPeerPresets,
          kOneAndTwoThreads, FaceCulling::Back, BenchPictures::Both},
};

}  // namespace

std::span<const Suite> suites() { return kSuites; }

const Suite* findSuite(std::string_view name)
{
    const auto found = std::ranges::find(kSuites, name, &Suite::name);
    return found == kSuites.end() ? nullptr : &*found;
}

}  // namespace zscope
