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
    SuiteScene{"builtin:soccer-field?count=100"},
    SuiteScene{"builtin:city", "above"},
    SuiteScene{"builtin:city", "street"},
    SuiteScene{"builtin:million"},
};
constexpr std::array<Names, 5> kTreeAndPyramid{"hzb-octree", "quadtree", "octree-frustum", "scanline", "zbuffer"};

constexpr std::array           kFieldScenes{SuiteScene{"builtin:soccer-field"}};
constexpr std::array<Names, 4> kField{"hzb-octree", "quadtree", "octree-order", "zbuffer"};

constexpr std::array kSuites{
    Suite{"four-modes", "Z-buffer, scanline, pyramid after a pre-pass, the same over a BVH", kFourModesScenes, kFourModes, 0},
    Suite{"octree-quadtree", "Octree and pyramid, each left out in turn, and a plain scanline", kTreeAndPyramidScenes, kTreeAndPyramid, 1},
    Suite{"soccer-field", "A thousand balls: octree with pyramid, pyramid alone, octree order without the node test", kFieldScenes, kField, 1},
};

}  // namespace

std::span<const Suite> suites() { return kSuites; }

const Suite* findSuite(std::string_view name)
{
    const auto found = std::ranges::find(kSuites, name, &Suite::name);
    return found == kSuites.end() ? nullptr : &*found;
}

}  // namespace zscope
